#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bentur/solve/engine/run/elements.h"
#include "bentur/solve/solution.h"

namespace bentur::engine {

/// Keeps account of all energy, step by step:
///   input = initial + ∫ (γ a_g) · q̇ dt + Σ ∫ F_i row_i,ground q̇_ground dt  (work of the ground, also through contacts
///   and links), kinetic = ½ q̇²,  bent = ½ Ω² q²,  damping = ∫ q̇ · D q̇ dt,  contact = Σ ∫ F_i δ̇_i dt + Σ jumps,
///   others = the same integral of all other elements, from rest on;                                          (E-2)
/// all over the modes; the residual is input − kinetic − bent − damping − contact − others. What contacts took is what
/// they store and what they have lost. What others took is kept as what they store (with `bent` the strain energy),
/// what their dashpots took (with the damping), and the rest, hysteretic. Integrals are by Gauss's rule, on steps that
/// the expansion has made short.
class EnergyAccount {
 public:
  /// `start`: the initial state.
  EnergyAccount(const ModalSystem& system, double duration, double output_step, const State& start,
                const Elements& elements);

  /// Takes in [0, end] of the expanded step that began at `time` with `inputs`.
  void take(const Expansion& motion, double time, double end, const std::vector<GroundInput>& inputs,
            const Elements& elements);
  /// Takes in the jumps of the last change, after which the state is `state`.
  void take_jumps(const Elements& elements, const State& state);

  [[nodiscard]] EnergyAudit finish();

 private:
  struct Sums {
    double input = 0, damping = 0, contact = 0, others = 0, dashpots = 0;
  };
  void integrate(const Expansion& motion, double from, double to, const std::vector<GroundInput>& inputs,
                 const Elements& elements);
  /// Looks at a state: the residual, and a row of the histories where `sample`.
  void look(const State& state, const Elements& elements, bool sample);
  [[nodiscard]] double kinetic(const State& state) const;
  [[nodiscard]] double strain(const State& state) const;
  /// row_i · q̇ of the ground coordinates alone [length/s].
  [[nodiscard]] double ground_speed(Eigen::Index element, const State& state) const;

  const ModalSystem* system_;
  double step_;
  Eigen::Index count_ = 0, taken_ = 0;
  Sums sums_;
  EnergyAudit audit_;
  State state_;
  std::vector<GroundInput> inputs_;
  Eigen::VectorXd forces_;
};

}  // namespace bentur::engine
