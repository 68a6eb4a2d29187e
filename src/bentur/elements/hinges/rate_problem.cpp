#include "bentur/elements/hinges/rate_problem.h"

#include <algorithm>
#include <limits>

#include "bentur/core/algebra/factors.h"
#include "bentur/elements/complementarity.h"

namespace bentur {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::optional<VectorXd> HingeSides::solve(const MatrixXd& a, const VectorXd& b, bool mixed,
                                          std::vector<Index> guess) const {
  const auto s = Eigen::Map<const VectorXd>(side.data(), std::ssize(side));
  if (!mixed) return complementary(s.asDiagonal() * a(of, of) * s.asDiagonal(), b, std::move(guess));
  const VectorXd sizes = a.diagonal()(of).cwiseMax(0.0);
  const VectorXd unit = (sizes.array() > 0.0).select(sizes.cwiseSqrt().cwiseInverse(), 1.0);
  const VectorXd scale = s.cwiseProduct(unit);
  auto found = complementary(scale.asDiagonal() * a(of, of) * scale.asDiagonal(), unit.cwiseProduct(b), free);
  if (found) *found = found->cwiseProduct(unit);
  return found;
}

namespace {

/// Of those that may only push, each measured by its size.
RateSolution least_pushing(const MatrixXd& a, const VectorXd& b) {
  constexpr double bends = 1e-10;   // a stiffness below that is none
  constexpr double no_push = 1e-9;  // of the largest: along a way without stiffness it is round-off
  const Index count = b.size();
  RateSolution found{VectorXd::Zero(count)};
  if (count == 0) return found;
  VectorXd& p = found.pace;
  std::vector<Index> pushed;
  std::vector<char> refused(count, 0);
  const double largest = b.cwiseAbs().maxCoeff();
  const double round_off = 0x1p-46 * largest;
  for (Index sets = 0; sets < 100 * count * count + 100; ++sets) {
    const VectorXd missing = b - a * p;
    Index next = -1;
    for (Index i = 0; i < count; ++i) {
      const bool open = refused[i] == 0 && std::find(pushed.begin(), pushed.end(), i) == pushed.end();
      if (open && missing(i) > (next < 0 ? round_off : missing(next))) next = i;
    }
    if (next < 0) break;
    // Along a way on which what pushes already stays in balance, until it does too or another pushes no more.
    for (bool moves = false;;) {
      VectorXd way = VectorXd::Zero(count);
      way(next) = 1.0;
      if (!pushed.empty()) way(pushed) = -Ldlt(a(pushed, pushed)).solve(a(pushed, next));
      const double stiffness = a.row(next).dot(way), lacks = b(next) - a.row(next).dot(p);
      const double most = stiffness > bends ? lacks / stiffness : std::numeric_limits<double>::infinity();
      double part = most;
      Index stops = -1;
      for (const Index i : pushed) {
        if (!(way(i) < 0.0) || !(p(i) < -way(i) * part)) continue;
        part = p(i) / -way(i);
        stops = i;
      }
      if (stops < 0 && most == std::numeric_limits<double>::infinity()) {
        if (lacks <= no_push * largest) {
          refused[next] = 1;
          break;
        }
        return {way, true};
      }
      p += part * way;
      moves = moves || part > 0.0;
      if (stops < 0) {
        pushed.insert(std::lower_bound(pushed.begin(), pushed.end(), next), next);
        if (moves) std::fill(refused.begin(), refused.end(), 0);
        break;
      }
      p(stops) = 0.0;
      pushed.erase(std::find(pushed.begin(), pushed.end(), stops));
    }
  }
  if (pushed.empty()) return found;
  const VectorXd exact = Ldlt(a(pushed, pushed)).solve(b(pushed));
  if ((exact.array() > 0.0).all()) p(pushed) = exact;
  return found;
}

}  // namespace

RateSolution least_rate(const MatrixXd& a, const VectorXd& b, Index free, const VectorXd& sizes) {
  const Index bound = b.size() - free;
  const VectorXd unit = sizes.cwiseSqrt().cwiseInverse();
  const MatrixXd scaled = unit.asDiagonal() * a * unit.asDiagonal();
  const VectorXd pushes = unit.cwiseProduct(b);
  if (free == 0) {
    RateSolution found = least_pushing(scaled, pushes);
    found.pace = found.pace.cwiseProduct(unit);
    return found;
  }
  const Ldlt of_free(scaled.bottomRightCorner(free, free));
  const MatrixXd coupling = of_free.solve(scaled.bottomLeftCorner(free, bound));
  const VectorXd alone = of_free.solve(pushes.tail(free));
  const RateSolution bound_ones =
      least_pushing(scaled.topLeftCorner(bound, bound) - scaled.topRightCorner(bound, free) * coupling,
                    pushes.head(bound) - scaled.topRightCorner(bound, free) * alone);
  RateSolution found{VectorXd(b.size()), bound_ones.unbounded};
  found.pace << bound_ones.pace, -coupling * bound_ones.pace;
  if (!found.unbounded) found.pace.tail(free) += alone;
  found.pace = found.pace.cwiseProduct(unit);
  return found;
}

}  // namespace bentur
