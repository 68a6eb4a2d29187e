// Text with one column (accelerations) or more (time first), separated by blanks, tabs, commas or semicolons.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "bentur/io/record_files_text.h"

namespace bentur {
namespace {

constexpr std::string_view blanks = " \t";
constexpr double step_tolerance = 0.01;  // of the mean step [-]

/// How the columns of a file are told apart.
struct Layout {
  char separator = ' ';        ///< ' ' stands for blanks and tabs
  bool decimal_comma = false;  ///< 0,25 is a quarter
};

/// The line without its comment.
Line without_comment(const Line& line) { return {line.text.substr(0, line.text.find_first_of("#%")), line.number}; }

bool has(const Line& line, char c) { return line.text.find(c) != std::string_view::npos; }

/// The columns of a line. A blank one between two commas or semicolons stays (as an error to come), one at the end does
/// not.
std::vector<Token> cells_of(const Line& line, char separator) {
  if (separator == ' ') return words_of(line, blanks);
  std::vector<Token> cells;
  std::size_t from = 0;
  while (from <= line.text.size()) {
    const std::size_t end = std::min(line.text.find(separator, from), line.text.size());
    const std::size_t first = std::min(line.text.find_first_not_of(blanks, from), end);
    const std::size_t last = line.text.find_last_not_of(blanks, end == 0 ? 0 : end - 1);
    const std::size_t size = first < end && last != std::string_view::npos && last >= first ? last - first + 1 : 0;
    cells.push_back({line.text.substr(first, size), line.number, static_cast<int>(first) + 1});
    from = end + 1;
  }
  if (cells.size() > 1 && cells.back().text.empty()) cells.pop_back();
  return cells;
}

/// A comma parts columns, unless every one stands between digits of blank-separated numbers of which none has a point.
bool commas_are_decimal(const std::vector<Line>& lines) {
  bool several_words = false;
  for (const Line& line : lines) {
    if (has(line, '.')) return false;
    const auto words = words_of(line, blanks);
    several_words = several_words || words.size() > 1;
    for (const Token& word : words) {
      for (std::size_t i = word.text.find(','); i != std::string_view::npos; i = word.text.find(',', i + 1)) {
        const bool digits = i > 0 && i + 1 < word.text.size() &&
                            std::isdigit(static_cast<unsigned char>(word.text[i - 1])) != 0 &&
                            std::isdigit(static_cast<unsigned char>(word.text[i + 1])) != 0;
        if (!digits || word.text.find(',', i + 1) != std::string_view::npos) return false;
      }
    }
  }
  return several_words;
}

Layout layout_of(const std::vector<Line>& lines) {
  const auto any = [&](char c) {
    return std::any_of(lines.begin(), lines.end(), [c](const Line& line) { return has(line, c); });
  };
  const bool point = any('.');
  if (any(';')) return {';', !point};
  if (!any(',')) return {' ', false};
  if (commas_are_decimal(lines)) return {' ', true};
  return {',', false};
}

/// True for a first line without a single number in it: column titles.
bool is_header(const Line& line) {
  const char separator = has(line, ';') ? ';' : has(line, '\t') ? '\t' : has(line, ',') ? ',' : ' ';
  const auto cells = cells_of(line, separator);
  return std::none_of(cells.begin(), cells.end(), [](const Token& cell) {
    return number_of(cell.text, true) ||
           (!cell.text.empty() && std::isdigit(static_cast<unsigned char>(cell.text.front())) != 0);
  });
}

/// (t_n − t_0)/(n − 1) [s], when no step differs from it by more than one per cent.
std::optional<double> step_of(const std::vector<double>& times, const std::vector<int>& lines, RecordErrors& errors) {
  if (times.size() < 2) {
    errors.error(0, 0, "holds one value only, a record needs two or more");
    return std::nullopt;
  }
  const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  if (!(step > 0)) {
    errors.error(lines.back(), 1, "time does not go forward from the first line to the last");
    return std::nullopt;
  }
  // Decimal fractions are not exact in binary: a few units in the last place of the times are no deviation.
  const double slack = 1e-14 * std::max(std::abs(times.front()), std::abs(times.back()));
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double own = times[i] - times[i - 1];
    if (std::abs(own - step) <= step_tolerance * step + slack) continue;
    errors.error(lines[i], 1,
                 fmt::format("time step {:.6g} s differs from the mean step {:.6g} s by more than 1 %", own, step));
    return std::nullopt;
  }
  return step;
}

/// Index of the accelerations' column among `columns`, or an error.
std::optional<std::size_t> chosen_column(const RecordOptions& options, std::size_t columns, RecordErrors& errors) {
  if (!options.column) {
    if (columns == 2) return 1;
    errors.error(
        0, 0, fmt::format("has {} columns: say in {} which one holds the accelerations", columns, options.column_name));
    return std::nullopt;
  }
  if (*options.column >= 2 && static_cast<std::size_t>(*options.column) <= columns) {
    return static_cast<std::size_t>(*options.column) - 1;
  }
  errors.error(0, 0,
               fmt::format("has columns 1 (time) to {}, {} = {} is not one of accelerations", columns,
                           options.column_name, *options.column));
  return std::nullopt;
}

}  // namespace

std::optional<Record> read_columns(const std::vector<Line>& lines, const RecordOptions& options, RecordErrors& errors) {
  std::vector<Line> rows;
  for (const Line& line : lines) {
    const Line row = without_comment(line);
    if (row.text.find_first_not_of(blanks) != std::string_view::npos) rows.push_back(row);
  }
  if (!rows.empty() && is_header(rows.front())) rows.erase(rows.begin());
  if (rows.empty()) {
    errors.error(0, 0, "holds no numbers");
    return std::nullopt;
  }
  const Layout layout = layout_of(rows);
  const std::size_t columns = cells_of(rows.front(), layout.separator).size();
  const bool single = options.format == "one-column" || (options.format == "auto" && columns == 1);
  if (single && columns != 1) {
    errors.error(rows.front().number, 1, fmt::format("has {} columns, a one-column file has one", columns));
    return std::nullopt;
  }
  if (!single && columns < 2) {
    errors.error(rows.front().number, 1, "has 1 column, a two-column file has time and acceleration");
    return std::nullopt;
  }
  if (single && options.column.value_or(1) != 1) {
    errors.error(0, 0, fmt::format("has one column, {} = {} is not there", options.column_name, *options.column));
  }
  if (single && !options.time_step) {
    errors.error(0, 0, "has one column and so no time: give " + options.time_step_name);
  }
  const auto column = single ? std::optional<std::size_t>(0) : chosen_column(options, columns, errors);

  Record record;
  record.format = single ? "one-column" : "two-column";
  std::vector<double> times;
  std::vector<int> line_numbers;
  for (const Line& row : rows) {
    if (errors.full()) break;
    const auto cells = cells_of(row, layout.separator);
    if (cells.size() != columns) {
      errors.error(row.number, 1,
                   fmt::format("has {} {}, the first row has {}", cells.size(),
                               cells.size() == 1 ? "column" : "columns", columns));
      continue;
    }
    for (std::size_t i = 0; i < columns; ++i) {
      const auto value = finite_number(cells[i], layout.decimal_comma, errors);
      if (!value) continue;
      if (i == 0 && !single) times.push_back(*value);
      if (i == column) record.values.push_back(*value);
    }
    line_numbers.push_back(row.number);
  }
  if (!errors.ok() || !column) return std::nullopt;
  if (single) {
    record.time_step = *options.time_step;
    return record;
  }
  const auto step = step_of(times, line_numbers, errors);
  if (!step) return std::nullopt;
  record.time_step = *step;
  return record;
}

}  // namespace bentur
