#pragma once

#include <vector>

#include "bentur/model/story/story.h"

namespace bentur {

/// What a report that is handed in says beside its verdict.
struct HandIn {
  std::vector<Statement> assumptions;  ///< that the numbers rest on
  /// Every check with what is needed and what is given, in the order of ASCE 7-16 (12.8.7 stability, 12.12.1 drift,
  /// 12.12.3 separation), before them members, after them rules of thumb and what the program checks of itself.
  StoryTable checks;
  std::vector<Statement> unchecked;  ///< what nobody has looked at, each with what would be needed for it
};

/// Of a run.
[[nodiscard]] HandIn hand_in(const RunResults& run);
/// Of gaps by a spectrum.
[[nodiscard]] HandIn hand_in(const Case& c, const Problem& problem, const SpectralGaps& spectral);

}  // namespace bentur
