#include "bentur/files/result_netcdf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "bentur/model/quantities.h"

namespace bentur {
namespace {

using Dimension = NetcdfWriter::Dimension;
using Variable = NetcdfWriter::Variable;

/// All values of a matrix by columns: rows × columns becomes columns × rows with the last dimension fastest.
template <class Matrix>
std::span<const double> by_columns(const Eigen::PlainObjectBase<Matrix>& matrix) {
  return {matrix.data(), static_cast<std::size_t>(matrix.size())};
}

/// Every quantity of `owner`, at the places along a dimension or at one place. Names and descriptions are followed by
/// what they are of: "_1", " of building \"A\"".
void write_quantities(const NetcdfWriter& file, Owner owner, const RunView& run,
                      const std::vector<Dimension>& dimensions, const std::vector<QuantityPlace>& places,
                      const std::string& suffix, const std::string& of) {
  for (const Quantity* quantity : quantities_of(owner)) {
    if (!is_told_at_any(*quantity, run, places)) continue;
    std::vector<double> values;
    for (const QuantityPlace& at : places) values.push_back(value_of(*quantity, run, at));
    const Variable variable = file.write(file_name(*quantity) + suffix, dimensions, values,
                                         udunits(quantity->units, run.units), std::string(quantity->long_name) + of);
    if (!quantity->symbol.empty()) file.attribute(variable, "symbol", std::string(quantity->symbol));
  }
}

/// Those of one building that the exact course takes part in.
struct BuildingDimensions {
  Dimension floors;
  std::optional<Dimension> nodes;
};

/// Columns of a building that are struck between floors; nothing where there are none.
std::optional<Dimension> write_nodes(const NetcdfWriter& file, Dimension time, Eigen::Index b, const RunView& run,
                                     const std::string& length, const std::string& force) {
  const Histories& histories = run.response.histories;
  const Building& building = run.problem.buildings[b];
  const Eigen::Index nodes = building.model.nodes();
  if (nodes == 0) return std::nullopt;
  const std::string number = fmt::format("_{}", b + 1);
  const std::string owner = fmt::format(" of building \"{}\"", building.name);
  const Dimension dimension = file.dimension("node" + number, static_cast<std::size_t>(nodes));
  file.write("node_elevation" + number, {dimension}, building.model.node_elevations, length,
             "elevation of the places in columns" + owner + " that floors strike");
  file.write("node_displacement" + number, {time, dimension}, by_columns(histories.node_displacement.at(b)), length,
             "displacement of struck columns" + owner + " where they are struck, relative to the own base");
  for (std::size_t end = 0; end < column_ends.size(); ++end) {
    const Eigen::MatrixXd& forces = histories.column_forces.at(b);
    Eigen::MatrixXd values(nodes, forces.cols());
    for (Eigen::Index n = 0; n < nodes; ++n) values.row(n) = forces.row(6 * n + static_cast<Eigen::Index>(end));
    file.write(std::string(column_ends[end].name) + number, {time, dimension}, by_columns(values),
               column_ends[end].is_moment ? fmt::format("{} {}", force, length) : force,
               std::string(column_ends[end].long_name) + owner);
  }
  return dimension;
}

BuildingDimensions write_building(const NetcdfWriter& file, Dimension time, Eigen::Index b, const RunView& run,
                                  const std::string& length, const std::string& force) {
  const Histories& histories = run.response.histories;
  const Building& building = run.problem.buildings[b];
  const std::string number = fmt::format("_{}", b + 1);
  const std::string owner = fmt::format("building \"{}\"", building.name);
  const Dimension floors = file.dimension("elevation" + number, building.model.elevations.size());
  const Variable elevation = file.write("elevation" + number, {floors}, building.model.elevations, length,
                                        "elevation of the floors of " + owner);
  file.attribute(elevation, "axis", "Z");
  file.attribute(elevation, "positive", "up");
  const auto history = [&](const std::string& name, const Eigen::MatrixXd& values, const std::string& units,
                           const std::string& what) {
    // Floors × samples by columns is time × floors by rows.
    file.write(name + number, {time, floors}, by_columns(values), units, what + " of the floors of " + owner);
  };
  history("displacement", histories.displacement.at(b), length, "displacement relative to the own base");
  history("velocity", histories.velocity.at(b), length + " s-1", "velocity relative to the own base");
  history("acceleration", histories.acceleration.at(b), length + " s-2", "absolute acceleration");
  const auto storeys = [&](const std::string& name, const Eigen::MatrixXd& values, const std::string& units,
                           const std::string& what) {
    file.write(name + number, {time, floors}, by_columns(values), units,
               what + " of the storeys of " + owner + ", each by the floor above it");
  };
  storeys("drift_ratio", histories.drift_ratio.at(b), "1", "relative floor displacement over the height");
  storeys("storey_shear", histories.storey_shear.at(b), force,
          "sum of the elastic forces of all floors above the foot");
  const Eigen::VectorXd base_shear = histories.storey_shear.at(b).row(0);
  file.write("base_shear" + number, {time}, by_columns(base_shear), force, "shear of the lowest storey of " + owner);
  const double base = building.model.elevations.front() - building.model.storey_heights.front();
  file.write("base_elevation" + number, {}, std::span(&base, 1), length, "elevation of the base of " + owner);
  write_quantities(file, Owner::floor, run, {floors}, floors_of(run.problem, b), number, " of the floors of " + owner);
  write_quantities(file, Owner::building, run, {}, {{b, 0}}, number, " of " + owner);
  const std::optional<Dimension> nodes = write_nodes(file, time, b, run, length, force);
  if (building.is_rigid()) return {floors, nodes};  // a dimension of size zero would be an unlimited one
  const Eigen::VectorXd periods = 2 * std::numbers::pi * building.modes.omega.cwiseInverse();
  const Dimension modes = file.dimension("mode" + number, static_cast<std::size_t>(periods.size()));
  file.write("period" + number, {modes}, by_columns(periods), "s", "periods of " + owner);
  file.write("shape" + number, {modes, floors}, by_columns(sway_shapes(building)), "1",
             "sways of the mode shapes, the largest 1, of " + owner);
  return {floors, nodes};
}

/// Which columns are struck at the contact points, and what they bear; nothing where floors meet at all of them.
void write_struck(const NetcdfWriter& file, Dimension points, const Problem& problem, const std::string& length,
                  const std::string& force) {
  std::vector<std::string> names;
  std::vector<int> nodes;
  std::vector<double> shears, moments;
  for (const ContactPoint& point : problem.points) {
    const std::optional<StruckColumn> struck = struck_column(problem, point);
    names.push_back(struck ? problem.buildings[struck->building].name : "");
    nodes.push_back(struck ? static_cast<int>(struck->node) : -1);
    shears.push_back(struck ? point.column_shear_capacity : 0);
    moments.push_back(struck ? point.column_moment_capacity : 0);
  }
  if (std::all_of(nodes.begin(), nodes.end(), [](int node) { return node < 0; })) return;
  file.write("point_struck", {points}, names, "", "building whose column is struck at the contact points, or nothing");
  file.write("point_node", {points}, nodes, "", "number of its node, counted from 0; -1 where floors meet");
  file.write("column_shear_capacity", {points}, shears, force, "shear that the struck column bears; 0: not given");
  file.write("column_moment_capacity", {points}, moments, force + " " + length,
             "moment that the struck column bears; 0: not given");
}

/// Nothing without a contact point: a dimension of size zero would be an unlimited one.
std::optional<Dimension> write_points(const NetcdfWriter& file, Dimension time, const RunView& run,
                                      const std::string& length, const std::string& force) {
  const Problem& problem = run.problem;
  const Histories& histories = run.response.histories;
  if (problem.points.empty()) return std::nullopt;
  std::vector<double> elevations;
  for (const ContactPoint& point : problem.points) {
    elevations.push_back(point.elevation);
  }
  const Dimension points = file.dimension("point", problem.points.size());
  file.write("point_elevation", {points}, elevations, length, "elevation of the contact points");
  write_point_sides(file, points, problem);
  const Variable opening = file.write("opening", {time, points}, by_columns(histories.opening), length,
                                      "opening of the contact points, negative in contact");
  const Variable contact = file.write("force", {time, points}, by_columns(histories.force), force, "contact force");
  for (const Variable variable : {opening, contact}) {
    file.attribute(variable, "coordinates", "point_elevation point_width point_left point_right");
  }
  write_quantities(file, Owner::point, run, {points}, first_places(std::ssize(problem.points)), "", "");
  write_struck(file, points, problem, length, force);
  return points;
}

/// Nothing without a link.
void write_links(const NetcdfWriter& file, const RunView& run, const std::string& length) {
  const Problem& problem = run.problem;
  if (problem.links.empty()) return;
  const Dimension links = file.dimension("link", problem.links.size());
  write_link_places(file, links, problem, length);
  write_quantities(file, Owner::link, run, {links}, first_places(std::ssize(problem.links)), "", "");
}

void write_energy(const NetcdfWriter& file, Dimension time, const EnergyHistories& energy, const std::string& units) {
  const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(energy.input.size());
  const auto curve = [&](const std::string& part, const Eigen::VectorXd& values, const std::string& what) {
    file.write("energy_" + part, {time}, by_columns(values), units, what);
  };
  curve("input", energy.input, "energy at the start and work of the ground motion so far");
  curve("kinetic", energy.kinetic, "kinetic energy of the buildings, relative to their bases");
  curve("strain", energy.strain, "strain energy of the buildings and links");
  curve("damping", energy.damping, "energy lost to the damping of the buildings and links so far");
  curve("hysteretic", energy.hysteretic.size() > 0 ? energy.hysteretic : nothing,
        "energy lost to yielding of storeys and links so far");
  curve("contact_stored", energy.contact_stored, "energy stored in contacts, to be given back");
  curve("contact_lost", energy.contact_lost, "energy lost in contacts so far");
}

/// Nothing without an impact: a dimension of size zero would be an unlimited one.
void write_impacts(const NetcdfWriter& file, const RunView& run) {
  const std::vector<Impact>& impacts = run.response.impacts;
  if (impacts.empty()) return;
  const Dimension dimension = file.dimension("impact", impacts.size());
  std::vector<int> points;
  for (const Impact& impact : impacts) points.push_back(static_cast<int>(impact.point));
  file.write("impact_point", {dimension}, points, "", "number of the contact point of each impact, counted from 0");
  write_quantities(file, Owner::impact, run, {dimension}, first_places(std::ssize(impacts)), "", " of each impact");
}

void write_figure_data(const NetcdfWriter& file, const FigureData& figures, const std::string& length,
                       const std::string& force) {
  if (const std::optional<CloseUp>& near = figures.close_up) {
    const Dimension time = file.dimension("close_up_time", near->time.size());
    file.write("close_up_impact", {}, std::span(&near->impact, 1), "", "number of the impact shown, counted from 0");
    file.write("close_up_time", {time}, near->time, "s", "time of the samples of one impact");
    file.write("close_up_opening", {time}, near->opening, length, "opening of its contact point");
    file.write("close_up_force", {time}, near->force, force, "force of its contact point");
  }
  if (figures.spectrum.empty()) return;
  const Dimension period = file.dimension("spectrum_period", figures.spectrum_periods.size());
  std::vector<double> displacement, acceleration;
  for (const OscillatorPeaks& peaks : figures.spectrum) {
    displacement.push_back(peaks.displacement);
    acceleration.push_back(peaks.pseudo_acceleration);
  }
  file.write("spectrum_period", {period}, figures.spectrum_periods, "s", "period of linear oscillators");
  file.write("spectrum_damping", {}, std::span(&figures.spectrum_damping, 1), "1",
             "damping ratio of linear oscillators");
  file.write("spectrum_displacement", {period}, displacement, length, "spectral displacement of the ground motion");
  file.write("spectrum_acceleration", {period}, acceleration, length + " s-2",
             "spectral pseudo-acceleration of the ground motion");
}

}  // namespace

void write_point_sides(const NetcdfWriter& file, NetcdfWriter::Dimension points, const Problem& problem) {
  for (const std::string side : {"left", "right"}) {
    std::vector<std::string> names;
    for (const ContactPoint& point : problem.points) {
      names.push_back(problem.buildings.at(static_cast<std::size_t>(point.left) + (side == "right" ? 1 : 0)).name);
    }
    file.write("point_" + side, {points}, names, "", "building to the " + side + " of the contact points");
  }
}

void write_link_places(const NetcdfWriter& file, NetcdfWriter::Dimension links, const Problem& problem,
                       const std::string& length) {
  std::vector<std::string> left, right;
  std::vector<double> elevations;
  for (const Link& link : problem.links) {
    left.push_back(problem.buildings.at(static_cast<std::size_t>(link.left)).name);
    right.push_back(problem.buildings.at(static_cast<std::size_t>(link.right)).name);
    elevations.push_back(link.elevation);
  }
  file.write("link_left", {links}, left, "", "left building of the links");
  file.write("link_right", {links}, right, "", "right building of the links");
  if (!length.empty()) file.write("link_elevation", {links}, elevations, length, "elevation of the links");
}

namespace {

/// The exact course, in a group of its own whose time has no even steps; it takes part in dimensions of the file.
struct CourseDimensions {
  std::vector<BuildingDimensions> buildings;
  std::optional<Dimension> points;
};

void write_course(NetcdfWriter& file, const CourseDimensions& of, const RunView& run, const std::string& length,
                  const std::string& force) {
  const Histories& course = run.response.course;
  if (course.time.empty()) return;
  file.begin_group("exact");
  const Dimension time = file.dimension("time", course.time.size());
  const Variable coordinate =
      file.write("time", {time}, course.time, "s",
                 "instants between which straight lines follow the solution; two at one time where a force jumps");
  file.attribute(coordinate, "axis", "T");
  for (std::size_t b = 0; b < of.buildings.size(); ++b) {
    const std::string number = fmt::format("_{}", b + 1);
    const std::string owner = fmt::format("building \"{}\"", run.problem.buildings[b].name);
    const auto write = [&](const char* name, const Eigen::MatrixXd& values, const std::string& units,
                           const std::string& what) {
      if (values.size() == 0) return;
      file.write(name + number, {time, of.buildings[b].floors}, by_columns(values), units, what + owner);
    };
    write("displacement", course.displacement[b], length, "displacement relative to the own base of the floors of ");
    write("drift_ratio", course.drift_ratio[b], "1", "relative floor displacement over the height of the storeys of ");
    write("storey_shear", course.storey_shear[b], force, "shear of the storeys of ");
    if (of.buildings[b].nodes) {
      file.write("node_displacement" + number, {time, *of.buildings[b].nodes}, by_columns(course.node_displacement[b]),
                 length, "displacement of struck columns where they are struck, relative to the own base of " + owner);
    }
  }
  if (!of.points) return;
  file.write("opening", {time, *of.points}, by_columns(course.opening), length,
             "opening of the contact points, negative in contact");
  file.write("force", {time, *of.points}, by_columns(course.force), force, "contact force");
}

}  // namespace

std::string histories_netcdf(const RunResults& results, std::string_view version) {
  const auto& [c, problem, response, remarks, figures] = results;
  const RunView run = results.view();
  const Histories& histories = response.histories;
  const std::string length = udunit(c.units.length);
  const std::string force = udunit(c.units.force);
  NetcdfWriter file("histories.nc", NetcdfWriter::Place::memory);
  file.describe(c.title, fmt::format("seismic pounding analysis, solver {}", name(c.analysis.solver)), version);
  if (c.source) {
    file.attribute("case_file", c.source->file);
    file.attribute("case_sha256", c.source->sha256);
  }
  if (const std::optional<RecordEcho>& record = c.excitation.record; record && !record->sha256.empty()) {
    file.attribute("record_file", record->file);
    file.attribute("record_size", fmt::format("{}", record->size));
    file.attribute("record_sha256", record->sha256);
  }
  const Dimension time = file.dimension("time", histories.time.size());
  const Variable coordinate = file.write("time", {time}, histories.time, "s", "time");
  file.attribute(coordinate, "axis", "T");
  file.write("ground_acceleration", {time}, histories.ground_acceleration, length + " s-2",
             "ground acceleration without delay");
  std::vector<double> delays = problem.delays;
  delays.resize(problem.buildings.size(), 0.0);
  std::vector<std::string> names;
  CourseDimensions of_course;
  for (Eigen::Index b = 0; b < std::ssize(problem.buildings); ++b) {
    of_course.buildings.push_back(write_building(file, time, b, run, length, force));
    names.push_back(problem.buildings[b].name);
  }
  const Dimension buildings = file.dimension("building", problem.buildings.size());
  file.write("building_name", {buildings}, names, "", "names of the buildings, left to right");
  file.write("building_delay", {buildings}, delays, "s", "delay of the ground motion at the buildings");
  std::vector<std::string> gap_names;
  for (const Gap& gap : gaps_of(problem)) gap_names.push_back(gap_name(problem, gap.left));
  const Dimension gaps = file.dimension("gap", gap_names.size());
  file.write("gap_name", {gaps}, gap_names, "", "buildings on both sides of the gaps");
  write_quantities(file, Owner::gap, run, {gaps}, first_places(std::ssize(gap_names)), "", "");
  write_quantities(file, Owner::run, run, {}, {{}}, "", "");
  of_course.points = write_points(file, time, run, length, force);
  write_links(file, run, length);
  write_impacts(file, run);
  write_figure_data(file, figures, length, force);
  if (response.energy) write_energy(file, time, response.energy->histories, force + " " + length);
  write_course(file, of_course, run, length, force);
  return file.finish();
}

}  // namespace bentur
