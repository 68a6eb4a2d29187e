#include "bentur/model/story/internal/hand_in_open.h"

#include <algorithm>
#include <type_traits>

#include "bentur/model/plan/plan_row.h"
#include "bentur/model/suite/suite.h"

namespace bentur::story {
namespace {

using Eigen::Index;

/// One statement of the buildings that move and of which something holds; none where it holds of none.
/// @param holds of a building by its place
template <class Buildings, class Holds>
void tell_of(const char* kind, const Buildings& buildings, const Holds& holds, std::vector<Statement>& statements) {
  Statement statement{.kind = kind, .severity = Severity::remark};
  std::string names;
  for (Index b = 0; b < std::ssize(buildings); ++b) {
    if (buildings[b].is_rigid() || !holds(b)) continue;
    names += (names.empty() ? "" : ", ") + buildings[b].name;
    statement.buildings.push_back(b);
  }
  if (names.empty()) return;
  statement.values = {text_of("names", names)};
  statements.push_back(std::move(statement));
}

void tell(const char* kind, std::vector<Statement>& statements, std::vector<StoryValue> values = {}) {
  statements.push_back({.kind = kind, .severity = Severity::remark, .values = std::move(values)});
}

template <class Structure>
bool is_given_as(const Case& c, Index b) {
  const auto place = static_cast<std::size_t>(b);
  return place < c.buildings.size() && std::holds_alternative<Structure>(c.buildings[place].structure);
}

/// @param delays of the motion at each building [s]
void tell_motion(const std::vector<double>& delays, std::vector<Statement>& statements) {
  const bool is_late = std::any_of(delays.begin(), delays.end(), [](double s) { return s != 0; });
  tell(is_late ? "assumption.late_motion" : "assumption.one_motion", statements);
}

/// Links, rules and defaults.
void tell_given(const Case& c, std::vector<Statement>& statements) {
  if (!c.links.empty()) tell("assumption.links", statements);
  if (!c.code.rules.empty()) tell("assumption.codes", statements);
  tell("assumption.defaults", statements);
}

/// That no rule of a code is asked for, and of which code the project is.
void tell_codes(const Case& c, std::vector<Statement>& statements) {
  if (!c.code.rules.empty()) return;
  const std::string basis = c.project ? c.project->code_basis : "";
  tell(basis.empty() ? "unchecked.codes" : "unchecked.codes_of_basis", statements, {text_of("basis", basis)});
}

/// That other motions are not looked at.
void tell_records(const Case& c, std::vector<Statement>& statements) {
  if (const auto& suite = c.excitation.suite) {
    tell("unchecked.records", statements, {story::count_of("records", std::ssize(suite->records))});
    tell("unchecked.each_record", statements);
  } else if (!c.excitation.spectrum) {
    tell("unchecked.motions", statements);
  }
}

bool is_on_soil(const Building& building) { return building.model.foundation || building.model.slab; }
bool is_on_soil(const PlanBuilding& building) { return building.model.soil || building.model.slab; }

/// Levels at which a column is struck of which is not said what it carries.
std::string bare_columns(const GapView& facts) {
  std::string bare;
  for (const Gap& gap : gaps_of(facts.problem)) {
    const auto place = static_cast<std::size_t>(gap.number);
    if (place < facts.c.gaps.size() && facts.c.gaps[place].column_capacity) continue;
    for (const Index i : gap.points) {
      const ContactPoint& point = facts.problem.points[i];
      if (struck_column(facts.problem, point) && point.column_shear_capacity == 0) {
        bare += (bare.empty() ? "" : "; ") + level_text(facts, gap.number, point.elevation);
      }
    }
  }
  return bare;
}

/// Whether a building's masses stand apart from where they are expected, or are looked at there as well.
bool is_moved(const Case& c, Index b) {
  const auto* const plan = std::get_if<Plan>(&c.buildings.at(static_cast<std::size_t>(b)).structure);
  return plan != nullptr && (!plan->accidental_eccentricity.isZero() || plan->eccentricity_both_ways > 0);
}

/// What is open in every report.
template <class Buildings>
void tell_always(const Case& c, const Buildings& buildings, std::vector<Statement>& statements) {
  tell("unchecked.members", statements);
  tell("unchecked.drift", statements);
  tell_of(
      "unchecked.gravity", buildings, [&](Index b) { return !has_gravity(buildings[b]); }, statements);
  tell_of(
      "unchecked.soil", buildings, [&](Index b) { return !is_on_soil(buildings[b]); }, statements);
  constexpr bool in_plan = std::is_same_v<Buildings, std::vector<PlanBuilding>>;
  tell(in_plan ? "unchecked.vertical" : "unchecked.other_directions", statements);
  if constexpr (in_plan) {
    tell_of(
        "unchecked.eccentricity", buildings, [&](Index b) { return !is_moved(c, b); }, statements);
  }
  tell("unchecked.local", statements);
  tell_records(c, statements);
}

}  // namespace

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() ? number(value) : number(value) + "\u00A0" + unit;
}

std::string level_text(const GapView& facts, Index gap, double level) {
  return gap_name(facts.problem, gap) + ", " + with_unit(level, facts.c.units.length);
}

std::vector<Statement> assumptions_of(const Case& c, const Problem& problem) {
  std::vector<Statement> statements;
  const std::vector<Building>& buildings = problem.buildings;
  const auto is_calibrated = [&](Index b) { return buildings[b].model.stiffness_factor.has_value(); };
  tell_of(
      "assumption.generic", buildings, [&](Index b) { return is_given_as<GenericBuilding>(c, b); }, statements);
  tell_of(
      "assumption.modal", buildings, [&](Index b) { return is_given_as<ModalBuilding>(c, b); }, statements);
  tell_of("assumption.calibrated", buildings, is_calibrated, statements);
  if (!c.excitation.spectrum) tell_motion(problem.delays, statements);
  if (c.excitation.suite) tell("assumption.suite", statements);
  tell_given(c, statements);
  return statements;
}

std::vector<Statement> assumptions_of(const PlanRun& run) {
  std::vector<Statement> statements = {model_statement(run)};
  const std::vector<PlanBuilding>& buildings = run.problem.buildings;
  const auto is_calibrated = [&](Index b) { return buildings[b].model.stiffness_factor.has_value(); };
  tell_of(
      "assumption.modal", buildings, [&](Index b) { return buildings[b].model.known.has_value(); }, statements);
  tell_of("assumption.calibrated", buildings, is_calibrated, statements);
  if (!run.c.excitation.spectrum) tell_motion(run.problem.delays, statements);
  if (run.c.excitation.suite) tell("assumption.suite", statements);
  tell_given(run.c, statements);
  return statements;
}

std::vector<Statement> unchecked_of(const Case& c, const GapView& facts, bool needs_seismicity, const PlanProblem* plan,
                                    bool without_energy) {
  std::vector<Statement> statements;
  tell_codes(c, statements);
  const std::string bare = bare_columns(facts);
  if (!bare.empty()) tell("unchecked.columns", statements, {text_of("levels", bare)});
  if (needs_seismicity) tell("unchecked.screening", statements);
  const bool is_moved = facts.response != nullptr || c.excitation.suite;
  if (is_moved && !c.analysis.both_ways) tell("unchecked.reversed", statements);
  if (without_energy) tell("unchecked.energy", statements);
  if (plan != nullptr) {
    tell_always(c, plan->buildings, statements);
  } else {
    tell_always(c, facts.problem.buildings, statements);
  }
  return statements;
}

}  // namespace bentur::story
