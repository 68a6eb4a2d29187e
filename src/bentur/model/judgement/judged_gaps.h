#pragma once

#include <vector>

#include "bentur/model/gap/spectral_gap.h"
#include "bentur/model/judgement/facts.h"
#include "bentur/model/judgement/judge.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/model/run_results.h"

namespace bentur {

/// Whether the motion is that of its file or of its case times −1 ("polarity"), so that what a run calls reversed is as
/// recorded.
[[nodiscard]] bool acts_reversed(const Case& c);

/// What the gaps of a run of a row have in common.
[[nodiscard]] RunFacts run_facts(const RunResults& run);
/// The same of buildings in plan.
[[nodiscard]] RunFacts run_facts(const PlanRun& run);

/// A gap of a run with what is known of it.
struct JudgedGap {
  GapFacts facts;
  Judgement judgement;
};

/// Of every gap of a row.
[[nodiscard]] std::vector<JudgedGap> judged_gaps(const RunResults& run);
/// Of every gap of a row by a spectrum.
[[nodiscard]] std::vector<JudgedGap> judged_gaps(const Case& c, const Problem& problem, const SpectralGaps& spectral);
/// Of every gap in plan.
[[nodiscard]] std::vector<JudgedGap> judged_gaps(const PlanRun& run);

}  // namespace bentur
