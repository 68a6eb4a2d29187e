#pragma once

#include <vector>

namespace bentur {

/// The value that a part p of the numbers does not exceed, linear between the two numbers next to (n − 1) p in order,
/// counted from 0: the quantile of type 7 [HyndmanFan1996], as numpy and R have it by default.
/// @param p in [0, 1]. @throws InvalidParameter when there are no numbers or p is not in [0, 1].
[[nodiscard]] double quantile_of(std::vector<double> numbers, double p);

[[nodiscard]] double median_of(std::vector<double> numbers);

}  // namespace bentur
