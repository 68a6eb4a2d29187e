#include "bentur/io/schema/table_view.h"

#include <algorithm>

namespace bentur {
namespace {

/// Whether a table says what a key is for; where it says nothing of that the first word counts.
bool applies(const Key& key, const KeyTable& keys, const TomlValue& table) {
  return std::all_of(key.conditions.begin(), key.conditions.end(), [&](const Condition& condition) {
    const TomlValue* const given = table.find(std::string(condition.key));
    const Key& by = keys.at(condition.key);
    std::string_view word = given != nullptr ? std::string_view(given->text) : "";
    if (by.kind == Key::Kind::flag) {
      word = given != nullptr && given->boolean ? "true" : "false";
    } else if (given == nullptr) {
      word = by.words.front();
    }
    return std::find(condition.words.begin(), condition.words.end(), word) != condition.words.end();
  });
}

const Key* key_of(const KeyTable& keys, std::string_view name, const TomlValue& table) {
  const Key* first = nullptr;
  for (const Key& key : keys.keys) {
    if (key.name != name) continue;
    if (applies(key, keys, table)) return &key;
    if (first == nullptr) first = &key;
  }
  return first;
}

}  // namespace

std::optional<TableView> TableView::of(const TomlView& view, const KeyTable& keys) {
  if (!view.is_table_of(keys.names())) return std::nullopt;
  return TableView(view, keys);
}

const Key& TableView::key(std::string_view name) const {
  const Key* const found = key_of(*keys_, name, value());
  return found != nullptr ? *found : keys_->at(name);
}

std::optional<TomlView> TableView::get(std::string_view name) const {
  auto found = find(std::string(name));
  if (!found && key(name).is_required()) error_missing(std::string(name));
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
  if (!given) return {};
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
    if (key.group != group || !applies(key, *keys_, value())) continue;
    known.emplace_back(key.name);
    needed = needed || key.need == Need::one_of;
  }
  return TomlView::exactly_one(known, needed ? Need::required : Need::optional);
}

void TableView::refuse_others(std::string_view by, std::string_view word,
                              const std::function<std::string(const std::vector<std::string_view>&)>& reason) const {
  for (const std::string& name : keys_->names()) {
    const auto owners = keys_->owners(name, by);
    if (!owners.empty() && std::find(owners.begin(), owners.end(), word) == owners.end())
      refuse({name}, reason(owners));
  }
}

const Key* key_at(const KeyTable& keys, const ParameterPath& path, const TomlValue& file) {
  const KeyTable* table = &keys;
  const TomlValue* value = &file;
  const TomlValue nothing;
  const Key* found = nullptr;
  for (const PathStep& step : path) {
    if (const auto* const place = std::get_if<std::size_t>(&step)) {
      value = value->kind == TomlValue::Kind::list && *place < value->items.size() ? &value->items[*place] : &nothing;
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

}  // namespace bentur
