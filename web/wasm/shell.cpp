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
#include "bentur/core/version.h"
#include "bentur/io/case/case_memo.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/io/results/result_json.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/json_schema.h"
#include "bentur/io/schema/parameter_units.h"
#include "bentur/model/limits.h"
#include "bentur/model/plan/plan_dense_run.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/pounding/pounding.h"
#include "bentur/report/html/page_parts.h"
#include "bentur/report/html/report.h"
#include "bentur/report/html/report.h"
#include "bentur/report/html/spectral_report.h"
#include "bentur/report/html/suite_report.h"
#include "bentur/report/kinds/kinds.h"
#include "shell_answers.h"

namespace bentur::web {
namespace {

namespace fs = std::filesystem;

const fs::path folder = case_folder;

constexpr std::size_t most_text = std::size_t{1} << 20;
constexpr double most_modes = 400;    // of all buildings: their cubes take a second or two
constexpr double most_joints = 1500;  // sways and rotations of a frame, before it is condensed
constexpr double most_levels = 1000;  // of a wall
constexpr std::size_t most_buildings = 100;

Json list_of(const std::vector<Diagnostic>& errors, const std::string& file) {
  Json list = Json::array();
  for (const Diagnostic& one : errors) {
    const bool here = fs::path(one.position.file).filename() == file;
    list.push_back(error_of(one, here ? "" : fs::path(one.position.file).filename().string()));
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
  // Also beside matrices or modes, which then have no floors of their own.
  if (const TomlValue* plan = building.find("plan")) size.modes = 3 * length_of(*plan, "storey_heights");
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
    return too_much("buildings", {{"n", buildings->items.size()}, {"most", most_buildings}}, first.line, first.column);
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
      return too_much(tall ? "elevations" : "joints",
                      {{"name", name(building)},
                       {"n", tall ? size.levels : size.joints},
                       {"most", tall ? most_levels : most_joints}},
                      building.line, building.column);
    }
    modes += size.modes;
    if (size.modes > most) most = size.modes, largest = &building;
  }
  if (!(modes > most_modes)) return std::nullopt;
  return too_much("modes", {{"n", modes}, {"name", name(*largest)}, {"of", most}, {"most", most_modes}}, largest->line,
                  largest->column);
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

void Studio::remove_file(const std::string& path) {
  std::error_code ignored;
  fs::remove((folder / "cases" / path).lexically_normal(), ignored);
  memo_ = std::make_unique<CaseMemo>();
  identities_.clear();
}

std::string Studio::open(const std::string& text, const std::string& file) {
  return guarded([&]() -> Json {
    case_.reset(), problem_.reset(), run_.reset(), spectral_.reset(), free_.reset(), plan_.reset(), plan_run_.reset();
    suite_.reset(), suite_run_.reset(), suite_gaps_.reset(), record_ = 0;
    if (text.size() > most_text) return too_much("text");
    const fs::path path = folder / "cases" / file;
    Diagnostics diagnostics;
    std::optional<TomlValue> root = parse_toml(text, path.string(), diagnostics);
    if (root) leave_out_lost_logo(*root, path.parent_path());
    if (!root) return {{"ok", false}, {"errors", list_of(diagnostics.errors(), file)}};
    if (std::optional<Json> answer = too_large(*root)) return *answer;
    const std::string name = path.string();  // which the view refers to
    const TomlView view(*root, "", name, diagnostics);
    ReadCase read = read_case_parts(view, path.parent_path(), diagnostics, memo_.get());
    if (!diagnostics.ok()) return {{"ok", false}, {"errors", list_of(diagnostics.errors(), file)}};
    if (read.plan) {
      if (read.c.excitation.spectrum) problem_ = row_of(*read.plan);  // its gaps are told of as those
      plan_ = std::move(read.plan);
    } else {
      problem_ = is_without_motion(read.c) ? make_still_problem(read.c, read.made_buildings()) : read.problem();
    }
    suite_ = read.c.excitation.suite;
    read.c.source = CaseSource{.file = file, .text = text, .sha256 = sha256(text)};
    read.c.given = std::make_shared<const TomlValue>(*root);
    for (ExcitationSpec* const one : {&read.c.excitation, &read.c.excitation_y}) know(*one);
    case_ = std::move(read.c);
    return {{"ok", true}, {"errors", Json::array()}};
  });
}

void Studio::know(ExcitationSpec& excitation) {
  auto& record = excitation.record;
  if (!record) return;
  const auto known = identities_.try_emplace(record->path);
  if (known.second) known.first->second = identify(record->path);
  record->size = known.first->second.size;
  record->sha256 = known.first->second.sha256;
}

std::string Studio::contacts() const {
  return guarded([&]() -> Json {
    if (plan_) return {{"ok", true}, {"errors", Json::array()}, {"counts", Json::array()}};
    if (!problem_) return failure("no case is open");
    std::vector<int> counts(problem_->buildings.size() - 1);
    for (const ContactPoint& point : problem_->points) ++counts[static_cast<std::size_t>(point.gap)];
    return {{"ok", true}, {"errors", Json::array()}, {"counts", counts}};
  });
}

std::string Studio::in_units(const std::string& text, const std::string& length, const std::string& force) const {
  return guarded([&]() -> Json {
    if (text.size() > most_text) return too_much("text");
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

namespace {

/// A run with what a page takes of time and memory, beside what its case allows. @param refused why the case refuses it
/// @param run solves, and answers with the response
template <class Refused, class Run>
std::optional<Json> run_within(SolveOptions& options, const emscripten::val& progress, const Effort& needed,
                               const Refused& refused, const Run& run) {
  options.limits.steps = std::min(options.limits.steps, static_cast<long>(most_steps));
  if (!progress.isNull()) options.progress = [&](double done) { return progress(done).template as<bool>(); };
  if (const std::string why = refused(needed); !why.empty()) return failure(why);
  if (const std::optional<Json> answer = beyond_page(needed)) return answer;
  const auto& response = run();
  if (response.status == Status::stopped) return failure("stopped");
  if (response.status == Status::failed) return failure("the numbers failed: " + response.message);
  return std::nullopt;
}

/// Histories as a page asks for them, as fine as a report has them where it names no step.
template <class Case, class Problem>
SolveOptions options_of(const Case& c, const Problem& problem, const emscripten::val& output_step) {
  SolveOptions options = solve_options(c);
  options.output_step = output_step.isNull() ? report_output_step(problem) : output_step.as<double>();
  options.energy_step = c.analysis.output_step;
  if (options.output_step < 0) options.output_step = c.analysis.output_step;
  return options;
}

}  // namespace

std::string Studio::solve(const emscripten::val& output_step, const emscripten::val& progress) {
  return guarded([&]() -> Json {
    run_.reset(), spectral_.reset(), plan_run_.reset(), suite_run_.reset(), suite_gaps_.reset();
    const auto solved = [](double seconds) -> Json {
      return {{"ok", true}, {"errors", Json::array()}, {"seconds", seconds}};
    };
    if (case_ && case_->excitation.suite) return solve_suite(progress);
    if (case_ && case_->excitation.spectrum) {
      const SpectrumSpec& spectrum = *case_->excitation.spectrum;
      spectral_ = plan_ ? spectral_gaps(*plan_, spectrum, case_->code, case_->units)
                        : spectral_gaps(*problem_, spectrum, case_->code, case_->units);
      return solved(0);
    }
    if (plan_) {
      const Case& c = *case_;
      const PlanProblem& problem = *plan_;
      SolveOptions options = options_of(c, problem, output_step);
      options.course = true;
      PlanResponse response;
      const auto refused = [&](const Effort& needed) { return beyond_limits(c, problem, needed); };
      const Effort needed = effort(problem, c.analysis.solver, options);
      const auto run = [&]() -> const PlanResponse& {
        return response = bentur::solve(problem, c.analysis.solver, options);
      };
      if (const auto failed = run_within(options, progress, needed, refused, run)) return *failed;
      const double seconds = response.wall_time;
      plan_run_ = run_results(c, problem, std::move(response));
      if (output_step.isNull()) plan_run_->closer = dense_findings(*plan_run_);
      return solved(seconds);
    }
    if (!problem_) return failure("no case is open");
    const Case& c = *case_;
    const bool fine = output_step.isNull();
    SolveOptions options = options_of(c, *problem_, output_step);
    options.course = true;
    Response response;
    const auto refused = [&](const Effort& needed) { return beyond_limits(c, *problem_, needed); };
    const Effort needed = effort(*problem_, c.analysis.solver, options);
    const auto run = [&]() -> const Response& {
      return response = bentur::solve(*problem_, c.analysis.solver, options);
    };
    if (const auto failed = run_within(options, progress, needed, refused, run)) return *failed;
    const double seconds = response.wall_time;
    run_ = run_results(c, *problem_, std::move(response));
    if (fine) {
      run_->figures = figures_ = figure_data(*run_, motion_, std::move(figures_));
      motion_ = run_->problem.motion;
    }
    return solved(seconds);
  });
}

std::string Studio::summary() const {
  if (plan_run_) return summary_json(*plan_run_, version());
  if (suite_run_) return suite_run_json(*suite_run_, *suite_gaps_, version());
  return run_ ? summary_json(*run_, version()) : "";
}

std::string Studio::impacts() const {
  if (plan_run_) return impacts_csv(*plan_run_);
  return run_ ? impacts_csv(run_->view()) : "";
}

std::string Studio::gaps() const {
  if (plan_run_) return gap_json(*plan_run_, version());
  if (spectral_) return spectral_gap_json(*case_, *problem_, *spectral_, version());
  if (suite_gaps_) return gap_study_json(*suite_gaps_, version(), suite_said_json(*suite_run_, *suite_gaps_));
  return run_ ? gap_json(*run_, version()) : "";
}

std::string Studio::modes() const {
  if (plan_) return modes_json(*plan_, case_->units);
  return problem_ ? modes_json(*problem_, case_->units) : "";
}

std::string Studio::motion(const std::string& language) const {
  if (plan_run_) return motion_json(*plan_run_, language);
  return run_ ? motion_json(*run_, language) : "";
}

std::string Studio::report(const std::string& language) const {
  const ReportOptions options{.language = language, .version = std::string(version())};
  if (plan_run_) return report_html(*plan_run_, options);
  if (spectral_) return spectral_report_html(*case_, *problem_, *spectral_, options);
  if (suite_run_) return suite_report_html(*suite_run_, *suite_gaps_, options);
  if (!run_) return "";
  ReportOptions all = options;
  all.sensitivity = sensitivity_of_report(run_->c, folder / "cases" / run_->c.source->file);
  return report_html(*run_, all);
}

std::string Studio::at_width(int gap, double width) {
  return guarded([&]() -> Json {
    if (!problem_) return failure("no case is open");
    Case c = *case_;
    if (c.excitation.suite) {
      return failure(
          "a suite is many ground motions: bentur run, gap and report take them all, --record N (record=N of Python) "
          "one of them");
    }
    if (gap < 0 || gap >= static_cast<int>(c.gaps.size()))
      throw InvalidParameter("gap", std::to_string(gap), "is no gap");
    std::vector<double>& widths = c.gaps[static_cast<std::size_t>(gap)].widths;
    const double narrowest = *std::min_element(widths.begin(), widths.end());
    for (double& one : widths) one = width + (one - narrowest);
    SolveOptions options;
    options.limits = run_limits(c.analysis);
    options.limits.steps = std::min(options.limits.steps, static_cast<long>(most_steps));
    if (!free_) {
      free_ = std::make_unique<FreeResponse>(*problem_, c.analysis.solver, nullptr, options.limits);
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
      .function("removeFile", &Studio::remove_file)
      .function("open", &Studio::open)
      .function("chooseRecord", &Studio::choose_record)
      .function("inUnits", &Studio::in_units)
      .function("schema", &Studio::schema)
      .function("solve", &Studio::solve)
      .function("summary", &Studio::summary)
      .function("impacts", &Studio::impacts)
      .function("gaps", &Studio::gaps)
      .function("modes", &Studio::modes)
      .function("motion", &Studio::motion)
      .function("report", &Studio::report)
      .function("overview", &Studio::overview)
      .function("tables", &Studio::tables)
      .function("contacts", &Studio::contacts)
      .function("histories", &Studio::histories)
      .function("draw", &Studio::draw)
      .function("figureFile", &Studio::figure_file)
      .function("atWidth", &Studio::at_width);
}
