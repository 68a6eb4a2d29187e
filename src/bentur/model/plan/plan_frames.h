#pragma once

#include <string>
#include <vector>

#include "bentur/model/plan/plan_run.h"
#include "bentur/model/run_results.h"

namespace bentur {

/// A frame of a building in plan: of those that yield one that has hinges, columns that can break, or infill.
struct PlanFramePlace {
  Eigen::Index building = 0, plane = 0;
};
/// "building, plane".
[[nodiscard]] std::string frame_name(const PlanProblem& problem, const PlanFramePlace& place);
/// Hinges of the frames before a plane: histories of a building have those of all its frames, one after the other.
[[nodiscard]] Eigen::Index hinges_before(const PlanModel& model, Eigen::Index plane);
[[nodiscard]] std::vector<PlanFramePlace> frames_that_yield(const PlanProblem& problem);

/// Each of these as a building of a row that is called "building, plane": what its hinges did, its columns that can
/// break, its infill, histories of its hinges, and nothing else. The response may be one without histories.
[[nodiscard]] RunResults frames_of(const PlanRun& run);
/// The same of these.
[[nodiscard]] RunResults frames_of(const PlanRun& run, const std::vector<PlanFramePlace>& places);

}  // namespace bentur
