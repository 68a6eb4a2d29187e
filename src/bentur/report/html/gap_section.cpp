#include <algorithm>

#include "bentur/report/html/internal/sections.h"

namespace bentur::html {
namespace {

/// Of levels those that govern, as the last column says.
HtmlTable governing_of(const SaidTable& levels) {
  HtmlTable table;
  for (std::size_t i = 0; i + 1 < levels.columns.size(); ++i) {
    const TableColumn& column = levels.columns[i];
    std::vector<std::string> cells;
    std::vector<double> values;
    for (std::size_t row = 0; row < column.cells.size(); ++row) {
      if (levels.columns.back().cells[row].empty()) continue;
      cells.push_back(column.cells[row]);
      if (!column.values.empty()) values.push_back(column.values[row]);
    }
    table.add(column.label, column.unit, std::move(cells), levels.are_numbers[i], std::move(values));
  }
  return table;
}

}  // namespace

Html gap_tables(const std::vector<std::string>& gaps, const std::vector<StoryTable>& tables, const Words& say) {
  EachOf each;
  for (auto table = tables.begin(); table != tables.end();) {
    const Eigen::Index gap = table->gap.value();
    Html content;
    HtmlTable governing;
    for (; table != tables.end() && table->gap == gap; ++table) {
      const SaidTable shown = said(*table, say);
      const bool is_named = shown.heading == gaps.at(static_cast<std::size_t>(gap));
      content += is_named                  ? table_of(shown)
                 : table->kind == "levels" ? element("h4", shown.heading) + table_of(shown)
                                           : fold("h4", shown.heading, table_of(shown));
      if (table->kind == "levels") governing = governing_of(shown);
    }
    each.add(gaps.at(static_cast<std::size_t>(gap)), content, {governing});
  }
  return each.markup(say, "appendix.gaps");
}

PageSection gap_section(const std::vector<std::string>& gaps, const std::vector<StoryTable>& tables, const Case& c,
                        const Words& say) {
  if (tables.empty()) return {};
  const auto note = [&](std::string_view key) { return element("p", say(key), "class=\"note\""); };
  const bool from_case = !c.buildings.empty();
  const bool is_screened =
      std::any_of(tables.begin(), tables.end(), [](const StoryTable& one) { return one.kind == "screening"; });
  Html content = gap_tables(gaps, tables, say) + note(c.is_in_plan() ? "cli.plan_gap_note" : "gap.note");
  if (is_screened) content += note("screening.note");
  content += note(!from_case ? "gap.no_case" : c.code.rules.empty() ? "gap.no_codes" : "gap.codes_note");
  return {"gaps", say("heading.gaps"), content};
}

}  // namespace bentur::html
