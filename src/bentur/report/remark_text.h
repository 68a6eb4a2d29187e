#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bentur/model/remarks.h"
#include "bentur/solve/problem.h"

namespace bentur {

/// Remarks as sentences, each with its subject, its number, what is usual and what follows from it; those that differ
/// in subject and number alone become one. @throws InvalidParameter for an unknown language or a remark that the
/// catalogue does not have.
[[nodiscard]] std::vector<std::string> remark_texts(const std::vector<Remark>& remarks,
                                                    std::string_view language = "en");

/// What the model leaves out. @param yields some_building_yields()
[[nodiscard]] std::string model_text(const Problem& problem, bool yields, std::string_view language = "en");

}  // namespace bentur
