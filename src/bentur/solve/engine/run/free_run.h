#pragma once

#include <optional>
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
  void note_reach(const RelationGroup& group, Eigen::Index point, const StepBuffer& buffer, Eigen::Index step);
  void add_meeting(Eigen::Index first, Eigen::Index count);

  /// Rows of points over the coordinates of a body on one side of them, in fours that differ by more than signs: what
  /// several of its neighbours meet is reported once.
  struct Side {
    explicit Side(const ModalSystem::Block& block) : begin(block.begin), rows(0, block.moving_size) {}
    /// Where the four are that these rows are the first of; they are added where there are none.
    Eigen::Index place(const Eigen::Ref<const Eigen::MatrixXd>& of);

    Eigen::Index begin = 0;
    Eigen::MatrixXd rows;
    std::optional<BoundedOutputs> sizes;
  };
  /// Four points from `first` on, of which only `count` are some, and where their rows are.
  struct Meeting {
    Eigen::Index first = 0, count = 0;
    Eigen::Index left = 0, right = 0;  ///< bodies; no right one: −1
    Eigen::Index left_at = 0, right_at = 0;
    Eigen::Vector4d speeds = Eigen::Vector4d::Zero();  ///< largest so far
  };

  FreeResult result_;
  std::vector<Side> sides_;  ///< per body
  std::vector<Meeting> meetings_;
  Eigen::VectorXd no_side_;  ///< values of one that is not there
};

}  // namespace bentur::engine
