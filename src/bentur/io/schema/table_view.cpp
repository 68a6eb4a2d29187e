#include "bentur/io/schema/table_view.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace bentur {
namespace {

using Kind = TomlValue::Kind;

/// One value; of a key that takes lists one of their items.
void check_one(const TomlView& value, const Key& key) {
  if (value.is(Kind::table) && key.table != nullptr) return check_values(value, *key.table);
  if (value.value().law) return;  // one's own, in the place of a law's name
  const bool is_text = value.is(Kind::text);
  switch (key.kind) {
    case Key::Kind::number:
      if (is_text && !key.words.empty()) {
        (void)value.as_word({key.words.begin(), key.words.end()});
      } else {
        (void)value.as_number(key.range);
      }
      break;
    case Key::Kind::quantity:
      if (!is_text) (void)value.as_number(Range::positive);
      break;
    case Key::Kind::whole:
      (void)value.as_whole(key.least, key.most);
      break;
    case Key::Kind::flag:
      if (is_text && !key.words.empty()) {
        (void)value.as_word({key.words.begin(), key.words.end()});
      } else {
        (void)value.as_flag();
      }
      break;
    case Key::Kind::text:
    case Key::Kind::file:
      (void)value.as_text();
      break;
    case Key::Kind::line:
      (void)value.as_line();
      break;
    case Key::Kind::choice:
      (void)value.as_word({key.words.begin(), key.words.end()});
      break;
    case Key::Kind::table:
    case Key::Kind::by_building:
      if (!value.is(Kind::table)) value.error_value("must be a table");
      break;
    case Key::Kind::any:
      break;
  }
}

/// A value or the items of a list. @param lists how deep they may be nested
void check_all(const TomlView& value, const Key& key, int lists) {
  if (value.has_error()) return;
  if (lists == 0 || !value.is(Kind::list)) return check_one(value, key);
  const std::vector<TomlValue>& items = value.value().items;
  for (std::size_t i = 0; i < items.size(); ++i) {  // lists of numbers may be long
    const bool right =
        key.kind == Key::Kind::number && items[i].is_number() && broken_rule(key.range, items[i].real).empty();
    if (right) continue;
    const TomlView item = value.item(i);
    const TomlValue* const name = items[i].find("name");  // which messages call it by
    const bool named = name != nullptr && !name->text.empty();
    check_all(named ? item.renamed(fmt::format("{}[{}]", value.path(), in_quotes(name->text))) : item, key, lists - 1);
  }
}

/// "stick.masses" for a key that this table has not, but one of those in it: where several have it those that are
/// given count. "kind = 'record'" for a word that a key of it takes. Empty where there is neither, or more than one.
std::string place_below(const KeyTable& keys, const TomlValue& table, const std::string& key) {
  std::vector<std::string> found, given;
  for (const Key& one : keys.keys) {
    if (one.kind == Key::Kind::choice && std::find(one.words.begin(), one.words.end(), key) != one.words.end()) {
      found.push_back(fmt::format("{} = '{}'", one.name, key));
    }
    if (one.kind != Key::Kind::table || one.table == nullptr) continue;
    const std::vector<std::string> below = one.table->names();
    if (std::find(below.begin(), below.end(), key) == below.end()) continue;
    found.push_back(fmt::format("{}.{}", one.name, key));
    if (table.find(std::string(one.name)) != nullptr) given.push_back(found.back());
  }
  const std::vector<std::string>& of = given.empty() ? found : given;
  return of.size() == 1 ? of.front() : "";
}

}  // namespace

const Condition* broken_condition(const Key& key, const KeyTable& keys, const TomlValue& table) {
  for (const Condition& condition : key.conditions) {
    const TomlValue* const given = table.find(std::string(condition.key));
    const Key& by = keys.at(condition.key);
    std::string_view word = given != nullptr ? std::string_view(given->text) : "";
    if (by.kind == Key::Kind::flag) {
      word = given != nullptr && given->boolean ? "true" : "false";
    } else if (given == nullptr) {
      word = by.words.front();
    }
    if (std::find(condition.words.begin(), condition.words.end(), word) == condition.words.end()) return &condition;
  }
  return nullptr;
}

const Key* key_of(const KeyTable& keys, std::string_view name, const TomlValue& table) {
  const Key* nearest = nullptr;
  std::ptrdiff_t most = -1;
  for (const Key& key : keys.keys) {
    if (key.name != name) continue;
    const Condition* const broken = broken_condition(key, keys, table);
    if (broken == nullptr) return &key;
    if (const std::ptrdiff_t hold = broken - key.conditions.data(); hold > most) {
      most = hold;
      nearest = &key;
    }
  }
  return nearest;
}

void check_values(const TomlView& table, const KeyTable& keys) {
  for (const TomlMember& member : table.value().members) {
    const Key* const key = key_of(keys, member.key, table.value());
    if (key == nullptr) continue;
    const TomlView value = *table.find(member.key);
    const bool must_be_list = key->form == Key::Form::list || key->form == Key::Form::matrix;
    const bool is_other = key->kind == Key::Kind::number && ((value.is(Kind::text) && !key->words.empty()) ||
                                                             (value.is(Kind::table) && key->table != nullptr));
    if (must_be_list && key->kind != Key::Kind::by_building && !is_other && !value.is(Kind::list)) {
      if (!value.has_error()) value.error_value("must be a list");
      continue;
    }
    check_all(value, *key, key->form == Key::Form::one ? 0 : key->form == Key::Form::matrix ? 2 : 1);
  }
}

std::optional<TableView> TableView::of(const TomlView& view, const KeyTable& keys) {
  const bool is_table = view.is(Kind::table);
  const std::vector<TomlMember>& members = view.value().members;
  const auto is_known = [&](const TomlMember& one) { return key_of(keys, one.key, view.value()) != nullptr; };
  if (!is_table || !std::all_of(members.begin(), members.end(), is_known)) {
    // Of what may stand beside a word that is given, such as kind = "record", no other keys are listed.
    std::vector<std::string> names = keys.names(), listed;
    std::copy_if(names.begin(), names.end(), std::back_inserter(listed), [&](const std::string& name) {
      return is_table && broken_condition(*key_of(keys, name, view.value()), keys, view.value()) == nullptr;
    });
    const auto elsewhere = [&](const std::string& key) { return place_below(keys, view.value(), key); };
    if (!view.is_table_of(names, &listed, elsewhere)) return std::nullopt;
  }
  for (const TomlMember& member : members) {
    const Key* const key = key_of(keys, member.key, view.value());
    const Condition* const broken = key == nullptr ? nullptr : broken_condition(*key, keys, view.value());
    if (broken == nullptr) continue;
    const Key& by = keys.at(broken->key);
    const TomlValue* const given = view.value().find(std::string(by.name));
    if (by.kind == Key::Kind::flag || (given == nullptr && by.is_required())) continue;
    if (given != nullptr && given->law) {
      view.refuse({member.key}, fmt::format("is not for {} = \"{}\"", by.name, given->text));
      continue;
    }
    const std::string_view word = given != nullptr ? std::string_view(given->text) : by.words.front();
    if (std::find(by.words.begin(), by.words.end(), word) == by.words.end()) continue;
    std::vector<std::string_view> owners;
    for (const Key& one : keys.keys) {
      for (const Condition& condition : one.conditions) {
        if (one.name != key->name || condition.key != by.name) continue;
        owners.insert(owners.end(), condition.words.begin(), condition.words.end());
      }
    }
    const std::string known = fmt::format("{}", fmt::join(owners, "\" or \""));
    view.refuse({member.key}, fmt::format("is for {} = \"{}\", not \"{}\"", by.name, known, word));
  }
  return TableView(view, keys);
}

const Key& TableView::key(std::string_view name) const {
  const Key* const found = key_of(*keys_, name, value());
  return found != nullptr ? *found : keys_->at(name);
}

std::optional<TomlView> TableView::get(std::string_view name) const {
  auto found = find(std::string(name));
  if (!found && key(name).is_required()) {
    const std::vector<std::string_view>& words = key(name).words;
    const bool is_choice = key(name).kind == Key::Kind::choice && !words.empty();
    error_missing(std::string(name), is_choice ? fmt::format("one of {}", fmt::join(words, ", ")) : "");
  }
  return found;
}

std::optional<double> TableView::number(std::string_view name) const {
  const auto given = get(name);
  return given ? given->as_number(key(name).range) : key(name).default_value;
}

bool TableView::flag(std::string_view name) const {
  const auto given = find(std::string(name));
  const auto flag = given ? given->as_flag() : std::nullopt;
  return flag.value_or(key(name).default_value != 0.0);
}

std::vector<double> TableView::numbers(std::string_view name, std::size_t count) const {
  const Key& one = key(name);
  const auto given = get(name);
  if (!given || given->has_more_than(one.most)) return {};
  if (count == 0) count = one.count;
  return one.form == Key::Form::one_or_list ? given->as_number_or_numbers(one.range, length(one, count))
                                            : given->as_numbers(one.range, length(one, count));
}

std::vector<double> TableView::numbers_for_each(std::string_view name, std::size_t count) const {
  const auto given = get(name);
  return given ? given->as_number_for_each(key(name).range, length(key(name), count)) : std::vector<double>();
}

std::optional<std::int64_t> TableView::whole(std::string_view name) const {
  const auto given = get(name);
  return given ? given->as_whole(key(name).least, key(name).most) : std::nullopt;
}

std::optional<std::string> TableView::text(std::string_view name) const {
  const auto given = get(name);
  return given ? given->as_text() : std::nullopt;
}

std::optional<std::string> TableView::word(std::string_view name) const {
  const auto given = get(name);
  const auto& known = key(name).words;
  return given ? given->as_word({known.begin(), known.end()}) : std::nullopt;
}

std::optional<TableView> TableView::table(std::string_view name) const {
  const auto given = get(name);
  return given ? of(*given, *key(name).table) : std::nullopt;
}

std::optional<std::string> TableView::exactly_one(std::string_view group) const {
  std::vector<std::string> known;
  bool needed = false;
  for (const Key& key : keys_->keys) {
    if (key.group != group || broken_condition(key, *keys_, value()) != nullptr) continue;
    known.emplace_back(key.name);
    needed = needed || key.need == Need::one_of;
  }
  return TomlView::exactly_one(known, needed ? Need::required : Need::optional);
}

const Key* key_at(const KeyTable& keys, const ParameterPath& path, const TomlValue& file) {
  const KeyTable* table = &keys;
  const TomlValue* value = &file;
  const TomlValue nothing;
  const Key* found = nullptr;
  for (const PathStep& step : path) {
    if (const auto* const place = std::get_if<std::size_t>(&step)) {
      value = value->kind == Kind::list && *place < value->items.size() ? &value->items[*place] : &nothing;
      continue;
    }
    const std::string& name = std::get<std::string>(step);
    if (table == nullptr) return found != nullptr && found->kind == Key::Kind::by_building ? found : nullptr;
    found = key_of(*table, name, *value);
    if (found == nullptr) return nullptr;
    table = found->table;
    const TomlValue* const next = value->find(name);
    value = next != nullptr ? next : &nothing;
  }
  return found;
}

std::optional<std::string> near_unknown_key(const KeyTable& keys, const ParameterPath& path, const TomlValue& file) {
  const KeyTable* table = &keys;
  ParameterPath way;
  for (const PathStep& step : path) {
    way.push_back(step);
    const auto* const name = std::get_if<std::string>(&step);
    if (name == nullptr) continue;
    if (table == nullptr) return std::nullopt;  // what buildings and laws are called
    const Key* const key = key_at(keys, way, file);
    if (key == nullptr) return likely(*name, table->names());
    table = key->table;
  }
  return std::nullopt;
}

}  // namespace bentur
