#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "bentur/elements/coupled_law.h"
#include "bentur/elements/hinges/flowing_sets.h"

namespace bentur {

struct HingeSides;

/// All plastic hinges of a building as one law. Its deformations are δ = G x, the moments that its coordinates x make
/// at the hinges while none has turned [force·length]; the moments are M = δ − K_hh θ, θ [rad] what the hinges have
/// turned, and the forces that push along the rows of G are F = −θ, beside those of the elastic K x:
///   −lower ≤ M − H θ ≤ upper;  θ̇ ≥ 0 only on the upper line, ≤ 0 only on the lower one, else θ̇ = 0.  (H-2), (H-3)
/// A branch is the set A of hinges that flow and the side s = ±1 on which each does: θ_A follows from δ (H-4), all
/// other θ stay. After an event all hinges that are on a line are looked at together (H-7): by symmetry many yield at
/// once. Rigid-plastic: no stiffness of its own, no damping. (docs/theory/hinges.md)
class HingeLaw : public CoupledLaw {
 public:
  using Parameters = HingeParameters;
  /// `kept`: of numbers that FlowingSets keeps. @throws InvalidParameter when sizes disagree or a value is outside its
  /// range.
  explicit HingeLaw(Parameters parameters, Eigen::Index kept = FlowingSets::most_kept);

  [[nodiscard]] std::string_view name() const noexcept override { return "hinges"; }
  [[nodiscard]] Eigen::Index size() const noexcept override { return of_.hardening.size(); }
  [[nodiscard]] bool same_as(const CoupledLaw& other) const override;
  [[nodiscard]] CoupledState begin(const Eigen::VectorXd& deformation) const override;
  [[nodiscard]] CoupledBranch branch(const CoupledState& state) const override;
  [[nodiscard]] CoupledState next(const CoupledState& state, const CoupledBranch& branch, std::size_t guard,
                                  double time, const CoupledMotion& motion) const override;
  [[nodiscard]] CoupledState settle(const CoupledState& state, double time, const CoupledMotion& motion) const override;
  [[nodiscard]] CoupledState at(const CoupledState& state, const Eigen::VectorXd& deformation) const override;
  [[nodiscard]] double stored_energy(const CoupledState& state, const Eigen::VectorXd& deformation) const override;
  [[nodiscard]] double lost_energy(const CoupledState& state, const Eigen::VectorXd& deformation) const override;
  [[nodiscard]] bool is_odd() const noexcept override;
  [[nodiscard]] const Parameters& parameters() const { return of_; }

  /// What one hinge has done up to the last event, or to at().
  struct Record {
    double rotation = 0;                ///< θ [rad]
    double peak_rotation = 0;           ///< max |θ| at events [rad]; one that is free turns beyond it in between
    double lost = 0;                    ///< ∫ (M − H θ) dθ [force·length] ≥ 0
    std::optional<double> first_yield;  ///< [s]
    int half_cycles = 0;                ///< stretches of flow in one direction before it fails; elastic excursions
                                        ///< do not part them
    int flows = 0;                      ///< −1, 0 or 1: the side on which it flows now
    std::optional<double> broke;        ///< [s]
    /// Energy lost when it did, or when it snapped or failed [force·length], that of what is at rest included.
    double released = 0;
    double strength_left = 1;           ///< share of what it could bear at its cap, less wear (H-18), (H-21)
    std::optional<double> cap, failed;  ///< when it came to its cap, and when it had nothing left [s]
    std::optional<double> snapped;      ///< when it lost at once what it had to lose [s]
  };
  [[nodiscard]] Record record(const CoupledState& state, Eigen::Index hinge) const;

  /// Least part of a frame's stiffness with which it still bends (H-12).
  static constexpr double bends = FlowingSet::bends;
  /// When the hinges first made the frame movable without bending, and which of them flowed then.
  struct Mechanism {
    double time = 0;  ///< [s]
    std::vector<Eigen::Index> hinges;
  };
  [[nodiscard]] std::optional<Mechanism> mechanism(const CoupledState& state) const;
  /// Whether it has broken or failed, nothing is left and it moves either way without resistance.
  [[nodiscard]] bool is_free(const CoupledState& state, Eigen::Index hinge) const;

 private:
  /// Columns of a state's memory.
  enum Column : Eigen::Index {
    rotation,      // θ at the last event [rad]
    side,          // on which it flows; 0: it rests
    peak,          // max |θ|
    lost,          // ∫ (M − Hθ) dθ
    first_yield,   // [s]; NaN: none
    half_cycles,   //
    last_side,     // of the latest flow that counted
    flow_began,    // [s]
    mechanism_at,  // of the frame, in the first row [s]; NaN: none
    moved,         // 1: it flowed then
    broke_at,      // [s]; NaN: it has not
    released,      // energy lost then, or when it snapped or failed [force·length]
    begins,        // order of the zero that its guard begins the branch with; of a resting one times its line's side
    without_weakening,          // so many columns where nothing breaks or loses strength
    stage = without_weakening,  // of its backbone
    worn,                       // from the cap on: how far it has turned at most, or has been worn by a snap [rad]
    at_cap_above,               // what it could bear at the cap, beyond what wear had left of it then [force·length]
    at_cap_below,               //
    cap_side,                   // on which it came to it
    cap_at,                     // [s]; NaN: it has not
    snapped_at,                 //
    failed_at,                  //
    without_wear,               // so many columns where nothing wears
    left_above = without_wear,  // what wear has left of its strength on either side [-]
    left_below,                 //
    way,                        // the side on which it flowed last; 0: it has not
    left_before,                // of the other side when that began
    lost_before,                // dissipated() when that began
    lost_then,                  // dissipated() when what is left was known
    columns
  };
  /// Of a backbone (H-17): up to the cap, beyond it, on what it keeps for good, without anything.
  enum Stage : int { virgin, softened, levelled, spent };

  static constexpr double on_line = 1e-10;  // of upper + lower: a hinge that is so near its line is on it
  static constexpr double no_flow = 1e-12;  // of (upper + lower)/K_hh: a flow that counts nowhere
  static constexpr double at_end = 1e-10;   // of a rotation: so near to where a stage ends it does

  struct Flow;
  struct Fall;
  void note_mechanism(CoupledState& state, const FlowingSet& set, double time) const;
  [[nodiscard]] std::shared_ptr<const Flow> flow(const CoupledState& state, const Flow* before = nullptr) const;
  [[nodiscard]] Eigen::VectorXd rotations(const CoupledState& state, const Eigen::VectorXd& deformation) const;
  [[nodiscard]] bool breaks(Eigen::Index hinge) const { return of_.kept.size() > 0 && of_.kept(hinge) < 1.0; }
  [[nodiscard]] bool whole(const CoupledState& state, Eigen::Index hinge) const;
  [[nodiscard]] bool nothing_left(const CoupledState& state, Eigen::Index hinge) const {
    return weakens_ && has_nothing_left(state, hinge);
  }
  [[nodiscard]] bool has_nothing_left(const CoupledState& state, Eigen::Index hinge) const;
  [[nodiscard]] std::vector<char> moving_freely(const CoupledState& state) const;
  [[nodiscard]] double line(const CoupledState& state, Eigen::Index hinge, double sign) const {
    return weakens_ ? weakened_line(state, hinge, sign) : sign > 0 ? of_.upper(hinge) : of_.lower(hinge);
  }
  [[nodiscard]] double weakened_line(const CoupledState& state, Eigen::Index hinge, double side) const;
  [[nodiscard]] Eigen::VectorXd borne(const CoupledState& state, const Eigen::VectorXd& deformation) const;
  void load(CoupledState& state, const Eigen::VectorXd& deformation, double time,
            std::vector<Eigen::Index> broken) const;
  bool break_at_lines(CoupledState& state, double time, const Eigen::VectorXd& deformation,
                      const CoupledGuard* ended) const;
  [[nodiscard]] double width(Eigen::Index hinge) const { return widths_(hinge); }
  [[nodiscard]] CoupledState settle(const CoupledState& state, double time, const CoupledMotion& motion,
                                    const CoupledGuard* ended) const;

  [[nodiscard]] Eigen::VectorXd hardened_rotations(const CoupledState& state, Eigen::VectorXd rotations) const;
  /// Whether a guard that has come down to zero says that a hinge at rest is on its line of side `to`.
  [[nodiscard]] static bool guard_says_met(const CoupledGuard* ended, Eigen::Index h, double to) {
    return ended != nullptr && ended->deformation >= 0 && ended->of == h && to * ended->sense < 0.0;
  }
  [[nodiscard]] bool flow_by_sets(const HingeSides& sides, const Eigen::VectorXd& rate,
                                  std::vector<Eigen::Index> expected, Eigen::VectorXd& lambda) const;
  [[nodiscard]] Eigen::VectorXd borne_after(const Flow& flowed, const CoupledState& state,
                                            const Eigen::VectorXd& deformation) const;
  [[nodiscard]] std::vector<Eigen::Index> paces(const CoupledState& state, const HingeSides& sides,
                                                const Eigen::VectorXd& rate, std::vector<Eigen::Index> expected,
                                                Eigen::VectorXd& lambda) const;
  [[nodiscard]] std::vector<Eigen::Index> losing_most(const CoupledState& state, const HingeSides& sides,
                                                      const Eigen::VectorXd& way) const;

  // What repetition wears out (hinges/wear.cpp).
  [[nodiscard]] double left_by_wear(const CoupledState& state, Eigen::Index hinge, double side) const;
  [[nodiscard]] double dissipated(const CoupledState& state, Eigen::Index hinge) const;
  void set_out(CoupledState& state, Eigen::Index hinge, double side) const;
  bool wear(CoupledState& state, double time, const Eigen::VectorXd& deformation) const;

  // Backbones (hinges/backbones.cpp, hinges/redistribution.cpp).
  void check_backbones() const;
  [[nodiscard]] const HingeBackbone* backbone(Eigen::Index hinge) const;
  [[nodiscard]] Stage stage_of(const CoupledState& state, Eigen::Index hinge) const;
  [[nodiscard]] bool any_softened(const CoupledState& state) const;
  [[nodiscard]] bool past_a_cap(const CoupledState& state) const;
  [[nodiscard]] double strength_at_cap(const CoupledState& state, Eigen::Index hinge, double side) const;
  [[nodiscard]] double level(const CoupledState& state, Eigen::Index hinge) const;
  [[nodiscard]] double levelled_at(const CoupledState& state, Eigen::Index hinge) const;
  [[nodiscard]] double share_left(const CoupledState& state, Eigen::Index hinge) const;
  [[nodiscard]] double softened_line(const CoupledState& state, Eigen::Index hinge, double side) const;
  [[nodiscard]] double slope(const CoupledState& state, Eigen::Index hinge, double side) const;
  [[nodiscard]] double stage_end(const CoupledState& state, Eigen::Index hinge, double side) const;
  [[nodiscard]] bool end_stage(CoupledState& state, Eigen::Index hinge, double side, double time) const;
  void sync(CoupledState& state, Eigen::Index hinge, double side) const;
  void harden_no_more(CoupledState& state, Eigen::Index hinge, double side) const;
  [[nodiscard]] Fall fall_of(const CoupledState& state, Eigen::Index hinge, bool fails, double borne) const;
  void redistribute(CoupledState& state, Eigen::VectorXd from, const Eigen::VectorXd& to, double time,
                    std::vector<Fall> falls) const;
  bool end_stages(CoupledState& state, double time, const Eigen::VectorXd& deformation) const;
  void snap(CoupledState& state, const Eigen::VectorXd& deformation, double time,
            const std::vector<Eigen::Index>& hinges) const;
  void rest_off_lines(CoupledState& state, const Eigen::VectorXd& deformation) const;
  void note_flow(CoupledState& state, Eigen::Index hinge, double side, double turned, double began) const;

  Parameters of_;
  Eigen::MatrixXd hardened_;                 ///< K_hh + H
  Eigen::VectorXd roots_;                    ///< √ of what K_hh has on its diagonal
  Eigen::VectorXd widths_;                   ///< upper + lower, or twice the one that is finite
  Eigen::VectorXd near_upper_, near_lower_;  ///< below these a hinge that does not weaken is on neither line
  bool wears_ = false;                       ///< a hinge does
  bool weakens_ = false;                     ///< one may break, or lose strength
  bool keeps_ = true;                        ///< sets that have been met, by which λ of (H-7) comes
  FlowingSets sets_;
};

}  // namespace bentur
