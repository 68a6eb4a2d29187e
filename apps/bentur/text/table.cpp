#include "text/table.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
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

std::string wrapped(const std::string& text) {
  const std::size_t widest = std::min(usual_width, line_width());
  std::string result;
  std::size_t taken = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    if (taken > 0 && taken + 1 + display_width(word) > widest) {
      result += "\n  ";
      taken = 2;
    } else if (at > 0) {
      result += ' ';
      ++taken;
    }
    result += word;
    taken += display_width(word);
    at = end + 1;
  }
  return result;
}

std::string fitted(const std::string& text) {
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

void Table::add(std::string name, std::string unit, std::vector<std::string> cells) {
  columns_.push_back({std::move(name), std::move(unit), std::move(cells)});
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
  std::string text;
  Table part;
  for (const Column& column : columns_) {
    Table longer = part;
    longer.columns_.push_back(column);
    if (part.columns_.size() > 1 && longer.least_width_needed() > width) {
      text += part.in_one(width) + "\n";
      part.columns_ = {columns_.front()};  // which says what the rows are
      part.columns_.push_back(column);
    } else {
      part = std::move(longer);
    }
  }
  return text + part.in_one(width);
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
      text += std::string(2 + widths[i] - display_width(cell), ' ') + cell;
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
    line([&](std::size_t i) -> const std::string& { return columns_[i].cells.at(row); });
  }
  return text;
}

std::string table_text(const SaidTable& table) {
  Table shown;
  for (const TableColumn& column : table.columns) shown.add(column.label, column.unit, column.cells);
  return wrapped(table.heading) + "\n\n" + shown.text();
}

}  // namespace bentur::cli
