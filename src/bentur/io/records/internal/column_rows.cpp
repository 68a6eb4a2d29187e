#include "bentur/io/records/internal/column_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/io/records/internal/number_cells.h"

namespace bentur::records {
namespace {

constexpr std::string_view row_blanks = " \t";
constexpr double step_tolerance = 0.01;  // of the mean step [-]

bool digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// The line without its comment.
Line without_comment(const Line& line) { return {line.text.substr(0, line.text.find_first_of("#%")), line.number}; }

Token unquoted(Token token) {
  if (token.text.size() < 2 || token.text.front() != '"' || token.text.back() != '"') return token;
  const std::string_view inside = token.text.substr(1, token.text.size() - 2);
  const std::size_t blanks = std::min(inside.find_first_not_of(row_blanks), inside.size());
  return {trimmed(inside), token.line, token.column + 1 + static_cast<int>(blanks)};
}

/// Whether a cell may be several fields that touch: a sign behind a digit, or two points.
bool may_touch(std::string_view text) {
  std::size_t points = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    points += text[i] == '.' || text[i] == ',' ? 1 : 0;
    if (i > 0 && (text[i] == '-' || text[i] == '+') && (digit(text[i - 1]) || text[i - 1] == '.')) return true;
  }
  return points > 1;
}

/// Cells of a row as they are meant: touching fields parted, a date and the time behind it in one.
std::vector<Token> row_cells(const Line& line, char separator) {
  std::vector<Token> cells = split_cells(line, separator);
  if (separator == ' ') {
    for (std::size_t i = 0; i + 1 < std::min(cells.size(), std::size_t{3}); ++i) {
      const Token& date = cells[i];
      if (date.text.size() != 10 || (date.text[4] != '-' && date.text[4] != '/')) continue;
      const Token& clock = cells[i + 1];
      const auto size = static_cast<std::size_t>(clock.text.data() + clock.text.size() - date.text.data());
      const Token both{{date.text.data(), size}, date.line, date.column};
      if (!time_stamp(both.text)) continue;
      cells[i] = both;
      cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!may_touch(cells[i].text)) continue;
    const std::vector<Token> pieces = touching_numbers(cells[i]);
    if (pieces.empty()) continue;
    cells[i] = pieces.front();
    cells.insert(cells.begin() + static_cast<std::ptrdiff_t>(i) + 1, pieces.begin() + 1, pieces.end());
    i += pieces.size() - 1;
  }
  return cells;
}

/// A number with a point or a comma; which of them it is to be is for all rows to say.
std::optional<double> any_number(const Token& cell) { return number_of(cell.text, true); }

/// A number, or of the first two cells a time of the day.
bool is_of_row(const Token& cell, std::size_t place) {
  return any_number(cell) || (place < 2 && time_stamp(cell.text));
}

/// The first cell that no row has, or the end.
std::size_t first_bad(const std::vector<Token>& cells) {
  std::size_t i = 0;
  while (i < cells.size() && is_of_row(cells[i], i)) ++i;
  return i;
}

bool is_row(const Line& line, char separator) {
  if (separator != ' ' && line.text.find(separator) == std::string_view::npos) return false;
  const auto cells = row_cells(line, separator);
  return first_bad(cells) == cells.size() && any_number(cells.back());
}

/// Rows of numbers one after the other: of the first three, or else two, or else one.
struct Run {
  std::size_t rows = 0;
  std::size_t begin = 0;  ///< index of the first

  [[nodiscard]] bool better_than(const Run& other) const {
    return rows > other.rows || (rows == other.rows && begin < other.begin);
  }
};

Run first_run(const std::vector<Line>& lines, char separator) {
  Run best;
  std::size_t rows = 0;  // up to this line
  for (std::size_t i = 0; i < lines.size() && best.rows < 3; ++i) {
    rows = is_row(lines[i], separator) ? rows + 1 : 0;
    if (rows > best.rows) best = {rows, i + 1 - rows};
  }
  return best;
}

/// In lines such as "0,25" the comma may part two columns or be decimal. Two columns where the first is time.
bool comma_parts_columns(const std::vector<Line>& lines, std::size_t begin, const std::string& format) {
  if (format == "csv" || format == "two-column") return true;
  if (format == "one-column") return false;
  std::vector<double> times;
  for (std::size_t i = begin; i < lines.size(); ++i) {
    const auto cells = split_cells(lines[i], ',');
    const auto time = any_number(cells[0]);
    if (cells.size() < 2) return false;
    if (cells.size() > 2 || !time || lines[i].text.find('.') != std::string_view::npos) return true;
    times.push_back(*time);
  }
  std::size_t bad = 0;
  return even_step(times, bad).has_value();
}

/// A digit and otherwise what numbers, and slips of the hand in them, are made of.
bool nearly_number(std::string_view text) {
  return std::any_of(text.begin(), text.end(), digit) &&
         text.find_first_not_of("0123456789.,+-eEdDoOlI") == std::string_view::npos;
}

/// Whether a line before the rows could be a row with a typing error, or a row of another width, and so may not be
/// passed over in silence.
bool could_be_row(const std::vector<Token>& cells, std::size_t columns) {
  std::size_t leading = 0;
  while (leading < cells.size() && any_number(cells[leading])) ++leading;
  if (cells.empty() || !nearly_number(cells[0].text)) return false;
  return leading == cells.size() || (cells.size() == columns) || (leading >= 2 && columns >= 2);
}

std::string other_width(std::size_t columns, std::size_t below) {
  return fmt::format("has {}, the rows below have {}", counted(columns, "column"), below);
}

std::string heading_hint(const RecordOptions& options, int lines) {
  return fmt::format(" (where this line is a heading, give {})", options.setting("skip_lines", std::to_string(lines)));
}

void say_count_and_step(const CountAndStep& stated, int line, Heading& heading) {
  heading.counts.push_back({.value = static_cast<double>(stated.count), .line = line, .column = 1});
  heading.steps.push_back({.value = stated.time_step, .line = line, .column = 1});
}

/// Whether `first` and `second` are the number of values that follow and their step.
bool is_count_and_step(std::optional<double> first, std::optional<double> second) {
  return is_count(first) && *first >= 2 && second && *second > 0 && *second <= 10;
}

/// "4000 0.02", or "0.02 4000", before as many values, or as many rows whose times have that step; or a line
/// each; or "4000" alone. An error where only the number of the values is another.
void take_count_line(ColumnRows& found, RecordErrors& errors) {
  if (found.rows.size() < 2) return;
  const auto first = found.cells(found.rows[0]), second = found.cells(found.rows[1]);
  std::size_t values = 0;
  for (std::size_t i = 1; i < found.rows.size(); ++i) values += found.cells(found.rows[i]).size();
  const std::size_t rows = found.rows.size() - 1;
  const auto number = [&](const Token& cell) { return number_of(cell.text, found.decimal_comma); };
  const auto take = [&](std::optional<CountAndStep> stated) {
    if (stated) say_count_and_step(*stated, found.rows.front().number, found.heading);
    ++found.header_lines;
    found.rows.erase(found.rows.begin());
  };
  if (first.size() == 1 && second.size() == 1) {  // a line each: the number, and perhaps the step
    const auto count = number(first[0]), step = number(second[0]);
    if (rows >= 10 && count == static_cast<double>(rows)) return take(std::nullopt);
    if (rows < 10 || count != static_cast<double>(rows - 1) || !is_count_and_step(count, step)) return;
    take(CountAndStep{static_cast<long>(*count), *step});
    return take(std::nullopt);
  }
  if (first.size() != 2) return;
  auto count = number(first[0]), step = number(first[1]);
  if (!is_count_and_step(count, step)) std::swap(count, step);
  if (!is_count_and_step(count, step)) return;
  const CountAndStep stated{static_cast<long>(*count), *step};
  if (second.size() != 2) {
    if (*count == static_cast<double>(values) || *count == static_cast<double>(rows)) return take(stated);
    errors.error(first[0], fmt::format("says {} values every {} s, but {} values follow in {} rows", stated.count,
                                       stated.time_step, values, rows));
    return;
  }
  // Rows of two: times with that step, or accelerations that are no times.
  std::vector<double> times;
  for (std::size_t i = 1; i < found.rows.size(); ++i)
    times.push_back(number(found.cells(found.rows[i])[0]).value_or(0));
  std::size_t bad = 0;
  const auto own = even_step(times, bad);
  const bool of_times = own && *count == static_cast<double>(rows) && std::abs(*own / *step - 1) <= step_tolerance;
  if (of_times || (!goes_up(times) && *count == static_cast<double>(values))) take(stated);
}

}  // namespace

std::vector<Token> split_cells(const Line& line, char separator) {
  if (separator == ' ') {
    std::vector<Token> words = words_of(line, row_blanks);
    for (Token& word : words) word = unquoted(word);
    return words;
  }
  std::vector<Token> cells;
  const std::string_view text = line.text;
  std::size_t from = 0;
  while (from <= text.size()) {
    bool quoted = false;
    std::size_t end = from;
    for (; end < text.size() && (quoted || text[end] != separator); ++end) quoted = quoted != (text[end] == '"');
    const std::string_view cell = text.substr(from, end - from);
    const std::size_t blanks = std::min(cell.find_first_not_of(row_blanks), cell.size());
    cells.push_back(unquoted({trimmed(cell), line.number, static_cast<int>(from + blanks) + 1}));
    from = end + 1;
  }
  if (cells.size() > 1 && cells.back().text.empty()) cells.pop_back();
  return cells;
}

std::vector<Token> ColumnRows::cells(const Line& row) const { return row_cells(row, separator); }

namespace {

/// Why there are no rows: the line that comes nearest to one, and what is no number in it.
std::nullopt_t no_rows(const std::vector<Line>& lines, RecordErrors& errors) {
  struct Nearest {
    std::size_t numbers = 0;
    Token bad;
  } nearest;
  for (const Line& line : lines) {
    for (const char separator : {' ', ';', ','}) {
      const auto cells = row_cells(line, separator);
      const auto numbers = static_cast<std::size_t>(
          std::count_if(cells.begin(), cells.end(), [](const Token& cell) { return any_number(cell).has_value(); }));
      const std::size_t bad = first_bad(cells);
      if (numbers <= nearest.numbers || 2 * numbers < cells.size() || bad == cells.size()) continue;
      nearest = {numbers, cells[bad]};
    }
  }
  if (nearest.numbers == 0) {  // "0.01s 0.35g"
    for (const Line& line : lines) {
      const auto words = words_of(line, " \t,;");
      const auto begins_so = [](const Token& word) {
        std::size_t size = 0;
        return heading_number(word.text, false, size).has_value();
      };
      if (words.empty() || !std::all_of(words.begin(), words.end(), begins_so)) continue;
      nearest = {words.size(), words.front()};
      break;
    }
  }
  if (nearest.numbers == 0) return errors.error("holds no numbers");
  return errors.error(
      nearest.bad, fmt::format("{} is not a number, and no line holds nothing but numbers", shown(nearest.bad.text)));
}

/// Whether a line of the heading says something, so that it is no row with a typing error.
bool says_something(const Heading& heading, int line) {
  const auto here = [&](const Statement& said) { return said.line == line; };
  return std::any_of(heading.counts.begin(), heading.counts.end(), here) ||
         std::any_of(heading.steps.begin(), heading.steps.end(), here) ||
         std::any_of(heading.peaks.begin(), heading.peaks.end(), here);
}

/// Counts the lines before the rows; what looks like a row among them is an error.
void take_head(const std::vector<Line>& all, std::size_t begin, const RecordOptions& options, ColumnRows& found,
               RecordErrors& errors) {
  const std::size_t columns = row_cells(all[begin], found.separator).size();
  for (std::size_t i = 0; i < begin; ++i) {
    const auto cells = row_cells(all[i], found.separator);
    if (!could_be_row(cells, columns) || says_something(found.heading, all[i].number)) {
      ++found.header_lines;
      continue;
    }
    const std::size_t bad = first_bad(cells);
    const std::string why =
        bad == cells.size() ? other_width(cells.size(), columns) : shown(cells[bad].text) + " is not a number";
    errors.error(all[i].number, bad == cells.size() ? 1 : cells[bad].column,
                 why + heading_hint(options, all[begin].number - 1));
  }
}

/// What the lines before the first row say.
void understand_head(const std::vector<Line>& lines, int first_row, ColumnRows& found) {
  for (const Line& line : lines) {
    if (line.number >= first_row) break;
    if (line.text.find_first_not_of(row_blanks) != std::string_view::npos) found.head.push_back(line);
  }
  found.heading = read_heading(found.head);
  for (const Line& line : found.head) {
    const auto is_said = [&](const Statement& said) { return said.line == line.number; };
    if (std::any_of(found.heading.counts.begin(), found.heading.counts.end(), is_said)) continue;
    if (const auto stated = count_and_step(line)) say_count_and_step(*stated, line.number, found.heading);
  }
}

}  // namespace

std::optional<ColumnRows> find_rows(const std::vector<Line>& lines, const RecordOptions& options,
                                    RecordErrors& errors) {
  std::vector<Line> all;
  for (const Line& line : lines) {
    const Line row = without_comment(line);
    if (row.text.find_first_not_of(row_blanks) != std::string_view::npos) all.push_back(row);
  }
  ColumnRows found;
  Run best;
  for (const char separator : {' ', ';', ','}) {
    const Run run = first_run(all, separator);
    const bool tie = separator == ',' && run.rows > 0 && !best.better_than(run) && found.separator == ' ';
    if (!run.better_than(best) && !(tie && comma_parts_columns(all, run.begin, options.format))) continue;
    best = run;
    found.separator = separator;
  }
  if (best.rows == 0) return no_rows(all, errors);
  understand_head(lines, all[best.begin].number, found);
  take_head(all, best.begin, options, found, errors);
  all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(best.begin));
  found.rows = std::move(all);
  bool points = false, commas = false;
  for (const Line& row : found.rows) {
    for (const Token& cell : found.cells(row)) {
      if (cell.text.find(':') != std::string_view::npos) continue;  // a time of the day
      points = points || cell.text.find('.') != std::string_view::npos;
      commas = commas || cell.text.find(',') != std::string_view::npos;
    }
  }
  found.decimal_comma = commas && !points;
  if (found.heading.counts.empty()) take_count_line(found, errors);
  if (found.rows.size() >= 3) {
    const std::size_t first = found.cells(found.rows[0]).size(), second = found.cells(found.rows[1]).size();
    if (first != second && second == found.cells(found.rows[2]).size()) {
      // Any other line would be compared with this one.
      return errors.error(found.rows[0], other_width(first, second) + heading_hint(options, found.rows[1].number - 1));
    }
  }
  return found;
}

bool goes_up(const std::vector<double>& values) {
  std::size_t back = 0;
  for (std::size_t i = 1; i < values.size(); ++i) back += values[i] > values[i - 1] ? 0 : 1;
  return back * 10 <= values.size();
}

namespace {

constexpr double coarsest_digit = 0.1;  // of the step: rounder times say nothing of it [-]

/// Whether times that are rounded to their last digit go up evenly: half a unit off, as may be the first and the last.
bool even_but_rounded(const std::vector<double>& times, double step) {
  double unit = 1;
  const auto is_multiple = [&](double time) {
    return std::abs(time / unit - std::round(time / unit)) <= 1e-14 * (1 + std::abs(time / unit)) + 1e-9;
  };
  while (unit > 1e-9 && !std::all_of(times.begin(), times.end(), is_multiple)) unit /= 10;
  if (unit > coarsest_digit * step) return false;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (std::abs(times[i] - (times.front() + static_cast<double>(i) * step)) > 1.001 * unit) return false;
  }
  return true;
}

}  // namespace

std::optional<double> even_step(const std::vector<double>& times, std::size_t& bad) {
  bad = 0;
  if (times.size() < 2) return std::nullopt;
  const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  if (!(step > 0 && std::isfinite(step))) return std::nullopt;
  // Decimal fractions are not exact in binary: a few units in the last place of the times are no deviation.
  const double slack = 1e-14 * std::max(std::abs(times.front()), std::abs(times.back()));
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (std::abs(times[i] - times[i - 1] - step) <= step_tolerance * step + slack) continue;
    if (even_but_rounded(times, step)) return step;
    bad = i;
    return std::nullopt;
  }
  return step;
}

}  // namespace bentur::records
