// Text with one column (accelerations), with several (time first, or channels without time), or with any number of
// accelerations in a line; separated by blanks, tabs, commas or semicolons. What the heading says of them is understood
// (internal/heading.h), and what it says otherwise than the numbers or the user is an error.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/io/records/internal/column_rows.h"
#include "bentur/io/records/internal/components.h"
#include "bentur/io/records/internal/number_cells.h"
#include "bentur/io/records/internal/number_rows.h"
#include "bentur/io/records/internal/record_text.h"

namespace bentur::records {
namespace {

/// What the columns of a file mean, once it is known.
enum class Meaning { time_first, channels, values };

constexpr std::size_t rows_to_tell_numbering = 10;
constexpr double same_step = 0.01;  // of the step [-]

/// Whether numbers are 0, 1, 2, ... or 1, 2, 3, ...: those of rows, as pandas writes them.
bool numbers_rows(const std::vector<double>& numbers) {
  if (numbers.size() < 2 || (numbers[0] != 0 && numbers[0] != 1)) return false;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    if (numbers[i] != numbers[0] + static_cast<double>(i)) return false;
  }
  return true;
}

class ColumnReader {
 public:
  ColumnReader(const ColumnRows& found, const RecordOptions& options, RecordErrors& errors)
      : found_(found), options_(options), errors_(errors) {
    columns_ = found.cells(found.rows.front()).size();
    labels_ = column_labels(found.head, columns_, found.separator);
    labels_.resize(columns_);
    labelled_ = std::all_of(labels_.begin(), labels_.end(),
                            [](const ColumnLabel& label) { return label.fact || is_direction(label.text); });
    settle_step();
    for (const Statement& other : found.heading.other_units) {
      errors.error(other.line, other.column,
                   fmt::format("says {}, but ground accelerations are needed", in_words(other.text)));
    }
  }

  std::optional<StrongMotionRecord> read() {
    read_numbers();
    if (numbers_.size() == 0) return std::nullopt;
    find_numbering();
    const auto meaning = settled();
    if (!meaning) return std::nullopt;
    StrongMotionRecord record;
    record.header_lines = found_.header_lines;
    ChannelPlace channel;
    if (*meaning == Meaning::values) {
      record.format = columns_ == 1 ? "one-column" : "values";
      record.values = numbers_.all();
      if (columns_ == 1) check_label(labels_.front());
      settle_unit(labels_.front(), record);
    } else {
      check_widths();
      const bool timed = *meaning == Meaning::time_first;
      record.format = timed ? "two-column" : "one-column";
      const std::size_t first_data = first_ + (timed ? 1 : 0);
      const auto column = chosen_column(timed, first_data);
      if (!timed) take_step(record);
      if (!errors_.ok() || !column) return std::nullopt;
      check_label(labels_[*column]);
      record.values = numbers_.column(*column);
      if (timed) take_step_of_times(record);
      const std::size_t channels = columns_ - first_data;
      if (channels > 1) record.channel = channel_name(*column);
      channel = {*column - first_data, channels};
      settle_unit(labels_[*column], record);
    }
    if (*meaning == Meaning::values) take_step(record);
    check_count(record.values.size());
    if (!errors_.ok()) return std::nullopt;
    check_peak(found_.heading, record.values, record.unit.empty() ? options_.unit : record.unit, channel, hint(),
               errors_);
    return errors_.ok() ? std::optional(std::move(record)) : std::nullopt;
  }

 private:
  void read_numbers() {
    const auto first_cells = found_.cells(found_.rows.front());
    std::optional<TimeStamp> first_stamp;
    for (std::size_t i = 0; i < std::min(first_cells.size(), std::size_t{2}) && !first_stamp; ++i) {
      if (number_of(first_cells[i].text, true)) continue;
      first_stamp = time_stamp(first_cells[i].text);
      stamped_ = i;
    }
    for (const Line& row : found_.rows) {
      if (errors_.full()) return;
      const auto cells = found_.cells(row);
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (first_stamp && i == stamped_) {
          const auto stamp = time_stamp(cells[i].text);
          if (!stamp) errors_.error(cells[i], shown(cells[i].text) + " is no time of the day, as the first row has");
          numbers_.add(stamp ? stamp->since(*first_stamp) : 0);
          continue;
        }
        numbers_.add(finite_number(cells[i], found_.decimal_comma, errors_).value_or(0));
      }
      numbers_.end_row();
    }
  }

  /// The step that the heading states, or the user, where that is one of those.
  void settle_step() {
    const std::vector<Statement>& steps = found_.heading.steps;
    const auto same = [](double a, double b) { return std::abs(a / b - 1) <= same_step; };
    const auto fits = [&](const Statement& said) {
      return same(said.value, *options_.time_step) || (said.vague && same(said.value / 1000, *options_.time_step));
    };
    if (options_.time_step) {
      step_ = options_.time_step;
      const auto said = std::find_if(steps.begin(), steps.end(), fits);
      if (said != steps.end()) {
        step_ = said->vague ? *options_.time_step : said->value;
        step_line_ = said->line;
      } else if (!steps.empty()) {  // what the user says otherwise is told where the user says it
        step_ = steps.front().value;
        step_line_ = steps.front().line;
      }
      return;
    }
    for (const Statement& said : steps) {
      if (said.vague || step_) continue;
      step_ = said.value;
      step_line_ = said.line;
    }
    for (const Statement& said : steps) {
      if (step_ && !same(said.value, *step_) && !(said.vague && same(said.value / 1000, *step_))) other_step_ = &said;
    }
  }

  /// A first column of row numbers is none of times: its heading says so, times stand beside it, or the step is known
  /// to be another.
  void find_numbering() {
    if (columns_ < 2 || !numbers_rows(numbers_.column(0)) || labels_[0].fact == Fact::time) return;
    std::size_t bad = 0;
    const std::vector<double> second = numbers_.column(1);
    const bool times_beside = columns_ > 2 && numbers_.size() >= rows_to_tell_numbering && !numbers_rows(second) &&
                              even_step(second, bad).has_value();
    const bool other_step = step_line_ > 0 && std::abs(*step_ - 1) > same_step && options_.format != "two-column";
    const bool named = labels_[0].line > 0 && labels_[0].fact == Fact::index;
    if (named || times_beside || other_step) first_ = 1;
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

  /// An asked-for format decides. Else the headings of the columns; else times are told by going up, and accelerations
  /// without time only where nothing else can be meant.
  std::optional<Meaning> settled() {
    const std::string& format = options_.format;
    if (format == "values") return values_without_column();
    const bool chosen = options_.column || options_.component;
    if (format == "one-column" && columns_ - first_ > 1 && !chosen) {
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
    if (columns_ - first_ == 1) return Meaning::channels;
    if (format == "csv" && found_.separator == ' ' && found_.rows.front().text.find('\t') == std::string_view::npos) {
      return errors_.error("has no commas, semicolons or tabs between its numbers, as a csv file has");
    }
    const ColumnLabel& label = labels_[first_];
    if (labelled_ && (label.fact == Fact::acceleration || is_direction(label.text))) return Meaning::channels;
    if (label.fact == Fact::time && labelled_ && label.text.size() > 1) return Meaning::time_first;  // T: transverse
    if (!errors_.ok() || goes_up(numbers_.column(first_))) return Meaning::time_first;
    return without_time();
  }

  std::optional<Meaning> values_without_column() {
    for (const char* const key : {"column", "component"}) {
      if (key == std::string("column") ? !options_.column : !options_.component) continue;
      return errors_.error(
          fmt::format("is read row by row with {}: {} has no meaning then", as_values(), options_.name(key)));
    }
    return Meaning::values;
  }

  /// Several numbers in a line, of which the first is no time.
  std::optional<Meaning> without_time() {
    bool ragged = false;
    const bool block = is_block(ragged);
    if (options_.column || options_.component) return Meaning::channels;
    const auto& counts = found_.heading.counts;
    const bool counted = std::any_of(counts.begin(), counts.end(), [&](const Statement& said) {
      return said.value == static_cast<double>(numbers_.all().size());
    });
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

  [[nodiscard]] std::string channel_name(std::size_t column) const {
    const std::string& label = labels_[column].text;
    return fmt::format("column {} of {}{}", column + 1, columns_, label.empty() ? "" : " (" + printable(label) + ")");
  }

  /// The only column whose heading says accelerations, where all others say that they are none.
  [[nodiscard]] std::optional<std::size_t> only_accelerations(std::size_t first_data) const {
    std::optional<std::size_t> only;
    for (std::size_t i = first_data; i < columns_; ++i) {
      const auto& fact = labels_[i].fact;
      if (fact && *fact != Fact::acceleration) continue;
      if (!fact || only) return std::nullopt;
      only = i;
    }
    return only;
  }

  /// Index of the accelerations' column, or an error.
  std::optional<std::size_t> chosen_column(bool timed, std::size_t first_data) {
    std::optional<std::size_t> named;
    if (options_.component) {
      named = column_of_component(first_data);
      if (!named) return named;
      if (options_.column && static_cast<std::size_t>(*options_.column) != *named + 1) {
        return errors_.error(labels_[*named].line, 1,
                             fmt::format("says that {} is column {}, but {} is given", in_words(*options_.component),
                                         *named + 1, options_.setting("column", std::to_string(*options_.column))));
      }
      return named;
    }
    if (!options_.column) {
      if (columns_ == first_data + 1) return first_data;
      if (const auto only = only_accelerations(first_data)) return only;
      return errors_.error(which_column(timed, first_data));
    }
    const auto column = static_cast<std::size_t>(*options_.column);
    if (column > first_data && column <= columns_) return column - 1;
    const std::string asked = options_.setting("column", std::to_string(column));
    return errors_.error(
        timed && first_ == 0
            ? fmt::format("has columns 1 (time) to {}, {} is not one of accelerations", columns_, asked)
        : column <= columns_ && first_data > 0
            ? fmt::format("has accelerations from column {} to {}, {} is not one of them", first_data + 1, columns_,
                          asked)
        : columns_ == 1 ? fmt::format("has one column, {} is not there", asked)
                        : fmt::format("has {} columns, {} is not there", columns_, asked));
  }

  /// That the column must be said, and among which.
  [[nodiscard]] std::string which_column(bool timed, std::size_t first_data) const {
    std::string list;
    for (std::size_t i = first_data; i < std::min(columns_, first_data + 12) && labels_[i].line > 0; ++i) {
      list += fmt::format("{}{} {}", list.empty() ? "" : ", ", i + 1, in_words(labels_[i].text));
    }
    const std::string has = timed ? fmt::format("has {} columns, time and {} more", columns_, columns_ - first_data)
                                  : fmt::format("has {} columns without time", columns_);
    const std::string places = fmt::format("{} ({} to {})", options_.name("column"), first_data + 1, columns_);
    if (list.empty()) return fmt::format("{}: say in {} which one holds the accelerations", has, places);
    return fmt::format("{}: say in {} or {} which one holds the accelerations: {}", has, places,
                       options_.name("component"), list);
  }

  std::optional<std::size_t> column_of_component(std::size_t first_data) {
    std::vector<std::string> names;
    for (std::size_t i = first_data; i < columns_; ++i) names.push_back(labels_[i].text);
    if (columns_ == first_data + 1 && names[0].empty() && !found_.heading.components.empty()) {
      names[0] = found_.heading.components.front().text;
    }
    const auto found = named_component(names, "column", options_, errors_);
    return found ? std::optional(*found + first_data) : std::nullopt;
  }

  void check_label(const ColumnLabel& label) {
    if (label.fact != Fact::velocity && label.fact != Fact::displacement && label.fact != Fact::other) return;
    errors_.error(label.line, label.column,
                  fmt::format("heads the column {}, but ground accelerations are needed", shown(label.text)));
  }

  /// The unit that the heading of the column says, or of all columns; what is said twice and differently the user says.
  void settle_unit(const ColumnLabel& label, StrongMotionRecord& record) {
    std::vector<Statement> said = found_.heading.units;
    if (label.unit) {  // the headings of other columns are of those
      const int line = label.unit_line > 0 ? label.unit_line : label.line;
      std::erase_if(said, [&](const Statement& other) { return other.line == line; });
      said.insert(said.begin(), {.unit = label.unit->unit, .factor = label.unit->factor, .line = line});
    }
    if (said.empty()) {  // a unit in prose is held against the user's, and not taken
      const auto& mentions = found_.heading.mentions;
      const auto same = [&](const Statement& one) { return one.unit == options_.unit; };
      if (!options_.unit.empty() && !mentions.empty() && std::none_of(mentions.begin(), mentions.end(), same)) {
        record.unit = mentions.front().unit;
        record.unit_line = mentions.front().line;
      }
      return;
    }
    const Statement* unit = &said.front();
    for (const Statement& other : said) {
      if (other.unit == options_.unit) unit = &other;
    }
    for (const Statement& other : said) {
      if (other.unit == unit->unit && other.factor == unit->factor) continue;
      if (unit->unit == options_.unit) continue;
      errors_.error(other.line, other.column + (other.column == 0 ? 1 : 0),
                    fmt::format("says {}, but line {} says {}: give {}", other.unit, unit->line, unit->unit,
                                options_.name("unit")));
      return;
    }
    record.unit = unit->unit;
    record.unit_line = unit->line;
    for (double& value : record.values) value *= unit->factor;
  }

  void take_step(StrongMotionRecord& record) {
    if (other_step_ != nullptr) {
      errors_.error(other_step_->line, other_step_->column,
                    fmt::format("says {:.6g} s from value to value, but line {} says {:.6g} s: give {}",
                                other_step_->value, step_line_, *step_, options_.name("time_step")));
      return;
    }
    if (step_) {
      record.time_step = *step_;
      record.step_line = step_line_;
      return;
    }
    errors_.error(fmt::format("has {} and so no time: give {}",
                              columns_ - first_ == 1 ? "one column" : "no column of times",
                              options_.name("time_step")));
  }

  void take_step_of_times(StrongMotionRecord& record) {
    std::vector<double> times = numbers_.column(first_);
    for (double& time : times) time *= labels_[first_].seconds;
    std::size_t bad = 0;
    const auto step = even_step(times, bad);
    const std::vector<Statement>& steps = found_.heading.steps;
    const auto fits = [&](const Statement& said) {
      return std::abs(*step / said.value - 1) <= same_step ||
             (said.vague && std::abs(1000 * *step / said.value - 1) <= same_step);
    };
    if (step && !steps.empty() && std::none_of(steps.begin(), steps.end(), fits)) {
      errors_.error(steps.front().line, steps.front().column,
                    fmt::format("says {:.6g} s from value to value, but the times go forward by {:.6g} s{}",
                                steps.front().value, *step, hint()));
    }
    record.time_step = step.value_or(0);
    if (step) return;
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
  }

  void check_count(std::size_t count) {
    const std::vector<Statement>& counts = found_.heading.counts;
    const auto fits = [&](const Statement& said) { return said.value == static_cast<double>(count); };
    if (!errors_.ok() || counts.empty() || std::any_of(counts.begin(), counts.end(), fits)) return;
    errors_.error(counts.front().line, counts.front().column,
                  fmt::format("says {} values, but {} follow{}", counts.front().value, count, hint()));
  }

  [[nodiscard]] std::string as_values() const { return options_.setting("format", "values"); }

  /// What to do where the heading is of other numbers.
  [[nodiscard]] std::string hint() const {
    return fmt::format(" (where the heading is of another record, give {})",
                       options_.setting("skip_lines", std::to_string(found_.rows.front().number - 1)));
  }

  const ColumnRows& found_;
  const RecordOptions& options_;
  RecordErrors& errors_;
  std::vector<ColumnLabel> labels_;  // of each column
  bool labelled_ = false;            // it is known what each of them says
  std::optional<double> step_;       // [s], where the file's heading or the user says it
  int step_line_ = 0;                // of the heading
  const Statement* other_step_ = nullptr;
  std::size_t columns_ = 0;  // of the first row
  std::size_t first_ = 0;    // behind a column of row numbers
  std::size_t stamped_ = 0;  // the column of times of the day, where there is one
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
