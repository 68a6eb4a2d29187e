#include "bentur/solve/engine/run/free_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bentur::engine {
namespace {

using Eigen::Index;

constexpr Index four = 4;  // rows that stand side by side
constexpr double unbounded = std::numeric_limits<double>::infinity();

}  // namespace

Index FreeRun::Side::place(const Eigen::Ref<const Eigen::MatrixXd>& of) {
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(four, rows.cols());
  whole.topRows(of.rows()) = of;
  for (Index at = 0; at < rows.rows(); at += four) {
    const auto same = [&](Index n) { return rows.row(at + n) == whole.row(n) || rows.row(at + n) == -whole.row(n); };
    if (same(0) && same(1) && same(2) && same(3)) return at;
  }
  rows.conservativeResize(rows.rows() + four, Eigen::NoChange);
  rows.bottomRows(four) = whole;
  return rows.rows() - four;
}

FreeRun::FreeRun(const Setup& setup) : Run(setup, setup.system.switched, {}, setup.system.watched_free) {
  for (const Reach& nearest : idle().nearest()) result_.reaches.push_back({{0, nearest.reach}});
  result_.speeds.resize(result_.reaches.size(), 0.0);
  for (const ModalSystem::Block& block : system_.blocks) sides_.emplace_back(block);
  for (const RelationGroup& group : idle().groups()) {
    for (Index first = 0; first < group.count; first += four)
      add_meeting(group.first + first, std::min(four, group.count - first));
  }
  for (Side& side : sides_) {
    if (side.rows.rows() > 0) side.sizes.emplace(side.rows, side.rows.cols(), kernels::Peaks::of_abs);
  }
  no_side_.setZero(four * (StepBuffer::most + 1));
}

/// Of points between the same bodies.
void FreeRun::add_meeting(Index first, Index count) {
  const auto of = [&](Index n) -> const ModalSystem::Relation& {
    return system_.elements[system_.opening(first + n)].relation;
  };
  const bool alone = of(0).right_size == 0;
  Meeting meeting{.first = first, .count = count, .left = of(0).left, .right = alone ? -1 : of(0).right};
  Eigen::MatrixXd left(count, of(0).left_size);
  Eigen::MatrixXd right(count, of(0).right_size);
  for (Index n = 0; n < count; ++n) {
    left.row(n) = of(n).left_row;
    right.row(n) = of(n).right_row;
  }
  meeting.left_at = sides_[meeting.left].place(left);
  if (!alone) meeting.right_at = sides_[meeting.right].place(right);
  meetings_.push_back(meeting);
}

/// How far a point reaches in a segment; a reach that is no number may be any.
void FreeRun::note(Index i, long segment, double reach) {
  auto& reaches = result_.reaches[i];
  if (reach <= reaches.back().reach) return;
  if (std::isnan(reach)) reach = unbounded;
  if (reaches.back().segment == segment) reaches.pop_back();
  reaches.push_back({segment, reach});
}

/// At `count` ends of steps only, whose speeds follow one another: what it is for needs no more.
void FreeRun::note_speeds(const double* v, Index count) {
  for (Side& side : sides_) {
    if (side.sizes) side.sizes->take_ends(count - 1, v + side.begin, system_.size);
  }
  for (Meeting& meeting : meetings_) {
    const double* right = meeting.right < 0 ? no_side_.data() : sides_[meeting.right].sizes->values(meeting.right_at);
    kernels::raise_sums(count, sides_[meeting.left].sizes->values(meeting.left_at), right, meeting.speeds.data());
  }
}

/// Notes how far the points reach in all steps of a buffer that has been taken in.
void FreeRun::note_reaches(const RelationGroup& group, const StepBuffer& buffer) {
  for (Index first = 0; first < group.count; first += four) {
    const Index end = std::min(first + four, group.count);
    Eigen::Vector4d known = Eigen::Vector4d::Zero();
    for (Index step = 0;; ++step) {
      for (Index n = first; n < end; ++n) known(n - first) = result_.reaches[group.first + n].back().reach;
      step = kernels::first_beyond(step, buffer.size(), group.rows.values(first), group.rows.betweens(),
                                   group.rows.peak.data() + first, known.data());
      if (step == buffer.size()) break;
      for (Index n = first; n < end; ++n) note_reach(group, n, buffer, step);
    }
  }
}

void FreeRun::note_reach(const RelationGroup& group, Index n, const StepBuffer& buffer, Index step) {
  // What rises in between as a part of the gap needed. Where that is none, of this point or of another one of the
  // group, no part of it says anything.
  double beyond = group.rows.between(step) * group.rows.peak(n);
  if (!std::isfinite(beyond)) beyond = group.rows.rise(n, buffer.rise(step) + group.begin);
  const double reach = group.rows.larger_value(n, step) + beyond;
  if (!(reach <= result_.reaches[group.first + n].back().reach)) {
    note(group.first + n, buffer.step(step).segment, reach);
  }
}

void FreeRun::take_buffer(const StepBuffer& buffer) {
  Run::take_buffer(buffer);
  if (buffer.size() == 0) return;
  note_speeds(buffer.v(0), buffer.size() + 1);
  for (std::size_t g = 0; g < idle().groups().size(); ++g) {
    if (!idle().moved_alike(g)) note_reaches(idle().groups()[g], buffer);
  }
}

void FreeRun::approximated() {
  note_speeds(state_.v.data(), 1);
  note_speeds(next_.v.data(), 1);
  for (Index i = 0; i < std::ssize(result_.reaches); ++i) note(i, segment(), idle().nearest()[i].reach);
}

FreeResult FreeRun::take_result() {
  for (const Meeting& meeting : meetings_) {
    for (Index n = 0; n < meeting.count; ++n) result_.speeds[meeting.first + n] = meeting.speeds(n);
  }
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
