#include "bentur/report/scene/tones.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/plan/plan_places.h"

namespace bentur {
namespace {

/// A contact point between two buildings.
struct PointSides {
  std::pair<std::size_t, std::size_t> buildings;
  double width = 0;  ///< [length]
};

/// @param points how many there are @param sides of one of them
template <class Sides>
PairsOfNote pairs(const RunOutcome& outcome, Eigen::Index points, const Sides& sides) {
  PairsOfNote told;
  if (const Impact* const hardest = hardest_impact(outcome.impacts)) told.struck = sides(hardest->point).buildings;
  double most = 0;
  for (Eigen::Index point = 0; point < std::min<Eigen::Index>(points, std::ssize(outcome.points)); ++point) {
    const PointSummary& needs = outcome.points[point];
    const PointSides at = sides(point);
    const double lacks = std::max(needs.gap_needed, needs.gap_needed_reversed.value_or(0)) - at.width;
    if (!(lacks > most)) continue;
    most = lacks;
    told.worst = at.buildings;
  }
  return told;
}

template <class AnyProblem>
std::vector<Tone> tones(const AnyProblem& problem, const RunOutcome& outcome) {
  const std::size_t count = problem.buildings.size();
  const PairsOfNote told = count > std::size(building_tones) ? pairs_of_note(problem, outcome) : PairsOfNote{};
  std::vector<Tone> all;
  for (std::size_t b = 0; b < count; ++b) all.push_back(building_tone(b, count, told.struck, told.worst));
  return all;
}

}  // namespace

PairsOfNote pairs_of_note(const Problem& problem, const RunOutcome& outcome) {
  return pairs(outcome, std::ssize(problem.points), [&](Eigen::Index point) {
    const ContactPoint& at = problem.points.at(point);
    return PointSides{{at.left, at.right}, at.width};
  });
}

PairsOfNote pairs_of_note(const PlanProblem& problem, const RunOutcome& outcome) {
  return pairs(outcome, contact_count(problem), [&](Eigen::Index point) {
    const auto at = contact_at(problem, point);
    const PlanGap& gap = problem.gaps[at.gap];
    return PointSides{{gap.left, gap.right}, gap.width_at(*at.contact)};
  });
}

std::vector<Tone> tones_of(const Problem& problem, const RunOutcome& outcome) { return tones(problem, outcome); }

std::vector<Tone> tones_of(const PlanProblem& problem, const RunOutcome& outcome) { return tones(problem, outcome); }

}  // namespace bentur
