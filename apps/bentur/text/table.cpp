#include "text/table.h"

#include <algorithm>
#include <utility>

#include "bentur/report/utf8.h"

namespace bentur::cli {

std::string wrapped(const std::string& text) {
  constexpr std::size_t widest = 100;
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

void Table::add(std::string name, std::string unit, std::vector<std::string> cells) {
  columns_.push_back({std::move(name), std::move(unit), std::move(cells)});
}

void Table::add(std::string name, std::string unit, const std::vector<double>& values) {
  add(std::move(name), std::move(unit), column(values));
}

std::string Table::text() const {
  std::vector<std::size_t> widths;
  std::size_t total = 0;
  for (const Column& column : columns_) {
    std::size_t widest = std::max(display_width(column.name), display_width(column.unit));
    for (const std::string& cell : column.cells) {
      widest = std::max(widest, display_width(cell));
    }
    widths.push_back(widest);
    total += widest + 2;
  }
  std::string text;
  const auto line = [&](const auto& cell_of) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const std::string& cell = cell_of(columns_[i]);
      text += std::string(2 + widths[i] - display_width(cell), ' ') + cell;
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  };
  line([](const Column& column) -> const std::string& { return column.name; });
  if (std::any_of(columns_.begin(), columns_.end(), [](const Column& column) { return !column.unit.empty(); })) {
    line([](const Column& column) -> const std::string& { return column.unit; });
  }
  text += "  ";
  for (std::size_t i = 2; i < total; ++i) {
    text += "─";
  }
  text += '\n';
  const std::size_t rows = columns_.empty() ? 0 : columns_.front().cells.size();
  for (std::size_t row = 0; row < rows; ++row) {
    line([row](const Column& column) -> const std::string& { return column.cells.at(row); });
  }
  return text;
}

}  // namespace bentur::cli
