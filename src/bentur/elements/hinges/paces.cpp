// How fast hinges on their lines turn, of HingeLaw.
#include <algorithm>
#include <utility>

#include "bentur/elements/hinges.h"
#include "bentur/elements/hinges/rate_problem.h"

namespace bentur {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// λ of (H-7) at hinges on their lines by the Q⁻¹ of sets, which recur: from those that are expected to flow by leaving
/// out what would turn back and taking in what would pass its line. Whether that has come to its end.
bool HingeLaw::flow_by_sets(const HingeSides& sides, const VectorXd& rate, std::vector<Index> expected,
                            VectorXd& lambda) const {
  constexpr int most_sets = 8;
  constexpr double complementary_slack = 0x1p-48;  // of the largest rate: round-off, as complementary() has it
  const Index count = std::ssize(sides.of);
  const double round_off = count > 0 ? complementary_slack * rate.cwiseAbs().maxCoeff() : 0.0;
  std::vector<Index> at, next;
  at.reserve(sides.of.size());
  next.reserve(sides.of.size());
  VectorXd speeds, turning;
  for (int tried = 0; tried < most_sets; ++tried) {
    at.clear();
    next.clear();
    speeds.resize(std::ssize(expected));
    for (const Index i : expected) {
      speeds(std::ssize(at)) = sides.side[i] * rate(i);
      at.push_back(sides.of[i]);
    }
    const auto of = sets_.paces_of(of_, at);
    if (!of->apart) return false;
    turning.noalias() = of->inverse * speeds;
    lambda.setZero(count);
    for (std::size_t n = 0; n < at.size(); ++n) {
      const Index i = expected[n];
      lambda(i) = sides.side[i] * turning(static_cast<Index>(n));
      if (lambda(i) > 0.0) next.push_back(i);
    }
    if (next.size() == expected.size()) {
      for (Index i = 0; i < count; ++i) {
        if (lambda(i) > 0.0) continue;
        double held = 0.0;
        for (std::size_t n = 0; n < at.size(); ++n)
          held += of_.stiffness(at[n], sides.of[i]) * turning(static_cast<Index>(n));
        if (!(rate(i) - sides.side[i] * held <= round_off)) next.push_back(i);
      }
      if (next.size() == expected.size()) return true;
      std::sort(next.begin(), next.end());
    }
    expected.swap(next);
  }
  return false;
}

/// λ of (H-7) at hinges on their lines; or, where these would run away, which of them snap. (H-19)
std::vector<Index> HingeLaw::paces(const CoupledState& state, const HingeSides& sides, const VectorXd& rate,
                                   std::vector<Index> expected, VectorXd& lambda) const {
  const Index count = std::ssize(sides.of);
  const bool mixed = of_.kept.size() > 0;
  if (!any_softened(state)) {
    if (keeps_ && !mixed && sides.free == 0 && flow_by_sets(sides, rate, expected, lambda)) return {};
    lambda = sides.solve(hardened_, rate, mixed, std::move(expected)).value_or(VectorXd::Zero(count));
    return {};
  }
  MatrixXd a = of_.stiffness(sides.of, sides.of);
  VectorXd slopes(count), sizes(count);
  for (Index i = 0; i < count; ++i) {
    slopes(i) = slope(state, sides.of[i], sides.side[i]);
    sizes(i) = of_.stiffness(sides.of[i], sides.of[i]);
  }
  a.diagonal() += slopes;
  if (!(slopes.array() < 0.0).any()) {
    HingeSides alone = sides;
    for (Index i = 0; i < count; ++i) alone.of[i] = i;
    lambda = alone.solve(a, rate, true).value_or(VectorXd::Zero(count));
    return {};
  }
  const auto s = Eigen::Map<const VectorXd>(sides.side.data(), count);
  RateSolution found = least_rate(s.asDiagonal() * a * s.asDiagonal(), rate, sides.free, sizes);
  lambda = found.unbounded ? VectorXd::Zero(count) : found.pace;
  return found.unbounded ? losing_most(state, sides, found.pace) : std::vector<Index>{};
}

}  // namespace bentur
