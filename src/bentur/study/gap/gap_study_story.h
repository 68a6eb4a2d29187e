#pragma once

#include <vector>

#include "bentur/model/story/story.h"
#include "bentur/study/gap/gap_study.h"

namespace bentur {

/// Of the gaps over the records of a study: how many need more than is given, what half of them and 84 % need; where
/// something else varies over all of its choices together, with a table of the choices. Then a table of the records for
/// each gap and choice, and where several widths are given one of them.
/// @param are_enough per gap whether it is judged so from all that is known; empty: nothing of contact is known
[[nodiscard]] Story gap_study_story(const GapStudy& study, const std::vector<bool>& are_enough = {});

}  // namespace bentur
