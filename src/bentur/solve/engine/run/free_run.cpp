#include "bentur/solve/engine/run/free_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bentur::engine {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

}  // namespace

FreeRun::FreeRun(const Setup& setup) : Run(setup, setup.system.switched, {}, setup.system.watched_free) {
  for (const Reach& nearest : idle().nearest()) result_.reaches.push_back({{0, nearest.reach}});
  result_.speeds.resize(result_.reaches.size(), 0.0);
  for (const RelationGroup& group : idle().groups()) {
    const auto of = [&](Eigen::Index n) -> const ModalSystem::Relation& {
      return system_.elements[system_.opening(group.first + n)].relation;
    };
    Eigen::MatrixXd left(group.count, of(0).left_size);
    Eigen::MatrixXd right(group.count, of(0).right_size);
    for (Eigen::Index n = 0; n < group.count; ++n) {
      left.row(n) = of(n).left_row;
      right.row(n) = of(n).right_row;
    }
    const auto sizes = [](const Eigen::MatrixXd& rows) {
      return BoundedOutputs(rows, rows.cols(), kernels::Peaks::of_abs);
    };
    sides_.push_back({group.first, group.count, of(0).left_begin, of(0).right_begin, sizes(left), sizes(right)});
  }
}

/// How far a point reaches in a segment; a reach that is no number may be any.
void FreeRun::note(Eigen::Index i, long segment, double reach) {
  auto& reaches = result_.reaches[i];
  if (reach <= reaches.back().reach) return;
  if (std::isnan(reach)) reach = unbounded;
  if (reaches.back().segment == segment) reaches.pop_back();
  reaches.push_back({segment, reach});
}

/// At `count` ends of steps only, whose speeds follow one another: what it is for needs no more.
void FreeRun::note_speeds(const double* v, Eigen::Index count) {
  for (Sides& sides : sides_) {
    sides.left.take_ends(count - 1, v + sides.left_begin, system_.size);
    sides.right.take_ends(count - 1, v + sides.right_begin, system_.size);
    for (Eigen::Index n = 0; n < sides.count; ++n) {
      double& largest = result_.speeds[sides.first + n];
      for (Eigen::Index i = 0; i < count; ++i) {
        largest = std::max(largest, sides.left.end_value(n, i) + sides.right.end_value(n, i));
      }
    }
  }
}

/// Notes how far the points reach in all steps of a buffer that has been taken in.
void FreeRun::note_reaches(const RelationGroup& group, const StepBuffer& buffer) {
  for (Eigen::Index n = 0; n < group.count; ++n) {
    const double needed = group.rows.peak(n);
    const auto& reaches = result_.reaches[group.first + n];
    for (Eigen::Index step = 0; step < buffer.size(); ++step) {
      // What rises in between as a part of the gap needed. Where that is none, of this point or of another one of the
      // group, no part of it says anything.
      double beyond = group.rows.between(step) * needed;
      if (!std::isfinite(beyond)) beyond = group.rows.rise(n, buffer.rise(step) + group.begin);
      const double reach = group.rows.larger_value(n, step) + beyond;
      if (!(reach <= reaches.back().reach)) note(group.first + n, buffer.step(step).segment, reach);
    }
  }
}

void FreeRun::take_buffer(const StepBuffer& buffer) {
  Run::take_buffer(buffer);
  if (buffer.size() == 0) return;
  note_speeds(buffer.v(0), buffer.size() + 1);
  for (const RelationGroup& group : idle().groups()) note_reaches(group, buffer);
}

void FreeRun::approximated() {
  note_speeds(state_.v.data(), 1);
  note_speeds(next_.v.data(), 1);
  for (Eigen::Index i = 0; i < std::ssize(result_.reaches); ++i) note(i, segment(), idle().nearest()[i].reach);
}

FreeResult FreeRun::take_result() {
  for (const Reach& nearest : idle().nearest()) result_.needed.push_back(nearest.reach);
  return std::move(result_);
}

long first_contact(const FreeResult& free, const std::vector<double>& widths) {
  long first = std::numeric_limits<long>::max();
  for (std::size_t i = 0; i < widths.size(); ++i) {
    if (widths[i] > free.needed[i]) continue;
    const auto& reaches = free.reaches[i];
    const auto found = std::lower_bound(reaches.begin(), reaches.end(), widths[i],
                                        [](const FreeResult::Before& at, double width) { return at.reach < width; });
    // What is needed, and no bound has reached: by round-off, and nobody knows when.
    first = std::min(first, found != reaches.end() ? found->segment : 0);
  }
  return first;
}

}  // namespace bentur::engine
