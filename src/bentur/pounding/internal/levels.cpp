#include "bentur/pounding/internal/levels.h"

#include <algorithm>
#include <optional>

namespace bentur {
namespace {

using Eigen::Index;

Interface times(Interface interface, double factor) {
  for (BodyRow* side : {&interface.left, &interface.right}) {
    side->row *= factor;
    side->ground *= factor;
  }
  return interface;
}

/// Adds the sways of faces that are no floors, relative to the own base, there and back; `floor_of`: the floor that a
/// side is.
void add_sways(const Interface& both, const auto& floor_of, std::vector<Interface>& interfaces) {
  for (const int side : {0, 1}) {
    if (floor_of(side)) continue;
    const BodyRow& face = side == 0 ? both.left : both.right;
    for (const double sign : {1.0, -1.0}) interfaces.push_back({{face.body, sign * face.row}});
  }
}

}  // namespace

std::vector<Interface> level_interfaces(const Problem& problem, const System& system) {
  std::vector<Interface> interfaces;
  for (const Contact& contact : system.contacts) interfaces.push_back(times(contact.at, -1.0));
  for (const Interface& both : system.watched) interfaces.push_back(times(both, -1.0));
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const auto floor_of = [&](int side) { return face_floor(problem, problem.points[i], side); };
    add_sways(system.contacts[i].at, floor_of, interfaces);
  }
  for (std::size_t i = 0; i < problem.watched.size(); ++i) {
    const auto floor_of = [&](int side) { return face_floor(problem.watched[i], side); };
    add_sways(system.watched[i], floor_of, interfaces);
  }
  return interfaces;
}

void report_levels(const Problem& problem, const std::vector<Reach>& reaches, bool reversed, Response& response) {
  auto at = reaches.begin();
  auto sway = at + std::ssize(problem.points) + std::ssize(problem.watched);
  const auto report = [&](Index left, const auto& floor_of, auto& summary) {
    if (reversed) summary.gap_needed_reversed = at->reach;
    ++at;
    for (const int side : {0, 1}) {
      double& peak = side == 0 ? summary.peak_left : summary.peak_right;
      if (const std::optional<Index> floor = floor_of(side)) {
        peak = response.buildings[left + side].displacement_no_contact(*floor);
      } else {
        peak = std::max(sway[0].reach, sway[1].reach);
        sway += 2;
      }
    }
  };
  for (Index i = 0; i < std::ssize(problem.points); ++i) {
    const ContactPoint& point = problem.points[i];
    report(
        point.left, [&](int side) { return face_floor(problem, point, side); }, response.points[i]);
  }
  for (Index i = 0; i < std::ssize(problem.watched); ++i) {
    const WatchedFloor& floor = problem.watched[i];
    report(
        floor.left, [&](int side) { return face_floor(floor, side); }, response.watched[i]);
  }
}

}  // namespace bentur
