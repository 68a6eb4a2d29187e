// What headings say, piece by piece: words, numbers, units, names of columns and components, times of the day.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bentur/io/records/internal/components.h"
#include "bentur/io/records/internal/heading.h"
#include "bentur/io/records/internal/number_cells.h"
#include "bentur/io/records/record_files.h"
#include "tests/support/record_file.h"

namespace bentur::records {
namespace {

/// What one line says; `below` is the next.
Heading said_by(const std::string& text, const std::string& below = {}) {
  std::vector<Line> lines = {{text, 1}};
  if (!below.empty()) lines.push_back({below, 2});
  return read_heading(lines);
}

TEST(HeadingWords, LettersLoseTheirAccents) {
  EXPECT_EQ(folded("\u00D6rnekleme aral\u0131\u011F\u0131"), "ORNEKLEME ARALIGI");
  EXPECT_EQ(folded("\xD6rnekleme aral\xFD\xF0\xFD"),
            "ORNEKLEME ARALIGI");  // one byte a letter, as Turkish files have it
  EXPECT_EQ(folded("N\u00FAmero, m/s\u00B2\uFF08gal\uFF09"), "NUMERO, M/S2(GAL)");
  EXPECT_EQ(folded("\u52A0\u901F\u5EA6"), "\u52A0\u901F\u5EA6");
  EXPECT_EQ(folded("\xFF\x80 \xE5"), "Y? A");
}

TEST(HeadingWords, TheLongestWordsCount) {
  const auto facts = [](const std::string& text) {
    std::vector<Fact> found;
    for (const HeadingPhrase& phrase : phrases_of(text)) found.push_back(phrase.fact);
    return found;
  };
  EXPECT_EQ(facts("PEAK GROUND ACCELERATION"), (std::vector{Fact::peak}));
  EXPECT_EQ(facts("TIME_PGA_S: 1.2, PGA_CM/S^2: 3"), (std::vector{Fact::other, Fact::peak}));
  EXPECT_EQ(facts("VEL. DE MUESTREO"), (std::vector{Fact::rate}));
  EXPECT_EQ(facts("UNCOR MAX = .079 G"), (std::vector{Fact::other}));
  EXPECT_EQ(facts("ACCELEROMETER UNITED DTX"), std::vector<Fact>());              // parts of other words
  EXPECT_EQ(facts("\u6700\u5927\u52A0\u901F\u5EA6"), (std::vector{Fact::peak}));  // not its 加速度, nor 速度 in that
}

TEST(Headings, NumbersWithCommas) {
  const auto number = [](const std::string& text, bool counts) {
    std::size_t size = 0;
    const auto value = heading_number(text, counts, size);
    return std::pair(value.value_or(-1), size);
  };
  EXPECT_EQ(number("0,005 s", false), std::pair(0.005, std::size_t{5}));
  EXPECT_EQ(number(",005", false), std::pair(0.005, std::size_t{4}));
  EXPECT_EQ(number("12,000 points", true), std::pair(12000.0, std::size_t{6}));
  EXPECT_EQ(number("4000,0.02", true), std::pair(4000.0, std::size_t{4}));
  EXPECT_EQ(number("4000,0.02", false), std::pair(4000.0, std::size_t{4}));
  EXPECT_EQ(number("1.5E-02-3", false), std::pair(0.015, std::size_t{7}));
  EXPECT_EQ(number("-.5D+01", false), std::pair(-5.0, std::size_t{7}));
  EXPECT_EQ(number("100Hz", false), std::pair(100.0, std::size_t{3}));
  EXPECT_EQ(number("9.", false), std::pair(9.0, std::size_t{2}));
  for (const char* const none : {"", ".", "-", "E5", "Hz", "+-3"}) EXPECT_EQ(number(none, false).second, 0U) << none;
}

TEST(Headings, StepsAndRates) {
  for (const auto& [text, step] : std::vector<std::pair<std::string, double>>{
           {"SAMPLING INTERVAL (sec) : 0.01", 0.01},
           {"Time step: 5 ms", 0.005},
           {"INTERVALO DE MUESTREO, C1-C6, (s)      : /0.005/0.005/0.005", 0.005},
           {"\u00D6rnekleme aral\u0131\u011F\u0131 (sn): 0,005", 0.005},
           {"Raw readings in units of 1.00 mm/s/s  at intervals of 0.005 s", 0.005},
           {"Instrument corrected data at 0.020 sec intervals", 0.02},
           {"400 points at equal spacing of 0.02 sec", 0.02},
           {"NO. OF POINTS =  12001  RECORD LENGTH = 60.000 SEC   AT 200 SAMPLES/SEC", 0.005},
           {"Sampling Freq(Hz) 100Hz", 0.01},
           {"#SampleRate(Hz): 50", 0.02},
           {"SAMPLING RATE= 100", 0.01},
           {"Sampling rate: 0.005", 0.005},
           {"one value every 0.01 s", 0.01}}) {
    const Heading heading = said_by(text);
    ASSERT_FALSE(heading.steps.empty()) << text;
    EXPECT_NEAR(heading.steps[0].value, step, 1e-12) << text;
    EXPECT_FALSE(heading.steps[0].vague) << text;
    EXPECT_EQ(heading.steps[0].line, 1) << text;
  }
  EXPECT_NEAR(said_by("#SamplingFrequency(Hz)", "#100").steps.at(0).value, 0.01, 1e-12);  // in the line below
  EXPECT_EQ(said_by("VEL. DE MUESTREO, C1-C6 (muestras/s)   : /200/200/250").steps.at(2).place, 2U);
  EXPECT_TRUE(said_by("DT = 10").steps.at(0).vague);  // seconds, or milliseconds
  for (const char* const none :
       {"every 10 lines", "DT: see below", "INTERVALO DE MUESTREO, C7-C12 (s) : ", "step 3", "2010 04 01 DTM"}) {
    EXPECT_TRUE(said_by(none).steps.empty()) << none;
  }
}

TEST(Headings, CountsUnitsAndPeaks) {
  EXPECT_EQ(said_by("Number of points  5800    Duration 115.98 sec").counts.at(0).value, 5800);
  EXPECT_EQ(said_by(" 12000 points of corrected data").counts.at(0).value, 12000);
  EXPECT_TRUE(said_by("AT 200 SAMPLES/SEC").counts.empty());
  EXPECT_TRUE(said_by("filter points: 2").counts.empty());
  const auto unit = [](const std::string& text) {
    const Heading heading = said_by(text);
    return heading.units.empty() ? std::string() : heading.units[0].unit;
  };
  EXPECT_EQ(unit("The units are (g)"), "g");
  EXPECT_EQ(unit("UNIDADES DE LOS DATOS                  : Gal (cm/s/s)"), "cm/s2");
  EXPECT_EQ(unit(" UNIT  = gal(cm/s/s)"), "cm/s2");
  EXPECT_EQ(unit("Accelaration time series in m/s/s"), "m/s2");
  EXPECT_EQ(unit("UNITS OF UNCOR ACCEL ARE SEC AND G/10."), "g");
  EXPECT_EQ(said_by("UNITS OF UNCOR ACCEL ARE SEC AND G/10.").units.at(0).factor, 0.1);
  EXPECT_EQ(unit("RAW PGA VALUES (gal)    : (N-S) 13.2"), "");  // of the peak alone
  EXPECT_EQ(unit("Gravity g = 9.81, units: SI"), "");
  EXPECT_EQ(unit("Unit 5, block G"), "");
  EXPECT_EQ(unit("UNIT: G"), "g");
  EXPECT_EQ(unit("units of time and acceleration are s and g"), "g");
  EXPECT_EQ(said_by("Units: cm/s").other_units.at(0).text, "CM/S");
  const Heading peaks = said_by("RAW PGA VALUES (gal)    : (N-S) 13.200332 (E-W) 12.163827 (U-D) 9.840572");
  ASSERT_EQ(peaks.peaks.size(), 3U);
  EXPECT_EQ(peaks.peaks[1].value, 12.163827);
  EXPECT_EQ(peaks.peaks[1].unit, "cm/s2");
  EXPECT_EQ(peaks.peaks[1].place, 1U);
  EXPECT_EQ(peaks.peaks[1].of, 3U);
  EXPECT_EQ(said_by("Acceleration:  peak    -41.6 mm/s/s at  43.68 sec").peaks.at(0).value, 41.6);
  EXPECT_EQ(said_by("PGA_CM/S^2: -12.345").peaks.at(0).unit, "cm/s2");
  EXPECT_EQ(said_by("MAX  =  -.055 G, AT  15.992 SEC.").peaks.at(0).value, 0.055);
  for (const char* const none : {"Velocity:      peak     1.65 mm/s", "MAX = 5 of 7", "Peak velocity = 3.15 cm/sec",
                                 "ACEL. MAX., C1-C6, EN LA MUESTRA       : /10692/16112/16295", "TIME_PGA_S: 12.3"}) {
    EXPECT_TRUE(said_by(none).peaks.empty()) << none;
  }
}

TEST(Components, OneDirectionHasManyNames) {
  for (const auto& [one, other] : std::vector<std::pair<std::string, std::string>>{{"N-S", "NS"},
                                                                                   {"N-S", "Chan 1: 360 Deg"},
                                                                                   {"n-s", "N00E;+"},
                                                                                   {"North", "HNN"},
                                                                                   {"E-W", "N90E"},
                                                                                   {"E-W", "COMP 90 DEG"},
                                                                                   {"Do\u011Fu", "este"},
                                                                                   {"Up", "U-D"},
                                                                                   {"V", "U(+)"},
                                                                                   {"L", "l"},
                                                                                   {"S16W", "196"},
                                                                                   {"Acc X (g)", "x"},
                                                                                   {"N-S (cm/s2)", "north"}}) {
    EXPECT_TRUE(same_component(one, other)) << one << ", " << other;
  }
  for (const auto& [one, other] : std::vector<std::pair<std::string, std::string>>{
           {"N-S", "E-W"}, {"N-S", "180"}, {"Up", "N"}, {"L", "T"}, {"N10E", "N10W"}, {"N10E", "N100E"}, {"", ""}}) {
    EXPECT_FALSE(same_component(one, other)) << one << ", " << other;
  }
}

TEST(NumberCells, FieldsOfFortranThatTouch) {
  const auto pieces = [](const std::string& text) {
    std::vector<std::string> found;
    for (const Token& piece : touching_numbers({text, 3, 5})) {
      found.emplace_back(piece.text);
      EXPECT_EQ(text.substr(static_cast<std::size_t>(piece.column) - 5, piece.text.size()), piece.text);
    }
    return found;
  };
  using Pieces = std::vector<std::string>;
  EXPECT_EQ(pieces("4.1580662E-02-5.8374143E-02-1.1E+00"), (Pieces{"4.1580662E-02", "-5.8374143E-02", "-1.1E+00"}));
  EXPECT_EQ(pieces("-.5-.25+.125"), (Pieces{"-.5", "-.25", "+.125"}));
  EXPECT_EQ(pieces("0.338100.005"), (Pieces{"0.338", "100.005"}));
  EXPECT_EQ(pieces("-1.0000002.000000-3.500000"), (Pieces{"-1.000000", "2.000000", "-3.500000"}));
  EXPECT_EQ(pieces("1.-2."), (Pieces{"1.", "-2."}));
  for (const char* const none :
       {"1.5E-02", "2024-01-15", "1.5", "1.5.2", "12.30.45", "1-2", "1.5-x", "-", "1.5-", "--1.", "1.23456E-10.500"}) {
    EXPECT_EQ(pieces(none), Pieces()) << none;
  }
}

TEST(NumberCells, TimesOfTheDay) {
  const auto seconds = [](const std::string& text) {
    const TimeStamp zero = time_stamp("2024-02-28 23:59:59").value();
    const auto stamp = time_stamp(text);
    return stamp ? stamp->since(zero) : std::nan("");
  };
  EXPECT_EQ(seconds("2024-02-29 00:00:00.5"), 1.5);
  EXPECT_EQ(seconds("2024/03/01T00:00:00,25Z"), 86400 + 1.25);  // of a leap year
  EXPECT_EQ(seconds("2025-02-28 23:59:59+09:00"), 366 * 86400.0);
  EXPECT_EQ(time_stamp("03:02:01.25")->seconds, 3 * 3600 + 2 * 60 + 1.25);
  for (const char* const none : {"", "2024-02-29", "2024-13-01 00:00:00", "2024-02-32 00:00:00", "24:00:00", "01:60:00",
                                 "01:02", "01:02:61", "1:02:03", "01:02:-3", "2024-02-29x00:00:00"}) {
    EXPECT_FALSE(time_stamp(none)) << none;
  }
}

using UnderstoodColumns = test::RecordFile;
using Values = std::vector<double>;

TEST_F(UnderstoodColumns, ByTheirHeadings) {
  const std::string rows = "0;1.5;9\n10;-2.5;8\n20;0.5;7\n";
  const auto record = read("Time (ms);Acc (cm/s2);Vel (cm/s)\n" + rows);
  ASSERT_TRUE(record.has_value()) << messages();
  EXPECT_EQ(record->values, (Values{1.5, -2.5, 0.5}));  // the only accelerations
  EXPECT_DOUBLE_EQ(record->time_step, 0.01);
  EXPECT_EQ(record->unit, "cm/s2");
  EXPECT_EQ(record->unit_line, 1);
  EXPECT_EQ(record->channel, "column 2 of 3 (Acc (cm/s2))");
  RecordOptions velocity;
  velocity.column = 3;
  EXPECT_FALSE(read("Time (ms);Acc (cm/s2);Vel (cm/s)\n" + rows, velocity).has_value());
  EXPECT_EQ(messages(), ":1:23: error: heads the column \"Vel (cm/s)\", but ground accelerations are needed\n");
  EXPECT_FALSE(read("Time (ms);Acc X (cm/s2);Acc Y (g)\n" + rows).has_value());
  EXPECT_EQ(
      messages(),
      ": error: has 3 columns, time and 2 more: say in excitation.column (2 to 3) or excitation.component which one "
      "holds the accelerations: 2 \"Acc X (cm/s2)\", 3 \"Acc Y (g)\"\n");
  RecordOptions other;
  other.column = 3;
  EXPECT_EQ(read("Time (ms);Acc X (cm/s2);Acc Y (g)\n" + rows, other)->unit, "g");  // each has its own
  EXPECT_FALSE(read("t;a [cm/s]\n0;1\n1;2\n").has_value());
  // Against the user.
  RecordOptions in_g;
  in_g.unit = "g";
  const auto otherwise = contradictions(read("t;Acc (cm/s2)\n0;94\n0.01;2\n", in_g).value(), in_g);
  ASSERT_EQ(otherwise.size(), 1U);
  EXPECT_EQ(otherwise[0].said, "\"cm/s2\" in line 1");
}

// Names of columns above, their units below.
TEST_F(UnderstoodColumns, UnitsMayStandInALineOfTheirOwn) {
  const std::string rows = "0,1.5,9\n0.01,-2.5,8\n0.02,0.5,7\n";
  for (const std::string units :
       {"s,cm/s2,cm/s\n", "(sec),(gal),(cm/s)\n", "# s;Gal;cm/s\n", "[s]  [cm/s^2]  [cm/s]\n"}) {
    const auto record = read("Time,Acc,Vel\n" + units + rows);
    ASSERT_TRUE(record.has_value()) << messages();
    EXPECT_EQ(record->unit, "cm/s2");
    EXPECT_EQ(record->unit_line, 2);
    EXPECT_EQ(record->channel, "column 2 of 3 (Acc)");  // the only accelerations
  }
  EXPECT_EQ(read("ms,gal,gal\n0,1.5,9\n10,-2.5,8\n", {.column = 2})->time_step, 0.01);
  EXPECT_EQ(read("t,N-S,E-W\ns,gal,gal\n" + rows, {.component = "E-W"})->values, (Values{9, 8, 7}));
  EXPECT_EQ(read("t,N,V\n0,1.5,9\n0.01,-2.5,8\n", {.component = "V"})->values, (Values{9, 8}));  // no volts
  for (const std::string head :
       {"# Gal\n", "[cm/s^2]\n", "values in gal\n", "data in Gal, of a station\n", "3 points in cm/s/s\n",
        "t,accel (in gal)\n", "t,a_cms2\n", "registro (gales)\n(gales)\n"}) {
    const auto record = read(head + "0,94\n0.01,2\n0.02,7\n");
    ASSERT_TRUE(record.has_value()) << head << messages();
    EXPECT_EQ(record->unit, "cm/s2") << head;
    EXPECT_EQ(contradictions(*record, {.unit = "g"}).size(), 1U) << head;
  }
  EXPECT_TRUE(read("block G\nof 3 rows\n0 1\n0.01 2\n")->unit.empty());
  // In prose one is too little to go by, and enough to hold another one against.
  const RecordOptions in_g{.unit = "g"}, in_gal{.unit = "cm/s2"};
  const std::string prose = "El Centro NS component gal dt 0.01\n0 1\n0.01 2\n";
  EXPECT_TRUE(read(prose)->unit.empty());
  EXPECT_TRUE(read(prose, in_gal)->unit.empty());
  EXPECT_EQ(contradictions(read(prose, in_g).value(), in_g).at(0).said, "\"cm/s2\" in line 1");
  for (const std::string head : {"sensor of 2000 gal\n", "from gal to g\n", "RMS velocity 3 (gal)\n"}) {
    EXPECT_TRUE(contradictions(read(head + "0 1\n0.01 2\n", in_g).value(), in_g).empty()) << head;
  }
  EXPECT_EQ(read("Fs = 200 Hz\n.1\n.2\n")->time_step, 0.005);
  EXPECT_FALSE(read("Station FS 200\n.1\n.2\n").has_value());
}

// pandas writes the number of each row before it.
TEST_F(UnderstoodColumns, RowNumbersAreNoTimes) {
  std::string many;
  for (int i = 0; i < 12; ++i) many += fmt::format("{},{},{}\n", i, 0.01 * i, 0.1 * (i % 4));
  for (const std::string text : {",t,a\n0,0.00,0.1\n1,0.01,0.2\n2,0.02,0.3\n", "index,t,a\n0,0.00,0.1\n1,0.01,0.2\n"}) {
    const auto record = read(text);
    ASSERT_TRUE(record.has_value()) << messages();
    EXPECT_NEAR(record->time_step, 0.01, 1e-12);
    EXPECT_EQ(record->values[1], 0.2);
  }
  const auto unnamed = read(many);  // beside times that go forward evenly
  ASSERT_TRUE(unnamed.has_value()) << messages();
  EXPECT_NEAR(unnamed->time_step, 0.01, 1e-12);
  EXPECT_EQ(unnamed->values.size(), 12U);
  RecordOptions column;
  column.column = 2;
  EXPECT_FALSE(read(many, column).has_value());
  EXPECT_EQ(messages(), ": error: has accelerations from column 3 to 3, excitation.column = 2 is not one of them\n");
  // No times beside them: the step is to be said, and where the heading says it they are no times at all.
  EXPECT_FALSE(read(",a\n0,0.1\n1,0.2\n").has_value());
  EXPECT_NE(messages().find("give excitation.time_step"), std::string::npos) << messages();
  const auto stepped = read("DT = 0.01 s\n1 0.1\n2 0.2\n3 0.3\n");
  ASSERT_TRUE(stepped.has_value()) << messages();
  EXPECT_EQ(stepped->values, (Values{0.1, 0.2, 0.3}));
  EXPECT_EQ(stepped->time_step, 0.01);
  EXPECT_EQ(read("0 0.1\n1 0.2\n2 0.3\n")->time_step, 1);  // seconds, and remarked on
}

TEST_F(UnderstoodColumns, TimesOfTheDay) {
  for (const std::string text :
       {"time,a\n2024-01-01 23:59:59.99,0.1\n2024-01-02 00:00:00.00,0.2\n2024-01-02T00:00:00.01Z,0.3\n",
        "2024/01/01 00:00:15.00  0.1\n2024/01/01 00:00:15.01  0.2\n2024/01/01 00:00:15.02  0.3\n",
        ",time,a\n0,00:00:15.00,0.1\n1,00:00:15.01,0.2\n2,00:00:15.02,0.3\n",
        "t;a\n2024-01-01 00:00:15,00;0,1\n2024-01-01 00:00:15,01;0,2\n2024-01-01 00:00:15,02;0,3\n"}) {
    SCOPED_TRACE(text);
    const auto record = read(text);
    ASSERT_TRUE(record.has_value()) << messages();
    EXPECT_EQ(record->values, (Values{0.1, 0.2, 0.3}));
    EXPECT_NEAR(record->time_step, 0.01, 1e-9);
  }
  EXPECT_FALSE(read("00:00:15.00,1\n00:00:15.01,2\n0.03,3\n00:00:15.03,4\n").has_value());
  EXPECT_EQ(messages().substr(0, 59), ":3:1: error: \"0.03\" is no time of the day, as the first row");
}

TEST_F(UnderstoodColumns, TheFirstRowThatCouldNotBeReadIsNamed) {
  EXPECT_FALSE(read("# of a station\ntime,a,b\n01.01.2024 15:00,0.1,0.2\n01.01.2024 15:01,0.2,0.2\n").has_value());
  EXPECT_EQ(messages(), ":3:1: error: \"01.01.2024 15:00\" is not a number, and no line holds nothing but numbers\n");
  EXPECT_FALSE(read(" , ,\nof nothing\n").has_value());
  EXPECT_EQ(messages(), ": error: holds no numbers\n");
  EXPECT_FALSE(read("t,a\n0.00s,0.1g\n0.01s,0.2g\n").has_value());
  EXPECT_EQ(messages(), ":2:1: error: \"0.00s\" is not a number, and no line holds nothing but numbers\n");
}

TEST_F(UnderstoodColumns, WhatIsSaidTwiceAndDifferentlyTheUserSays) {
  const std::string text = "Raw data at 0.005 sec intervals\nProcessed data at 0.02 sec intervals\n.1\n.2\n.3\n";
  EXPECT_FALSE(read(text).has_value());
  EXPECT_EQ(messages(),
            ":2:19: error: says 0.02 s from value to value, but line 1 says 0.005 s: give excitation.time_step\n");
  RecordOptions options;
  options.time_step = 0.02;
  EXPECT_EQ(read(text, options)->time_step, 0.02);
  EXPECT_EQ(read(text, options)->step_line, 2);
  options.time_step = 0.01;
  EXPECT_EQ(contradictions(read(text, options).value(), options).at(0).said, "0.005 s in line 1");
  EXPECT_FALSE(read("Units: g\nAcceleration in cm/s2\n0 .1\n1 .2\n").has_value());
  EXPECT_EQ(messages(), ":2:17: error: says cm/s2, but line 1 says g: give excitation.unit\n");
  RecordOptions unit;
  unit.unit = "cm/s2";
  EXPECT_EQ(read("Units: g\nAcceleration in cm/s2\n0 .1\n1 .2\n", unit)->unit, "cm/s2");
  EXPECT_FALSE(read("Units: counts\n0 .1\n1 .2\n", unit).has_value());
  EXPECT_EQ(messages(), ":1:8: error: says \"COUNTS\", but ground accelerations are needed\n");
}

TEST_F(UnderstoodColumns, APeakStandsAgainstUnitAndValues) {
  const std::string text = "PGA = 0.35 g\n0 100\n0.01 -343.2\n0.02 7\n";
  RecordOptions options;
  options.unit = "cm/s2";
  EXPECT_TRUE(read(text, options).has_value()) << messages();
  EXPECT_TRUE(read(text).has_value()) << messages();  // some unit fits; the door asks for it
  options.unit = "g";
  EXPECT_FALSE(read(text, options).has_value());
  EXPECT_EQ(messages(),
            ":1:7: error: says a peak of 0.35 g, but that of the values is 343.2 g (where the heading is of another "
            "record, give excitation.skip_lines = 1)\n");
  options.skip_lines = 1;
  EXPECT_TRUE(read(text, options).has_value()) << messages();
  // Without a unit any of them will do; to the digits that are stated.
  options = {};
  options.unit = "cm/s2";
  EXPECT_TRUE(read("Peak acceleration: 0.3\n0 100\n0.01 -343.2\n", options).has_value()) << messages();
  EXPECT_FALSE(read("Peak acceleration: 0.30\n0 100\n0.01 -343.2\n", options).has_value());
}

}  // namespace
}  // namespace bentur::records
