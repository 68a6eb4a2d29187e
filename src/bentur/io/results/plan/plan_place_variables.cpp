// Where planes, gaps, contact points and links of a problem are.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "bentur/io/results/internal/variable_pass.h"
#include "bentur/io/results/plan/plan_variables.h"
#include "bentur/model/plan/plan_places.h"

namespace bentur {

using Eigen::Index;

ResultDimension point_dimension(std::size_t size, bool stand_still) {
  return {"point", size, std::string(stand_still ? "point_elevation point_x point_y " : "") + "point_left point_right"};
}

ResultDimension link_dimension(std::size_t size, bool stand_still) {
  return {"link", size,
          std::string(stand_still ? "link_elevation link_x link_y " : "") + "link_left link_right link_along"};
}

ResultDimension plane_dimension(std::size_t building, std::size_t planes) {
  return {fmt::format("plane_{}", building + 1), planes, fmt::format("plane_name_{}", building + 1)};
}

ResultVariable plane_names(const ResultDimension& planes, const PlanBuilding& building) {
  std::vector<std::string> names;
  for (const PlanModel::Plane& plane : building.model.planes) names.push_back(plane.name);
  return {planes.coordinates, {planes}, "", fmt::format("names of the planes of building \"{}\"", building.name), {},
          std::move(names)};
}

ResultVariable plane_angles(const ResultDimension& planes, const PlanBuilding& building, std::size_t number) {
  std::vector<double> angles;
  for (const PlanModel::Plane& plane : building.model.planes) {
    const PlanPoint along = plane.direction();
    angles.push_back(std::atan2(along.y(), along.x()) * 180 / std::numbers::pi);
  }
  return {fmt::format("plane_angle_{}", number + 1),
          {planes},
          "degree",
          fmt::format("angle with x, counter-clockwise, of the planes of building \"{}\"", building.name),
          {},
          std::move(angles)};
}

ResultDimension bearing_dimension(std::size_t building, std::size_t bearings, bool stand_still) {
  return {fmt::format("bearing_{}", building + 1), bearings,
          stand_still ? fmt::format("bearing_x_{0} bearing_y_{0}", building + 1) : ""};
}

std::vector<ResultVariable> bearing_places(const ResultDimension& bearings, const PlanBuilding& building,
                                           std::size_t number, const std::string& length) {
  std::vector<ResultVariable> places;
  for (const Index i : {0, 1}) {
    std::vector<double> values;
    for (const PlanModel::Bearing& one : building.model.bearings) {
      values.push_back(building.model.footprint.corner(i) + one.at(i));
    }
    const char axis = i == 0 ? 'x' : 'y';
    places.push_back({fmt::format("bearing_{}_{}", axis, number + 1),
                      {bearings},
                      length,
                      fmt::format("{} of the bearings of building \"{}\"", axis, building.name),
                      {},
                      std::move(values)});
  }
  return places;
}

namespace {

/// Which buildings the links join, along which coordinate, and where. @param length empty: they have no place
void tell_links(const PlanProblem& problem, const ResultDimension& links, const std::string& length, Teller& teller) {
  std::vector<std::string> left, right, along;
  std::vector<double> elevation, x, y;
  for (const PlanLink& link : problem.links) {
    left.push_back(problem.buildings[link.link.left].name);
    right.push_back(problem.buildings[link.link.right].name);
    along.push_back(link_along(link));
    elevation.push_back(link.link.elevation);
    const PlanPoint at = link.stretch.middle(link.along);
    x.push_back(at.x());
    y.push_back(at.y());
  }
  teller.tell({"link_left", {links}, "", "building to the left of the links, or below", {}, left});
  teller.tell({"link_right", {links}, "", "building to the right of the links, or above", {}, right});
  teller.tell({"link_along", {links}, "", "direction along which the links act", {}, along});
  if (length.empty()) return;
  teller.tell({"link_elevation", {links}, length, "elevation of the links", {}, elevation});
  teller.tell({"link_x", {links}, length, "x of the links, in the middle of the gap", {}, x});
  teller.tell({"link_y", {links}, length, "y of the links, in the middle of the gap", {}, y});
}

}  // namespace

PlaceVariables plan_place_variables(const PlanProblem& problem, const std::string& length,
                                    const std::string& link_length) {
  std::vector<std::string> names, left, right;
  std::vector<double> elevation, x, y;
  for (const PlanGap& gap : problem.gaps) names.push_back(gap_name(problem, gap));
  for (Index i = 0; i < contact_count(problem); ++i) {
    const PlanContactPlace place = contact_at(problem, i);
    const PlanGap& gap = problem.gaps[place.gap];
    left.push_back(problem.buildings[gap.left].name);
    right.push_back(problem.buildings[gap.right].name);
    elevation.push_back(place.contact->elevation);
    x.push_back(place.at.x());
    y.push_back(place.at.y());
  }
  PlaceVariables places;
  places.gaps = {"gap", names.size(), "gap_name"};
  places.points = point_dimension(left.size(), !length.empty());
  Teller teller;
  const auto tell = [&](const char* name, const ResultDimension& along, const char* what, ResultValues values,
                        const std::string& units = "") {
    teller.tell({name, {along}, units, what, {}, std::move(values)});
  };
  tell("gap_name", places.gaps, "buildings on both sides of the gaps", names);
  tell("point_left", places.points, "building to the left of the contact points, or below", left);
  tell("point_right", places.points, "building to the right of the contact points, or above", right);
  if (!length.empty()) {
    tell("point_elevation", places.points, "elevation of the contact points", elevation, length);
    tell("point_x", places.points, "x of the contact points, in the middle of the gap", x, length);
    tell("point_y", places.points, "y of the contact points, in the middle of the gap", y, length);
  }
  places.links = link_dimension(problem.links.size(), !link_length.empty());
  if (!problem.links.empty()) tell_links(problem, places.links, link_length, teller);
  places.variables = std::move(teller.variables);
  return places;
}

}  // namespace bentur
