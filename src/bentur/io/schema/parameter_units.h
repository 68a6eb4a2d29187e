#pragma once

#include <optional>
#include <string>

#include "bentur/core/diagnostics.h"
#include "bentur/core/units.h"
#include "bentur/io/toml/parameter_path.h"

namespace bentur {

/// The unit of a number of the case, as UDUNITS reads it, by the dimension of its key (io/schema); "1" for
/// ratios and counts, empty where it is no number or its unit is not known.
/// @param root the case: the unit of a contact stiffness depends on the law.
[[nodiscard]] std::string parameter_units(const ParameterPath& path, const TomlValue& root, const Units& units);

/// The text of a case in other units: each number times what makes it the same in them, [units] saying so; comments and
/// all else as they are. Numbers of no such unit stay: ratios, seconds, multiples of g, what stands at unknown keys.
/// A number keeps 13 digits, and one of up to 10 comes back as it was.
/// @param length, force as in [units], m and N where that says nothing.
/// @return nothing where the text is no TOML or has other units; `diagnostics` then says why.
/// @throws InvalidParameter for an unknown `length` or `force`.
[[nodiscard]] std::optional<std::string> text_in_units(const std::string& text, const std::string& file,
                                                       const std::string& length, const std::string& force,
                                                       Diagnostics& diagnostics);

}  // namespace bentur
