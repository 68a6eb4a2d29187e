#pragma once

#include "bentur/solve/engine/motion/expansion.h"
#include "bentur/solve/engine/run/elements.h"
#include "bentur/solve/solution.h"

namespace bentur::engine {

inline constexpr double sample_slack = 1e-9;  ///< of a step: a sample this little beyond the end of an interval counts

/// Samples at 0, `step`, 2 `step`, … up to `duration` [s].
[[nodiscard]] Eigen::Index sample_count(double duration, double step);

/// Samples at equal times from solutions that are known anyway; it never changes the solution.
class Sampler {
 public:
  /// `offsets`: of all elements
  Sampler(const ModalSystem& system, const System& given, const std::vector<double>& offsets, double output_step);

  /// Whether a sample falls in (…, time].
  [[nodiscard]] bool due(double time) const;

  /// Takes every sample up to `until` [s] out of the expanded step that began at `time` with `inputs`.
  void take(const Expansion& motion, double time, double until, const std::vector<GroundInput>& inputs,
            const Elements& elements);

  /// Takes the next sample, of which this is the state.
  void take(const State& state, const std::vector<GroundInput>& inputs, const Elements& elements);
  [[nodiscard]] double next_time() const { return static_cast<double>(taken_) * step_; }  ///< [s]

  /// Puts the samples that were taken into a solution, whose outputs have an entry for each.
  void finish(Solution& solution);

 private:
  /// Multiplies outputs of the instants that wait for it, many at a time.
  void multiply();

  const ModalSystem* system_;
  const System* given_;
  std::vector<double> offsets_;
  double step_;
  Eigen::Index count_ = 0, taken_ = 0;
  Sampled samples_;
  std::vector<std::vector<Eigen::MatrixXd>> outputs_;     ///< per body, as its outputs
  std::vector<double> largest_q_, largest_acceleration_;  ///< per body, squares of the norms over its modes
  State state_;
  Eigen::VectorXd forces_, acceleration_;
  Eigen::Index multiplied_ = 0;  ///< of the samples taken
  Eigen::MatrixXd q_, v_, a_;    ///< of those after them, a column each
};

}  // namespace bentur::engine
