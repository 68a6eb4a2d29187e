// Records of networks on paper, and what is said of them otherwise: each is read right or refused for its reason.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bentur/io/records/record_files.h"
#include "tests/records/paper_records.h"
#include "tests/support/record_file.h"

namespace bentur {
namespace {

using test::paper_waves;
using test::PaperComponents;

/// Three components of 123 values, so that the last line of each is shorter.
PaperComponents three(double peak, const std::string& first = "N-S", const std::string& second = "E-W",
                      const std::string& up = "U-D") {
  return {
      {first, paper_waves(123, peak)}, {second, paper_waves(123, -peak / 2, 5)}, {up, paper_waves(123, peak / 4, 3)}};
}

class NetworkRecords : public test::RecordFile {
 protected:
  /// What is read is a component, times a factor, to the digits that the layout has.
  void expect_read(const std::string& text, const RecordOptions& options, const std::string& format,
                   const std::string& unit, double step, const std::vector<double>& values, double digit) {
    const auto record = read(text, options);
    ASSERT_TRUE(record.has_value()) << messages();
    EXPECT_EQ(record->format, format);
    EXPECT_EQ(record->unit, unit);
    EXPECT_NEAR(record->time_step, step, 1e-12);
    EXPECT_TRUE(contradictions(*record, options).empty());
    ASSERT_EQ(record->values.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) ASSERT_NEAR(record->values[i], values[i], 0.51 * digit) << i;
  }

  /// The text with one phrase changed for another, which stands in it.
  static std::string with(std::string text, const std::string& old, const std::string& changed) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), changed);
  }

  void expect_refused(const std::string& text, const RecordOptions& options, const std::string& why) {
    EXPECT_FALSE(read(text, options).has_value()) << why;
    EXPECT_NE(messages().find(why), std::string::npos) << messages();
  }
};

RecordOptions component(const std::string& name) {
  RecordOptions options;
  options.component = name;
  return options;
}

RecordOptions channel(int number) {
  RecordOptions options;
  options.channel = number;
  return options;
}

TEST_F(NetworkRecords, GeoNet) {
  const PaperComponents all = three(6543.2, "N10E", "S80E", "Up");
  for (const bool corrected : {true, false}) {
    SCOPED_TRACE(corrected);
    const double step = corrected ? 0.02 : 0.005;
    const std::string text = test::paper_geonet(all, step, corrected);
    ASSERT_EQ(corrected, text.find("-6543.2-") != std::string::npos || corrected);  // fields touch
    for (int i = 0; i < 3; ++i) {
      const std::vector<double>& values = all[static_cast<std::size_t>(i)].values;
      expect_read(text, channel(i + 1), "geonet", "mm/s2", step, values, 0.1);
      expect_read(text, component(all[static_cast<std::size_t>(i)].name), "geonet", "mm/s2", step, values, 0.1);
    }
    EXPECT_EQ(read(text, component("U-D"))->channel, "channel 3 of 3 (Up)");  // another name of the same
    expect_refused(text, {},
                   "has 3 channels of accelerations: say in excitation.channel or excitation.component which "
                   "one: 1 \"N10E\", 2 \"S80E\", 3 \"Up\"");
    expect_refused(text, component("N-S"), "has no component \"N-S\", but \"N10E\", \"S80E\", \"Up\"");
    RecordOptions both = component("Up");
    both.channel = 1;
    expect_refused(text, both, "has \"Up\" as channel 3, but excitation.channel = 1 is given");
    both.channel.reset();
    both.column = 2;
    expect_refused(text, both, "has no columns to choose from");
    const std::string one = test::paper_geonet({all[1]}, step, corrected);
    expect_read(one, {}, "geonet", "mm/s2", step, all[1].values, 0.1);
    const auto record = read(one);
    EXPECT_EQ(record->channel, "");
    EXPECT_EQ(record->header_lines, 26);
    // Lines are missing at the end: fewer than are stated of accelerations, or of what stands behind them.
    expect_refused(one.substr(0, one.size() - 300), {}, "says 123 values, but");
    expect_refused(with(one, "points   123", "points   122"), {}, "says 122 values, but 123 follow");
    expect_refused(with(one, "-3271.6 mm/s/s", " -327.2 mm/s/s"), {},
                   "says a peak of 327.2 mm/s2, but that of the values");
    // What the file holds is no rows of one record (4 lines of integers, 6 of reals, velocities), as it was once read.
    RecordOptions wrong;
    wrong.format = "values";
    wrong.time_step = step;
    wrong.unit = "mm/s2";
    expect_refused(
        one, wrong,
        "is a geonet file, whose numbers are not accelerations alone: leave excitation.format = \"values\" out");
    expect_refused(one.substr(one.find("Site")), wrong, "says 123 values, but");
  }
}

TEST_F(NetworkRecords, Afad) {
  const PaperComponents all = three(345.678901);
  const std::string text = test::paper_afad(all, 0.01);
  expect_read(text, component("n-s"), "afad", "cm/s2", 0.01, all[0].values, 1e-6);
  expect_read(text, channel(2), "afad", "cm/s2", 0.01, all[1].values, 1e-6);
  RecordOptions column;
  column.column = 3;
  expect_read(text, column, "afad", "cm/s2", 0.01, all[2].values, 1e-6);
  EXPECT_EQ(read(text, column)->channel, "channel 3 of 3 (U-D)");
  EXPECT_EQ(read(text, column)->header_lines, 18);
  column.column = 4;
  expect_refused(text, column, "has accelerations from column 1 to 3, excitation.column = 4 is not one of them");
  expect_refused(text, {}, "1 \"N-S\", 2 \"E-W\", 3 \"U-D\"");
  expect_refused(with(text, ": 123", ": 124"), channel(1), ":13:27: error: says 124 values, but 123 follow");
  // The peak of each component is its own.
  expect_refused(with(text, "(E-W) 172", "(E-W) 182"), channel(2),
                 "says a peak of 182.839 cm/s2, but that of the values");
  EXPECT_TRUE(read(with(text, "(E-W) 172", "(E-W) 182"), channel(1)).has_value()) << messages();
  // What the user says otherwise.
  RecordOptions wrong = channel(1);
  wrong.time_step = 0.005;
  wrong.unit = "g";
  const auto otherwise = contradictions(read(text, wrong).value(), wrong);
  ASSERT_EQ(otherwise.size(), 2U);
  EXPECT_EQ(otherwise[0].key + ": " + otherwise[0].given + ", " + otherwise[0].said,
            "time_step: 0.005 s, 0.01 s in line 14");
  EXPECT_EQ(otherwise[1].key + ": " + otherwise[1].given + ", " + otherwise[1].said,
            "unit: \"g\", \"cm/s2\" in line 15");
  // Without its first line it is no file of AFAD, but its heading is understood; only the unit is stated of the peak
  // alone, and the peak stands against another one.
  const std::string headless = text.substr(text.find("PLACE"));
  RecordOptions by_hand;
  by_hand.column = 1;
  by_hand.unit = "cm/s2";
  expect_read(headless, by_hand, "one-column", "", 0.01, all[0].values, 1e-6);
  by_hand.unit = "g";
  expect_refused(headless, by_hand, "says a peak of 345.679 cm/s2, but that of the values is 345.679 g");
}

TEST_F(NetworkRecords, Asa) {
  const PaperComponents all = three(58.7394, "V", "N00E;+", "N90E");
  const std::string text = test::paper_asa(all, 0.005);
  expect_read(text, component("V"), "asa", "cm/s2", 0.005, all[0].values, 1e-4);
  expect_read(text, component("N-S"), "asa", "cm/s2", 0.005, all[1].values, 1e-4);
  expect_read(text, channel(3), "asa", "cm/s2", 0.005, all[2].values, 1e-4);
  EXPECT_EQ(read(text, component("N-S"))->channel, "channel 2 of 3 (N00E)");
  // --column 1 --time-step 0.01 --unit g, as it was once read without a word.
  RecordOptions wrong;
  wrong.of_command = true;
  wrong.column = 1;
  wrong.time_step = 0.01;
  wrong.unit = "g";
  const auto otherwise = contradictions(read(text, wrong).value(), wrong);
  ASSERT_EQ(otherwise.size(), 2U);
  EXPECT_EQ(otherwise[0].said, "0.005 s in line 11");
  EXPECT_EQ(otherwise[1].said, "\"cm/s2\" in line 20");
  EXPECT_EQ(otherwise[0].line, 11);
  expect_refused(with(text, "/123/123/123", "/122/123/123"), channel(1), "says 122 values, but 123 follow");
  EXPECT_TRUE(read(with(text, "/123/123/123", "/122/123/123"), channel(2)).has_value()) << messages();
  // Rows that repeat the last one fill up a block.
  const std::size_t last = text.rfind('\n', text.size() - 2) + 1;
  expect_read(text + text.substr(last) + text.substr(last), channel(1), "asa", "cm/s2", 0.005, all[0].values, 1e-4);
  expect_refused(text + "    1.0000    1.0000    1.0000\r\n", channel(1), "says 123 values, but 124 follow");
  expect_refused(text + "    1.0000    1.0000\r\n", channel(1), "has 2 columns, not 3");
  expect_refused(with(text, "Gal (cm/s/s)", "Cuentas"), channel(1), "\"Cuentas\" is no unit of acceleration");
  expect_refused(with(text, "/58.7394", "/5.87394"), channel(1), "says a peak of 5.87394 cm/s2");
}

TEST_F(NetworkRecords, PairsOfVolume1) {
  const PaperComponents all = three(-6.82, "EW", "NS", "Z");
  std::vector<double> times, uneven;
  for (int i = 0; i < 123; ++i) {
    times.push_back(99 + 0.01 * i);  // from 100 s on the fields touch: "99.990  0.338100.000"
    uneven.push_back(0.005 * i + (i % 3 == 1 ? 0.001 : 0));
  }
  const std::string text = test::paper_pairs(all, times);
  ASSERT_NE(text.find("100.005"), text.find("100.010"));
  for (int i = 0; i < 3; ++i) {
    std::vector<double> values = all[static_cast<std::size_t>(i)].values;
    for (double& value : values) value /= 10;  // of g/10
    expect_read(text, channel(i + 1), "csmip", "g", 0.01, values, 1e-4);
    expect_read(text, component(all[static_cast<std::size_t>(i)].name), "csmip", "g", 0.01, values, 1e-4);
  }
  EXPECT_EQ(read(text, component("E-W"))->channel, "channel 1 of 3 (CHAN 1: EW)");
  expect_refused(
      test::paper_pairs(all, uneven), channel(1),
      ":12:1: error: is followed by pairs of time and acceleration at uneven times, which go forward by 0.004 "
      "to 0.006 s: take the corrected accelerogram (volume 2)");
  expect_refused(with(text, "MAX  = -0.682 G", "MAX  = -0.068 G"), channel(1), "says a peak of 0.068 g");
  expect_refused(with(text, "POINTS =    123", "POINTS =    120"), channel(1), "says 120 values, but 123 follow");
}

TEST_F(NetworkRecords, CsmipFieldsAreAsWideAsTheirLines) {
  // 8F9.6, of which the file does not say the format.
  const std::vector<double> values = paper_waves(400, 0.1);
  std::string text = test::paper_pairs({{"90 DEG", paper_waves(400, 1)}}, std::vector<double>(400, 0));
  text = text.substr(0, text.find("     0.000     0.000\n") + 21);
  text = with(text, "ARE SEC AND G/10. ", "IS G.             ");
  text += "  400 POINTS OF ACCEL DATA EQUALLY SPACED AT .005 SEC.  (UNITS: G)\n" + test::paper_fields(values, 8, 9, 6) +
          "/&  ----------  END OF DATA FOR CHANNEL  1  ----------\n";
  expect_read(text, {}, "csmip", "g", 0.005, values, 1e-6);
}

TEST_F(NetworkRecords, Bhrc) {
  const PaperComponents all = three(1.94316, "L", "V", "T");
  const std::string text = test::paper_bhrc(all, 0.005);
  for (int i = 0; i < 3; ++i) {
    std::vector<double> values = all[static_cast<std::size_t>(i)].values;
    for (double& value : values) value /= 10;
    expect_read(text, component(all[static_cast<std::size_t>(i)].name), "bhrc", "g", 0.005, values, 1e-7);
  }
  EXPECT_EQ(read(text, channel(2))->channel, "channel 2 of 3 (V)");
  EXPECT_EQ(read(text, channel(2))->header_lines, 27);
  expect_refused(with(text, "  0.615", "  6.615"), channel(1),
                 ":11:1: error: says 123 values in 6.615 s, but the headers 200 values a second");
  expect_refused(with(text, "POINTS =    123", "POINTS =    122"), channel(1), "says 122 values, but 123 follow");
  expect_refused(with(text, "AND G/10", "AND CM"), channel(1), "must say \"NO. OF POINTS\" and");
}

TEST_F(NetworkRecords, KnetAsCsv) {
  const PaperComponents all = three(104.25);
  const std::string text = test::paper_knet_csv(all, 0.01, -18.6);
  double mean = 0;
  for (const double value : all[1].values) mean += value / 123;
  std::vector<double> values = all[1].values;
  for (double& value : values) value -= mean;
  expect_read(text, component("E-W"), "knet-csv", "cm/s2", 0.01, values, 2e-4);
  EXPECT_NEAR(read(text, channel(2))->mean_removed, mean - 18.6, 1e-4);
  EXPECT_EQ(read(text, channel(2))->channel, "channel 2 of 3 (E-W)");
  RecordOptions column;
  column.column = 4;
  expect_read(text, column, "knet-csv", "cm/s2", 0.01, values, 2e-4);
  column.column = 2;
  expect_refused(text, column, "has accelerations from column 3 to 5, excitation.column = 2 is not one of them");
  expect_refused(with(text, "#100\n", "#50\n"), channel(1), "but the heading says 1.23 s of 0.02 s each");
  expect_refused(with(with(text, "#100\n", "#50\n"), "#1.23\n", "#2.46\n"), channel(1),
                 ":19:1: error: stands at \"0.02\" s, but values every 0.02 s have reached 0.04 s");
  // A row that is missing, and one that is damaged.
  const std::size_t row = text.find("2024/01/01 00:00:15.50"), next = text.find("2024/01/01 00:00:15.51");
  expect_refused(text.substr(0, row) + text.substr(next), channel(1),
                 ":67:1: error: stands at \"0.51\" s, but values every 0.01 s have reached 0.5 s");
  expect_refused(with(text, "15.50,0.50,", "15.50,half,"), channel(1), "stands at \"half\" s");
  expect_refused(with(text, "E-W(gal),U-D(gal)\n2024", "E-W(m/s2),U-D(gal)\n2024"), channel(1),
                 "must be the name of a component in gal");
  // The borehole and the surface of KiK-net, by number.
  const PaperComponents six = {{"1", values}, {"2", values}, {"3", values}, {"4", all[0].values}, {"5", values}};
  EXPECT_EQ(read(test::paper_knet_csv(six, 0.01, 1), component("4"))->channel, "channel 4 of 5 (4)");
}

// As columns: JMA (Japan), CWA (Taiwan), tables of seismic databases.
TEST_F(NetworkRecords, HeadingsOfOthersAreUnderstood) {
  const std::string jma =
      "SITE CODE= TOWN,37.5,137.2,16,7.6\r\n LAT.= 37.0\r\n LON.= 137.0\r\n SAMPLING RATE= 100Hz\r\n UNIT  = "
      "gal(cm/s/s)\r\nINITIAL TIME = 2024 01 01 16 10 00\r\n   NS,EW,UD\r\n1.5,2,3\r\n-4,-5,-6\r\n2,2,3\r\n";
  expect_read(jma, component("N-S"), "one-column", "cm/s2", 0.01, {1.5, -4, 2}, 1e-9);
  EXPECT_EQ(read(jma, component("U-D"))->channel, "column 3 of 3 (UD)");
  expect_refused(jma, {},
                 "has 3 columns without time: say in excitation.column (1 to 3) or excitation.component which one "
                 "holds the accelerations: 1 \"NS\", 2 \"EW\", 3 \"UD\"");
  const std::string cwa =
      "#StationCode: TOWN\n#RecordLength(sec): 0.06\n#SampleRate(Hz): 50\n#AmplitudeUnit:  gal. DCoffset(corr)\n"
      "#AmplitudeMAX. U:    0.658~   -0.837\n#DataSequence: Time U(+); N(+); E(+)\n#Data: 4F10.3 \n     0.000     "
      "0.100     0.200     0.300\n     0.020     0.500     0.600     0.700\n     0.040    -0.100    -0.200    -0.300\n";
  expect_read(cwa, component("N"), "two-column", "cm/s2", 0.02, {0.2, 0.6, -0.2}, 1e-9);
  const std::string touching =
      "Orientation                   : NS\nTime Increment (s)            : 0.005\nNumber of Data                : "
      "7\nPGA "
      "(m/s/s)                   : 3.0000000E+00\nAccelaration time series in m/s/s\n 1.0000000E+00-2.0000000E+00 "
      "3.0000000E+00-1.5000000E-02-1.0000000E-03\n-2.0000000E-01 1.0000000E-01\n";
  expect_read(touching, {}, "values", "m/s2", 0.005, {1, -2, 3, -0.015, -0.001, -0.2, 0.1}, 1e-12);
  EXPECT_FALSE(read(touching, component("E-W")).has_value());
  expect_refused(with(touching, ": 3.0000000E+00", ": 3.0000000E-01"), {}, ":4:33: error: says a peak of 0.3 m/s2");
}

TEST_F(NetworkRecords, WhatIsNotReadIsCalledByItsName) {
  const std::string spectra =
      "Response and Fourier amplitude spectra (78 periods,  .04 -  6.0 sec)   for\n" + test::paper_line_of("1 2 3", 20);
  expect_refused(spectra, {}, ":1:1: error: a file of spectra (volume 3), but ground accelerations are needed");
  for (const char* const format : {"geonet", "bhrc", "afad", "asa", "knet-csv", "csmip"}) {
    RecordOptions named;
    named.format = format;
    EXPECT_FALSE(read("0.00 0.5\n0.02 0.25\n0.04 0.1\n0.06 0.2\n0.08 1\n", named).has_value()) << format;
    EXPECT_FALSE(messages().empty());
  }
}

// OpenSees' and SimCenter's habit, and what spreadsheets of other countries make of an AT2.
TEST_F(NetworkRecords, At2InOtherWords) {
  const std::string text =
      "El Centro\n4 points at equal spacing of 0.02 sec\nThe units are (g)\nNPTS=  4, DT= .02000 SEC\n  .1 -.2 .3\n "
      ".05\n";
  expect_read(text, {}, "peer-at2", "g", 0.02, {0.1, -0.2, 0.3, 0.05}, 1e-12);
  expect_refused(with(text, "(g)", "(cm/s2)"), {},
                 ":3:16: error: units of \"cm/s2\", but a peer-at2 file must be in g: in others it is read with "
                 "excitation.format = \"values\"");
  RecordOptions values;
  values.format = "values";
  expect_read(with(text, "(g)", "(cm/s2)"), values, "values", "cm/s2", 0.02, {0.1, -0.2, 0.3, 0.05}, 1e-12);
  expect_refused(
      with(text, "The units are (g)", "Acceleration"), {},
      "line 3 of a peer-at2 file must say \"... IN UNITS OF G\": where it does not, give excitation.format = "
      "\"values\" and excitation.unit");
  // With no word of what it holds it is read by its heading, as any other file.
  RecordOptions unit;
  unit.unit = "g";
  expect_read(with(text, "The units are (g)", "No word of it"), unit, "values", "", 0.02, {0.1, -0.2, 0.3, 0.05},
              1e-12);
  const std::string commas =
      "PEER\nx\nACCELERATION IN UNITS OF G\nNPTS=   4, DT=   ,02000 SEC\n  0,1  -,2E0 0,3\n 0,05\n";
  expect_read(commas, {}, "peer-at2", "g", 0.02, {0.1, -0.2, 0.3, 0.05}, 1e-12);
}

}  // namespace
}  // namespace bentur
