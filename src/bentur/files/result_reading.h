#pragma once

#include <filesystem>

#include "bentur/model/case.h"
#include "bentur/model/remarks.h"
#include "bentur/solve/problem.h"
#include "bentur/solve/response.h"

namespace bentur {

/// A run as far as its result files tell of it.
struct RunResults {
  /// With the case's copy all of it but the samples of a record. Without: title, units, excitation echo, gaps with what
  /// their laws worked with, solver; no buildings, no code.
  Case c;
  /// With the case's copy as made from it, but for a record's motion. Without: buildings with names, elevations,
  /// periods and shapes; contact points without laws.
  Problem problem;
  std::vector<Remark> remarks;  ///< as the run made them
  Response response;            ///< peaks, points, impacts; of the histories displacement, opening and force
};

/// Reads the folder that `bentur run -o` wrote: summary.json, impacts.csv, histories.nc, and case.toml where it is
/// there and is the case that summary.json was made from.
/// @throws std::runtime_error naming the file, when one is missing, is not what bentur writes, or is not of the same
/// run.
[[nodiscard]] RunResults read_results(const std::filesystem::path& folder);

}  // namespace bentur
