#include "bentur/report/html/page_parts.h"

#include <algorithm>
#include <vector>

#include "bentur/report/figures/internal/text.h"
#include "bentur/report/html/internal/animation.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/report/html/plan/plan_animation.h"

namespace bentur {
namespace {

html::Report part_of(const RunResults& results, const Words& say) {
  return {results.view(), results.c, results.problem, results.response, say, {}, {}};
}

std::vector<PageColumn> columns_of(const html::HtmlTable& table) {
  std::vector<PageColumn> columns;
  for (const html::HtmlTable::Column& one : table.all()) {
    columns.push_back({one.name, one.unit, one.cells, one.numeric});
    if (!one.numeric) continue;
    for (std::string& cell : columns.back().cells) cell = signed_text(cell);
  }
  return columns;
}

}  // namespace

std::vector<PageColumn> impact_columns(const RunResults& results, const std::string& language) {
  const Words say(language);
  return columns_of(html::impact_table(part_of(results, say), html::hardest_impacts(results.response.impacts)));
}

std::vector<PageColumn> impact_columns(const PlanRun& run, const std::string& language) {
  return columns_of(html::impact_table(run, html::hardest_impacts(run.response.impacts), Words(language)));
}

std::vector<Eigen::Index> listed_impacts(const std::vector<Impact>& impacts) {
  std::vector<Eigen::Index> listed = html::hardest_impacts(impacts);
  std::sort(listed.begin(), listed.end());
  return listed;
}

std::vector<PagePart> html::parts(const std::vector<PageSection>& sections) {
  std::vector<PagePart> all;
  for (const auto& [id, heading, content, behind] : sections) {
    if (!content.str().empty()) all.push_back({id, heading, (content + behind).str()});
  }
  return all;
}

std::string motion_json(const RunResults& results, const std::string& language) {
  const Words say(language);
  return html::animation_json(part_of(results, say), listed_impacts(results.response.impacts));
}

std::string motion_json(const PlanRun& run, const std::string& language) {
  return html::plan_animation_json(run, Words(language), listed_impacts(run.response.impacts));
}

std::vector<PagePart> table_parts(const RunResults& results, const std::string& language) {
  const Words say(language);
  html::Report report = part_of(results, say);
  report.gap_tables = gap_tables_of(results);
  return html::parts({html::gap_section(report), html::peaks_section(report), html::columns_section(report)});
}

}  // namespace bentur
