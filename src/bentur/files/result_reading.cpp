#include "bentur/files/result_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/files/result_netcdf.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/file_identity.h"
#include "bentur/io/input_file.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;
using UnorderedJson = nlohmann::json;

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
  throw std::runtime_error(file.string() + ": " + what);
}

std::string contents(const fs::path& file) {
  std::string problem;
  auto text = read_input(file, result_input, problem);
  if (!text) fail(file, problem);
  return *std::move(text);
}

ExcitationSpec excitation(const UnorderedJson& json) {
  ExcitationSpec spec;
  if (json.at("kind") == "record") {
    spec.record = RecordEcho{.file = json.at("file"),
                             .path = {},
                             .size = json.value("size", std::uint64_t{0}),
                             .sha256 = json.value("sha256", ""),
                             .format = json.at("format"),
                             .unit = json.at("unit"),
                             .channel = json.value("channel", ""),
                             .header_lines = json.value("header_lines", 0),
                             .mean_removed = json.value("mean_removed", 0.0),
                             .time_step = json.at("time_step"),
                             .count = json.at("count"),
                             .duration = json.at("duration"),
                             .pga_read = json.at("pga_read"),
                             .reversed = json.value("polarity", "") == "reversed",
                             .pga = json.at("pga")};
  } else if (json.at("kind") == "harmonic") {
    const bool sine = json.at("phase") == "sine";
    spec.motion = HarmonicMotion{.period = json.at("period"),
                                 .displacement_amplitude = json.at("displacement_amplitude"),
                                 .phase = sine ? HarmonicMotion::Phase::sine : HarmonicMotion::Phase::cosine};
  }
  spec.delays = json.at("delays").get<std::vector<double>>();
  spec.kinematics = json.at("kinematics") == "absolute" ? Kinematics::absolute : Kinematics::relative;
  return spec;
}

Solver solver(const UnorderedJson& json) {
  if (json.at("name") == "adaptive") return AdaptiveSolver{.tolerance = json.at("tolerance")};
  if (json.at("name") == "runge-kutta") return RungeKuttaSolver{.step = json.at("step")};
  return ExactSolver{};
}

/// The unit of a case that UDUNITS reads so.
std::string unit_of(const std::string& udunits) { return udunits == udunit("tf") ? "tf" : udunits; }

Eigen::VectorXd vector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Values that the file holds with the other dimension as the slower one.
Eigen::MatrixXd table(const NetcdfReader& file, const std::string& variable, std::size_t rows, std::size_t columns) {
  const std::vector<double> values = file.numbers(variable);
  if (values.size() != rows * columns) throw NetcdfError(file.name(), "variables disagree in size at " + variable);
  return Eigen::Map<const Eigen::MatrixXd>(values.data(), static_cast<Eigen::Index>(rows),
                                           static_cast<Eigen::Index>(columns));
}

/// Every quantity of `owner` that a response keeps, at each of its places.
void take_quantities(const NetcdfReader& file, Owner owner, const std::vector<QuantityPlace>& places,
                     const std::string& suffix, Response& response) {
  for (const Quantity* quantity : quantities_of(owner)) {
    if (!is_kept(*quantity)) continue;
    const std::string name = file_name(*quantity) + suffix;
    const bool of_some =
        is_of_yielding(*quantity) || is_of_foundation(*quantity) || is_of_forces(*quantity) || is_of_columns(*quantity);
    if (of_some && file.find(name) == nullptr) continue;  // nothing can yield, is on soil or is struck between floors
    const std::vector<double> values = file.numbers(name);
    if (values.size() != places.size()) throw NetcdfError(file.name(), "variables disagree in size at " + name);
    for (std::size_t i = 0; i < values.size(); ++i) put_value(*quantity, values[i], places[i], response);
  }
}

Building read_building(const NetcdfReader& file, const std::string& name, const std::string& number) {
  Building building;
  building.name = name;
  StructuralModel& model = building.model;
  model.elevations = file.numbers("elevation" + number);
  double below = file.numbers("base_elevation" + number).at(0);
  for (const double elevation : model.elevations) {
    model.storey_heights.push_back(elevation - below);
    below = elevation;
  }
  if (file.find("period" + number) == nullptr) {  // moves with the ground
    building.modes.shapes = Eigen::MatrixXd::Zero(std::ssize(model.elevations), 0);
    return building;
  }
  model.has_slab = model.storey_heights.front() == 0;
  model.has_soil = file.find("peak_sway" + number) != nullptr;
  const std::vector<double> periods = file.numbers("period" + number);
  building.modes.omega = 2 * std::numbers::pi * vector(periods).cwiseInverse();
  building.modes.shapes = table(file, "shape" + number, model.elevations.size(), periods.size());
  return building;
}

/// Columns of building `b` that are struck between floors.
void read_nodes(const NetcdfReader& file, Eigen::Index b, Building& building, Histories& histories) {
  const std::string number = fmt::format("_{}", b + 1);
  const std::size_t samples = histories.time.size();
  std::size_t nodes = 0;
  if (file.find("node_elevation" + number) != nullptr) {
    building.model.node_elevations = file.numbers("node_elevation" + number);
    nodes = building.model.node_elevations.size();
  }
  Eigen::MatrixXd forces(6 * nodes, samples);
  for (std::size_t end = 0; nodes > 0 && end < column_ends.size(); ++end) {
    const Eigen::MatrixXd values = table(file, std::string(column_ends[end].name) + number, nodes, samples);
    for (Eigen::Index n = 0; n < values.rows(); ++n) forces.row(6 * n + static_cast<Eigen::Index>(end)) = values.row(n);
  }
  histories.node_displacement.push_back(nodes > 0 ? table(file, "node_displacement" + number, nodes, samples)
                                                  : Eigen::MatrixXd(0, samples));
  histories.column_forces.push_back(std::move(forces));
}

/// Which contact points strike columns, of points that have been read.
void read_struck(const NetcdfReader& file, Problem& problem) {
  if (file.find("point_struck") == nullptr) return;
  const std::vector<std::string> names = file.texts("point_struck");
  const std::vector<double> nodes = file.numbers("point_node");
  const std::vector<double> shears = file.numbers("column_shear_capacity");
  const std::vector<double> moments = file.numbers("column_moment_capacity");
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    if (names.at(i).empty()) continue;
    ContactPoint& point = problem.points[i];
    const bool left = problem.buildings.at(point.left).name == names[i];
    const StructuralModel& model = problem.buildings.at(point.left + (left ? 0 : 1)).model;
    if (!(nodes.at(i) < static_cast<double>(model.nodes()))) {
      throw NetcdfError(file.name(), "a floor strikes a column that is not in it");
    }
    (left ? point.left_floor : point.right_floor) = model.floors() + static_cast<Eigen::Index>(nodes[i]);
    point.column_shear_capacity = shears.at(i);
    point.column_moment_capacity = moments.at(i);
  }
}

int floor_at(const Building& building, double elevation) {
  const std::vector<double>& floors = building.model.elevations;
  const auto near = std::min_element(floors.begin(), floors.end(), [&](double a, double b) {
    return std::abs(a - elevation) < std::abs(b - elevation);
  });
  return static_cast<int>(near - floors.begin());
}

Remark remark(const UnorderedJson& json) {
  const auto side = [&](std::size_t i) {
    const UnorderedJson& value = json.at("usual").at(i);
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
  };
  return {json.at("key"), json.at("subject"), json.at("value"), json.at("unit"), side(0), side(1)};
}

/// What the laws of a gap worked with, and its watched floors.
void read_gap(const UnorderedJson& json, const Gap& gap, const fs::path& file, RunResults& results) {
  const Problem& problem = results.problem;
  GapSpec spec;
  const UnorderedJson& points = json.at("points");
  if (points.size() != gap.points.size()) fail(file, "is not of the same run as histories.nc");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ContactPoint& point = problem.points[gap.points[i]];
    spec.elevations.push_back(point.elevation);
    spec.widths.push_back(point.width);
    for (const auto& [key, value] : points[i].at("contact").items()) {
      if (value.is_number()) {
        spec.contact.numbers[key].push_back(value);
      } else if (key == "law") {
        spec.contact.law = value;
      } else {
        spec.contact.words[key] = value;
      }
    }
  }
  for (const UnorderedJson& entry : json.value("watched_floors", UnorderedJson::array())) {
    const bool of_left = entry.at("floor_of") == problem.buildings.at(gap.left).name;
    WatchedFloor floor;
    floor.left = static_cast<int>(gap.left);
    floor.floor_of = floor.left + (of_left ? 0 : 1);
    floor.elevation = entry.at("elevation");
    floor.width = entry.at("width");
    floor.floor = floor_at(problem.buildings.at(gap.left + (of_left ? 0 : 1)), floor.elevation);
    if (entry.at("faces") == "floor") {
      floor.facing_floor = floor_at(problem.buildings.at(gap.left + (of_left ? 1 : 0)), floor.elevation);
    }
    WatchedSummary summary{.needed = entry.at("minimum_gap_no_contact"),
                           .least_opening = entry.at("least_opening"),
                           .least_time = entry.at("time")};
    const auto& met = json.at("unmodelled_contact");
    summary.closes = std::any_of(met.begin(), met.end(), [&](const UnorderedJson& one) {
      return one.at("floor_of") == entry.at("floor_of") && one.at("elevation") == entry.at("elevation");
    });
    results.problem.watched.push_back(floor);
    results.response.watched.push_back(summary);
  }
  if (spec.elevations.empty() && !results.problem.watched.empty()) {
    spec.widths = {results.problem.watched.back().width};
  }
  results.c.gaps.push_back(spec);
}

/// What the laws of one [[link]] table worked with. @param first of its links in the problem
void read_link_table(const UnorderedJson& json, std::size_t first, const fs::path& file, RunResults& results) {
  LinkSpec spec;
  for (const UnorderedJson& point : json.at("points")) {
    if (first >= results.problem.links.size()) fail(file, "is not of the same run as histories.nc");
    const Link& link = results.problem.links[first++];
    spec.left = static_cast<std::size_t>(link.left);
    spec.right = static_cast<std::size_t>(link.right);
    spec.elevations.push_back(link.elevation);
    for (const auto& [key, value] : point.at("link").items()) {
      if (value.is_number()) {
        spec.numbers[key].push_back(value);
      } else {
        spec.law = value;
      }
    }
  }
  results.c.links.push_back(std::move(spec));
}

void read_summary(const UnorderedJson& json, const fs::path& file, RunResults& results) {
  results.c.title = json.at("title");
  results.c.units.length = json.at("units").at("length");
  results.c.units.force = json.at("units").at("force");
  results.c.units.gravity = standard_gravity(results.c.units.length);
  results.c.excitation = excitation(json.at("excitation"));
  const UnorderedJson& solved = json.at("solver");
  results.c.analysis.solver = solver(solved);
  results.response.steps = solved.at("steps");
  results.response.events = solved.at("events");
  if (results.response.energy && !solved.at("energy_residual").is_null()) {
    EnergyAudit& audit = *results.response.energy;
    audit.peak_input = solved.at("peak_input_energy");
    audit.residual = audit.peak_input * solved.at("energy_residual").get<double>();
  }
  for (const UnorderedJson& entry : json.at("remarks")) results.remarks.push_back(remark(entry));
  if (json.at("buildings").size() != results.problem.buildings.size()) {
    fail(file, "is not of the same run as histories.nc");
  }
  for (std::size_t b = 0; b < results.problem.buildings.size(); ++b) {
    const UnorderedJson& building = json.at("buildings").at(b);
    if (!building.contains("stiffness_factor")) continue;
    results.problem.buildings[b].model.stiffness_factor = building.at("stiffness_factor").get<double>();
  }
  const auto collapse = [&](const char* key) -> std::optional<Collapse> {
    if (!json.contains(key)) return std::nullopt;
    const UnorderedJson& told = json.at(key);
    const std::vector<Building>& buildings = results.problem.buildings;
    const auto named = std::find_if(buildings.begin(), buildings.end(),
                                    [&](const Building& building) { return told.at("building") == building.name; });
    if (named == buildings.end()) fail(file, "names a building that collapsed and is not there");
    const Eigen::Index storey = told.at("storey");
    return Collapse{named - buildings.begin(), storey - named->model.storey_number(0), told.at("time")};
  };
  results.response.collapse = collapse("collapse");
  results.response.collapse_no_contact = collapse("collapse_no_contact");
  if (results.response.collapse) results.response.status = Status::collapsed;
  for (const Gap& gap : gaps_of(results.problem)) read_gap(json.at("gaps").at(gap.left), gap, file, results);
  std::size_t links = 0;
  for (const UnorderedJson& table : json.value("links", UnorderedJson::array())) {
    read_link_table(table, links, file, results);
    links += table.at("points").size();
  }
  if (links != results.problem.links.size()) fail(file, "is not of the same run as histories.nc");
}

void read_points(const NetcdfReader& file, RunResults& results) {
  Problem& problem = results.problem;
  const std::vector<std::string> left = file.texts("point_left");
  const std::vector<double> elevations = file.numbers("point_elevation"), widths = file.numbers("point_width");
  for (std::size_t i = 0; i < left.size(); ++i) {
    const auto named = std::find_if(problem.buildings.begin(), problem.buildings.end(),
                                    [&](const Building& building) { return building.name == left[i]; });
    if (problem.buildings.end() - named < 2) {
      throw NetcdfError(file.name(), "its contact points name no building of it");
    }
    ContactPoint point;
    point.left = static_cast<int>(named - problem.buildings.begin());
    point.elevation = elevations.at(i);
    point.width = widths.at(i);
    point.left_floor = floor_at(named[0], point.elevation);
    point.right_floor = floor_at(named[1], point.elevation);
    problem.points.push_back(point);
  }
  read_struck(file, problem);
  Response& response = results.response;
  response.points.resize(left.size());
  take_quantities(file, Owner::point, first_places(std::ssize(left)), "", response);
  response.histories.opening = table(file, "opening", left.size(), response.histories.time.size());
  response.histories.force = table(file, "force", left.size(), response.histories.time.size());
  if (file.find("impact_point") == nullptr) return;
  for (const double point : file.numbers("impact_point")) {
    if (!(point < static_cast<double>(left.size()))) throw NetcdfError(file.name(), "an impact is at no point of it");
    response.impacts.push_back({.point = static_cast<int>(point)});
  }
  take_quantities(file, Owner::impact, first_places(std::ssize(response.impacts)), "", response);
}

/// Links without laws.
void read_links(const NetcdfReader& file, RunResults& results) {
  Problem& problem = results.problem;
  const std::vector<std::string> left = file.texts("link_left"), right = file.texts("link_right");
  const std::vector<double> elevations = file.numbers("link_elevation");
  const auto building = [&](const std::string& name) {
    const auto named = std::find_if(problem.buildings.begin(), problem.buildings.end(),
                                    [&](const Building& one) { return one.name == name; });
    if (named == problem.buildings.end()) throw NetcdfError(file.name(), "its links name no building of it");
    return named - problem.buildings.begin();
  };
  for (std::size_t i = 0; i < left.size(); ++i) {
    Link link;
    link.left = building(left[i]);
    link.right = building(right.at(i));
    link.elevation = elevations.at(i);
    link.left_floor = floor_at(problem.buildings[link.left], link.elevation);
    link.right_floor = floor_at(problem.buildings[link.right], link.elevation);
    problem.links.push_back(link);
  }
  results.response.links.resize(left.size());
  take_quantities(file, Owner::link, first_places(std::ssize(left)), "", results.response);
}

EnergyHistories read_energy(const NetcdfReader& file) {
  const auto part = [&](const char* name) { return vector(file.numbers(std::string("energy_") + name)); };
  return {.input = part("input"),
          .kinetic = part("kinetic"),
          .strain = part("strain"),
          .damping = part("damping"),
          .hysteretic = part("hysteretic"),
          .contact_stored = part("contact_stored"),
          .contact_lost = part("contact_lost")};
}

FigureData read_figure_data(const NetcdfReader& file) {
  FigureData data;
  if (file.find("close_up_time") != nullptr) {
    data.close_up = CloseUp{.impact = static_cast<int>(file.numbers("close_up_impact").at(0)),
                            .time = file.numbers("close_up_time"),
                            .opening = file.numbers("close_up_opening"),
                            .force = file.numbers("close_up_force")};
  }
  if (file.find("spectrum_period") == nullptr) return data;
  data.spectrum_damping = file.numbers("spectrum_damping").at(0);
  data.spectrum_periods = file.numbers("spectrum_period");
  const std::vector<double> displacement = file.numbers("spectrum_displacement");
  const std::vector<double> acceleration = file.numbers("spectrum_acceleration");
  for (std::size_t i = 0; i < data.spectrum_periods.size(); ++i) {
    data.spectrum.push_back({.displacement = displacement.at(i), .pseudo_acceleration = acceleration.at(i)});
  }
  return data;
}

/// Takes buildings, gaps and codes as they were given from the copy of the case, if it is that of these results.
void take_case(const fs::path& file, const UnorderedJson& summary, RunResults& results) {
  std::error_code failed;
  const auto source = summary.find("case");
  if (source == summary.end() || !source->is_object() || !fs::is_regular_file(file, failed)) return;
  const std::string text = contents(file);
  if (source->value("sha256", "") != sha256(text)) return;
  Diagnostics diagnostics;
  std::optional<Case> c = read_case_without_record(text, file, diagnostics);
  if (!c) return;
  Problem problem = make_problem(*c);
  const auto same_places = [](const ContactPoint& a, const ContactPoint& b) {
    return a.left == b.left && a.elevation == b.elevation && a.width == b.width;
  };
  const auto same_links = [](const Link& a, const Link& b) {
    return a.left == b.left && a.right == b.right && a.elevation == b.elevation;
  };
  if (problem.buildings.size() != results.problem.buildings.size() ||
      !std::equal(problem.links.begin(), problem.links.end(), results.problem.links.begin(),
                  results.problem.links.end(), same_links) ||
      !std::equal(problem.points.begin(), problem.points.end(), results.problem.points.begin(),
                  results.problem.points.end(), same_places)) {
    return;
  }
  const bool from_record = results.c.excitation.record.has_value();
  if (from_record) c->excitation = results.c.excitation;
  c->source->file = source->value("file", c->source->file);
  problem.motion = c->excitation.motion;
  problem.delays = c->excitation.delays;
  problem.duration = c->analysis.duration = results.problem.duration;
  results.c = std::move(*c);
  results.problem = std::move(problem);
}

void read_course(const NetcdfReader& file, Response& response) {
  Histories& course = response.course;
  course.time = file.numbers("exact/time");
  const Eigen::Index count = std::ssize(course.time);
  const auto read = [&](const std::string& name) {
    const NetcdfVariable* variable = file.find("exact/" + name);
    if (variable == nullptr) return Eigen::MatrixXd();
    return table(file, variable->name, variable->shape.back(), course.time.size());
  };
  for (std::size_t b = 0; b < response.buildings.size(); ++b) {
    const std::string number = fmt::format("_{}", b + 1);
    course.displacement.push_back(read("displacement" + number));
    course.drift_ratio.push_back(read("drift_ratio" + number));
    course.storey_shear.push_back(read("storey_shear" + number));
    course.node_displacement.push_back(read("node_displacement" + number));
    if (course.node_displacement.back().size() == 0) course.node_displacement.back().resize(0, count);
  }
  course.opening = read("opening");
  course.force = read("force");
}

}  // namespace

bool is_histories(const NetcdfReader& file) {
  return file.find("displacement_1") != nullptr && file.find("base_elevation_1") != nullptr &&
         file.find("gap_needed") != nullptr;
}

RunResults read_histories(const NetcdfReader& file) {
  RunResults results;
  results.c.title = file.attribute("title");
  results.c.units.length = unit_of(file.at("displacement_1").units);
  results.c.units.force = unit_of(file.at("storey_shear_1").units);
  Problem& problem = results.problem;
  Response& response = results.response;
  response.histories.time = file.numbers("time");
  if (response.histories.time.empty()) throw NetcdfError(file.name(), "holds no histories");
  for (const std::string& name : file.texts("building_name")) {
    const Eigen::Index b = std::ssize(problem.buildings);
    const std::string number = fmt::format("_{}", b + 1);
    problem.buildings.push_back(read_building(file, name, number));
    const std::size_t floors = problem.buildings.back().model.elevations.size();
    response.buildings.emplace_back();
    take_quantities(file, Owner::floor, floors_of(problem, b), number, response);
    take_quantities(file, Owner::building, {{b, 0}}, number, response);
    Histories& histories = response.histories;
    const auto history = [&](const char* quantity) {
      return table(file, quantity + number, floors, histories.time.size());
    };
    histories.displacement.push_back(history("displacement"));
    histories.drift_ratio.push_back(history("drift_ratio"));
    histories.storey_shear.push_back(history("storey_shear"));
    read_nodes(file, b, problem.buildings.back(), histories);
  }
  if (file.find("exact/time") != nullptr) read_course(file, response);
  if (file.find("opening") != nullptr) read_points(file, results);  // else no contact is modelled
  if (file.find("link_left") != nullptr) read_links(file, results);
  if (file.find("energy_input") != nullptr) response.energy = EnergyAudit{.histories = read_energy(file)};
  results.figures = read_figure_data(file);
  problem.duration = response.histories.time.back();  // less than a step before the end of the analysis
  for (const Impact& impact : response.impacts) problem.duration = std::max(problem.duration, impact.end);
  results.c.analysis.duration = problem.duration;
  return results;
}

RunResults read_results(const fs::path& folder) {
  const fs::path summary = folder / "summary.json";
  const std::string text = contents(summary);
  const NetcdfReader histories(folder / "histories.nc");
  RunResults results = read_histories(histories);
  try {
    const UnorderedJson json = UnorderedJson::parse(text);
    const std::string of_case =
        json.contains("case") && json["case"].is_object() ? json["case"].value("sha256", "") : "";
    if (histories.attribute("case_sha256") != of_case) fail(histories.name(), "is not of the same run as summary.json");
    read_summary(json, summary, results);
    take_case(folder / "case.toml", json, results);
  } catch (const UnorderedJson::exception& error) {
    fail(summary, std::string("is not a summary of bentur run: ") + error.what());
  }
  return results;
}

}  // namespace bentur
