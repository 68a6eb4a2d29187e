#include "bentur/solve/engine/run/watch/guard_monitor.h"

#include <algorithm>
#include <limits>

namespace bentur::engine {

using Eigen::Index;

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

}  // namespace

GuardMonitor::Sides GuardMonitor::sides_of(const Branch& branch) {
  Sides sides = Sides::none;
  for (std::size_t g = 0; g < branch.guard_count; ++g) {
    const Guard& guard = branch.guards[g];
    if (guard.speed != 0.0 || guard.decaying != 0.0 || guard.deformation == 0.0) return Sides::none;
    const Sides side = guard.deformation < 0.0 ? Sides::upper : Sides::lower;
    sides = sides == Sides::none || sides == side ? side : Sides::both;
  }
  return sides;
}

GuardMonitor::GuardMonitor(const std::vector<Watched>& elements, Index stride)
    : limits_(elements.size(), unlimited), stays_(elements.size(), 0), stride_(stride) {
  std::vector<Bounded> rows;
  for (const Watched& element : elements) {
    const Sides sides = element.span > 0.0 ? Sides::both : sides_of(element.first);
    sides_.push_back(sides);
    offsets_.push_back(element.offset);
    spans_.push_back(element.span);
    rows.push_back({element.relation, sides == Sides::lower ? -1.0 : 1.0,
                    sides == Sides::both ? kernels::Peaks::of_abs : kernels::Peaks::of_values, element.switched});
  }
  groups_ = relation_groups(rows);
  changed_.assign(groups_.size(), 1);
  for (Index i = 0; i < std::ssize(elements); ++i) (void)enter(i, elements[i].first);
}

RelationGroup& GuardMonitor::group_of(Index element) {
  const auto after = std::upper_bound(groups_.begin(), groups_.end(), element,
                                      [](Index i, const RelationGroup& group) { return i < group.first; });
  return *std::prev(after);
}

std::pair<std::size_t, std::size_t> GuardMonitor::groups_of(Index first, Index end) const {
  const auto from = [this](Index element) {
    const auto found = std::lower_bound(groups_.begin(), groups_.end(), element,
                                        [](const RelationGroup& group, Index i) { return group.first < i; });
    return static_cast<std::size_t>(found - groups_.begin());
  };
  return {from(first), from(end)};
}

bool GuardMonitor::enter(Index i, const Branch& branch) {
  const Sides sides = sides_of(branch);
  const bool endless = branch.guard_count == 0;
  const bool watched = endless || (sides != Sides::none && (sides == sides_[i] || spans_[i] > 0.0));
  double limit = endless ? std::numeric_limits<double>::max() : unlimited;
  double offset = 0.0;
  if (watched && !endless) {
    // The guards say low ≤ δ ≤ high.
    double low = -unlimited;
    double high = unlimited;
    for (std::size_t g = 0; g < branch.guard_count; ++g) {
      const Guard& guard = branch.guards[g];
      const double at = -guard.constant / guard.deformation;
      if (guard.deformation < 0.0) high = std::min(high, at);
      if (guard.deformation > 0.0) low = std::max(low, at);
    }
    if (spans_[i] > 0.0 && sides == Sides::upper) low = high - spans_[i];
    if (spans_[i] > 0.0 && sides == Sides::lower) high = low + spans_[i];
    if (sides_[i] == Sides::both) {
      const double centre = 0.5 * (low + high);
      limit = 0.5 * (high - low);
      offset = offsets_[i] - centre;
    } else {
      limit = sides == Sides::upper ? high - offsets_[i] : offsets_[i] - low;
    }
  }
  RelationGroup& group = group_of(i);
  group.rows.offset(i - group.first) = offset;
  changed_[&group - groups_.data()] = changed_[&group - groups_.data()] != 0 || limit != limits_[i] ? 1 : 0;
  limits_[i] = limit;
  stays_[i] = 0;
  return watched;
}

void GuardMonitor::limit(std::size_t g) {
  if (changed_[g] == 0) return;
  changed_[g] = 0;
  RelationGroup& group = groups_[g];
  group_limits_.setZero(group.rows.size());
  // Shares of a limit say nothing where that is not above zero; infinite parts of zero leave it to look().
  for (Index n = 0; n < group.count; ++n)
    group_limits_(n) = limits_[group.first + n] > 0.0 ? limits_[group.first + n] : 0.0;
  group.rows.limit(group_limits_);
}

Index GuardMonitor::quiet(const StepBuffer& buffer, Index count, Index from, Index end) {
  const Index first = buffer.size();
  if (count == 1) return look(buffer.q(first), buffer.q(first + 1), buffer.rise(first), from, end) ? 1 : 0;
  const auto [asked, after] = groups_of(from, end);
  for (std::size_t g = asked; g < after; ++g) {
    RelationGroup& group = groups_[g];
    limit(g);
    group.rows.compare(count, buffer.q(first) + group.begin, buffer.rise(first) + group.begin, stride_);
  }
  for (Index n = 0; n < count; ++n) {
    bool quiet = true;
    for (std::size_t g = asked; g < after; ++g) quiet = quiet && groups_[g].rows.share(n) < 1.0;
    if (!quiet && !look(buffer.q(first + n), buffer.q(first + n + 1), buffer.rise(first + n), from, end)) return n;
  }
  return count;
}

bool GuardMonitor::look(const double* q, const double* q_end, const double* rise, Index from, Index end) {
  bool all = true;
  const auto [asked, after] = groups_of(from, end);
  for (std::size_t g = asked; g < after; ++g) {
    RelationGroup& group = groups_[g];
    (void)group.look(q, q_end, rise);
    for (Index n = 0; n < group.count; ++n) {
      const Index i = group.first + n;
      const bool stays = limits_[i] < unlimited && group.reach(n) < limits_[i];
      stays_[i] = stays ? 1 : 0;
      all = all && stays;
    }
  }
  return all;
}

}  // namespace bentur::engine
