#include <algorithm>
#include <cmath>

#include "bentur/model/story/internal/run_parts.h"

// What the story of a run asks of a row.
namespace bentur::story {
namespace {

using Eigen::Index;

void tell_columns_of(const RunResults& run, const Gap& gap, std::vector<Statement>& statements) {
  for (const bool shear : {true, false}) {
    const std::optional<WorstColumn> worst = worst_column(run, gap, shear);
    if (!worst || !(worst->ratio > 1 + reached)) continue;
    const double level = run.problem.points[worst->point].elevation;
    const double capacity = worst->demand / worst->ratio;
    statements.push_back(
        {.kind = shear ? "column_shear" : "column_moment",
         .severity = Severity::danger,
         .gap = gap.number,
         .buildings = {worst->building},
         .level = level,
         .values = {text_of("building", run.problem.buildings[worst->building].name),
                    value_in("level", level, run.c.units.length), value_in("ratio", worst->ratio),
                    value_in("demand", worst->demand, worst->unit), value_in("capacity", capacity, worst->unit),
                    value_in("alone", worst->alone / capacity)}});
    auto& values = statements.back().values;
    if (worst->beyond > 1) values.push_back(count_of("beyond", worst->beyond));
    values.push_back(worst->beyond > 1 ? word_of("others", "story.columns_beyond") : text_of("others", ""));
  }
}

}  // namespace

std::optional<WorstColumn> worst_column(const RunResults& run, const Gap& gap, bool shear) {
  const RunView view = run.view();
  const Quantity& ratio =
      quantity_named(shear ? "column_shear_demand_capacity" : "column_moment_demand_capacity", Owner::point);
  WorstColumn worst{.ratio = -1};
  for (const Index i : gap.points) {
    const double value = value_of(ratio, view, {i, 0});
    worst.beyond += value > 1 + reached ? 1 : 0;
    if (!(value > worst.ratio)) continue;
    worst.ratio = value;
    worst.point = i;
  }
  if (worst.ratio < 0) return std::nullopt;
  const ColumnPeaks& column = *run.response.points[worst.point].column;
  const char* const form = shear ? "F" : "F L";
  const double factor = view.shown.factor(form);
  worst.building = struck_column(run.problem, run.problem.points[worst.point])->building;
  worst.demand = factor * (shear ? column.shear : column.moment);
  worst.alone = factor * (shear ? column.shear_no_contact : column.moment_no_contact);
  worst.unit = unit_text(form, view.shown.units);
  return worst;
}

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

std::vector<std::vector<ScreeningFinding>> screened(const Case& c, const Problem& problem) {
  std::vector<std::vector<ScreeningFinding>> all;
  for (Index gap = 0; gap < gap_count(problem) && !c.buildings.empty(); ++gap) {
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
  const PlanProblem* const plan = spectral.plan.get();
  GapView view{.c = c,
               .problem = problem,
               .levels = spectral.levels,
               .screened = plan != nullptr ? screened(c, *plan) : screened(c, problem),
               .plan = plan};
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

Hit hit_of(const RunResults& run, std::size_t gap) {
  const GapOutcome found = gap_outcome(run.problem, run.response, static_cast<Index>(gap));
  return {.impacts = found.impacts,
          .touched = found.touched,
          .points = std::ssize(found.gap.points),
          .point = found.hardest.value(),
          .hardest = hardest_impact(run.response, *found.hardest)};
}

void put_place(const RunResults& run, std::size_t /*gap*/, const Hit& hit, Statement& statement) {
  statement.level = run.problem.points[hit.point].elevation;
  statement.values.push_back(count_of("points", hit.points));
  statement.values.push_back(value_in("level", *statement.level, run.c.units.length));
}

void tell_columns(const RunResults& run, std::vector<Statement>& statements) {
  for (const Gap& gap : gaps_of(run.problem)) tell_columns_of(run, gap, statements);
}

Index most_softened(const BuildingPeaks::Yielding& yielding) {
  const auto is_known = [](const Eigen::VectorXd& list, Index f) { return f < list.size() && !std::isnan(list(f)); };
  Index worst = -1;
  for (Index f = 0; f < yielding.strength_left.size(); ++f) {
    if (!is_known(yielding.capped_time, f) && !is_known(yielding.failed_time, f)) continue;
    if (worst < 0 || yielding.strength_left(f) < yielding.strength_left(worst)) worst = f;
  }
  return worst;
}

void tell_failures(const RunResults& run, Story& told) {
  tell_breaking(run, told);
  tell_infill(run, told.statements);
}

std::vector<Storeys> storeys_of(const RunResults& run, Index b) {
  const BuildingPeaks& peaks = run.response.buildings[b];
  return {{run.problem.buildings[b].name, peaks.drift_ratio, peaks.drift_ratio_no_contact, peaks.yielding,
           peaks.yielding_no_contact}};
}

}  // namespace bentur::story
