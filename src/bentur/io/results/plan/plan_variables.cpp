#include "bentur/io/results/plan/plan_variables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bentur/core/not_known.h"
#include "bentur/io/results/internal/curve_names.h"
#include "bentur/io/results/internal/place_list.h"
#include "bentur/io/results/internal/plan_figures.h"
#include "bentur/io/results/internal/variable_pass.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

using Eigen::Index;

/// Goes through all variables of a run, one after the other: `File` is a Teller of a `Run` that is const, or a Giver to
/// one that is not, whose problem is known: of it the response alone is read.
template <class File, class Run>
class PlanVariables : private PlaceList<File, const PlanProblem> {
  using Pass = VariablePass<File>;
  using Pass::each, Pass::file_, Pass::fit, Pass::made, Pass::pass;
  static constexpr bool reads = File::reads;

 public:
  PlanVariables(File& file, Run& run)
      : PlaceList<File, const PlanProblem>(file, run.problem),
        run_(run),
        length_(udunit(run.c.units.length)),
        force_(udunit(run.c.units.force)),
        time_(file.dimension({"time", run.response.histories.time.size()})),
        points_(file.dimension(point_dimension(run.response.points.size(), true))) {}

  void all() {
    auto& histories = run_.response.histories;
    const auto& buildings = run_.problem.buildings;
    const ResultDimension building = file_.dimension({"building", buildings.size(), "building_name"});
    if constexpr (reads) {
      const auto points = static_cast<std::size_t>(contact_count(run_.problem));
      if (building.size != buildings.size() || points_.size != points) file_.source.fail("is not of this case");
      run_.response.buildings.resize(buildings.size());
      run_.response.buildings_no_contact.resize(buildings.size());
      run_.response.points.resize(points);
      run_.response.friction.resize(points);
    }
    pass({"time", {time_}, "s", "time", {{"axis", "T"}}}, histories.time);
    const ResultDimension component =
        file_.dimension({"component", static_cast<std::size_t>(histories.ground_acceleration.rows())});
    pass({"ground_acceleration",
          {time_, component},
          length_ + " s-2",
          "components of the ground acceleration, along their own axes, without delay"},
         histories.ground_acceleration);
    if constexpr (!reads) {
      each({"building_name", {building}, "", "names of the buildings, as in the case"}, buildings, &PlanBuilding::name);
      std::vector<double> delays = run_.problem.delays;
      delays.resize(buildings.size(), 0.0);
      made({"building_delay", {building}, "s", "delay of the ground motion at the buildings"}, delays);
    }
    for (Index b = 0; b < std::ssize(buildings); ++b) of_building(b);
    of_points();
    course();
    of_links();
    quantities(Owner::run, {}, {QuantityPlace{}});
    auto& impacts = run_.response.impacts;
    const ResultDimension impact = this->impact_points(impacts, run_.response.points.size());
    quantities(Owner::impact, {impact}, places_of(impacts.size()), "", " of each impact");
    plan_figures(file_, run_, length_, force_);
    this->energy(run_.response.energy, time_, force_ + " " + length_, run_.response.histories.time);
  }

 private:
  void quantities(Owner owner, const std::vector<ResultDimension>& along, const std::vector<QuantityPlace>& places,
                  const std::string& after = "", const std::string& of = "") {
    for (const Quantity* const one : quantities_of(owner, true)) {
      ResultVariable variable{file_name(*one) + after, along, udunits(one->units, run_.c.units),
                              std::string(one->long_name) + of};
      std::vector<double> values;
      if constexpr (reads) {
        const auto& keep = one->source.plan.keep;
        if (!keep || !file_.has(variable.name, false)) continue;
        made(std::move(variable), values);
        for (std::size_t i = 0; i < values.size(); ++i) keep(run_, places[i], values[i]);
      } else {
        values = values_at(*one, run_, places);
        if (values.empty()) continue;
        if (!one->symbol.empty()) variable.attributes.push_back({"symbol", std::string(one->symbol)});
        made(std::move(variable), values);
      }
    }
  }

  void of_building(Index b) {
    const PlanBuilding& building = run_.problem.buildings[b];
    const PlanModel& model = building.model;
    auto& histories = run_.response.histories;
    const std::string number = fmt::format("_{}", b + 1), owner = fmt::format("building \"{}\"", building.name);
    const std::string of = " of the floors of " + owner;
    const ResultDimension floors = file_.dimension({"elevation" + number, model.elevations.size()});
    if constexpr (reads) {
      if (floors.size != model.elevations.size()) file_.source.fail("is not of this case");
      if (building.is_rigid()) stand_still(b);
    } else {
      shape(building, floors, number, owner);
    }
    const auto history = [&](const char* name, auto& list, const std::string& units, const std::string& what) {
      fit(list, run_.problem.buildings.size());
      if (time_.size > 0) pass({name + number, {time_, floors}, units, what + of}, list[b]);
    };
    history("displacement_x", histories.x, length_, "displacement along x of the centres of mass, from the own base,");
    history("displacement_y", histories.y, length_, "displacement along y of the centres of mass, from the own base,");
    history("rotation", histories.rotation, "rad", "rotation, counter-clockwise from above,");
    history("acceleration_x", histories.acceleration_x, length_ + " s-2", "absolute acceleration along x");
    history("acceleration_y", histories.acceleration_y, length_ + " s-2", "absolute acceleration along y");
    quantities(Owner::floor, {floors}, floors_of(run_.problem, b), number, of);
    quantities(Owner::building, {}, {{b}}, number, " of " + owner);
    foundation(b, number, owner);
    bearings(b, number, owner);
    planes(b, floors, number, owner);
  }

  /// Histories of the foundation of a building on soil.
  void foundation(Index b, const std::string& number, const std::string& owner) {
    auto& list = run_.response.histories.foundation;
    fit(list, run_.problem.buildings.size());
    if (time_.size == 0 || !run_.problem.buildings[b].model.soil) return;
    if constexpr (reads) list[b].resize(10, static_cast<Index>(time_.size));
    const std::string moment = udunits("F L", run_.c.units);
    const auto row = [&](Index r, const char* name, const std::string& units, const char* what) {
      Eigen::MatrixXd values = list[b].row(r);
      made({name + number, {time_}, units, fmt::format("{} of {}", what, owner)}, values);
      if constexpr (reads) list[b].row(r) = values.transpose();
    };
    row(0, "foundation_sway_x", length_, "sway along x, relative to the free field, of the foundation");
    row(1, "foundation_sway_y", length_, "sway along y, relative to the free field, of the foundation");
    row(2, "foundation_rocking_x", "rad", "rocking that moves what is above along x of the foundation");
    row(3, "foundation_rocking_y", "rad", "rocking that moves what is above along y of the foundation");
    row(4, "foundation_twist", "rad", "rotation, counter-clockwise from above, of the foundation");
    row(5, "soil_force_x", force_, "force along x of the springs and dashpots under the foundation");
    row(6, "soil_force_y", force_, "force along y of the springs and dashpots under the foundation");
    row(7, "soil_moment_x", moment, "moment against rocking along x of the springs and dashpots under the foundation");
    row(8, "soil_moment_y", moment, "moment against rocking along y of the springs and dashpots under the foundation");
    row(9, "soil_torque", moment, "torque of the springs and dashpots under the foundation");
  }

  /// Places, numbers and histories of the bearings below a slab.
  void bearings(Index b, const std::string& number, const std::string& owner) {
    auto& list = run_.response.histories.bearing;
    fit(list, run_.problem.buildings.size());
    const PlanModel& model = run_.problem.buildings[b].model;
    const auto count = static_cast<Index>(model.bearings.size());
    if (count == 0) return;
    const ResultDimension bearing = file_.dimension(bearing_dimension(b, model.bearings.size(), true));
    if constexpr (reads) {
      if (bearing.size != model.bearings.size()) file_.source.fail("is not of this case");
    } else {
      for (ResultVariable& one : bearing_places(bearing, run_.problem.buildings[b], b, length_)) {
        file_.tell(std::move(one));
      }
    }
    quantities(Owner::bearing, {bearing}, bearings_of(run_.problem, b), number, " of " + owner);
    if (time_.size == 0) return;
    if constexpr (reads) list[b].resize(4 * count, static_cast<Index>(time_.size));
    const auto rows = [&](Index first, const char* name, const std::string& units, const char* what) {
      Eigen::MatrixXd values(count, static_cast<Index>(time_.size));
      for (Index n = 0; n < count; ++n) values.row(n) = list[b].row(first + 2 * n);
      made({name + number, {time_, bearing}, units, fmt::format("{} of the bearings of {}", what, owner)}, values);
      if constexpr (reads) {
        for (Index n = 0; n < count; ++n) list[b].row(first + 2 * n) = values.row(n);
      }
    };
    rows(0, "bearing_displacement_x", length_, "displacement along x");
    rows(1, "bearing_displacement_y", length_, "displacement along y");
    rows(2 * count, "bearing_force_x", force_, "force along x, without dashpots,");
    rows(2 * count + 1, "bearing_force_y", force_, "force along y, without dashpots,");
  }

  /// What nobody tells of a wall.
  void stand_still(Index b) {
    for (auto* response : {&run_.response.buildings, &run_.response.buildings_no_contact}) {
      PlanPeaks& peaks = (*response)[b];
      for (Eigen::VectorXd* const list : {&peaks.south, &peaks.north, &peaks.west, &peaks.east, &peaks.rotation,
                                          &peaks.angular_acceleration, &peaks.x, &peaks.y}) {
        list->setZero(run_.problem.buildings[b].model.floors());
      }
    }
  }

  /// Where a building stands, its masses and periods.
  void shape(const PlanBuilding& building, const ResultDimension& floors, const std::string& number,
             const std::string& owner) {
    const PlanModel& model = building.model;
    const std::string of = " of the floors of " + owner;
    pass({floors.name, {floors}, length_, "elevation" + of, {{"axis", "Z"}, {"positive", "up"}}}, model.elevations);
    std::vector<double> footprint = {model.footprint.lower().x(), model.footprint.lower().y(),
                                     model.footprint.far_corner().x(), model.footprint.far_corner().y()};
    made({"footprint" + number, {{"side", 4}}, length_, "left, lower, right and upper edge of " + owner}, footprint);
    if (!model.footprint.polygon.empty()) {
      const std::vector<PlanPoint> corners = model.footprint.corners();
      std::vector<double> places;
      for (const PlanPoint& at : corners) places.insert(places.end(), {at.x(), at.y()});
      made({"corners" + number,
            {{"corner" + number, corners.size()}, {"coordinate", 2}},
            length_,
            "x and y of the corners of " + owner},
           places);
    }
    if (building.is_rigid()) return;
    std::vector<double> x, y;
    for (const PlanPoint& centre : model.centres) {
      x.push_back(model.footprint.corner.x() + centre.x());
      y.push_back(model.footprint.corner.y() + centre.y());
    }
    made({"centre_x" + number, {floors}, length_, "x of the centres of mass" + of}, x);
    made({"centre_y" + number, {floors}, length_, "y of the centres of mass" + of}, y);
    Eigen::MatrixXd periods = modal_properties(building.modes, model.load.col(0)).periods;
    made({"period" + number, {{"mode" + number, static_cast<std::size_t>(periods.size())}}, "s", "periods of " + owner},
         periods);
  }

  void planes(Index b, const ResultDimension& floors, const std::string& number, const std::string& owner) {
    const auto& all = run_.problem.buildings[b].model.planes;
    const ResultDimension planes = plane_dimension(b, all.size());
    if constexpr (reads) {
      for (auto* response : {&run_.response.buildings, &run_.response.buildings_no_contact}) {
        (*response)[b].planes.resize(all.size());
      }
    } else {
      file_.tell(plane_names(planes, run_.problem.buildings[b]));
      file_.tell(plane_angles(planes, run_.problem.buildings[b], b));
    }
    std::vector<QuantityPlace> places;
    for (Index p = 0; p < std::ssize(all); ++p) {
      for (const QuantityPlace& place : floors_of(run_.problem, b, p)) places.push_back(place);
    }
    quantities(Owner::plane, {planes, floors}, places, number, ", by the floor above, of " + owner);
    hinges(b, number, owner);
    breaking_columns(b, number, owner);
    infill(b, number, owner);
    mechanisms(b, planes, floors, number, owner);
  }

  /// What the struts of the frames of a building did, sample by sample.
  void infill(Index b, const std::string& number, const std::string& owner) {
    auto& histories = run_.response.histories;
    for (auto* list : {&histories.infill_force, &histories.infill_shortening}) {
      fit(*list, run_.problem.buildings.size());
    }
    std::vector<InfillPanel> panels;
    std::vector<std::string> planes;
    for (const PlanModel::Plane& plane : run_.problem.buildings[b].model.planes) {
      panels.insert(panels.end(), plane.infills.begin(), plane.infills.end());
      planes.insert(planes.end(), plane.infills.size(), plane.name);
    }
    if (panels.empty()) return;
    const std::size_t count = panels.size();
    const ResultDimension dimension = this->infill_places(panels, number, owner);
    if constexpr (reads) {
      if (dimension.size != count) file_.source.fail("is not of this case");
    }
    made({"infill_panel_plane" + number, {dimension}, "", "planes of the panels of infill of " + owner}, planes);
    this->infill_histories(dimension, time_, force_, length_, number, owner, histories.infill_force[b],
                           histories.infill_shortening[b]);
  }

  /// Where members of the frames of a building yield, and what they did there.
  void hinges(Index b, const std::string& number, const std::string& owner) {
    const std::vector<QuantityPlace> places = hinges_of(run_.problem, b);
    auto& histories = run_.response.histories;
    fit(histories.hinge_moment, run_.problem.buildings.size());
    fit(histories.hinge_rotation, run_.problem.buildings.size());
    if (places.empty()) return;
    const ResultDimension hinges = file_.dimension({"hinge" + number, places.size()});
    const std::string of = " of the hinges of " + owner;
    if constexpr (reads) {
      if (hinges.size != places.size()) file_.source.fail("is not of this case");
    } else {
      hinges_told(b, hinges, places, number, of);
    }
    quantities(Owner::hinge, {hinges}, places, number, of);
    if (time_.size == 0) return;
    pass({"hinge_moment" + number, {time_, hinges}, force_ + " " + length_, "moments, that at rest included," + of},
         histories.hinge_moment[b]);
    pass({"hinge_rotation" + number, {time_, hinges}, "rad", "rotations" + of}, histories.hinge_rotation[b]);
  }

  void hinges_told(Index b, const ResultDimension& hinges, const std::vector<QuantityPlace>& places,
                   const std::string& number, const std::string& of) {
    std::vector<std::string> planes;
    std::vector<HingePlace> ends;
    Eigen::MatrixXd limits(std::ssize(places), 3);
    for (std::size_t h = 0; h < places.size(); ++h) {
      const PlanModel::Plane& plane = run_.problem.buildings[b].model.planes[places[h].plane];
      planes.push_back(plane.name);
      ends.push_back(plane.hinges.places[places[h].floor]);
      limits.row(static_cast<Index>(h)) = plane.hinges.rotation_limits.row(places[h].floor);
    }
    made({"hinge_plane" + number, {hinges}, "", "planes" + of}, planes);
    this->hinge_places(hinges, ends, number, of);
    if (limits.array().isNaN().all()) return;
    made({"hinge_limit" + number, {{"limit" + number, 3}, hinges}, "rad", "IO, LS, CP" + of}, limits);
  }

  void breaking_columns(Index b, const std::string& number, const std::string& owner) {
    const std::vector<QuantityPlace> places = breaking_columns_of(run_.problem, b);
    if (places.empty()) return;
    const std::string of = " of the columns that can break of " + owner;
    const ResultDimension columns = file_.dimension({"breaking_column" + number, places.size()});
    if constexpr (reads) {
      if (columns.size != places.size()) file_.source.fail("is not of this case");
    } else {
      std::vector<std::string> planes;
      std::vector<BreakingColumn> all;
      for (const QuantityPlace& at : places) {
        const PlanModel::Plane& plane = run_.problem.buildings[b].model.planes[at.plane];
        planes.push_back(plane.name);
        all.push_back(plane.hinges.columns[at.floor]);
      }
      made({"breaking_column_plane" + number, {columns}, "", "planes" + of}, planes);
      this->breaking_places(all, number, owner, force_);
    }
    quantities(Owner::column, {columns}, places, number, of);
  }

  /// When hinges first let storeys of a frame sway without bending, and which; NaN and 0 of all others.
  void mechanisms(Index b, const ResultDimension& planes, const ResultDimension& floors, const std::string& number,
                  const std::string& owner) {
    const auto& all = run_.problem.buildings[b].model.planes;
    const auto has_hinges = [](const PlanModel::Plane& plane) { return plane.hinges.size() > 0; };
    if (std::none_of(all.begin(), all.end(), has_hinges)) return;
    std::vector<double> times(all.size(), not_known);
    std::vector<int> sways(all.size() * floors.size, 0);
    auto& peaks = run_.response.buildings[b].planes;
    if constexpr (!reads) {
      for (std::size_t p = 0; p < all.size(); ++p) {
        if (!peaks[p].frame.mechanism) continue;
        times[p] = peaks[p].frame.mechanism->time;
        for (const Index storey : peaks[p].frame.mechanism->storeys) {
          sways[p * floors.size + static_cast<std::size_t>(storey)] = 1;
        }
      }
    }
    made({"mechanism_time" + number,
          {planes},
          "s",
          "when hinges first let storeys of a frame sway without bending, of " + owner},
         times);
    made({"mechanism_storey" + number, {planes, floors}, "", "1 for each storey that did so then, of " + owner}, sways);
    if constexpr (reads) {
      for (std::size_t p = 0; p < times.size(); ++p) {
        if (std::isnan(times[p])) continue;
        peaks[p].frame.mechanism = BuildingPeaks::Mechanism{.time = times[p], .storeys = {}};
        std::vector<Index>& storeys = peaks[p].frame.mechanism->storeys;
        for (std::size_t j = 0; j < floors.size; ++j) {
          if (sways[p * floors.size + j] != 0) storeys.push_back(static_cast<Index>(j));
        }
      }
    }
  }

  void of_points() {
    if constexpr (!reads) point_places();
    quantities(Owner::point, {points_}, places_of(points_.size));
    if (time_.size == 0) return;
    auto& histories = run_.response.histories;
    this->openings("", time_, points_, length_, force_, histories);
    bool rubs = false;
    for (const PlanGap& gap : run_.problem.gaps) {
      for (const PlanContact& contact : gap.contacts) rubs = rubs || contact.rubbing;
    }
    if (!rubs) return;
    pass({"slip", {time_, points_}, length_, "movement along the joint of the left against the right building"},
         histories.slip);
    pass({"force_along",
          {time_, points_},
          force_,
          "contact force along the joint, as it acts against the left building"},
         histories.force_along);
  }

  void course() {
    auto& course = run_.response.course;
    const ResultDimension time = this->course_time(course);
    if (time.size == 0) return;
    for (Index b = 0; b < std::ssize(run_.problem.buildings); ++b) {
      const PlanBuilding& building = run_.problem.buildings[b];
      const std::string number = fmt::format("_{}", b + 1);
      const ResultDimension floors{"elevation" + number, building.model.elevations.size()};
      const auto curves = [&](const char* name, auto& list, const std::string& units, const char* what) {
        fit(list, run_.problem.buildings.size());
        pass({fmt::format("exact/{}{}", name, number),
              {time, floors},
              units,
              fmt::format("{} of the floors of building \"{}\"", what, building.name)},
             list[b]);
      };
      curves("displacement_x", course.x, length_, "displacement along x of the centres of mass, from the own base,");
      curves("displacement_y", course.y, length_, "displacement along y of the centres of mass, from the own base,");
      curves("rotation", course.rotation, "rad", "rotation, counter-clockwise from above,");
    }
    this->openings("exact/", time, points_, length_, force_, course);
  }

  void point_places() {
    PlaceVariables places = plan_place_variables(run_.problem, length_, length_);
    for (ResultVariable& variable : places.variables) file_.tell(std::move(variable));
    quantities(Owner::gap, {places.gaps}, places_of(places.gaps.size));
  }

  void of_links() {
    const auto& links = run_.problem.links;
    if (links.empty()) return;
    const ResultDimension link = file_.dimension(link_dimension(links.size(), true));
    if constexpr (reads) {
      if (link.size != links.size()) file_.source.fail("is not of this case");
      run_.response.links.resize(links.size());
    }
    quantities(Owner::link, {link}, places_of(links.size()));
  }

  [[nodiscard]] static std::vector<QuantityPlace> places_of(std::size_t count) {
    std::vector<QuantityPlace> places;
    for (std::size_t i = 0; i < count; ++i) places.push_back({static_cast<Index>(i)});
    return places;
  }

  Run& run_;
  std::string length_, force_;
  ResultDimension time_, points_;
};

}  // namespace

void read_plan_response(const ResultSource& source, PlanRun& run) {
  if (source.dimension_size("time") == 0) source.fail("holds no histories");
  run.response = {};
  Giver giver(source);
  PlanVariables(giver, run).all();
}

bool is_plan_run(const ResultSource& source) { return source.has("footprint_1") && source.has("displacement_x_1"); }

ResultFile run_file(const PlanRun& run, std::string_view version) {
  ResultFile file;
  file.attributes = run_attributes(run.c, "seismic pounding analysis in plan", version);
  Teller teller;
  PlanVariables(teller, run).all();
  file.variables = std::move(teller.variables);
  return file;
}

}  // namespace bentur
