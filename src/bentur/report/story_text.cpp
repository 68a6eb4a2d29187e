#include "bentur/report/story_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "bentur/core/number_text.h"
#include "bentur/core/text.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur {
namespace {

using Filled = std::vector<std::pair<std::string, std::string>>;

enum class Digits { shown, all };

std::string value_text(const StoryValue& value, const Words& say, Digits digits) {
  if (const auto* real = std::get_if<double>(&value.value)) {
    const std::string text = digits == Digits::all ? fmt::format("{}", *real) : number(*real);
    return value.unit.empty() ? text : text + "\u00A0" + value.unit;
  }
  if (const auto* count = std::get_if<long>(&value.value)) {
    const std::string key = "story.count." + value.name;
    return say.has(key + ".many") ? say.count(key, *count) : std::to_string(*count);
  }
  return std::get<std::string>(value.value);
}

/// Every value as a text; words are filled with the others, in the order in which they stand.
Filled filled(const std::vector<StoryValue>& values, const Words& say, Digits digits = Digits::shown) {
  Filled texts;
  for (const bool words : {false, true}) {
    for (const StoryValue& value : values) {
      if (value.is_word != words) continue;
      texts.emplace_back(value.name,
                         words ? say(std::get<std::string>(value.value), texts) : value_text(value, say, digits));
    }
  }
  return texts;
}

/// "a, b and c".
std::string joined(const std::vector<std::string>& parts, const Words& say) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += i == 0 ? "" : i + 1 == parts.size() ? " " + say("word.and") + " " : ", ";
    text += parts[i];
  }
  return text;
}

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  for (std::size_t from = 0; from <= row.size();) {
    const std::size_t to = std::min(row.find('|', from), row.size());
    cells.emplace_back(trimmed(std::string_view(row).substr(from, to - from)));
    from = to + 1;
  }
  return cells;
}

/// What fills a text about how many runs say something.
Filled filled(const Statement::OfMany& many, const Words& say) {
  return {{"count", std::to_string(many.count)},
          {"runs", say.count("story.count.records", many.runs)},
          {"worst", many.worst}};
}

/// The rows of a statement: one for each of its items, or one.
std::vector<std::vector<std::string>> rows_of(const Statement& statement, const std::string& key, const Words& say,
                                              Digits digits = Digits::shown) {
  const Filled values = filled(statement.values, say, digits);
  std::vector<std::vector<std::string>> rows;
  for (const auto& item : statement.items) {
    Filled all = filled(item, say, digits);
    all.insert(all.end(), values.begin(), values.end());
    rows.push_back(cells_of(say(key + ".row", all)));
  }
  if (rows.empty()) rows.push_back(cells_of(say(key + ".row", values)));
  if (statement.many) {
    for (auto& row : rows) row.push_back(say("story.row_of_many", filled(*statement.many, say)));
  }
  return rows;
}

/// Bytes of the first sentence of a text; of a long one those of its first clauses, not within brackets.
std::size_t first_sentence(std::string_view text) {
  constexpr std::size_t most = 180;
  const std::size_t stop = text.find(". ");
  const std::size_t end = stop == std::string_view::npos ? text.size() : stop + 1;
  if (end <= most) return end;
  std::size_t lead = end;
  int depth = 0;
  for (std::size_t at = 0; at < most; ++at) {
    depth += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
    const bool ends_clause = depth <= 0 && std::string_view(",;:").find(text[at]) != std::string_view::npos;
    if (ends_clause && at + 1 < text.size() && text[at + 1] == ' ') lead = at + 1;
  }
  return lead;
}

/// How a rule's wording is known, in the words of a language.
std::string wording_text(std::string text, const Words& say) {
  for (const auto& [english, key] :
       {std::pair("to check", "gap.to_check"), std::pair("second hand", "gap.second_hand"),
        std::pair("by memory", "gap.by_memory"), std::pair("read", "gap.read"),
        std::pair("in the 2010 edition", "gap.in_2010_edition"), std::pair("in paraphrase", "gap.in_paraphrase"),
        std::pair("steel", "gap.of_steel")}) {
    const std::size_t at = text.find(english);
    if (at != std::string::npos) text.replace(at, std::string_view(english).size(), say(key));
  }
  return text;
}

constexpr std::size_t how_much = 1;  // the cell of a row of what else is known

/// The number of a cell before its unit.
std::optional<double> number_of(const std::string& cell) {
  return parse_number(std::string_view(cell).substr(0, cell.find("\u00A0")));
}

/// How much the rows say, of cells that have all digits; NaN where that is no number.
std::vector<double> amounts_of(const std::vector<std::vector<std::string>>& rows) {
  std::vector<double> amounts;
  for (const auto& row : rows) amounts.push_back(row.size() > how_much ? number_of(row[how_much]).value_or(NAN) : NAN);
  return amounts;
}

/// Quantities of one unit with equally many decimals, as a column has them, where none loses more than one digit by it.
/// @param amounts of the cells, before they were rounded, so that none is rounded twice
void make_alike(std::vector<std::string>& cells, const std::vector<double>& amounts) {
  struct Quantity {
    std::size_t row;
    double value;
  };
  std::map<std::string, std::vector<Quantity>> by_unit;
  for (std::size_t row = 0; row < cells.size(); ++row) {
    const std::size_t end = std::min(cells[row].find("\u00A0"), cells[row].size());
    const bool is_plain = number_of(cells[row]).has_value();  // without a power of ten
    if (is_plain && std::isfinite(amounts[row])) by_unit[cells[row].substr(end)].push_back({row, amounts[row]});
  }
  for (const auto& [unit, all] : by_unit) {
    std::vector<double> values;
    for (const Quantity& one : all) values.push_back(one.value);
    const auto size = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto [least, most] = std::minmax_element(values.begin(), values.end(), size);
    if (std::abs(*most) > 10 * std::abs(*least)) continue;
    const std::vector<std::string> alike = column(values);
    for (std::size_t i = 0; i < all.size(); ++i) cells[all[i].row] = alike[i] + unit;
  }
}

}  // namespace

std::vector<SaidStatement> said(const std::vector<Statement>& statements, const Words& say) {
  std::vector<SaidStatement> all;
  for (const Statement& statement : statements) {
    const bool is_remark = statement.kind.starts_with("remark.");
    const std::string key = is_remark ? statement.kind : "story." + statement.kind;
    Filled values = filled(statement.values, say);
    std::vector<std::string> items;
    for (const auto& item : statement.items) items.push_back(say(key + ".item", filled(item, say)));
    values.emplace_back("items", joined(items, say));
    SaidStatement one{.kind = statement.kind,
                      .severity = statement.severity,
                      .gap = statement.gap,
                      .rank = statement.rank,
                      .is_open = is_open(statement.kind),
                      .shown = statement.shown};
    one.text = say(key, values);
    if (one.shown == Shown::row) {
      one.rows = rows_of(statement, key, say);
      one.amounts = amounts_of(rows_of(statement, key, say, Digits::all));
    }
    if (say.has(key + ".badge")) one.badge = say(key + ".badge");
    if (is_remark && statement.severity != Severity::remark) one.badge = say("remark.doubted");
    if (!statement.subject.empty()) {
      std::string subject = statement.subject;
      for (const auto& [name, text] : values) {
        if (name == "more") subject += say("remark.more", {{"n", text}});
      }
      one.text = subject + ": " + one.text;
    }
    if (statement.many) {
      const bool of_all = statement.many->count == statement.many->runs;
      Filled of_many = filled(*statement.many, say);
      of_many.emplace_back("text", one.text);
      one.text = say(of_all ? "story.under_all" : "story.under_some", of_many);
    }
    if (one.severity == Severity::danger || !one.badge.empty()) one.lead = first_sentence(one.text);
    all.push_back(std::move(one));
  }
  return all;
}

const char* verdict_tone(const std::vector<SaidStatement>& all) {
  const auto some = [&](const auto& holds) { return std::any_of(all.begin(), all.end(), holds); };
  if (!some([](const auto& one) { return is_grave(one.severity); })) return "clear";
  const auto is_worse = [](const auto& one) {
    return is_grave(one.severity) && !one.is_open && one.shown != Shown::row;
  };
  return some(is_worse) ? "pounds" : "open";
}

SaidTable said(const StoryTable& table, const Words& say) {
  SaidTable result{
      .heading = say("story.table." + table.kind, filled(table.values, say)), .columns = {}, .marked = table.marked};
  const std::string note = "story.table." + table.kind + ".note";
  if (say.has(note)) result.note = say(note, filled(table.values, say));
  const auto word = [&](const std::string& key) { return say.has(key) ? say(key) : key; };
  for (const StoryColumn& column : table.columns) {
    TableColumn shown{word(column.label), column.unit, {}};
    if (column.texts.empty()) {
      shown.cells = bentur::column(column.numbers, column.digits);
      shown.values = column.numbers;
    } else {
      for (const std::string& text : column.texts) {
        shown.cells.push_back(column.are_words                ? word(text)
                              : column.label == "gap.wording" ? wording_text(text, say)
                                                              : text);
      }
    }
    for (const std::size_t row : column.at_most) shown.cells.at(row).insert(0, "≤ ");
    result.are_numbers.push_back(column.texts.empty() || column.are_counts);
    result.columns.push_back(std::move(shown));
  }
  return result;
}

std::optional<SaidTable> known_table(const std::vector<std::string>& gaps, const std::vector<SaidStatement>& all,
                                     const Words& say) {
  constexpr std::size_t where = 2;
  SaidTable table{.heading = say("story.table.known"), .columns = {}, .is_list = true};
  std::size_t count = 0;
  std::vector<double> amounts;
  for (const SaidStatement& one : all) {
    amounts.insert(amounts.end(), one.amounts.begin(), one.amounts.end());
    for (std::vector<std::string> row : one.rows) {
      if (gaps.size() > 1 && one.gap) {
        const std::string& gap = gaps.at(static_cast<std::size_t>(*one.gap));
        row.at(where).insert(0, row.at(where).empty() ? gap : gap + ", ");
      }
      while (table.columns.size() < row.size()) {
        table.columns.push_back({say("known." + std::to_string(table.columns.size())), "", {}});
      }
      ++count;
      for (std::size_t i = 0; i < row.size(); ++i) {
        table.columns[i].cells.resize(count);
        table.columns[i].cells.back() = std::move(row[i]);
      }
    }
  }
  if (count == 0) return std::nullopt;
  for (TableColumn& column : table.columns) column.cells.resize(count);
  make_alike(table.columns[how_much].cells, amounts);
  table.are_numbers.resize(table.columns.size());
  table.are_numbers[1] = true;
  return table;
}

std::vector<std::string> rows_in_words(const SaidTable& table) {
  std::vector<std::string> lines(table.columns.front().cells.size());
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    for (std::size_t row = 0; row < lines.size(); ++row) {
      const std::string& cell = table.columns[i].cells[row];
      if (!cell.empty()) lines[row] += (i == 0 ? "" : i == 1 ? ": " : ", ") + cell;
    }
  }
  return lines;
}

namespace {

/// Whether a text has a name as a word of its own, not as a part of another: "B" is none of "By".
bool has_word(const std::string& text, const std::string& name) {
  const auto is_of_word = [&](std::size_t at) {
    const auto byte = static_cast<unsigned char>(text[at]);
    return std::isalnum(byte) != 0 || byte >= 0x80;
  };
  // A no-break space, U+00A0, is no letter.
  const auto is_letter = [&](std::size_t at) {
    const bool no_break = (at > 0 && text.compare(at - 1, 2, "\u00A0") == 0) || text.compare(at, 2, "\u00A0") == 0;
    return is_of_word(at) && !no_break;
  };
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !is_letter(at - 1)) && (end >= text.size() || !is_letter(end))) return true;
  }
  return false;
}

}  // namespace

std::string of_gap(const std::string& text, const std::string& gap, std::string shown) {
  if (shown.empty()) shown = gap;
  const std::size_t bar = gap.find(" | ");
  const bool is_named =
      bar != std::string::npos && has_word(text, gap.substr(0, bar)) && has_word(text, gap.substr(bar + 3));
  return is_named ? text : shown + ": " + text;
}

SaidStatement behind_gap(SaidStatement statement, const std::string& gap, const std::string& shown) {
  std::string text = of_gap(statement.text, gap, shown);
  if (statement.lead > 0) statement.lead += text.size() - statement.text.size();
  statement.text = std::move(text);
  return statement;
}

std::string with_spaces(std::string text) {
  constexpr std::string_view no_break = "\u00A0";
  for (std::size_t at = text.find(no_break); at != std::string::npos; at = text.find(no_break, at)) {
    text.replace(at, no_break.size(), " ");
  }
  return text;
}

std::string upper_case(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return text;
}

std::vector<std::string> story_lines(const std::vector<std::string>& gaps, const std::vector<SaidStatement>& all,
                                     const Words& say, Told told) {
  std::vector<std::string> lines;
  for (const SaidStatement& one : all) {
    if (told != Told::all && (one.severity == Severity::remark) != (told == Told::remarks)) continue;
    if (told != Told::remarks && one.shown != Shown::sentence) continue;
    std::string line = one.badge.empty() ? one.text : upper_case(one.badge) + ": " + one.text;
    if (gaps.size() > 1 && one.gap) line = of_gap(line, gaps.at(static_cast<std::size_t>(*one.gap)));
    if (one.kind.starts_with("remark.") && one.badge.empty()) line = say("cli.remark", {{"text", line}});
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace bentur
