#pragma once

#include <limits>
#include <optional>
#include <string_view>

#include "bentur/elements/law.h"

namespace bentur {

/// What one side of an element can bear as it deforms further and further: three straight pieces and a floor.
///   F = k δ to F_y, up to F_c = cap · F_y over δ_p, down towards zero over δ_pc, but never below F_r = residual · F_y;
///   nothing from δ_u on. (L-5)
/// In the words of ASCE 41: a is δ_p, c is `residual`, b ends at δ_u.
struct Backbone {
  double yield = 0;                                                ///< F_y [force] > 0
  double cap = 1;                                                  ///< F_c/F_y [-] ≥ 1
  double plastic = std::numeric_limits<double>::infinity();        ///< δ_p [length] > 0; infinite: it keeps F_y
  double softening = std::numeric_limits<double>::infinity();      ///< δ_pc [length] > 0, from the cap to zero force
  double residual = 0;                                             ///< F_r/F_y [-], 0 ≤ F_r/F_y < cap
  double ultimate = std::numeric_limits<double>::infinity();       ///< δ_u [length] beyond F_y/k
  [[nodiscard]] double floor() const { return residual * yield; }  ///< F_r [force]
  [[nodiscard]] bool operator==(const Backbone&) const = default;
};

/// How fast repetition wears an element out [IbarraMedinaKrawinkler2005]: energies γ F_y δ_y that can be lost, F_y and
/// δ_y of the weaker side; infinite: not at all. What was lost since there was no force last, E_i, gives
///   β = (E_i/(γ F_y δ_y − Σ E))^c,                                                                    (L-6)
/// and F_y and the slope to the cap become (1 − β) of what they were, the line beyond the cap falls by β of its force
/// at δ = 0, the peak that it heads for moves out by β, the stiffness of unloading falls by β.
struct Deterioration {
  static constexpr double none = std::numeric_limits<double>::infinity();
  double strength = none, cap = none, reloading = none, unloading = none;  ///< γ [-] > 0
  double exponent = 1;                                                     ///< c [-], 1 … 2
};

/// How it goes on from where there is no force: along the line on which it was unloaded, straight for the peaks of
/// before, or by way of a point of little force.
enum class Reloading { bilinear, peak_oriented, pinching };
/// "bilinear", "peak-oriented", "pinching".
[[nodiscard]] std::string_view word_of(Reloading reloading);

/// An element that loses strength: backbones (L-5) of both sides, rules of Ibarra, Medina & Krawinkler (2005) between
/// them as OpenSees has them in IMKBilin, IMKPeakOriented and IMKPinching (A. Elkady, H. ElJisr), with their
/// parameters changing only where it turns or has no force: (L-6)
///   1. from a turn at (δ, F), its side's last one, it unloads with k_u; the largest δ of each side is its peak;
///   2. without force it enters the other side, whose backbone and peak then deteriorate; there
///      bilinear: the line of unloading goes on to the backbone;
///      peak-oriented: it heads for the last turn of that side where this is steeper, then for the peak, then along the
///      backbone;
///      pinching: before that, with `pinching_force` of the slope to the peak, it goes to 1 − `pinching_deformation` of
///      what the peak would leave when unloaded;
///   3. back at the turn it goes on to the peak, or along the backbone it came from.
/// Where a peak cannot be headed for with a slope of k or less the line has the slope k and ends at the backbone. It
/// fails for good, both sides of it, from δ_u on, when softening has come to zero, and when a β exceeds 1 or its
/// divisor is gone; only the first drops a force, whose energy F²/2k_u is lost. k_u never falls so far that unloading
/// would give back more than was put in since there was no force last. It would give back F²/2k_u. (docs/theory/
/// elements.md says where this differs from OpenSees.)
class BackboneLaw final : public HystereticLaw {
 public:
  struct Parameters {
    double stiffness = 0;  ///< k [force/length] > 0
    Backbone positive, negative;
    Deterioration deterioration = {};
    Reloading reloading = Reloading::bilinear;
    double pinching_force = 1;        ///< κ_F [-], 0 < κ_F ≤ 1
    double pinching_deformation = 0;  ///< κ_D [-], 0 ≤ κ_D < 1
    bool one_sided = false;           ///< δ < 0, and what is left of δ, meets no force: a strut
  };
  /// @throws InvalidParameter unless every value is in its range, softening lasts where plastic does not, and the
  /// ultimate deformation is beyond yielding.
  explicit BackboneLaw(const Parameters& parameters);

  [[nodiscard]] std::string_view name() const noexcept override { return word_of(of_.reloading); }
  [[nodiscard]] LawParameters parameters() const override;
  [[nodiscard]] const Parameters& made_of() const { return of_; }
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] LawState next(const LawState& state, std::size_t guard, double time, double deformation,
                              double speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double deformation) const noexcept override;
  [[nodiscard]] bool is_odd() const noexcept override { return !of_.one_sided && of_.positive == of_.negative; }
  [[nodiscard]] double initial_stiffness() const noexcept override { return of_.stiffness; }
  [[nodiscard]] double yield_deformation() const noexcept override { return of_.positive.yield / of_.stiffness; }
  [[nodiscard]] double yield_deformation_below() const noexcept override {
    return (of_.one_sided ? of_.positive : of_.negative).yield / of_.stiffness;
  }
  [[nodiscard]] double residual(const LawState& state, double deformation) const noexcept override;
  [[nodiscard]] std::optional<StrengthLoss> loss(const LawState& state, double deformation) const noexcept override;

 private:
  enum : int {  // branches; those of both sides in pairs
    virgin,
    plastic_up,
    plastic_down,
    softening_up,
    softening_down,
    residual_up,
    residual_down,
    unloading_above,
    unloading_below,
    pinched_up,
    pinched_down,
    last_up,
    last_down,
    peak_up,
    peak_down,
    slack,
    failed
  };
  struct Side;
  struct Past;
  [[nodiscard]] const Backbone& backbone(double side) const { return side > 0 ? of_.positive : of_.negative; }
  [[nodiscard]] double softening_slope(const Past& past, double side) const noexcept;
  [[nodiscard]] double cap_at(const Past& past, double side) const noexcept;
  [[nodiscard]] bool flat(const Past& past, double side) const noexcept;
  [[nodiscard]] double strength(const Past& past, double side, double size) const noexcept;
  [[nodiscard]] double met(const Past& past, double side, double size, double force, double slope) const noexcept;
  [[nodiscard]] double unloading_stiffness(const Past& past, double force) const noexcept;
  [[nodiscard]] double worn(double energy, double gamma, double lost) const noexcept;
  [[nodiscard]] LawState along_backbone(Past past, double side, double size, double time) const noexcept;
  [[nodiscard]] LawState soften(Past past, double side, double time) const noexcept;
  [[nodiscard]] LawState level(Past past, double side, double time) const noexcept;
  [[nodiscard]] LawState turn(Past past, double side, double deformation, double force, double time) const noexcept;
  [[nodiscard]] LawState enter(Past past, double side, double time) const noexcept;
  [[nodiscard]] LawState head(Past past, double side, double time) const noexcept;
  [[nodiscard]] LawState to_peak(Past past, double side, double size, double force, double time) const noexcept;
  [[nodiscard]] LawState go_on(Past past, double side, double size, double force, double time) const noexcept;
  [[nodiscard]] LawState fail(Past past, double time) const noexcept;
  [[nodiscard]] double back(const LawState& state, double deformation, double force) const noexcept;

  Parameters of_;
};

}  // namespace bentur
