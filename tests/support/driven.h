#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <utility>

#include "bentur/elements/coupled_law.h"

namespace bentur::test {

/// The state of a law without dashpots after δ has gone straight from one place to another, event by event. `each`
/// looks at the state after each of them.
template <class Each>
CoupledState driven(const CoupledLaw& law, CoupledState state, const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                    const Each& each) {
  using Eigen::VectorXd;
  CoupledMotion motion{from, to - from, VectorXd::Zero(from.size()), 1e-9};
  state = law.settle(state, state.since, motion);
  for (double done = 0;;) {
    const CoupledBranch branch = law.branch(state);
    double first = 2;
    std::size_t which = 0;
    for (std::size_t g = 0; g < branch.guard_count(); ++g) {
      const CoupledGuard guard = branch.guard(g);
      if (guard.deformation < 0 || guard.zeros > 0) continue;  // δ̇ does not turn
      const VectorXd row = branch.set->row(guard.deformation, from.size());
      const double slope = guard.sense * row.dot(to - from);
      const double now = guard.constant + guard.sense * row.dot(from + done * (to - from));
      const double at = slope < 0 ? done + std::max(0.0, now) / -slope : 2;
      if (at < first) {
        first = at;
        which = g;
      }
    }
    motion.deformation = from + std::min(first, 1.0) * (to - from);
    if (first > 1.0) return law.at(state, motion.deformation);
    state = law.next(state, branch, which, state.since + 1e-3, motion);
    each(state);
    done = first;
  }
}

inline CoupledState driven(const CoupledLaw& law, CoupledState state, const Eigen::VectorXd& from,
                           const Eigen::VectorXd& to) {
  return driven(law, std::move(state), from, to, [](const CoupledState&) {});
}

}  // namespace bentur::test
