#include "bentur/report/html/page_parts.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "bentur/report/html/internal/animation.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/report/html/plan/plan_animation.h"

namespace bentur {
namespace {

html::Report part_of(const RunResults& results, const Words& say) {
  return {results.view(), results.c, results.problem, results.response, say, {}, {}};
}

std::vector<Eigen::Index> first_of(const std::vector<Impact>& impacts) {
  std::vector<Eigen::Index> listed(std::min(impacts.size(), most_impacts));
  std::iota(listed.begin(), listed.end(), Eigen::Index{0});
  return listed;
}

}  // namespace

std::vector<PagePart> html::parts(const std::vector<PageSection>& sections) {
  std::vector<PagePart> all;
  for (const auto& [id, heading, content] : sections) {
    if (!content.str().empty()) all.push_back({id, heading, content.str()});
  }
  return all;
}

std::string motion_json(const RunResults& results, const std::string& language) {
  const Words say(language);
  return html::animation_json(part_of(results, say), first_of(results.response.impacts));
}

std::string motion_json(const PlanRun& run, const std::string& language) {
  return html::plan_animation_json(run, Words(language), first_of(run.response.impacts));
}

std::vector<PagePart> table_parts(const RunResults& results, const std::string& language) {
  const Words say(language);
  html::Report report = part_of(results, say);
  report.gap_tables = gap_tables_of(results);
  return html::parts({html::gap_section(report), html::peaks_section(report), html::columns_section(report)});
}

}  // namespace bentur
