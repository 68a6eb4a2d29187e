#include "bentur/solve/engine/run/gap_monitor.h"

#include <limits>
#include <utility>

namespace bentur::engine {

using Eigen::Index;
using Eigen::VectorXd;

bool Gaps::look(const double* q, const double* q_end, const double* rise) {
  reach.setConstant(std::numeric_limits<double>::infinity());
  return closing.settled(q + begin, q_end + begin, rise + begin, reach.data(), reach.data());
}

std::vector<Gaps> gaps_between(const std::vector<ModalSystem::Point>& points) {
  std::vector<Gaps> all;
  for (Index first = 0, end = 0; first < std::ssize(points); first = end) {
    const auto& of = points[first];
    while (end < std::ssize(points) && points[end].left_begin == of.left_begin) ++end;
    Eigen::MatrixXd closing(end - first, of.left_size + of.right_size);
    for (Index i = first; i < end; ++i) {
      const auto& point = points[i];
      closing.row(i - first) << -point.sense_left.transpose(), -point.sense_right.transpose();
    }
    BoundedOutputs rows(closing, closing.cols(), kernels::Peaks::of_values);
    const VectorXd reach = VectorXd::Zero(rows.size());
    all.push_back({first, end - first, of.left_begin, std::move(rows), reach});
  }
  return all;
}

GapMonitor::GapMonitor(const ModalSystem& system, std::vector<double> widths)
    : widths_(std::move(widths)),
      gaps_(gaps_between(system.points)),
      stride_(system.size),
      open_(system.points.size(), 0) {
  for (Gaps& gaps : gaps_) {
    VectorXd limits = VectorXd::Zero(gaps.closing.size());
    for (Index n = 0; n < gaps.count; ++n) limits(n) = widths_[gaps.first + n];
    gaps.closing.limit(limits);
  }
}

Index GapMonitor::stay_open(const StepBuffer& buffer, Index count) {
  const Index first = buffer.size();
  if (count == 1) return look(buffer.q(first), buffer.q(first + 1), buffer.rise(first)) ? 1 : 0;
  for (Gaps& gaps : gaps_) {
    gaps.closing.compare(count, buffer.q(first) + gaps.begin, buffer.rise(first) + gaps.begin, stride_);
  }
  for (Index n = 0; n < count; ++n) {
    bool open = true;
    for (const Gaps& gaps : gaps_) open = open && gaps.closing.share(n) < 1.0;
    if (!open && !look(buffer.q(first + n), buffer.q(first + n + 1), buffer.rise(first + n))) return n;
  }
  return count;
}

bool GapMonitor::look(const double* q, const double* q_end, const double* rise) {
  bool all_open = true;
  for (Gaps& gaps : gaps_) {
    (void)gaps.look(q, q_end, rise);
    for (Index n = 0; n < gaps.count; ++n) {
      const bool open = gaps.reach(n) < widths_[gaps.first + n];
      open_[gaps.first + n] = open ? 1 : 0;
      all_open = all_open && open;
    }
  }
  return all_open;
}

}  // namespace bentur::engine
