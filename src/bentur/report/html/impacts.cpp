#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "bentur/model/gap/gap_outcome.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur::html {

std::vector<Eigen::Index> hardest_impacts(const std::vector<Impact>& impacts) {
  std::vector<Eigen::Index> order(impacts.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return is_harder(impacts[a], impacts[b]); });
  order.resize(std::min(order.size(), most_impacts));
  return order;
}

Html csv_script(const std::string& csv) {
  return json_script("impacts-csv", nlohmann::json(csv).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

namespace {

/// The list with its buttons; a page's script sorts and saves it. @param all how many there are
Html impact_list(const Words& say, const HtmlTable& table, std::size_t listed, std::size_t all) {
  // By the peak force, which stands behind the number and, where there are several, the gap.
  const int sorted = table.all().at(1).numeric ? 1 : 2;
  Html content;
  if (listed < all) {
    content += element(
        "p", Html::text(say("impacts.cut", {{"listed", std::to_string(listed)}, {"all", std::to_string(all)}})));
  }
  content += element("p",
                     element("button", Html::text(say("impacts.download")), "type=\"button\" id=\"download\"") +
                         Html::markup(" ") + element("span", Html::text(say("impacts.sort")), "class=\"note\""),
                     "class=\"screen\"");
  const std::vector<std::pair<std::string, std::string>> of = {{"n", std::to_string(all)}};
  content += element("p",  // the script fills in how many are in sight, and shows it where these are not all
                     Html::markup("<b></b> ") + element("span", say("impacts.hardest", of)) +
                         element("span", say("impacts.first", of), "hidden") + Html::markup(" ") +
                         element("button", say("impacts.whole", {{"n", std::to_string(listed)}}), "type=\"button\""),
                     "class=\"screen\" id=\"in-sight\" hidden");
  if (listed > impacts_in_print) {
    content +=
        element("p", say("impacts.print", {{"n", std::to_string(impacts_in_print)}, {"all", std::to_string(all)}}),
                "class=\"print\"");
  }
  content += table.called(say("impacts.order")).markup(fmt::format("id=\"impact-list\" data-sorted=\"{}\"", sorted)) +
             element("p", Html::text(say("impacts.restitution")), "class=\"note\"");
  return content;
}

}  // namespace

PageSection impacts_section(const RunOutcome& outcome, const RunTable& listed, const Words& say) {
  const std::size_t all = outcome.impacts.size();
  if (all == 0) return {"impacts", say("heading.impacts"), element("p", say("impacts.none"))};
  return {"impacts", say("heading.impacts"),
          impact_list(say, table_of(listed), listed.places.size(), all) + elastic_note(outcome.points, say)};
}

}  // namespace bentur::html
