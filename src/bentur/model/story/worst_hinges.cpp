#include "bentur/model/story/worst_hinges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace bentur {

std::vector<Eigen::Index> worst_hinges(const BuildingPeaks& peaks) {
  constexpr double alike = 1e-9;  // of the larger
  std::vector<Eigen::Index> hinges;
  for (Eigen::Index h = 0; h < std::ssize(peaks.hinges); ++h) {
    if (peaks.hinges[h].first_yield) hinges.push_back(h);
  }
  const auto turned = [&](Eigen::Index h) { return peaks.hinges[h].peak_rotation; };
  std::stable_sort(hinges.begin(), hinges.end(), [&](Eigen::Index a, Eigen::Index b) { return turned(a) > turned(b); });
  for (auto first = hinges.begin(); first != hinges.end();) {
    const double largest = turned(*first);
    const auto end =
        std::find_if(first, hinges.end(), [&](Eigen::Index h) { return turned(h) < largest * (1 - alike); });
    std::sort(first, end);
    first = end;
  }
  return hinges;
}

namespace {

/// Floor (0: the base) and line of the joint that a member's end is at; nothing of a struck column's node.
std::optional<std::pair<Eigen::Index, Eigen::Index>> joint_of(const HingePlace& place) {
  switch (place.end) {
    case HingePlace::End::bottom:
      return std::pair(place.level - 1, place.number);
    case HingePlace::End::top:
    case HingePlace::End::left:
      return std::pair(place.level, place.number);
    case HingePlace::End::right:
      return std::pair(place.level, place.number + 1);
    case HingePlace::End::node:
      break;
  }
  return std::nullopt;
}

/// Whether moments at the ends of a joint, each at its capacity of either sense, can add up to nothing.
bool balances(const Hinges& hinges, const std::vector<Eigen::Index>& ends, std::size_t from, double sum, double size) {
  constexpr double round_off = 1e-9;
  if (from == ends.size()) return std::abs(sum) <= round_off * size;
  const double up = hinges.clockwise(ends[from]), down = hinges.anticlockwise(ends[from]);
  return (std::isfinite(up) && balances(hinges, ends, from + 1, sum + up, size + up)) ||
         (std::isfinite(down) && balances(hinges, ends, from + 1, sum - down, size + down));
}

}  // namespace

std::vector<std::vector<Eigen::Index>> indeterminate_joints(const Hinges& hinges, const BuildingPeaks& peaks) {
  constexpr double round_off = 1e-9;
  std::map<std::pair<Eigen::Index, Eigen::Index>, std::vector<Eigen::Index>> joints;
  for (Eigen::Index h = 0; h < std::ssize(peaks.hinges) && h < hinges.size(); ++h) {
    if (const auto joint = joint_of(hinges.places[h])) joints[*joint].push_back(h);
  }
  std::vector<std::vector<Eigen::Index>> found;
  for (const auto& [joint, ends] : joints) {
    Eigen::VectorXd moments = Eigen::VectorXd::Zero(hinges.size());
    double size = 0;
    bool flows = ends.size() > 1;
    for (const Eigen::Index h : ends) {
      moments += hinges.stiffness.col(h);
      size = std::max(size, hinges.stiffness(h, h));
      // One that has come to its capacity may rest while the others of the joint turn for it.
      const double capacity = std::min(hinges.clockwise(h), hinges.anticlockwise(h));
      const bool yields = peaks.hinges[h].first_yield || peaks.hinges[h].peak_moment >= (1 - round_off) * capacity;
      flows = flows && yields && hinges.hardening(h) == 0.0;
    }
    // Where nothing else holds the joint it turns back as all its ends turn.
    if (!flows || moments.cwiseAbs().maxCoeff() > round_off * size) continue;
    if (balances(hinges, ends, 0, 0, 0)) found.push_back(ends);
  }
  return found;
}

}  // namespace bentur
