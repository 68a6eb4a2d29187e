#include <algorithm>
#include <cmath>
#include <utility>

#include "bentur/core/not_known.h"
#include "bentur/model/story/internal/run_parts.h"

// The story of a run, of a row as of buildings in plan.
namespace bentur {
namespace story {

template <class AnyRun>
Statement model_statement(const AnyRun& run) {
  std::size_t counted = 0, loaded = 0, moved = 0;  // buildings, those with gravity loads, those on soil or bearings
  Statement statement{.kind = "model_plan", .severity = Severity::remark};
  for (const auto& building : run.problem.buildings) {
    counted += building.is_rigid() ? 0 : 1;
    loaded += has_gravity(building) ? 1 : 0;
    moved += has_soil(building) || building.model.slab ? 1 : 0;
  }
  const auto leave_out = [&](const char* key) { statement.items.push_back({word_of("what", key)}); };
  const bool yields = some_building_yields(run.problem, run.response);
  if (loaded < counted) leave_out(loaded == 0 ? "remarks.no_gravity" : "remarks.gravity_of");
  if constexpr (is_in_plan<AnyRun>) {
    statement.values = {word_of("planes", yields ? "remarks.planes_yield" : "remarks.planes_elastic")};
    if (has_bearings_by_axes(run.problem)) leave_out("remarks.bearings_by_axes");
  } else {
    statement.kind = yields ? "model_yielding" : "model";
    leave_out("remarks.no_torsion");
  }
  if (moved < counted) leave_out(moved == 0 ? "remarks.no_soil" : "remarks.soil_of");
  return statement;
}
template Statement model_statement(const RunResults& run);
template Statement model_statement(const PlanRun& run);

}  // namespace story

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
  const auto &in_contact = run.response.collapse, &alone = run.response.collapse_no_contact;
  if (in_contact) tell(*in_contact, "collapse");
  if (in_contact && !alone) statements.push_back({.kind = "collapse_by_contact", .severity = Severity::danger});
  if (alone) tell(*alone, in_contact ? "collapse_also_alone" : "collapse_alone");
}

/// An entry of a list that results leave out where nothing of it is known.
double known(const Eigen::VectorXd& list, Index i) { return i < list.size() ? list(i) : not_known; }

/// Of each building what is said of the storey with the largest value beyond `least`.
/// @param value of (building, its storeys, storey); NaN: there is none @param say the statement, of the same
template <class AnyRun, class Value, class Say>
void tell_worst_storeys(const AnyRun& run, double least, Value value, Say say, std::vector<Statement>& statements) {
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    double most = least;
    std::optional<Statement> worst;
    for (const Storeys& all : storeys_of(run.problem, run.response, b)) {
      for (Index storey = 0; storey < run.problem.buildings[b].model.floors(); ++storey) {
        const double found = value(b, all, storey);
        if (!(found > most)) continue;
        most = found;
        worst = say(b, all, storey);
      }
    }
    if (worst) statements.push_back(std::move(*worst));
  }
}

/// Buildings that drift beyond what counts as collapse, where nothing looks for that since no gravity acts.
template <class AnyRun>
void tell_drifts(const AnyRun& run, std::vector<Statement>& statements) {
  const double limit = run.problem.collapse_drift;
  const auto drift = [&](Index b, const Storeys& all, Index storey) {
    const auto& building = run.problem.buildings[b];
    if (building.is_rigid() || has_gravity(building)) return not_known;
    return std::fmax(known(all.drift, storey), known(all.drift_alone, storey));
  };
  const auto say = [&](Index b, const Storeys& all, Index storey) {
    const double most = drift(b, all, storey);
    return Statement{.kind = known(all.drift, storey) == most ? "drift_beyond" : "drift_beyond_alone",
                     .severity = Severity::danger,
                     .buildings = {b},
                     .level = run.problem.buildings[b].model.elevations[storey],
                     .values = {text_of("building", all.name),
                                count_of("storey", run.problem.buildings[b].model.storey_number(storey)),
                                value_in("drift", percent * most, "%"), value_in("limit", percent * limit, "%")}};
  };
  tell_worst_storeys(run, limit, drift, say, statements);
}

/// What storeys have lost of their strength: of each building the one with least left of those that have softened.
template <class AnyRun>
void tell_lost_strength(const AnyRun& run, std::vector<Statement>& statements) {
  const auto lost = [&](Index /*b*/, const Storeys& all, Index storey) {
    const BuildingPeaks::Yielding& of = *all.yielding;
    const bool softened = !std::isnan(known(of.capped_time, storey)) || !std::isnan(known(of.failed_time, storey));
    return softened ? 1 - known(of.strength_left, storey) : not_known;
  };
  const auto say = [&](Index b, const Storeys& all, Index storey) {
    const auto& model = run.problem.buildings[b].model;
    const BuildingPeaks::Yielding& of = *all.yielding;
    const double failed = known(of.failed_time, storey), residual = known(of.residual_time, storey);
    const bool has_failed = !std::isnan(failed), to_residual = !has_failed && !std::isnan(residual);
    const double time = has_failed ? failed : to_residual ? residual : known(of.capped_time, storey);
    return Statement{.kind = has_failed    ? "storey_fails"
                             : to_residual ? "storey_at_residual"
                                           : "storey_softens",
                     .severity = has_failed ? Severity::danger : Severity::warning,
                     .buildings = {b},
                     .level = model.elevations[storey],
                     .values = {value_in("time", time, "s"), value_in("left", percent * of.strength_left(storey), "%"),
                                text_of("building", all.name), count_of("storey", model.storey_number(storey))}};
  };
  tell_worst_storeys(run, -1, lost, say, statements);
}

/// @param storey nothing: of bearings @param alone without contact; NaN: not known
Statement yields(Index b, const std::string& name, double ductility, std::optional<long> storey, double alone) {
  Statement statement{.kind = storey ? "storey_yields" : "bearings_yield",
                      .buildings = {b},
                      .values = {text_of("building", name), value_in("ductility", ductility)}};
  if (storey) statement.values.push_back(count_of("storey", *storey));
  if (std::isnan(alone)) return with(std::move(statement), text_of("comparison", ""));
  return with(std::move(statement), value_in("alone", alone), word_of("comparison", "story.ductility_alone"));
}

/// The largest ductility of each building that can yield.
template <class AnyRun>
void tell_yielding(const AnyRun& run, std::vector<Statement>& statements) {
  const auto ductility = [](Index /*b*/, const Storeys& all, Index i) { return known(all.yielding->ductility, i); };
  const auto say = [&](Index b, const Storeys& all, Index i) {
    const auto& model = run.problem.buildings[b].model;
    const bool is_storey = i >= model.first_storey();  // else a row's bearings
    return yields(b, all.name, ductility(b, all, i),
                  is_storey ? std::optional<long>(model.storey_number(i)) : std::nullopt,
                  known(all.yielding_alone->ductility, i));
  };
  tell_worst_storeys(run, 1, ductility, say, statements);
  if constexpr (is_in_plan<AnyRun>) {
    for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
      const double bearings = ductility_of_bearings(run, b);
      if (!(bearings > 1)) continue;
      statements.push_back(yields(b, run.problem.buildings[b].name, bearings, {}, known({}, 0)));
    }
  }
}

/// Completes what is said of buildings that collide: the force and how long it lasts, or of contacts without force the
/// speed.
template <class AnyRun>
void tell_hit(const AnyRun& run, std::size_t gap, Statement statement, std::vector<Statement>& statements) {
  const std::vector<Index> points = points_from_top(run.problem, gap);
  const Hit hit = hit_of(run.response.points, run.response.impacts, points);
  const PointSummary& point = run.response.points[hit.point];
  const ShownUnits shown = shown_units(run);
  statement.severity = Severity::warning;
  statement = with(std::move(statement), count_of("times", hit.impacts), count_of("touched", hit.touched));
  put_place(run, gap, hit.point, std::ssize(points), statement);
  if (!(point.peak_force > 0)) {
    statement.kind = "pounding_impulse";
    statement = with(std::move(statement), value_in("speed", point.peak_closing_speed, shown.units.length + "/s"),
                     value_in("time", hit.hardest != nullptr ? hit.hardest->start : 0, "s"));
  } else {
    statement.kind = "pounding";
    statement = with(std::move(statement), value_in("force", shown.force * point.peak_force, shown.units.force),
                     value_in("time", point.peak_force_time.value_or(0), "s"));
    statement = hit.hardest == nullptr ? with(std::move(statement), text_of("lasting", ""))
                                       : with(std::move(statement),
                                              value_in("contact", 1e3 * (hit.hardest->end - hit.hardest->start), "ms"),
                                              word_of("lasting", "story.lasting"));
  }
  statements.push_back(std::move(statement));
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

/// What contact does to displacements, accelerations and shears.
template <class AnyRun>
void tell_effects(const AnyRun& run, std::vector<Statement>& statements) {
  constexpr double round_off = 1e-9, seen = 1.005;  // with three digits
  const std::string& length = run.c.units.length;
  if (!run.response.impacts.empty()) {
    const LargestOfFloors moves = largest_of_floors(run, "amplification");
    const bool is_amplified = moves.value > 1 + round_off;
    if (is_amplified) {
      const double alone = value_at(run, "peak_displacement_no_contact", moves);
      statements.push_back(with(of_floor(run, moves, "amplified"), value_in("factor", moves.value),
                                value_in("with", value_at(run, "peak_displacement", moves), length),
                                value_in("without", alone, length)));
    }
    bool turns = false;
    if constexpr (is_in_plan<AnyRun>) turns = tell_turning(run, statements);
    if (!is_amplified && !turns && !std::isnan(moves.value)) statements.push_back({.kind = "not_amplified"});
    for (const std::string key : {"acceleration_ratio", "storey_shear_ratio"}) {
      const LargestOfFloors most = largest_of_floors(run, key);
      if (!(most.value > 0)) continue;
      statements.push_back(most.value < seen ? Statement{.kind = key + "_none"}
                                             : with(of_floor(run, most, key), value_in("factor", most.value)));
    }
  }
  const LargestOfFloors fastest = largest_of_floors(run, "peak_acceleration");
  if (std::isnan(fastest.value)) return;
  statements.push_back(with(of_floor(run, fastest, "acceleration"),
                            value_in("acceleration", fastest.value, length + "/s²"),
                            value_in("in_g", fastest.value / run.c.units.gravity, "g")));
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
    statements.push_back(with(std::move(statement), value_in("pga", peaks[i], run.c.units.length + "/s²"),
                              value_in("in_g", peaks[i] / run.c.units.gravity, "g")));
  }
}

/// Where floors meet that no contact is modelled between, an impact is the hardest of those that are modelled.
void tell_what_is_modelled(std::vector<Statement>& statements) {
  const bool lacks =
      std::any_of(statements.begin(), statements.end(), [](const Statement& one) { return one.kind == "unmodelled"; });
  for (Statement& one : statements) {
    if (one.kind != "pounding") continue;
    one.values.push_back(lacks ? word_of("modelled", "story.of_modelled") : text_of("modelled", ""));
  }
}

/// Of several gaps that close what is said of all of them says how often, and of the hardest impact where and when.
void tell_hardest(std::vector<Statement>& statements) {
  const auto all = std::find_if(statements.begin(), statements.end(),
                                [](const Statement& one) { return one.kind == "row_some" || one.kind == "row_all"; });
  if (all == statements.end()) return;
  const Statement* const hardest = hardest_impact_of(statements);
  if (hardest == nullptr) return;
  long times = 0, closed = 0;
  for (const Statement& one : statements) {
    if (!one.gap || !one.kind.starts_with("pounding")) continue;
    ++closed;
    const auto counted = std::find_if(one.values.begin(), one.values.end(),
                                      [](const StoryValue& value) { return value.name == "times"; });
    times += std::get<long>(counted->value);
  }
  std::vector<StoryValue> values = hardest->values;
  std::erase_if(values, [](const StoryValue& one) { return one.name == "times"; });
  all->kind = "row_" + hardest->kind;
  all->buildings = hardest->buildings;
  all->level = hardest->level;
  all->values.insert(all->values.end(), values.begin(), values.end());
  all->values.push_back(count_of("times", times));
  all->values.push_back(count_of("closed", closed));
}

/// What a table says as well as a sentence. @param worst of many gaps the one that sentences are about
void leave_to_tables(std::optional<Index> worst, std::vector<Statement>& statements) {
  constexpr std::string_view rows[] = {
      "pga",           "pga_along",          "pga_along_turned",        "acceleration",   "acceleration_ratio_none",
      "not_amplified", "storey_shear_ratio", "storey_shear_ratio_none", "rules",          "rules_less",
      "rules_short",   "rules_silent",       "reversed_alone",          "reversed_enough"};
  for (Statement& one : statements) {
    if (one.severity == Severity::danger) continue;
    const bool is_reversed = one.kind.starts_with("reversed_");
    // Where the motion reversed needs the more, of many gaps that of the worst one.
    if (is_reversed && is_grave(one.severity) && one.shown == Shown::sentence && (!worst || one.gap == worst)) continue;
    if (std::find(std::begin(rows), std::end(rows), one.kind) != std::end(rows)) one.shown = Shown::row;
    if (one.kind == "rules_understate") one.shown = Shown::table;  // a note of the rules' rows
    if (worst && is_reversed) one.shown = Shown::table;            // which has it of every gap
    if (one.kind == "row_pushed") continue;                        // which has a row of its own
    if (worst && one.gap && (*one.gap != *worst || one.kind.starts_with("pounding"))) one.shown = Shown::table;
  }
}

/// How much the rule that understates the most lacks.
double most_lacking(const Statement& statement) {
  double most = 0;
  for (const auto& item : statement.items) {
    for (const StoryValue& value : item) {
      if (value.name == "lacks") most = std::max(most, std::get<double>(value.value));
    }
  }
  return most;
}

/// What the tables of a gap's levels and rules have. @param many of many gaps one sentence has the worst of its kind
void leave_to_gap_tables(bool many, std::vector<Statement>& statements) {
  for (Statement& one : statements) {
    const bool is_level = one.kind.starts_with("reversed_") && one.shown == Shown::row;
    if (is_level || one.kind.starts_with("rules")) one.shown = Shown::table;
    if (one.kind == "rules_understate") one.shown = many ? Shown::table : Shown::sentence;
  }
  if (!many) return;
  Statement* worst = nullptr;
  long others = -1;
  for (Statement& one : statements) {
    if (one.kind != "rules_understate") continue;
    ++others;
    if (worst == nullptr || most_lacking(one) > most_lacking(*worst)) worst = &one;
  }
  if (worst == nullptr) return;
  worst->shown = Shown::sentence;
  if (others > 0) {
    worst->values = {word_of("more", "story.rules_understate_more"), count_of("others", others)};
  }
}

/// Remarks and what the model leaves out, after all else.
template <class AnyRun>
void tell_remarks(const AnyRun& run, Story& told) {
  sort_by_severity(told.statements);
  tell_quotations(run.c.code, told.statements);
  put_remarks(run.remarks, told.statements);
  if constexpr (is_in_plan<AnyRun>) tell_left_out(run, told.statements);
  told.statements.push_back(model_statement(run));
}

void rank_gaps(const GapView& view, std::vector<Statement>& statements) {
  if (view.gaps.size() < 2) return;
  const std::vector<std::size_t> order = worst_first(view.gaps);
  for (Statement& one : statements) {
    if (!one.gap) continue;
    const auto place = std::find(order.begin(), order.end(), static_cast<std::size_t>(*one.gap));
    one.rank = 1 + (place - order.begin());
  }
}

template <class AnyRun>
Story story_of(const AnyRun& run) {
  const GapView view = judged_view_of(run);
  Story told;
  tell_collapse(run, told.statements);
  tell_columns(run, told.statements);
  tell_drifts(run, told.statements);
  tell_lost_strength(run, told.statements);
  if constexpr (!is_in_plan<AnyRun>) {  // in plan with the hinges of frames
    tell_breaking(run, told);
    tell_infill(run, told.statements);
  }
  const std::optional<Index> worst = tell_gaps(view, shown_units(run), told);
  for (std::size_t g = 0; g < view.gaps.size(); ++g) tell_gap(run, view, g, told.statements);
  if constexpr (is_in_plan<AnyRun>) {
    tell_slips(run, told.statements);
    tell_pairs_without_contact(run, told.statements);
  }
  tell_effects(run, told.statements);
  tell_yielding(run, told.statements);
  story::tell_hinges(run, told);
  tell_links(run.problem, run.response.links, shown_units(run), run.c.units.length, told.statements);
  tell_bounds(view, told.statements);
  tell_motion(run, told.statements);
  tell_what_is_modelled(told.statements);
  tell_hardest(told.statements);
  leave_to_tables(worst, told.statements);
  rank_gaps(view, told.statements);
  tell_remarks(run, told);
  return told;
}

std::vector<StoryTable> tables_of(const GapView& view) {
  std::vector<StoryTable> tables;
  for (Index g = 0; g < std::ssize(view.gaps); ++g) {
    for (StoryTable& one : gap_tables(view, g)) tables.push_back(std::move(one));
  }
  return tables;
}

template <class AnyRun>
Story story_of_gaps(const AnyRun& run) {
  const GapView view = judged_view_of(run);
  Story told;
  tell_collapse(run, told.statements);
  tell_drifts(run, told.statements);
  const std::optional<Index> worst = tell_gaps(view, shown_units(run), told);
  for (std::size_t g = 0; g < view.gaps.size(); ++g) tell_gap(run, view, g, told.statements);
  for (StoryTable& one : tables_of(view)) told.tables.push_back(std::move(one));
  if constexpr (is_in_plan<AnyRun>) tell_pairs_without_contact(run, told.statements);
  tell_bounds(view, told.statements);
  tell_motion(run, told.statements);
  tell_what_is_modelled(told.statements);
  tell_hardest(told.statements);
  leave_to_tables(worst, told.statements);
  rank_gaps(view, told.statements);
  leave_to_gap_tables(worst.has_value(), told.statements);
  tell_remarks(run, told);
  return told;
}

}  // namespace

namespace story {

std::string key_along(const std::string& key, const std::string& axis) {
  const std::string end = "_no_contact";
  if (axis.empty()) return key;
  const bool has_end = key.ends_with(end);
  return (has_end ? key.substr(0, key.size() - end.size()) : key) + "_" + axis + (has_end ? end : "");
}

}  // namespace story

Story run_story(const RunResults& run) { return story_of(run); }
Story run_story(const PlanRun& run) { return story_of(run); }

Story gap_story(const RunResults& run) { return story_of_gaps(run); }
Story gap_story(const PlanRun& run) { return story_of_gaps(run); }

std::vector<StoryTable> gap_tables_of(const RunResults& run) { return tables_of(judged_view_of(run)); }
std::vector<StoryTable> gap_tables_of(const PlanRun& run) { return tables_of(judged_view_of(run)); }

}  // namespace bentur
