#include "bentur/io/records/record_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "tests/reference/shared_folder.h"
#include "tests/support/record_file.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

using test::RecordFile;
using Values = std::vector<double>;
const std::string peer_head =
    "PEER STRONG MOTION DATABASE RECORD\nSOMEWHERE\nACCELERATION TIME HISTORY IN UNITS OF G\n";

TEST_F(RecordFile, PeerHeadersInEachSpelling) {
  for (const char* const header : {"NPTS=  3, DT= .01000 SEC", "NPTS=   3, dt=  .01000", "3 0.01000 NPTS, DT",
                                   "npts=3,dt=.01sec", "NPTS =  3 , DT = 1.0D-02 SEC,", "   3    .0100    NPTS, DT"}) {
    SCOPED_TRACE(header);
    const auto record = read(peer_head + header + "\n  .1E-01  -.2D-01\n   3.E-02\n");
    ASSERT_TRUE(record.has_value()) << messages();
    EXPECT_EQ(record->format, "peer-at2");
    EXPECT_EQ(record->unit, "g");
    EXPECT_DOUBLE_EQ(record->time_step, 0.01);
    EXPECT_EQ(record->values, (Values{0.01, -0.02, 0.03}));
  }
}

TEST_F(RecordFile, LineEndsOfDosAndOldMacintosh) {
  for (const std::string end : {"\r\n", "\r"}) {
    std::string text = peer_head + "NPTS= 2, DT= .01 SEC\n .1 .2\n";
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size())
      text.replace(at, 1, end);
    const auto record = read(text + "\x1A");
    ASSERT_TRUE(record.has_value()) << messages();
    EXPECT_EQ(record->values, (Values{0.1, 0.2}));
  }
}

TEST_F(RecordFile, ACountBeyondAnyFileIsNoCount) {
  for (const auto& [name, before, after] :
       {std::tuple("csmip", "     9 points of accel", "  1e39 points of accel"),
        std::tuple("cosmos", "       9 acceleration pts", "    1e39 acceleration pts"),
        std::tuple("smc", "\n        10    -32768", "\n      1e39    -32768")}) {
    SCOPED_TRACE(name);
    std::ifstream file(std::string(BENTUR_SOURCE_DIR) + "/tests/fuzz/corpus/record/" + name + ".txt");
    std::string text{std::istreambuf_iterator<char>(file), {}};
    ASSERT_NE(text.find(before), std::string::npos);
    EXPECT_TRUE(read(text).has_value()) << messages();
    text.replace(text.find(before), std::string(before).size(), after);
    EXPECT_FALSE(read(text).has_value());
    EXPECT_EQ(messages().find("-922"), std::string::npos) << messages();
  }
}

TEST_F(RecordFile, PeerCountThatDisagreesStatesBoth) {
  EXPECT_FALSE(read(peer_head + "NPTS= 4, DT= .01 SEC\n .1 .2 .3\n").has_value());
  EXPECT_EQ(messages(), ":4:1: error: NPTS = 4, but the file holds 3 values\n");
  EXPECT_FALSE(read(peer_head + "NPTS= 2.5, DT= -.01 SEC\n .1 .2 .3\n").has_value());
  EXPECT_EQ(messages(), ":4:7: error: NPTS = 2.5, must be a whole number > 0\n:4:16: error: DT = -.01, must be > 0\n");
}

TEST_F(RecordFile, PeerVelocityAndDisplacementAreRefused) {
  const std::string rest = "NPTS= 2, DT= .01 SEC\n .1 .2\n";
  EXPECT_FALSE(read("PEER\nX\nVELOCITY TIME HISTORY IN UNITS OF CM/S\n" + rest).has_value());
  EXPECT_NE(messages().find("a velocity record"), std::string::npos);
  EXPECT_FALSE(read("PEER\nX\nDISPLACEMENT TIME SERIES IN UNITS OF CM\n" + rest).has_value());
  EXPECT_NE(messages().find("a displacement record"), std::string::npos);
  EXPECT_FALSE(read("PEER\nX\nACCELERATION TIME HISTORY IN UNITS OF CM/S/S\n" + rest).has_value());
  EXPECT_NE(messages().find("units of \"CM/S/S\""), std::string::npos);
  EXPECT_FALSE(read("PEER\nX\nACCELERATION TIME HISTORY\n" + rest).has_value());
  EXPECT_NE(messages().find("IN UNITS OF G"), std::string::npos);
}

TEST_F(RecordFile, BadNumbersWithLineAndColumn) {
  EXPECT_FALSE(read(peer_head + "NPTS= 4, DT= .01 SEC\n .1 .2\n .x NaN\n").has_value());
  EXPECT_EQ(messages(), ":6:2: error: \".x\" is not a number\n:6:5: error: \"NaN\" is not a finite number\n");
  EXPECT_FALSE(read("0 1\n1 inf\n2 1e999\n3 --2\n4 1.5.2\n").has_value());
  EXPECT_EQ(messages(),
            ":2:3: error: \"inf\" is not a finite number\n:3:3: error: \"1e999\" is not a finite number\n"
            ":4:3: error: \"--2\" is not a number\n:5:3: error: \"1.5.2\" is not a number\n");
}

TEST_F(RecordFile, ErrorsAreCutAfterTen) {
  std::string text = "0 1\n";
  for (int i = 1; i < 100; ++i) text += std::to_string(i) + " x\n";
  EXPECT_FALSE(read(text).has_value());
  EXPECT_EQ(diagnostics_.errors().size(), 10U);
}

TEST(RecordFiles, RecordsOfRealEarthquakes) {
  const fs::path folder = test::shared_folder() / "records";
  if (!fs::exists(folder)) GTEST_SKIP() << "the folder shared/records is not beside the sources";
  struct Known {
    const char* name;
    const char* format;
    double time_step;  // [s]
    std::size_t count;
  };
  // Step and number of values as headers and line counts of the files say.
  const std::vector<Known> known = {{"A-ELC180.AT2", "peer-at2", 0.01, 4000},
                                    {"ANLA196.AT2", "peer-at2", 0.02, 1451},
                                    {"AZF225.AT2", "peer-at2", 0.005, 2060},
                                    {"EUR090.AT2", "peer-at2", 0.02, 2200},
                                    {"FOR090.AT2", "peer-at2", 0.02, 2200},
                                    {"GCN-WE.AT2", "peer-at2", 0.00244, 8192},
                                    {"PBFEAS.AT2", "peer-at2", 0.01, 2364},
                                    {"RIO270.AT2", "peer-at2", 0.02, 1800},
                                    {"RSN1044_DirRot2.AT2", "peer-at2", 0.02, 2000},
                                    {"SHL000.AT2", "peer-at2", 0.02, 1800},
                                    {"el-centro-1940-s00e.txt", "two-column", 0.02, 2688},
                                    {"kobe.txt", "two-column", 0.02, 1250},
                                    {"hollister.txt", "two-column", 0.02, 601}};
  for (const Known& one : known) {
    SCOPED_TRACE(one.name);
    Diagnostics diagnostics;
    const auto record = read_record(folder / one.name, {}, diagnostics);
    for (const Diagnostic& error : diagnostics.errors()) ADD_FAILURE() << error.text();
    ASSERT_TRUE(record.has_value());
    EXPECT_EQ(record->format, one.format);
    EXPECT_EQ(record->values.size(), one.count);
    EXPECT_NEAR(record->time_step, one.time_step, 1e-12);
  }
  int read = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".md" || entry.path().filename() == "mexico-sct-1985.txt") continue;
    Diagnostics diagnostics;
    EXPECT_TRUE(read_record(entry.path(), {}, diagnostics).has_value()) << entry.path();
    ++read;
  }
  EXPECT_GE(read, 20);

  Diagnostics diagnostics;
  const auto el_centro = read_record(folder / "el-centro-1940-s00e.txt", {}, diagnostics).value();
  const auto peak = std::max_element(el_centro.values.begin(), el_centro.values.end(),
                                     [](double a, double b) { return std::abs(a) < std::abs(b); });
  EXPECT_NEAR(std::abs(*peak), 0.34874, 5e-6);
  EXPECT_EQ(peak - el_centro.values.begin(), 106);  // at 2.12 s

  EXPECT_FALSE(read_record(folder / "mexico-sct-1985.txt", {}, diagnostics).has_value());
  RecordOptions east;
  east.column = 3;
  const auto mexico = read_record(folder / "mexico-sct-1985.txt", east, diagnostics).value();
  EXPECT_EQ(mexico.format, "two-column");
  double largest = 0;
  for (const double value : mexico.values) largest = std::max(largest, std::abs(value));
  EXPECT_NEAR(largest, 0.171, 5e-4);
  EXPECT_NEAR(mexico.time_step, 0.02, 1e-5);
}

}  // namespace
}  // namespace bentur
