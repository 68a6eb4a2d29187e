#pragma once

#include <nlohmann/json.hpp>

#include "bentur/study/fragility/ida_fragility.h"

namespace bentur {

/// Which runs collapse, of a cloud: `kind`, and where it is fitted α₀ and α₁.
[[nodiscard]] nlohmann::ordered_json collapse_json(const CaseFragility& fragility);
/// Of all runs, those that collapse among them; null where none does, or what is of all is not known.
[[nodiscard]] nlohmann::ordered_json of_all_json(const CaseFragility& fragility);

}  // namespace bentur
