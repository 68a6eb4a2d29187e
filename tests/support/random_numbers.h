#pragma once

#include <cstddef>
#include <random>
#include <vector>

namespace bentur::test {

inline std::vector<double> random_numbers(std::size_t count, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> number(-2.0, 2.0);
  std::vector<double> list(count);
  for (double& x : list) x = number(engine);
  return list;
}

}  // namespace bentur::test
