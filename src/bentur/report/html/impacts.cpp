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

void add_impacts(HtmlTable& table, std::vector<TableColumn> quantities, const HtmlTable& places, const Words& say,
                 bool in_plan) {
  for (const char* const key : {"peak_force", "peak_force_time"}) {
    const std::string_view name = quantity_named(key, Owner::impact, in_plan).label[say.number()];
    const auto first = std::find_if(quantities.begin(), quantities.end(),
                                    [&](const TableColumn& column) { return column.label == name; });
    if (first == quantities.end()) continue;
    table.add(first->label, first->unit, std::move(first->cells));
    quantities.erase(first);
  }
  table.add(places);
  add_columns(table, std::move(quantities));
}

HtmlTable impact_table(const Report& report, const std::vector<Eigen::Index>& listed) {
  const Words& say = report.say;
  std::vector<std::string> numbers, gaps, struck;
  std::vector<double> elevations;
  for (const Eigen::Index k : listed) {
    const Eigen::Index i = report.response.impacts.at(static_cast<std::size_t>(k)).point;
    const ContactPoint& point = report.problem.points.at(static_cast<std::size_t>(i));
    numbers.push_back(std::to_string(k + 1));
    gaps.push_back(short_gap_name(report, point.gap));
    elevations.push_back(point.elevation);
    struck.push_back(struck_text(report, i));
  }
  HtmlTable table, places;
  table.add("#", "", numbers);
  if (report.c.gaps.size() > 1) table.add(say("column.gap"), "", gaps, false);
  places.add(say("column.elevation"), report.c.units.length, elevations);
  if (!struck_points(report.problem).empty()) places.add(say("columns.struck"), "", struck, false);
  add_impacts(table,
              without_losses(table_columns(Owner::impact, report.run, places_of(listed), say.number()), Owner::impact,
                             report.response.points, say),
              places, say, false);
  return table;
}

PageSection impacts_section(const Report& report, const std::vector<Eigen::Index>& listed) {
  const Words& say = report.say;
  const std::size_t all = report.response.impacts.size();
  if (all == 0) return {"impacts", say("heading.impacts"), element("p", Html::text(say("impacts.none")))};
  return {
      "impacts", say("heading.impacts"),
      impact_list(say, impact_table(report, listed), listed.size(), all) + elastic_note(report.response.points, say)};
}

}  // namespace bentur::html
