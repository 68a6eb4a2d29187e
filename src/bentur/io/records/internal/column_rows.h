#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bentur/io/records/internal/heading.h"
#include "bentur/io/records/internal/record_text.h"

namespace bentur::records {

/// The rows of numbers of a text file, and how their columns are distinguished.
struct ColumnRows {
  std::vector<Line> rows;       ///< without comments and blank lines, from the first row on
  char separator = ' ';         ///< ; , or ' ' for blanks and tabs
  bool decimal_comma = false;   ///< 0,25 is a quarter
  int header_lines = 0;         ///< before the rows, neither blank nor comments
  std::vector<Line> head = {};  ///< all lines before the rows, comments too
  Heading heading = {};         ///< what those say, or a line of two numbers

  /// The columns of a row; quotes are taken off, fields of Fortran that touch are parted, a date and the time behind it
  /// are one. A blank one between two commas or semicolons stays, as an error to come; one at the end does not.
  [[nodiscard]] std::vector<Token> cells(const Line& row) const;
};

/// The cells of a line between any separator, blank ones too, but for one at the end. ' ': words between blanks.
[[nodiscard]] std::vector<Token> split_cells(const Line& line, char separator);

/// Finds the rows: header lines, any number, are what stands before the first three rows of numbers. A line among them
/// that looks like a row with a typing error is an error. Nothing where there are no numbers.
[[nodiscard]] std::optional<ColumnRows> find_rows(const std::vector<Line>& lines, const RecordOptions& options,
                                                  RecordErrors& errors);

/// Whether a column can be one of times: it rises from row to row, with at most one exception in ten rows.
[[nodiscard]] bool goes_up(const std::vector<double>& values);

/// (t_n − t_0)/(n − 1) [s] when no step differs from it by more than one per cent, or no time from an even course by
/// more than its last digit's rounding; else nothing, and in `bad` the index of the first time that is too far from the
/// one before, 0 where time does not go forward as a whole.
[[nodiscard]] std::optional<double> even_step(const std::vector<double>& times, std::size_t& bad);

}  // namespace bentur::records
