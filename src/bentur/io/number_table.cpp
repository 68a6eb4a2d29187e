#include "bentur/io/number_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "bentur/core/number_text.h"
#include "bentur/core/text.h"
#include "bentur/io/records/internal/column_rows.h"

namespace bentur {
namespace {

using records::Line;
using records::Token;

Line before_comment(const Line& line) { return {line.text.substr(0, line.text.find('#')), line.number}; }

/// Its first cell is a word, and no number with a slip of the hand in it.
bool is_heading(const std::vector<Token>& cells, bool decimal_comma) {
  constexpr std::string_view of_numbers = "0123456789.,+-eEdDoOlI";
  const std::string_view first = cells.front().text;
  return !records::number_of(first, decimal_comma) && first.find_first_not_of(of_numbers) != std::string_view::npos;
}

/// A word and then nothing but numbers.
bool has_name(const std::vector<Token>& cells, bool decimal_comma) {
  const auto is_number = [&](const Token& cell) { return records::number_of(cell.text, decimal_comma).has_value(); };
  return cells.size() > 1 && is_heading(cells, decimal_comma) && std::all_of(cells.begin() + 1, cells.end(), is_number);
}

}  // namespace

std::optional<NumberTable> number_table(const std::string& text, const std::string& file, Diagnostics& diagnostics,
                                        std::vector<std::string>* names) {
  records::RecordErrors errors(file, diagnostics);
  const std::string plain = records::decoded(text);
  std::vector<Line> lines;
  for (const Line& line : records::lines_of(plain)) {
    const Line row = before_comment(line);
    if (!trimmed(row.text).empty()) lines.push_back(row);
  }
  records::ColumnRows shape;
  for (const char separator : {',', ';'}) {  // the latter where both occur
    const auto has = [&](const Line& line) { return line.text.find(separator) != std::string_view::npos; };
    if (std::any_of(lines.begin(), lines.end(), has)) shape.separator = separator;
  }
  shape.decimal_comma = shape.separator == ';';
  NumberTable table;
  for (const Line& line : lines) {
    if (errors.full()) break;
    std::vector<Token> cells = shape.cells(line);
    const bool is_named = names != nullptr && shape.separator != ' ' && has_name(cells, shape.decimal_comma);
    if (is_named && names->size() == table.rows.size()) {
      names->emplace_back(cells.front().text);
      cells.erase(cells.begin());
    }
    if (table.rows.empty() && errors.ok() && is_heading(cells, shape.decimal_comma)) continue;
    std::vector<double> row;
    for (const Token& cell : cells) {
      if (const auto value = records::finite_number(cell, shape.decimal_comma, errors)) row.push_back(*value);
    }
    if (row.size() < cells.size()) continue;                    // said
    if (names != nullptr && names->size() == 1 && !is_named) {  // "Elevation,1,2" was a heading
      table = {};
      names->clear();
    }
    if (names != nullptr && !names->empty() && !is_named) {
      errors.error(line, fmt::format("has no name, the row of line {} has one", table.lines.front()));
      continue;
    }
    if (!table.rows.empty() && row.size() != table.columns()) {
      errors.error(line, fmt::format("has {}, the row of line {} has {}", counted(row.size(), "column"),
                                     table.lines.front(), table.columns()));
      continue;
    }
    table.rows.push_back(std::move(row));
    table.lines.push_back(line.number);
  }
  if (errors.ok() && table.rows.empty()) errors.error("holds no numbers");
  if (!errors.ok()) return std::nullopt;
  return table;
}

std::optional<NumberTable> read_number_table(const std::filesystem::path& file, Diagnostics& diagnostics) {
  const auto text = read_input(file, table_input, diagnostics);
  return text ? number_table(*text, file.string(), diagnostics) : std::nullopt;
}

}  // namespace bentur
