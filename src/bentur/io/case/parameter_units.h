#pragma once

#include <string>

#include "bentur/core/units.h"
#include "bentur/io/toml/parameter_path.h"

namespace bentur {

/// The unit of a number of the case, as UDUNITS reads it, by the keys that lead to it (docs/case-file.md); "1" for
/// ratios and counts, empty where it is no number or its unit is not known.
/// @param root the case: the unit of a contact stiffness depends on the law.
[[nodiscard]] std::string parameter_units(const ParameterPath& path, const TomlValue& root, const Units& units);

}  // namespace bentur
