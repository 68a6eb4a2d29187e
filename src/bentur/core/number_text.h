#pragma once

#include <string>
#include <vector>

namespace bentur {

/// A number for people: four significant digits, no exponent between 1e-4 and 1e7.
[[nodiscard]] std::string number(double value);

/// Numbers of one column with equally many decimals, as many as leave the largest at most four significant digits.
/// A value that does not exist (NaN) becomes a dash.
[[nodiscard]] std::vector<std::string> column(const std::vector<double>& values);

}  // namespace bentur
