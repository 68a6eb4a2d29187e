#include "bentur/io/results/result_netcdf.h"

#include <fmt/format.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <vector>

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

/// The unit as UDUNITS knows it: tf would be unknown, since its ton_force is the short one.
std::string udunit(const std::string& unit) { return unit == "tf" ? "1000 kgf" : unit; }

void write_building(const NetcdfFile& file, int time, std::size_t b, const Problem& problem, const Histories& histories,
                    const std::string& length) {
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
}

void write_points(const NetcdfFile& file, int time, const Problem& problem, const Histories& histories,
                  const std::string& length, const std::string& force) {
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

}  // namespace

std::string histories_netcdf(const Case& c, const Problem& problem, const Response& response,
                             std::string_view version) {
  const Histories& histories = response.histories;
  const std::string length = udunit(c.units.length);
  const std::string force = udunit(c.units.force);
  NetcdfFile file;
  file.attribute(NC_GLOBAL, "Conventions", "CF-1.8");
  file.attribute(NC_GLOBAL, "title", c.title);
  file.attribute(NC_GLOBAL, "source", fmt::format("seismic pounding analysis, solver {}", name(c.analysis.solver)));
  file.attribute(NC_GLOBAL, "history", fmt::format("written by bentur {}", version));
  const int time = file.dimension("time", histories.time.size());
  const int coordinate = file.write("time", {time}, histories.time.data(), "s", "time");
  file.attribute(coordinate, "axis", "T");
  file.write("ground_acceleration", {time}, histories.ground_acceleration.data(), length + " s-2",
             "ground acceleration without delay");
  std::vector<double> delays = problem.delays;
  delays.resize(problem.buildings.size(), 0.0);
  std::vector<std::string> names;
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    write_building(file, time, b, problem, histories, length);
    names.push_back(problem.buildings[b].name);
  }
  const int buildings = file.dimension("building", problem.buildings.size());
  file.write("building_name", buildings, names, "names of the buildings, left to right");
  file.write("building_delay", {buildings}, delays.data(), "s", "delay of the ground motion at the buildings");
  write_points(file, time, problem, histories, length, force);
  if (response.energy) write_energy(file, time, response.energy->histories, force + " " + length);
  return file.take();
}

}  // namespace bentur
