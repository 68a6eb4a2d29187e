#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "bentur/io/results/result_variable.h"

namespace bentur {

/// Which runs of a sweep or an incremental dynamic analysis are the sample of demands, and of which building.
struct DemandRequest {
  std::string building;  ///< its name
  /// Coordinates and the value that a run must have, {"intensity", "0.5"}: the others make the sample.
  std::vector<std::pair<std::string, std::string>> only = {};
};

/// A sample of demands as pelicun reads it: comma-separated, a row of units, a row per run. Columns:
///
///   1-PFA-0-1    peak ground acceleration as applied [m/s²]
///   1-PFA-j-1    largest absolute acceleration of floor j = 1, 2, … from the lowest up [m/s²]
///   1-PID-j-1    largest drift ratio of the storey below floor j [-]
///   1-RID-j-1    drift ratio left after unloading, its size, where storeys can yield [-]
///   1-ERROR      1 of a run that collapses or whose numbers failed: pelicun leaves it out of the sample
///
/// A cell is empty where the number is not known; a storey of which no run has a number, as of a slab on bearings, has
/// no column. Direction 1 is that of the row of buildings. Of buildings in plan directions 1 and 2 are x and y: their
/// floors' accelerations are those of the centres of mass, and drifts the largest of the planes whose lines are mostly
/// along the axis (at 45 degrees both), or of a building without planes of the two edges parallel to it.
/// Source: documentation of pelicun 3 (demand sample, event-type-location-direction).
struct Demands {
  std::string csv;
  std::size_t runs = 0, errors = 0;
  std::size_t left_out = 0;                               ///< runs whose values make no case
  std::vector<std::pair<std::string, std::size_t>> over;  ///< dimensions that the sample is over, with their sizes
};

/// The file fails, ResultSource::fail(), where it has no such building or runs, or several levels of intensity remain.
[[nodiscard]] Demands demand_sample(const ResultSource& file, const DemandRequest& request);

}  // namespace bentur
