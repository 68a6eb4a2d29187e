#pragma once

#include <string>
#include <vector>

namespace bentur {

/// A number as it is to be written into an input: the fewest digits that read back as it but for round-off of 10⁻¹², so
/// that the sum of storeys of 3.4 is 6.8.
[[nodiscard]] std::string written(double value);
/// "3.4, 6.8".
[[nodiscard]] std::string written(const std::vector<double>& values);

}  // namespace bentur
