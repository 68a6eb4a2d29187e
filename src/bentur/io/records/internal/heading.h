#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/io/records/internal/heading_words.h"
#include "bentur/io/records/internal/record_text.h"

// What a heading says of the numbers below it. It is understood by the words of one table, and nothing in it is taken
// for more than that: what is said twice and differently is left to the user.
namespace bentur::records {

/// One thing that a heading says, and where.
struct Statement {
  double value = 0;          ///< [s] of a step, a number of values, of a peak in `unit`
  double resolution = 0;     ///< of the last digit of `value`
  std::string unit = {};     ///< of a unit or a peak, as acceleration_units(); empty: none is said
  double factor = 1;         ///< what brings numbers to that unit [-]
  std::string text = {};     ///< of a component
  int line = 0, column = 0;  ///< from 1
  std::size_t place = 0;     ///< from 0, in a list of one per channel
  std::size_t of = 1;        ///< how many that list has
  bool vague = false;        ///< a step without a unit that may also be milliseconds
};

struct Heading {
  std::vector<Statement> steps, counts, units, peaks, components;
  std::vector<Statement> other_units;  ///< that are none of accelerations, in `text`
  std::vector<Statement> mentions;     ///< units in prose: too little to go by, enough to hold another one against
};

/// What the lines say, each of them by itself, or by the number that is the line below.
[[nodiscard]] Heading read_heading(std::span<const Line> lines);

/// A number as people write it in headings: with a decimal comma, or one of thousands where it counts values.
/// @param size is set to the characters it takes, 0 where there is no number
[[nodiscard]] std::optional<double> heading_number(std::string_view text, bool counts, std::size_t& size);

/// The unit of accelerations that a text begins with, past blanks; nothing where it begins otherwise.
[[nodiscard]] std::optional<FileUnit> unit_at(std::string_view text);

/// What the heading of a column says of it.
struct ColumnLabel {
  std::string text = {};              ///< as it stands there
  std::optional<Fact> fact = {};      ///< acceleration, velocity, displacement, time, index
  std::optional<FileUnit> unit = {};  ///< of accelerations
  double seconds = 1;                 ///< of its unit of time [s]
  int line = 0, column = 0;
  int unit_line = 0;  ///< of the unit, where it stands below the names; else 0
};

/// The headings of columns, as many as there are: of the last line that has one for each. Empty where none has.
[[nodiscard]] std::vector<ColumnLabel> column_labels(std::span<const Line> lines, std::size_t columns, char separator);

/// Which of several channels was read, for peaks that stand in a list.
struct ChannelPlace {
  std::size_t place = 0, of = 1;
};

/// An error where the heading states peaks of these values and none is theirs, to 5 %: another unit, another scale, or
/// values that are missing. @param unit as acceleration_units(); empty: not known, then any will do
/// @param hint what to do where the heading is not of these values; may be empty
void check_peak(const Heading& heading, const std::vector<double>& values, const std::string& unit,
                ChannelPlace channel, const std::string& hint, RecordErrors& errors);

}  // namespace bentur::records
