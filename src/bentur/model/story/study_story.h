#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bentur/model/story/story.h"

namespace bentur {

/// A number of one run of a study.
struct PlacedValue {
  double value = 0;
  std::string unit = {};
  std::string where = {};  ///< of what varies, "width = 0.2, record = El Centro"; empty: the number does not vary
};

/// What came of the runs of a study. Those that failed count in `failed` alone.
struct StudyOutcome {
  long runs = 0, failed = 0;
  long pounding = 0;               ///< with an impact, or with a contact that is not modelled
  long unmodelled = 0;             ///< with a contact that is not modelled
  long remarked = 0, doubted = 0;  ///< with a remark, with one by which an input may not be meant
  std::vector<std::pair<std::string, long>> remarks = {};  ///< what they are about, and in how many runs
  long not_known = 0;  ///< of which the gap needed is not known: a building falls without contact
  std::optional<PlacedValue> hardest_force = {}, gap_needed = {};  ///< the largest of all runs
};

/// Of a study: contacts that are not modelled, how many runs pound, the hardest force, the gap needed, what failed.
[[nodiscard]] Story study_story(const StudyOutcome& outcome);

}  // namespace bentur
