#include "bentur/report/html/internal/each_of.h"

#include <fmt/ranges.h>

#include <algorithm>

namespace bentur::html {

void EachOf::add(const std::string& name, Html content, const std::vector<HtmlTable>& printed, const std::string& of) {
  printed_.resize(std::max(printed_.size(), printed.size()));
  for (std::size_t i = 0; i < printed.size(); ++i) printed_[i].join(of.empty() ? name : of, printed[i]);
  all_.emplace_back(name, std::move(content));
}

Html EachOf::markup(const Words& say, std::string_view what) const {
  if (all_.size() > most_open) return folded(say, what);
  Html content;
  for (const auto& [name, told] : all_) content += are_given_ ? fold("h3", name, told) : element("h3", name) + told;
  return printed_.empty() ? content : element("div", content, "class=\"each\"");
}

Html EachOf::folded(const Words& say, std::string_view what) const {
  Html content;
  for (const auto& [name, told] : all_) {
    content += element("details", element("summary", name) + told) + Html::markup("\n");
  }
  if (all_.size() <= most_open) return content;
  const std::vector<std::pair<std::string, std::string>> count = {{"count", std::to_string(all_.size())}};
  const std::string all(what), heading = say.has(all + ".printed") ? all + ".printed" : all;
  const std::string of = say.has(all + ".of") ? say(all + ".of") : "";
  Html printed;
  for (HtmlTable table : printed_) {
    constexpr std::size_t most = 160;         // rows, of some two pages
    constexpr std::size_t most_columns = 12;  // with letters that can be read
    const std::size_t rows = table.rows();
    if (rows == 0) continue;
    // What all are comes first; what is to be said of a table stands below it, so that its title is right above it.
    if (printed.str().empty()) table = table.called(say(heading, count));
    table.call_first(of);
    Html below;
    if (rows > most) {
      below += element("p", say("appendix.cut", {{"shown", std::to_string(most)}, {"all", std::to_string(rows)}}));
    }
    if (are_given_) {
      const std::vector<std::string> alike = table.take_alike();
      if (!alike.empty()) {
        below += element("p", say("appendix.alike", {{"list", fmt::format("{}", fmt::join(alike, "; "))}}));
      }
      for (const HtmlTable& part : table.in_page_widths()) printed += part.printed(most);
      printed += below;
      continue;
    }
    const std::size_t columns = table.columns();
    if (columns > most_columns) {
      below += element(
          "p", say("appendix.narrow", {{"shown", std::to_string(most_columns)},
                                       {"all", std::to_string(columns)},
                                       {"names", fmt::format("{}", fmt::join(table.names_from(most_columns), ", "))}}));
      table.cut_columns(most_columns);
    }
    printed += table.printed(most) + below;
  }
  if (!printed.str().empty()) {
    const Html note = say.has(all + ".paper") ? element("p", say(all + ".paper")) : Html();
    printed = element("div", element("h3", say(heading, count)) + printed + note, "class=\"print joined\"");
  } else {
    printed = element("p", say("appendix.in_file", {{"what", say(what, count)}}), "class=\"print joined\"");
  }
  return printed + element("details", element("summary", say(what, count)) + content, "class=\"appendix\"") +
         Html::markup("\n");
}

std::string entries_key(const Words& say, std::string_view key) {
  const std::string all = "appendix.entries", of_key = all + "." + std::string(key);
  return say.has(of_key) ? of_key : all;
}

}  // namespace bentur::html
