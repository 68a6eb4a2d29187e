#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "bentur/io/records/internal/record_text.h"

// Numbers as files have them beside plain ones: fields that touch, and times of the day.
namespace bentur::records {

/// The numbers of a cell in which fields of Fortran touch: a sign behind a digit begins the next ("1.5E-02-3.1E-02"),
/// but for that of an exponent, and so does what follows the decimals that all have, three or more ("12.00010.000").
/// Empty where the cell is not made of two or more such numbers, each with a point; 2024-01-15 is not.
[[nodiscard]] std::vector<Token> touching_numbers(const Token& cell);

/// The day and the time of the day of "2024-01-15T03:02:01.25", "2024/01/15 03:02:01,25 Z" or "03:02:01.25".
struct TimeStamp {
  long day = 0;        ///< from some day on; 0 where none is said
  double seconds = 0;  ///< of the day [s]

  /// [s]
  [[nodiscard]] double since(const TimeStamp& first) const {
    return 86400.0 * static_cast<double>(day - first.day) + (seconds - first.seconds);
  }
};
[[nodiscard]] std::optional<TimeStamp> time_stamp(std::string_view text);

}  // namespace bentur::records
