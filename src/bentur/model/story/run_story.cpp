#include <algorithm>
#include <cmath>
#include <utility>

#include "bentur/model/story/internal/run_parts.h"

// The story of a run, of a row as of buildings in plan.
namespace bentur {
namespace {

using Eigen::Index;
using namespace story;

/// A collapse: {building}, {storey}, {time} and {limit}.
template <class AnyRun>
void tell_collapse(const AnyRun& run, std::vector<Statement>& statements) {
  const auto tell = [&](const Collapse& collapse, const char* kind) {
    const auto& building = run.problem.buildings[collapse.building];
    statements.push_back({.kind = kind,
                          .severity = Severity::danger,
                          .buildings = {collapse.building},
                          .values = {text_of("building", building.name),
                                     count_of("storey", building.model.storey_number(collapse.storey)),
                                     value_in("time", collapse.time, "s"),
                                     value_in("limit", percent * run.problem.collapse_drift, "%")}});
  };
  const auto &with = run.response.collapse, &without = run.response.collapse_no_contact;
  if (with) {
    tell(*with, "collapse");
    if (!without) statements.push_back({.kind = "collapse_by_contact", .severity = Severity::danger});
  }
  if (without) tell(*without, with ? "collapse_also_alone" : "collapse_alone");
}

/// The storey of a building that drifts the most, with contact or without; nothing of one that does not move, or that
/// gravity acts on, whose collapse is looked for.
template <class AnyRun>
std::optional<WorstDrift> worst_drift(const AnyRun& run, Index b) {
  const auto& building = run.problem.buildings[b];
  if (building.is_rigid() || has_gravity(building)) return std::nullopt;
  WorstDrift most{.name = building.name};
  for (const bool is_alone : {false, true}) {
    for (const Storeys& all : storeys_of(run, b)) {
      const Eigen::VectorXd& ratios = is_alone ? all.drift_alone : all.drift;
      for (Index storey = 0; storey < ratios.size(); ++storey) {
        if (ratios(storey) > most.ratio) most = {all.name, storey, ratios(storey), is_alone};
      }
    }
  }
  return most;
}

/// A storey that yields, or the bearings of a building.
struct Yields {
  std::string name;                  ///< of the building, or of the plane of it
  double ductility = 1;              ///< > 1 [-]
  std::optional<double> alone = {};  ///< without contact, where that is known
  std::optional<Index> storey = {};  ///< its number, for people; nothing: bearings
};

/// Of a building those of the largest ductility.
template <class AnyRun>
std::vector<Yields> yields_of(const AnyRun& run, Index b) {
  const auto& model = run.problem.buildings[b].model;
  std::optional<Yields> most;
  for (const Storeys& all : storeys_of(run, b)) {
    const Eigen::VectorXd &with = all.yielding.ductility, &alone = all.yielding_alone.ductility;
    for (Index storey = 0; storey < with.size(); ++storey) {
      if (!(with(storey) > (most ? most->ductility : 1))) continue;
      most = Yields{.name = all.name, .ductility = with(storey)};
      if (storey < alone.size() && !std::isnan(alone(storey))) most->alone = alone(storey);
      if (storey >= model.first_storey()) most->storey = model.storey_number(storey);
    }
  }
  std::vector<Yields> found;
  if (most) found.push_back(*most);
  const double bearings = ductility_of_bearings(run, b);
  if (bearings > 1) found.push_back({.name = run.problem.buildings[b].name, .ductility = bearings});
  return found;
}

/// The storeys of a building with the one that has least of its strength left, where some has softened.
template <class AnyRun>
std::optional<std::pair<Storeys, Index>> softened_of(const AnyRun& run, Index b) {
  std::optional<std::pair<Storeys, Index>> worst;
  for (Storeys& all : storeys_of(run, b)) {
    const Index storey = most_softened(all.yielding);
    if (storey < 0) continue;
    const double left = all.yielding.strength_left(storey);
    if (!worst || left < worst->first.yielding.strength_left(worst->second)) worst.emplace(std::move(all), storey);
  }
  return worst;
}

/// Buildings that drift beyond what counts as collapse, where nothing looks for that since no gravity acts.
template <class AnyRun>
void tell_drifts(const AnyRun& run, std::vector<Statement>& statements) {
  const double limit = run.problem.collapse_drift;
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const std::optional<WorstDrift> worst = worst_drift(run, b);
    if (!worst || !(worst->ratio > limit)) continue;
    const auto& model = run.problem.buildings[b].model;
    statements.push_back(
        {.kind = worst->is_alone ? "drift_beyond_alone" : "drift_beyond",
         .severity = Severity::danger,
         .buildings = {b},
         .level = model.elevations[worst->storey],
         .values = {text_of("building", worst->name), count_of("storey", model.storey_number(worst->storey)),
                    value_in("drift", percent * worst->ratio, "%"), value_in("limit", percent * limit, "%")}});
  }
}

/// An entry of a list that results leave out where nothing of it is known.
double known(const Eigen::VectorXd& list, Index i) {
  return i < list.size() ? list(i) : std::numeric_limits<double>::quiet_NaN();
}

/// What storeys have lost of their strength: of each building the one with least left.
template <class AnyRun>
void tell_lost_strength(const AnyRun& run, std::vector<Statement>& statements) {
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const auto found = softened_of(run, b);
    if (!found) continue;
    const auto& model = run.problem.buildings[b].model;
    const BuildingPeaks::Yielding& yielding = found->first.yielding;
    const Index storey = found->second;
    const double failed = known(yielding.failed_time, storey);
    const double residual = known(yielding.residual_time, storey);
    const bool has_failed = !std::isnan(failed), to_residual = !std::isnan(residual);
    const double capped = known(yielding.capped_time, storey);
    const double time = has_failed ? failed : to_residual ? residual : capped;
    statements.push_back(
        {.kind = has_failed    ? "storey_fails"
                 : to_residual ? "storey_at_residual"
                               : "storey_softens",
         .severity = has_failed ? Severity::danger : Severity::warning,
         .buildings = {b},
         .level = model.elevations[storey],
         .values = {value_in("time", time, "s"), value_in("left", percent * yielding.strength_left(storey), "%"),
                    text_of("building", found->first.name), count_of("storey", model.storey_number(storey))}});
  }
}

/// The largest ductility of each building that can yield.
template <class AnyRun>
void tell_yielding(const AnyRun& run, std::vector<Statement>& statements) {
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    for (const Yields& one : yields_of(run, b)) {
      Statement statement{.kind = one.storey ? "storey_yields" : "bearings_yield", .buildings = {b}};
      statement.values = {text_of("building", one.name), value_in("ductility", one.ductility)};
      if (one.storey) statement.values.push_back(count_of("storey", *one.storey));
      if (one.alone) statement.values.push_back(value_in("alone", *one.alone));
      statement.values.push_back(one.alone ? word_of("comparison", "story.ductility_alone")
                                           : text_of("comparison", ""));
      statements.push_back(std::move(statement));
    }
  }
}

/// Completes what is said of buildings that collide.
template <class AnyRun>
void tell_hit(const AnyRun& run, std::size_t gap, Statement statement, std::vector<Statement>& statements) {
  const Hit hit = hit_of(run, gap);
  statement.severity = Severity::warning;
  statement.values.push_back(count_of("times", hit.impacts));
  statement.values.push_back(count_of("touched", hit.touched));
  put_place(run, gap, hit, statement);
  tell_blow(run.response.points[hit.point], hit.hardest, shown_units(run), statement);
  statements.push_back(std::move(statement));
}

/// Of many gaps the headline and the table. @return the worst of them; nothing where there is one alone
std::optional<Index> tell_all_gaps(const GapView& view, const ShownUnits& shown, Story& told) {
  std::vector<GapLine> lines;
  for (std::size_t g = 0; g < view.facts.size(); ++g) {
    lines.push_back(gap_line(view.facts[g], view.judged[g].value, gap_name(view.problem, static_cast<Index>(g))));
  }
  return tell_gaps(lines, shown, view.c.units.length, told);
}

/// Contact, the need, the rules of one of the run's gaps.
template <class AnyRun>
void tell_gap(const AnyRun& run, const GapView& view, std::size_t gap, std::vector<Statement>& statements) {
  const auto number = static_cast<Index>(gap);
  const auto hit = [&](Statement statement) { tell_hit(run, gap, std::move(statement), statements); };
  tell_unmodelled(view, number, statements);
  tell_judgement(view, number, hit, statements);
  tell_need(view, number, statements);
  tell_rules(view, number, statements);
}

void put_tables(const GapView& view, std::size_t gap, std::vector<StoryTable>& tables) {
  for (StoryTable& table : gap_tables(view, static_cast<Index>(gap))) tables.push_back(std::move(table));
}

/// What contact does to displacements, accelerations and shears.
template <class AnyRun>
void tell_effects(const AnyRun& run, std::vector<Statement>& statements) {
  constexpr double round_off = 1e-9;
  if (!run.response.impacts.empty()) {
    const LargestOfFloors moves = largest_of_floors(run, "amplification");
    const bool is_amplified = moves.value > 1 + round_off;
    if (is_amplified) {
      statements.push_back(of_floor(run, moves, "amplified"));
      auto& values = statements.back().values;
      const std::string& length = run.c.units.length;
      values.push_back(value_in("factor", moves.value));
      values.push_back(value_in("with", value_at(run, "peak_displacement", moves), length));
      values.push_back(value_in("without", value_at(run, "peak_displacement_no_contact", moves), length));
    }
    const bool turns = tell_turning(run, statements);
    if (!is_amplified && !turns && !std::isnan(moves.value)) statements.push_back({.kind = "not_amplified"});
    for (const char* const key : {"acceleration_ratio", "storey_shear_ratio"}) {
      const LargestOfFloors most = largest_of_floors(run, key);
      if (!(most.value > 0)) continue;
      constexpr double seen = 1.005;  // with three digits
      if (most.value < seen) {
        statements.push_back({.kind = std::string(key) + "_none"});
        continue;
      }
      statements.push_back(of_floor(run, most, key));
      statements.back().values.push_back(value_in("factor", most.value));
    }
  }
  const LargestOfFloors fastest = largest_of_floors(run, "peak_acceleration");
  if (std::isnan(fastest.value)) return;
  statements.push_back(of_floor(run, fastest, "acceleration"));
  auto& values = statements.back().values;
  values.push_back(value_in("acceleration", fastest.value, run.c.units.length + "/s²"));
  values.push_back(value_in("in_g", fastest.value / run.c.units.gravity, "g"));
}

std::vector<double> peaks_of_ground(const RunResults& run) { return {applied_pga(run.c)}; }
std::vector<double> peaks_of_ground(const PlanRun& run) { return {applied_pga(run, 0), applied_pga(run, 1)}; }

/// The ground motion as applied, in plan along each of its axes.
template <class AnyRun>
void tell_motion(const AnyRun& run, std::vector<Statement>& statements) {
  const std::vector<double> peaks = peaks_of_ground(run);
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    if (!(peaks[i] > 0)) continue;
    Statement statement{.kind = "pga"};
    if (is_in_plan<AnyRun>) {
      statement.kind = run.c.angle == 0 ? "pga_along" : "pga_along_turned";
      statement.values = {text_of("axis", i == 0 ? "x" : "y"), value_in("angle", run.c.angle)};
    }
    statement.values.push_back(value_in("pga", peaks[i], run.c.units.length + "/s²"));
    statement.values.push_back(value_in("in_g", peaks[i] / run.c.units.gravity, "g"));
    statements.push_back(std::move(statement));
  }
}

/// What a table says as well as a sentence. @param worst of many gaps the one that sentences are about
void leave_to_tables(std::optional<Index> worst, std::vector<Statement>& statements) {
  constexpr std::string_view rows[] = {
      "pga",           "pga_along",          "pga_along_turned",        "acceleration",   "acceleration_ratio_none",
      "not_amplified", "storey_shear_ratio", "storey_shear_ratio_none", "rules",          "rules_less",
      "rules_short",   "rules_silent",       "reversed_alone",          "reversed_enough"};
  for (Statement& one : statements) {
    if (one.severity == Severity::danger) continue;
    if (std::find(std::begin(rows), std::end(rows), one.kind) != std::end(rows)) one.shown = Shown::row;
    if (one.kind == "rules_understate") one.shown = Shown::table;  // a note of the rules' rows
    if (worst && one.gap && *one.gap != *worst) one.shown = Shown::table;
  }
}

/// What the tables of a gap's levels and rules have.
void leave_to_gap_tables(std::vector<Statement>& statements) {
  for (Statement& one : statements) {
    const bool is_level = one.kind.starts_with("reversed_") && one.shown == Shown::row;
    if (is_level || one.kind.starts_with("rules")) one.shown = Shown::table;
    if (one.kind == "rules_understate") one.shown = Shown::sentence;
  }
}

/// Remarks and what the model leaves out, after all else.
template <class AnyRun>
void tell_remarks(const AnyRun& run, Story& told) {
  sort_by_severity(told.statements);
  tell_quotations(run.c.code, told.statements);
  put_remarks(run.remarks, told.statements);
  tell_left_out(run, told.statements);
  told.statements.push_back(model_statement(run));
}

template <class AnyRun>
Story story_of(const AnyRun& run) {
  const ToldGaps gaps(run);
  Story told;
  tell_collapse(run, told.statements);
  tell_columns(run, told.statements);
  tell_drifts(run, told.statements);
  tell_lost_strength(run, told.statements);
  tell_failures(run, told);
  const std::optional<Index> worst = tell_all_gaps(gaps.view(), shown_units(run), told);
  for (std::size_t g = 0; g < gaps.count(); ++g) tell_gap(run, gaps.view(), g, told.statements);
  tell_slips(run, told.statements);
  tell_pairs_without_contact(run, told.statements);
  tell_effects(run, told.statements);
  tell_yielding(run, told.statements);
  story::tell_hinges(run, told);
  tell_links(run.problem, run.response.links, shown_units(run), run.c.units.length, told.statements);
  tell_motion(run, told.statements);
  leave_to_tables(worst, told.statements);
  tell_remarks(run, told);
  return told;
}

template <class AnyRun>
Story story_of_gaps(const AnyRun& run) {
  const ToldGaps gaps(run);
  Story told;
  tell_collapse(run, told.statements);
  tell_drifts(run, told.statements);
  const std::optional<Index> worst = tell_all_gaps(gaps.view(), shown_units(run), told);
  for (std::size_t g = 0; g < gaps.count(); ++g) {
    tell_gap(run, gaps.view(), g, told.statements);
    put_tables(gaps.view(), g, told.tables);
  }
  tell_pairs_without_contact(run, told.statements);
  tell_motion(run, told.statements);
  leave_to_tables(worst, told.statements);
  leave_to_gap_tables(told.statements);
  tell_remarks(run, told);
  return told;
}

template <class AnyRun>
std::vector<StoryTable> tables_of_gaps(const AnyRun& run) {
  const ToldGaps gaps(run);
  std::vector<StoryTable> tables;
  for (std::size_t g = 0; g < gaps.count(); ++g) put_tables(gaps.view(), g, tables);
  return tables;
}

}  // namespace

namespace story {

std::string key_along(const std::string& key, const std::string& axis) {
  const std::string end = "_no_contact";
  if (axis.empty()) return key;
  const bool has_end = key.ends_with(end);
  return (has_end ? key.substr(0, key.size() - end.size()) : key) + "_" + axis + (has_end ? end : "");
}

void tell_blow(const PointSummary& point, const Impact* hardest, const ShownUnits& shown, Statement& statement) {
  if (point.peak_force > 0) {
    statement.kind = "pounding";
    statement.values.push_back(value_in("force", shown.force * point.peak_force, shown.units.force));
    statement.values.push_back(value_in("time", point.peak_force_time.value_or(0), "s"));
    if (hardest != nullptr) {
      statement.values.push_back(value_in("contact", 1e3 * (hardest->end - hardest->start), "ms"));
      statement.values.push_back(word_of("lasting", "story.lasting"));
    } else {
      statement.values.push_back(text_of("lasting", ""));
    }
  } else {
    statement.kind = "pounding_impulse";
    statement.values.push_back(value_in("speed", point.peak_closing_speed, shown.units.length + "/s"));
    statement.values.push_back(value_in("time", hardest != nullptr ? hardest->start : 0, "s"));
  }
}

std::vector<std::vector<StoryValue>> gravity_left_out(std::size_t loaded, std::size_t counted) {
  if (loaded == counted) return {};
  return {{word_of("what", loaded == 0 ? "remarks.no_gravity" : "remarks.gravity_of")}};
}

}  // namespace story

Story run_story(const RunResults& run) { return story_of(run); }
Story run_story(const PlanRun& run) { return story_of(run); }

Story gap_story(const RunResults& run) { return story_of_gaps(run); }
Story gap_story(const PlanRun& run) { return story_of_gaps(run); }

std::vector<StoryTable> gap_tables_of(const RunResults& run) { return tables_of_gaps(run); }
std::vector<StoryTable> gap_tables_of(const PlanRun& run) { return tables_of_gaps(run); }

}  // namespace bentur
