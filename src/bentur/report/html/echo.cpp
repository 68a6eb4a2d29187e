#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/io/schema/table_view.h"
#include "bentur/report/html/internal/echo.h"

namespace bentur::html {
namespace {

using Kind = TomlValue::Kind;

constexpr std::size_t largest_matrix_shown = 12;
constexpr std::size_t most_numbers_shown = 200;  // of a list: a record has thousands

/// Whether what it has for each place makes a column of a table.
bool is_of_places(const Key& key) {
  return key.name == "elevations" || key.each == "one per storey" || key.each == "one per floor" ||
         key.each == "one per elevation" || key.each == "one per contact point";
}

bool is_list_of_numbers(const TomlValue& value) {
  return value.kind == Kind::list &&
         std::all_of(value.items.begin(), value.items.end(), [](const TomlValue& item) { return item.is_number(); });
}

std::vector<double> from_the_top(const TomlValue& list) {
  std::vector<double> values;
  for (const TomlValue& item : list.items) {
    values.insert(values.begin(), std::isinf(item.real) ? not_known : item.real);
  }
  return values;
}

class Echo {
 public:
  Echo(const Words& say, const Units& units, bool with_lines) : say_(say), units_(units), with_lines_(with_lines) {}

  /// @param of the name of the table, before those of its keys; empty: it needs none
  void add(const KeyTable& keys, const TomlValue& given, const std::string& of = {}) {
    std::vector<std::pair<const Key*, const TomlValue*>> columns;
    for (const Key& key : keys.keys) {
      if (broken_condition(key, keys, given) != nullptr) continue;
      const TomlValue* const value = given.find(std::string(key.name));
      if (value == nullptr) {
        add_default(key, given, of);
      } else if (is_of_places(key) && is_list_of_numbers(*value) && value->items.size() > 1 &&
                 (columns.empty() || columns.front().second->items.size() == value->items.size())) {
        columns.emplace_back(&key, value);
      } else {
        add_value(key, *value, given, of);
      }
    }
    if (columns.size() == 1) {
      add_value(*columns.front().first, *columns.front().second, given, of);
    } else if (!columns.empty()) {
      add_columns_of(columns, of);
    }
  }

  [[nodiscard]] Echoed made(const Rows& more) {
    rows_.insert(rows_.end(), more.begin(), more.end());
    for (const auto& [name, text] : more) in_a_row(name, "", text);
    if (rows_.empty()) return {tables_, std::move(row_)};
    lines_.resize(with_lines_ ? rows_.size() : 0);
    return {facts(rows_, lines_) + tables_, std::move(row_)};
  }

 private:
  [[nodiscard]] std::string label(const Key& key) const { return label_text(key.label, say_); }
  [[nodiscard]] std::string label(const Key& key, const std::string& of) const {
    return of.empty() ? label(key) : of + ": " + label(key);
  }

  [[nodiscard]] std::string text(const TomlValue& value, const Key& key) const {
    std::string joined;
    switch (value.kind) {
      case Kind::integer:
      case Kind::real:
        return std::isinf(value.real) ? "∞" : number(value.real);
      case Kind::boolean:
        return say_(value.boolean ? "word.yes" : "word.no");
      case Kind::text:
        return label_text(key.label_of(value.text), say_);
      case Kind::list:
        if (value.size() > most_numbers_shown && is_list_of_numbers(value)) {
          return say_("input.numbers", {{"count", std::to_string(value.size())}});
        }
        for (const TomlValue& item : value.items) joined += (joined.empty() ? "" : ", ") + text(item, key);
        return joined.empty() ? "–" : joined;
      default:
        return {};
    }
  }
  /// Empty where it has none.
  [[nodiscard]] std::string unit_of_value(const TomlValue& value, const Key& key, const TomlValue& given) const {
    const bool are_numbers = value.is_number() || (is_list_of_numbers(value) && !value.items.empty());
    if (!are_numbers) return {};
    const TomlValue* const stated = given.find(std::string(key.own_unit));  // "in `unit`"
    return stated != nullptr ? stated->text : unit_of(key, units_);
  }
  [[nodiscard]] std::string text_with_unit(const TomlValue& value, const Key& key, const TomlValue& given) const {
    const std::string unit = unit_of_value(value, key, given);
    return text(value, key) + (unit.empty() ? "" : "\u00A0" + unit);
  }

  /// "line 14", "lines 14–17": where values stand in the case; empty where that is not asked for or known.
  [[nodiscard]] std::string place(const std::vector<const TomlValue*>& values) const {
    int first = 0, last = 0;
    for (const TomlValue* const value : values) {
      if (value->origin != 0 || value->line == 0) return {};
      first = first == 0 ? value->line : std::min(first, value->line);
      last = std::max(last, value->line);
    }
    if (!with_lines_ || first == 0) return {};
    if (first == last) return say_("input.line", {{"line", std::to_string(first)}});
    return say_("input.lines", {{"first", std::to_string(first)}, {"last", std::to_string(last)}});
  }

  void add_row(const std::string& name, const std::string& text, const TomlValue& value) {
    lines_.resize(rows_.size());
    lines_.push_back(place({&value}));
    rows_.emplace_back(name, text);
  }
  void in_a_row(const std::string& name, const std::string& unit, const std::string& text, bool numeric = false) {
    row_.add(name, unit, std::vector<std::string>{text}, numeric);
  }
  void in_a_row(const std::string& name, const TomlValue& value, const Key& key, const TomlValue& given) {
    in_a_row(name, unit_of_value(value, key, given), text(value, key), value.is_number());
  }

  void add_default(const Key& key, const TomlValue& given, const std::string& of) {
    const auto has = [&](std::string_view name) { return given.find(std::string(name)) != nullptr; };
    if (key.need != Need::optional || (!key.with.empty() && !has(key.with))) return;
    TomlValue value;
    if (key.kind == Key::Kind::choice && key.otherwise.empty() && key.group.empty()) {
      value = toml_text(std::string(key.words.front()));
    } else if (key.kind == Key::Kind::flag && key.default_value == 1.0) {
      value.kind = Kind::boolean;
      value.boolean = true;
    } else if (key.kind == Key::Kind::number && key.group.empty() && key.default_value.value_or(0) != 0) {
      value = toml_number(*key.default_value);
    } else {
      return;
    }
    const std::string text = say_("input.default", {{"value", text_with_unit(value, key, given)}});
    rows_.emplace_back(label(key, of), text);
    in_a_row(label(key, of), "", text);
  }

  void add_value(const Key& key, const TomlValue& value, const TomlValue& given, const std::string& of) {
    const bool is_list = value.kind == Kind::list && !value.items.empty();
    if (key.kind == Key::Kind::by_building) {
      for (const TomlMember& member : value.members) {
        add_row(label(key) + ", " + member.key, text_with_unit(member.value, key, given), member.value);
        in_a_row(label(key) + ", " + member.key, member.value, key, given);
      }
    } else if (value.kind == Kind::table && key.table != nullptr) {
      add(*key.table, value, label(key));
    } else if (is_list && key.table != nullptr) {
      add_tables(key, value);
    } else if (is_list && value.items.front().kind == Kind::list) {
      add_matrix(label(key, of), unit_of(key, units_), value);
    } else {
      add_row(label(key, of), text_with_unit(value, key, given), value);
      const bool is_named_there = key.name == "name" || key.name == "between";  // by the first column
      if (!is_named_there) in_a_row(label(key, of), value, key, given);
    }
  }

  void add_columns_of(const std::vector<std::pair<const Key*, const TomlValue*>>& columns, const std::string& of) {
    HtmlTable table;
    const auto is_elevations = [](const auto& column) { return column.first->name == "elevations"; };
    if (std::none_of(columns.begin(), columns.end(), is_elevations)) {
      const bool storeys = columns.front().first->each == "one per storey";
      table.add(storeys ? say_("column.storey") : "", "", numbers_from_the_top(columns.front().second->items.size()));
    }
    std::vector<const TomlValue*> values;
    for (const auto& [key, value] : columns) {
      table.add(label(*key), unit_of(*key, units_), from_the_top(*value));
      in_a_row(label(*key, of), unit_of(*key, units_), text(*value, *key));
      values.push_back(value);
    }
    add_table(of, table, values);
  }

  /// A list of tables, a row for each: of storeys and floors from the top, of others in their order.
  void add_tables(const Key& key, const TomlValue& list) {
    if (list.items.size() == 1) return add(*key.table, list.items.front(), label(key));
    const bool from_top = key.each.find("storey") != key.each.npos || key.each.find("floor") != key.each.npos;
    std::vector<const TomlValue*> rows;
    std::vector<std::string> numbers;
    for (const TomlValue& item : list.items) {
      rows.insert(from_top ? rows.begin() : rows.end(), &item);
      numbers.insert(from_top ? numbers.begin() : numbers.end(), std::to_string(rows.size()));
    }
    HtmlTable table;
    table.add("", "", numbers);
    for (const Key& one : key.table->keys) {
      bool given = false, numeric = true;
      std::vector<std::string> cells;
      for (const TomlValue* row : rows) {
        const TomlValue* const value = row->find(std::string(one.name));
        cells.push_back(value != nullptr ? text(*value, one) : "–");
        given = given || value != nullptr;
        numeric = numeric && (value == nullptr || value->is_number());
      }
      if (!given) continue;
      std::vector<std::string> in_order = cells;
      if (from_top) std::reverse(in_order.begin(), in_order.end());
      in_a_row(label(one, label(key)), unit_of(one, units_), fmt::format("{}", fmt::join(in_order, ", ")));
      table.add(label(one), unit_of(one, units_), std::move(cells), numeric);
    }
    add_table(label(key), table, rows);
  }

  void add_matrix(const std::string& name, const std::string& unit, const TomlValue& list) {
    const std::size_t columns = list.items.front().items.size();
    if (list.items.size() > largest_matrix_shown || columns > largest_matrix_shown) {
      const std::string size = fmt::format("{} × {}", list.items.size(), columns);
      add_row(name, size, list);
      in_a_row(name, "", size);
      return;
    }
    HtmlTable table;
    std::string in_lines;
    for (std::size_t j = 0; j < columns; ++j) {
      std::vector<double> values;
      for (const TomlValue& row : list.items) values.push_back(row.items.at(j).real);
      table.add(std::to_string(j + 1), "", values);
    }
    for (const TomlValue& row : list.items) {
      if (!in_lines.empty()) in_lines += "; ";
      for (const TomlValue& one : row.items) in_lines += (&one == row.items.data() ? "" : ", ") + number(one.real);
    }
    in_a_row(name, unit, in_lines);
    add_table(unit.empty() ? name : fmt::format("{} [{}]", name, unit), table, {&list});
  }

  void add_table(const std::string& name, const HtmlTable& table, const std::vector<const TomlValue*>& values) {
    const std::string at = place(values);
    const std::string title = name.empty() || at.empty() ? name + at : name + ", " + at;
    tables_ += title.empty() ? table.markup() : under("h4", title, table);
  }

  const Words& say_;
  const Units& units_;
  const bool with_lines_;
  Rows rows_;
  std::vector<std::string> lines_;  ///< of the rows, where each stands
  Html tables_;
  HtmlTable row_;
};

}  // namespace

std::vector<std::string> numbers_from_the_top(std::size_t count) {
  std::vector<std::string> numbers;
  for (std::size_t i = count; i > 0; --i) numbers.push_back(std::to_string(i));
  return numbers;
}

std::string unit_of(const Key& key, const Units& units) {
  if (!key.own_unit.empty()) return std::string(key.own_unit);
  return key.dimension == dimension::mass ? mass_unit(units) : key.dimension.text(units.length, units.force);
}

Echoed echo(const KeyTable& keys, const TomlValue& given, const Words& say, const Units& units, bool with_lines,
            const Rows& more) {
  Echo of_case(say, units, with_lines);
  of_case.add(keys, given);
  return of_case.made(more);
}

}  // namespace bentur::html
