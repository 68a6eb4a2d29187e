#pragma once

#include <string>
#include <string_view>

#include "bentur/model/case.h"

namespace bentur {

/// What the rules of the case's [code] ask of each gap from heights alone, before anything is computed: the statements,
/// what is known of each rule, and of each gap every level (docs/result-files.md).
[[nodiscard]] std::string height_rules_json(const Case& c, const Problem& problem, std::string_view version);

}  // namespace bentur
