// Random headings above random records: what they say is read, and where they contradict the numbers or the user, never
// without a word. A thousand of each a gate; BENTUR_RANDOM_HEADINGS=FIRST:COUNT runs others.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "bentur/core/units.h"
#include "bentur/io/records/record_files.h"
#include "tests/support/random_numbers.h"
#include "tests/support/record_file.h"

namespace bentur {
namespace {

using Words = std::vector<std::string>;

/// Draws from a seed what a file may be like.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  std::size_t below(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(engine_); }
  bool once_in(std::size_t count) { return below(count) == 0; }
  double between(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
  template <class List>
  const auto& of(const List& list) {
    return list[below(list.size())];
  }

 private:
  std::mt19937 engine_;
};

/// A unit, and what headings write for it.
struct SpelledUnit {
  std::string name;
  Words spellings;
};
const std::vector<SpelledUnit> spelled_units = {{"g", {"g", "G"}},
                                                {"m/s2", {"m/s2", "m/s/s", "m/s^2", "m/sec2", "m/s\u00B2"}},
                                                {"cm/s2", {"cm/s2", "gal", "Gal (cm/s/s)", "cm/sec/sec", "cm/s^2"}},
                                                {"mm/s2", {"mm/s2", "mm/s/s"}},
                                                {"in/s2", {"in/s2", "in/sec2"}},
                                                {"ft/s2", {"ft/s/s", "ft/s2"}}};

// {} stands for the number, or the unit.
const Words step_lines = {"SAMPLING INTERVAL (sec) : {}",
                          "DT= {} SEC",
                          "Time step: {} s",
                          "dt = {}",
                          "Time Increment (s)            : {}",
                          "INTERVALO DE MUESTREO, C1-C6 (s)       : /{}",
                          "\u00D6rnekleme aral\u0131\u011F\u0131 (sn): {}",
                          "Zaman ad\u0131m\u0131 = {}",
                          "\u6642\u9593\u9593\u9694(\u79D2): {}",
                          "a value every {} s",
                          "SAMPLING_INTERVAL_S: {}",
                          "Paso de tiempo: {} s",
                          "data at {} sec intervals",
                          "equally spaced at {} sec"};
const Words rate_lines = {"Sampling Freq(Hz) {}Hz",
                          "SAMPLING RATE= {}Hz",
                          "Sample rate: {} samples/s",
                          "Frecuencia de muestreo (Hz): {}",
                          "\u00D6rnekleme frekans\u0131: {} Hz",
                          "\u30B5\u30F3\u30D7\u30EA\u30F3\u30B0\u5468\u6CE2\u6570: {} Hz",
                          "AT {} SAMPLES/SEC"};
const Words count_lines = {"NPTS= {}",
                           "NUMBER OF DATA : {}",
                           "No. of points = {}",
                           "{} data points",
                           "N\u00DAMERO DE MUESTRAS: {}",
                           "NUM. TOTAL DE MUESTRAS, C1-C6          : /{}",
                           "Veri say\u0131s\u0131: {}",
                           "\u30C7\u30FC\u30BF\u6570 {}",
                           "NDATA: {}",
                           "Number of samples {}"};
const Words unit_lines = {"Units: {}",
                          "UNIT = {}",
                          "The units are ({})",
                          "Acceleration time series in {}",
                          "UNIDADES DE LOS DATOS : {}",
                          "Birim: {}",
                          "\u5358\u4F4D {}",
                          "Acc. in units of {}",
                          "\u0130vme ({})",
                          "{}",
                          "[{}]",
                          "values in {}",
                          "Datos en {}",
                          "Aceleraci\u00F3n [{}]"};
const Words peak_lines = {"PGA = {} {}",
                          "Peak acceleration: {} {}",
                          "Max. Acc. ({1})   {0}",
                          "ACEL. MAX.({1}), C1-C6 : /{0}",
                          "En b\u00FCy\u00FCk ivme: {} {}",
                          "\u6700\u5927\u52A0\u901F\u5EA6 {} {}",
                          "RAW PGA VALUES ({1}) : {0}",
                          "Aceleraci\u00F3n m\u00E1xima = {} {}"};
const Words noise_lines = {"Station 117, El Centro",
                           "Kocaeli 17/08/1999",
                           "Recorder: SSA-2, s/n 245",
                           "COORDENADAS : 16.84 LAT. N",
                           "Magnitude 6.5 Mw, depth 19 km",
                           "Filter: 0.1-25 Hz, order 4",
                           "Copyright nobody",
                           "Peak velocity = 12.05 cm/s",
                           "---------------------",
                           "\u77F3\u5DFB\u5E02"};

/// What is wrong with a file, or with what is said of it.
enum class Wrong {
  nothing,
  users_step,
  users_unit,
  count,
  peak,
  times,
  two_steps,
  two_units,
  column,
  component,
  COUNT
};

struct Drawn {
  std::string text;
  RecordOptions options;
  std::vector<double> values;
  double step = 0;
  std::string unit;
};

std::string filled(const std::string& line, const std::string& one, const std::string& two = {}) {
  return fmt::format(fmt::runtime(line), one, two);
}

const SpelledUnit& other_unit(const SpelledUnit& unit, Dice& dice) {
  const SpelledUnit* other = &unit;
  while (other == &unit) other = &dice.of(spelled_units);
  return *other;
}

/// A heading with a fact at some line of it, rows below, and options as a user gives them, one of them wrong.
Drawn drawn(unsigned seed, Wrong wrong) {
  Dice dice(seed);
  Drawn made;
  const SpelledUnit& unit = dice.of(spelled_units);
  const std::vector<double> steps = {0.002, 0.004, 0.005, 0.01, 0.02};
  made.unit = unit.name;
  made.step = dice.of(steps);
  const double other_step = made.step * dice.of(std::vector<double>{0.5, 2, 1.1, 100, 0.001});
  const std::size_t count = 7 + 2 * dice.below(40);
  const double scale = 0.3 * 9.80665 / acceleration_factor(unit.name, {"m", "N", 9.80665});
  for (std::size_t i = 0; i < count; ++i) made.values.push_back(std::round(dice.between(-1e4, 1e4)) / 1e4 * scale);
  double peak = 0;
  for (double& value : made.values) {
    value = std::stod(fmt::format("{:.6g}", value));
    peak = std::max(peak, std::abs(value));
  }

  // Times decide between two steps of a heading.
  const bool timed = wrong == Wrong::times || wrong == Wrong::column || (wrong != Wrong::two_steps && dice.once_in(2));
  const bool says_step =
      wrong == Wrong::users_step || wrong == Wrong::times || wrong == Wrong::two_steps || dice.once_in(2);
  const bool says_unit = wrong == Wrong::users_unit || wrong == Wrong::two_units || dice.once_in(2);
  Words lines;
  const auto step_line = [&](double step) {
    return dice.once_in(3) ? filled(dice.of(rate_lines), fmt::format("{:.6g}", 1 / step))
                           : filled(dice.of(step_lines), fmt::format("{:.6g}", step));
  };
  const auto unit_line = [&](const SpelledUnit& one) { return filled(dice.of(unit_lines), dice.of(one.spellings)); };
  if (says_step) lines.push_back(step_line(wrong == Wrong::times ? other_step : made.step));
  if (wrong == Wrong::two_steps) lines.push_back(step_line(other_step));
  if (says_unit) lines.push_back(unit_line(unit));
  if (wrong == Wrong::two_units) lines.push_back(unit_line(other_unit(unit, dice)));
  if (wrong == Wrong::count || dice.once_in(2)) {
    const std::size_t said =
        wrong == Wrong::count ? count + dice.of(std::vector<std::size_t>{1, 2, 100, count}) : count;
    lines.push_back(filled(dice.of(count_lines), std::to_string(said)));
  }
  if (wrong == Wrong::peak || dice.once_in(2)) {
    const double factor = wrong == Wrong::peak ? dice.of(std::vector<double>{0.1, 0.5, 1.2, 10, 980.665}) : 1;
    lines.push_back(filled(dice.of(peak_lines), fmt::format("{:#.4g}", peak * factor), dice.of(unit.spellings)));
  }
  std::shuffle(lines.begin(), lines.end(), std::mt19937(seed));
  Words head;
  for (const std::string& line : lines) {
    if (dice.once_in(2)) head.push_back(dice.of(noise_lines));
    head.push_back(line);
  }
  const std::string mark = dice.once_in(3) ? "# " : "";
  const std::string separator = dice.of(Words{" ", "\t", ",", ";", "  "});
  const bool labelled = wrong == Wrong::column || wrong == Wrong::component || dice.once_in(3);
  const std::string between = separator.front() == ' ' ? "  " : separator;
  if (labelled) head.push_back(timed ? "Time (s)" + between + "N-S" + between + "E-W" : "N-S" + between + "E-W");
  for (const std::string& line : head) made.text += mark + line + (dice.once_in(9) ? "\r\n" : "\n");
  for (std::size_t i = 0; i < count; ++i) {
    if (timed) made.text += fmt::format("{:.6g}{}", made.step * static_cast<double>(i), separator);
    made.text += fmt::format("{:.6g}", made.values[i]);
    if (labelled) made.text += fmt::format("{}{:.6g}", separator, 0.5 * made.values[count - 1 - i]);
    made.text += "\n";
  }

  // What the user says: what the file does not, and at times what it does.
  if ((!says_step && !timed) || dice.once_in(3)) made.options.time_step = made.step;
  if (!says_unit || dice.once_in(3)) made.options.unit = unit.name;
  if (labelled) made.options.component = dice.of(Words{"N-S", "NS", "north", "N00E"});
  if (wrong == Wrong::users_step) made.options.time_step = other_step;
  if (wrong == Wrong::users_unit) made.options.unit = other_unit(unit, dice).name;
  if (wrong == Wrong::two_steps) made.options.time_step.reset();
  if (wrong == Wrong::two_units) made.options.unit.clear();
  if (wrong == Wrong::column) made.options.column = timed ? 3 : 2;
  if (wrong == Wrong::component) made.options.component = dice.of(Words{"Up", "U-D", "S16W", "HNZ"});
  return made;
}

class RandomHeadings : public test::RecordFile {
 protected:
  static std::pair<unsigned, unsigned> seeds() {
    const auto [first, count] = test::seeds_of("BENTUR_RANDOM_HEADINGS", {1, 1000}, {1, 1000});
    return {first, first + count};
  }
};

TEST_F(RandomHeadings, AreReadForWhatTheySay) {
  const auto [first, end] = seeds();
  for (unsigned seed = first; seed < end; ++seed) {
    const Drawn file = drawn(seed, Wrong::nothing);
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, file.text.substr(0, 900)));
    const auto record = read(file.text, file.options);
    ASSERT_TRUE(record.has_value()) << messages();
    EXPECT_TRUE(contradictions(*record, file.options).empty());
    ASSERT_EQ(record->values.size(), file.values.size());
    for (std::size_t i = 0; i < file.values.size(); ++i) ASSERT_DOUBLE_EQ(record->values[i], file.values[i]);
    ASSERT_NEAR(record->time_step, file.step, 1e-5 * file.step);
    ASSERT_EQ(record->unit.empty() ? file.options.unit : record->unit, file.unit);
  }
}

TEST_F(RandomHeadings, ThatContradictAreNeverReadWithoutAWord) {
  const auto [first, end] = seeds();
  for (unsigned seed = first; seed < end; ++seed) {
    const auto wrong = static_cast<Wrong>(1 + seed % (static_cast<unsigned>(Wrong::COUNT) - 1));
    const Drawn file = drawn(seed, wrong);
    const auto record = read(file.text, file.options);
    const bool told = !record || !contradictions(*record, file.options).empty();
    ASSERT_TRUE(told) << fmt::format("seed {}, wrong {}: read as {} every {} s\n{}", seed, static_cast<int>(wrong),
                                     record->unit, record->time_step, file.text.substr(0, 900));
    if (record) continue;
    // The message is of the contradiction: both values.
    const char* const of = wrong == Wrong::column      ? "is column"
                           : wrong == Wrong::component ? "has no component"
                                                       : "says";
    ASSERT_NE(messages().find(of), std::string::npos) << "seed " << seed << "\n"
                                                      << messages() << file.text.substr(0, 900);
  }
}

}  // namespace
}  // namespace bentur
