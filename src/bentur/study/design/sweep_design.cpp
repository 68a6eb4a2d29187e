#include "bentur/study/design/sweep_design.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

constexpr std::size_t most_runs = 1000000000;

}  // namespace

SweepDesign::SweepDesign(std::vector<SweepAxis> axes, const Sampling& sampling) : axes_(std::move(axes)) {
  const auto require = [](bool ok, const std::string& parameter, std::size_t value, const std::string& rule) {
    if (!ok) throw InvalidParameter(parameter, std::to_string(value), rule);
  };
  const auto any = [&](auto&& holds) { return std::any_of(axes_.begin(), axes_.end(), holds); };
  require(!axes_.empty(), "axes", 0, "must be one or more");
  const bool some_outer = any([](const SweepAxis& axis) { return !axis.inner; });
  if (sampling.method == Sampling::Method::grid) {
    for (const SweepAxis& axis : axes_) {
      require(axis.levels > 0, "levels", 0, "must be > 0 in a grid");
      require(runs_ <= most_runs / axis.levels, "levels", axis.levels, "make more than a thousand million runs");
      runs_ *= axis.levels;
    }
    has_groups_ = any([](const SweepAxis& axis) { return axis.inner && axis.levels > 1; });
    return;
  }
  runs_ = sampling.count;
  require(runs_ > 0 && runs_ <= most_runs, "count", runs_, "must be > 0 and at most a thousand million");
  points_.emplace(sampling, axes_.size());
  has_groups_ = !any([](const SweepAxis& axis) { return !axis.inner && axis.levels == 0; });
  if (has_groups_ && some_outer) {
    std::vector<std::uint64_t> groups(runs_);
    for (std::size_t run = 0; run < runs_; ++run) groups[run] = group(run);
    order_.resize(runs_);
    std::iota(order_.begin(), order_.end(), 0U);
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return groups[a] < groups[b]; });
  }
}

std::size_t SweepDesign::level(std::size_t run, std::size_t axis) const {
  const std::size_t levels = axes_[axis].levels;
  if (points_) {
    const double u = points_->at(run, axis);
    return std::min(static_cast<std::size_t>(u * static_cast<double>(levels)), levels - 1);
  }
  for (std::size_t later = axes_.size() - 1; later > axis; --later) run /= axes_[later].levels;
  return run % levels;
}

std::size_t SweepDesign::at_level(std::size_t run, std::size_t axis, std::size_t level) const {
  std::size_t stride = 1;
  for (std::size_t later = axes_.size() - 1; later > axis; --later) stride *= axes_[later].levels;
  return run + (level - this->level(run, axis)) * stride;
}

double SweepDesign::unit(std::size_t run, std::size_t axis) const { return points_->at(run, axis); }

std::size_t SweepDesign::run_at(std::size_t position) const {
  if (points_) return order_.empty() ? position : order_[position];
  // Inner axes last, that is fastest: take the position apart in that order, and sum up with the strides of the run.
  std::size_t run = 0;
  for (const bool inner : {true, false}) {
    std::size_t stride = 1;
    for (std::size_t axis = axes_.size(); axis-- > 0;) {
      const std::size_t levels = axes_[axis].levels;
      if (axes_[axis].inner == inner) {
        run += position % levels * stride;
        position /= levels;
      }
      stride *= levels;
    }
  }
  return run;
}

std::uint64_t SweepDesign::group(std::size_t run) const {
  if (points_ && !has_groups_) return run;
  std::uint64_t number = 0;
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    if (!axes_[axis].inner) number = number * axes_[axis].levels + level(run, axis);
  }
  return number;
}

}  // namespace bentur
