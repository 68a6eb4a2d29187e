#include "bentur/report/html/internal/sections.h"

namespace bentur::html {

Html gap_tables(const std::vector<std::string>& gaps, const std::vector<StoryTable>& tables, const Words& say) {
  EachOf each;
  for (auto table = tables.begin(); table != tables.end();) {
    const Eigen::Index gap = table->gap.value();
    Html content;
    for (; table != tables.end() && table->gap == gap; ++table) {
      const SaidTable shown = said(*table, say);
      if (shown.heading != gaps.at(static_cast<std::size_t>(gap))) content += element("h4", shown.heading);
      content += table_of(shown);
    }
    each.add(gaps.at(static_cast<std::size_t>(gap)), content);
  }
  return each.markup(say, "appendix.gaps");
}

PageSection gap_section(const Report& report) {
  const Words& say = report.say;
  Html content = gap_tables(gap_names(report.problem), report.gap_tables, say);
  content += element("p", say("gap.note"), "class=\"note\"");
  if (report.from_case()) content += element("p", say("screening.note"), "class=\"note\"");
  content += element("p",
                     say(!report.from_case()           ? "gap.no_case"
                         : report.c.code.rules.empty() ? "gap.no_codes"
                                                       : "gap.codes_note"),
                     "class=\"note\"");
  return {"gaps", say("heading.gaps"), content};
}

}  // namespace bentur::html
