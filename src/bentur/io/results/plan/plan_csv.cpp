#include "bentur/io/results/plan/plan_csv.h"

#include <fmt/format.h>

#include "bentur/io/results/result_csv.h"
#include "bentur/model/plan/plan_places.h"

namespace bentur {

std::string impacts_csv(const PlanRun& run) {
  const Units& units = run.c.units;
  std::string csv = fmt::format("left,right,elevation [{0}],x [{0}],y [{0}]", units.length);
  const std::vector<const Quantity*> columns = quantities_of(Owner::impact, true);
  for (const Quantity* const one : columns) csv += "," + csv_heading(*one, units);
  csv += "\n";
  for (Eigen::Index i = 0; i < std::ssize(run.response.impacts); ++i) {
    const PlanContactPlace place = contact_at(run.problem, run.response.impacts[i].point);
    const PlanGap& gap = run.problem.gaps[place.gap];
    csv += fmt::format("{},{},{},{},{}", csv_field(run.problem.buildings[gap.left].name),
                       csv_field(run.problem.buildings[gap.right].name), csv_number(place.contact->elevation),
                       csv_number(place.at.x()), csv_number(place.at.y()));
    for (const Quantity* const one : columns) csv += "," + csv_number(value_of(*one, run, {i}));
    csv += "\n";
  }
  return csv;
}

}  // namespace bentur
