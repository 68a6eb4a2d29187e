#include "text/table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

#include "text/display_width.h"

namespace bentur::cli {

namespace {

constexpr std::size_t usual_width = 100, least_width = 40, largest_width = 200;  // characters

}  // namespace

std::optional<std::size_t> asked_width() {
  const char* const given = std::getenv("COLUMNS");
  if (given != nullptr) {
    const std::optional<double> asked = parse_number(given);
    if (asked && *asked >= 1 && *asked < 1e4) {
      return std::clamp(static_cast<std::size_t>(*asked), least_width, largest_width);
    }
  }
  winsize size{};
  if (::isatty(STDOUT_FILENO) == 1 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    return std::clamp<std::size_t>(size.ws_col, least_width, largest_width);
  }
  return std::nullopt;
}

std::size_t line_width() { return asked_width().value_or(usual_width); }

namespace {

/// Words in lines, the first of at most `first` characters, those after it of `others`.
std::vector<std::string> in_lines(const std::string& text, std::size_t first, std::size_t others) {
  std::vector<std::string> lines(1);
  std::size_t taken = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    const std::size_t width = display_width(word);
    if (taken > 0 && taken + 1 + width > (lines.size() == 1 ? first : others)) {
      lines.emplace_back();
      taken = 0;
    } else if (at > 0) {
      lines.back() += ' ';
      ++taken;
    }
    lines.back() += word;
    taken += width;
    at = end + 1;
  }
  return lines;
}

}  // namespace

std::string wrapped(const std::string& text) {
  constexpr std::string_view indent = "\n  ";
  const std::size_t widest = std::min(usual_width, line_width());
  return fmt::format("{}", fmt::join(in_lines(text, widest, widest - (indent.size() - 1)), indent));
}

std::string fitted(const std::string& given) {
  const std::string text = with_spaces(given);
  if (!asked_width()) return text;
  const std::size_t width = std::min(usual_width, line_width());
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
    const bool is_table = begin > 0 && line.find("  ", begin) != std::string::npos;
    result += display_width(line) > width && !is_table ? wrapped(line) : line;
    if (end < text.size()) result += '\n';
    at = end + 1;
  }
  return result;
}

void Table::add(std::string name, std::string unit, std::vector<std::string> cells, bool is_left) {
  columns_.push_back({std::move(name), std::move(unit), std::move(cells), is_left});
}

void Table::add(std::string name, std::string unit, const std::vector<double>& values) {
  add(std::move(name), std::move(unit), column(values));
}

namespace {

/// A name in two lines, the first one empty where it is no wider than what stands below it or cannot be divided.
std::array<std::string, 2> heading(const std::string& name, std::size_t below) {
  std::array<std::string, 2> lines = {"", name};
  for (std::size_t at = name.find(' '); at != std::string::npos && display_width(name) > below;
       at = name.find(' ', at + 1)) {
    const std::size_t now = std::max(display_width(lines[0]), display_width(lines[1]));
    const std::string first = name.substr(0, at), second = name.substr(at + 1);
    if (std::max(display_width(first), display_width(second)) < now) lines = {first, second};
  }
  return lines;
}

}  // namespace

std::string Table::text() const {
  const std::size_t width = line_width();
  if (!asked_width()) return in_one(width);
  if (least_width_needed() > width && columns_.size() > 1 && columns_.back().name.empty()) return with_marks_first();
  std::string text;
  Table part;
  part.marked_ = marked_;
  for (const Column& column : columns_) {
    Table longer = part;
    longer.columns_.push_back(column);
    if (part.columns_.size() > 1 && longer.least_width_needed() > width) {
      text += part.in_one(width) + "\n";
      part.columns_ = {columns_.front()};  // which says what the rows are
      part.marked_ = marked_;
      part.columns_.push_back(column);
    } else {
      part = std::move(longer);
    }
  }
  return text + part.in_one(width);
}

std::string Table::with_marks_first() const {
  Table rest = *this;
  const Column marks = std::move(rest.columns_.back());
  rest.columns_.pop_back();
  rest.marked_.clear();
  std::string meaning;
  for (const std::string& mark : marks.cells) {
    rest.marked_.push_back(!mark.empty());
    if (!mark.empty()) meaning = mark;
  }
  if (const std::size_t words = meaning.find(' '); words != std::string::npos) meaning.erase(0, words);
  return rest.text() + "► " + std::string(meaning, meaning.find_first_not_of(' ')) + "\n";
}

std::size_t Table::least_width_needed() const {
  std::size_t total = 0;
  for (const Column& column : columns_) {
    std::size_t widest = display_width(column.unit);
    for (const std::string& cell : column.cells) widest = std::max(widest, display_width(cell));
    for (const std::string& line : heading(column.name, widest)) widest = std::max(widest, display_width(line));
    total += widest + 2;
  }
  return total;
}

std::string Table::in_one(std::size_t widest_line) const {
  std::vector<std::array<std::string, 2>> headings;
  std::vector<std::size_t> widths;
  std::size_t total = 0;
  for (const bool divided : {false, true}) {
    if (divided && total <= widest_line) break;
    headings.clear();
    widths.clear();
    total = 0;
    for (const Column& column : columns_) {
      std::size_t widest = display_width(column.unit);
      for (const std::string& cell : column.cells) widest = std::max(widest, display_width(cell));
      headings.push_back(divided ? heading(column.name, widest) : std::array<std::string, 2>{"", column.name});
      for (const std::string& line : headings.back()) widest = std::max(widest, display_width(line));
      widths.push_back(widest);
      total += widest + 2;
    }
  }
  std::string text;
  const auto line = [&](const auto& cell_of) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const std::string& cell = cell_of(i);
      const std::string room(widths[i] - display_width(cell), ' ');
      text += "  " + (columns_[i].is_left ? cell + room : room + cell);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  };
  const auto any = [&](const auto& cell_of) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (!cell_of(i).empty()) return true;
    }
    return false;
  };
  const auto upper = [&](std::size_t i) -> const std::string& { return headings[i][0]; };
  const auto unit = [&](std::size_t i) -> const std::string& { return columns_[i].unit; };
  if (any(upper)) line(upper);
  line([&](std::size_t i) -> const std::string& { return headings[i][1]; });
  if (any(unit)) line(unit);
  text += "  ";
  for (std::size_t i = 2; i < total; ++i) {
    text += "─";
  }
  text += '\n';
  const std::size_t rows = columns_.empty() ? 0 : columns_.front().cells.size();
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t begin = text.size();
    line([&](std::size_t i) -> const std::string& { return columns_[i].cells.at(row); });
    if (row < marked_.size() && marked_[row]) text.replace(begin, 1, "►");
  }
  return text;
}

namespace {

/// The table of a list, the words of whose last column go on below one another where lines would be too long.
std::string list_text(const SaidTable& table) {
  constexpr std::size_t least_room = 16;
  const std::size_t last = table.columns.size() - 1;
  std::vector<std::vector<std::string>> cells(table.columns.size());
  std::size_t taken = 2;
  for (std::size_t i = 0; i < last; ++i) {
    std::size_t widest = display_width(table.columns[i].label);
    for (const std::string& cell : table.columns[i].cells) widest = std::max(widest, display_width(cell));
    taken += widest + 2;
  }
  const std::size_t width = std::min(usual_width, line_width());
  if (taken + least_room > width) {
    std::string text;
    for (const std::string& line : rows_in_words(table)) text += with_spaces(wrapped(line)) + "\n";
    return text;
  }
  for (std::size_t row = 0; row < table.columns[last].cells.size(); ++row) {
    const std::vector<std::string> lines = in_lines(table.columns[last].cells[row], width - taken, width - taken);
    for (std::size_t line = 0; line < lines.size(); ++line) {
      for (std::size_t i = 0; i < last; ++i) cells[i].push_back(line == 0 ? table.columns[i].cells.at(row) : "");
      cells[last].push_back(lines[line]);
    }
  }
  Table shown;
  for (std::size_t i = 0; i <= last; ++i) {
    const TableColumn& column = table.columns[i];
    shown.add(column.label, column.unit, std::move(cells[i]), !table.are_numbers[i]);
  }
  return shown.text();
}

}  // namespace

std::string table_text(const SaidTable& table) {
  if (table.is_list) return wrapped(table.heading) + "\n\n" + list_text(table);
  Table shown;
  for (const TableColumn& column : table.columns) shown.add(column.label, column.unit, column.cells);
  const std::string note = table.note.empty() ? "" : "\n" + wrapped(table.note) + "\n";
  return wrapped(table.heading) + "\n\n" + shown.text() + note;
}

}  // namespace bentur::cli
