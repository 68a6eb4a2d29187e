// The formats of the networks. All files here are made up, in the layout that each network describes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "bentur/io/records/record_files.h"
#include "tests/support/record_file.h"

namespace bentur {
namespace {

using namespace std::string_literals;
using RecordFormats = test::RecordFile;
using Numbers = std::vector<double>;

RecordOptions channel_of(int channel) {
  RecordOptions options;
  options.channel = channel;
  return options;
}

RecordOptions by_name(const std::string& format) {
  RecordOptions options;
  options.format = format;
  return options;
}

/// Numbers in fields of a width, eight in a line, as Fortran's 8Fw.d writes them: they touch where they are wide.
std::string fixed_fields(const Numbers& values, int width, int decimals) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += fmt::format("{:>{}}", fmt::format("{:.{}f}", values[i], decimals), width);
    if (i % 8 == 7 || i + 1 == values.size()) text += "\n";
  }
  return text;
}

/// `count` fields of header, all `missing` but the one with a number from 1.
std::string header_block(int count, int in_line, int width, const std::string& missing, int place,
                         const std::string& value) {
  std::string text;
  for (int i = 1; i <= count; ++i) {
    text += fmt::format("{:>{}}", i == place ? value : missing, width);
    if (i % in_line == 0 || i == count) text += "\n";
  }
  return text;
}

// ---- COSMOS ----

struct CosmosChannel {
  std::string quantity = "acceleration", unit_text = "cm/sec2(04)", title = "360 deg";
  int unit = 4, count = 0;  // 0: as many as there are
  std::string step = "5.000000";
  Numbers values = {1.5, -12345.625, -10000.5, 3, 4, 5, 6, 7, 8.25};
};

std::string cosmos(const std::vector<CosmosChannel>& channels) {
  std::string text;
  for (const CosmosChannel& one : channels) {
    text += "Corrected acceleration    (Format v01.20 with 14 text lines) Src: made up\n";
    for (int i = 2; i <= 14; ++i) text += i == 9 ? "Sta Chan  7: " + one.title + " (Rcrdr Chan  1)\n" : "a line\n";
    text += " 100 Integer-header values follow on  10 lines, Format= (10I8)\n" +
            header_block(100, 10, 8, "-999", 3, std::to_string(one.unit));
    text += " 100 Real-header values follow on  17 lines, Format= (6F13.6)\n" +
            header_block(100, 6, 13, "-999.000000", 62, one.step);
    text += "   2 Comment line(s) follow, each starting with a \"|\":\n| 5 acceleration points of no meaning\n| end\n";
    text += fmt::format("{:8} {} pts, approx  0 secs, units={},Format=(8F10.3)\n",
                        one.count == 0 ? static_cast<int>(one.values.size()) : one.count, one.quantity, one.unit_text);
    text += fixed_fields(one.values, 10, 3) + "End-of-data for Chan  7 " + one.quantity + "\n";
  }
  return text;
}

TEST_F(RecordFormats, CosmosFieldsTouchAndStepIsInMilliseconds) {
  for (const std::string format : {"auto", "cosmos"}) {
    const auto record = read(cosmos({{}}), by_name(format));
    ASSERT_TRUE(record.has_value()) << messages();
    EXPECT_EQ(record->format, "cosmos");
    EXPECT_EQ(record->unit, "cm/s2");
    EXPECT_DOUBLE_EQ(record->time_step, 0.005);
    EXPECT_EQ(record->values, (Numbers{1.5, -12345.625, -10000.5, 3, 4, 5, 6, 7, 8.25}));
    EXPECT_EQ(record->header_lines, 14 + 11 + 18 + 3 + 1);
    EXPECT_EQ(record->channel, "");
  }
}

TEST_F(RecordFormats, CosmosUnits) {
  const auto in_unit = [&](int code, const std::string& text) {
    CosmosChannel channel;
    channel.unit = code;
    channel.unit_text = text;
    channel.values = {100, -50};
    return read(cosmos({channel}));
  };
  EXPECT_EQ(in_unit(2, "g.     (02)")->unit, "g");
  EXPECT_EQ(in_unit(10, "gal (10)")->unit, "cm/s2");
  const auto milli = in_unit(11, "mg (11)");
  EXPECT_EQ(milli->unit, "g");
  EXPECT_EQ(milli->values, (Numbers{0.1, -0.05}));
  EXPECT_EQ(in_unit(-999, "cm/sec2(04)")->unit, "cm/s2");
  EXPECT_EQ(in_unit(4, "cm/sec2")->unit, "cm/s2");
  EXPECT_EQ(in_unit(99, "who knows (99)")->unit, "");  // then the user has to say it
  EXPECT_FALSE(in_unit(50, "counts (50)").has_value());
  EXPECT_NE(messages().find("counts or volts"), std::string::npos) << messages();
  EXPECT_FALSE(in_unit(2, "cm/sec2(04)").has_value());
  EXPECT_NE(messages().find("says unit 4, but integer 3 of the headers says 2"), std::string::npos) << messages();
}

TEST_F(RecordFormats, CosmosChannelsAreChosenNotGuessed) {
  CosmosChannel second, velocity;
  second.title = "Up";
  second.step = "10.0";
  second.values = {9, 8, 7};
  velocity.quantity = "velocity";
  velocity.unit_text = "cm/sec (05)";
  velocity.unit = 5;
  const std::string text = cosmos({{}, velocity, second});
  EXPECT_FALSE(read(text).has_value());
  EXPECT_EQ(messages(),
            ": error: has 2 channels of accelerations: say in excitation.channel or excitation.component which one: 1 "
            "\"Chan 7: 360 deg\", 2 "
            "\"Chan 7: Up\"\n");
  const auto up = read(text, channel_of(2));
  ASSERT_TRUE(up.has_value()) << messages();
  EXPECT_EQ(up->values, (Numbers{9, 8, 7}));
  EXPECT_DOUBLE_EQ(up->time_step, 0.01);
  EXPECT_EQ(up->channel, "channel 2 of 2 (Chan 7: Up)");
  EXPECT_FALSE(read(text, channel_of(3)).has_value());
  EXPECT_EQ(messages(), ": error: has 2 channels of accelerations, excitation.channel = 3 is not there\n");
  EXPECT_FALSE(read(cosmos({velocity})).has_value());
  EXPECT_NE(messages().find("has no block of accelerations"), std::string::npos) << messages();
}

TEST_F(RecordFormats, CosmosCountMayBeOffByOne) {
  CosmosChannel channel;
  for (const auto& [count, good] : std::vector<std::pair<int, bool>>{{8, true}, {10, true}, {7, false}, {11, false}}) {
    channel.count = count;
    const auto record = read(cosmos({channel}));
    EXPECT_EQ(record.has_value(), good) << count;
    if (record) {
      EXPECT_EQ(record->values.size(), 9U);
    }
  }
  EXPECT_NE(messages().find("says 11 values, but 9 follow"), std::string::npos) << messages();
  channel.count = 0;
  channel.step = "-999.000000";
  EXPECT_FALSE(read(cosmos({channel})).has_value());
  EXPECT_NE(messages().find("real 62"), std::string::npos) << messages();
  std::string stars = cosmos({{}});
  stars.replace(stars.find("-12345.625"), 10, "**********");
  EXPECT_FALSE(read(stars).has_value());
  EXPECT_NE(messages().find(":48:11: error: \"**********\" is not a number"), std::string::npos) << messages();
}

// ---- CSMIP ----

std::string csmip_channel(int number, const std::string& accelerations, const std::string& title) {
  std::string text =
      fmt::format("Corrected accelerogram   00000-X0000-00000.00   Chan  {}: {}   from   \n", number, title);
  for (int i = 2; i <= 25; ++i) {
    text += i == 16 ? "     9 points of instrument- and baseline-corrected accel, veloc and displ data\n" : "a line\n";
  }
  for (int i = 0; i < 7; ++i)
    text += "    1  100    1    3    3  200    1    3    1   24   12 2866    058667   41    0\n";
  for (int i = 0; i < 13; ++i) {
    text += "  .0101833  .6400000 75.000000-999.00000-999.00000 624.00000  .0276252 32.570000\n";
  }
  return text + accelerations + "     2 points of veloc data equally spaced at  .020 sec, in cm/sec.  (8f10.7)\n" +
         fixed_fields({1, 2}, 10, 7) + "     2 points of displ data equally spaced at  .020 sec, in cm.  (8f10.7)\n" +
         fixed_fields({3, 4}, 10, 7) + fmt::format("/&  ----------  End of data for channel  {}  ----------\n", number);
}

TEST_F(RecordFormats, CsmipVolume2) {
  const Numbers values = {1.5, -123.456789, -100.000001, 3, 4, 5, 6, 7, 8.25};
  const std::string block =
      "     9 points of accel data equally spaced at  .020 sec, in cm/sec2. (8f10.5)\n" + fixed_fields(values, 10, 5);
  const auto record = read(csmip_channel(1, block, " 90 Deg"));
  ASSERT_TRUE(record.has_value()) << messages();
  EXPECT_EQ(record->format, "csmip");
  EXPECT_EQ(record->unit, "cm/s2");
  EXPECT_DOUBLE_EQ(record->time_step, 0.02);
  ASSERT_EQ(record->values.size(), 9U);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(record->values[i], values[i], 5e-6);  // five decimals
  EXPECT_EQ(record->header_lines, 46);

  const std::string older = "9 POINTS OF ACCEL DATA EQUALLY SPACED AT  .010 SEC.  (UNITS: CM/SEC/SEC)\n";
  const std::string two =
      csmip_channel(1, block, "90 Deg") + csmip_channel(2, older + fixed_fields(values, 10, 3), "Up");
  EXPECT_FALSE(read(two).has_value());
  EXPECT_EQ(messages(),
            ": error: has 2 channels of accelerations: say in excitation.channel or excitation.component which one: 1 "
            "\"Chan 1: 90 Deg\", 2 "
            "\"Chan 2: Up\"\n");
  const auto up = read(two, channel_of(2));
  ASSERT_TRUE(up.has_value()) << messages();
  EXPECT_DOUBLE_EQ(up->time_step, 0.01);
  EXPECT_EQ(up->unit, "cm/s2");
  EXPECT_EQ(up->channel, "channel 2 of 2 (Chan 2: Up)");
  EXPECT_EQ(up->header_lines, 46);
  const std::string endless = "9e99 POINTS OF ACCEL DATA EQUALLY SPACED AT  .010 SEC.  (UNITS: CM/SEC/SEC)\n";
  for (const std::string& none : {std::string(), endless}) {
    EXPECT_FALSE(read(csmip_channel(1, none, "90 Deg")).has_value());
    EXPECT_NE(messages().find("has no block of accelerations"), std::string::npos) << messages();
  }
}

TEST_F(RecordFormats, CsmipVolume1) {
  std::string text = "Uncorrected Accelerogram Data             Processed: never\n";
  for (int i = 0; i < 26; ++i) text += "a line\n";
  const auto record = read(text + "     3 Accelerogram points at 200 pts/sec in units of g .      Format: (8f9.6)\n" +
                           fixed_fields({-10.123456, -0.5, 0.25}, 10, 6).replace(0, 1, "") +
                           "/&  ----------  End of Data for Channel  1  ----------\n");
  EXPECT_FALSE(record.has_value());  // the first field is a place too wide, so all are out of place
  const auto good = read(text + "     3 Accelerogram points at 200 pts/sec in units of g .      Format: (8f9.6)\n" +
                         fixed_fields({-1.123456, -0.5, 0.25}, 9, 6) + "/&  --- End of Data for Channel  1\n");
  ASSERT_TRUE(good.has_value()) << messages();
  EXPECT_EQ(good->unit, "g");
  EXPECT_DOUBLE_EQ(good->time_step, 0.005);
  EXPECT_EQ(good->values, (Numbers{-1.123456, -0.5, 0.25}));
}

// ---- SMC ----

std::string smc(const std::string& kind, const std::string& rate, int count, int comments, const std::string& data) {
  std::string text = kind + "\n";
  for (int i = 0; i < 10; ++i) text += "*\n";
  std::string integers = header_block(48, 8, 10, "-32768", 17, std::to_string(count));
  integers.replace(integers.find('\n') + 1 + 70, 10, fmt::format("{:>10}", comments));
  text += integers + header_block(50, 5, 15, "0.1700000E+39", 2, rate);
  for (int i = 0; i < comments; ++i) text += "|a comment\n";
  return text + data;
}

TEST_F(RecordFormats, SmcFieldsTouch) {
  const std::string data =
      " 1.5057E+0-2.2223E+0-1.9234E+0-3.1562E+0-3.2440E+0-3.5638E+0-5.1941E+0-5.7933E+0\n-5.5295E+1-5.4933E-1\n";
  const auto record = read(smc("2 CORRECTED ACCELEROGRAM", "0.2000000E+03", 10, 3, data));
  ASSERT_TRUE(record.has_value()) << messages();
  EXPECT_EQ(record->format, "smc");
  EXPECT_EQ(record->unit, "cm/s2");
  EXPECT_DOUBLE_EQ(record->time_step, 0.005);
  EXPECT_EQ(record->values,
            (Numbers{1.5057, -2.2223, -1.9234, -3.1562, -3.244, -3.5638, -5.1941, -5.7933, -55.295, -0.54933}));
  EXPECT_EQ(record->header_lines, 30);
  EXPECT_TRUE(read(smc("1 UNCORRECTED ACCELEROGRAM", "0.2000000E+03", 10, 0, data)).has_value());

  EXPECT_FALSE(read(smc("2 CORRECTED ACCELEROGRAM", "0.2000000E+03", 11, 3, data)).has_value());
  EXPECT_EQ(messages(), ":14:1: error: says 11 values, but the file holds 10\n");
  EXPECT_FALSE(read(smc("3 VELOCITY", "0.2000000E+03", 10, 3, data)).has_value());
  EXPECT_EQ(messages(), ":1:1: error: the file holds \"3 VELOCITY\", but ground accelerations are needed\n");
  EXPECT_FALSE(read(smc("1 UNCORRECTED ACCELEROGRAM", "0.1700000E+39", 10, 3, data)).has_value());
  EXPECT_NE(messages().find("uneven times"), std::string::npos) << messages();
  EXPECT_FALSE(read(smc("2 CORRECTED ACCELEROGRAM", "0.2000000E+03", -32768, -32768, data)).has_value());
  EXPECT_NE(messages().find("number of values"), std::string::npos) << messages();
  EXPECT_NE(messages().find("number of comment lines"), std::string::npos) << messages();
  std::string one_more = smc("2 CORRECTED ACCELEROGRAM", "0.2000000E+03", 10, 3, data);
  one_more.replace(one_more.find("|a comment"), 1, " ");
  EXPECT_FALSE(read(one_more).has_value());
  EXPECT_NE(messages().find("must be one of 3 comment lines"), std::string::npos) << messages();
  EXPECT_FALSE(read(smc("2 CORRECTED ACCELEROGRAM", "0.2000000E+03", 2, 0, " 1.5057E+0 1.7000E38\n")).has_value());
  EXPECT_NE(messages().find("marked as missing"), std::string::npos) << messages();
}

// ---- K-NET ----

std::string knet(const std::string& scale = "3920(gal)/6182761", const std::string& rate = "100Hz",
                 const std::string& peak = "0.001") {
  return "Origin Time       2000/01/01 00:00:00\nLat.              0\nLong.             0\nDepth. (km)       1\n"
         "Mag.              7\nStation Code      XXX001\nStation Lat.      0\nStation Long.     0\nStation Height(m) "
         "1\n"
         "Record Time       2000/01/01 00:00:15\nSampling Freq(Hz) " +
         rate + "\nDuration Time(s)  0\nDir.              N-S\nScale Factor      " + scale + "\nMax. Acc. (gal)   " +
         peak + "\nLast Correction   2000/01/01 00:00:00\nMemo.             \n";
}

TEST_F(RecordFormats, KnetMeanIsTakenOff) {
  const auto record =
      read(knet("2000(gal)/8000", "100Hz", "2.500") + "     1000     1004     1008     1012 \n     1016     1020\n");
  ASSERT_TRUE(record.has_value()) << messages();
  EXPECT_EQ(record->format, "knet");
  EXPECT_EQ(record->unit, "cm/s2");
  EXPECT_DOUBLE_EQ(record->time_step, 0.01);
  EXPECT_EQ(record->values, (Numbers{-2.5, -1.5, -0.5, 0.5, 1.5, 2.5}));  // a quarter of a gal a count
  EXPECT_EQ(record->mean_removed, 252.5);
  EXPECT_EQ(record->header_lines, 17);
  EXPECT_EQ(echo_notes(echo_of(*record, "a", "cm/s2")), ", 17 header lines, mean 252.5 cm/s2 removed");
  EXPECT_FALSE(read(knet("2000(gal)/8000", "100Hz", "3.500") + " 1000 1004 1008 1012 1016 1020\n").has_value());
  EXPECT_EQ(messages(), ":15:19: error: says a peak of 3.5 cm/s2, but that of the values is 2.5 cm/s2\n");
  EXPECT_FALSE(read(knet("3920/6182761") + "1 2 3\n").has_value());
  EXPECT_EQ(messages(), ":14:1: error: must give gal per count, as in \"Scale Factor      3920(gal)/6182761\"\n");
  EXPECT_FALSE(read(knet("3920(gal)/6182761", "Hz") + "1 2 3\n").has_value());
  EXPECT_NE(messages().find(":11:1: error: must give the sampling frequency"), std::string::npos) << messages();
  EXPECT_FALSE(read("1\n2\n", by_name("knet")).has_value());
}

// ---- ESM ----

std::string esm(const std::string& unit = "cm/s^2", const std::string& type = "ACCELERATION", int count = 3) {
  std::string text = "EVENT_NAME: NOWHERE: AT 10:15\nINSTRUMENT: sensor = X [1] | digitizer = Y\nVS30_M/S: \n";
  text += fmt::format("SAMPLING_INTERVAL_S: 0.005000\nNDATA: {}\nUNITS: {}\nDATA_TYPE: {}\n", count, unit, type);
  for (int i = 8; i <= 64; ++i) text += fmt::format("USER{}: a: b\n", i);
  return text;
}

TEST_F(RecordFormats, EsmKeysEndAtTheFirstColon) {
  const auto record = read(esm() + "0.5\n-1.25\n  0.75\n");
  ASSERT_TRUE(record.has_value()) << messages();
  EXPECT_EQ(record->format, "esm");
  EXPECT_EQ(record->unit, "cm/s2");
  EXPECT_DOUBLE_EQ(record->time_step, 0.005);
  EXPECT_EQ(record->values, (Numbers{0.5, -1.25, 0.75}));
  EXPECT_EQ(record->header_lines, 64);
  EXPECT_EQ(read(esm("m/s^2") + "1\n2\n3\n")->unit, "m/s2");
  EXPECT_FALSE(read(esm("cm/s", "VELOCITY") + "1\n2\n3\n").has_value());
  EXPECT_EQ(messages(),
            ":6:8: error: \"cm/s\" is no unit of acceleration that is known\n"
            ":7:12: error: the file holds \"VELOCITY\", but ground accelerations are needed\n");
  EXPECT_FALSE(read(esm("cm/s^2", "ACCELERATION", 4) + "1\n2\n3\n").has_value());
  EXPECT_EQ(messages(), ":5:8: error: NDATA is 4, but the file holds 3 values\n");
  EXPECT_FALSE(read("1\n2\n", by_name("esm")).has_value());
}

// ---- Any of them ----

TEST_F(RecordFormats, OtherFormatsHaveNoColumnsAndMayHaveOneChannel) {
  RecordOptions column;
  column.column = 2;
  for (const std::string& text : {knet() + "1 2 3\n", esm() + "1\n2\n3\n", cosmos({{}})}) {
    EXPECT_FALSE(read(text, column).has_value());
    EXPECT_NE(messages().find("no columns to choose from"), std::string::npos) << messages();
    EXPECT_TRUE(read(text, channel_of(1)).has_value()) << messages();
    EXPECT_FALSE(read(text, channel_of(2)).has_value());
    EXPECT_NE(messages().find("excitation.channel = 2 is not there"), std::string::npos) << messages();
  }
}

TEST_F(RecordFormats, NamesThatDoNotFitAreToldNotFollowed) {
  for (const char* const format : {"peer-at2", "cosmos", "csmip", "smc", "knet", "esm"}) {
    EXPECT_FALSE(read("0.00 0.5\n0.02 0.25\n0.04 0.1\n0.06 0.2\n0.08 1\n", by_name(format)).has_value()) << format;
    EXPECT_FALSE(messages().empty());
  }
}

TEST_F(RecordFormats, LinesBeforeAnyFormatCanBeSkipped) {
  RecordOptions options;
  options.skip_lines = 2;
  const auto record = read("fetched yesterday\n-- begin --\n" + knet() + "1 2 3\n", options);
  ASSERT_TRUE(record.has_value()) << messages();
  EXPECT_EQ(record->header_lines, 19);
}

TEST_F(RecordFormats, Utf16AndMarks) {
  const std::string text = "Beschl\xE4unigung\r\n0.00 0.5\r\n0.02 -0.25\r\n0.04 0.1\r\n";
  const std::string rows = text.substr(text.find('\n') + 1);
  for (const bool mark : {true, false}) {
    for (const bool big : {true, false}) {
      std::string wide = !mark ? "" : big ? "\xFE\xFF" : "\xFF\xFE";
      for (const char c : text) wide += big ? std::string{'\0', c} : std::string{c, '\0'};
      const auto record = read(wide);
      ASSERT_TRUE(record.has_value()) << messages();
      EXPECT_EQ(record->values, (Numbers{0.5, -0.25, 0.1}));
      EXPECT_EQ(record->header_lines, 1);
      std::string bare = wide.substr(0, mark ? 2 : 0);  // the mark is no part of the first number
      for (const char c : rows) bare += big ? std::string{'\0', c} : std::string{c, '\0'};
      EXPECT_EQ(read(bare).value().values, (Numbers{0.5, -0.25, 0.1}));
    }
  }
}

TEST_F(RecordFormats, WhatIsNoText) {
  EXPECT_FALSE(read(std::string("PK\x03\x04 and so on\n1 2\n")).has_value());
  EXPECT_NE(messages().find("spreadsheet"), std::string::npos) << messages();
  EXPECT_FALSE(read("CDF\x01 abc\0\0\0\x02 1 2 3 4 5 6 7 8 9 a b c d e f g h"s).has_value());
  EXPECT_EQ(messages(), ": error: is a binary file, but records are text\n");
}

TEST_F(RecordFormats, SizesAreBounded) {
  std::string lines;
  for (int i = 0; i < 5000001; ++i) lines += "1\n";
  EXPECT_FALSE(read(lines).has_value());
  EXPECT_EQ(messages(), ": error: has more than 5000000 lines, which no record has\n");
  EXPECT_FALSE(read("1 2\n" + std::string((std::size_t{4} << 20) + 1, '1') + "\n").has_value());
  EXPECT_EQ(messages(), ":2:1: error: is a line of more than 4 MiB, which no record has\n");
  EXPECT_FALSE(read(std::string((std::size_t{64} << 20) + 1, ' ')).has_value());
  EXPECT_EQ(messages(), ": error: is larger than 64 MiB, which no record is\n");
}

TEST_F(RecordFormats, OnlyRegularFilesAreOpened) {
  Diagnostics found;
  const auto refused = [&](const std::filesystem::path& file) {
    found = Diagnostics();
    EXPECT_FALSE(read_record(file, {}, found).has_value());
    return found.ok() ? "" : found.errors().front().message();
  };
  EXPECT_EQ(refused(folder_.path()), "is a folder, not a record");
  EXPECT_EQ(refused(folder_.path() / "none"), "there is no such file");
  std::filesystem::create_symlink("itself", folder_.path() / "itself");
  EXPECT_NE(refused(folder_.path() / "itself").find("cannot be read: "), std::string::npos);
}

}  // namespace
}  // namespace bentur
