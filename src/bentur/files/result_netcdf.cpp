#include "bentur/files/result_netcdf.h"

#include <fmt/format.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <variant>
#include <vector>

#include "bentur/model/quantities.h"

namespace bentur {
namespace {

void check(int status) {
  if (status != NC_NOERR) {
    throw std::runtime_error(std::string("histories.nc: ") + nc_strerror(status));
  }
}

/// A NetCDF file in memory; aborted unless its bytes are taken.
class NetcdfFile {
 public:
  NetcdfFile() { check(nc_create_mem("histories.nc", NC_NETCDF4, 0, &id_)); }
  ~NetcdfFile() {
    if (open_) {
      nc_abort(id_);
    }
  }
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;

  [[nodiscard]] int dimension(const std::string& name, std::size_t size) const {
    int dimension = 0;
    check(nc_def_dim(id_, name.c_str(), size, &dimension));
    return dimension;
  }

  /// A variable of type double or string with its two obligatory attributes; `units` empty for texts.
  [[nodiscard]] int variable(const std::string& name, nc_type type, const std::vector<int>& dimensions,
                             const std::string& units, const std::string& long_name) const {
    int variable = 0;
    check(nc_def_var(id_, name.c_str(), type, static_cast<int>(dimensions.size()), dimensions.data(), &variable));
    if (!units.empty()) {
      attribute(variable, "units", units);
    }
    attribute(variable, "long_name", long_name);
    return variable;
  }

  void attribute(int variable, const char* name, const std::string& text) const {
    check(nc_put_att_text(id_, variable, name, text.size(), text.data()));
  }

  /// Defines a variable of doubles and writes all of it, last dimension fastest.
  int write(const std::string& name, const std::vector<int>& dimensions, const double* values, const std::string& units,
            const std::string& long_name) const {
    const int id = variable(name, NC_DOUBLE, dimensions, units, long_name);
    check(nc_put_var_double(id_, id, values));
    return id;
  }

  int write(const std::string& name, const std::vector<int>& dimensions, const std::vector<double>& values,
            const std::string& units, const std::string& long_name) const {
    return write(name, dimensions, values.data(), units, long_name);
  }

  int write(const std::string& name, const std::vector<int>& dimensions, const std::vector<int>& values,
            const std::string& long_name) const {
    const int id = variable(name, NC_INT, dimensions, "", long_name);
    check(nc_put_var_int(id_, id, values.data()));
    return id;
  }

  int write(const std::string& name, int dimension, const std::vector<std::string>& values,
            const std::string& long_name) const {
    const int id = variable(name, NC_STRING, {dimension}, "", long_name);
    std::vector<const char*> texts;
    texts.reserve(values.size());
    for (const std::string& value : values) {
      texts.push_back(value.c_str());
    }
    check(nc_put_var_string(id_, id, texts.data()));
    return id;
  }

  [[nodiscard]] std::string take() {
    NC_memio memory{};
    open_ = false;
    check(nc_close_memio(id_, &memory));
    const std::unique_ptr<void, decltype(&std::free)> owner(memory.memory, &std::free);
    return {static_cast<const char*>(memory.memory), memory.size};
  }

 private:
  int id_ = 0;
  bool open_ = true;
};

void write_building(const NetcdfFile& file, int time, std::size_t b, const Problem& problem, const Response& response,
                    const std::string& length, const std::string& force) {
  const Histories& histories = response.histories;
  const Building& building = problem.buildings[b];
  const std::string number = fmt::format("_{}", b + 1);
  const std::string owner = fmt::format("building \"{}\"", building.name);
  const int floors = file.dimension("elevation" + number, building.model.elevations.size());
  const int elevation = file.write("elevation" + number, {floors}, building.model.elevations.data(), length,
                                   "elevation of the floors of " + owner);
  file.attribute(elevation, "axis", "Z");
  file.attribute(elevation, "positive", "up");
  const auto history = [&](const std::string& name, const Eigen::MatrixXd& values, const std::string& units,
                           const std::string& what) {
    // Floors × samples by columns is time × floors by rows.
    file.write(name + number, {time, floors}, values.data(), units, what + " of the floors of " + owner);
  };
  history("displacement", histories.displacement.at(b), length, "displacement relative to the own base");
  history("velocity", histories.velocity.at(b), length + " s-1", "velocity relative to the own base");
  history("acceleration", histories.acceleration.at(b), length + " s-2", "absolute acceleration");
  const auto storeys = [&](const std::string& name, const Eigen::MatrixXd& values, const std::string& units,
                           const std::string& what) {
    file.write(name + number, {time, floors}, values.data(), units,
               what + " of the storeys of " + owner + ", each by the floor above it");
  };
  storeys("drift_ratio", histories.drift_ratio.at(b), "1", "relative floor displacement over the height");
  storeys("storey_shear", histories.storey_shear.at(b), force,
          "sum of the elastic forces of all floors above the foot");
  const Eigen::VectorXd base_shear = histories.storey_shear.at(b).row(0);
  file.write("base_shear" + number, {time}, base_shear.data(), force, "shear of the lowest storey of " + owner);
  const double base = building.model.elevations.front() - building.model.storey_heights.front();
  file.write("base_elevation" + number, {}, &base, length, "elevation of the base of " + owner);
  const BuildingPeaks& peaks = response.buildings.at(b);
  const auto peak = [&](const std::string& name, const Eigen::VectorXd& values, const std::string& what) {
    file.write(name + number, {floors}, values.data(), length, what + " of the floors of " + owner);
  };
  peak("peak_displacement", peaks.displacement, "largest displacement relative to the own base");
  peak("peak_displacement_no_contact", peaks.displacement_no_contact, "largest displacement with contact switched off");
  const Eigen::VectorXd periods = 2 * std::numbers::pi * building.modes.omega.cwiseInverse();
  Eigen::MatrixXd shapes = building.modes.shapes.topRows(building.model.floors());
  for (auto shape : shapes.colwise()) {
    if (const double largest = shape.cwiseAbs().maxCoeff(); largest > 0) shape /= largest;
  }
  const int modes = file.dimension("mode" + number, static_cast<std::size_t>(periods.size()));
  file.write("period" + number, {modes}, periods.data(), "s", "periods of " + owner);
  file.write("shape" + number, {modes, floors}, shapes.data(), "1",
             "sways of the mode shapes, the largest 1, of " + owner);
}

/// Nothing without a contact point: a dimension of size zero would be an unlimited one.
void write_points(const NetcdfFile& file, int time, const Problem& problem, const Histories& histories,
                  const std::string& length, const std::string& force) {
  if (problem.points.empty()) return;
  std::vector<std::string> left, right;
  std::vector<double> elevations, widths;
  for (const ContactPoint& point : problem.points) {
    left.push_back(problem.buildings[static_cast<std::size_t>(point.left)].name);
    right.push_back(problem.buildings[static_cast<std::size_t>(point.left) + 1].name);
    elevations.push_back(point.elevation);
    widths.push_back(point.width);
  }
  const int points = file.dimension("point", problem.points.size());
  file.write("point_elevation", {points}, elevations.data(), length, "elevation of the contact points");
  file.write("point_width", {points}, widths.data(), length, "initial opening of the contact points");
  file.write("point_left", points, left, "building to the left of the contact points");
  file.write("point_right", points, right, "building to the right of the contact points");
  const int opening = file.write("opening", {time, points}, histories.opening.data(), length,
                                 "opening of the contact points, negative in contact");
  const int contact = file.write("force", {time, points}, histories.force.data(), force, "contact force");
  for (const int variable : {opening, contact}) {
    file.attribute(variable, "coordinates", "point_elevation point_width point_left point_right");
  }
}

void write_energy(const NetcdfFile& file, int time, const EnergyHistories& energy, const std::string& units) {
  const auto curve = [&](const std::string& part, const Eigen::VectorXd& values, const std::string& what) {
    file.write("energy_" + part, {time}, values.data(), units, what);
  };
  curve("input", energy.input, "energy at the start and work of the ground motion so far");
  curve("kinetic", energy.kinetic, "kinetic energy of the buildings, relative to their bases");
  curve("strain", energy.strain, "strain energy of the buildings");
  curve("damping", energy.damping, "energy lost to the damping of the buildings so far");
  curve("contact_stored", energy.contact_stored, "energy stored in contacts, to be given back");
  curve("contact_lost", energy.contact_lost, "energy lost in contacts so far");
}

/// Nothing without an impact: a dimension of size zero would be an unlimited one.
void write_impacts(const NetcdfFile& file, const std::vector<Impact>& impacts, const std::string& length,
                   const std::string& force) {
  if (impacts.empty()) return;
  const int dimension = file.dimension("impact", impacts.size());
  std::vector<int> points;
  for (const Impact& impact : impacts) points.push_back(static_cast<int>(impact.point));
  file.write("impact_point", {dimension}, points, "number of the contact point of each impact, counted from 0");
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

void write_figure_data(const NetcdfFile& file, const FigureData& figures, const std::string& length,
                       const std::string& force) {
  if (const std::optional<CloseUp>& near = figures.close_up) {
    const int time = file.dimension("close_up_time", near->time.size());
    file.write("close_up_impact", {}, std::vector<int>{near->impact}, "number of the impact shown, counted from 0");
    file.write("close_up_time", {time}, near->time, "s", "time of the samples of one impact");
    file.write("close_up_opening", {time}, near->opening, length, "opening of its contact point");
    file.write("close_up_force", {time}, near->force, force, "force of its contact point");
  }
  if (figures.spectrum.empty()) return;
  const int period = file.dimension("spectrum_period", figures.spectrum_periods.size());
  std::vector<double> displacement, acceleration;
  for (const OscillatorPeaks& peaks : figures.spectrum) {
    displacement.push_back(peaks.displacement);
    acceleration.push_back(peaks.pseudo_acceleration);
  }
  file.write("spectrum_period", {period}, figures.spectrum_periods, "s", "period of linear oscillators");
  file.write("spectrum_damping", {}, &figures.spectrum_damping, "1", "damping ratio of linear oscillators");
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

std::string histories_netcdf(const Case& c, const Problem& problem, const Response& response, std::string_view version,
                             const FigureData* figures) {
  const Histories& histories = response.histories;
  const std::string length = udunit(c.units.length);
  const std::string force = udunit(c.units.force);
  NetcdfFile file;
  file.attribute(NC_GLOBAL, "Conventions", "CF-1.8");
  file.attribute(NC_GLOBAL, "title", c.title);
  file.attribute(NC_GLOBAL, "source", fmt::format("seismic pounding analysis, solver {}", name(c.analysis.solver)));
  file.attribute(NC_GLOBAL, "history", fmt::format("written by bentur {}", version));
  if (c.source) {
    file.attribute(NC_GLOBAL, "case_file", c.source->file);
    file.attribute(NC_GLOBAL, "case_sha256", c.source->sha256);
  }
  if (const std::optional<RecordEcho>& record = c.excitation.record; record && !record->sha256.empty()) {
    file.attribute(NC_GLOBAL, "record_file", record->file);
    file.attribute(NC_GLOBAL, "record_size", fmt::format("{}", record->size));
    file.attribute(NC_GLOBAL, "record_sha256", record->sha256);
  }
  const int time = file.dimension("time", histories.time.size());
  const int coordinate = file.write("time", {time}, histories.time.data(), "s", "time");
  file.attribute(coordinate, "axis", "T");
  file.write("ground_acceleration", {time}, histories.ground_acceleration.data(), length + " s-2",
             "ground acceleration without delay");
  std::vector<double> delays = problem.delays;
  delays.resize(problem.buildings.size(), 0.0);
  std::vector<std::string> names;
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    write_building(file, time, b, problem, response, length, force);
    names.push_back(problem.buildings[b].name);
  }
  const int buildings = file.dimension("building", problem.buildings.size());
  file.write("building_name", buildings, names, "names of the buildings, left to right");
  file.write("building_delay", {buildings}, delays.data(), "s", "delay of the ground motion at the buildings");
  write_points(file, time, problem, histories, length, force);
  write_impacts(file, response.impacts, length, force);
  if (figures != nullptr) write_figure_data(file, *figures, length, force);
  if (response.energy) write_energy(file, time, response.energy->histories, force + " " + length);
  return file.take();
}

}  // namespace bentur
