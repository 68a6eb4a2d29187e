#pragma once

#include <cstddef>
#include <string>

namespace bentur {

// Range checks of parameters, one line at the place of use. Each throws InvalidParameter naming parameter, value and
// range.

/// @throws InvalidParameter unless `value` is finite and > 0.
void require_positive(const std::string& name, double value);

/// @throws InvalidParameter unless `value` is finite and ≥ 0.
void require_not_negative(const std::string& name, double value);

/// @throws InvalidParameter unless `value` is finite.
void require_finite(const std::string& name, double value);

/// @throws InvalidParameter unless a list has `expected` entries.
void require_size(const std::string& name, std::size_t size, std::size_t expected);

/// "name[3]", for the entries of a list.
[[nodiscard]] std::string indexed(const std::string& name, std::size_t index);

}  // namespace bentur
