#pragma once

#include <vector>

#include "bentur/model/closer/dense_run.h"
#include "bentur/model/plan/plan_frames.h"
#include "bentur/model/plan/plan_run.h"

namespace bentur {

/// Frames of a case whose members' forces are known: none whose columns can break.
[[nodiscard]] std::vector<PlanFramePlace> frames_with_members(const Case& c, const PlanProblem& problem);

/// Of both buildings at the hardest impact the roof and the floor that is hit, along the line across their joint;
/// without an impact the roofs of at most six buildings, along the component of the motion that is the larger.
[[nodiscard]] std::vector<FloorSpectra::Floor> spectrum_floors(const PlanProblem& problem,
                                                               const PlanResponse& response);

/// As of a row: floors move at their centres of mass, frames are counted among frames_with_members(). Speeds are those
/// of movements between samples, so that S_a falls 0.4 % short at most.
[[nodiscard]] DenseFindings dense_findings(const PlanRun& run, double budget = 2e7);
/// As that of a row (run_results.h).
inline void find_figures(PlanRun& run) { run.closer = dense_findings(run); }

}  // namespace bentur
