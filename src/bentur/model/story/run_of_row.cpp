#include <algorithm>
#include <cmath>

#include "bentur/model/contact/worst_column.h"
#include "bentur/model/story/internal/run_parts.h"

// What the story of a run asks of a row.
namespace bentur::story {

using Eigen::Index;

std::vector<std::vector<ScreeningFinding>> screened(const Case& c, const Problem& problem) {
  std::vector<std::vector<ScreeningFinding>> all;
  for (Index gap = 0; gap < gap_count(problem) && !c.buildings.empty(); ++gap) {
    all.push_back(screening(problem, gap, c.screening, c.units));
  }
  return all;
}

GapView judged_view_of(const RunResults& run) {
  GapView view = view_of(run);
  view.gaps = judged_gaps(run);
  return view;
}

GapView judged_view_of(const Case& c, const Problem& problem, const SpectralGaps& spectral) {
  const PlanProblem* const plan = spectral.plan.get();
  return {.c = c,
          .problem = problem,
          .levels = spectral.levels,
          .screened = plan != nullptr ? screened(c, *plan) : screened(c, problem),
          .plan = plan,
          .gaps = judged_gaps(c, problem, spectral)};
}

GapView view_of(const RunResults& run) {
  const auto goes_on = [](const auto& summary) { return comes_without_bound(summary.to_come); };
  const std::vector<PointSummary>& points = run.response.points;
  const std::vector<WatchedSummary>& watched = run.response.watched;
  return {.c = run.c,
          .problem = run.problem,
          .response = &run.response,
          .levels = separations(run.problem, run.response, run.c.code, run.c.units),
          .falls = falls_without_contact(run.problem, run.response),
          .is_cut = std::any_of(points.begin(), points.end(), goes_on) ||
                    std::any_of(watched.begin(), watched.end(), goes_on),
          .screened = screened(run.c, run.problem)};
}

std::vector<Index> points_from_top(const Problem& problem, std::size_t gap) {
  std::vector<Index> points = gap_at(problem, static_cast<Index>(gap)).points;
  std::reverse(points.begin(), points.end());
  return points;
}

void put_place(const RunResults& run, std::size_t /*gap*/, Index point, long points, Statement& statement) {
  statement.level = run.problem.points[point].elevation;
  statement =
      with(std::move(statement), count_of("points", points), value_in("level", *statement.level, run.c.units.length));
}

void tell_columns(const RunResults& run, std::vector<Statement>& statements) {
  for (const Gap& gap : gaps_of(run.problem)) {
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
}

std::vector<Storeys> storeys_of(const Problem& problem, const Response& response, Index b) {
  const BuildingPeaks& peaks = response.buildings[b];
  const auto lowest = [](const Eigen::VectorXd& shears) { return shears.size() > 0 ? shears(0) : 0; };
  return {{problem.buildings[b].name, peaks.drift_ratio, peaks.drift_ratio_no_contact, &peaks.yielding,
           &peaks.yielding_no_contact, &peaks, lowest(peaks.storey_shear), lowest(peaks.storey_shear_no_contact)}};
}

}  // namespace bentur::story
