#include "bentur/files/result_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "bentur/core/not_known.h"
#include "bentur/files/netcdf.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/file_identity.h"
#include "bentur/io/input_file.h"
#include "bentur/io/json_position.h"
#include "bentur/io/results/judged_by_json.h"
#include "bentur/io/results/plan/plan_variables.h"
#include "bentur/io/results/run_variables.h"
#include "bentur/io/toml/toml_value.h"
#include "bentur/model/plan/plan_row.h"

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
    const bool sine = json.at("phase") == "sine", is_reversed = json.value("polarity", "") == "reversed";
    const double amplitude = json.at("displacement_amplitude");
    spec.motion = HarmonicMotion{.period = json.at("period"),
                                 .displacement_amplitude = is_reversed ? -amplitude : amplitude,
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

Remark remark(const UnorderedJson& json) {
  const auto side = [&](std::size_t i) {
    const UnorderedJson& value = json.at("usual").at(i);
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
  };
  return {json.at("key"), json.at("subject"),        json.at("value"), json.at("unit"), side(0),
          side(1),        json.value("doubt", false)};
}

/// Of one watched floor, an entry of a gap's JSON.
WatchedSummary watched_summary(const UnorderedJson& entry, const UnorderedJson& gap) {
  const auto number = [&](const char* key) {
    const auto value = entry.find(key);
    return value == entry.end() || value->is_null() ? not_known : value->get<double>();
  };
  WatchedSummary summary{.gap_needed = number("gap_needed"),
                         .peak_left = number("peak_left_no_contact"),
                         .peak_right = number("peak_right_no_contact"),
                         .least_opening = entry.at("least_opening"),
                         .least_time = entry.at("time")};
  if (const double reversed = number("gap_needed_reversed"); !std::isnan(reversed)) {
    summary.gap_needed_reversed = reversed;
  }
  const auto& met = gap.at("unmodelled_contact");
  summary.closes = std::any_of(met.begin(), met.end(), [&](const UnorderedJson& one) {
    return one.at("floor_of") == entry.at("floor_of") && one.at("elevation") == entry.at("elevation") &&
           one.value("at", UnorderedJson()) == entry.value("at", UnorderedJson());
  });
  return summary;
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
    floor.left = gap.left;
    floor.right = gap.right;
    floor.gap = gap.number;
    floor.floor_of = of_left ? gap.left : gap.right;
    floor.elevation = entry.at("elevation");
    floor.width = entry.at("width");
    floor.floor = nearest_floor(problem.buildings.at(floor.floor_of), floor.elevation);
    if (entry.at("faces") == "floor") {
      floor.facing_floor = nearest_floor(problem.buildings.at(floor.faced()), floor.elevation);
    }
    results.problem.watched.push_back(floor);
    results.response.watched.push_back(watched_summary(entry, json));
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

/// What solving took, of a row's response or one in plan.
template <class Of>
void read_solved(const UnorderedJson& solved, Of& response) {
  response.steps = solved.at("steps");
  response.events = solved.at("events");
  if (!response.energy || solved.at("energy_residual").is_null()) return;
  response.energy->peak_input = solved.at("peak_input_energy");
  response.energy->residual = response.energy->peak_input * solved.at("energy_residual").template get<double>();
}

/// @param lowest number of the lowest storey of a building
template <class Buildings, class Lowest, class Of>
void read_collapses(const UnorderedJson& json, const fs::path& file, const Buildings& buildings, const Lowest& lowest,
                    Of& response) {
  const auto collapse = [&](const char* key) -> std::optional<Collapse> {
    if (!json.contains(key)) return std::nullopt;
    const UnorderedJson& told = json.at(key);
    const auto named = std::find_if(buildings.begin(), buildings.end(),
                                    [&](const auto& building) { return told.at("building") == building.name; });
    if (named == buildings.end()) fail(file, "names a building that collapsed and is not there");
    const Eigen::Index storey = told.at("storey");
    return Collapse{named - buildings.begin(), storey - lowest(*named), told.at("time")};
  };
  response.collapse = collapse("collapse");
  response.collapse_no_contact = collapse("collapse_no_contact");
  if (response.collapse) response.status = Status::collapsed;
}

void read_summary(const UnorderedJson& json, const fs::path& file, RunResults& results) {
  results.c.title = json.at("title");
  results.c.units.length = json.at("units").at("length");
  results.c.units.force = json.at("units").at("force");
  results.c.units.gravity = standard_gravity(results.c.units.length);
  results.c.excitation = excitation(json.at("excitation"));
  const UnorderedJson& solved = json.at("solver");
  results.c.analysis.solver = solver(solved);
  read_solved(solved, results.response);
  for (const UnorderedJson& entry : json.at("remarks")) results.remarks.push_back(remark(entry));
  if (json.at("buildings").size() != results.problem.buildings.size()) {
    fail(file, "is not of the same run as histories.nc");
  }
  for (std::size_t b = 0; b < results.problem.buildings.size(); ++b) {
    const UnorderedJson& building = json.at("buildings").at(b);
    if (!building.contains("stiffness_factor")) continue;
    results.problem.buildings[b].model.stiffness_factor = building.at("stiffness_factor").get<double>();
  }
  read_collapses(
      json, file, results.problem.buildings, [](const Building& building) { return building.model.storey_number(0); },
      results.response);
  for (const Gap& gap : gaps_of(results.problem)) read_gap(json.at("gaps").at(gap.number), gap, file, results);
  std::size_t links = 0;
  for (const UnorderedJson& table : json.value("links", UnorderedJson::array())) {
    read_link_table(table, links, file, results);
    links += table.at("points").size();
  }
  if (links != results.problem.links.size()) fail(file, "is not of the same run as histories.nc");
  take_judged_by(json.at("judged_by"), results.response);
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
    return a.gap == b.gap && a.elevation == b.elevation && a.width == b.width;
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

/// Which of the watched floors the nearest one of the figures is: histories.nc names it by building and level.
void number_nearest(const fs::path& file, RunResults& results) {
  std::optional<NearestFloor>& nearest = results.figures.nearest;
  if (!nearest) return;
  const std::vector<WatchedFloor>& watched = results.problem.watched;
  const auto same = std::find_if(watched.begin(), watched.end(), [&](const WatchedFloor& one) {
    return one.gap == nearest->gap && one.floor_of == nearest->floor_of && one.floor == nearest->floor;
  });
  if (same == watched.end()) fail(file, "is not of the same run as histories.nc");
  nearest->watched = same - watched.begin();
}

/// Of the watched floors of plans, which the problem has in the summary's order.
void read_plan_watched(const UnorderedJson& gaps, const fs::path& file, PlanRun& run) {
  for (std::size_t g = 0; g < run.problem.gaps.size(); ++g) {
    const UnorderedJson& json = gaps.at(g);
    const UnorderedJson& floors = json.at("watched_floors");
    if (floors.size() != run.problem.gaps[g].watched.size()) fail(file, "is not of the same run as histories.nc");
    for (const UnorderedJson& entry : floors) run.response.watched.push_back(watched_summary(entry, json));
  }
}

/// What a summary of buildings in plan says that is neither in the case nor in histories.nc.
void read_plan_summary(const UnorderedJson& json, const fs::path& file, PlanRun& run) {
  read_plan_watched(json.at("gaps"), file, run);
  const UnorderedJson& along_x = json.at("excitation");
  UnorderedJson along_y = along_x.at("y");
  for (const char* key : {"delays", "kinematics"}) along_y[key] = along_x.at(key);
  double longest = 0;
  for (const auto& [of, told] :
       {std::pair(&run.c.excitation, &along_x), std::pair(&run.c.excitation_y, &std::as_const(along_y))}) {
    if (told->at("kind") != "record") continue;
    of->record = excitation(*told).record;
    longest = std::max(longest, of->record->duration);
  }
  const TomlValue* const analysis = run.c.given->find("analysis");
  if (longest > 0 && (analysis == nullptr || analysis->find("duration") == nullptr)) {
    run.c.analysis.duration = run.problem.duration = longest;
  }
  read_solved(json.at("solver"), run.response);
  read_collapses(
      json, file, run.problem.buildings, [](const PlanBuilding&) { return Eigen::Index(1); }, run.response);
  if (!run.response.collapse) run.problem.duration = json.at("solver").at("end_time");
  run.response.duration = run.problem.duration;
  run.response.drifts_elsewhere = take_judged_by(json.at("judged_by"), run.response);
  for (const UnorderedJson& entry : json.at("remarks")) run.remarks.push_back(remark(entry));
  for (const UnorderedJson& one : json.at("discrepancies")) {
    run.response.discrepancies.push_back({one.at("key"), one.at("size")});
  }
}

/// Calls `read` with the JSON of a summary's text. @throws std::runtime_error where it is none
template <class Read>
void with_summary(const fs::path& file, const std::string& text, const Read& read) {
  try {
    read(UnorderedJson::parse(text));
  } catch (const UnorderedJson::parse_error& error) {
    const SourcePosition at = json_position(file.string(), text, error.byte);
    fail(fmt::format("{}:{}:{}", at.file, at.line, at.column), no_json);
  } catch (const UnorderedJson::exception&) {
    fail(file, "is JSON, but lacks what a summary of bentur run has");
  }
}

/// The hash of the case that a summary is of; empty where it is of none.
std::string hash_of_case(const UnorderedJson& json) {
  return json.contains("case") && json["case"].is_object() ? json["case"].value("sha256", "") : "";
}

}  // namespace

RunResults read_results(const fs::path& folder) {
  const fs::path summary = folder / "summary.json";
  const std::string text = contents(summary);
  const NetcdfReader histories(folder / "histories.nc");
  RunResults results = read_run(histories);
  with_summary(summary, text, [&](const UnorderedJson& json) {
    if (histories.attribute("case_sha256") != hash_of_case(json)) {
      fail(histories.name(), "is not of the same run as summary.json");
    }
    read_summary(json, summary, results);
    take_case(folder / "case.toml", json, results);
    number_nearest(summary, results);
    results.c.code.is_known = results.c.given != nullptr || hash_of_case(json).empty();
  });
  return results;
}

namespace {

PlanRun plan_of(const NetcdfReader& histories) {
  const fs::path folder = fs::path(histories.name()).parent_path();
  const fs::path file = folder / "case.toml";
  const std::string text = contents(file);
  const std::string hash = sha256(text);
  if (histories.attribute("case_sha256") != hash) fail(histories.name(), "is not of the case that stands beside it");
  Diagnostics diagnostics;
  PlanRun run;
  MadeParts made;
  std::optional<Case> c = read_case_without_record(text, file, diagnostics, &made);
  if (!c && !diagnostics.ok()) throw std::runtime_error(diagnostics.errors().front().text());
  if (!c || !c->is_in_plan()) fail(file, "is no case of buildings in plan of this version");
  run.c = *std::move(c);
  run.problem = std::move(made.plan);
  if (const std::string name = histories.attribute("case_file"); !name.empty()) run.c.source->file = name;
  read_plan_response(histories, run);
  const fs::path summary = folder / "summary.json";
  with_summary(summary, contents(summary), [&](const UnorderedJson& json) {
    if (hash_of_case(json) != hash) fail(summary, "is not of the same run as histories.nc");
    read_plan_summary(json, summary, run);
  });
  run.row = row_of(run);
  return run;
}

}  // namespace

PlanRun read_plan_results(const fs::path& folder) { return plan_of(NetcdfReader(folder / "histories.nc")); }

AnyRun read_any_results(const NetcdfReader& histories) {
  if (is_plan_run(histories)) return plan_of(histories);
  const fs::path file = histories.name(), folder = file.parent_path();
  // With its summary all that was found: what floors need that no contact is modelled with is there alone.
  const bool is_whole = file.filename() == "histories.nc" && fs::exists(folder / "summary.json");
  return is_whole ? read_results(folder) : read_run(histories);
}

bool is_any_run(const NetcdfReader& results) { return is_run(results) || is_plan_run(results); }

}  // namespace bentur
