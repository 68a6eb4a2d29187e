#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The words that headings of records use, of all formats and languages in one table.
namespace bentur::records {

/// What a word of a heading speaks of.
enum class Fact {
  step,  ///< time from value to value
  rate,  ///< values a second
  count,
  unit,
  peak,  ///< of accelerations
  component,
  acceleration,
  velocity,
  displacement,
  time,
  index,  ///< the number of a row
  other   ///< what could be taken for one of these, as the time of a peak
};

/// Words of the table in a line.
struct HeadingPhrase {
  Fact fact = Fact::other;
  std::size_t begin = 0, end = 0;  ///< in the line
  bool number_before = false;      ///< as in "4000 POINTS"
  bool needs_unit = false;         ///< only a number with a unit is meant, as in "EVERY 0.01 S", "MAX = 0.3 G"
};

/// The letter of ASCII that a letter with an accent, a dot or a cedilla comes from, as capital; 0 for other characters.
[[nodiscard]] char base_letter(char32_t character);

/// A line as the table has its words: capitals, without accents; UTF-8, or Latin letters of one byte (Western,
/// Turkish).
[[nodiscard]] std::string folded(std::string_view text);

/// The words of the table that stand in a folded line, from left to right; where several begin the longest.
[[nodiscard]] std::vector<HeadingPhrase> phrases_of(std::string_view text);

/// What a column is whose heading is this, folded and without its unit; nothing for other words.
[[nodiscard]] std::optional<Fact> fact_of_label(std::string_view label);

/// Seconds of a unit of time [s], as in "MSEC"; nothing for other words. @param word folded
[[nodiscard]] std::optional<double> seconds_of(std::string_view word);

/// Whether a word is a unit of samples by time, as "HZ". @param word folded
[[nodiscard]] bool is_rate_unit(std::string_view word);

/// Whether a word is a unit that records have, but of no accelerations: "CM/S", "COUNTS". @param word folded
[[nodiscard]] bool is_other_unit(std::string_view word);

}  // namespace bentur::records
