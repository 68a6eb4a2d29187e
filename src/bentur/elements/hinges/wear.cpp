// What repetition takes of the strength of the hinges of HingeLaw. (H-21)
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "bentur/elements/hinges/falling.h"

namespace bentur {

using Eigen::Index;
using Eigen::VectorXd;

double HingeLaw::left_by_wear(const CoupledState& state, Index h, double s) const {
  return wears_ ? state.memory(h, s > 0 ? left_above : left_below) : 1.0;
}

/// ∫ (M + M₀ − Hθ) dθ [force·length].
double HingeLaw::dissipated(const CoupledState& state, Index h) const {
  return state.memory(h, lost) + backbone(h)->at_rest * state.memory(h, rotation);
}

/// It is about to flow on side s.
void HingeLaw::set_out(CoupledState& state, Index h, double s) const {
  if (!wears_ || backbone(h) == nullptr || !backbone(h)->wears() || state.memory(h, way) == s) return;
  auto memory = state.memory.row(h);
  memory(way) = s;
  memory(left_before) = left_by_wear(state, h, -s);
  memory(lost_before) = memory(lost_then) = dissipated(state, h);
}

/// What rests and has flowed since it last did is weaker on the other side. Returns whether any has failed by it, so
/// that all have been loaded anew.
bool HingeLaw::wear(CoupledState& state, double time, const VectorXd& deformation) const {
  constexpr double nothing_lost = 1e-12;  // of γ M_y θ_c: round-off
  if (!wears_) return false;
  std::vector<Fall> falls;
  const VectorXd y = borne(state, deformation);
  for (Index h = 0; h < size(); ++h) {
    auto memory = state.memory.row(h);
    if (backbone(h) == nullptr || !backbone(h)->wears()) continue;
    const double s = memory(way), now = dissipated(state, h);
    if (s == 0.0 || memory(side) != 0.0 || nothing_left(state, h) || now == memory(lost_then)) continue;
    memory(lost_then) = now;
    const double can = backbone(h)->can_lose(), here = now - memory(lost_before);
    if (!(here > nothing_lost * can)) continue;
    const double share = now < can ? std::pow(here / (can - now), backbone(h)->wear_exponent) : 1.0;
    if (share >= 1.0) {
      const bool hardens = stage_of(state, h) == virgin;
      if (hardens) {
        harden_no_more(state, h, s);
        memory(worn) = backbone(h)->plastic;
      }
      const double bears = hardens ? borne(state, deformation)(h) : y(h);
      Fall fall = fall_of(state, h, true, bears);
      for (const double to : {1.0, -1.0}) {
        double& from = fall.line[Fall::number(to)];
        from = std::max(from, to * bears);
      }
      falls.push_back(fall);
      continue;
    }
    // Its line comes nearer to the moment, and stops there.
    double& left = state.memory(h, s > 0 ? left_below : left_above);
    const double before = left, at_line = line(state, h, -s);
    left = memory(left_before) * (1.0 - share);
    const double comes_to = line(state, h, -s);
    if (comes_to >= -s * y(h) || !(at_line > comes_to)) continue;
    left += (before - left) * std::clamp((-s * y(h) - comes_to) / (at_line - comes_to), 0.0, 1.0);
  }
  if (falls.empty()) return false;
  redistribute(state, deformation, deformation, time, std::move(falls));
  rest_off_lines(state, deformation);
  return true;
}

}  // namespace bentur
