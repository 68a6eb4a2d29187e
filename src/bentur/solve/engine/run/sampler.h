#pragma once

#include "bentur/solve/engine/motion/expansion.h"
#include "bentur/solve/engine/run/elements.h"
#include "bentur/solve/response.h"

namespace bentur::engine {

inline constexpr double sample_slack = 1e-9;  ///< of a step: a sample this little beyond the end of an interval counts

/// Samples at 0, `step`, 2 `step`, … up to `duration` [s].
[[nodiscard]] Eigen::Index sample_count(double duration, double step);

/// Fills histories at equal times from solutions that are known anyway; it never changes the solution.
class Sampler {
 public:
  Sampler(const ModalSystem& system, const Problem& problem, double output_step);

  /// Whether a sample falls in (…, time].
  [[nodiscard]] bool due(double time) const;

  /// Takes every sample up to `until` [s] out of the expanded step that began at `time` with `inputs`.
  void take(const Expansion& motion, double time, double until, const std::vector<GroundInput>& inputs,
            const Elements& elements);

  [[nodiscard]] Histories& histories() { return histories_; }
  /// Drops the columns of samples that were not taken.
  void finish();

 private:
  [[nodiscard]] double next_time() const { return static_cast<double>(taken_) * step_; }

  const ModalSystem* system_;
  const Problem* problem_;
  double step_;
  Eigen::Index count_ = 0, taken_ = 0;
  Histories histories_;
  State state_;
  Eigen::VectorXd forces_, acceleration_;
};

}  // namespace bentur::engine
