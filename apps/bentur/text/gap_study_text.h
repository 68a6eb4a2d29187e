#pragma once

#include <string>

#include "bentur/study/gap/gap_study.h"

namespace bentur::cli {

/// A table per gap with a row per record, the largest and the median last.
[[nodiscard]] std::string gap_study_text(const GapStudy& study);

}  // namespace bentur::cli
