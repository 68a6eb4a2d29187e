#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

namespace bentur::test {

inline std::vector<double> random_numbers(std::size_t count, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> number(-2.0, 2.0);
  std::vector<double> list(count);
  for (double& x : list) x = number(engine);
  return list;
}

/// The two numbers, first and last or first and count, by which a test draws its random cases: those of an environment
/// variable "A:B" where it is set, else the usual ones, which a build with sanitizers has fewer of.
inline std::pair<unsigned, unsigned> seeds_of(const char* variable, std::pair<unsigned, unsigned> usual,
                                              [[maybe_unused]] std::pair<unsigned, unsigned> sanitized) {
#ifdef BENTUR_SANITIZED
  usual = sanitized;
#endif
  if (const char* text = std::getenv(variable)) {
    EXPECT_EQ(std::sscanf(text, "%u:%u", &usual.first, &usual.second), 2) << text;  // NOLINT(cert-err34-c)
  }
  return usual;
}

}  // namespace bentur::test
