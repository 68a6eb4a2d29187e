#pragma once

#include <vector>

#include "bentur/solve/engine/run/run.h"

namespace bentur::engine {

/// What the free response has in common with all responses that it turns into when two bodies touch.
struct FreeResult {
  /// The openings came no lower than −reach before a segment.
  struct Before {
    long segment = 0;
    double reach = 0;  ///< [length]
  };
  std::vector<std::vector<Before>> reaches;  ///< per point, ascending in both
  std::vector<double> needed;                ///< per point: the gap that is never closed [length]
  std::vector<double> speeds;                ///< per point: both sides' together, the largest seen [length/s]
  std::vector<Run::Checkpoint> checkpoints;  ///< ascending
};

/// The first segment in which one of the gaps may close when they have these widths; max() where they never do.
[[nodiscard]] long first_contact(const FreeResult& free, const std::vector<double>& widths);

/// Contact switched off: peaks and the gaps that would have been needed.
class FreeRun final : public Run {
 public:
  explicit FreeRun(const Setup& setup);

  /// After to_end().
  [[nodiscard]] FreeResult take_result();

 private:
  void take_buffer(const StepBuffer& buffer) override;
  void approximated() override;
  [[nodiscard]] bool settle_before(long /*segment*/) override { return elements_.may_fly(); }
  void settled_before(long /*segment*/) override { result_.checkpoints.push_back(checkpoint()); }
  void note(Eigen::Index point, long segment, double reach);
  void note_speeds(const double* v, Eigen::Index count);
  void note_reaches(const RelationGroup& group, const StepBuffer& buffer);

  /// Both sides of points between the same bodies, as rows over their coordinates.
  struct Sides {
    Eigen::Index first = 0, count = 0;  ///< points
    Eigen::Index left_begin = 0, right_begin = 0;
    BoundedOutputs left, right;
  };

  FreeResult result_;
  std::vector<Sides> sides_;
};

}  // namespace bentur::engine
