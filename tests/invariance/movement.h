#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

#include "bentur/pounding/pounding.h"
#include "tests/invariance/difference.h"

// What two descriptions of one case may differ by: what its numbers and the solver's tolerance leave open.

namespace bentur::test {

/// Where floors touch and rest, the opening leaves zero with the second to the eighth power of time (the second or
/// third of the ground's, two more for each storey or neighbour between), and round-off leaves open when. A contact of
/// such a point that is its first one, or that begins without speed, starts as in `base`, if that is near.
inline Response starting_as(const Response& base, Response response, const Problem& problem) {
  constexpr double near = 1e-2;  // of the duration: the eighth root of round-off
  const double slow = 1e-7 * largest(base, &Impact::closing_speed);
  std::vector<std::vector<Impact>> of_base;
  for (int point = 0; point < static_cast<int>(base.points.size()); ++point) of_base.push_back(impacts_at(base, point));
  std::vector<std::size_t> met(of_base.size(), 0);
  for (Impact& impact : response.impacts) {
    const auto point = static_cast<std::size_t>(impact.point);
    const std::size_t n = met[point]++;
    if (problem.points[point].width != 0 || n >= of_base[point].size()) continue;
    const Impact& like = of_base[point][n];
    const bool known = n > 0 && std::max(impact.closing_speed, like.closing_speed) > slow;
    if (!known && std::abs(impact.start - like.start) < near * problem.duration) impact.start = like.start;
  }
  return response;
}

/// Where a contact comes to rest by rebounds that have no end, the solver ends them, and how many there were and when
/// the last one was is a matter of round-off. Those that are slower than this, of all impacts, count as part of the
/// rest.
inline Response with_whole_rests(Response response, const Problem& problem) {
  const double slow = 0x1p-13 * largest(response, &Impact::closing_speed);
  std::vector<Impact> kept;
  for (Impact impact : response.impacts) {
    const auto at_point = [&](const Impact& one) { return one.point == impact.point; };
    const bool rests =
        impact.end > impact.start && problem.points[static_cast<std::size_t>(impact.point)].law->restitution();
    while (rests) {
      const auto last = std::find_if(kept.rbegin(), kept.rend(), at_point);
      if (last == kept.rend() || last->end > last->start || last->closing_speed >= slow) break;
      impact.start = last->start;
      impact.impulse += last->impulse;
      kept.erase(std::next(last).base());
    }
    kept.push_back(impact);
  }
  response.impacts = std::move(kept);
  return response;
}

/// Whether some contact's force is integrated, by steps that have a tolerance.
inline bool is_integrated(const Problem& problem) {
  return std::any_of(problem.points.begin(), problem.points.end(), [](const ContactPoint& point) {
    const LawState closed = point.law->next({}, 0, 0.0, 0.0, 1.0);
    return !point.law->restitution() && !point.law->branch(closed).linear;
  });
}

/// How far a case is moved by perturbations of its numbers and, where contacts are integrated, by other steps of the
/// same tolerance.
class Movement {
 public:
  /// `perturbed`: the case with its numbers changed a little, another way for each seed.
  Movement(const Problem& problem, const Response& base, std::function<Problem(unsigned)> perturbed)
      : problem_(&problem), base_(&base), perturbed_(std::move(perturbed)) {}

  /// Whether it is moved by a tenth of what two descriptions are apart. One impact more or less counts as 1: where a
  /// case is moved by a tenth of itself, some contact is grazed.
  bool explains(const Difference& apart) {
    const double size = std::min(apart.size, 1.0);
    return 10 * reach(0.1 * size) >= size;
  }
  /// By how much it was, as far as was tried.
  [[nodiscard]] double most() const { return most_; }

 private:
  /// Relative, as `difference` has it. Perturbations are tried until it is `enough`, up to twenty.
  double reach(double enough) {
    if (tried_ == 0 && is_integrated(*problem_)) note(solve(*problem_, AdaptiveSolver{1e-10}));
    for (; tried_ < 20 && most_ < enough; ++tried_) note(solve(perturbed_(tried_)));
    return most_;
  }

  void note(const Response& moved) {
    if (moved.status != Status::done) return;
    most_ = std::max(most_, difference(*base_, starting_as(*base_, with_whole_rests(moved, *problem_), *problem_),
                                       problem_->duration)
                                .size);
  }

  const Problem* problem_;
  const Response* base_;
  std::function<Problem(unsigned)> perturbed_;
  unsigned tried_ = 0;
  double most_ = 0;
};

}  // namespace bentur::test
