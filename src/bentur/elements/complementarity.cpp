#include "bentur/elements/complementarity.h"

#include <algorithm>
#include <vector>

#include "bentur/core/algebra/factors.h"

namespace bentur {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Those of a set that push where no other does, found by leaving out what would pull; `p` becomes what they push with.
/// None where A hardly tells them apart.
std::vector<Index> pushing_alone(const Eigen::MatrixXd& a, const VectorXd& b, std::vector<Index> set, VectorXd& p) {
  constexpr double apart = 1e-9;  // of the largest pivot
  while (!set.empty()) {
    const Ldlt factors(a(set, set));
    const VectorXd wanted = factors.solve(b(set));
    if (!factors.is_definite(apart)) return {};
    std::vector<Index> push;
    for (Index n = 0; n < wanted.size(); ++n) {
      if (wanted(n) > 0.0) push.push_back(set[n]);
    }
    if (push.size() == set.size()) {
      p(set) = wanted;
      break;
    }
    set = std::move(push);
  }
  return set;
}

}  // namespace

std::optional<VectorXd> complementary(const Eigen::MatrixXd& a, const VectorXd& b, std::vector<Index> guess) {
  const Index count = b.size();
  VectorXd p = VectorXd::Zero(count);
  if (count == 0) return p;
  if (count == 1) {  // what most impacts are: no factors, to the bit the same
    if (b(0) > 0.0) p(0) = b(0) / a(0, 0);
    return p.allFinite() ? std::optional(p) : std::nullopt;
  }
  const double round_off = 0x1p-48 * b.cwiseAbs().maxCoeff();
  std::vector<Index> pushed = pushing_alone(a, b, std::move(guess), p);
  std::vector<char> refused(b.size(), 0);             // what has been tried from this p, and pushes by round-off alone
  const Index most_sets = 100 * count * count + 100;  // far more than have been seen to be taken
  for (Index sets = 0; sets < most_sets; ++sets) {
    const VectorXd missing = b - a * p;
    Index worst = -1;
    for (Index i = 0; i < count; ++i) {
      const bool free = refused[i] == 0 && !std::binary_search(pushed.begin(), pushed.end(), i);
      if (free && missing(i) > (worst < 0 ? round_off : missing(worst))) worst = i;
    }
    if (worst < 0) return p;
    pushed.insert(std::lower_bound(pushed.begin(), pushed.end(), worst), worst);
    for (bool first = true; !pushed.empty(); first = false) {
      const VectorXd wanted = Ldlt(a(pushed, pushed)).solve(b(pushed));
      if (!wanted.allFinite()) return std::nullopt;
      // As far towards it as none pulls.
      double part = 1.0;
      for (Index n = 0; n < wanted.size(); ++n) {
        if (wanted(n) <= 0.0) part = std::min(part, p(pushed[n]) / (p(pushed[n]) - wanted(n)));
      }
      if (first && !(part > 0.0)) {
        pushed.erase(std::find(pushed.begin(), pushed.end(), worst));
        refused[worst] = 1;
        break;
      }
      if (first) std::fill(refused.begin(), refused.end(), 0);
      if (part == 1.0) {
        p(pushed) = wanted;
        break;
      }
      std::vector<Index> still;
      for (Index n = 0; n < wanted.size(); ++n) {
        const Index i = pushed[n];
        const double stays = p(i) + part * (wanted(n) - p(i));
        const bool ends = wanted(n) <= 0.0 && !(p(i) / (p(i) - wanted(n)) > part);
        p(i) = ends ? 0.0 : stays;
        if (!ends) still.push_back(i);
      }
      pushed = std::move(still);
    }
  }
  return std::nullopt;
}

std::optional<VectorXd> complementary(const MatrixXd& a, const VectorXd& b, Index free) {
  if (free == 0) return complementary(a, b);
  const Index bound = b.size() - free;
  const Ldlt of_free(a.bottomRightCorner(free, free));
  const MatrixXd coupling = of_free.solve(a.bottomLeftCorner(free, bound));
  const VectorXd alone = of_free.solve(b.tail(free));
  const auto found = complementary(a.topLeftCorner(bound, bound) - a.topRightCorner(bound, free) * coupling,
                                   b.head(bound) - a.topRightCorner(bound, free) * alone);
  if (!found) return std::nullopt;
  VectorXd all(b.size());
  all << *found, alone - coupling * *found;
  return all;
}

// With a little on A's diagonal there is one solution alone, which goes to the one of least norm as that goes to
// nothing: it tells which of them push.
VectorXd least_norm(const MatrixXd& a, const VectorXd& b, VectorXd p) {
  if (p.size() < 2) return p;
  constexpr double apart = 1e-11;   // of the largest pivot
  constexpr double little = 1e-9;   // of the largest entry of A
  constexpr double agreed = 1e-10;  // of the largest of b, or of p
  const VectorXd surplus = a * p - b;
  const double round_off = 0x1p-40 * b.cwiseAbs().maxCoeff();
  std::vector<Index> may_push;
  for (Index i = 0; i < p.size(); ++i) {
    if (p(i) > 0.0 || surplus(i) <= round_off) may_push.push_back(i);
  }
  if (may_push.size() < 2) return p;
  MatrixXd among = a(may_push, may_push);
  if (Ldlt(among).is_definite(apart)) return p;
  among.diagonal().array() += little * among.diagonal().maxCoeff();
  const auto shared = complementary(among, b(may_push));
  if (!shared) return p;
  std::vector<Index> push;
  for (Index n = 0; n < shared->size(); ++n) {
    if ((*shared)(n) > 0.0) push.push_back(may_push[n]);
  }
  if (push.empty()) return p;
  const VectorXd least = least_norm_solution(a(may_push, push), b(may_push), apart);
  VectorXd all = VectorXd::Zero(p.size());
  all(push) = least.cwiseMax(0.0);
  const bool agrees = least.minCoeff() >= -agreed * least.cwiseAbs().maxCoeff() &&
                      (a * (all - p)).cwiseAbs().maxCoeff() <= agreed * b.cwiseAbs().maxCoeff();
  return agrees ? all : p;
}

}  // namespace bentur
