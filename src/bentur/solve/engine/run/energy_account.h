#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bentur/solve/engine/run/contacts.h"

namespace bentur::engine {

/// Keeps account of all energy, step by step:
///   input = initial + ∫ (γ a_g) · q̇ dt − Σ ∫ F_i sense_i,ground q̇_ground dt  (work of the ground, also through
///   contact), kinetic = ½ q̇²,  strain = ½ Ω² q²,  damping = ∫ q̇ · D q̇ dt,  contact = Σ ∫ F_i δ̇_i dt + Σ jumps, (E-2)
/// all over the modes; the residual is input − kinetic − strain − damping − contact. What contacts took is what they
/// store and what they have lost. Integrals are by Gauss's rule, on steps that the expansion has made short.
class EnergyAccount {
 public:
  EnergyAccount(const ModalSystem& system, const Problem& problem, double output_step);

  /// Takes in [0, end] of the expanded step that began at `time` with `inputs`.
  void take(const Expansion& motion, double time, double end, const std::vector<GroundInput>& inputs,
            const Contacts& contacts);
  /// Takes in the jumps of the last change, after which the state is `state`.
  void take_jumps(const Contacts& contacts, const State& state);

  [[nodiscard]] EnergyAudit finish();

 private:
  struct Sums {
    double input = 0, damping = 0, contact = 0;
  };
  void integrate(const Expansion& motion, double from, double to, const std::vector<GroundInput>& inputs,
                 const Contacts& contacts);
  /// Looks at a state: the residual, and a row of the histories where `sample`.
  void look(const State& state, const Contacts& contacts, bool sample);
  [[nodiscard]] double kinetic(const State& state) const;
  [[nodiscard]] double strain(const State& state) const;
  /// sense_i · q̇ of the ground coordinates alone [length/s].
  [[nodiscard]] double ground_speed(Eigen::Index point, const State& state) const;

  const ModalSystem* system_;
  double step_;
  Eigen::Index count_ = 0, taken_ = 0;
  Eigen::VectorXd is_mode_;  ///< 1 for modes, 0 for ground coordinates
  Sums sums_;
  EnergyAudit audit_;
  State state_;
  std::vector<GroundInput> inputs_;
  Eigen::VectorXd forces_;
};

}  // namespace bentur::engine
