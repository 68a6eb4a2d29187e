#pragma once

#include <filesystem>

#include "bentur/solve/problem.h"
#include "bentur/solve/response.h"
#include "bentur/study/case.h"
#include "bentur/study/remarks/remarks.h"

namespace bentur {

/// A run as far as its result files tell of it.
struct RunResults {
  Case c;                       ///< title, units, excitation echo, gaps with their laws, solver; no buildings, no code
  Problem problem;              ///< buildings with names, elevations, periods and shapes; contact points without laws
  std::vector<Remark> remarks;  ///< as the run made them
  Response response;            ///< peaks, points, impacts; of the histories displacement, opening and force
};

/// Reads the folder that `bentur run -o` wrote: summary.json, impacts.csv and histories.nc.
/// @throws std::runtime_error naming the file, when one is missing, is not what bentur writes, or is not of the same
/// run.
[[nodiscard]] RunResults read_results(const std::filesystem::path& folder);

}  // namespace bentur
