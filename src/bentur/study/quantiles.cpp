#include "bentur/study/quantiles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "bentur/core/errors.h"

namespace bentur {

double quantile_of(std::vector<double> numbers, double p) {
  if (numbers.empty()) throw InvalidParameter("numbers", "empty", "must have at least one entry");
  if (!(p >= 0 && p <= 1)) throw InvalidParameter("p", std::to_string(p), "must be in [0, 1]");
  std::sort(numbers.begin(), numbers.end());
  const double place = p * static_cast<double>(numbers.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, numbers.size() - 1);
  const double part = place - static_cast<double>(below);
  return part == 0 || numbers[below] == numbers[above] ? numbers[below]
                                                       : (1 - part) * numbers[below] + part * numbers[above];
}

double median_of(std::vector<double> numbers) { return quantile_of(std::move(numbers), 0.5); }

}  // namespace bentur
