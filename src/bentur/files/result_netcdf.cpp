#include "bentur/files/result_netcdf.h"

#include <fmt/format.h>

#include <cstddef>
#include <numbers>
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

void write_building(const NetcdfWriter& file, Dimension time, std::size_t b, const Problem& problem,
                    const Response& response, const std::string& length, const std::string& force) {
  const Histories& histories = response.histories;
  const Building& building = problem.buildings[b];
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
  const BuildingPeaks& peaks = response.buildings.at(b);
  const auto peak = [&](const std::string& name, const Eigen::VectorXd& values, const std::string& what) {
    file.write(name + number, {floors}, by_columns(values), length, what + " of the floors of " + owner);
  };
  peak("peak_displacement", peaks.displacement, "largest displacement relative to the own base");
  peak("peak_displacement_no_contact", peaks.displacement_no_contact, "largest displacement with contact switched off");
  const Eigen::VectorXd periods = 2 * std::numbers::pi * building.modes.omega.cwiseInverse();
  Eigen::MatrixXd shapes = building.modes.shapes.topRows(building.model.floors());
  for (auto shape : shapes.colwise()) {
    if (const double largest = shape.cwiseAbs().maxCoeff(); largest > 0) shape /= largest;
  }
  const Dimension modes = file.dimension("mode" + number, static_cast<std::size_t>(periods.size()));
  file.write("period" + number, {modes}, by_columns(periods), "s", "periods of " + owner);
  file.write("shape" + number, {modes, floors}, by_columns(shapes), "1",
             "sways of the mode shapes, the largest 1, of " + owner);
}

/// Nothing without a contact point: a dimension of size zero would be an unlimited one.
void write_points(const NetcdfWriter& file, Dimension time, const Problem& problem, const Histories& histories,
                  const std::string& length, const std::string& force) {
  if (problem.points.empty()) return;
  std::vector<double> elevations, widths;
  for (const ContactPoint& point : problem.points) {
    elevations.push_back(point.elevation);
    widths.push_back(point.width);
  }
  const Dimension points = file.dimension("point", problem.points.size());
  file.write("point_elevation", {points}, elevations, length, "elevation of the contact points");
  file.write("point_width", {points}, widths, length, "initial opening of the contact points");
  write_point_sides(file, points, problem);
  const Variable opening = file.write("opening", {time, points}, by_columns(histories.opening), length,
                                      "opening of the contact points, negative in contact");
  const Variable contact = file.write("force", {time, points}, by_columns(histories.force), force, "contact force");
  for (const Variable variable : {opening, contact}) {
    file.attribute(variable, "coordinates", "point_elevation point_width point_left point_right");
  }
}

void write_energy(const NetcdfWriter& file, Dimension time, const EnergyHistories& energy, const std::string& units) {
  const auto curve = [&](const std::string& part, const Eigen::VectorXd& values, const std::string& what) {
    file.write("energy_" + part, {time}, by_columns(values), units, what);
  };
  curve("input", energy.input, "energy at the start and work of the ground motion so far");
  curve("kinetic", energy.kinetic, "kinetic energy of the buildings, relative to their bases");
  curve("strain", energy.strain, "strain energy of the buildings");
  curve("damping", energy.damping, "energy lost to the damping of the buildings so far");
  curve("contact_stored", energy.contact_stored, "energy stored in contacts, to be given back");
  curve("contact_lost", energy.contact_lost, "energy lost in contacts so far");
}

/// Nothing without an impact: a dimension of size zero would be an unlimited one.
void write_impacts(const NetcdfWriter& file, const std::vector<Impact>& impacts, const std::string& length,
                   const std::string& force) {
  if (impacts.empty()) return;
  const Dimension dimension = file.dimension("impact", impacts.size());
  std::vector<int> points;
  for (const Impact& impact : impacts) points.push_back(impact.point);
  file.write("impact_point", {dimension}, points, "", "number of the contact point of each impact, counted from 0");
  const auto column = [&](const std::string& name, double Impact::*member, const std::string& units,
                          const std::string& what) {
    std::vector<double> values;
    for (const Impact& impact : impacts) values.push_back(impact.*member);
    file.write("impact_" + name, {dimension}, values, units, what + " of each impact");
  };
  column("start", &Impact::start, "s", "start");
  column("end", &Impact::end, "s", "end");
  column("peak_force", &Impact::peak_force, force, "largest force");
  column("peak_force_time", &Impact::peak_force_time, "s", "time of the largest force");
  column("peak_penetration", &Impact::peak_penetration, length, "largest penetration");
  column("closing_speed", &Impact::closing_speed, length + " s-1", "speed at which the bodies met");
  column("impulse", &Impact::impulse, force + " s", "impulse");
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

FigureData figure_data(const Problem& problem, const Response& response, const Solver& solver) {
  FigureData data;
  data.close_up = close_up(problem, response, solver);
  if (const auto* motion = std::get_if<SampledMotion>(&problem.motion)) {
    data.spectrum_periods = logarithmic_periods(0.02, 5, 201);
    data.spectrum = response_spectrum(*motion, data.spectrum_periods, data.spectrum_damping);
  }
  return data;
}

void write_point_sides(const NetcdfWriter& file, NetcdfWriter::Dimension points, const Problem& problem) {
  for (const std::string side : {"left", "right"}) {
    std::vector<std::string> names;
    for (const ContactPoint& point : problem.points) {
      names.push_back(problem.buildings.at(static_cast<std::size_t>(point.left) + (side == "right" ? 1 : 0)).name);
    }
    file.write("point_" + side, {points}, names, "", "building to the " + side + " of the contact points");
  }
}

std::string histories_netcdf(const Case& c, const Problem& problem, const Response& response, std::string_view version,
                             const FigureData* figures) {
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
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    write_building(file, time, b, problem, response, length, force);
    names.push_back(problem.buildings[b].name);
  }
  const Dimension buildings = file.dimension("building", problem.buildings.size());
  file.write("building_name", {buildings}, names, "", "names of the buildings, left to right");
  file.write("building_delay", {buildings}, delays, "s", "delay of the ground motion at the buildings");
  write_points(file, time, problem, histories, length, force);
  write_impacts(file, response.impacts, length, force);
  if (figures != nullptr) write_figure_data(file, *figures, length, force);
  if (response.energy) write_energy(file, time, response.energy->histories, force + " " + length);
  return file.finish();
}

}  // namespace bentur
