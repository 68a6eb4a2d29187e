#include "bentur/io/case/plan/plan_toml.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <memory>
#include <string_view>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/case/plan/plan_parts.h"
#include "bentur/io/file_identity.h"
#include "bentur/io/input_file.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"
#include "bentur/io/toml/parameter_path.h"

namespace bentur {
namespace {

/// Steps of one length do not follow friction.
void refuse_analysis(const TomlView& root, const std::vector<PlanGapSpec>& gaps) {
  const bool rubs = std::any_of(gaps.begin(), gaps.end(), [](const PlanGapSpec& gap) {
    const auto friction = gap.contact.numbers.find("friction");
    return friction != gap.contact.numbers.end() &&
           std::any_of(friction->second.begin(), friction->second.end(), [](double value) { return value > 0; });
  });

  const auto analysis = root.find("analysis");
  if (!analysis || !analysis->is(TomlValue::Kind::table)) return;
  const auto solver = analysis->find("solver");
  if (rubs && solver && solver->value().text == "runge-kutta") solver->error_value("does not go with friction");
}

/// The excitation that says how long the ground moves: the longer record.
const ExcitationSpec& longer_of(const std::array<ExcitationSpec, 2>& excitation) {
  const auto length = [](const ExcitationSpec& one) { return one.record ? one.record->duration : 0.0; };
  return length(excitation[1]) > length(excitation[0]) ? excitation[1] : excitation[0];
}

/// @param problem takes what the case is solved as, unless it is null or there are errors
PlanCase read_parts(const TomlView& root, const CaseFiles& files, PlanProblem* problem) {
  PlanCase c;
  (void)TableView::of(root, case_keys());
  const auto title = root.find("title");
  c.title = title ? title->as_line().value_or("") : "";
  c.units = read_units(root);
  const std::vector<ReadPlanBuilding> buildings = read_plan_buildings(root, c.units);
  for (const ReadPlanBuilding& building : buildings) c.buildings.push_back(building.spec);
  c.gaps = read_plan_gaps(root, buildings);
  c.links = read_plan_links(root, buildings);
  c.code = read_code(root, c.units, buildings.size(), files.diagnostics.ok() ? c.gaps.size() : 0);
  read_plan_excitation(root, buildings, files, c);
  bool moves = false;
  c.initial = read_plan_initial(root, buildings, moves);
  c.screening = read_screening(root);
  c.project = read_project(root, files.folder, files.diagnostics);
  refuse_analysis(root, c.gaps);
  c.analysis = read_analysis(root, longer_of(c.excitation));
  check_values(root, case_keys());
  if (!files.diagnostics.ok()) return c;
  const TomlView excitation = *root.find("excitation");
  const auto still = [](const ExcitationSpec& one) { return std::holds_alternative<NoMotion>(one.motion); };
  if (std::all_of(c.excitation.begin(), c.excitation.end(), still) && !moves) {
    excitation.find("kind")->error_value(
        "nothing would move: give [initial] displacements or velocities, or a ground motion");
  }
  std::vector<PlanBuilding> made = make_buildings(c, buildings);
  check_motion_times(excitation, c.excitation[0].motion, c.analysis.duration, c.units);
  if (const auto y = excitation.find("y")) {
    check_motion_times(*y, c.excitation[1].motion, c.analysis.duration, c.units);
  }
  if (!files.diagnostics.ok()) return c;
  try {
    PlanProblem found = make_plan_problem(c, std::move(made));
    if (problem != nullptr) *problem = std::move(found);
  } catch (const InvalidParameter& fault) {  // an overlap at the start, of contacts without time
    const auto initial = root.find("initial");
    (initial ? *initial : root).error(std::string("cannot be computed with: ") + fault.what());
  }
  return c;
}

/// Puts a harmonic motion in place of a record; `kept` are the keys of the table that stay. @return whether there was
/// one.
bool take_record_out(TomlValue& excitation, std::initializer_list<std::string_view> kept) {
  const TomlValue* const kind = excitation.find("kind");
  if (kind == nullptr || kind->text != "record") return false;
  std::erase_if(excitation.members,
                [&](const TomlMember& one) { return std::find(kept.begin(), kept.end(), one.key) == kept.end(); });
  put_value(excitation, {"kind"}, toml_text("harmonic"));
  for (const char* key : {"period", "displacement_amplitude"}) put_value(excitation, {key}, toml_number(1));
  return true;
}

/// @param prepare what is changed of the text before it is read
template <class Prepare>
std::optional<PlanCase> read_text(const std::string& text, const std::filesystem::path& file, Diagnostics& diagnostics,
                                  PlanProblem* problem, const Prepare& prepare) {
  Diagnostics found;
  const std::string name = file.string();
  std::optional<PlanCase> c;
  auto root = parse_toml(text, name, found);
  if (root) {
    auto given = std::make_shared<const TomlValue>(*root);
    prepare(*root);
    c = read_parts(TomlView(*root, "", name, found), {file.parent_path(), found}, problem);
    c->given = std::move(given);
  }
  diagnostics.add(found);
  if (!found.ok()) return std::nullopt;
  c->source = CaseSource{.file = file.filename().string(), .text = text, .sha256 = sha256(text)};
  return c;
}

}  // namespace

ReadPlan read_plan_case_parts(const TomlView& root, const std::filesystem::path& folder, Diagnostics& diagnostics,
                              CaseMemo* memo) {
  ReadPlan read;
  read.c = read_parts(root, {folder, diagnostics, memo}, &read.problem);
  return read;
}

bool is_plan_case(const std::filesystem::path& file) {
  Diagnostics ignored;
  const auto text = read_input(file, case_input, ignored);
  const std::string name = file.string();
  const auto root = text ? parse_toml(*text, name, ignored) : std::nullopt;
  return root && plan_of(TomlView(*root, "", name, ignored)).has_value();
}

std::optional<PlanCase> read_plan_case_text(const std::string& text, const std::filesystem::path& file,
                                            Diagnostics& diagnostics, PlanProblem* problem) {
  return read_text(text, file, diagnostics, problem, [](TomlValue&) {});
}

std::optional<PlanCase> read_plan_case_without_records(const std::string& text, const std::filesystem::path& file,
                                                       Diagnostics& diagnostics, PlanProblem* problem) {
  std::array<bool, 2> taken{};
  std::optional<PlanCase> c = read_text(text, file, diagnostics, problem, [&](TomlValue& root) {
    leave_out_lost_logo(root, file.parent_path());
    TomlValue* const excitation = root.find("excitation");
    if (excitation == nullptr) return;
    taken[0] = take_record_out(*excitation, {"delays", "wave_velocity", "wave_angle", "kinematics", "angle", "y"});
    if (TomlValue* const y = excitation->find("y")) taken[1] = take_record_out(*y, {});
    const TomlValue* const analysis = root.find("analysis");
    const bool lasts = analysis != nullptr && analysis->find("duration") != nullptr;
    if ((taken[0] || taken[1]) && !lasts) put_value(root, {"analysis", "duration"}, toml_number(1));
  });
  for (std::size_t i = 0; c && i < taken.size(); ++i) {
    if (!taken[i]) continue;
    c->excitation[i].motion = NoMotion{};
    if (problem != nullptr) problem->motions[i] = NoMotion{};
  }
  return c;
}

std::optional<PlanCase> read_plan_case(const std::filesystem::path& file, Diagnostics& diagnostics,
                                       PlanProblem* problem) {
  const auto text = read_input(file, case_input, diagnostics);
  return text ? read_plan_case_text(*text, file, diagnostics, problem) : std::nullopt;
}

std::vector<std::filesystem::path> files_read(const PlanCase& c) {
  std::vector<std::filesystem::path> files;
  for (const ExcitationSpec& one : c.excitation) {
    if (one.record && !one.record->path.empty()) files.emplace_back(one.record->path);
  }
  if (c.project && !c.project->logo_path.empty()) files.emplace_back(c.project->logo_path);
  return files;
}

}  // namespace bentur
