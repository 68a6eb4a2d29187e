#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "bentur/study/design/sampling.h"

namespace bentur {

/// One direction in which the runs of a study differ.
struct SweepAxis {
  std::size_t levels = 0;  ///< values to choose from; 0: a continuous one, which only samples can take
  bool inner = false;      ///< runs that differ along such axes alone share most of their work
};

/// The runs of a study by number, and the order to work on them: a grid counts through its axes with the last one
/// fastest; samples are numbered as they are drawn.
class SweepDesign {
 public:
  /// @throws InvalidParameter without axes, with a continuous axis in a grid, without samples, or with more than
  /// 10⁹ runs.
  SweepDesign(std::vector<SweepAxis> axes, const Sampling& sampling);

  [[nodiscard]] std::size_t runs() const noexcept { return runs_; }
  [[nodiscard]] bool is_grid() const noexcept { return !points_.has_value(); }
  [[nodiscard]] const std::vector<SweepAxis>& axes() const noexcept { return axes_; }

  /// Which value of an axis with levels `run` has.
  [[nodiscard]] std::size_t level(std::size_t run, std::size_t axis) const;
  /// In a grid, the run that differs from `run` by having that level of an axis.
  [[nodiscard]] std::size_t at_level(std::size_t run, std::size_t axis, std::size_t level) const;
  /// Where on a continuous axis `run` lies: u in (0, 1).
  [[nodiscard]] double unit(std::size_t run, std::size_t axis) const;

  /// The run to be worked on as number `position` < runs(): every run once, those of one group one after the other.
  [[nodiscard]] std::size_t run_at(std::size_t position) const;
  /// Runs of one group differ along inner axes alone.
  [[nodiscard]] std::uint64_t group(std::size_t run) const;
  /// Whether groups have more than one run.
  [[nodiscard]] bool has_groups() const noexcept { return has_groups_; }

 private:
  std::vector<SweepAxis> axes_;
  std::size_t runs_ = 1;
  std::optional<UnitPoints> points_;  // of samples
  bool has_groups_ = false;
  std::vector<std::uint32_t> order_;  // of samples in groups
};

}  // namespace bentur
