#include "bentur/study/exchange/gem.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <variant>

namespace bentur {
namespace {

/// Its lateral system, with the stroke behind it; empty where the case does not say.
std::string system_of_building(const BuildingSpec& spec) {
  if (std::holds_alternative<PlaneFrame>(spec.structure)) return "LFM/";
  if (const auto* const plan = std::get_if<Plan>(&spec.structure)) {
    const bool frames =
        !plan->planes.empty() && !plan->rigidity && !plan->cantilever &&
        std::all_of(plan->planes.begin(), plan->planes.end(), [](const PlanPlane& plane) { return plane.is_frame(); });
    return frames ? "LFM/" : "";
  }
  const auto* const generic = std::get_if<GenericBuilding>(&spec.structure);
  if (generic == nullptr) return "";
  // As `system` has them: wall 1, dual 4, frame 12; between them the nearer one.
  return generic->stiffness_ratio < 2 ? "LWAL/" : (generic->stiffness_ratio < 7 ? "LDUAL/" : "LFM/");
}

std::string taxonomy(const BuildingSpec& spec, std::size_t storeys, std::size_t sides, bool pounds) {
  const std::string place = sides == 0 ? "BPD" : fmt::format("BP{}", std::min<std::size_t>(sides, 3));
  return system_of_building(spec) + fmt::format("HEX:{}/{}", storeys, place) + (pounds ? "/IRIR+IRVP:POP" : "");
}

}  // namespace

bool may_close(const Judgement& judgement) {
  return std::any_of(judgement.reasons.begin(), judgement.reasons.end(), [](const Reason& one) {
    return is_by_motion(one.kind) || one.kind == Reason::Kind::collapse || one.kind == Reason::Kind::drift;
  });
}

std::string gem_taxonomy(const Case& c, const Problem& problem, Eigen::Index building, bool pounds) {
  const Eigen::Index last = std::ssize(problem.buildings) - 1;
  const std::size_t sides = (building > 0 ? 1U : 0U) + (building < last ? 1U : 0U);
  return taxonomy(c.buildings[static_cast<std::size_t>(building)],
                  problem.buildings[building].model.storey_heights.size(), sides, pounds);
}

std::string gem_taxonomy(const Case& c, const PlanProblem& problem, Eigen::Index building, bool pounds) {
  std::set<std::pair<int, bool>> sides;  // along x (0) or y (1), and whether towards what is larger
  for (const PlanGap& gap : problem.gaps) {
    if (gap.left != building && gap.right != building) continue;
    const bool onwards = gap.stretch.n(gap.stretch.across) > 0;
    sides.emplace(gap.stretch.across, onwards == (gap.left == building));
  }
  return taxonomy(c.buildings[static_cast<std::size_t>(building)],
                  problem.buildings[building].model.storey_heights.size(), sides.size(), pounds);
}

}  // namespace bentur
