#include "bentur/model/internal/quantity_sources.h"

#include <algorithm>
#include <utility>

#include "bentur/model/plan/plan_places.h"
#include "bentur/model/plan/plan_row.h"

namespace bentur::sources {

using Eigen::Index;
using Eigen::VectorXd;

QuantitySource of_gaps(double (*value)(const Problem&, const Response&, Index), bool both_ways) {
  QuantitySource source;
  source.row.value = [=](const RunView& run, const QuantityPlace& at) {
    return value(run.problem, run.response, at.item);
  };
  source.plan.value = [=](const PlanRun& run, const QuantityPlace& at) {
    if (both_ways && !run.c.analysis.both_ways) return not_known;
    const auto row = row_of(run);
    return value(row->problem, row->response, at.item);
  };
  return source;
}

QuantitySource needed_reversed() {
  QuantitySource source = of_points(&PointSummary::gap_needed_reversed);
  source.plan.value = [known = source.plan.value](const PlanRun& run, const QuantityPlace& at) {
    return run.c.analysis.both_ways ? known(run, at) : not_known;
  };
  return source;
}

QuantitySource widths() {
  QuantitySource source;
  source.row.value = [](const RunView& run, const QuantityPlace& at) { return run.problem.points[at.item].width; };
  source.plan.value = [](const PlanRun& run, const QuantityPlace& at) {
    const PlanContactPlace place = contact_at(run.problem, at.item);
    return run.problem.gaps[place.gap].width_at(*place.contact);
  };
  return source;
}

QuantitySource of_yielding(VectorXd BuildingPeaks::Yielding::*list, BuildingPeaks::Yielding BuildingPeaks::*of) {
  using Yielding = BuildingPeaks::Yielding;
  const auto losses = {&Yielding::strength_left, &Yielding::capped_time, &Yielding::residual_time,
                       &Yielding::failed_time};
  const When when = std::find(losses.begin(), losses.end(), list) != losses.end() ? When::loses_strength
                    : list == &Yielding::residual_drift_ratio                     ? When::yields_or_turns
                                                                                  : When::yields;
  return of_some_lists(
      when, [=](auto& peaks) -> auto& { return peaks.*of.*list; });
}

QuantitySource of_infill(VectorXd BuildingPeaks::Infill::*list) {
  const When when = list == &BuildingPeaks::Infill::column_demand ? When::infill_columns : When::infill;
  return of_some_lists(
      when, [list](auto& peaks) -> auto& { return peaks.infill.*list; });
}

QuantitySource of_foundation(Index entry) {
  QuantitySource source;
  source.row.value = [entry](const RunView& run, const QuantityPlace& at) {
    const VectorXd& values = run.response.buildings[at.item].foundation;
    return entry < values.size() ? values(entry) : not_known;
  };
  source.row.keep = [entry](Response& response, const QuantityPlace& at, double number) {
    VectorXd& values = response.buildings.at(at.item).foundation;
    if (values.size() <= entry) values.conservativeResize(entry + 1);
    values(entry) = number;
  };
  source.row.is_told = [](const RunView& run, Index b) { return run.response.buildings[b].foundation.size() > 0; };
  source.when = When::soil;
  return source;
}

QuantitySource of_weakening(std::optional<double> BuildingPeaks::Hinge::*member) {
  QuantitySource source = of_frames(When::weakening_hinges, &BuildingPeaks::hinges, member);
  source.row.is_told = [](const RunView& run, Index b) {
    const std::vector<BuildingPeaks::Hinge>& hinges = run.response.buildings[b].hinges;
    return std::any_of(hinges.begin(), hinges.end(), [](const auto& of) { return of.strength_left.has_value(); });
  };
  return source;
}

namespace {

double energy_of(const std::vector<BuildingPeaks::Hinge>& hinges) {
  double sum = 0;
  for (const BuildingPeaks::Hinge& hinge : hinges) sum += hinge.dissipated_energy;
  return hinges.empty() ? not_known : sum;
}

}  // namespace

QuantitySource hinge_energy() {
  QuantitySource source;
  source.row.value = [](const RunView& run, const QuantityPlace& at) {
    return energy_of(run.response.buildings[at.item].hinges);
  };
  source.row.is_told = [](const RunView& run, Index b) { return !run.response.buildings[b].hinges.empty(); };
  source.plan.value = [](const PlanRun& run, const QuantityPlace& at) {
    double sum = not_known;
    for (const PlanPeaks::Plane& plane : run.response.buildings[at.item].planes) {
      const double of_frame = energy_of(plane.frame.hinges);
      if (!std::isnan(of_frame)) sum = std::isnan(sum) ? of_frame : sum + of_frame;
    }
    return sum;
  };
  source.when = When::hinges;
  return source;
}

namespace {

QuantitySource struck(When when, QuantitySource source) {
  source.row.is_told = [when](const RunView& run, Index point) {
    return holds(when, run.problem, run.problem.points[point]);
  };
  source.when = when;
  source.table = QuantityTable::struck;
  return source;
}

/// What a struck column can carry, as a point of a row has it.
ContactPoint capacities_of(const PlanContact& contact) {
  ContactPoint point;
  point.column_shear_capacity = contact.column_shear_capacity;
  point.column_moment_capacity = contact.column_moment_capacity;
  return point;
}

}  // namespace

QuantitySource of_struck(double ColumnPeaks::*member) {
  return struck(When::struck, of_outcome(
                                  [=](const RunOutcome& run, const QuantityPlace& at) {
                                    const std::optional<ColumnPeaks>& column = run.points[at.item].column;
                                    return column ? *column.*member : not_known;
                                  },
                                  [=](RunOutcome& run, const QuantityPlace& at, double number) {
                                    if (std::isnan(number)) return;  // no column is struck there
                                    std::optional<ColumnPeaks>& column = run.points.at(at.item).column;
                                    if (!column) column.emplace();
                                    *column.*member = number;
                                  }));
}

QuantitySource of_struck(double (*value)(const ColumnPeaks&, const ContactPoint&), When when) {
  QuantitySource source;
  source.row.value = [value](const RunView& run, const QuantityPlace& at) {
    const std::optional<ColumnPeaks>& column = run.response.points[at.item].column;
    return column ? value(*column, run.problem.points[at.item]) : not_known;
  };
  source.plan.value = [value](const PlanRun& run, const QuantityPlace& at) {
    const std::optional<ColumnPeaks>& column = run.response.points[at.item].column;
    return column ? value(*column, capacities_of(*contact_at(run.problem, at.item).contact)) : not_known;
  };
  return struck(when, std::move(source));
}

}  // namespace bentur::sources
