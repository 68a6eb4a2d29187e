#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "bentur/io/results/result_variable.h"
#include "bentur/io/results/run_variables.h"
#include "bentur/model/plan/plan_run.h"

namespace bentur {

/// Contact points and links, which have a place where they `stand_still`.
[[nodiscard]] ResultDimension point_dimension(std::size_t size, bool stand_still);
[[nodiscard]] ResultDimension link_dimension(std::size_t size, bool stand_still);

/// Where gaps and contact points of a problem are; their elevations and places where a unit of length is given.
[[nodiscard]] PlaceVariables plan_place_variables(const PlanProblem& problem, const std::string& length,
                                                  const std::string& link_length);
/// The planes of a building, which is number `building` of the case, from 0; what they are called, and the direction of
/// their lines.
[[nodiscard]] ResultDimension plane_dimension(std::size_t building, std::size_t planes);
[[nodiscard]] ResultVariable plane_names(const ResultDimension& planes, const PlanBuilding& building);
[[nodiscard]] ResultVariable plane_angles(const ResultDimension& planes, const PlanBuilding& building,
                                          std::size_t number);

/// The bearings below a building, which have a place where they `stand_still`; and where they are.
[[nodiscard]] ResultDimension bearing_dimension(std::size_t building, std::size_t bearings, bool stand_still);
[[nodiscard]] std::vector<ResultVariable> bearing_places(const ResultDimension& bearings, const PlanBuilding& building,
                                                         std::size_t number, const std::string& length);

/// Whether a file is one of a run of buildings in plan, with histories.
[[nodiscard]] bool is_plan_run(const ResultSource& source);

/// The response that such a file holds, into a run whose case and problem are known. What the file contradicts these or
/// itself in is ResultSource::fail().
void read_plan_response(const ResultSource& source, PlanRun& run);

}  // namespace bentur
