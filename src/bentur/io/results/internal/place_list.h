#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "bentur/io/results/internal/variable_pass.h"
#include "bentur/solve/problem.h"

namespace bentur {

/// Where gaps, contact points and links are. Without a unit of length they have no elevations.
template <class File, class Problem>
class PlaceList : protected VariablePass<File> {
 public:
  PlaceList(File& file, Problem& problem) : VariablePass<File>(file), problem_(problem) {}

  void places(const std::string& point_length, const std::string& link_length) {
    const std::vector<Building>& buildings = problem_.buildings;
    gaps = this->file_.dimension({"gap", std::max<std::size_t>(buildings.size(), 1) - 1, "gap_name"});
    points = this->file_.dimension(
        {"point", problem_.points.size(), (point_length.empty() ? "" : "point_elevation ") + of_points});
    links = this->file_.dimension(
        {"link", problem_.links.size(), (link_length.empty() ? "" : "link_elevation ") + of_links});
    this->fit(problem_.points, points.size);
    this->fit(problem_.links, links.size);
    std::vector<std::string> names;
    for (Eigen::Index gap = 0; gap < static_cast<Eigen::Index>(gaps.size); ++gap) {
      names.push_back(gap_name(problem_, gap));
    }
    this->made({"gap_name", {gaps}, "", "buildings on both sides of the gaps"}, names);
    this->named({"point_left", {points}, "", "building to the left of the contact points"}, problem_.points,
                &ContactPoint::left, buildings);
    this->named({"point_right", {points}, "", "building to the right of the contact points"}, problem_.points,
                &ContactPoint::left, buildings, 1);
    if (!point_length.empty()) {
      this->each({"point_elevation", {points}, point_length, "elevation of the contact points"}, problem_.points,
                 &ContactPoint::elevation);
    }
    this->named({"link_left", {links}, "", "left building of the links"}, problem_.links, &Link::left, buildings);
    this->named({"link_right", {links}, "", "right building of the links"}, problem_.links, &Link::right, buildings);
    if (!link_length.empty()) {
      this->each({"link_elevation", {links}, link_length, "elevation of the links"}, problem_.links, &Link::elevation);
    }
  }

  const std::string of_points = "point_left point_right", of_links = "link_left link_right";
  ResultDimension gaps, points, links;

 protected:
  Problem& problem_;
};

}  // namespace bentur
