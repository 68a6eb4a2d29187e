#pragma once

#include "bentur/model/story/hand_in.h"
#include "bentur/study/gap/gap_study.h"
#include "bentur/study/suite/suite_run.h"

namespace bentur {

/// Of a suite whose records have all been run: drifts under the hardest of them, the gap that it needs, what the code
/// that scales them takes of them, and every rule of [code]. What is not known says so and counts as not met.
[[nodiscard]] HandIn suite_hand_in(const SuiteRun& run, const GapStudy& gaps);

}  // namespace bentur
