#include "bentur/io/case/case_toml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <iterator>
#include <string_view>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/core/number_text.h"
#include "bentur/io/case/case_memo.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/case/plan/plan_parts.h"
#include "bentur/io/file_identity.h"
#include "bentur/io/input_file.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"
#include "bentur/io/toml/parameter_path.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/model/run_results.h"
#include "bentur/model/suite/suite.h"

namespace bentur {
namespace {

constexpr double shortest_time = 1e-15;  // of the duration: less has no phase left in a number [-]
constexpr double most_samples = 1e7;     // of one history [-]

/// Whether something is given an initial displacement or velocity.
bool moves(const InitialSpec& initial) {
  const auto any = [](const std::vector<std::vector<double>>& lists) {
    return std::any_of(lists.begin(), lists.end(), [](const std::vector<double>& list) {
      return std::any_of(list.begin(), list.end(), [](double x) { return x != 0; });
    });
  };
  return any(initial.displacements) || any(initial.velocities);
}

Solver read_solver(const TableView& view) {
  const auto chosen = view.word("solver");
  if (chosen == "runge-kutta") return RungeKuttaSolver{view.number("step").value_or(RungeKuttaSolver{}.step)};
  if (chosen == "adaptive") return AdaptiveSolver{view.number("tolerance").value_or(AdaptiveSolver{}.tolerance)};
  return ExactSolver{};
}

}  // namespace

AnalysisSpec read_analysis(const TomlView& root, const ExcitationSpec& excitation) {
  AnalysisSpec analysis;
  if (excitation.record) {
    analysis.duration = excitation.record->duration;
    analysis.goes_on = true;
  }
  if (excitation.spectrum || excitation.suite) analysis.duration = 1;  // [s] of nothing: no run is made of it
  // A record that could not be read would have given the duration.
  const auto source = root.find("excitation");
  const auto kind = source && source->is(TomlValue::Kind::table) ? source->find("kind") : std::nullopt;
  const bool duration_needed = kind && (kind->value().text == "harmonic" || kind->value().text == "none");
  const std::string reason = "only a record has a length of its own";

  if (!root.has("analysis")) {
    if (duration_needed) root.error_missing("analysis", "its duration is needed, " + reason);
    return analysis;
  }
  const auto view = TableView(root, case_keys()).table("analysis");
  if (!view) return analysis;
  if (view->has("duration")) {
    analysis.duration = view->number("duration").value_or(0);
    analysis.goes_on = false;
  } else if (duration_needed) {
    view->error_missing("duration", reason);
  }
  analysis.solver = read_solver(*view);
  if (const auto limits = view->table("limits")) {
    analysis.limits.steps = limits->number("steps").value_or(analysis.limits.steps);
    analysis.limits.events = limits->number("events").value_or(analysis.limits.events);
    analysis.limits.seconds = limits->number("seconds").value_or(analysis.limits.seconds);
    analysis.limits.memory = limits->number("memory").value_or(analysis.limits.memory);
  }
  analysis.collapse_drift = view->number("collapse_drift").value_or(analysis.collapse_drift);
  analysis.energy_audit = view->flag("energy_audit");
  analysis.both_ways = view->flag("both_ways");
  analysis.output_step = view->number("output_step").value_or(analysis.output_step);
  if (analysis.duration / analysis.output_step > most_samples) {
    (view->has("output_step") ? *view->find("output_step") : *root.find("analysis"))
        .error(fmt::format("asks for histories of {:.3g} samples, more than {:.0e}: make output_step larger",
                           analysis.duration / analysis.output_step, most_samples));
  }
  return analysis;
}

namespace {

/// What only shows once the structure is assembled (such as Rayleigh damping negative in some mode).
void check_assembled(const std::vector<TomlView>& views, const Units& units, std::vector<ReadBuilding>& buildings) {
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    if (buildings[b].made) continue;
    try {
      const BuildingSpec& spec = buildings[b].spec;
      const bool whole = buildings[b].model && !spec.isolation;
      buildings[b].made =
          std::make_shared<const Building>(whole ? make_building(spec, *buildings[b].model) : make_building(spec));
      if (!std::isfinite(proportions(*buildings[b].made, units, nullptr).weight)) {
        views[b].error("weighs more than can be computed with: are masses in the units of the case?");
      }
    } catch (const InvalidParameter& error) {
      const auto frame = views[b].find("frame");
      if (!frame || !at_section(frame->find("columns"), frame->find("beams"), error))
        views[b].error(std::string("cannot be computed with: ") + error.what());
    } catch (const std::exception& error) {
      views[b].error(std::string("cannot be computed with: ") + error.what());
    }
  }
}

/// Buildings whose contact takes no time cannot start inside one another.
void check_overlaps(const TomlView& root, const ReadCase& read) {
  const Case& c = read.c;
  const auto hard = [](const GapSpec& gap) { return gap.contact.law == "restitution"; };
  if (c.initial.displacements.empty() || std::none_of(c.gaps.begin(), c.gaps.end(), hard)) return;
  const std::vector<Building> made = read.made_buildings();
  for (const ContactPoint& point : contact_points(c, made)) {
    if (point.left_floor >= made[point.left].model.floors() || point.right_floor >= made[point.right].model.floors()) {
      continue;  // a node starts where the floors around it take it
    }
    const Eigen::Index left = point.left, right = point.right;
    const double left_at = c.initial.displacements[left][static_cast<std::size_t>(point.left_floor)];
    const double right_at = c.initial.displacements[right][static_cast<std::size_t>(point.right_floor)];
    if (!point.law->restitution() || !overlap(point.width, left_at, right_at)) continue;
    root.find("initial")
        ->find("displacements")
        ->error(fmt::format("makes \"{}\" and \"{}\" overlap by {:.4g} at elevation {}; with law = \"restitution\" "
                            "no force would part them: start without overlap or choose a law with a stiffness",
                            made[left].name, made[right].name, left_at - right_at - point.width,
                            written(point.elevation)));
  }
}

/// Times of which the duration has more than numbers can tell apart: validate() would refuse them without a position.
void check_times(const TomlView& root, const std::vector<TomlView>& views, const ReadCase& read) {
  const Case& c = read.c;
  for (std::size_t b = 0; b < views.size() && !read.plan; ++b) {
    const Building& building = *read.buildings[b].made;
    check_mode_times(views[b], building.modes, building.modal_damping, c.analysis.duration);
  }
  const TomlView excitation = *root.find("excitation");
  check_motion_times(excitation, c.excitation.motion, c.analysis.duration, c.units);
  if (const auto y = excitation.find("y")) {
    check_motion_times(*y, c.excitation_y.motion, c.analysis.duration, c.units);
  }
}

/// The excitation that says how long the ground moves: the longer record.
const ExcitationSpec& longest_of(const Case& c) {
  const auto length = [](const ExcitationSpec& one) { return one.record ? one.record->duration : 0.0; };
  return length(c.excitation_y) > length(c.excitation) ? c.excitation_y : c.excitation;
}

/// What a case in plan is solved as, of one that is right so far; where that is there but for the motion, with it.
void make_in_plan(const TomlView& root, ReadCase& read, Diagnostics& diagnostics) {
  const bool known = read.plan.has_value();
  if (!known) read.plan.emplace();
  std::vector<PlanBuilding> made = make_buildings(root, read.c, read.buildings, std::move(read.plan->buildings));
  refuse_masses_elsewhere(root, read.c, read.buildings);
  check_times(root, {}, read);
  if (!diagnostics.ok()) return;
  try {
    if (known) {
      read.plan->buildings = std::move(made);
      take_motion(read.c, *read.plan);
    } else {
      read.plan = make_plan_problem(read.c, std::move(made));
    }
  } catch (const InvalidParameter& fault) {  // an overlap at the start, of contacts without time
    const auto initial = root.find("initial");
    (initial ? *initial : root).error(std::string("cannot be computed with: ") + fault.what());
  }
}

}  // namespace

void check_mode_times(const TomlView& building, const Modes& modes, const Eigen::MatrixXd& modal_damping,
                      double duration) {
  if (modes.omega.size() == 0) return;
  const double shortest = duration * shortest_time;
  const double fastest = modes.omega.maxCoeff();
  const double damping = modal_damping.norm();
  if (fastest * shortest <= 1 && damping * shortest <= 1) return;
  const std::string what = fastest * shortest > 1 ? "a mode" : "damping";
  if (!std::isfinite(damping)) {
    building.error("has damping beyond what can be computed with");
    return;
  }
  building.error(
      fmt::format("has {} of {:.3g} rad/s, too fast to follow for {} s: are stiffness and mass in the units of "
                  "the case?",
                  what, std::max(fastest, damping), duration));
}

void check_motion_times(const TomlView& excitation, const GroundMotion& motion, double duration, const Units& units) {
  const auto* harmonic = std::get_if<HarmonicMotion>(&motion);
  if (harmonic == nullptr) return;
  const double shortest = duration * shortest_time;
  if (harmonic->period < shortest) {
    excitation.find("period")->error_value(fmt::format("must be >= {:.3g} for a duration of {} s", shortest, duration));
  } else if (!std::isfinite(peak_acceleration(motion) / units.gravity)) {
    excitation.error("asks for a ground acceleration beyond what can be computed with");
  }
}

bool read_by_building(const TomlView& table, const std::string& each, const std::vector<std::string>& names,
                      const std::function<void(std::size_t, const TomlView&)>& take) {
  if (!table.is(TomlValue::Kind::table)) {
    table.error_value("must be a table: building name = " + each);
    return false;
  }
  for (const TomlMember& member : table.value().members) {
    const TomlView given = *table.find(member.key);
    const auto found = std::find(names.begin(), names.end(), member.key);
    if (found == names.end()) {
      given.error("is for no building of the case, " + suggestion(member.key, names, "the buildings are"));
    } else {
      take(static_cast<std::size_t>(found - names.begin()), given);
    }
  }
  return true;
}

std::optional<TomlView> plan_of(const TomlView& root) {
  if (auto plan = root.find("plan")) return plan;
  const auto list = root.find("building");
  if (!list || !list->is(TomlValue::Kind::list)) return std::nullopt;
  for (const TomlView& building : list->items()) {
    if (!building.is(TomlValue::Kind::table)) continue;
    if (auto plan = building.find("plan")) return plan;
  }
  return std::nullopt;
}

std::optional<std::filesystem::path> input_path(const TomlView& key, const std::string& name,
                                                const std::filesystem::path& folder, const InputKind& kind) {
  std::filesystem::path path = folder / name;
  const std::string problem = input_problem(path, kind);
  if (problem.empty()) return path;
  return key.error_value(problem + " (names are relative to the case file)");
}

std::vector<Building> ReadCase::made_buildings() const {
  std::vector<Building> made;
  for (const ReadBuilding& building : buildings) made.push_back(*building.made);
  return made;
}

namespace {

/// All that does not hang on the ground motion.
ReadCase read_but_motion(const TomlView& root, const CaseFiles& files, bool in_plan) {
  const auto& [folder, diagnostics, memo] = files;
  ReadCase read;
  Case& c = read.c;
  (void)TableView::of(root, case_keys());
  const auto title = root.find("title");
  c.title = title ? title->as_line().value_or("") : "";
  c.units = read_units(root);
  std::vector<ReadBuilding>& buildings = read.buildings;
  buildings = in_plan ? read_plan_buildings(root, c.units, {folder, diagnostics})
                      : with_struck_columns(root, read_buildings(root, c.units, {folder, diagnostics}, memo));
  if (in_plan && diagnostics.ok()) {
    // Where columns are struck is known of footprints and floors, which these have.
    const StruckNodes nodes = struck_nodes(root, buildings);
    if (!nodes.empty()) buildings = read_plan_buildings(root, c.units, {folder, diagnostics}, nodes);
  }
  c.gaps = in_plan ? read_plan_gaps(root, buildings) : read_gaps(root, buildings);
  c.links = read_links(root, buildings, in_plan);
  const std::size_t neighbours = buildings.empty() ? 0 : buildings.size() - 1;
  const std::size_t gaps = !in_plan ? neighbours : diagnostics.ok() ? c.gaps.size() : 0;
  c.initial = read_initial(root, buildings, in_plan);
  c.code = read_code(root, c.units, buildings.size(), gaps);
  c.screening = read_screening(root);
  c.project = read_project(root, folder, diagnostics);
  for (const ReadBuilding& building : buildings) c.buildings.push_back(building.spec);
  return read;
}

}  // namespace

ReadCase read_case_parts(const TomlView& root, const std::filesystem::path& folder, Diagnostics& diagnostics,
                         CaseMemo* memo, const std::function<void(double)>& progress) {
  const CaseFiles files{folder, diagnostics, memo};
  const bool in_plan = plan_of(root).has_value();
  if (const auto study = root.find("case"); study && !root.has("building")) {
    study->error("names the case of a study, which is not taken here: bentur sweep, ida, gap and remedy take studies");
    return {};
  }
  const std::shared_ptr<const ReadCase> known = memo != nullptr ? memo->but_motion(root, folder) : nullptr;
  ReadCase read = known ? *known : read_but_motion(root, files, in_plan);
  Case& c = read.c;
  std::vector<ReadBuilding>& buildings = read.buildings;
  read_excitation(root, buildings, files, in_plan, c);
  c.analysis = read_analysis(root, longest_of(c));
  if (const auto excitation = root.find("excitation"); !known) {
    check_values(root, case_keys());
  } else if (excitation && excitation->is(TomlValue::Kind::table)) {
    check_values(*excitation, excitation_keys());
  }
  if (!diagnostics.ok()) return read;
  const bool still =
      std::holds_alternative<NoMotion>(c.excitation.motion) && std::holds_alternative<NoMotion>(c.excitation_y.motion);
  if (still && !is_without_motion(c) && !moves(c.initial)) {
    root.find("excitation")
        ->find("kind")
        ->error_value("nothing would move: give [initial] displacements or velocities, or a ground motion");
  }
  std::vector<TomlView> views;
  if (in_plan) {
    make_in_plan(root, read, diagnostics);
  } else {
    for (std::size_t b = 0; b < buildings.size(); ++b) views.push_back(view_of(root, buildings, b));
    check_assembled(views, c.units, buildings);
  }
  if (!diagnostics.ok()) return read;
  if (!in_plan) {
    check_overlaps(root, read);
    check_times(root, views, read);
  }
  settle_excitation(root, read, diagnostics, progress);
  if (memo != nullptr && diagnostics.ok() && !known) {
    if (!in_plan) memo->keep(root, c.units, buildings);
    memo->keep(root, folder, read);
  }
  return read;
}

TomlView view_of(const TomlView& root, const std::vector<ReadBuilding>& buildings, std::size_t building) {
  return root.find("building")->item(building).renamed(buildings.at(building).path);
}

Units read_units(const TomlView& root) {
  Units units;
  const auto view = TableView(root, case_keys()).table("units");
  if (!view) return units;
  units.length = view->word("length").value_or(units.length);
  units.force = view->word("force").value_or(units.force);
  units.gravity = view->number("gravity").value_or(standard_gravity(units.length));
  return units;
}

namespace {

/// Whatever happens, errors are those of this file alone, whatever the caller has collected before.
template <typename Read>
std::optional<Case> read_parsed(const std::string& text, const std::filesystem::path& file, Diagnostics& diagnostics,
                                const Read& read) {
  Diagnostics found;
  const std::string name = file.string();
  std::optional<Case> c;
  auto root = parse_toml(text, name, found);
  const auto given = root ? std::make_shared<const TomlValue>(*root) : nullptr;
  if (root) c = read(*root, name, found);
  diagnostics.add(found);
  if (!found.ok()) return std::nullopt;
  c->given = given;
  c->source = CaseSource{.file = file.filename().string(), .text = text, .sha256 = sha256(text)};
  return c;
}

void take_made(ReadCase& read, MadeParts& made) {
  if (read.plan) {
    made.plan = std::move(*read.plan);
  } else {
    made.buildings = read.made_buildings();
  }
}

/// Puts a harmonic motion in place of a record or a suite, in [excitation] or its y. @return whether there was one
bool take_record_out(TomlValue& excitation) {
  const TomlValue* const kind = excitation.find("kind");
  if (kind == nullptr || (kind->text != "record" && kind->text != "suite")) return false;
  constexpr std::string_view kept[] = {"delays", "wave_velocity", "wave_angle", "kinematics", "angle", "y"};
  std::erase_if(excitation.members, [&](const TomlMember& one) {
    return std::find(std::begin(kept), std::end(kept), one.key) == std::end(kept);
  });
  put_value(excitation, {"kind"}, toml_text("harmonic"));
  for (const char* key : {"period", "displacement_amplitude"}) put_value(excitation, {key}, toml_number(1));
  return true;
}

}  // namespace

void leave_out_lost_logo(TomlValue& root, const std::filesystem::path& folder) {
  TomlValue* const project = root.find("project");
  const TomlValue* const logo = project != nullptr ? project->find("logo") : nullptr;
  if (logo == nullptr || input_problem(folder / logo->text, logo_input).empty()) return;
  std::erase_if(project->members, [](const TomlMember& one) { return one.key == "logo"; });
}

std::optional<Case> read_case_text(const std::string& text, const std::filesystem::path& file, Diagnostics& diagnostics,
                                   MadeParts* made, const std::function<void(double)>& progress) {
  return read_parsed(text, file, diagnostics, [&](const TomlValue& root, const std::string& name, Diagnostics& found) {
    ReadCase read = read_case_parts(TomlView(root, "", name, found), file.parent_path(), found, nullptr, progress);
    if (made != nullptr && found.ok()) take_made(read, *made);
    return std::move(read.c);
  });
}

std::optional<Case> read_case_without_record(const std::string& text, const std::filesystem::path& file,
                                             Diagnostics& diagnostics, MadeParts* made) {
  return read_parsed(text, file, diagnostics, [&](TomlValue& root, const std::string& name, Diagnostics& found) {
    leave_out_lost_logo(root, file.parent_path());
    TomlValue* const excitation = root.find("excitation");
    TomlValue* const along_y = excitation != nullptr ? excitation->find("y") : nullptr;
    const bool taken = excitation != nullptr && take_record_out(*excitation);
    const bool taken_y = along_y != nullptr && take_record_out(*excitation->find("y"));
    const TomlValue* const analysis = root.find("analysis");
    const bool lasts = analysis != nullptr && analysis->find("duration") != nullptr;
    if ((taken || taken_y) && !lasts) put_value(root, {"analysis", "duration"}, toml_number(1));
    ReadCase read = read_case_parts(TomlView(root, "", name, found), file.parent_path(), found);
    if (taken) read.c.excitation.motion = NoMotion{};
    if (taken_y) read.c.excitation_y.motion = NoMotion{};
    if (read.plan) read.plan->motions = {read.c.excitation.motion, read.c.excitation_y.motion};
    if (made != nullptr && found.ok()) take_made(read, *made);
    return std::move(read.c);
  });
}

std::optional<ProjectSpec> project_of(const std::string& text) {
  Diagnostics found;
  auto root = parse_toml(text, "", found);
  if (!root) return std::nullopt;
  std::erase_if(root->members, [](const TomlMember& one) { return one.key != "project"; });
  if (TomlValue* const project = root->find("project")) {
    std::erase_if(project->members, [](const TomlMember& one) { return one.key == "logo"; });
  }
  const std::string file;
  std::optional<ProjectSpec> project = read_project(TomlView(*root, "", file, found), {}, found);
  return found.ok() ? project : std::nullopt;
}

std::optional<Case> read_case(const std::filesystem::path& file, Diagnostics& diagnostics, MadeParts* made,
                              const std::function<void(double)>& progress) {
  const auto text = read_input(file, case_input, diagnostics);
  return text ? read_case_text(*text, file, diagnostics, made, progress) : std::nullopt;
}

std::vector<std::filesystem::path> files_read(const Case& c) {
  std::vector<std::filesystem::path> files;
  const auto add = [&](const std::string& path) {
    if (!path.empty()) files.emplace_back(path);
  };
  for (const ExcitationSpec* const one : c.excitations()) {
    if (one->record) add(one->record->path);
  }
  if (c.excitation.spectrum) add(c.excitation.spectrum->path);
  if (c.excitation.suite) {
    for (const std::string& path : c.excitation.suite->paths()) add(path);
  }
  for (const BuildingSpec& building : c.buildings) add(building.shapes_path);
  if (c.project) add(c.project->logo_path);
  return files;
}

}  // namespace bentur
