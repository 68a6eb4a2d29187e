#include "bentur/io/exchange/house_tags.h"

#include <gtest/gtest.h>

#include <tuple>

namespace bentur {
namespace {

TEST(HouseTags, HeightsAreMetresOrFeetAndMayHaveADecimalComma) {
  // A foot is 0.3048 m, twelve inches, by definition.
  for (const auto& [text, metres, as_written] : {std::tuple("12.5", 12.5, true),
                                                 {"12", 12.0, true},
                                                 {"12.5 m", 12.5, true},
                                                 {" 12.5m", 12.5, true},
                                                 {"12,5", 12.5, false},
                                                 {"12,5 m", 12.5, false},
                                                 {"40'", 40 * 0.3048, false},
                                                 {"40'6\"", 40.5 * 0.3048, false},
                                                 {"40' 6\"", 40.5 * 0.3048, false},
                                                 {"40.5'", 40.5 * 0.3048, false},
                                                 {"40 ft", 40 * 0.3048, false},
                                                 {"40ft", 40 * 0.3048, false}}) {
    const auto read = height_tag(text);
    ASSERT_TRUE(read) << text;
    EXPECT_NEAR(read->value, metres, 1e-12) << text;
    EXPECT_EQ(read->as_written, as_written) << text;
  }
  for (const char* const text :
       {"",    " ",     "m",     "'",       "ft",  "tall", "0",       "-1",      "-40'",    "1001", "1e999",
        "nan", "12 mm", "1,2,3", "1.200,5", "12,", "40'6", "40'12\"", "40'-6\"", "40'6\"x", "6\"",  "12;14"}) {
    EXPECT_FALSE(height_tag(text)) << text;
  }
}

TEST(HouseTags, StoreysAreWholeAndOfSeveralTheMost) {
  for (const auto& [text, storeys, as_written] : {std::tuple("3", 3, true),
                                                  {"4.0", 4, true},
                                                  {" 5 ", 5, true},
                                                  {"200", 200, true},
                                                  {"3.5", 4, false},
                                                  {"0.5", 1, false},
                                                  {"3,5", 4, false},
                                                  {"3;4", 4, false},
                                                  {"4; 3", 4, false},
                                                  {"0;2", 2, false},
                                                  {"2-3", 3, false},
                                                  {"2 - 3", 3, false},
                                                  {"2\xE2\x80\x93"
                                                   "3",
                                                   3, false},
                                                  {"4+1", 5, false},
                                                  {"1;2-3.5", 4, false}}) {
    const auto read = storeys_tag(text);
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(read->value, storeys) << text;
    EXPECT_EQ(read->as_written, as_written) << text;
  }
  // 2,4 may be two numbers or one: neither is taken.
  for (const char* const text : {"",   "0",    "-1",   "-0.5", "201", "1e300", "150+60", "many", "3;",  ";3",
                                 "2-", "-3-2", "2--3", "2,4",  "+3",  "3+",    "3;x",    "~3",   "nan", "inf"}) {
    EXPECT_FALSE(storeys_tag(text)) << text;
  }
}

}  // namespace
}  // namespace bentur
