#include "bentur/io/results/plan/plan_variables.h"

#include <fmt/format.h>

#include <utility>

#include "bentur/io/results/internal/curve_names.h"
#include "bentur/io/results/internal/variable_pass.h"
#include "bentur/model/plan/plan_quantities.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

using Eigen::Index;

/// Tells all variables of a run, one after the other.
class PlanVariables : private VariablePass<Teller> {
 public:
  PlanVariables(Teller& file, const PlanRun& run)
      : VariablePass(file),
        run_(run),
        length_(udunit(run.c.units.length)),
        force_(udunit(run.c.units.force)),
        time_{"time", run.response.histories.time.size()},
        points_{"point", run.response.points.size(), "point_elevation point_x point_y point_left point_right"} {}

  void all() {
    const PlanHistories& histories = run_.response.histories;
    pass({"time", {time_}, "s", "time", {{"axis", "T"}}}, histories.time);
    pass({"ground_acceleration",
          {time_, {"component", static_cast<std::size_t>(histories.ground_acceleration.rows())}},
          length_ + " s-2",
          "components of the ground acceleration, along their own axes, without delay"},
         histories.ground_acceleration);
    const auto& buildings = run_.problem.buildings;
    const ResultDimension building{"building", buildings.size(), "building_name"};
    each({"building_name", {building}, "", "names of the buildings, as in the case"}, buildings, &PlanBuilding::name);
    std::vector<double> delays = run_.problem.delays;
    delays.resize(buildings.size(), 0.0);
    made({"building_delay", {building}, "s", "delay of the ground motion at the buildings"}, delays);
    for (Index b = 0; b < std::ssize(buildings); ++b) of_building(b);
    of_points();
    of_impacts();
    energy();
  }

 private:
  void quantities(PlanOwner owner, const std::vector<ResultDimension>& along, const std::vector<PlanPlace>& places,
                  const std::string& before = "", const std::string& after = "", const std::string& of = "") {
    for (const PlanQuantity& one : plan_quantities()) {
      if (one.owner != owner) continue;
      std::vector<double> values = values_at(one, run_, places);
      if (values.empty()) continue;
      ResultVariable variable{fmt::format("{}{}{}", before, file_name(one.told), after), along,
                              udunits(one.told.units, run_.c.units), std::string(one.told.long_name) + of};
      if (!one.told.symbol.empty()) variable.attributes.push_back({"symbol", std::string(one.told.symbol)});
      made(std::move(variable), values);
    }
  }

  void of_building(Index b) {
    const PlanBuilding& building = run_.problem.buildings[b];
    const PlanModel& model = building.model;
    const PlanHistories& histories = run_.response.histories;
    const std::string number = fmt::format("_{}", b + 1), owner = fmt::format("building \"{}\"", building.name);
    const std::string of = " of the floors of " + owner;
    const ResultDimension floors{"elevation" + number, model.elevations.size()};
    pass({floors.name, {floors}, length_, "elevation" + of, {{"axis", "Z"}, {"positive", "up"}}}, model.elevations);
    std::vector<double> footprint = {model.footprint.corner.x(), model.footprint.corner.y(),
                                     model.footprint.far_corner().x(), model.footprint.far_corner().y()};
    made({"footprint" + number, {{"side", 4}}, length_, "left, lower, right and upper edge of " + owner}, footprint);
    std::vector<double> x, y;
    for (const PlanPoint& centre : model.centres) {
      x.push_back(model.footprint.corner.x() + centre.x());
      y.push_back(model.footprint.corner.y() + centre.y());
    }
    if (!building.is_rigid()) {
      made({"centre_x" + number, {floors}, length_, "x of the centres of mass" + of}, x);
      made({"centre_y" + number, {floors}, length_, "y of the centres of mass" + of}, y);
      Eigen::MatrixXd periods = modal_properties(building.modes, model.load.col(0)).periods;
      made({"period" + number,
            {{"mode" + number, static_cast<std::size_t>(periods.size())}},
            "s",
            "periods of " + owner},
           periods);
    }
    const auto history = [&](const char* name, const std::vector<Eigen::MatrixXd>& list, const std::string& units,
                             const std::string& what) {
      if (time_.size > 0) pass({name + number, {time_, floors}, units, what + of}, list[b]);
    };
    history("displacement_x", histories.x, length_, "displacement along x of the centres of mass, from the own base,");
    history("displacement_y", histories.y, length_, "displacement along y of the centres of mass, from the own base,");
    history("rotation", histories.rotation, "rad", "rotation, counter-clockwise from above,");
    history("acceleration_x", histories.acceleration_x, length_ + " s-2", "absolute acceleration along x");
    history("acceleration_y", histories.acceleration_y, length_ + " s-2", "absolute acceleration along y");
    quantities(PlanOwner::floor, {floors}, floors_of(run_.problem, b), "", number, of);
    planes(b, floors, number, owner);
  }

  void planes(Index b, const ResultDimension& floors, const std::string& number, const std::string& owner) {
    const auto& all = run_.problem.buildings[b].model.planes;
    const ResultDimension planes{"plane" + number, all.size(), "plane_name" + number};
    each({"plane_name" + number, {planes}, "", "names of the planes of " + owner}, all, &PlanModel::Plane::name);
    std::vector<PlanPlace> places;
    for (Index p = 0; p < std::ssize(all); ++p) {
      for (const PlanPlace& place : floors_of(run_.problem, b, p)) places.push_back(place);
    }
    quantities(PlanOwner::plane, {planes, floors}, places, "plane_", number, ", by the floor above, of " + owner);
  }

  void of_points() {
    std::vector<std::string> names, left, right;
    std::vector<double> elevation, x, y;
    bool rubs = false;
    for (const PlanGap& gap : run_.problem.gaps) names.push_back(gap_name(run_.problem, gap));
    for (Index i = 0; i < std::ssize(run_.response.points); ++i) {
      const PlanContactPlace place = contact_at(run_.problem, i);
      const PlanGap& gap = run_.problem.gaps[place.gap];
      left.push_back(run_.problem.buildings[gap.left].name);
      right.push_back(run_.problem.buildings[gap.right].name);
      elevation.push_back(place.contact->elevation);
      x.push_back(place.at.x());
      y.push_back(place.at.y());
      rubs = rubs || place.contact->rubbing;
    }
    const ResultDimension gaps{"gap", names.size(), "gap_name"};
    made({"gap_name", {gaps}, "", "buildings on both sides of the gaps"}, names);
    quantities(PlanOwner::gap, {gaps}, places_of(names.size()));
    made({"point_left", {points_}, "", "building to the left of the contact points, or below"}, left);
    made({"point_right", {points_}, "", "building to the right of the contact points, or above"}, right);
    made({"point_elevation", {points_}, length_, "elevation of the contact points"}, elevation);
    made({"point_x", {points_}, length_, "x of the contact points, in the middle of the gap"}, x);
    made({"point_y", {points_}, length_, "y of the contact points, in the middle of the gap"}, y);
    quantities(PlanOwner::point, {points_}, places_of(points_.size));
    if (time_.size == 0) return;
    const PlanHistories& histories = run_.response.histories;
    pass({"opening", {time_, points_}, length_, "opening of the contact points, negative in contact"},
         histories.opening);
    pass({"force", {time_, points_}, force_, "contact force"}, histories.force);
    if (!rubs) return;
    pass({"slip", {time_, points_}, length_, "movement along the joint of the left against the right building"},
         histories.slip);
    pass({"force_along",
          {time_, points_},
          force_,
          "contact force along the joint, as it acts against the left building"},
         histories.force_along);
  }

  void of_impacts() {
    std::vector<int> at;
    for (const Impact& one : run_.response.impacts) at.push_back(static_cast<int>(one.point));
    const ResultDimension impact{"impact", at.size()};
    made({"impact_point", {impact}, "", "number of the contact point of each impact, counted from 0"}, at);
    quantities(PlanOwner::impact, {impact}, places_of(at.size()), "", "", " of each impact");
  }

  void energy() {
    if (!run_.response.energy) return;
    for (const auto& [name, values, what] : energy_curves) {
      const Eigen::VectorXd& curve = run_.response.energy->histories.*values;
      if (curve.size() > 0) pass({fmt::format("energy_{}", name), {time_}, force_ + " " + length_, what}, curve);
    }
  }

  [[nodiscard]] static std::vector<PlanPlace> places_of(std::size_t count) {
    std::vector<PlanPlace> places;
    for (std::size_t i = 0; i < count; ++i) places.push_back({static_cast<Index>(i)});
    return places;
  }

  const PlanRun& run_;
  std::string length_, force_;
  ResultDimension time_, points_;
};

}  // namespace

ResultFile plan_file(const PlanRun& run, std::string_view version) {
  ResultFile file;
  file.attributes = file_attributes(
      run.c.title, fmt::format("seismic pounding analysis in plan, solver {}", name(run.c.analysis.solver)), version);
  if (run.c.source) {
    file.attributes.push_back({"case_file", run.c.source->file});
    file.attributes.push_back({"case_sha256", run.c.source->sha256});
  }
  Teller teller;
  PlanVariables(teller, run).all();
  file.variables = std::move(teller.variables);
  return file;
}

}  // namespace bentur
