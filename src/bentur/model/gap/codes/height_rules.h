#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bentur/model/gap/minimum_gap.h"

namespace bentur {

/// What one rule asks of a level from heights alone.
struct HeightNeed {
  FacingLevel level;
  std::optional<HeightSeparation> asked;  ///< nothing: the rule needs displacements
};

/// What one rule of [code] asks of a gap from heights alone, before anything is computed, at the level where it falls
/// short the most or has least to spare. A rule that may ask for more when displacements are known is never enough.
struct HeightFinding {
  enum class Verdict {
    too_small,      ///< more than is given, whatever the displacements are
    enough,         ///< what is given is as much as the rule asks, at every level
    least,          ///< what is given is as much as the rule asks at least; displacements may ask for more
    not_evaluated,  ///< `silence` says why
  };
  std::string rule;
  std::vector<HeightNeed> needs = {};  ///< per facing level of the gap, from the lowest up
  std::optional<std::size_t> at = {};  ///< the level reported, an index into `needs`
  Verdict verdict = Verdict::not_evaluated;
  RuleFinding::Silence silence = RuleFinding::Silence::none;
};

/// Of each rule of `code`, in its order. @throws InvalidParameter when a rule lacks something.
[[nodiscard]] std::vector<HeightFinding> height_findings(const Problem& problem, Eigen::Index gap, const CodeSpec& code,
                                                         const Units& units);

}  // namespace bentur
