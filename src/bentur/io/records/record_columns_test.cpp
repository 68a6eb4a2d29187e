// Files of columns, and of any number of values in a line.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bentur/io/records/record_files.h"
#include "tests/support/record_file.h"

namespace bentur {
namespace {

using RecordColumns = test::RecordFile;
using ColumnValues = std::vector<double>;

RecordOptions with_step(double step, const std::string& format = "auto") {
  RecordOptions options;
  options.time_step = step;
  options.format = format;
  return options;
}

TEST_F(RecordColumns, TwoColumnsInEachLayout) {
  for (const char* const text :
       {"0.00 0.5\n0.02 -0.25\n0.04 1e-1\n", "0.00,0.5\n0.02,-0.25\n0.04,.1\n", "0.00, 0.5\n0.02, -0.25\n0.04, 0.1\n",
        "0.00;0.5\n0.02; -0.25 ;\n0.04;0.1", "0.00\t0.5\n0.02\t-0.25\n0.04\t0.1\n", "0,00;0,5\n0,02;-0,25\n0,04;0,1\n",
        "0,00\t0,5\n0,02\t-0,25\n0,04\t0,1\n", "0,00  0,5\n0,02 -0,25\n0,04  0,1\n",
        "Time [s], Acceleration\n0.00,0.5\n0.02,-0.25\n0.04,0.1\n", "Zeit;Beschl. a\n0,00;0,5\n0,02;-0,25\n0,04;0,1\n",
        "# a comment, 1 2 3\n% another\n\n 0.00 0.5 # start\n0.02 -0.25\n\n0.04 0.1\n",
        "\xEF\xBB\xBF"
        "0.00 0.5\n0.02 -0.25\n0.04 0.1\n"}) {
    SCOPED_TRACE(text);
    const auto record = read(text);
    ASSERT_TRUE(record.has_value()) << messages();
    EXPECT_EQ(record->format, "two-column");
    EXPECT_EQ(record->unit, "");  // never guessed
    EXPECT_DOUBLE_EQ(record->time_step, 0.02);
    EXPECT_EQ(record->values, (ColumnValues{0.5, -0.25, 0.1}));
  }
}

TEST_F(RecordColumns, OneColumnNeedsAStep) {
  RecordOptions options;
  EXPECT_FALSE(read("0.5\n-0.25\n", options).has_value());
  EXPECT_NE(messages().find("give excitation.time_step"), std::string::npos);
  RecordOptions of_command;
  of_command.of_command = true;
  EXPECT_FALSE(read("0.5\n-0.25\n", of_command).has_value());
  EXPECT_NE(messages().find("give --time-step"), std::string::npos);
  options.time_step = 0.01;
  const auto record = read("acceleration\n0.5\n-0.25\n", options);
  ASSERT_TRUE(record.has_value()) << messages();
  EXPECT_EQ(record->format, "one-column");
  EXPECT_EQ(record->time_step, 0.01);
  EXPECT_EQ(record->values, (ColumnValues{0.5, -0.25}));
}

TEST_F(RecordColumns, FormatAskedForMustFit) {
  RecordOptions options;
  options.format = "one-column";
  options.time_step = 0.01;
  EXPECT_FALSE(read("0 0.5\n1 0.6\n", options).has_value());
  options.format = "two-column";
  EXPECT_FALSE(read("0.5\n0.6\n", options).has_value());
  options.format = "peer-at2";
  EXPECT_FALSE(read("0 0.5\n1 0.6\n", options).has_value());
}

TEST_F(RecordColumns, ColumnsAreChosenNotGuessed) {
  const std::string text = "0.0 1 2 3\n0.1 4 5 6\n";
  EXPECT_FALSE(read(text).has_value());
  RecordOptions options;
  for (const int column : {1, 5}) {
    options.column = column;
    EXPECT_FALSE(read(text, options).has_value()) << column;
  }
  options.column = 3;
  EXPECT_EQ(read(text, options).value().values, (ColumnValues{2, 5}));
}

TEST_F(RecordColumns, StepMayVaryByOnePerCent) {
  // Steps 0.0201, 0.0199: half a per cent off the mean. 0.0203, 0.0197: one and a half.
  const auto record = read("0 1\n0.0201 2\n0.04 3\n");
  ASSERT_TRUE(record.has_value()) << messages();
  EXPECT_DOUBLE_EQ(record->time_step, 0.02);
  EXPECT_FALSE(read("0 1\n0.0203 2\n0.04 3\n").has_value());
  EXPECT_EQ(messages(), ":2:1: error: time step 0.0203 s differs from the mean step 0.02 s by more than 1 %\n");
  EXPECT_FALSE(read("0.04 1\n0.02 2\n0 3\n").has_value());
  EXPECT_EQ(messages(), ":3:1: error: time does not go forward from the first line to the last\n");
}

TEST_F(RecordColumns, FilesWithoutNumbers) {
  for (const char* const text : {"", "\n\n", " \t\r\n"}) {
    EXPECT_FALSE(read(text).has_value());
    EXPECT_EQ(messages(), ": error: is empty\n");
  }
  EXPECT_FALSE(read(std::string(1000, '\0')).has_value());
  EXPECT_EQ(messages(), ": error: is a binary file, but records are text\n");
  EXPECT_FALSE(read("# only a comment\ntime acceleration\n").has_value());
  EXPECT_EQ(messages(), ": error: holds no numbers\n");
  EXPECT_FALSE(read("0 1\n").has_value());
  EXPECT_EQ(messages(), ": error: holds one value only, a record needs two or more\n");
  EXPECT_FALSE(read("0,1;2\n0,2;;3\n").has_value());
}

TEST_F(RecordColumns, ATypingErrorInTheFirstRowIsNoHeader) {
  EXPECT_FALSE(read("0.00 O.5\n0.02 0.25\n0.04 0.1\n").has_value());
  EXPECT_EQ(messages(),
            ":1:6: error: \"O.5\" is not a number (where this line is a heading, give excitation.skip_lines = 1)\n");
  EXPECT_FALSE(read("0.00 0.5 x\n0.02 0.25\n0.04 0.1\n0.06 0.2\n").has_value());
  EXPECT_EQ(messages(),
            ":1:10: error: \"x\" is not a number (where this line is a heading, give excitation.skip_lines = 1)\n");
  EXPECT_FALSE(read("a title\n1 2 3\n0.00 0.5\n0.02 0.25\n0.04 0.1\n").has_value());
  EXPECT_EQ(
      messages(),
      ":2:1: error: has 3 columns, the rows below have 2 (where this line is a heading, give excitation.skip_lines "
      "= 2)\n");
}

TEST_F(RecordColumns, HeadingsOfAnyLengthAreFoundAndCounted) {
  const std::string rows = "0.00 0.5\n0.02 -0.25\n0.04 0.1\n";
  for (const auto& [heading, lines] : std::vector<std::pair<std::string, int>>{
           {"", 0},
           {"time acc\n", 1},
           {"El Centro\nImperial Valley, 1940\n", 2},
           {"Station 117, El Centro\nDate: 19 May 1940\n\n# a comment\ntime [s], acc [g]\nbegin:\n", 4},
           {"Kocaeli 17/08/1999\nPGA = 0.50 g at 4.5 s\nDT 0.02\n", 3}}) {
    SCOPED_TRACE(heading);
    const auto record = read(heading + rows);
    ASSERT_TRUE(record.has_value()) << messages();
    EXPECT_EQ(record->values, (ColumnValues{0.5, -0.25, 0.1}));
    EXPECT_EQ(record->header_lines, lines);
  }
}

TEST_F(RecordColumns, LinesAreSkippedWhereTheHeadingLooksLikeRows) {
  const std::string text = "1940 May\n1940 5\n0.00 0.5\n0.02 -0.25\n0.04 0.1\n";
  EXPECT_FALSE(read(text).has_value());
  EXPECT_NE(messages().find("give excitation.skip_lines = 1"), std::string::npos) << messages();
  RecordOptions options;
  options.skip_lines = 2;
  const auto record = read(text, options);
  ASSERT_TRUE(record.has_value()) << messages();
  EXPECT_EQ(record->values, (ColumnValues{0.5, -0.25, 0.1}));
  EXPECT_EQ(record->header_lines, 2);
  options.skip_lines = 5;
  EXPECT_FALSE(read(text, options).has_value());
  EXPECT_EQ(messages(), ": error: holds nothing behind the 5 lines of excitation.skip_lines\n");
  options.skip_lines = 3;
  EXPECT_FALSE(read(text + "x\n", options).has_value());
  EXPECT_EQ(messages(), ":6:1: error: \"x\" is not a number\n:6:1: error: has 1 column, the first row has 2\n");
}

TEST_F(RecordColumns, SeveralValuesInALine) {
  // The last line is shorter, so that nothing but row by row can be meant.
  const ColumnValues all = {0.1, -0.2, 0.3, -0.4, 0.5, 0.05, -0.15, 0.25};
  const std::string rows = " .1 -.2 .3\n-.4 .5 .05\n-.15 .25\n";
  const auto ragged = read(rows, with_step(0.01));
  ASSERT_TRUE(ragged.has_value()) << messages();
  EXPECT_EQ(ragged->format, "values");
  EXPECT_EQ(ragged->values, all);
  EXPECT_EQ(ragged->time_step, 0.01);
  EXPECT_FALSE(read(rows).has_value());
  EXPECT_NE(messages().find("give excitation.time_step"), std::string::npos) << messages();
  EXPECT_EQ(messages().find("excitation.column"), std::string::npos) << messages();

  // Four full lines of three might be three channels of four values: it is to be said.
  const std::string full = "a record\n.1 -.2 .3\n-.4 .5 .05\n-.15 .25 0\n-.2 .1 0\n";
  EXPECT_FALSE(read(full, with_step(0.01)).has_value());
  EXPECT_EQ(messages(),
            ": error: has 3 numbers in a line, and the first is no time: give either excitation.format = \"values\", "
            "where all are accelerations of one record, row by row, or excitation.column, where each column is a "
            "channel\n");
  EXPECT_EQ(read(full, with_step(0.01, "values"))->values.size(), 12U);
  RecordOptions channel = with_step(0.01);
  channel.column = 2;
  const auto second = read(full, channel);
  ASSERT_TRUE(second.has_value()) << messages();
  EXPECT_EQ(second->values, (ColumnValues{-0.2, 0.5, 0.25, 0.1}));
  EXPECT_EQ(second->channel, "column 2 of 3");
  EXPECT_EQ(second->format, "one-column");
  channel.format = "values";
  EXPECT_FALSE(read(full, channel).has_value());
}

TEST_F(RecordColumns, CountAndStepInTheHeading) {
  struct Case {
    std::string text, format;
    ColumnValues values;
    int header_lines;
  };
  const ColumnValues four = {0.1, -0.2, 0.3, -0.4};
  const std::string eleven = ".1\n.2\n.1\n.2\n.1\n.2\n.1\n.2\n.1\n.2\n.1\n";
  const ColumnValues ten_and_one = {.1, .2, .1, .2, .1, .2, .1, .2, .1, .2, .1};
  for (const Case& one : std::vector<Case>{{"4 0.02\n.1\n-.2\n.3\n-.4\n", "one-column", four, 1},
                                           {"Kobe\n0.02 4\n.1\n-.2\n.3\n-.4\n", "one-column", four, 2},
                                           {"4 0.02\n.1 -.2 .3\n-.4\n", "values", four, 1},
                                           {"4 0.02\n.1 -.2\n.3 -.4\n-.1 .2\n", "", {}, 0},
                                           {"4 0.02\n.1 -.2\n-.3 -.4\n", "values", {0.1, -0.2, -0.3, -0.4}, 1},
                                           {"NPTS=  4, DT= .0200 SEC\n.1 -.2 .3\n-.4\n", "values", four, 1},
                                           {"somewhere\nNPTS 4\tDT .02\n.1\n-.2\n.3\n-.4\n", "one-column", four, 2},
                                           {"3 0.02\n0.00 .1\n0.02 .2\n0.04 .3\n", "two-column", {0.1, 0.2, 0.3}, 1},
                                           {"11\n0.02\n" + eleven, "one-column", ten_and_one, 2}}) {
    SCOPED_TRACE(one.text);
    const auto record = read(one.text);
    EXPECT_EQ(record.has_value(), !one.format.empty()) << messages();
    if (!record) continue;
    EXPECT_EQ(record->format, one.format);
    EXPECT_EQ(record->values, one.values);
    EXPECT_DOUBLE_EQ(record->time_step, 0.02);
    EXPECT_EQ(record->header_lines, one.header_lines);
  }
  EXPECT_FALSE(read("5 0.02\n.1\n-.2\n.3\n-.4\n").has_value());
  EXPECT_NE(messages().find(":1:1: error: says 5 values every 0.02 s, but 4 values follow"), std::string::npos);
  EXPECT_FALSE(read("NPTS= 5, DT= .02\n.1\n-.2\n.3\n-.4\n").has_value());
  EXPECT_EQ(messages(),
            ":1:7: error: says 5 values, but 4 follow (where the heading is of another record, give "
            "excitation.skip_lines = 1)\n");
  EXPECT_FALSE(read("NPTS= 3, DT= .02\n0 .1\n0.01 .2\n0.02 .3\n").has_value());
  EXPECT_EQ(
      messages(),
      ":1:14: error: says 0.02 s from value to value, but the times go forward by 0.01 s (where the heading is of "
      "another record, give excitation.skip_lines = 1)\n");
}

TEST_F(RecordColumns, QuotedCells) {
  for (const char* const text :
       {"\"time, s\",\"acc\"\n\"0.00\",\"0.5\"\n\"0.02\",\"-0.25\"\n\"0.04\",\"0.1\"\n",
        "\"0,00\",\"0,5\"\n\"0,02\",\"-0,25\"\n\"0,04\",\"0,1\"\n", "\"0,00\";\"0,5\"\n\"0,02\";\"-0,25\"\n0,04;0,1\n",
        "\"0.00\" \"0.5\"\n\"0.02\" \"-0.25\"\n\"0.04\" \"0.1\"\n", "0.00, \" 0.5\"\n0.02,-0.25\n0.04,\"0.1 \"\n"}) {
    SCOPED_TRACE(text);
    const auto record = read(text);
    ASSERT_TRUE(record.has_value()) << messages();
    EXPECT_EQ(record->values, (ColumnValues{0.5, -0.25, 0.1}));
    EXPECT_DOUBLE_EQ(record->time_step, 0.02);
  }
  EXPECT_FALSE(read("\"0.00\",\"0.5\"\n\"0.02\",\"-O.25\"\n\"0.04\",\"0.1\"\n\"0.06\",\"0.1\"\n").has_value());
  EXPECT_NE(messages().find("\"-O.25\" is not a number"), std::string::npos) << messages();
}

TEST_F(RecordColumns, ADecimalCommaInOneColumn) {
  const auto record = read("Beschleunigung\n0,25\n0\n-0,125\n1,5E-01\n", with_step(0.01));
  ASSERT_TRUE(record.has_value()) << messages();
  EXPECT_EQ(record->values, (ColumnValues{0.25, 0, -0.125, 0.15}));
  EXPECT_EQ(record->format, "one-column");
  // Whole numbers that go forward evenly before the comma are times, unless one column is asked for.
  const auto columns = read("0,5\n1,-2\n2,7\n");
  ASSERT_TRUE(columns.has_value()) << messages();
  EXPECT_EQ(columns->values, (ColumnValues{5, -2, 7}));
  EXPECT_EQ(read("0,5\n1,2\n2,7\n", with_step(0.01, "one-column"))->values, (ColumnValues{0.5, 1.2, 2.7}));
  EXPECT_EQ(read("1,5\n3,2\n4,7\n", with_step(0.01))->values, (ColumnValues{1.5, 3.2, 4.7}));
  EXPECT_FALSE(read("1,5\n3,2\n4,7\n", with_step(0.01, "csv")).has_value());
  EXPECT_FALSE(read("0 5\n1 2\n2 7\n", with_step(1, "csv")).has_value());
  EXPECT_NE(messages().find("as a csv file has"), std::string::npos) << messages();
}

// A step of 0.00488 s printed with four decimals: no time is off by more than half of the last.
TEST_F(RecordColumns, TimesMayBeRoundedToTheirLastDigit) {
  std::string rounded, uneven;
  for (int i = 0; i < 200; ++i) {
    rounded += fmt::format("{:.4f} {}\n", 0.00488 * i, i % 7);
    uneven += fmt::format("{:.4f} {}\n", 0.00488 * i + (i == 100 ? 0.0002 : 0), i % 7);
  }
  const auto record = read(rounded);
  ASSERT_TRUE(record.has_value()) << messages();
  EXPECT_NEAR(record->time_step, 0.00488, 0.0001 / 199);
  EXPECT_FALSE(read(uneven).has_value());
  EXPECT_FALSE(read("0.00 1\n0.01 2\n0.01 3\n0.02 4\n0.02 5\n0.03 6\n").has_value());  // too few digits for its step
}

TEST_F(RecordColumns, ColumnsWithTimeAreNotTakenForValues) {
  // A row lacks a value: a mistake to be told, whatever step is given.
  EXPECT_FALSE(read("0.00 0.5\n0.02\n0.04 0.1\n0.06 0.3\n", with_step(0.02)).has_value());
  EXPECT_EQ(messages(), ":2:1: error: has 1 column, the first row has 2\n");
  EXPECT_FALSE(read("0 1 2 3 4\n0.1 4 5 6 7\n0.2 1 2 3 4\n", with_step(0.1)).has_value());
  EXPECT_EQ(messages(),
            ": error: has 5 columns, time and 4 more: say in excitation.column (2 to 5) which one holds the "
            "accelerations\n");
  RecordOptions channel;
  channel.channel = 2;
  EXPECT_FALSE(read("0.00 0.5\n0.02 0.1\n", channel).has_value());
  EXPECT_NE(messages().find("excitation.channel has no meaning"), std::string::npos);
}

TEST_F(RecordColumns, VelocitiesWithAnotherHeadingAreRefused) {
  EXPECT_FALSE(read("PEER\nX\nY\nVELOCITY TIME HISTORY IN CM/S\n.1\n.2\n.3\n", with_step(0.01)).has_value());
  EXPECT_EQ(messages(), ":4:1: error: a velocity record, but ground accelerations are needed\n");
}

}  // namespace
}  // namespace bentur
