#include "bentur/io/results/run_variables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <type_traits>

#include "bentur/io/results/internal/curve_names.h"
#include "bentur/io/results/internal/figure_list.h"
#include "bentur/io/results/internal/place_list.h"
#include "bentur/pounding/pounding.h"

namespace bentur {
namespace {

template <class File, class Part>
using PartOf = std::conditional_t<File::reads, Part, const Part>;

/// Goes through all variables of a run: `File` is a Teller of a `Run` that is const, or a Giver to one that is not.
template <class File, class Run>
class RunList : private PlaceList<File, PartOf<File, Problem>> {
  using List = PlaceList<File, PartOf<File, Problem>>;
  using List::breaking_places, List::each, List::file_, List::fit, List::hinge_places, List::infill_places, List::made,
      List::mechanism, List::pass, List::problem_, List::single;
  using List::gaps, List::links, List::places, List::points;

 public:
  RunList(File& file, Run& run, std::string length, std::string force)
      : List(file, run.problem),
        run_(run),
        response_(run.response),
        histories_(run.response.histories),
        length_(std::move(length)),
        force_(std::move(force)),
        moment_(force_ + " " + length_) {}

  void all() {
    time_ = file_.dimension({"time", histories_.time.size()});
    const ResultDimension buildings = file_.dimension({"building", problem_.buildings.size(), "building_name"});
    fit(problem_.buildings, buildings.size);
    fit(response_.buildings, buildings.size);
    pass({"time", {time_}, "s", "time", {{"axis", "T"}}}, histories_.time);
    pass({"ground_acceleration", {time_}, length_ + " s-2", "ground acceleration without delay"},
         histories_.ground_acceleration);
    each({"building_name", {buildings}, "", "names of the buildings, left to right"}, problem_.buildings,
         &Building::name);
    std::vector<double> delays = problem_.delays;
    delays.resize(buildings.size, 0.0);
    made({"building_delay", {buildings}, "s", "delay of the ground motion at the buildings"}, delays);
    for (std::size_t b = 0; b < buildings.size; ++b) building(b);
    places(length_, length_);
    quantities(Owner::gap, gaps, first_places(static_cast<Eigen::Index>(gaps.size)));
    quantities(Owner::run, {}, {{}});
    contact_points();
    fit(response_.links, links.size);
    each({"link_kind", {links}, "", "what the links are"}, problem_.links, &Link::kind);
    quantities(Owner::link, links, first_places(static_cast<Eigen::Index>(links.size)));
    stretched("", time_, histories_.link_deformation, histories_.link_force);
    const ResultDimension impact = this->impact_points(response_.impacts, problem_.points.size());
    quantities(Owner::impact, impact, first_places(std::ssize(response_.impacts)), "", " of each impact");
    FigureList<File, PartOf<File, FigureData>>(file_, run_.figures, problem_.buildings, length_, force_).all();
    this->energy(response_.energy, time_, moment_, histories_.time);
    course();
  }

 private:
  /// Every quantity of `owner` at the places along a dimension, or at one place. Names and descriptions are followed by
  /// what they are of: "_1", " of building \"A\"". Read are those that a response keeps.
  void quantities(Owner owner, const std::optional<ResultDimension>& along, const std::vector<QuantityPlace>& at,
                  const std::string& suffix = "", const std::string& of = "") {
    for (const Quantity* quantity : quantities_of(owner)) {
      ResultVariable variable{file_name(*quantity) + suffix, {}, "", std::string(quantity->long_name) + of};
      if (along) variable.dimensions.push_back(*along);
      std::vector<double> values;
      if constexpr (File::reads) {
        const auto& source = quantity->source.row;
        const bool of_some = source.is_told || quantity->source.table == QuantityTable::forces;
        if (!source.keep || (of_some && !file_.has(variable.name, false))) continue;
        made(variable, values);
        for (std::size_t i = 0; i < values.size(); ++i) source.keep(response_, at[i], values[i]);
      } else {
        const RunView& view = view_ ? *view_ : view_.emplace(run_.view());
        if (!is_told_at_any(*quantity, view, at)) continue;
        variable.units = udunits(quantity->units, run_.c.units);
        if (!quantity->symbol.empty()) variable.attributes.push_back({"symbol", std::string(quantity->symbol)});
        for (const QuantityPlace& place : at) values.push_back(value_of(*quantity, view, place));
        made(std::move(variable), values);
      }
    }
  }

  void building(std::size_t b) {
    auto& building = problem_.buildings[b];
    auto& model = building.model;
    const Eigen::Index item = static_cast<Eigen::Index>(b);
    const std::string number = fmt::format("_{}", b + 1);
    const std::string owner = fmt::format("building \"{}\"", building.name);
    const std::string of_floors = " of the floors of " + owner;
    const std::string of_storeys = " of the storeys of " + owner + ", each by the floor above it";
    const ResultDimension floors = file_.dimension({"elevation" + number, model.elevations.size()});
    const std::vector<ResultAttribute> upwards = {{"axis", "Z"}, {"positive", "up"}};
    pass({floors.name, {floors}, length_, "elevation" + of_floors, upwards}, model.elevations);
    const auto history = [&](const std::string& name, auto& list, const std::string& units, const std::string& what) {
      fit(list, problem_.buildings.size());
      if (time_.size > 0) pass({name + number, {time_, floors}, units, what}, list[b]);
    };
    history("displacement", histories_.displacement, length_, "displacement relative to the own base" + of_floors);
    history("velocity", histories_.velocity, length_ + " s-1", "velocity relative to the own base" + of_floors);
    history("acceleration", histories_.acceleration, length_ + " s-2", "absolute acceleration" + of_floors);
    history("drift_ratio", histories_.drift_ratio, "1", "relative floor displacement over the height" + of_storeys);
    history("storey_shear", histories_.storey_shear, force_,
            "sum of the elastic forces of all floors above the foot" + of_storeys);
    double base = 0;
    if constexpr (!File::reads) {
      Eigen::MatrixXd base_shear;
      if (time_.size > 0) base_shear = histories_.storey_shear[b].row(0);
      made({"base_shear" + number, {time_}, force_, "shear of the lowest storey of " + owner}, base_shear);
      base = model.elevations.front() - model.storey_heights.front();
    }
    const ResultDimension bays = file_.dimension({"bay" + number, building.bays.size()});
    pass({"bay_width" + number, {bays}, length_, "widths of the bays of " + owner}, building.bays);
    single({"base_elevation" + number, {}, length_, "elevation of the base of " + owner}, base);
    if constexpr (File::reads) {
      if (model.elevations.empty()) file_.source.fail("has no floors of " + owner);
      for (const double elevation : model.elevations) {
        model.storey_heights.push_back(elevation - std::exchange(base, elevation));
      }
    }
    quantities(Owner::floor, floors, floors_of(problem_, item), number, of_floors);
    quantities(Owner::building, {}, {{item, 0}}, number, " of " + owner);
    nodes(b, number, owner);
    column_forces("", time_, histories_.column_forces, b);
    hinges(b, number, owner);
    breaking_columns(b, number, owner);
    infill(b, number, owner);
    modes(building, floors, number, owner);
    foundation("", time_, histories_.foundation, b);
  }

  /// Places in columns of a building that floors strike.
  void nodes(std::size_t b, const std::string& number, const std::string& owner) {
    auto& elevations = problem_.buildings[b].model.node_elevations;
    const ResultDimension nodes = file_.dimension({"node" + number, elevations.size(), "node_elevation" + number});
    const std::string what = "elevation of the places in columns of " + owner + " that floors strike";
    pass({"node_elevation" + number, {nodes}, length_, what}, elevations);
    const auto count = static_cast<Eigen::Index>(nodes.size);
    if constexpr (File::reads) {
      histories_.node_displacement.emplace_back(count, static_cast<Eigen::Index>(time_.size));
    }
    if (count == 0 || time_.size == 0) return;
    pass({"node_displacement" + number,
          {time_, nodes},
          length_,
          "displacement of struck columns of " + owner + " where they are struck, relative to the own base"},
         histories_.node_displacement[b]);
  }

  /// Of columns that are struck; `group`: that of the exact course, which had none once.
  template <class List>
  void column_forces(const std::string& group, const ResultDimension& time, List& list, std::size_t b) {
    fit(list, problem_.buildings.size());
    const std::string number = fmt::format("_{}", b + 1);
    const ResultDimension nodes{"node" + number, problem_.buildings[b].model.node_elevations.size()};
    const auto count = static_cast<Eigen::Index>(nodes.size);
    const bool is_there = count > 0 && time.size > 0;
    const std::string first = group + column_ends.front().name + number;
    const bool has = file_.has(first, is_there && b < list.size() && list[b].size() > 0) && is_there;
    if constexpr (File::reads) list[b].resize(has ? 6 * count : 0, static_cast<Eigen::Index>(time.size));
    if (!has) return;
    for (std::size_t end = 0; end < column_ends.size(); ++end) {
      const auto& [name, long_name, is_moment] = column_ends[end];
      const auto rows = Eigen::seqN(static_cast<Eigen::Index>(end), count, Eigen::fix<6>);
      Eigen::MatrixXd values = list[b](rows, Eigen::all);
      made({fmt::format("{}{}{}", group, name, number),
            {time, nodes},
            is_moment ? moment_ : force_,
            fmt::format("{} of building \"{}\"", long_name, problem_.buildings[b].name)},
           values);
      if constexpr (File::reads) list[b](rows, Eigen::all) = values;
    }
  }

  /// Where members of a frame yield, and what they did there.
  void hinges(std::size_t b, const std::string& number, const std::string& owner) {
    auto& places = problem_.buildings[b].model.hinges.places;
    const ResultDimension hinges = file_.dimension({"hinge" + number, places.size()});
    fit(places, hinges.size);
    if constexpr (File::reads) {
      for (auto* list : {&histories_.hinge_moment, &histories_.hinge_rotation})
        list->emplace_back(static_cast<Eigen::Index>(hinges.size), static_cast<Eigen::Index>(time_.size));
    }
    if (hinges.size == 0) return;
    const std::string of = " of the hinges of " + owner;
    hinge_places(hinges, places, number, of);
    if (auto& limits = problem_.buildings[b].model.hinges.rotation_limits;
        file_.has("hinge_limit" + number, limits.size() > 0 && !limits.array().isNaN().all())) {
      if constexpr (File::reads) limits.resize(static_cast<Eigen::Index>(hinges.size), 3);
      pass({"hinge_limit" + number, {file_.dimension({"limit" + number, 3}), hinges}, "rad", "IO, LS, CP" + of},
           limits);
    }
    quantities(Owner::hinge, hinges, hinges_of(problem_, static_cast<Eigen::Index>(b)), number, of);
    if (time_.size == 0) return;
    pass({"hinge_moment" + number, {time_, hinges}, moment_, "moments, that at rest included," + of},
         histories_.hinge_moment[b]);
    pass({"hinge_rotation" + number, {time_, hinges}, "rad", "rotations" + of}, histories_.hinge_rotation[b]);
  }

  /// Columns that can break in shear, and what they did; of hinges and of these the mechanism.
  void breaking_columns(std::size_t b, const std::string& number, const std::string& owner) {
    auto& model = problem_.buildings[b].model;
    const ResultDimension columns = breaking_places(model.hinges.columns, number, owner, force_);
    if (columns.size + model.hinges.places.size() == 0) return;
    mechanism(model.floors(), response_.buildings[b].mechanism, number, owner);
    if (columns.size == 0) return;
    quantities(Owner::column, columns, breaking_columns_of(problem_, static_cast<Eigen::Index>(b)), number,
               " of the columns that can break of " + owner);
  }

  /// What struts did, sample by sample.
  void infill(std::size_t b, const std::string& number, const std::string& owner) {
    for (auto* list : {&histories_.infill_force, &histories_.infill_shortening}) fit(*list, problem_.buildings.size());
    if (!file_.has("infill_panel_storey" + number, !problem_.buildings[b].model.infills.empty())) return;
    const ResultDimension panels = infill_places(problem_.buildings[b].model.infills, number, owner);
    this->infill_histories(panels, time_, force_, length_, number, owner, histories_.infill_force[b],
                           histories_.infill_shortening[b]);
  }

  /// None of a building that moves with the ground.
  template <class Owned>
  void modes(Owned& building, const ResultDimension& floors, const std::string& number, const std::string& owner) {
    const ResultDimension modes =
        file_.dimension({"mode" + number, static_cast<std::size_t>(building.modes.omega.size())});
    Eigen::MatrixXd periods, shapes;
    if constexpr (!File::reads) {
      periods = 2 * std::numbers::pi * building.modes.omega.cwiseInverse();
      if (modes.size > 0) shapes = sway_shapes(building);
    }
    made({"period" + number, {modes}, "s", "periods of " + owner}, periods);
    made({"shape" + number, {modes, floors}, "1", "sways of the mode shapes, the largest 1, of " + owner}, shapes);
    if constexpr (File::reads) {
      building.modes.shapes = shapes;
      if (modes.size == 0) return;
      building.modes.omega = 2 * std::numbers::pi * periods.col(0).cwiseInverse();
      if (building.model.storey_heights.front() == 0) building.model.slab = 0;
      if (file_.has("peak_sway" + number, false)) building.model.foundation.emplace();
    }
  }

  /// Of a building on soil; `group`: that of the exact course.
  template <class List>
  void foundation(const std::string& group, const ResultDimension& time, List& list, std::size_t b) {
    fit(list, problem_.buildings.size());
    const std::string of = fmt::format(" of building \"{}\"", problem_.buildings[b].name);
    const auto name = [&](const char* quantity) { return fmt::format("{}{}_{}", group, quantity, b + 1); };
    if (!file_.has(name("foundation_sway"), time.size > 0 && b < list.size() && list[b].rows() > 0)) return;
    if constexpr (File::reads) list[b].resize(4, static_cast<Eigen::Index>(time.size));
    const auto row = [&](Eigen::Index r, const char* quantity, const std::string& units, const std::string& what) {
      Eigen::MatrixXd values = list[b].row(r);
      made({name(quantity), {time}, units, what + of}, values);
      if constexpr (File::reads) list[b].row(r) = values.transpose();
    };
    row(0, "foundation_sway", length_, "sway of the foundation relative to the free field");
    row(1, "foundation_rocking", "rad", "rotation of the foundation");
    row(2, "soil_force", force_, "horizontal force of the springs and dashpots under the foundation");
    row(3, "soil_moment", moment_, "moment of the springs and dashpots under the foundation");
  }

  /// Of the links; `group`: that of the exact course.
  template <class Table>
  void stretched(const std::string& group, const ResultDimension& time, Table& deformation, Table& force) {
    if (!file_.has(group + "link_force", time.size > 0 && force.rows() > 0)) return;
    pass({group + "link_deformation", {time, links}, length_, "approach of the floors that links join"}, deformation);
    pass({group + "link_force", {time, links}, force_, "force of links, pushing apart"}, force);
  }

  void contact_points() {
    points.coordinates = "point_elevation point_width " + List::of_points;
    fit(response_.points, points.size);
    quantities(Owner::point, points, first_places(static_cast<Eigen::Index>(points.size)));
    this->openings("", time_, points, length_, force_, histories_);
    if constexpr (File::reads) each({"point_width", {points}, "", ""}, problem_.points, &ContactPoint::width);
    struck();
  }

  /// Which columns are struck at the contact points, and what they bear; nothing where floors meet at all of them.
  void struck() {
    auto& all = problem_.points;
    std::vector<std::string> names(all.size());
    std::vector<int> nodes(all.size(), -1);
    std::vector<double> shears(all.size()), moments(all.size());
    bool some = false;
    for (std::size_t i = 0; !File::reads && i < all.size(); ++i) {
      const std::optional<StruckColumn> column = struck_column(problem_, all[i]);
      if (!column) continue;
      some = true;
      names[i] = problem_.buildings[column->building].name;
      nodes[i] = static_cast<int>(column->node);
      shears[i] = all[i].column_shear_capacity;
      moments[i] = all[i].column_moment_capacity;
    }
    if (!file_.has("point_struck", some)) return;
    made({"point_struck", {points}, "", "building whose column is struck at the contact points, or nothing"}, names);
    made({"point_node", {points}, "", "number of its node, counted from 0; -1 where floors meet"}, nodes);
    made({"column_shear_capacity", {points}, force_, "shear that the struck column can carry; 0: not given"}, shears);
    made({"column_moment_capacity", {points}, moment_, "moment that the struck column can carry; 0: not given"},
         moments);
    if constexpr (File::reads) {
      for (std::size_t i = 0; i < all.size(); ++i) {
        if (names[i].empty()) continue;
        const bool left = problem_.buildings[all[i].left].name == names[i];
        const StructuralModel& model = problem_.buildings[left ? all[i].left : all[i].right].model;
        if (nodes[i] < 0 || nodes[i] >= model.nodes()) file_.source.fail("a floor strikes a column that is not in it");
        (left ? all[i].left_floor : all[i].right_floor) = model.floors() + nodes[i];
        all[i].column_shear_capacity = shears[i];
        all[i].column_moment_capacity = moments[i];
      }
    }
  }

  void course() {
    auto& course = response_.course;
    const ResultDimension time = this->course_time(course);
    if (time.size == 0) return;
    for (std::size_t b = 0; b < problem_.buildings.size(); ++b) {
      const Building& building = problem_.buildings[b];
      const std::string number = fmt::format("_{}", b + 1);
      const ResultDimension floors{"elevation" + number, building.model.elevations.size()};
      const ResultDimension nodes{"node" + number, building.model.node_elevations.size()};
      const auto curves = [&](const std::string& name, auto& list, const ResultDimension& along,
                              const std::string& units, const std::string& of) {
        fit(list, problem_.buildings.size());
        const ResultVariable variable{fmt::format("exact/{}{}", name, number),
                                      {time, along},
                                      units,
                                      fmt::format("{} of building \"{}\"", of, building.name)};
        if (file_.has(variable.name, along.size > 0 && list[b].size() > 0)) pass(variable, list[b]);
      };
      curves("displacement", course.displacement, floors, length_, "displacement relative to the own base");
      curves("drift_ratio", course.drift_ratio, floors, "1", "drift over height of the storeys");
      curves("storey_shear", course.storey_shear, floors, force_, "shear of the storeys");
      curves("node_displacement", course.node_displacement, nodes, length_, "displacement of struck columns");
      column_forces("exact/", time, course.column_forces, b);
      const ResultDimension hinges{"hinge" + number, building.model.hinges.places.size()};
      curves("hinge_moment", course.hinge_moment, hinges, moment_, "moments of the hinges");
      curves("hinge_rotation", course.hinge_rotation, hinges, "rad", "rotations of the hinges");
      foundation("exact/", time, course.foundation, b);
      if constexpr (File::reads) {
        if (nodes.size == 0) course.node_displacement[b].resize(0, std::ssize(course.time));
      }
    }
    this->openings("exact/", time, points, length_, force_, course);
    stretched("exact/", time, course.link_deformation, course.link_force);
  }

  Run& run_;
  PartOf<File, Response>& response_;
  PartOf<File, Histories>& histories_;
  std::string length_, force_, moment_;
  ResultDimension time_;
  std::optional<RunView> view_ = {};  // of one that is written
};

/// The unit of a case that UDUNITS reads so.
std::string unit_of(const std::string& udunits) { return udunits == udunit("tf") ? "tf" : udunits; }

}  // namespace

Eigen::Index nearest_floor(const Building& building, double elevation) {
  const std::vector<double>& floors = building.model.elevations;
  const auto near = std::min_element(floors.begin(), floors.end(), [&](double a, double b) {
    return std::abs(a - elevation) < std::abs(b - elevation);
  });
  return near - floors.begin();
}

ResultFile run_file(const RunResults& results, std::string_view version) {
  const Case& c = results.c;
  ResultFile file;
  file.attributes = run_attributes(c, "seismic pounding analysis", version);
  if (const std::optional<RecordEcho>& record = c.excitation.record; record && !record->sha256.empty()) {
    file.attributes.push_back({"record_file", record->file});
    file.attributes.push_back({"record_size", fmt::format("{}", record->size)});
    file.attributes.push_back({"record_sha256", record->sha256});
  }
  Teller teller;
  RunList(teller, results, udunit(c.units.length), udunit(c.units.force)).all();
  file.variables = std::move(teller.variables);
  return file;
}

RunResults read_run(const ResultSource& source) {
  RunResults results;
  if (source.dimension_size("time") == 0) source.fail("holds no histories");
  results.c.title = source.attribute("title");
  results.c.units.length = unit_of(source.attribute("displacement_1", "units"));
  results.c.units.force = unit_of(source.attribute("storey_shear_1", "units"));
  Giver giver(source);
  RunList(giver, results, results.c.units.length, results.c.units.force).all();
  Problem& problem = results.problem;
  const auto take_floors = [&](auto& item, Eigen::Index left, Eigen::Index right) {
    if (item.left_floor == 0) item.left_floor = nearest_floor(problem.buildings[left], item.elevation);
    if (item.right_floor == 0) item.right_floor = nearest_floor(problem.buildings[right], item.elevation);
  };
  for (ContactPoint& point : problem.points) take_floors(point, point.left, point.right);
  for (Link& link : problem.links) take_floors(link, link.left, link.right);
  problem.duration = results.response.histories.time.back();  // less than a step before the end of the analysis
  for (const Impact& impact : results.response.impacts) problem.duration = std::max(problem.duration, impact.end);
  results.c.analysis.duration = problem.duration;
  return results;
}

bool is_run(const ResultSource& source) {
  return source.has("displacement_1") && source.has("base_elevation_1") && source.has("gap_needed");
}

PlaceVariables place_variables(const Problem& problem, const std::string& point_length,
                               const std::string& link_length) {
  Teller teller;
  PlaceList list(teller, problem);
  list.places(point_length, link_length);
  return {list.gaps, list.points, list.links, std::move(teller.variables)};
}

}  // namespace bentur
