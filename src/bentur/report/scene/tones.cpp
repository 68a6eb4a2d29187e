#include "bentur/report/scene/tones.h"

#include <optional>
#include <utility>

#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/plan/plan_places.h"

namespace bentur {
namespace {

using Pair = std::pair<std::size_t, std::size_t>;

/// @param sides the two buildings at a contact point
template <class AnyProblem, class Sides>
std::vector<Tone> tones(const AnyProblem& problem, const std::vector<Impact>& impacts, const Sides& sides) {
  const Impact* const hardest = hardest_impact(impacts);
  const auto struck = hardest != nullptr ? std::optional<Pair>(sides(hardest->point)) : std::nullopt;
  std::vector<Tone> all;
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    all.push_back(building_tone(b, problem.buildings.size(), struck));
  }
  return all;
}

}  // namespace

std::vector<Tone> tones_of(const Problem& problem, const std::vector<Impact>& impacts) {
  return tones(problem, impacts, [&](Eigen::Index point) {
    const ContactPoint& at = problem.points.at(point);
    return Pair{at.left, at.right};
  });
}

std::vector<Tone> tones_of(const PlanProblem& problem, const std::vector<Impact>& impacts) {
  return tones(problem, impacts, [&](Eigen::Index point) {
    const PlanGap& gap = problem.gaps[contact_at(problem, point).gap];
    return Pair{gap.left, gap.right};
  });
}

}  // namespace bentur
