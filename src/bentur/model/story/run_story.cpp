#include <algorithm>
#include <cmath>
#include <limits>

#include "bentur/model/story/internal/story_parts.h"

namespace bentur {
namespace story {

Statement model_statement(const RunResults& run) {
  std::size_t counted = 0, loaded = 0, moved = 0;  // buildings, those with gravity loads, those on soil or bearings
  for (const Building& building : run.problem.buildings) {
    if (building.is_rigid()) continue;
    ++counted;
    loaded += building.has_gravity_loads ? 1 : 0;
    moved += building.model.foundation || building.model.slab ? 1 : 0;
  }
  Statement statement{.kind = some_building_yields(run.problem, run.response) ? "model_yielding" : "model",
                      .severity = Severity::remark};
  const auto leave_out = [&](const char* key) { statement.items.push_back({word_of("what", key)}); };
  statement.items = gravity_left_out(loaded, counted);
  leave_out("remarks.no_torsion");
  if (moved < counted) leave_out(moved == 0 ? "remarks.no_soil" : "remarks.soil_of");
  return statement;
}

void tell_collapse(const std::optional<Collapse>& with, const std::optional<Collapse>& without, double drift,
                   const std::function<std::pair<std::string, Eigen::Index>(const Collapse&)>& place,
                   std::vector<Statement>& statements) {
  const auto tell = [&](const Collapse& collapse, const char* kind) {
    const auto [building, storey] = place(collapse);
    statements.push_back({.kind = kind,
                          .severity = Severity::danger,
                          .buildings = {collapse.building},
                          .values = {text_of("building", building), count_of("storey", storey),
                                     value_in("time", collapse.time, "s"), value_in("limit", percent * drift, "%")}});
  };
  if (with) {
    tell(*with, "collapse");
    if (!without) statements.push_back({.kind = "collapse_by_contact", .severity = Severity::danger});
  }
  if (without) tell(*without, with ? "collapse_also_alone" : "collapse_alone");
}

void tell_drift_beyond(const WorstDrift& worst, double limit, std::vector<Statement>& statements) {
  if (!(worst.ratio > limit)) return;
  statements.push_back(
      {.kind = worst.is_alone ? "drift_beyond_alone" : "drift_beyond",
       .severity = Severity::danger,
       .buildings = {worst.building},
       .level = worst.level,
       .values = {text_of("building", worst.name), count_of("storey", worst.storey),
                  value_in("drift", percent * worst.ratio, "%"), value_in("limit", percent * limit, "%")}});
}

std::vector<std::vector<StoryValue>> gravity_left_out(std::size_t loaded, std::size_t counted) {
  if (loaded == counted) return {};
  return {{word_of("what", loaded == 0 ? "remarks.no_gravity" : "remarks.gravity_of")}};
}

namespace {

/// An entry of a list that results leave out where nothing of it is known.
double known(const Eigen::VectorXd& list, Eigen::Index i) {
  return i < list.size() ? list(i) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Eigen::Index most_softened(const BuildingPeaks::Yielding& yielding) {
  Eigen::Index worst = -1;
  for (Eigen::Index f = 0; f < yielding.strength_left.size(); ++f) {
    if (std::isnan(known(yielding.capped_time, f)) && std::isnan(known(yielding.failed_time, f))) continue;
    if (worst < 0 || yielding.strength_left(f) < yielding.strength_left(worst)) worst = f;
  }
  return worst;
}

Statement lost_strength(const BuildingPeaks::Yielding& yielding, Eigen::Index storey) {
  const double failed = known(yielding.failed_time, storey), residual = known(yielding.residual_time, storey);
  const bool has_failed = !std::isnan(failed), to_residual = !std::isnan(residual);
  const double time = has_failed ? failed : to_residual ? residual : known(yielding.capped_time, storey);
  return {.kind = has_failed    ? "storey_fails"
                  : to_residual ? "storey_at_residual"
                                : "storey_softens",
          .severity = has_failed ? Severity::danger : Severity::warning,
          .values = {value_in("time", time, "s"), value_in("left", percent * yielding.strength_left(storey), "%")}};
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

std::vector<std::vector<ScreeningFinding>> screened(const Case& c, const Problem& problem) {
  std::vector<std::vector<ScreeningFinding>> all;
  for (Eigen::Index gap = 0; gap + 1 < std::ssize(problem.buildings) && !c.buildings.empty(); ++gap) {
    all.push_back(screening(problem, gap, c.screening, c.units));
  }
  return all;
}

GapView judged_view_of(const RunResults& run) {
  GapView view = view_of(run);
  for (JudgedGap& one : judged_gaps(run)) {
    view.facts.push_back(std::move(one.facts));
    view.judged.push_back(std::move(one.judgement));
  }
  return view;
}

GapView judged_view_of(const Case& c, const Problem& problem, const SpectralGaps& spectral) {
  GapView view{.c = c, .problem = problem, .levels = spectral.levels, .screened = screened(c, problem)};
  for (JudgedGap& one : judged_gaps(c, problem, spectral)) {
    view.facts.push_back(std::move(one.facts));
    view.judged.push_back(std::move(one.judgement));
  }
  return view;
}

GapView view_of(const RunResults& run) {
  return {.c = run.c,
          .problem = run.problem,
          .response = &run.response,
          .levels = separations(run.problem, run.response, run.c.code, run.c.units),
          .collapsed = run.response.collapse_no_contact.has_value(),
          .screened = screened(run.c, run.problem)};
}

}  // namespace story
namespace {

using Eigen::Index;
using story::count_of;
using story::GapView;
using story::text_of;
using story::value_in;
using story::word_of;

std::string acceleration_unit(const Units& units) { return units.length + "/s²"; }

void tell_collapse(const RunResults& run, std::vector<Statement>& statements) {
  story::tell_collapse(
      run.response.collapse, run.response.collapse_no_contact, run.problem.collapse_drift,
      [&](const Collapse& one) {
        const Building& building = run.problem.buildings[one.building];
        return std::pair(building.name, building.model.storey_number(one.storey));
      },
      statements);
}

void tell_drifts(const RunResults& run, std::vector<Statement>& statements) {
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const Building& building = run.problem.buildings[b];
    const BuildingPeaks& peaks = run.response.buildings[b];
    if (building.is_rigid() || building.has_gravity_loads) continue;
    const LargestDrift with = largest_drift(peaks.drift_ratio), alone = largest_drift(peaks.drift_ratio_no_contact);
    const bool is_alone = alone.ratio > with.ratio;
    const LargestDrift& worst = is_alone ? alone : with;
    story::tell_drift_beyond({.building = b,
                              .name = building.name,
                              .storey = building.model.storey_number(worst.storey),
                              .level = building.model.elevations[worst.storey],
                              .ratio = worst.ratio,
                              .is_alone = is_alone},
                             run.problem.collapse_drift, statements);
  }
}

/// Columns beyond what they bear: of each gap the worst in shear and in moment.
void tell_columns(const RunResults& run, Index gap, std::vector<Statement>& statements) {
  const RunView view = run.view();
  for (const bool shear : {true, false}) {
    const Quantity& ratio =
        quantity_named(shear ? "column_shear_demand_capacity" : "column_moment_demand_capacity", Owner::point);
    Index worst = -1;
    double most = 1 + story::reached;
    long beyond = 0;
    for (const Index i : gap_at(run.problem, gap).points) {
      const double value = value_of(ratio, view, {i, 0});
      beyond += value > 1 + story::reached ? 1 : 0;
      if (!(value > most)) continue;
      most = value;
      worst = i;
    }
    if (worst < 0) continue;
    const ContactPoint& point = run.problem.points[worst];
    const ColumnPeaks& column = *run.response.points[worst].column;
    const Index building = struck_column(run.problem, point)->building;
    const char* const form = shear ? "F" : "F L";
    const std::string unit = unit_text(form, view.shown.units);
    const double factor = view.shown.factor(form);
    const double demand = factor * (shear ? column.shear : column.moment);
    const double alone = factor * (shear ? column.shear_no_contact : column.moment_no_contact);
    const double capacity = demand / most;
    statements.push_back({.kind = shear ? "column_shear" : "column_moment",
                          .severity = Severity::danger,
                          .gap = gap,
                          .buildings = {building},
                          .level = point.elevation,
                          .values = {text_of("building", run.problem.buildings[building].name),
                                     value_in("level", point.elevation, run.c.units.length), value_in("ratio", most),
                                     value_in("demand", demand, unit), value_in("capacity", capacity, unit),
                                     value_in("alone", alone / capacity)}});
    if (beyond > 1) statements.back().values.push_back(count_of("beyond", beyond));
    statements.back().values.push_back(beyond > 1 ? word_of("others", "story.columns_beyond") : text_of("others", ""));
  }
}

/// Completes what is said of buildings that collide.
void tell_hit(const RunResults& run, const GapOutcome& found, Statement statement, std::vector<Statement>& statements) {
  statement.severity = Severity::warning;
  statement.level = run.problem.points[*found.hardest].elevation;
  statement.values.push_back(count_of("times", found.impacts));
  statement.values.push_back(count_of("touched", found.touched));
  statement.values.push_back(count_of("points", std::ssize(found.gap.points)));
  statement.values.push_back(value_in("level", *statement.level, run.c.units.length));
  story::tell_blow(run.response.points[*found.hardest], hardest_impact(run.response, *found.hardest),
                   shown_units(run.c.units, run.response), statement);
  statements.push_back(std::move(statement));
}

/// What is said first of a gap, what it needs and what rules ask.
void tell_gap(const RunResults& run, const GapView& view, const GapOutcome& found, std::vector<Statement>& statements) {
  const Index gap = found.gap.left;
  const auto hit = [&](Statement one) { tell_hit(run, found, std::move(one), statements); };
  story::tell_judgement(view, gap, hit, statements);
  story::tell_need(view, gap, statements);
  story::tell_rules(view, gap, statements);
}

/// The largest of a quantity of floors over all buildings; NaN where none has one.
double largest_floor_value(const RunView& view, const char* key, QuantityPlace& place) {
  const Quantity& quantity = quantity_named(key, Owner::floor);
  double most = std::numeric_limits<double>::quiet_NaN();
  for (Index b = 0; b < std::ssize(view.problem.buildings); ++b) {
    for (const QuantityPlace& at : floors_of(view.problem, b)) {
      const double value = value_of(quantity, view, at);
      if (std::isnan(value) || value <= most) continue;
      most = value;
      place = at;
    }
  }
  return most;
}

/// A statement of the largest of a quantity of floors: {building}, {level}.
Statement floor_statement(const RunResults& run, std::string kind, const QuantityPlace& place) {
  const Building& building = run.problem.buildings[place.item];
  const double level = building.model.elevations[place.floor];
  return {.kind = std::move(kind),
          .buildings = {place.item},
          .level = level,
          .values = {text_of("building", building.name), value_in("level", level, run.c.units.length)}};
}

/// What contact does to displacements, accelerations and shears.
void tell_effects(const RunResults& run, std::vector<Statement>& statements) {
  const RunView view = run.view();
  QuantityPlace place;
  if (!run.response.impacts.empty()) {
    if (const double most = largest_floor_value(view, "amplification", place); most > 1 + 1e-9) {
      const BuildingPeaks& peaks = run.response.buildings[place.item];
      statements.push_back(floor_statement(run, "amplified", place));
      auto& values = statements.back().values;
      values.push_back(value_in("factor", most));
      values.push_back(value_in("with", peaks.displacement(place.floor), run.c.units.length));
      values.push_back(value_in("without", peaks.displacement_no_contact(place.floor), run.c.units.length));
    } else if (!std::isnan(most)) {
      statements.push_back({.kind = "not_amplified"});
    }
    for (const char* const key : {"acceleration_ratio", "storey_shear_ratio"}) {
      const double most = largest_floor_value(view, key, place);
      if (!(most > 0)) continue;
      constexpr double seen = 1.005;  // with three digits
      if (most < seen) {
        statements.push_back({.kind = std::string(key) + "_none"});
        continue;
      }
      statements.push_back(floor_statement(run, key, place));
      statements.back().values.push_back(value_in("factor", most));
    }
  }
  if (const double fastest = largest_floor_value(view, "peak_acceleration", place); !std::isnan(fastest)) {
    statements.push_back(floor_statement(run, "acceleration", place));
    auto& values = statements.back().values;
    values.push_back(value_in("acceleration", fastest, acceleration_unit(run.c.units)));
    values.push_back(value_in("in_g", fastest / run.c.units.gravity, "g"));
  }
}

/// The largest ductility of each building that can yield.
void tell_yielding(const RunResults& run, std::vector<Statement>& statements) {
  for (Index b = 0; b < std::ssize(run.response.buildings); ++b) {
    const auto& with = run.response.buildings[b].yielding.ductility;
    const auto& without = run.response.buildings[b].yielding_no_contact.ductility;
    Index worst = -1;
    for (Index storey = 0; storey < with.size(); ++storey) {
      if (with(storey) > 1 && (worst < 0 || with(storey) > with(worst))) worst = storey;
    }
    if (worst < 0) continue;
    const Building& building = run.problem.buildings[b];
    const bool bearings = worst < building.model.first_storey();
    Statement statement{.kind = bearings ? "bearings_yield" : "storey_yields", .buildings = {b}};
    statement.values = {text_of("building", building.name), value_in("ductility", with(worst))};
    if (!bearings) statement.values.push_back(count_of("storey", building.model.storey_number(worst)));
    const bool known = worst < without.size() && !std::isnan(without(worst));
    if (known) statement.values.push_back(value_in("alone", without(worst)));
    statement.values.push_back(known ? word_of("comparison", "story.ductility_alone") : text_of("comparison", ""));
    statements.push_back(std::move(statement));
  }
}

/// Of each building the storey that has least of its strength left, where some has softened.
void tell_lost_strength(const RunResults& run, std::vector<Statement>& statements) {
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const Building& building = run.problem.buildings[b];
    const BuildingPeaks::Yielding& yielding = run.response.buildings[b].yielding;
    const Index worst = story::most_softened(yielding);
    if (worst < 0) continue;
    Statement statement = story::lost_strength(yielding, worst);
    statement.buildings = {b};
    statement.level = building.model.elevations[worst];
    statement.values.push_back(text_of("building", building.name));
    statement.values.push_back(count_of("storey", building.model.storey_number(worst)));
    statements.push_back(std::move(statement));
  }
}

void tell_motion(const RunResults& run, std::vector<Statement>& statements) {
  const double pga = applied_pga(run.c);
  if (!(pga > 0)) return;
  statements.push_back({.kind = "pga",
                        .values = {value_in("pga", pga, acceleration_unit(run.c.units)),
                                   value_in("in_g", pga / run.c.units.gravity, "g")}});
}

void tell_row(const RunResults& run, const GapView& view, const std::vector<GapOutcome>& all, Story& told) {
  std::vector<story::GapLine> lines;
  for (const GapOutcome& one : all) {
    const auto gap = static_cast<std::size_t>(one.gap.left);
    lines.push_back({.name = gap_name(run.problem, one.gap.left),
                     .facts = &view.facts.at(gap),
                     .judged = view.judged.at(gap).value,
                     .impacts = one.impacts,
                     .peak_force = one.hardest ? run.response.points[*one.hardest].peak_force : 0});
  }
  story::tell_gaps(lines, shown_units(run.c.units, run.response), run.c.units.length, told);
}

/// Of every gap.
std::vector<StoryTable> tables_of(const GapView& facts) {
  std::vector<StoryTable> tables;
  for (Index gap = 0; gap + 1 < std::ssize(facts.problem.buildings); ++gap) {
    for (StoryTable& table : story::gap_tables(facts, gap)) tables.push_back(std::move(table));
  }
  return tables;
}

/// Remarks and what the model leaves out, after all else.
void tell_remarks(const RunResults& run, Story& told) {
  sort_by_severity(told.statements);
  story::tell_quotations(run.c.code, told.statements);
  put_remarks(run.remarks, told.statements);
  told.statements.push_back(story::model_statement(run));
}

}  // namespace

Story run_story(const RunResults& run) {
  const GapView view = story::judged_view_of(run);
  std::vector<GapOutcome> all;
  for (const Gap& gap : gaps_of(run.problem)) all.push_back(gap_outcome(run.problem, run.response, gap.left));
  Story told;
  tell_collapse(run, told.statements);
  for (const GapOutcome& found : all) tell_columns(run, found.gap.left, told.statements);
  for (const GapOutcome& found : all) story::tell_unmodelled(view, found.gap.left, told.statements);
  tell_drifts(run, told.statements);
  tell_lost_strength(run, told.statements);
  story::tell_breaking(run, told);
  story::tell_infill(run, told.statements);
  tell_row(run, view, all, told);
  for (const GapOutcome& found : all) tell_gap(run, view, found, told.statements);
  tell_effects(run, told.statements);
  tell_yielding(run, told.statements);
  story::tell_hinges(run, told);
  story::tell_links(run.problem, run.response.links, shown_units(run.c.units, run.response), run.c.units.length,
                    told.statements);
  tell_motion(run, told.statements);
  tell_remarks(run, told);
  return told;
}

Story gap_story(const RunResults& run) {
  const GapView view = story::judged_view_of(run);
  Story told;
  tell_collapse(run, told.statements);
  tell_drifts(run, told.statements);
  for (const Gap& gap : gaps_of(run.problem)) {
    story::tell_unmodelled(view, gap.left, told.statements);
    tell_gap(run, view, gap_outcome(run.problem, run.response, gap.left), told.statements);
  }
  tell_motion(run, told.statements);
  tell_remarks(run, told);
  told.tables = tables_of(view);
  return told;
}

std::vector<StoryTable> gap_tables_of(const RunResults& run) { return tables_of(story::judged_view_of(run)); }

}  // namespace bentur
