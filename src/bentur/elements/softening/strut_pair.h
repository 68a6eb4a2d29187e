#pragma once

#include "bentur/elements/softening/backbone_law.h"

namespace bentur {

/// The two diagonal struts of an infill panel, one each way: each pushes only while its diagonal is shorter than it has
/// been crushed to, so that never more than one of them works. Each has the same backbone (L-5) and is unloaded and
/// loaded again along the line with its first stiffness k,
///   F = k (δ − p) ≥ 0 of one, F = k (δ + p) ≤ 0 of the other,  p ≥ 0 each one's own,                        (I-1)
/// p = δ − F/k where it leaves its backbone. Between them nothing resists. The panel has failed for good, both ways,
/// when one of them has come to its ultimate deformation or to a strength of zero.
class StrutPair final : public HystereticLaw {
 public:
  /// @param stiffness k [force/length] > 0
  /// @throws InvalidParameter as BackboneLaw's.
  StrutPair(double stiffness, const Backbone& backbone);

  [[nodiscard]] std::string_view name() const noexcept override { return "strut-pair"; }
  [[nodiscard]] LawParameters parameters() const override;
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] LawState next(const LawState& state, std::size_t guard, double time, double deformation,
                              double speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double deformation) const noexcept override;
  [[nodiscard]] bool is_odd() const noexcept override { return true; }
  [[nodiscard]] double initial_stiffness() const noexcept override { return stiffness_; }
  [[nodiscard]] double yield_deformation() const noexcept override { return of_.yield / stiffness_; }
  [[nodiscard]] double residual(const LawState& state, double deformation) const noexcept override;
  [[nodiscard]] std::optional<StrengthLoss> loss(const LawState& state, double deformation) const noexcept override;

 private:
  // Branches; those of the struts in pairs, that which pushes at δ > 0 first and odd.
  enum : int { virgin, plastic = 1, softening = 3, level = 5, loaded = 7, slack = 9, failed = 10 };
  /// A straight piece of the backbone: force + slope size, up to `end`.
  struct Piece {
    double force, slope, end;
  };
  struct Past;
  [[nodiscard]] Past past_of(const LawState& state) const noexcept;
  [[nodiscard]] Piece piece(int upper) const noexcept;
  [[nodiscard]] LawState go_on(Past past, int upper, int strut, double time) const noexcept;

  double stiffness_;
  Backbone of_;
  double yields_, capped_, leveled_;  ///< sizes of δ at the ends of the first pieces [length]
};

}  // namespace bentur
