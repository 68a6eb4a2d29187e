#include "bentur/report/html/page_parts.h"

#include <algorithm>
#include <vector>

#include "bentur/report/html/internal/animation.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur {
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

std::string motion_json(const RunResults& run, const std::string& language) {
  return html::animation_json(run, listed_impacts(run.response.impacts), Words(language));
}

std::string motion_json(const PlanRun& run, const std::string& language) {
  return html::animation_json(run, listed_impacts(run.response.impacts), Words(language));
}

}  // namespace bentur
