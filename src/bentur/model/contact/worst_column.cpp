#include "bentur/model/contact/worst_column.h"

#include "bentur/model/quantities.h"

namespace bentur {

using Eigen::Index;

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

}  // namespace bentur
