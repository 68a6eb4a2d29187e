#include "bentur/elements/softening/strut_pair.h"
#include "bentur/core/not_known.h"

#include <algorithm>
#include <cmath>

namespace bentur {
namespace {

// Struts are 0, which pushes at δ > 0, and 1; sizes and strengths are told for the first.
double strut_way(int strut) { return strut == 0 ? 1.0 : -1.0; }
int strut_of_branch(int branch) { return branch % 2 == 1 ? 0 : 1; }
int upper_branch(int branch) { return branch - strut_of_branch(branch); }

}  // namespace

/// What is remembered: how far each strut is crushed, where it left its backbone and on which piece, and when.
struct StrutPair::Past {
  double crushed[2], reach[2];
  int piece[2];
  double capped, level, failed;

  [[nodiscard]] LawState in(int branch, double time) const {
    return {.branch = branch,
            .since = time,
            .memory = {crushed[0], crushed[1], reach[0], reach[1], static_cast<double>(piece[0]),
                       static_cast<double>(piece[1]), capped, level, failed}};
  }
};

StrutPair::StrutPair(double stiffness, const Backbone& backbone) : stiffness_(stiffness), of_(backbone) {
  static_cast<void>(BackboneLaw({.stiffness = stiffness, .positive = backbone, .negative = backbone}));  // checks them
  yields_ = of_.yield / stiffness_;
  capped_ = yields_ + of_.plastic;
  leveled_ = capped_ + of_.softening * (1 - of_.residual / of_.cap);
}

LawParameters StrutPair::parameters() const {
  return {{"stiffness", stiffness_},    {"yield_force", of_.yield}, {"cap", of_.cap},          {"plastic", of_.plastic},
          {"softening", of_.softening}, {"residual", of_.residual}, {"ultimate", of_.ultimate}};
}

StrutPair::Past StrutPair::past_of(const LawState& state) const noexcept {
  if (state.branch == virgin) return {{0, 0}, {yields_, yields_}, {plastic, plastic}, not_known, not_known, not_known};
  const auto& m = state.memory;
  return {{m[0], m[1]}, {m[2], m[3]}, {static_cast<int>(m[4]), static_cast<int>(m[5])}, m[6], m[7], m[8]};
}

StrutPair::Piece StrutPair::piece(int upper) const noexcept {
  const double cap = of_.cap * of_.yield;
  if (upper == plastic) {
    const double slope = std::isinf(of_.plastic) ? 0.0 : (cap - of_.yield) / of_.plastic;
    return {of_.yield - slope * yields_, slope, std::min(capped_, of_.ultimate)};
  }
  if (upper == softening) {
    if (std::isinf(of_.softening)) return {cap, 0.0, of_.ultimate};
    const double slope = -cap / of_.softening;
    return {cap - slope * capped_, slope, std::min(leveled_, of_.ultimate)};
  }
  return {of_.floor(), 0.0, of_.ultimate};
}

Branch StrutPair::branch(const LawState& state) const noexcept {
  if (state.branch == virgin) {
    return Branch{.stiffness = stiffness_}.guarded_by(
        {{.constant = yields_, .deformation = -1}, {.constant = yields_, .deformation = 1}});
  }
  if (state.branch == failed) return Branch{};
  const Past past = past_of(state);
  if (state.branch == slack) {
    return Branch{}.guarded_by(
        {{.constant = past.crushed[0], .deformation = -1}, {.constant = past.crushed[1], .deformation = 1}});
  }
  const int strut = strut_of_branch(state.branch);
  const double s = strut_way(strut);
  if (upper_branch(state.branch) == loaded) {
    return Branch{.base = -s * stiffness_ * past.crushed[strut], .stiffness = stiffness_}.guarded_by(
        {{.constant = past.reach[strut], .deformation = -s}, {.constant = -past.crushed[strut], .deformation = s}});
  }
  const Piece on = piece(upper_branch(state.branch));
  const Branch along = Branch{.base = s * on.force, .stiffness = on.slope}.guarded_by({{.speed = s}});
  return std::isinf(on.end) ? along : along.guarded_by({{.constant = on.end, .deformation = -s}});
}

/// Enters a piece of the backbone.
LawState StrutPair::go_on(Past past, int upper, int strut, double time) const noexcept {
  if (upper == softening && std::isnan(past.capped)) past.capped = time;
  if (upper == level && std::isnan(past.level)) past.level = time;
  if (upper == level && of_.floor() == 0.0) {
    past.failed = time;
    return past.in(failed, time);
  }
  past.piece[strut] = upper;
  return past.in(upper + strut, time);
}

LawState StrutPair::next(const LawState& state, std::size_t guard, double time, double deformation,
                         double /*speed*/) const noexcept {
  Past past = past_of(state);
  if (state.branch == failed) return state;
  if (state.branch == virgin) return go_on(past, plastic, guard == 0 ? 0 : 1, time);
  if (state.branch == slack) return past.in(loaded + (guard == 0 ? 0 : 1), time);
  const int strut = strut_of_branch(state.branch), upper = upper_branch(state.branch);
  if (upper == loaded) return guard == 0 ? go_on(past, past.piece[strut], strut, time) : past.in(slack, time);
  const Piece on = piece(upper);
  if (guard == 0) {
    past.reach[strut] = strut_way(strut) * deformation;
    past.crushed[strut] = past.reach[strut] - (on.force + on.slope * past.reach[strut]) / stiffness_;
    return past.in(loaded + strut, time);
  }
  if (on.end == of_.ultimate) {
    past.failed = time;
    return past.in(failed, time);
  }
  return go_on(past, upper == plastic ? softening : level, strut, time);
}

double StrutPair::stored_energy(const LawState& state, double deformation) const noexcept {
  const double force = this->force(state, deformation, 0);
  return 0.5 * force * force / stiffness_;
}

double StrutPair::residual(const LawState& state, double deformation) const noexcept {
  return deformation - force(state, deformation, 0) / stiffness_;
}

std::optional<StrengthLoss> StrutPair::loss(const LawState& state, double deformation) const noexcept {
  if (std::isinf(capped_) && std::isinf(of_.ultimate)) return std::nullopt;
  const Past past = past_of(state);
  const auto told = [](double time) { return std::isnan(time) ? std::nullopt : std::optional(time); };
  StrengthLoss loss{.capped = told(past.capped), .residual = told(past.level), .failed = told(past.failed)};
  if (state.branch == failed) loss.left = 0;
  const bool on_backbone = state.branch != virgin && state.branch < loaded;
  for (int strut = 0; strut < 2 && state.branch != failed; ++strut) {
    if (past.piece[strut] == plastic) continue;
    const bool now = on_backbone && strut == strut_of_branch(state.branch);
    const double size = now ? strut_way(strut) * deformation : past.reach[strut];
    const Piece on = piece(past.piece[strut]);
    const double left = (on.force + on.slope * size) / (of_.cap * of_.yield);
    loss.left = std::min(loss.left, std::clamp(left, of_.residual / of_.cap, 1.0));
  }
  return loss;
}

}  // namespace bentur
