// The headings of columns: which line has one for each, and what they say.

#include <algorithm>

#include "bentur/io/records/internal/column_rows.h"
#include "bentur/io/records/internal/components.h"
#include "bentur/io/records/internal/heading.h"

namespace bentur::records {
namespace {

constexpr std::size_t furthest_label_line = 10;  // above the first row

std::string_view without_mark(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of("#% \t"), text.size()));
  return text;
}

/// Words, each with the brackets behind it: "Time (s)  Acc (cm / s2)" is two.
std::vector<Token> bracketed_words(const Line& line) {
  std::vector<Token> words;
  for (const Token& word : words_of(line, " \t,;")) {
    const bool joins = !words.empty() && [&] {
      const std::string_view before = words.back().text;
      const auto open = [&](char a, char b) {
        return std::count(before.begin(), before.end(), a) > std::count(before.begin(), before.end(), b);
      };
      return open('(', ')') || open('[', ']') || word.text.front() == '(' || word.text.front() == '[';
    }();
    if (!joins) {
      words.push_back(word);
    } else {
      Token& last = words.back();
      last.text = {last.text.data(), static_cast<std::size_t>(word.text.data() + word.text.size() - last.text.data())};
    }
  }
  return words;
}

/// Between tabs, or two blanks and more.
std::vector<Token> wide_words(const Line& line) {
  std::vector<Token> words;
  std::size_t at = 0;
  while ((at = line.text.find_first_not_of(" \t", at)) != std::string_view::npos) {
    const std::size_t end = std::min({line.text.find("  ", at), line.text.find('\t', at), line.text.size()});
    words.push_back({line.text.substr(at, end - at), line.number, static_cast<int>(at) + 1});
    at = end;
  }
  return words;
}

ColumnLabel label_of(const Token& cell) {
  ColumnLabel label{.text = std::string(trimmed(cell.text)), .line = cell.line, .column = cell.column};
  const std::string text = folded(label.text);
  const std::size_t open = text.find_first_of("([");
  const std::size_t close = open == std::string::npos ? open : text.find(text[open] == '(' ? ')' : ']', open);
  std::string name = text.substr(0, open), unit;
  if (close != std::string::npos) unit = trimmed(std::string_view(text).substr(open + 1, close - open - 1));
  for (const char* const link : {"IN ", "EN "}) {  // "ACCEL (IN G)"
    if (unit.starts_with(link) && file_unit(unit.substr(3))) unit.erase(0, 3);
  }
  // "ACC_G", "TIME_MS", "ACC CM/S2": the unit is the last word.
  if (const std::size_t last = name.find_last_of(" _"); unit.empty() && last != std::string::npos) {
    const std::string word = name.substr(last + 1);
    if (file_unit(word) || seconds_of(word)) {
      unit = word;
      name.erase(last);
    }
  }
  label.fact = fact_of_label(trimmed(name));
  label.unit = file_unit(unit);
  if (const auto seconds = seconds_of(unit)) {
    label.seconds = *seconds;
    if (!label.fact) label.fact = Fact::time;
  }
  if (is_other_unit(unit) && (!label.fact || label.fact == Fact::acceleration)) label.fact = Fact::other;
  if (label.unit && !label.fact) label.fact = Fact::acceleration;  // "N-S(GAL)"
  return label;
}

/// A number, with a unit or without, or one thing that is said of all columns.
bool is_no_label(const ColumnLabel& label) {
  const std::string text = folded(label.text);
  std::size_t digits = 0;
  if (heading_number(text, false, digits)) {
    const std::string_view unit = trimmed(std::string_view(text).substr(digits));
    if (unit.empty() || seconds_of(unit) || is_rate_unit(unit) || file_unit(unit)) return true;
  }
  return number_of(label.text, true) || label.text.find_first_of("=:") < label.text.size() - 1;
}

bool is_known(const ColumnLabel& label) { return label.fact || is_direction(label.text); }

/// What a cell says that is a unit and nothing else, "(s)", "cm/s2"; nothing of other words.
std::optional<ColumnLabel> unit_alone(const Token& cell) {
  ColumnLabel label{.text = std::string(trimmed(cell.text)), .line = cell.line, .column = cell.column};
  const std::string unit = folded(trimmed(cell.text, " \t()[]"));
  label.unit = file_unit(unit);
  if (label.unit) {
    label.fact = Fact::acceleration;
  } else if (const auto seconds = seconds_of(unit)) {
    label.fact = Fact::time;
    label.seconds = *seconds;
  } else if (is_other_unit(unit)) {
    label.fact = Fact::other;
  } else {
    return std::nullopt;
  }
  return label;
}

/// The labels of a line of units, one of them of accelerations; empty where it is none.
std::vector<ColumnLabel> row_of_units(const std::vector<Token>& cells) {
  std::vector<ColumnLabel> labels;
  for (const Token& cell : cells) {
    const auto label = unit_alone(cell);
    if (!label) return {};
    labels.push_back(*label);
  }
  const bool any =
      std::any_of(labels.begin(), labels.end(), [](const ColumnLabel& one) { return one.unit.has_value(); });
  return any ? labels : std::vector<ColumnLabel>{};
}

/// Names, with the units of the line below them where they have none of their own.
std::vector<ColumnLabel> with_units(std::vector<ColumnLabel> names, const std::vector<ColumnLabel>& units) {
  if (names.size() != units.size()) return units;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!names[i].fact || names[i].fact == Fact::acceleration) names[i].fact = units[i].fact;
    if (!names[i].unit && units[i].unit) {
      names[i].unit = units[i].unit;
      names[i].unit_line = units[i].line;
    }
    if (names[i].seconds == 1) names[i].seconds = units[i].seconds;
  }
  return names;
}

}  // namespace

std::vector<ColumnLabel> column_labels(std::span<const Line> lines, std::size_t columns, char separator) {
  const std::size_t most = std::min(lines.size(), furthest_label_line);
  for (std::size_t i = lines.size(); i > lines.size() - most; --i) {
    std::string_view text = without_mark(lines[i - 1].text);
    const std::size_t colon = text.find(':');  // "Data: ..."
    if (colon != std::string_view::npos && colon + 1 < text.size()) text.remove_prefix(colon + 1);
    const Line line{text, lines[i - 1].number};
    std::vector<std::vector<Token>> ways;
    if (separator != ' ') ways.push_back(split_cells(line, separator));
    const std::size_t own_ways = ways.size();  // others may be prose: there all must be known
    for (const char other : {',', ';', '\t'}) ways.push_back(split_cells(line, other));
    ways.push_back(wide_words(line));
    ways.push_back(bracketed_words(line));
    for (std::size_t way = 0; way < ways.size(); ++way) {
      if (ways[way].size() != columns) continue;
      if (const auto units = row_of_units(ways[way]); !units.empty()) {
        return with_units(column_labels(lines.first(i - 1), columns, separator), units);
      }
      std::vector<ColumnLabel> labels;
      for (const Token& cell : ways[way]) labels.push_back(label_of(cell));
      if (std::any_of(labels.begin(), labels.end(), is_no_label)) continue;
      const auto known = static_cast<std::size_t>(std::count_if(labels.begin(), labels.end(), is_known));
      const bool last = i == lines.size() && columns > 1;
      if (way < own_ways ? known > 0 || last : known == columns) return labels;
    }
  }
  return {};
}

}  // namespace bentur::records
