#include "bentur/report/html/page_parts.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "bentur/report/html/internal/animation.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur {
namespace {

html::Report part_of(const RunResults& results, const Words& say) {
  return {results.view(), results.c, results.problem, results.response, say, {}, {}};
}

}  // namespace

std::string motion_json(const RunResults& results, const std::string& language) {
  const Words say(language);
  std::vector<Eigen::Index> listed(std::min(results.response.impacts.size(), most_impacts));
  std::iota(listed.begin(), listed.end(), Eigen::Index{0});
  return html::animation_json(part_of(results, say), listed);
}

}  // namespace bentur
