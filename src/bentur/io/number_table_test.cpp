#include "bentur/io/number_table.h"

#include <gtest/gtest.h>

namespace bentur {
namespace {

std::optional<NumberTable> table_of(const std::string& text, std::vector<std::string>* errors = nullptr) {
  Diagnostics diagnostics;
  auto table = number_table(text, "t.csv", diagnostics);
  EXPECT_EQ(diagnostics.ok(), table.has_value());
  if (errors != nullptr) {
    for (const Diagnostic& one : diagnostics.errors()) errors->push_back(one.text());
  }
  return table;
}

TEST(NumberTable, CommasSemicolonsAndBlanksPartTheSameCells) {
  for (const char* text :
       {"floor,mode 1,mode 2\n3,0.5,-1\n6,1,1\n", "# from a test\nfloor;mode 1;mode 2\n\n3;0,5;-1\n6;1;1\n",
        "3 0.5 -1\r\n6 1e0 1   # roof\r\n", "3\t0.5\t-1\n6\t1\t1"}) {
    SCOPED_TRACE(text);
    const auto table = table_of(text);
    ASSERT_TRUE(table);
    EXPECT_EQ(table->rows, (std::vector<std::vector<double>>{{3, 0.5, -1}, {6, 1, 1}}));
  }
  EXPECT_EQ(table_of("a,b\n\n1,2\n3,4\n")->lines, (std::vector<int>{3, 4}));
}

TEST(NumberTable, WhatIsWrongIsSaidWithItsPlace) {
  std::vector<std::string> errors;
  EXPECT_FALSE(table_of("mode 1,mode 2\n0.5,x1\n1,1\n0.2\nnan,1\n", &errors));
  EXPECT_EQ(errors, (std::vector<std::string>{"t.csv:2:5: error: \"x1\" is not a number",
                                              "t.csv:4:1: error: has 1 column, the row of line 3 has 2",
                                              "t.csv:5:1: error: \"nan\" is not a finite number"}));
  errors.clear();
  EXPECT_FALSE(table_of("0.5,1\n1,1,1\n", &errors));
  EXPECT_EQ(errors, (std::vector<std::string>{"t.csv:2:1: error: has 3 columns, the row of line 1 has 2"}));
  errors.clear();
  EXPECT_FALSE(table_of("O.5,1\n0.7,1\n", &errors));
  EXPECT_EQ(errors, (std::vector<std::string>{"t.csv:1:1: error: \"O.5\" is not a number"}));
  errors.clear();
  EXPECT_FALSE(table_of("mode 1 mode 2\n", &errors));
  EXPECT_EQ(errors, (std::vector<std::string>{"t.csv: error: holds no numbers"}));
}

}  // namespace
}  // namespace bentur
