#pragma once

#include <vector>

#include "bentur/model/story/story.h"
#include "bentur/study/gap/gap_study.h"

namespace bentur {

/// What is known of a gap of a suite beside what its records need.
struct JudgedOverRecords {
  bool is_enough = false;  ///< from all that is known
  bool is_alone = false;   ///< another gap closes under some record: needs are of buildings that meet nobody
};

/// Of the gaps over the records of a study: how many need more than is given, what half of them and 84 % need; where
/// something else varies over all of its choices together, with a table of the choices. Then a table of the records for
/// each gap and choice, and where several widths are given one of them.
/// @param judged per gap; empty: nothing of contact is known
[[nodiscard]] Story gap_study_story(const GapStudy& study, const std::vector<JudgedOverRecords>& judged = {});

}  // namespace bentur
