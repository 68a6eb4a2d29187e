#pragma once

#include <string>

#include "bentur/io/case/case_parts.h"
#include "bentur/study/gap/gap_study.h"

namespace bentur {

/// What one record needs without contact at every level, of a row as in plan; of its gaps nothing yet.
/// @param record what the study calls it
/// @param both_ways each number is the larger one of the record and the record reversed
/// @throws std::runtime_error with record and reason when the numbers fail.
[[nodiscard]] RecordNeed need_of_record(const std::string& record, const ReadCase& read, bool both_ways);

}  // namespace bentur
