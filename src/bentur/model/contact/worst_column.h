#pragma once

#include <optional>
#include <string>

#include "bentur/model/run_results.h"

namespace bentur {

inline constexpr double reached = 1e-9;  ///< of a capacity: what is so near it has come to it

/// The column of those struck in a gap that carries the most of what it can.
struct WorstColumn {
  Eigen::Index point = 0, building = 0;
  double ratio = 0;              ///< demand over capacity [-] ≥ 0
  double demand = 0, alone = 0;  ///< with contact and without, in `unit`
  std::string unit = {};
  long beyond = 0;  ///< how many of the gap have come to more than they bear
};
/// Nothing where no capacity is known. @param shear or moment
[[nodiscard]] std::optional<WorstColumn> worst_column(const RunResults& run, const Gap& gap, bool shear);

}  // namespace bentur
