#include "shell.h"

#include <emscripten/bind.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/core/number_text.h"
#include "bentur/core/units.h"
#include "bentur/io/case/case_memo.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/case/parameter_units.h"
#include "bentur/io/records/record_files.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/io/results/result_json.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/json_schema.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/limits.h"
#include "bentur/report/html/page_parts.h"
#include "bentur/report/html/report.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/story_text.h"
#include "bentur/solve/effort.h"

namespace bentur::web {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

const fs::path folder = "/case";

// A page must not stand still: what a run may take here, where the case itself allows more.
constexpr double most_steps = 5e6;     // some ten seconds of a case of some floors
constexpr double most_memory = 300e6;  // [byte]
constexpr std::size_t most_text = std::size_t{1} << 20;
const char* const text_too_long = "the case is longer than 1 MiB, which is more than a page reads";
constexpr double most_modes = 400;    // of all buildings: their cubes take a second or two
constexpr double most_joints = 1500;  // sways and rotations of a frame, before it is condensed
constexpr double most_levels = 1000;  // of a wall
constexpr std::size_t most_buildings = 100;

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json failure(const std::string& message, int line = 0, int column = 0, const std::string& key = "") {
  return {{"ok", false},
          {"errors", {{{"file", ""}, {"line", line}, {"column", column}, {"key", key}, {"message", message}}}}};
}

Json list_of(const std::vector<Diagnostic>& errors, const std::string& file) {
  Json list = Json::array();
  for (const Diagnostic& one : errors) {
    const bool here = fs::path(one.position.file).filename() == file;
    list.push_back({{"file", here ? "" : fs::path(one.position.file).filename().string()},
                    {"line", one.position.line},
                    {"column", one.position.column},
                    {"key", one.key},
                    {"message", one.message()}});
    if (list.size() == 200) break;
  }
  return list;
}

/// How large a building is, from its text alone; 0 where that is not right.
struct Size {
  double modes = 0, joints = 0, levels = 0;
};

double length_of(const TomlValue& table, const char* key) {
  const TomlValue* list = table.find(key);
  return list == nullptr ? 0 : static_cast<double>(list->items.size());
}

Size size_of(const TomlValue& building) {
  Size size;
  size.levels = length_of(building, "elevations");
  if (const TomlValue* frame = building.find("frame")) {
    const double floors = length_of(*frame, "storey_heights");
    const TomlValue* condensation = frame->find("condensation");
    size.joints = floors * (2 + length_of(*frame, "bay_widths"));
    size.modes = condensation != nullptr && condensation->text == "none" ? size.joints : floors;
  }
  if (const TomlValue* stick = building.find("stick")) size.modes = length_of(*stick, "storey_heights");
  for (const char* const known : {"matrices", "modal"}) {
    if (const TomlValue* one = building.find(known)) size.modes = length_of(*one, "elevations");
  }
  if (const TomlValue* generic = building.find("generic")) {
    const TomlValue* storeys = generic->find("storeys");
    if (storeys != nullptr) size.modes = storeys->real;
  }
  return size;
}

/// What is larger than a page can take without standing still, said before any of it is computed.
std::optional<Json> too_large(const TomlValue& root) {
  const TomlValue* buildings = root.find("building");
  if (buildings == nullptr) return std::nullopt;
  if (buildings->items.size() > most_buildings) {
    const TomlValue& first = buildings->items[most_buildings];
    return failure(fmt::format("the case has {} buildings, over the limit of {} of a page; bentur run takes more",
                               buildings->items.size(), most_buildings),
                   first.line, first.column);
  }
  double modes = 0, most = 0;
  const TomlValue* largest = nullptr;
  const auto name = [&](const TomlValue& building) {
    const TomlValue* given = building.find("name");
    return given == nullptr ? "?" : given->text.substr(0, 60);
  };
  for (const TomlValue& building : buildings->items) {
    const Size size = size_of(building);
    const bool tall = size.levels > most_levels;
    if (tall || size.joints > most_joints) {
      return failure(
          fmt::format("building \"{}\" has {:.0f} {}, over the limit of {:.0f} of a page; bentur run takes more",
                      name(building), tall ? size.levels : size.joints, tall ? "elevations" : "sways and rotations",
                      tall ? most_levels : most_joints),
          building.line, building.column);
    }
    modes += size.modes;
    if (size.modes > most) most = size.modes, largest = &building;
  }
  if (!(modes > most_modes)) return std::nullopt;
  return failure(fmt::format("the buildings have {:.0f} modes together, \"{}\" {:.0f} of them, over the limit of "
                             "{:.0f} of a page; bentur run takes more",
                             modes, name(*largest), most, most_modes),
                 largest->line, largest->column);
}

/// What may go wrong becomes an answer.
template <typename Work>
std::string guarded(const Work& work) {
  try {
    return text_of(work());
  } catch (const std::bad_alloc&) {
    return text_of(failure("there is not enough memory for this case in a browser; bentur run has more"));
  } catch (const InvalidParameter& error) {
    return text_of(failure(error.what(), 0, 0, error.parameter()));
  } catch (const std::exception& error) {
    return text_of(failure(error.what()));
  }
}

/// The largest displacement over that without contact, of floors that move; 0 where none does.
double largest_amplification(const Response& response) {
  double largest = 0;
  for (const BuildingPeaks& peaks : response.buildings) {
    for (Eigen::Index floor = 0; floor < peaks.displacement.size(); ++floor) {
      const double alone = peaks.displacement_no_contact(floor);
      if (alone > 0) largest = std::max(largest, peaks.displacement(floor) / alone);
    }
  }
  return largest;
}

double largest_force(const Response& response) {
  double largest = 0;
  for (const PointSummary& point : response.points) largest = std::max(largest, point.peak_force);
  return largest;
}

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json list(const Eigen::VectorXd& values) {
  Json all = Json::array();
  for (const double value : values) all.push_back(number_or_null(value));
  return all;
}

Json gap_overview(const RunResults& run, Eigen::Index gap) {
  const GapOutcome found = gap_outcome(run.problem, run.response, gap);
  Json one = {
      {"name", gap_name(run.problem, gap)}, {"width", found.governing.width}, {"needed", found.governing.gap_needed}};
  if (found.hardest && run.response.points[*found.hardest].peak_force_time) {
    const PointSummary& worst = run.response.points[*found.hardest];
    one["hardest"] = {{"force", worst.peak_force}, {"elevation", run.problem.points[*found.hardest].elevation}};
  }
  return one;
}

/// What is to be said of the run, in words, the gravest first.
Json statements_of(const RunResults& run, const Words& say) {
  Json all = Json::array();
  for (const SaidStatement& one : said(run_story(run).statements, say)) {
    all.push_back({{"kind", one.kind},
                   {"severity", severity_name(one.severity)},
                   {"gap", one.gap ? Json(gap_name(run.problem, *one.gap)) : Json()},
                   {"badge", one.badge},
                   {"text", one.text}});
  }
  return all;
}

/// The figures that tell something of the run, with their captions.
Json kinds_of(const RunResults& run, const Words& say) {
  Json all = Json::array();
  if (run.response.histories.time.empty()) return all;
  for (const FigureKind& kind : figure_kinds(run)) {
    if (!kind.tells) continue;
    all.push_back({{"kind", kind.name}, {"caption", say("figure." + kind.name)}, {"overTime", kind.over_time}});
  }
  return all;
}

}  // namespace

Studio::Studio() : memo_(std::make_unique<CaseMemo>()) {}
Studio::~Studio() = default;

void Studio::put_file(const std::string& path, const std::string& bytes) {
  std::error_code ignored;  // a case that names it is told that it is not there
  const fs::path file = (folder / "cases" / path).lexically_normal();
  fs::create_directories(file.parent_path(), ignored);
  std::ofstream(file, std::ios::binary) << bytes;
  memo_ = std::make_unique<CaseMemo>();  // what was read from another file of this name is forgotten
  identities_.clear();
}

std::string Studio::open(const std::string& text, const std::string& file) {
  return guarded([&]() -> Json {
    case_.reset(), problem_.reset(), run_.reset(), free_.reset();
    if (text.size() > most_text) return failure(text_too_long);
    const fs::path path = folder / "cases" / file;
    Diagnostics diagnostics;
    const std::optional<TomlValue> root = parse_toml(text, path.string(), diagnostics);
    if (!root) return {{"ok", false}, {"errors", list_of(diagnostics.errors(), file)}};
    if (std::optional<Json> answer = too_large(*root)) return *answer;
    ReadCase read =
        read_case_parts(TomlView(*root, "", path.string(), diagnostics), path.parent_path(), diagnostics, memo_.get());
    if (!diagnostics.ok()) return {{"ok", false}, {"errors", list_of(diagnostics.errors(), file)}};
    Problem problem = read.problem();
    read.c.source = CaseSource{.file = file, .text = text, .sha256 = sha256(text)};
    read.c.given = std::make_shared<const TomlValue>(*root);
    if (auto& record = read.c.excitation.record) {
      const auto known = identities_.try_emplace(record->path);
      if (known.second) known.first->second = identify(record->path);
      record->size = known.first->second.size;
      record->sha256 = known.first->second.sha256;
    }
    case_ = std::move(read.c);
    problem_ = std::move(problem);
    return {{"ok", true}, {"errors", Json::array()}};
  });
}

std::string Studio::in_units(const std::string& text, const std::string& length, const std::string& force) const {
  return guarded([&]() -> Json {
    if (text.size() > most_text) return failure(text_too_long);
    Diagnostics diagnostics;
    const std::optional<std::string> made = text_in_units(text, "", length, force, diagnostics);
    if (!made) return {{"ok", false}, {"errors", list_of(diagnostics.errors(), "")}};
    return {{"ok", true}, {"errors", Json::array()}, {"text", *made}};
  });
}

std::string Studio::schema() const {
  Json units = Json::object();
  for (const std::string& one : length_units()) units["length"][one] = metres(one);
  for (const std::string& one : force_units()) units["force"][one] = newtons(one);
  return fmt::format("{{\"case\": {}, \"units\": {}}}", json_schema(case_keys(), "A case"), text_of(units));
}

std::string Studio::record_unit(const std::string& path) const {
  Diagnostics unread;
  const auto record = read_record(folder / "cases" / path, {}, unread);
  return record ? record->unit : "";
}

std::string Studio::solve(const emscripten::val& output_step, const emscripten::val& progress) {
  return guarded([&]() -> Json {
    run_.reset();
    if (!problem_) return failure("no case is open");
    const Case& c = *case_;
    SolveOptions options = solve_options(c);
    const bool fine = output_step.isNull();
    options.output_step = fine ? report_output_step(*problem_) : output_step.as<double>();
    options.course = fine;
    if (options.output_step < 0) options.output_step = c.analysis.output_step;
    options.most_steps = std::min(options.most_steps, static_cast<long>(most_steps));
    if (!progress.isNull()) options.progress = [&](double done) { return progress(done).as<bool>(); };
    const Effort needed = effort(*problem_, c.analysis.solver, options);
    if (const std::string refused = beyond_limits(c, *problem_, needed); !refused.empty()) return failure(refused);
    if (needed.certain_steps > most_steps) {
      return failure(
          fmt::format("a run takes {:.3g} steps or more, over the limit of {:.3g} of a page. Is a motion so "
                      "fast meant? bentur run may take longer",
                      needed.certain_steps, most_steps));
    }
    if (needed.memory > most_memory) {
      return failure(
          fmt::format("a run takes {:.3g} MB of memory, over the limit of a page. Make the duration shorter, "
                      "or take bentur run",
                      needed.memory / 1e6));
    }
    Response response = bentur::solve(*problem_, c.analysis.solver, options);
    if (response.status == Status::stopped) return failure("stopped");
    if (response.status == Status::failed) return failure("the numbers failed: " + response.message);
    const double seconds = response.wall_time;
    run_ = run_results(c, *problem_, std::move(response));
    if (fine) {
      run_->figures = figures_ = figure_data(*run_, motion_, std::move(figures_));
      motion_ = run_->problem.motion;
    }
    return {{"ok", true}, {"errors", Json::array()}, {"seconds", seconds}};
  });
}

std::string Studio::summary() const { return run_ ? summary_json(*run_, BENTUR_VERSION) : ""; }

std::string Studio::impacts() const { return run_ ? impacts_csv(run_->view()) : ""; }

std::string Studio::gaps() const { return run_ ? gap_json(*run_, BENTUR_VERSION) : ""; }

std::string Studio::modes() const { return run_ ? modes_json(run_->problem.buildings, run_->c.units) : ""; }

std::string Studio::motion(const std::string& language) const { return run_ ? motion_json(*run_, language) : ""; }

std::string Studio::report(const std::string& language) const {
  return run_ ? report_html(*run_, {.language = language, .version = BENTUR_VERSION}) : "";
}

std::string Studio::overview(const std::string& language) const {
  return guarded([&]() -> Json {
    if (!run_) return failure("nothing was run");
    const RunResults& run = *run_;
    const Words say(language);
    Json gaps = Json::array();
    for (const Gap& gap : gaps_of(run.problem)) gaps.push_back(gap_overview(run, gap.left));
    Json buildings = Json::array();
    for (std::size_t b = 0; b < run.problem.buildings.size(); ++b) {
      const Building& building = run.problem.buildings[b];
      const BuildingPeaks& peaks = run.response.buildings[b];
      buildings.push_back({{"name", building.name},
                           {"rigid", building.is_rigid()},
                           {"elevations", building.model.elevations},
                           {"heights", building.model.storey_heights},
                           {"yields", peaks.yielding.ductility.size() > 0},
                           {"displacement", list(peaks.displacement)},
                           {"alone", list(peaks.displacement_no_contact)},
                           {"drift", list(peaks.drift_ratio)}});
    }
    Json impacts = Json::array();
    for (const Impact& one : run.response.impacts) {
      if (impacts.size() == most_impacts) break;
      const ContactPoint& point = run.problem.points[one.point];
      const std::optional<double> e = one.restitution();
      impacts.push_back({point.left, point.elevation, one.start, one.end, one.peak_force, one.closing_speed,
                         e ? number_or_null(*e) : Json()});
    }
    Json points = Json::array();
    for (const ContactPoint& point : run.problem.points) {
      points.push_back({{"gap", point.left}, {"elevation", point.elevation}});
    }
    return {{"ok", true},
            {"title", run.c.title},
            {"version", BENTUR_VERSION},
            {"duration", run.problem.duration},
            {"units", {{"length", run.c.units.length}, {"force", run.c.units.force}}},
            {"gaps", gaps},
            {"buildings", buildings},
            {"points", points},
            {"impacts", impacts},
            {"impactCount", run.response.impacts.size()},
            {"force", largest_force(run.response)},
            {"amplification", largest_amplification(run.response)},
            {"figures", kinds_of(run, say)},
            {"statements", statements_of(run, say)}};
  });
}

std::string Studio::at_width(int gap, double width) {
  return guarded([&]() -> Json {
    if (!problem_) return failure("no case is open");
    Case c = *case_;
    if (gap < 0 || gap >= static_cast<int>(c.gaps.size()))
      throw InvalidParameter("gap", std::to_string(gap), "is no gap");
    std::vector<double>& widths = c.gaps[static_cast<std::size_t>(gap)].widths;
    const double narrowest = *std::min_element(widths.begin(), widths.end());
    for (double& one : widths) one = width + (one - narrowest);
    SolveOptions options;
    options.most_steps = static_cast<long>(std::min(c.analysis.limits.steps, most_steps));
    if (!free_) {
      free_ = std::make_unique<FreeResponse>(*problem_, c.analysis.solver, nullptr, options.most_steps);
    }
    const Response response = free_->solve(make_problem(c, problem_->buildings), options);
    if (response.status == Status::failed) return failure("the numbers failed: " + response.message);
    return {{"ok", true},
            {"errors", Json::array()},
            {"force", largest_force(response)},
            {"amplification", largest_amplification(response)}};
  });
}

}  // namespace bentur::web

EMSCRIPTEN_BINDINGS(bentur) {
  using bentur::web::Studio;
  emscripten::class_<Studio>("Studio")
      .constructor<>()
      .function("putFile", &Studio::put_file)
      .function("open", &Studio::open)
      .function("inUnits", &Studio::in_units)
      .function("schema", &Studio::schema)
      .function("recordUnit", &Studio::record_unit)
      .function("solve", &Studio::solve)
      .function("summary", &Studio::summary)
      .function("impacts", &Studio::impacts)
      .function("gaps", &Studio::gaps)
      .function("modes", &Studio::modes)
      .function("motion", &Studio::motion)
      .function("report", &Studio::report)
      .function("overview", &Studio::overview)
      .function("histories", &Studio::histories)
      .function("draw", &Studio::draw)
      .function("figureFile", &Studio::figure_file)
      .function("atWidth", &Studio::at_width);
}
