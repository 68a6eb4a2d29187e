#pragma once

#include <vector>

#include "bentur/solve/engine/run/gap_monitor.h"
#include "bentur/solve/engine/run/run.h"

namespace bentur::engine {

/// What the free response has in common with all responses that it turns into when two buildings touch.
struct FreeResult {
  /// The openings came no lower than −reach before a segment.
  struct Reach {
    long segment = 0;
    double reach = 0;  ///< [length]
  };
  std::vector<std::vector<Reach>> reaches;   ///< per point, ascending in both
  std::vector<double> needed;                ///< per point: the gap that is never closed [length]
  std::vector<double> speeds;                ///< per point: both floors' together, the largest seen [length/s]
  std::vector<Run::Checkpoint> checkpoints;  ///< ascending
};

/// The first segment in which one of the gaps may close when they have these widths; max() where they never do.
[[nodiscard]] long first_contact(const FreeResult& free, const std::vector<double>& widths);

/// Contact switched off: peak displacements and the gap that would have been needed.
class FreeRun final : public Run {
 public:
  explicit FreeRun(const Setup& setup);

  /// Per point, max(0, x_left − x_right) [length].
  [[nodiscard]] std::vector<double> needed() const;

  /// After to_end().
  [[nodiscard]] FreeResult take_result();

 private:
  [[nodiscard]] const ContactForces& forces() const override { return none_; }
  [[nodiscard]] const ForceFunction& force_at() const override { return no_force_; }
  [[nodiscard]] bool may_fly() const override { return true; }
  [[nodiscard]] Eigen::Index quiet(Eigen::Index count) override { return count; }
  void take_buffer(const StepBuffer& buffer) override;
  double look(double time) override;
  [[nodiscard]] bool settle_before(long /*segment*/) override { return true; }
  void settled_before(long /*segment*/) override { result_.checkpoints.push_back(checkpoint()); }
  void settle() override;
  void note(Eigen::Index point, long segment, double reach);
  void note_speeds(const double* v);
  void raise(const State& from, const State& to);
  [[nodiscard]] bool below(const std::vector<double>& reach) const;

  /// A step in which a gap may have been exceeded.
  struct Unsettled {
    const Flights* flights;  ///< none: a power series
    std::size_t halvings;
    double length;  ///< [s]
    State start;
    std::vector<GroundInput> inputs;
    std::vector<double> reach;  ///< per point
  };
  void note_reaches(const Gaps& gaps, const StepBuffer& buffer);
  [[nodiscard]] bool settled(Gaps& gaps, const StepBuffer& buffer, Eigen::Index step);

  const ContactForces none_;
  const ForceFunction no_force_;
  std::vector<Gaps> gaps_;       ///< their peaks are what is needed
  std::vector<double*> needed_;  ///< per point, where its peak is kept
  FreeResult result_;
  std::vector<Unsettled> unsettled_;
};

}  // namespace bentur::engine
