#include "bentur/core/number_text.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <system_error>
#include <utility>

namespace bentur {
namespace {

using Cells = std::vector<std::string>;

TEST(NumberText, FourSignificantDigitsWithoutTrailingZeros) {
  EXPECT_EQ(number(0), "0");
  EXPECT_EQ(number(0.2), "0.2");
  EXPECT_EQ(number(2.54872), "2.549");
  EXPECT_EQ(number(-0.0123456), "-0.01235");
  EXPECT_EQ(number(3817.6), "3818");
  EXPECT_EQ(number(206181.818), "206182");
}

TEST(NumberText, ExponentOnlyForTheVeryLargeAndTheVerySmall) {
  EXPECT_EQ(number(1e-5), "1\u00A0×\u00A010⁻⁵");
  EXPECT_EQ(number(2.5e7), "2.5\u00A0×\u00A010⁷");
  EXPECT_EQ(number(-2.0221e11), "-2.022\u00A0×\u00A010¹¹");
  EXPECT_EQ(number(std::numeric_limits<double>::infinity()), "∞");
  EXPECT_EQ(column({2e11, 2.0221e11}), (Cells{"2.000\u00A0×\u00A010¹¹", "2.022\u00A0×\u00A010¹¹"}));
  EXPECT_EQ(number(9999999), "9999999");
}

TEST(NumberText, AColumnHasEquallyManyDecimals) {
  EXPECT_EQ(column({0.72618, 0.5, 12.25}), (Cells{"0.73", "0.50", "12.25"}));
  EXPECT_EQ(column({100, 200, 300}), (Cells{"100", "200", "300"}));
  EXPECT_EQ(column({0.2, 0, 0.25}), (Cells{"0.20", "0", "0.25"}));
  EXPECT_EQ(column({0.1480, 0.0349}, 3), (Cells{"0.148", "0.035"}));
  EXPECT_EQ(column({0.1480, 0.0004}, 3), (Cells{"0.1480", "0.0004"}));
  EXPECT_EQ(column({5297, 471.2}, 3), (Cells{"5297", "471"}));
  EXPECT_EQ(column({1, std::numeric_limits<double>::quiet_NaN()}), (Cells{"1", "–"}));
  EXPECT_EQ(column({0.0132, 0.00017}, 4, 2), (Cells{"0.01320", "0.00017"}));
  EXPECT_EQ(column({954, 0.0031}, 4, 2), (Cells{"954.000", "0.003"})) << "two decimals more at most";
}

TEST(NumberText, ANumberIsTheWholeText) {
  EXPECT_EQ(parse_number("-2.5e1"), -25);
  for (const char* const wrong : {"", " 1", "1 ", "1x", "inf", "nan", "1e999"}) {
    EXPECT_EQ(parse_number(wrong), std::nullopt) << wrong;
  }
}

TEST(NumberText, IsReadAsTheStandardLibraryReadsIt) {
  for (const auto& [text, length] : {std::pair<std::string, int>{"NaN)", 3},
                                     {"-Inf", 4},
                                     {"INFINITY", 8},
                                     {"infinite", 3},
                                     {"1e", 1},
                                     {"1e+5x", 4},
                                     {".5.", 2},
                                     {"0x10", 1}}) {
    double value = 0;
    const auto [end, failure] = from_chars(text.data(), text.data() + text.size(), value);
    EXPECT_EQ(failure, std::errc()) << text;
    EXPECT_EQ(end - text.data(), length) << text;
  }
  for (const std::string text : {"", "+1", " 1", "-", ".", "e5", "n"}) {
    double value = 7;
    const auto [end, failure] = from_chars(text.data(), text.data() + text.size(), value);
    EXPECT_EQ(failure, std::errc::invalid_argument) << text;
    EXPECT_EQ(end, text.data()) << text;
    EXPECT_EQ(value, 7) << text;
  }
}

TEST(NumberText, IsTheNearestDouble) {
  std::mt19937 random(5);
  const auto among = [&](unsigned count) { return static_cast<unsigned>(random() % count); };
  for (int k = 0; k < 20000; ++k) {
    std::string text = among(2) == 0 ? "-" : "";
    const unsigned whole = among(12), fraction = among(12);
    for (unsigned i = 0; i <= whole; ++i) text += static_cast<char>('0' + among(10));
    if (fraction > 0) text += '.';
    for (unsigned i = 0; i < fraction; ++i) text += static_cast<char>('0' + among(10));
    if (among(2) == 0) text += (among(2) == 0 ? "e-" : "E") + std::to_string(among(40));
    double value = 0;
    const auto [end, failure] = from_chars(text.data(), text.data() + text.size(), value);
    EXPECT_EQ(end, text.data() + text.size()) << text;
    EXPECT_EQ(value, std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(NumberText, WhatIsToBeWrittenReadsBackWithoutRoundOff) {
  EXPECT_EQ(written(3.4 + 3.4 + 3.4), "10.2");
  EXPECT_EQ(written({3.5, 3.3 + 3.5, 13.1475}), "3.5, 6.8, 13.1475");
  EXPECT_EQ(written(1.0 / 3), "0.333333333333");
  EXPECT_EQ(written(-0.0), "-0");
  EXPECT_EQ(written(std::numeric_limits<double>::infinity()), "inf");
}

TEST(NumberText, CountsInWords) {
  EXPECT_EQ(counted(1, "column"), "1 column");
  EXPECT_EQ(counted(0, "column"), "0 columns");
  EXPECT_EQ(counted(2, "entry", "entries"), "2 entries");
}

}  // namespace
}  // namespace bentur
