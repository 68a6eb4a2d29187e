#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "bentur/model/story/remarks.h"
#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"

namespace bentur {

/// Why it is not known what the gaps of a run need, so that none of any width is known to be enough. Bits of a number.
enum class OpenNeed : unsigned {
  collapse = 1,    ///< a storey collapses without contact
  drift = 2,       ///< one drifts that far, where nothing looks for collapse
  doubt = 4,       ///< an input may not be meant
  motion_left = 8  ///< what comes after the end of the run could need more
};
/// "collapse", "drift_beyond_collapse", "doubt", "motion_left": of each bit from the lowest, as results have them.
[[nodiscard]] const std::vector<std::string_view>& open_need_keys();
[[nodiscard]] inline bool has(std::uint64_t bits, OpenNeed one) { return (bits & static_cast<unsigned>(one)) != 0; }

/// Of the ground motion as it is given.
/// @param problem a row, or row_of() buildings in plan
[[nodiscard]] std::uint64_t open_needs(const Problem& problem, const Response& response,
                                       const std::vector<Remark>& remarks);

}  // namespace bentur
