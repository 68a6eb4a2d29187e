#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bentur/core/not_known.h"
#include "bentur/io/results/internal/curve_names.h"
#include "bentur/io/results/internal/variable_pass.h"
#include "bentur/pounding/problem.h"

namespace bentur {

/// Where gaps, contact points and links are (without a unit of length they have no elevations), and where frames become
/// mechanisms.
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
                &ContactPoint::right, buildings);
    if constexpr (File::reads) {
      for (ContactPoint& point : problem_.points) point.gap = point.left;
    }
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
  /// When hinges first let storeys of a building sway without bending, and which.
  template <class Mechanism>
  void mechanism(Eigen::Index floors, Mechanism& mechanism, const std::string& number, const std::string& owner) {
    std::vector<double> time = {mechanism ? mechanism->time : not_known};
    std::vector<int> sways(static_cast<std::size_t>(floors), 0);
    if constexpr (!File::reads) {
      if (mechanism) {
        for (const Eigen::Index storey : mechanism->storeys) sways[storey] = 1;
      }
    }
    this->made({"mechanism_time" + number, {}, "s", "when hinges first let storeys sway without bending, of " + owner},
               time);
    const ResultDimension storeys{"elevation" + number, sways.size()};
    this->made({"mechanism_storey" + number, {storeys}, "", "1 for each storey that did so then, of " + owner}, sways);
    if constexpr (File::reads) {
      if (std::isnan(time.at(0))) return;
      mechanism = typename Mechanism::value_type{.time = time[0], .storeys = {}};
      for (Eigen::Index j = 0; j < floors; ++j) {
        if (sways.at(j) != 0) mechanism->storeys.push_back(j);
      }
    }
  }

  /// Which ends of members are hinges.
  template <class Hinges>
  void hinge_places(const ResultDimension& hinges, Hinges& places, const std::string& number, const std::string& of) {
    std::vector<std::string> members, ends;
    std::vector<int> levels, numbers;
    for (const HingePlace& place : places) {
      members.emplace_back(place.of_beam ? "beam" : "column");
      levels.push_back(static_cast<int>(place.level));
      numbers.push_back(static_cast<int>(place.number));
      ends.emplace_back(word_of(place.end));
    }
    this->made({"hinge_member" + number, {hinges}, "", "members" + of}, members);
    this->made({"hinge_level" + number, {hinges}, "", "storeys of columns, floors of beams" + of}, levels);
    this->made({"hinge_number" + number, {hinges}, "", "lines of columns, bays of beams" + of}, numbers);
    this->made({"hinge_end" + number, {hinges}, "", "ends of the members" + of}, ends);
    if constexpr (File::reads) {
      for (std::size_t h = 0; h < places.size(); ++h) {
        places[h] = {members[h] == "beam", levels[h], numbers[h], hinge_end(ends[h])};
      }
    }
  }

  /// Which columns of a building can break, along the dimension that is returned.
  template <class Columns>
  ResultDimension breaking_places(Columns& all, const std::string& number, const std::string& owner,
                                  const std::string& force) {
    const std::string name = "breaking_column", of = " of the columns that can break of " + owner;
    const ResultDimension columns = this->file_.dimension({name + number, all.size()});
    this->fit(all, columns.size);
    if (columns.size == 0) return columns;
    std::vector<int> storeys, lines, pieces;
    std::vector<double> capacities;
    for (const BreakingColumn& column : all) {
      storeys.push_back(static_cast<int>(column.storey));
      lines.push_back(static_cast<int>(column.line));
      pieces.push_back(static_cast<int>(column.piece));
      capacities.push_back(column.capacity);
    }
    this->made({name + "_storey" + number, {columns}, "", "storeys" + of}, storeys);
    this->made({name + "_line" + number, {columns}, "", "column lines" + of}, lines);
    this->made({name + "_piece" + number, {columns}, "", "pieces of struck columns from below, 0: whole," + of},
               pieces);
    this->made({name + "_capacity" + number, {columns}, force, "shear capacities" + of}, capacities);
    if constexpr (File::reads) {
      for (std::size_t n = 0; n < all.size(); ++n) all[n] = {storeys[n], lines[n], pieces[n], capacities[n]};
    }
    return columns;
  }

  /// Panels of infill, which `all` is fitted to.
  template <class Panels>
  ResultDimension infill_places(Panels& all, const std::string& number, const std::string& owner) {
    const std::string of = " of the panels of infill of " + owner;
    const ResultDimension panels = this->file_.dimension({"infill_panel" + number, all.size()});
    this->fit(all, panels.size);
    if (panels.size == 0) return panels;
    std::vector<int> storeys, bays;
    for (const InfillPanel& panel : all) {
      storeys.push_back(static_cast<int>(panel.storey) + 1);
      bays.push_back(static_cast<int>(panel.bay) + 1);
    }
    this->made({"infill_panel_storey" + number, {panels}, "", "storeys" + of}, storeys);
    this->made({"infill_panel_bay" + number, {panels}, "", "bays" + of}, bays);
    if constexpr (File::reads) {
      for (std::size_t n = 0; n < all.size(); ++n) {
        all[n].storey = storeys[n] - 1;
        all[n].bay = bays[n] - 1;
      }
    }
    return panels;
  }
  /// What struts did, sample by sample: panels × samples.
  template <class Samples>
  void infill_histories(const ResultDimension& panels, const ResultDimension& time, const std::string& force,
                        const std::string& length, const std::string& number, const std::string& owner, Samples& forces,
                        Samples& shortenings) {
    if (time.size == 0) return;
    const std::string signs = ", < 0 where the storey drifts to the left, of the panels of infill of " + owner;
    this->pass({"infill_panel_force" + number, {time, panels}, force, "force of the strut at work" + signs}, forces);
    this->pass({"infill_panel_shortening" + number, {time, panels}, length, "shortening of its diagonal" + signs},
               shortenings);
  }

  /// At which points impacts were; of as many as the file has. @param points how many there are
  template <class Impacts>
  ResultDimension impact_points(Impacts& all, std::size_t points) {
    const ResultDimension impact = this->file_.dimension({"impact", all.size()});
    this->fit(all, impact.size);
    std::vector<int> at;
    for (const Impact& one : all) at.push_back(static_cast<int>(one.point));
    this->made({"impact_point", {impact}, "", "number of the contact point of each impact, counted from 0"}, at);
    if constexpr (File::reads) {
      for (std::size_t i = 0; i < all.size(); ++i) {
        if (at[i] < 0 || at[i] >= static_cast<Eigen::Index>(points)) {
          this->file_.source.fail("an impact is at no point of it");
        }
        all[i].point = at[i];
      }
    }
    return impact;
  }
  /// Where the energy was. @param moment its unit @param time of the histories [s]
  template <class Energy>
  void energy(Energy& energy, const ResultDimension& along, const std::string& moment,
              const std::vector<double>& time) {
    if (!this->file_.has("energy_input", energy.has_value())) return;
    if constexpr (File::reads) energy.emplace().histories.time = time;
    for (const auto& [name, values, what] : energy_curves) {
      ResultVariable variable{std::string("energy_") + name, {along}, moment, what};
      auto& curve = energy->histories.*values;
      if (File::reads || curve.size() > 0) {
        this->pass(std::move(variable), curve);
      } else {  // nothing can yield
        std::vector<double> zeros(along.size);
        this->made(std::move(variable), zeros);
      }
    }
  }
  /// `group`: that of the exact course.
  template <class Samples>
  void openings(const std::string& group, const ResultDimension& time, const ResultDimension& points,
                const std::string& length, const std::string& force, Samples& samples) {
    if (time.size == 0) return;
    this->pass({group + "opening", {time, points}, length, "opening of the contact points, negative in contact"},
               samples.opening);
    this->pass({group + "force", {time, points}, force, "contact force"}, samples.force);
  }
  /// Instants of the exact course, in a group of its own, as they have no even steps.
  template <class Samples>
  ResultDimension course_time(Samples& course) {
    const ResultDimension time = this->file_.dimension({"exact/time", course.time.size()});
    if (time.size == 0) return time;
    this->pass(
        {"exact/time", {time}, "s", "instants joined by straight lines; two where a force jumps", {{"axis", "T"}}},
        course.time);
    return time;
  }

  Problem& problem_;
};

}  // namespace bentur
