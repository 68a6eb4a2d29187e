#pragma once

#include "bentur/model/closer/floor_spectra.h"
#include "bentur/model/closer/frame_forces.h"
#include "bentur/solve/solver.h"

namespace bentur {

/// What is found of a run that is solved once more, and once without contact, with samples a two-thousandth of a second
/// apart, or so far that both fit a budget of numbers in memory.
struct DenseFindings {
  FloorSpectra floors;
  std::vector<FrameForces> frames;
};

/// @param frames of the buildings as their case gives them; nothing of those that are no frame
/// @param budget numbers in memory; nothing is found where samples would be more than 1/200 s apart
[[nodiscard]] DenseFindings dense_findings(const Problem& problem, const Response& response, const Solver& solver,
                                           const std::vector<const PlaneFrame*>& frames, double budget = 2e7);

}  // namespace bentur
