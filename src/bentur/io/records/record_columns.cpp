// Text with one column (accelerations), with several (time first, or channels without time), or with any number of
// accelerations in a line; separated by blanks, tabs, commas or semicolons.

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <span>

#include "bentur/core/number_text.h"
#include "bentur/io/records/internal/column_rows.h"
#include "bentur/io/records/internal/record_text.h"

namespace bentur::records {
namespace {

/// What the columns of a file mean, once it is known.
enum class Meaning { time_first, channels, values };

/// Rows of numbers, one behind the other: a file may have millions.
class NumberRows {
 public:
  void add(double number) { numbers_.push_back(number); }
  void end_row() { ends_.push_back(static_cast<std::uint32_t>(numbers_.size())); }
  [[nodiscard]] std::size_t size() const { return ends_.size(); }
  [[nodiscard]] std::span<const double> operator[](std::size_t row) const {
    const std::size_t begin = row == 0 ? 0 : ends_[row - 1];
    return {numbers_.data() + begin, ends_[row] - begin};
  }
  [[nodiscard]] std::vector<double> column(std::size_t index) const {
    std::vector<double> result(size());
    for (std::size_t row = 0; row < size(); ++row) result[row] = (*this)[row][index];
    return result;
  }
  /// All of them, row by row.
  [[nodiscard]] const std::vector<double>& all() const { return numbers_; }

 private:
  std::vector<double> numbers_;
  std::vector<std::uint32_t> ends_;  // of the rows
};

class ColumnReader {
 public:
  ColumnReader(const ColumnRows& found, const RecordOptions& options, RecordErrors& errors)
      : found_(found), options_(options), errors_(errors) {
    if (found.stated) step_ = found.stated->time_step;
    if (!step_) step_ = options.time_step;
    columns_ = found.cells(found.rows.front()).size();
  }

  std::optional<StrongMotionRecord> read() {
    read_numbers();
    if (numbers_.size() == 0) return std::nullopt;
    const auto meaning = settled();
    if (!meaning) return std::nullopt;
    StrongMotionRecord record;
    record.header_lines = found_.header_lines;
    if (*meaning == Meaning::values) {
      record.format = columns_ == 1 ? "one-column" : "values";
      record.values = numbers_.all();
      record.time_step = needed_step();
    } else {
      check_widths();
      const bool timed = *meaning == Meaning::time_first;
      record.format = timed ? "two-column" : "one-column";
      const auto column = chosen_column(timed);
      if (!timed) record.time_step = needed_step();
      if (!errors_.ok() || !column) return std::nullopt;
      record.values = numbers_.column(*column);
      if (timed) record.time_step = step_of_times();
      if (columns_ > (timed ? 2 : 1)) record.channel = fmt::format("column {} of {}", *column + 1, columns_);
    }
    check_count(record.values.size());
    return errors_.ok() ? std::optional(std::move(record)) : std::nullopt;
  }

 private:
  void read_numbers() {
    for (const Line& row : found_.rows) {
      if (errors_.full()) return;
      for (const Token& cell : found_.cells(row)) {
        numbers_.add(finite_number(cell, found_.decimal_comma, errors_).value_or(0));
      }
      numbers_.end_row();
    }
  }

  /// Every row but the last has as many numbers as the first, and the last no more; `ragged`: it has fewer.
  [[nodiscard]] bool is_block(bool& ragged) const {
    const std::size_t last = numbers_.size() - 1;
    ragged = numbers_[last].size() < columns_;
    for (std::size_t row = 0; row < last; ++row) {
      if (numbers_[row].size() != columns_) return false;
    }
    return numbers_[last].size() <= columns_;
  }

  /// An asked-for format decides. Else times are told by going up, and accelerations without time only where nothing
  /// else can be meant.
  std::optional<Meaning> settled() {
    const std::string& format = options_.format;
    if (format == "values") return values_without_column();
    if (format == "one-column" && columns_ > 1 && !options_.column) {
      return errors_.error(
          fmt::format("has {} numbers in a line: say in {} which column holds the accelerations; where every number is "
                      "an acceleration of one record, row by row, give {}",
                      columns_, options_.name("column"), as_values()));
    }
    if (format == "one-column") return Meaning::channels;
    if (format == "two-column") {
      if (columns_ >= 2) return Meaning::time_first;
      return errors_.error(found_.rows.front(), "has 1 column, a two-column file has time and acceleration");
    }
    if (columns_ == 1) return Meaning::channels;
    if (format == "csv" && found_.separator == ' ' && found_.rows.front().text.find('\t') == std::string_view::npos) {
      return errors_.error("has no commas, semicolons or tabs between its numbers, as a csv file has");
    }
    if (!errors_.ok() || goes_up(numbers_.column(0))) return Meaning::time_first;
    return without_time();
  }

  std::optional<Meaning> values_without_column() {
    if (!options_.column) return Meaning::values;
    return errors_.error(
        fmt::format("is read row by row with {}: {} has no meaning then", as_values(), options_.name("column")));
  }

  /// Several numbers in a line, of which the first is no time.
  std::optional<Meaning> without_time() {
    bool ragged = false;
    const bool block = is_block(ragged);
    if (options_.column) return Meaning::channels;
    const bool counted = found_.stated && static_cast<std::size_t>(found_.stated->count) == numbers_.all().size();
    if ((block && ragged && step_) || counted) return Meaning::values;
    if (columns_ == 2 && !step_) return Meaning::time_first;  // more likely bad times than no times
    if (!block) {
      check_widths();
      return errors_.error(
          fmt::format("is no table of columns: where every number is an acceleration, row by row, give {}{}",
                      as_values(), step_ ? "" : " and " + options_.name("time_step")));
    }
    if (ragged) {
      return errors_.error(fmt::format("has {} numbers in a line, row by row, and no time: give {}", columns_,
                                       options_.name("time_step")));
    }
    const std::string step = step_ ? "" : options_.name("time_step") + " and ";
    return errors_.error(
        fmt::format("has {} numbers in a line, and the first is no time: give {}either {}, where all are "
                    "accelerations of one record, row by row, or {}, where each column is a channel",
                    columns_, step, as_values(), options_.name("column")));
  }

  void check_widths() {
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      if (numbers_[i].size() == columns_) continue;
      errors_.error(found_.rows[i],
                    fmt::format("has {}, the first row has {}", counted(numbers_[i].size(), "column"), columns_));
    }
  }

  /// Index of the accelerations' column, or an error.
  std::optional<std::size_t> chosen_column(bool timed) {
    if (!options_.column) {
      if (columns_ == (timed ? 2 : 1)) return columns_ - 1;
      return errors_.error(
          fmt::format("has {} columns, time and {} more: say in {} (2 to {}) which one holds the accelerations",
                      columns_, columns_ - 1, options_.name("column"), columns_));
    }
    const auto column = static_cast<std::size_t>(*options_.column);
    if (column >= (timed ? 2U : 1U) && column <= columns_) return column - 1;
    const std::string asked = options_.setting("column", std::to_string(column));
    return errors_.error(
        timed           ? fmt::format("has columns 1 (time) to {}, {} is not one of accelerations", columns_, asked)
        : columns_ == 1 ? fmt::format("has one column, {} is not there", asked)
                        : fmt::format("has {} columns, {} is not there", columns_, asked));
  }

  double needed_step() {
    if (step_) return *step_;
    errors_.error(fmt::format("has {} and so no time: give {}", columns_ == 1 ? "one column" : "no column of times",
                              options_.name("time_step")));
    return 0;
  }

  double step_of_times() {
    const std::vector<double> times = numbers_.column(0);
    std::size_t bad = 0;
    const auto step = even_step(times, bad);
    if (step && found_.stated && std::abs(*step / found_.stated->time_step - 1) > 0.01) {
      errors_.error(fmt::format("says a step of {:.6g} s in its heading, but its times go forward by {:.6g} s",
                                found_.stated->time_step, *step));
    }
    if (step) return *step;
    if (times.size() < 2) {
      errors_.error("holds one value only, a record needs two or more");
    } else if (bad == 0) {
      errors_.error(found_.rows.back(), "time does not go forward from the first line to the last");
    } else {
      const double mean = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
      errors_.error(found_.rows[bad],
                    fmt::format("time step {:.6g} s differs from the mean step {:.6g} s by more than 1 %",
                                times[bad] - times[bad - 1], mean));
    }
    return 0;
  }

  void check_count(std::size_t count) {
    if (!errors_.ok() || !found_.stated || static_cast<std::size_t>(found_.stated->count) == count) return;
    errors_.error(fmt::format("says {} values in its heading, but holds {}", found_.stated->count, count));
  }

  [[nodiscard]] std::string as_values() const { return options_.setting("format", "values"); }

  const ColumnRows& found_;
  const RecordOptions& options_;
  RecordErrors& errors_;
  std::optional<double> step_;  // [s], where the file's heading or the user says it
  std::size_t columns_ = 0;     // of the first row
  NumberRows numbers_;
};

/// A heading that names another quantity than acceleration, as VT2 and DT2 files have it.
void check_heading(const std::vector<Line>& lines, const ColumnRows& found, RecordErrors& errors) {
  for (const Line& line : lines) {
    if (line.number >= found.rows.front().number) return;
    const std::string text = upper(line.text);
    for (const char* const other : {"VELOCITY TIME", "DISPLACEMENT TIME"}) {
      const std::size_t at = text.find(other);
      if (at == std::string::npos || text.find("ACCELERATION") != std::string::npos) continue;
      errors.error(
          line.number, static_cast<int>(at) + 1,
          fmt::format("a {} record, but ground accelerations are needed", *other == 'V' ? "velocity" : "displacement"));
      return;
    }
  }
}

}  // namespace

std::optional<StrongMotionRecord> read_columns(const std::vector<Line>& lines, const RecordOptions& options,
                                               RecordErrors& errors) {
  if (options.channel) {
    errors.error(fmt::format("is a file of columns: {} has no meaning, give {}", options.name("channel"),
                             options.name("column")));
  }
  const auto found = find_rows(lines, options, errors);
  if (!found) return std::nullopt;
  check_heading(lines, *found, errors);
  return ColumnReader(*found, options, errors).read();
}

}  // namespace bentur::records
