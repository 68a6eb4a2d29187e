#pragma once

#include "bentur/model/story/story.h"
#include "bentur/study/gap/gap_study.h"

namespace bentur {

/// Of the gaps over the records of a study: how many need more than is given, what half of them and 84 % need; where
/// something else varies over all of its choices together, with a table of the choices. Then a table of the records for
/// each gap and choice, and where several widths are given one of them.
[[nodiscard]] Story gap_study_story(const GapStudy& study);

}  // namespace bentur
