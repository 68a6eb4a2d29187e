#include "bentur/report/kinds/internal/largest_forces.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace bentur {

void LargestForce::take(const Carried& carried, const FrameForces& frame, const FrameForces::Forces& forces,
                        Among among) {
  for (Eigen::Index n = 0; n < std::ssize(frame.members); ++n) {
    if (!among.has(frame.members[n])) continue;
    const std::vector<double> values = carried.of(forces, n);
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (!(std::abs(values[k]) > std::abs(value) * (1 + 1e-9))) continue;  // of those that are alike the first
      value = values[k];
      member = n;
      station = k;
    }
  }
}

std::vector<LargestForce> alike_to(const LargestForce& largest, const Carried& carried, const FrameForces& frame,
                                   const std::vector<const FrameForces::Forces*>& drawn, Among among) {
  std::vector<LargestForce> found;
  for (const FrameForces::Forces* const forces : drawn) {
    for (Eigen::Index n = 0; n < std::ssize(frame.members); ++n) {
      if (!among.has(frame.members[n])) continue;
      const std::vector<double> values = carried.of(*forces, n);
      for (std::size_t k = 0; k < (carried.is_moment ? values.size() : 1); ++k) {
        const bool is_alike = std::abs(values[k]) > std::abs(largest.value) * (1 - 1e-6);
        if (is_alike) found.push_back({values[k], n, k});
      }
    }
  }
  return found;
}

namespace {

/// Whether a contact point is struck at an instant, or at any.
bool is_struck(const RunResults& run, Eigen::Index point, std::optional<double> time) {
  const std::vector<Impact>& impacts = run.response.impacts;
  return time ? std::any_of(impacts.begin(), impacts.end(),
                            [&](const Impact& one) { return one.point == point && lasts_at(one, *time); })
              : run.response.points[point].impacts > 0;
}

/// Whether it is of a column that a floor strikes, at the blow: the moment there, or the shear of a piece that ends
/// there.
/// @param time of the instant at which it is struck; nothing: at any
bool is_at_blow(const RunResults& run, const Carried& carried, const FrameForces& frame, const LargestForce& force,
                std::optional<double> time) {
  const FrameMember& member = frame.members[force.member];
  if (member.of_beam || carried.is_axial) return false;
  Eigen::Index lines = 0;
  for (const FrameMember& one : frame.members) lines = one.of_beam ? lines : std::max(lines, one.number);
  const double base = base_of(run.problem.buildings[frame.building]);
  for (Eigen::Index i = 0; i < std::ssize(run.problem.points); ++i) {
    const ContactPoint& point = run.problem.points[i];
    const std::optional<StruckColumn> struck = struck_column(run.problem, point);
    if (!struck || struck->building != frame.building || !is_struck(run, i, time)) continue;
    if (member.number != (point.left == frame.building ? lines : 1)) continue;
    const double height = point.elevation - base, near = 1e-6 * member.length();
    const auto is_there = [&](double at) { return std::abs(at - height) < near; };
    const double station = carried.stations()[force.station];
    if (carried.is_moment ? is_there(member.from + station * member.length())
                          : is_there(member.from) || is_there(member.to)) {
      return true;
    }
  }
  return false;
}

}  // namespace

LargestForce largest_at_blow(const RunResults& run, const Carried& carried, const FrameForces& frame,
                             const std::vector<const FrameForces::Forces*>& drawn, std::optional<double> time) {
  LargestForce largest;
  for (const FrameForces::Forces* const forces : drawn) {
    for (Eigen::Index n = 0; n < std::ssize(frame.members); ++n) {
      const std::vector<double> values = carried.of(*forces, n);
      for (std::size_t k = 0; k < values.size(); ++k) {
        const LargestForce one{values[k], n, k};
        if (std::abs(one.value) > std::abs(largest.value) && is_at_blow(run, carried, frame, one, time)) largest = one;
      }
    }
  }
  return largest;
}

}  // namespace bentur
