#pragma once

#include <cstdint>
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

/// Of many runs those of which it is not known what gap they need, and in how many it is each of OpenNeed.
struct OpenNeeds {
  long runs = 0;
  std::vector<long> in = {};  ///< per open_need_keys(), or empty

  /// @param bits of one run; none: it is known
  void add(std::uint64_t bits);
  void add(const OpenNeeds& other);
};
/// What is said of them. @param of so many runs @param kind "study_not_known" or one that has the same values
[[nodiscard]] Statement open_needs_statement(const OpenNeeds& open, long of, std::string kind = "study_not_known");

/// What came of the runs of a study. Those that failed count in `failed` alone.
struct StudyOutcome {
  long runs = 0, failed = 0;
  long pounding = 0;               ///< with an impact, or with a contact that is not modelled
  long unmodelled = 0;             ///< with a contact that is not modelled
  long remarked = 0, doubted = 0;  ///< with a remark, with one by which an input may not be meant
  std::vector<std::pair<std::string, long>> remarks = {};          ///< what they are about, and in how many runs
  OpenNeeds open = {};                                             ///< of which it is not known what gap they need
  std::optional<PlacedValue> hardest_force = {}, gap_needed = {};  ///< the largest of all runs
};

/// Of a study: contacts that are not modelled, how many runs pound, the hardest force, the gap needed, what failed.
[[nodiscard]] Story study_story(const StudyOutcome& outcome);

}  // namespace bentur
