#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "bentur/io/case/case_parts.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"

namespace bentur {
namespace {

/// One for all gaps, or a list with one for each. @param read of one value, nothing where it is wrong
template <class Read>
auto read_for_gaps(const TomlView& value, std::size_t gaps, std::string_view of, const Read& read)
    -> std::optional<std::vector<typename decltype(read(value))::value_type>> {
  using One = typename decltype(read(value))::value_type;
  if (!value.is(TomlValue::Kind::list)) {
    const auto one = read(value);
    return one ? std::optional(std::vector<One>(gaps, *one)) : std::nullopt;
  }
  if (gaps == 0 || !value.is_list_of(std::string(of), {gaps, "one per gap"})) return std::nullopt;
  std::vector<One> all;
  for (const TomlView& item : value.items()) all.push_back(read(item).value_or(One{}));
  return all;
}

/// What stands in a gap: true, no line; false, a property line; or a word.
std::optional<Boundary> read_boundary(const TomlView& value) {
  if (value.is(TomlValue::Kind::boolean)) {
    return value.value().boolean ? Boundary::one_owner : Boundary::property_line;
  }
  if (value.is(TomlValue::Kind::text) && value.value().text == "public-way") return Boundary::public_way;
  return value.error_value("must be true, false or \"public-way\"");
}

void read_words(const TomlView& value, const Key& key, const Length& length, CodeRuleSpec& spec) {
  const std::vector<std::string> known(key.words.begin(), key.words.end());
  std::vector<std::string>& words = spec.words[std::string(key.name)];
  if (!value.is(TomlValue::Kind::list)) {
    words.push_back(value.as_word(known).value_or(known.front()));
  } else if (value.is_list_of("words", length)) {
    for (const TomlView& one : value.items()) words.push_back(one.as_word(known).value_or(known.front()));
  }
}

/// In g: a bare number, or a text with its unit.
std::optional<double> read_in_g(const TomlView& value, const Units& units) {
  if (!value.is(TomlValue::Kind::text)) return value.as_number(Range::positive);
  const auto acceleration = read_acceleration(value, units);
  return acceleration ? std::optional(*acceleration / units.gravity) : std::nullopt;
}

void read_key(const TomlView& value, const Key& key, std::size_t buildings, const Units& units, CodeRuleSpec& spec) {
  const std::string name(key.name);
  const Length length{buildings, std::string(key.each)};
  if (key.kind == Key::Kind::number) {
    if (auto numbers = value.as_number_or_numbers(key.range, length); !numbers.empty())
      spec.numbers[name] = std::move(numbers);
  } else if (key.kind == Key::Kind::quantity) {
    if (const auto number = read_in_g(value, units)) spec.numbers[name] = {*number};
  } else if (key.kind == Key::Kind::whole) {
    if (const auto number = value.as_number(Range::finite)) {
      if (*number < static_cast<double>(key.least) || *number > static_cast<double>(key.most) ||
          *number != std::floor(*number)) {
        value.error_value(fmt::format("must be a whole number from {} to {}", key.least, key.most));
      }
      spec.numbers[name] = {*number};
    }
  } else if (key.kind == Key::Kind::flag) {
    spec.flags[name] = value.as_flag().value_or(false);
  } else if (key.form == Key::Form::one_or_list) {
    read_words(value, key, length, spec);
  } else if (const auto word = value.as_word({key.words.begin(), key.words.end()})) {
    spec.words[name] = {*word};
  }
}

CodeRuleSpec read_rule(const TableView& table, std::size_t buildings, const Units& units) {
  CodeRuleSpec spec{.rule = std::string(table.keys().name)};
  for (const Key& key : table.keys().keys) {
    const bool counts = broken_condition(key, table.keys(), table.value()) == nullptr;
    if (!counts && !table.has(std::string(key.name))) continue;
    if (const auto value = table.get(key.name)) read_key(*value, key, buildings, units, spec);
  }
  return spec;
}

}  // namespace

CodeSpec read_code(const TomlView& root, const Units& units, std::size_t buildings, std::size_t gaps) {
  CodeSpec code;
  const auto view = TableView(root, case_keys()).table("code");
  if (!view) return code;
  if (const auto aligned = view->find("floors_aligned")) {
    code.floors_aligned =
        read_for_gaps(*aligned, gaps, "true or false", [](const TomlView& value) { return value.as_flag(); });
  }
  if (const auto owner = view->find("same_owner")) {
    code.boundaries = read_for_gaps(*owner, gaps, "true, false or \"public-way\"", &read_boundary);
  }
  std::vector<std::string_view> rules;
  bool any = false;
  for (const CodeRule& rule : code_rules()) {
    rules.push_back(rule.name);
    if (!view->has(std::string(rule.name))) continue;
    any = true;
    if (const auto table = view->table(rule.name)) {
      code.rules.push_back(read_rule(*table, buildings, units));
    } else {
      code.rules.push_back({.rule = std::string(rule.name)});
    }
  }
  if (!any) view->error(fmt::format("names no rule, there are {}", fmt::join(rules, ", ")));
  return code;
}

}  // namespace bentur
