#include "bentur/report/figures/internal/pixels.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace bentur {
namespace {

/// By the library for text, without the zeros at the end of a fraction.
std::string formatted(double hundredths) {
  std::string text = fmt::format("{:.2f}", hundredths / 100);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

TEST(Pixels, AreWrittenAsTheLibraryForTextDoes) {
  std::mt19937_64 random(28);
  for (const double largest : {0.05, 2.0, 700.0, 1e5}) {
    std::uniform_real_distribution<double> pixels(-largest, largest);
    for (int k = 0; k < 50000; ++k) {
      const double value = pixels(random);
      // Rounded by whole numbers: of a value halfway between two hundredths the even one, whatever its last bit is.
      ASSERT_EQ(length(value), formatted(std::rint(100 * value))) << value;
      ASSERT_NEAR(std::stod(length(value)), value, 0.005 * (1 + 1e-9)) << value;
    }
  }
  for (int hundredths = -20000; hundredths <= 20000; ++hundredths) {
    ASSERT_EQ(length(hundredths / 100.0), formatted(hundredths)) << hundredths;
  }
}

TEST(Pixels, WithoutEndAreFarOutside) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(length(infinity), "100000");
  EXPECT_EQ(length(-infinity), "-100000");
  EXPECT_EQ(length(1e300), "100000");
  EXPECT_EQ(length(std::nan("")), "-100000");
  EXPECT_EQ(length(-0.001), "0");
}

TEST(Pixels, StandAtTheEndOfAText) {
  std::string text = "M";
  add_length(text, -1.5);
  EXPECT_EQ(text, "M-1.5");
}

}  // namespace
}  // namespace bentur
