#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bentur {

/// A number for people, at every door alike: four significant digits without trailing zeros, whole numbers with all of
/// theirs; below 10⁻⁴ and from 10⁷ on with a power of ten, "2.022 × 10¹¹", which no line break divides.
[[nodiscard]] std::string number(double value);

/// "10⁻⁵".
[[nodiscard]] std::string power_of_ten(int exponent);

/// Numbers of one column with equally many decimals, as many as leave the largest at most four significant digits, or
/// as few as asked for unless one of them would vanish. A value that does not exist (NaN) becomes a dash.
/// @param of_least significant digits that the smallest has at least, for which there are two decimals more at most
[[nodiscard]] std::vector<std::string> column(const std::vector<double>& values, int digits = 4, int of_least = 0);

/// The finite number that a text is, from its first character to its last.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// std::from_chars for a double, also where the standard library has it for whole numbers alone, as in a browser.
std::from_chars_result from_chars(const char* first, const char* last, double& value);

/// A number as it is to be written into an input: the fewest digits that read back as it but for round-off of 10⁻¹², so
/// that the sum of storeys of 3.4 is 6.8.
[[nodiscard]] std::string written(double value);
/// "3.4, 6.8".
[[nodiscard]] std::string written(const std::vector<double>& values);

/// "1 column", "3 columns". @param many where it is not `one` with an s.
[[nodiscard]] std::string counted(std::size_t count, const std::string& one, const std::string& many = {});

}  // namespace bentur
