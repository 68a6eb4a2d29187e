#include "bentur/files/result_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "bentur/files/netcdf.h"
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

Eigen::VectorXd vector(const UnorderedJson& json) {
  const auto values = json.get<std::vector<double>>();
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
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

/// Every quantity that a response keeps, from the object that stands for its owner.
void take_quantities(const UnorderedJson& object, Owner owner, std::size_t item, Response& response) {
  const auto number = [](const UnorderedJson& value) { return value.is_null() ? NAN : value.get<double>(); };
  for (const Quantity* quantity : quantities_of(owner)) {
    if (!is_kept(*quantity)) continue;
    const UnorderedJson& value = object.at(std::string(quantity->key));
    if (owner != Owner::floor) put_value(*quantity, number(value), {item, 0}, response);
    for (std::size_t i = 0; owner == Owner::floor && i < value.size(); ++i) {
      put_value(*quantity, number(value[i]), {item, i}, response);
    }
  }
}

/// Names, elevations and periods are in the summary, bases and shapes in the histories.
Building building(const UnorderedJson& json, std::size_t number, const NetcdfReader& histories) {
  Building building;
  building.name = json.at("name");
  StructuralModel& model = building.model;
  model.elevations = json.at("elevations").get<std::vector<double>>();
  double below = histories.numbers(fmt::format("base_elevation_{}", number)).at(0);
  for (const double elevation : model.elevations) {
    model.storey_heights.push_back(elevation - below);
    below = elevation;
  }
  building.modes.omega = 2 * std::numbers::pi * vector(json.at("periods")).cwiseInverse();
  const std::vector<double> shapes = histories.numbers(fmt::format("shape_{}", number));
  if (shapes.size() != model.elevations.size() * static_cast<std::size_t>(building.modes.omega.size())) {
    fail(histories.name(), "is not of the same run as summary.json");
  }
  building.modes.shapes = Eigen::Map<const Eigen::MatrixXd>(shapes.data(), model.floors(), building.modes.omega.size());
  return building;
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

void read_gap(const UnorderedJson& json, std::size_t gap, RunResults& results) {
  GapSpec spec;
  for (const UnorderedJson& entry : json.at("points")) {
    const Building& left = results.problem.buildings.at(gap);
    const Building& right = results.problem.buildings.at(gap + 1);
    ContactPoint point;
    point.left = static_cast<int>(gap);
    point.elevation = entry.at("elevation");
    point.width = entry.at("width");
    point.left_floor = floor_at(left, point.elevation);
    point.right_floor = floor_at(right, point.elevation);
    results.problem.points.push_back(point);
    results.response.points.emplace_back();
    take_quantities(entry, Owner::point, results.response.points.size() - 1, results.response);
    spec.elevations.push_back(point.elevation);
    spec.widths.push_back(point.width);
    for (const auto& [key, value] : entry.at("contact").items()) {
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
    const bool of_left = entry.at("floor_of") == results.problem.buildings.at(gap).name;
    WatchedFloor floor;
    floor.left = static_cast<int>(gap);
    floor.floor_of = floor.left + (of_left ? 0 : 1);
    floor.elevation = entry.at("elevation");
    floor.width = entry.at("width");
    floor.floor = floor_at(results.problem.buildings.at(gap + (of_left ? 0 : 1)), floor.elevation);
    if (entry.at("faces") == "floor") {
      floor.facing_floor = floor_at(results.problem.buildings.at(gap + (of_left ? 1 : 0)), floor.elevation);
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

void read_summary(const UnorderedJson& json, const NetcdfReader& histories, RunResults& results) {
  results.c.title = json.at("title");
  results.c.units.length = json.at("units").at("length");
  results.c.units.force = json.at("units").at("force");
  results.c.units.gravity = standard_gravity(results.c.units.length);
  results.c.excitation = excitation(json.at("excitation"));
  const UnorderedJson& solved = json.at("solver");
  results.c.analysis.solver = solver(solved);
  results.response.steps = solved.at("steps");
  results.response.events = solved.at("events");
  if (!solved.at("energy_residual").is_null()) {
    EnergyAudit audit;
    audit.peak_input = solved.at("peak_input_energy");
    audit.residual = audit.peak_input * solved.at("energy_residual").get<double>();
    results.response.energy = audit;
  }
  for (const UnorderedJson& entry : json.at("remarks")) results.remarks.push_back(remark(entry));
  for (const UnorderedJson& entry : json.at("buildings")) {
    results.problem.buildings.push_back(building(entry, results.problem.buildings.size() + 1, histories));
    results.response.buildings.emplace_back();
    take_quantities(entry, Owner::floor, results.response.buildings.size() - 1, results.response);
  }
  for (const UnorderedJson& entry : json.at("gaps")) read_gap(entry, results.c.gaps.size(), results);
}

/// Cells of one line of RFC 4180 text, from `at` on; `at` goes behind it.
std::vector<std::string> csv_line(const std::string& text, std::size_t& at) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (quoted && c == '"' && at + 1 < text.size() && text[at + 1] == '"') {
      cells.back() += text[++at];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else if (c == '\n' && !quoted) {
      ++at;
      return cells;
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

/// Impacts by the headings of their columns, which may have a unit: "peak_force [kgf]".
void read_impacts(const fs::path& file, const Problem& problem, Response& response) {
  const std::string text = contents(file);
  std::size_t at = 0;
  std::map<std::string, std::size_t> columns;
  for (const std::string& heading : csv_line(text, at))
    columns.emplace(heading.substr(0, heading.find(" [")), columns.size());
  while (at < text.size()) {
    const std::vector<std::string> cells = csv_line(text, at);
    if (cells.size() != columns.size()) fail(file, "is not a list of impacts");
    const auto cell = [&](std::string_view key) -> const std::string& {
      const auto column = columns.find(std::string(key));
      if (column == columns.end()) fail(file, "is not a list of impacts");
      return cells[column->second];
    };
    const auto value = [&](std::string_view key) {
      double number = 0;
      const std::string& digits = cell(key);
      const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
      if (error != std::errc() || end != digits.data() + digits.size())
        fail(file, "\"" + digits + "\" is not a number");
      return number;
    };
    const auto point = std::find_if(problem.points.begin(), problem.points.end(), [&](const ContactPoint& p) {
      const auto left = static_cast<std::size_t>(p.left);
      return problem.buildings[left].name == cell("left") && problem.buildings[left + 1].name == cell("right") &&
             p.elevation == value("elevation");
    });
    if (point == problem.points.end()) fail(file, "is not of the same run as summary.json");
    response.impacts.push_back({.point = static_cast<int>(point - problem.points.begin())});
    for (const Quantity* quantity : quantities_of(Owner::impact)) {
      if (is_kept(*quantity)) put_value(*quantity, value(quantity->key), {response.impacts.size() - 1, 0}, response);
    }
  }
}

/// A table of histories, which the file holds with time as the slower dimension.
Eigen::MatrixXd table(const NetcdfReader& histories, const std::string& variable, std::size_t rows,
                      std::size_t samples) {
  const std::vector<double> values = histories.numbers(variable);
  if (values.size() != rows * samples) fail(histories.name(), "is not of the same run as summary.json");
  return Eigen::Map<const Eigen::MatrixXd>(values.data(), static_cast<Eigen::Index>(rows),
                                           static_cast<Eigen::Index>(samples));
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
  if (problem.buildings.size() != results.problem.buildings.size() ||
      !std::equal(problem.points.begin(), problem.points.end(), results.problem.points.begin(),
                  results.problem.points.end(), same_places)) {
    return;
  }
  const bool from_record = results.c.excitation.record.has_value();
  if (from_record) c->excitation = results.c.excitation;
  c->source->file = source->value("file", c->source->file);
  problem.motion = c->excitation.motion;
  problem.delays = c->excitation.delays;
  results.c = std::move(*c);
  results.problem = std::move(problem);
}

}  // namespace

RunResults read_results(const fs::path& folder) {
  RunResults results;
  const fs::path summary = folder / "summary.json";
  const std::string text = contents(summary);
  const NetcdfReader histories(folder / "histories.nc");
  try {
    const UnorderedJson json = UnorderedJson::parse(text);
    const std::string of_case =
        json.contains("case") && json["case"].is_object() ? json["case"].value("sha256", "") : "";
    if (histories.attribute("case_sha256") != of_case) fail(histories.name(), "is not of the same run as summary.json");
    read_summary(json, histories, results);
    take_case(folder / "case.toml", json, results);
  } catch (const UnorderedJson::exception& error) {
    fail(summary, std::string("is not a summary of bentur run: ") + error.what());
  }
  read_impacts(folder / "impacts.csv", results.problem, results.response);
  Histories& kept = results.response.histories;
  kept.time = histories.numbers("time");
  if (kept.time.empty()) fail(histories.name(), "holds no histories");
  for (std::size_t b = 0; b < results.problem.buildings.size(); ++b) {
    kept.displacement.push_back(table(histories, fmt::format("displacement_{}", b + 1),
                                      results.problem.buildings[b].model.elevations.size(), kept.time.size()));
  }
  if (!results.problem.points.empty()) {
    kept.opening = table(histories, "opening", results.problem.points.size(), kept.time.size());
    kept.force = table(histories, "force", results.problem.points.size(), kept.time.size());
  }
  double end = kept.time.back();  // less than a step before the end of the analysis
  for (const Impact& impact : results.response.impacts) end = std::max(end, impact.end);
  results.problem.duration = results.c.analysis.duration = end;
  long counted = 0;
  for (const PointSummary& point : results.response.points) counted += point.impacts;
  if (counted != static_cast<long>(results.response.impacts.size())) {
    fail(folder / "impacts.csv", "is not of the same run as summary.json");
  }
  return results;
}

}  // namespace bentur
