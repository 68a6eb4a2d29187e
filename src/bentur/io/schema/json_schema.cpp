#include "bentur/io/schema/json_schema.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bentur/core/units.h"

namespace bentur {
namespace {

using Schema = nlohmann::ordered_json;

constexpr std::int64_t without_end = 1000000;  // a whole number that may be so large has no end worth telling

Schema schema_of_table(const KeyTable& table);

std::string quoted_words(const std::vector<std::string_view>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += i == 0 ? "" : i + 1 == words.size() ? " or " : ", ";
    text += fmt::format("`\"{}\"`", words[i]);
  }
  return text;
}

/// "> 0 [length]" of a number.
std::string number_words(const Key& key) {
  const std::string unit = key.own_unit.empty() ? key.dimension.text() : std::string(key.own_unit);
  std::string text(range_text(key.range));
  if (!unit.empty()) text += (text.empty() ? "[" : " [") + unit + "]";
  return text;
}

/// A small table by its keys, with what each takes where they are all numbers.
std::string table_text(const KeyTable& table) {
  if (table.keys.size() > 5) return "table";
  std::vector<std::string> numbers;
  for (const Key& key : table.keys) {
    const std::string words = number_words(key);
    if (key.kind == Key::Kind::number && !words.empty()) numbers.push_back(words);
  }
  const std::string names = fmt::format("`{{ {} }}`", fmt::join(table.names(), ", "));
  return numbers.size() < table.keys.size() ? names : fmt::format("{} ({})", names, fmt::join(numbers, "; "));
}

std::string one_value_text(const Key& key) {
  switch (key.kind) {
    case Key::Kind::number:
    case Key::Kind::by_building:
      return number_words(key);
    case Key::Kind::quantity:
      return number_words(key) + ", or a text with its unit, `\"0.35 g\"`";
    case Key::Kind::whole:
      return key.most < without_end ? fmt::format("whole number, {} to {}", key.least, key.most)
                                    : fmt::format("whole number ≥ {}", key.least);
    case Key::Kind::flag:
      return "`true` or `false`";
    case Key::Kind::text:
      return "text";
    case Key::Kind::line:
      return "text of one line";
    case Key::Kind::file:
      return "name of a file";
    case Key::Kind::choice:
      return quoted_words(key.words);
    case Key::Kind::table:
      return table_text(*key.table);
    case Key::Kind::any:
      break;
  }
  return "";
}

/// Markdown as plain text.
std::string plain_text(const std::string& markdown) {
  std::string plain;
  for (std::size_t i = 0; i < markdown.size(); ++i) {
    if (markdown[i] == '`') continue;
    if (markdown[i] == ']' && i + 1 < markdown.size() && markdown[i + 1] == '(') {  // [text](target)
      const std::size_t open = plain.rfind('[');
      if (open != std::string::npos) plain.erase(open, 1);
      i = markdown.find(')', i);
      continue;
    }
    plain += markdown[i];
  }
  return plain;
}

/// A number > 0 with a unit of acceleration.
std::string quantity_pattern() {
  return fmt::format("^[ \\t]*[0-9.][0-9.eE+-]*[ \\t]*({}|gal|Gal)[ \\t]*$", fmt::join(acceleration_units(), "|"));
}

Schema one_number(const Key& key) {
  if (key.kind == Key::Kind::whole) return {{"type", "integer"}, {"minimum", key.least}, {"maximum", key.most}};
  Schema number = {{"type", "number"}};
  const Bounds bounds = bounds_of(key.range);
  if (bounds.least) number["minimum"] = *bounds.least;
  if (bounds.least_excluded) number["exclusiveMinimum"] = true;
  if (bounds.most) number["maximum"] = *bounds.most;
  if (bounds.most_excluded) number["exclusiveMaximum"] = true;
  if (key.range == Range::not_zero) number["not"] = {{"enum", {0}}};
  return number;
}

Schema one_value(const Key& key) {
  switch (key.kind) {
    case Key::Kind::number:
    case Key::Kind::by_building:
    case Key::Kind::whole:
      return one_number(key);
    case Key::Kind::quantity:
      return {{"anyOf", {one_number(key), {{"type", "string"}, {"pattern", quantity_pattern()}}}}};
    case Key::Kind::flag:
      return {{"type", "boolean"}};
    case Key::Kind::text:
    case Key::Kind::file:
      return {{"type", "string"}};
    case Key::Kind::line:
      return {{"type", "string"}, {"pattern", key.may_be_empty ? "^[^\\x00-\\x1f\\x7f]*$" : "^[^\\x00-\\x1f\\x7f]+$"}};
    case Key::Kind::choice:
      return {{"enum", key.words}};
    case Key::Kind::table:
      return schema_of_table(*key.table);
    case Key::Kind::any:
      break;
  }
  return Schema::object();
}

Schema list_of_items(const Key& key, const Schema& item) {
  Schema list = {{"type", "array"}, {"items", item}};
  const auto least = key.count > 0                  ? static_cast<std::int64_t>(key.count)
                     : key.may_be_empty             ? 0
                     : key.kind == Key::Kind::table ? std::max<std::int64_t>(key.least, 1)
                                                    : 1;
  if (least > 0) list["minItems"] = least;
  if (key.count > 0) list["maxItems"] = key.count;
  if (key.most > 0) list["maxItems"] = key.most;
  return list;
}

/// All that the values of a key have in common, whatever it means.
Schema schema_of_value(const Key& key) {
  Schema one = one_value(key);
  if (key.kind == Key::Kind::file && key.table != nullptr) one = {{"anyOf", {one, schema_of_table(*key.table)}}};
  Schema list = list_of_items(key, one);
  std::vector<Schema> ways;
  if (key.kind == Key::Kind::by_building) {
    // Of buildings in plan three numbers a floor.
    Schema floor = {{"type", "array"}, {"items", one}, {"minItems", 3}, {"maxItems", 3}};
    const Schema in_plan = list_of_items(key, floor);
    ways.push_back({{"type", "object"}, {"additionalProperties", {{"anyOf", {list, in_plan}}}}});
  } else if (key.form == Key::Form::matrix) {
    ways.push_back(list_of_items(key, list_of_items(key, one)));
    if (key.or_diagonal) ways.push_back(list);
  } else {
    if (key.form != Key::Form::list) ways.push_back(one);
    if (key.form != Key::Form::one) ways.push_back(list);
    if (key.kind != Key::Kind::choice && key.kind != Key::Kind::any && !key.words.empty()) {
      ways.push_back({{"enum", key.words}});
    }
    const bool takes_table = key.kind == Key::Kind::number || key.kind == Key::Kind::choice;
    if (takes_table && key.table != nullptr) ways.push_back(schema_of_table(*key.table));
  }
  if (ways.size() == 1) return ways.front();
  return {{"anyOf", ways}};
}

Schema told_of(const Key& key) {
  // In the order of Key::Kind and Key::Form.
  static constexpr const char* kinds[] = {"number", "quantity", "whole", "flag",        "text", "line",
                                          "file",   "choice",   "table", "by_building", "any"};
  static constexpr const char* forms[] = {"one", "list", "one_or_list", "matrix"};
  Schema told = {{"kind", kinds[static_cast<std::size_t>(key.kind)]},
                 {"form", forms[static_cast<std::size_t>(key.form)]},
                 {"label", {{"en", key.label.english}, {"id", key.label.indonesian}}},
                 {"value", value_text(key)},
                 {"doc", key.doc},
                 {"need", key.need == Need::required   ? "required"
                          : key.need == Need::optional ? "optional"
                                                       : "one_of"}};
  if (key.kind <= Key::Kind::whole || key.kind == Key::Kind::by_building) told["number"] = one_number(key);
  if (const std::string without = default_text(key); !without.empty()) told["default"] = without;
  if (key.dimension != dimension::none) told["dimension"] = key.dimension.form();
  if (!key.each.empty() && key.count == 0) told["each"] = key.each;
  const std::string own_unit(key.own_unit), unit = key.dimension.text("length", "force");
  if (!own_unit.empty() || !unit.empty()) told["unit"] = own_unit.empty() ? unit : own_unit;
  if (!key.words.empty()) told["words"] = key.words;
  if (!key.word_docs.empty()) told["word_docs"] = key.word_docs;
  if (key.table != nullptr) told["table"] = key.table->title;
  if (!key.group.empty()) told["group"] = key.group;
  if (!key.with.empty()) told["with"] = key.with;
  for (const Condition& condition : key.conditions) told["when"][std::string(condition.key)] = condition.words;
  return told;
}

std::string description_of(const Key& key) {
  std::string text = value_text(key);
  if (!key.doc.empty()) text += (text.empty() ? "" : ": ") + std::string(key.doc);
  if (const std::string without = default_text(key); !without.empty()) {
    text += (without.starts_with("needed") ? "; " : "; default ") + without;
  }
  for (std::size_t i = 0; i < key.word_docs.size(); ++i)
    text += fmt::format("\n{}: {}", key.words[i], key.word_docs[i]);
  return plain_text(text);
}

/// One property, of all keys of its name.
Schema schema_of_name(const KeyTable& table, const std::string& name) {
  std::vector<Schema> values, told;
  std::string title, description;
  for (const Key& key : table.keys) {
    if (key.name != name) continue;
    if (title.empty()) title = key.label.english;
    if (const std::string text = description_of(key); description.find(text) == std::string::npos) {
      description += (description.empty() ? "" : "\n\n") + text;
    }
    Schema value = schema_of_value(key);
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(std::move(value));
    told.push_back(told_of(key));
  }
  Schema schema = {{"title", title}, {"description", description}};
  const Schema value = values.size() == 1 ? values.front() : Schema{{"anyOf", values}};
  for (const auto& [keyword, said] : value.items()) {
    if (!schema.contains(keyword)) schema[keyword] = said;
  }
  const Key& first = table.at(name);
  if (first.default_value && told.size() == 1) {
    schema["default"] =
        first.kind == Key::Kind::flag ? Schema(*first.default_value != 0) : Schema(*first.default_value);
  } else if (first.kind == Key::Kind::choice && first.need == Need::optional && first.otherwise.empty()) {
    schema["default"] = first.words.front();
  }
  schema["x-bentur"] = told;
  return schema;
}

Schema all_given(const std::vector<std::string>& names) { return {{"required", names}}; }

/// Adds what keys of one table say of one another: those of a group, as far as `counts`.
template <class Counts>
void add_groups(const KeyTable& table, const Counts& counts, std::vector<Schema>& rules) {
  std::vector<std::string_view> groups;
  for (const Key& key : table.keys) {
    const bool is_new = std::find(groups.begin(), groups.end(), key.group) == groups.end();
    if (!key.group.empty() && counts(key) && is_new) groups.push_back(key.group);
  }
  for (const std::string_view group : groups) {
    std::vector<std::string> names;
    bool needed = false;
    for (const Key& key : table.keys) {
      if (key.group != group || !counts(key)) continue;
      needed = needed || key.need == Need::one_of;
      if (std::find(names.begin(), names.end(), key.name) == names.end()) names.emplace_back(key.name);
    }
    if (needed) {
      Schema one_of = Schema::array();
      for (const std::string& name : names) {
        Schema alone = all_given({name});
        Schema joining = Schema::array();  // both together count as the one that joins
        for (const Key& key : table.keys) {
          if (key.group == group && key.beside == name) joining.push_back(all_given({std::string(key.name)}));
        }
        if (!joining.empty()) alone["not"] = {{"anyOf", joining}};
        one_of.push_back(alone);
      }
      rules.push_back({{"oneOf", one_of}});
    } else {
      for (std::size_t i = 0; i + 1 < names.size(); ++i)
        rules.push_back({{"not", all_given({names[i], names[i + 1]})}});
    }
  }
}

std::vector<std::string_view> words_of(const Key& by) {
  return by.kind == Key::Kind::flag ? std::vector<std::string_view>{"false", "true"} : by.words;
}

/// Whether there is a key of this name whatever the words of others are.
bool is_always(const KeyTable& table, const Key& key) {
  return std::all_of(key.conditions.begin(), key.conditions.end(), [&](const Condition& condition) {
    return table.owners(key.name, condition.key).size() == words_of(table.at(condition.key)).size();
  });
}

/// Whether it is needed whatever the words of others are.
bool is_always_required(const KeyTable& table, const Key& key) {
  return is_always(table, key) && std::all_of(table.keys.begin(), table.keys.end(), [&](const Key& one) {
           return one.name != key.name || one.is_required();
         });
}

/// Whether it is of its group whatever the words of others are.
bool is_always_in_group(const KeyTable& table, const Key& key) {
  return is_always(table, key) && std::all_of(table.keys.begin(), table.keys.end(), [&](const Key& one) {
           return one.name != key.name || one.group == key.group;
         });
}

/// What holds for each word of a key that others depend on.
Schema schema_of_words(const KeyTable& table, const Key& by) {
  const bool is_flag = by.kind == Key::Kind::flag;
  Schema ways = Schema::array();
  for (const std::string_view word : words_of(by)) {
    const Schema said = is_flag ? Schema(word == "true") : Schema(word);
    Schema way = {{"properties", {{std::string(by.name), {{"enum", {said}}}}}}};
    std::vector<std::string> required;
    Schema others = Schema::array();
    for (const Key& key : table.keys) {  // of several of a name the one that counts
      const bool only_one =
          std::count_if(table.keys.begin(), table.keys.end(), [&](const Key& one) { return one.name == key.name; }) < 2;
      if (only_one || key.conditions.empty() || !key.is_for(by.name, word)) continue;
      if (key.conditions.back().key == by.name) way["properties"][std::string(key.name)] = schema_of_value(key);
    }
    const bool by_default = by.need == Need::optional && word == words_of(by).front();
    if (!by_default) required.emplace_back(by.name);
    for (const std::string& name : table.names()) {
      const auto owners = table.owners(name, by.name);
      if (!owners.empty() && std::find(owners.begin(), owners.end(), word) == owners.end()) {
        others.push_back(all_given({name}));
      }
    }
    const auto is_of_word = [&](const Key& key) {
      return !key.conditions.empty() && key.conditions.back().key == by.name && key.is_for(by.name, word);
    };
    for (const Key& key : table.keys) {
      if (is_of_word(key) && key.is_required() && !is_always_required(table, key)) required.emplace_back(key.name);
    }
    if (!required.empty()) way["required"] = required;
    if (!others.empty()) way["not"] = {{"anyOf", others}};
    std::vector<Schema> rules;
    add_groups(
        table, [&](const Key& key) { return !is_always_in_group(table, key) && is_of_word(key); }, rules);
    if (!rules.empty()) way["allOf"] = rules;
    ways.push_back(way);
  }
  if (!by.conditions.empty()) ways.push_back({{"not", all_given({std::string(by.name)})}});
  return {{"anyOf", ways}};
}

Schema schema_of_table(const KeyTable& table) {
  Schema schema = {{"type", "object"}};
  if (!table.title.empty()) schema["description"] = plain_text(std::string(table.title));
  schema["properties"] = Schema::object();
  for (const std::string& name : table.names()) schema["properties"][name] = schema_of_name(table, name);
  schema["additionalProperties"] = false;
  std::vector<std::string> required;
  std::vector<Schema> rules;
  for (const Key& key : table.keys) {
    const bool is_new = std::find(required.begin(), required.end(), key.name) == required.end();
    if (is_new && is_always_required(table, key)) required.emplace_back(key.name);
  }
  if (!required.empty()) schema["required"] = required;
  for (const Key& key : table.keys) {
    const bool always_so = std::all_of(table.keys.begin(), table.keys.end(),
                                       [&](const Key& one) { return one.name != key.name || one.with == key.with; });
    if (!key.with.empty() && always_so) schema["dependencies"][std::string(key.name)] = {key.with};
  }
  add_groups(
      table, [&](const Key& key) { return is_always_in_group(table, key); }, rules);
  std::vector<std::string_view> deciding;
  for (const Key& key : table.keys) {
    for (const Condition& condition : key.conditions) {
      if (std::find(deciding.begin(), deciding.end(), condition.key) == deciding.end())
        deciding.push_back(condition.key);
    }
  }
  for (const std::string_view by : deciding) rules.push_back(schema_of_words(table, table.at(by)));
  if (!rules.empty()) schema["allOf"] = rules;
  return schema;
}

}  // namespace

std::string value_text(const Key& key) {
  std::string text = one_value_text(key);
  const auto put_before = [&](const std::string& words) { text = words + (text.empty() ? "" : ", " + text); };
  if (key.kind == Key::Kind::by_building) return "a table that maps names of buildings to lists, " + text;
  if (key.form == Key::Form::list && key.kind == Key::Kind::text) {
    text = "list of texts";
  } else if (key.form == Key::Form::list) {
    put_before("list");
  } else if (key.form == Key::Form::one_or_list) {
    put_before(key.kind == Key::Kind::number ? "number or list" : "one or a list");
  } else if (key.form == Key::Form::matrix) {
    put_before("list of lists");
  }
  if (key.form != Key::Form::one && !key.each.empty()) text += ", " + std::string(key.each);
  if (key.kind != Key::Kind::choice && key.kind != Key::Kind::any && !key.words.empty()) {
    text += "; or " + quoted_words(key.words);
  }
  if ((key.kind == Key::Kind::number || key.kind == Key::Kind::choice) && key.table != nullptr) {
    text += fmt::format(", or `{{ {} }}`", fmt::join(key.table->names(), ", "));
  }
  return text;
}

std::string default_text(const Key& key) {
  if (key.need == Need::required) return "";
  if (!key.otherwise.empty()) return std::string(key.otherwise);
  if (key.kind == Key::Kind::choice && key.need == Need::optional) return fmt::format("`\"{}\"`", key.words.front());
  if (!key.default_value) return "";
  if (key.kind == Key::Kind::flag) return *key.default_value != 0 ? "`true`" : "`false`";
  return fmt::format("{}", *key.default_value);
}

std::string json_schema(const KeyTable& keys, const std::string& title) {
  Schema schema = {{"$schema", "http://json-schema.org/draft-04/schema#"}, {"title", title}};
  const Schema table = schema_of_table(keys);
  for (const auto& [keyword, said] : table.items()) schema[keyword] = said;
  return schema.dump(1) + "\n";
}

}  // namespace bentur
