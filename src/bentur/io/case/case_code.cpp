#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "bentur/io/case/case_parts.h"

namespace bentur {
namespace {

/// true or false for all gaps, or a list with one for each.
std::optional<std::vector<bool>> read_flags(const TomlView& value, std::size_t gaps) {
  if (!value.is(TomlValue::Kind::list)) {
    const auto flag = value.as_flag();
    return flag ? std::optional(std::vector<bool>(gaps, *flag)) : std::nullopt;
  }
  if (!value.is_list_of("true or false", {gaps, "one per gap"})) return std::nullopt;
  std::vector<bool> flags;
  for (const TomlView& one : value.items()) flags.push_back(one.as_flag().value_or(false));
  return flags;
}

void read_words(const TomlView& value, const CodeKey& key, const Length& length, CodeRuleSpec& spec) {
  const std::vector<std::string> known(key.words.begin(), key.words.end());
  std::vector<std::string>& words = spec.words[std::string(key.name)];
  if (!value.is(TomlValue::Kind::list)) {
    words.push_back(value.as_word(known).value_or(known.front()));
  } else if (value.is_list_of("words", length)) {
    for (const TomlView& one : value.items()) words.push_back(one.as_word(known).value_or(known.front()));
  }
}

void read_key(const TomlView& value, const CodeKey& key, std::size_t buildings, CodeRuleSpec& spec) {
  const std::string name(key.name);
  const Length length{buildings, "one per building"};
  switch (key.kind) {
    case CodeKey::Kind::factor:
      if (auto numbers = value.as_number_or_numbers(Rule::positive, length); !numbers.empty())
        spec.numbers[name] = std::move(numbers);
      break;
    case CodeKey::Kind::whole:
      if (const auto number = value.as_number(Rule::finite)) {
        if (*number < key.from || *number > key.to || *number != std::floor(*number)) {
          value.error_value(fmt::format("must be a whole number from {} to {}", key.from, key.to));
        }
        spec.numbers[name] = {*number};
      }
      break;
    case CodeKey::Kind::word:
      if (const auto word = value.as_word({key.words.begin(), key.words.end()})) spec.words[name] = {*word};
      break;
    case CodeKey::Kind::building_word:
      read_words(value, key, length, spec);
      break;
    case CodeKey::Kind::flag:
      spec.flags[name] = value.as_flag().value_or(false);
      break;
  }
}

CodeRuleSpec read_rule(const TomlView& table, const CodeRule& rule, std::size_t buildings) {
  CodeRuleSpec spec{.rule = std::string(rule.name)};
  std::vector<std::string> keys;
  for (const CodeKey& key : rule.keys) keys.emplace_back(key.name);
  if (!table.is_table_of(keys)) return spec;
  for (const CodeKey& key : rule.keys) {
    const bool optional = key.kind == CodeKey::Kind::flag;
    const auto value = table.get(std::string(key.name), optional ? Need::optional : Need::required);
    if (value) read_key(*value, key, buildings, spec);
  }
  return spec;
}

}  // namespace

CodeSpec read_code(const TomlView& root, const std::vector<ReadBuilding>& buildings) {
  CodeSpec code;
  const auto view = root.find("code");
  if (!view) return code;
  std::vector<std::string> rules;
  for (const CodeRule& rule : code_rules()) rules.emplace_back(rule.name);
  std::vector<std::string> known = rules;
  known.insert(known.end(), {"floors_aligned", "same_owner"});
  if (!view->is_table_of(known)) return code;
  const std::size_t gaps = buildings.empty() ? 0 : buildings.size() - 1;
  if (const auto aligned = view->find("floors_aligned")) code.floors_aligned = read_flags(*aligned, gaps);
  if (const auto owner = view->find("same_owner")) {
    code.same_owner = read_flags(*owner, gaps).value_or(std::vector<bool>{});
  }
  for (const CodeRule& rule : code_rules()) {
    if (const auto table = view->find(std::string(rule.name))) {
      code.rules.push_back(read_rule(*table, rule, buildings.size()));
    }
  }
  if (code.rules.empty()) view->error(fmt::format("names no rule, there are {}", fmt::join(rules, ", ")));
  return code;
}

}  // namespace bentur
