#pragma once

#include <span>
#include <vector>

#include "bentur/model/plan/plan_quantities.h"
#include "bentur/model/quantity_row.h"

// What a study keeps of each run of buildings in plan, as quantity_row.h has it of a row.
namespace bentur {

/// The parts, in their order: every quantity but those of impacts and of single runs alone, buildings first, their
/// planes after their floors.
[[nodiscard]] std::vector<RowPart> row_parts(const PlanProblem& problem, const Units& units);

/// Whether floors, planes, hinges, bearings, contacts, gaps and links of two problems are as many, the same buildings
/// are walls or stand on soil, and the same planes and some of the same building's bearings can yield, so that their
/// rows are alike.
[[nodiscard]] bool same_places(const PlanProblem& a, const PlanProblem& b);

/// Fills `row` with the values of one run; what does not exist is NaN.
/// @throws InvalidParameter unless the row is as long as these parts need.
void fill_row(const std::vector<RowPart>& parts, const PlanRun& run, std::span<double> row);

}  // namespace bentur
