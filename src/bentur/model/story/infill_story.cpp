// What the infill of frames did, in sentences.
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bentur/model/quantities.h"
#include "bentur/model/story/internal/story_parts.h"

namespace bentur::story {
namespace {

using Eigen::Index;

/// That of a storey in which infill has failed or lost most of its strength; nothing where it is whole.
std::optional<Statement> lost_infill(const BuildingPeaks::Infill& infill, Index& storey) {
  storey = -1;
  for (Index j = 0; j < infill.failed_time.size(); ++j) {
    if (infill.failed_time(j) < (storey < 0 ? HUGE_VAL : infill.failed_time(storey))) storey = j;
  }
  if (storey >= 0) {
    return Statement{.kind = "infill_fails",
                     .severity = Severity::warning,
                     .values = {value_in("time", infill.failed_time(storey), "s")}};
  }
  for (Index j = 0; j < infill.strength_left.size(); ++j) {
    if (infill.strength_left(j) < (storey < 0 ? 1.0 : infill.strength_left(storey))) storey = j;
  }
  if (storey < 0) return std::nullopt;
  return Statement{.kind = "infill_weakens",
                   .severity = Severity::warning,
                   .values = {value_in("left", 100 * infill.strength_left(storey), "%")}};
}

}  // namespace

void tell_infill(const RunResults& run, std::vector<Statement>& statements) {
  const ShownUnits shown = shown_units(run.c.units, run.response);
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const Building& building = run.problem.buildings[b];
    const BuildingPeaks::Infill& infill = run.response.buildings[b].infill;
    const auto of_storey = [&](Statement statement, Index storey) {
      statement.buildings = {b};
      statement.level = building.model.elevations[storey];
      statement.values.push_back(text_of("building", building.name));
      statement.values.push_back(count_of("storey", static_cast<long>(building.model.storey_number(storey))));
      statements.push_back(std::move(statement));
    };
    Index hardest = -1;
    for (Index j = 0; j < infill.force.size(); ++j) {
      if (infill.force(j) > (hardest < 0 ? 0.0 : infill.force(hardest))) hardest = j;
    }
    if (hardest < 0) continue;
    const double force = shown.factor("F");
    const std::string unit = unit_text("F", shown.units);
    of_storey({.kind = "infill",
               .values = {value_in("force", force * infill.force(hardest), unit),
                          value_in("shear", force * infill.shear(hardest), unit)}},
              hardest);
    Index storey = -1;
    if (std::optional<Statement> loss = lost_infill(infill, storey)) of_storey(std::move(*loss), storey);
    Index worst = -1;
    for (Index j = 0; j < infill.column_demand.size(); ++j) {
      if (infill.column_demand(j) > (worst < 0 ? 1.0 : infill.column_demand(worst))) worst = j;
    }
    if (worst < 0) continue;
    of_storey({.kind = "infill_columns",
               .severity = Severity::warning,
               .values = {value_in("demand", infill.column_demand(worst))}},
              worst);
  }
}

}  // namespace bentur::story
