#include "bentur/report/html/internal/sections.h"

namespace bentur::html {

Html gap_tables(const Report& report, const std::vector<StoryTable>& tables) {
  Html content;
  std::optional<Eigen::Index> gap;
  for (const StoryTable& table : tables) {
    if (table.gap != gap) {
      gap = table.gap;
      content += element("h3", gap_name(report.problem, gap.value()));
    }
    const SaidTable shown = said(table, report.say);
    content += element("h4", shown.heading) + table_of(shown);
  }
  return content;
}

PageSection gap_section(const Report& report) {
  const Words& say = report.say;
  Html content = gap_tables(report, report.gap_tables);
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
