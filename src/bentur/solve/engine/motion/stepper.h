#pragma once

#include <vector>

#include "bentur/solve/engine/motion/runge_kutta/embedded_pair.h"
#include "bentur/solve/engine/motion/runge_kutta/fixed_step.h"
#include "bentur/solve/engine/motion/runge_kutta/step_control.h"
#include "bentur/solve/engine/motion/series.h"
#include "bentur/solve/solver.h"

namespace bentur::engine {

/// Takes the next step in the way of a solver and makes it known as an expansion.
///
/// exact: by power series where all forces are linear; where one is not, by the embedded pair for the island of
/// bodies that it shakes (those joined by elements) and by power series for the others. adaptive: by the embedded
/// pair for all. runge-kutta: by steps of fixed length, a third of it in contact.
class Stepper {
 public:
  /// `offsets`: of each element's δ [length].
  Stepper(const ModalSystem& system, const std::vector<double>& offsets, const Solver& solver);

  /// What a step starts from, and what acts during it.
  struct Start {
    const State& state;
    const std::vector<GroundInput>& inputs;
    const ElementForces& forces;
    const ForceFunction& force_at;
  };

  /// Goes from `start` as far as is good, `longest` [s] at most. False when no step is short enough. `to` is the state
  /// at the end, but where the step is a power series: there motion has it.
  [[nodiscard]] bool advance(const Start& start, double longest, bool touching, Expansion& motion, State& to);

  /// Takes the same step again, but only `h` [s] of it. For solvers whose expansions are an approximation only.
  void retake(const Start& start, double h, Expansion& motion, State& to);

  /// Whether the step last taken is a power series, which is the solution itself wherever it is cut.
  [[nodiscard]] bool is_series() const { return way_ == Way::series; }
  [[nodiscard]] bool is_fixed() const { return way_ == Way::fixed; }
  [[nodiscard]] bool is_adapted() const { return way_ == Way::pair; }

  /// Learns when a contact begins: its force may set in steeply.
  void contact_begins() { fresh_ = true; }

  /// How well the places of events are known, relative to displacements and speeds, where steps are approximations.
  [[nodiscard]] double accuracy() const;

  [[nodiscard]] Series& series() { return series_; }

 private:
  enum class Way { series, pair, fixed };
  [[nodiscard]] BodyRange island(const ElementForces& forces) const;
  bool begin_contact(const Start& start, double longest, Expansion& motion, State& to);
  Eigen::VectorXd hold(const std::vector<Eigen::Index>& resting, Eigen::VectorXd& change) const;
  [[nodiscard]] double longest_before_parting(const Start& start, double h) const;
  bool advance_by_pair(const Start& start, double longest, Expansion& motion, State& to);
  void expand_pair(const Start& start, double h, Expansion& motion, State& to);
  void finish_expansion(const Start& start, Expansion& motion, State& to) const;
  void fill_resting(const Start& start, const State& from, Expansion& motion) const;

  const ModalSystem* system_;
  std::vector<double> offsets_;
  Solver solver_;
  Series series_;
  EmbeddedPair pair_;
  StepControl control_;
  FixedStep fixed_;
  Way way_ = Way::series;
  BodyRange range_;
  double guess_ = 0;          ///< length for the next attempt [s]
  double first_guess_ = 0;    ///< length of the step that begins a contact [s]
  double parting_scale_ = 0;  ///< step that failed first in a contact [s]; 0: none has
  bool fresh_ = true;
  /// What a force does over the first step of a contact: ∫F dt and ∫(h − t) F dt per element, changes of v and q.
  struct Push {
    Eigen::VectorXd impulse, moment, force, dv, dq;
  };
  Push push_;    ///< scratch
  State there_;  ///< scratch
};

}  // namespace bentur::engine
