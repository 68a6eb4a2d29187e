#include "bentur/core/key.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bentur {

std::string_view broken_rule(Range range, double x) {
  if (range == Range::positive_or_infinite) return x > 0 ? "" : "must be > 0 (inf: no limit)";
  if (!std::isfinite(x)) return "must be finite";
  switch (range) {
    case Range::positive:
      return x > 0 ? "" : "must be > 0";
    case Range::not_negative:
      return x >= 0 ? "" : "must be >= 0";
    case Range::not_zero:
      return x != 0 ? "" : "must not be 0";
    case Range::ratio:
      return x >= 0 && x < 1 ? "" : "must be in [0, 1)";
    case Range::restitution:
      return x > 0 && x <= 1 ? "" : "must be in (0, 1]";
    case Range::share:
      return x >= 0 && x <= 1 ? "" : "must be in [0, 1]";
    case Range::size:
      return !(x > 0) ? "must be > 0" : x >= 1e-9 && x <= 1e9 ? "" : "must be in [1e-9, 1e9]";
    case Range::distance:
      return !(x >= 0) ? "must be >= 0" : x <= 1e9 ? "" : "must be in [0, 1e9]";
    case Range::level:
      return std::abs(x) <= 1e9 ? "" : "must be in [-1e9, 1e9]";
    case Range::poisson:
      return !(x >= 0) ? "must be >= 0" : x <= 0.5 ? "" : "must be in [0, 0.5]";
    case Range::tolerance:
      return x >= 1e-13 && x <= 1e-2 ? "" : "must be in [1e-13, 1e-2]";
    case Range::step_limit:
      return !(x > 0) ? "must be > 0" : x >= 1 && x <= 1e15 ? "" : "must be in [1, 1e15]";
    case Range::memory_limit:
      return !(x > 0) ? "must be > 0" : x <= 1e9 ? "" : "must be at most 1e9 (MB)";
    case Range::positive_or_infinite:
    case Range::finite:
      break;
  }
  return "";
}

std::string_view range_text(Range range) {
  switch (range) {
    case Range::positive:
    case Range::positive_or_infinite:
    case Range::size:
    case Range::memory_limit:
      return "> 0";
    case Range::poisson:
      return "in [0, 0.5]";
    case Range::tolerance:
      return "in [1e-13, 1e-2]";
    case Range::step_limit:
      return "in [1, 1e15]";
    case Range::not_negative:
    case Range::distance:
      return "≥ 0";
    case Range::not_zero:
      return "not 0";
    case Range::ratio:
      return "in [0, 1)";
    case Range::restitution:
      return "in (0, 1]";
    case Range::share:
      return "in [0, 1]";
    case Range::level:
    case Range::finite:
      break;
  }
  return "";
}

Bounds bounds_of(Range range) {
  switch (range) {
    case Range::positive:
    case Range::positive_or_infinite:
      return {.least = 0, .least_excluded = true};
    case Range::size:
      return {.least = 1e-9, .most = 1e9};
    case Range::memory_limit:
      return {.least = 0, .most = 1e9, .least_excluded = true};
    case Range::poisson:
      return {.least = 0, .most = 0.5};
    case Range::tolerance:
      return {.least = 1e-13, .most = 1e-2};
    case Range::step_limit:
      return {.least = 1, .most = 1e15};
    case Range::not_negative:
      return {.least = 0};
    case Range::distance:
      return {.least = 0, .most = 1e9};
    case Range::level:
      return {.least = -1e9, .most = 1e9};
    case Range::ratio:
      return {.least = 0, .most = 1, .most_excluded = true};
    case Range::restitution:
      return {.least = 0, .most = 1, .least_excluded = true};
    case Range::share:
      return {.least = 0, .most = 1};
    case Range::not_zero:
    case Range::finite:
      break;
  }
  return {};
}

Key Key::number(std::string_view name, PhysicalDimension dimension, Range range, Label label, std::string_view doc) {
  return {.name = name, .kind = Kind::number, .dimension = dimension, .label = label, .doc = doc, .range = range};
}

Key Key::quantity(std::string_view name, PhysicalDimension dimension, Label label, std::string_view doc) {
  Key key = number(name, dimension, Range::positive, label, doc);
  key.kind = Kind::quantity;
  return key;
}

Key Key::whole(std::string_view name, std::int64_t least, std::int64_t most, Label label, std::string_view doc) {
  Key key = of(name, Kind::whole, label, doc);
  key.least = least;
  key.most = most;
  return key;
}

Key Key::of(std::string_view name, Kind kind, Label label, std::string_view doc) {
  return {.name = name, .kind = kind, .dimension = dimension::none, .label = label, .doc = doc};
}

Key Key::choice(std::string_view name, std::vector<std::string_view> words, Label label, std::string_view doc) {
  Key key = of(name, Kind::choice, label, doc);
  key.words = std::move(words);
  return key;
}

Key Key::sub_table(std::string_view name, const KeyTable& table, Label label, std::string_view doc) {
  Key key = of(name, Kind::table, label, doc);
  key.table = &table;
  return key;
}

Key Key::by_building(std::string_view name, PhysicalDimension dimension, Range range, Label label,
                     std::string_view doc) {
  Key key = number(name, dimension, range, label, doc).list("one per floor").optional("zeros");
  key.kind = Kind::by_building;
  return key;
}

Key& Key::list(std::string_view one_per, std::size_t of_them) {
  form = Form::list;
  each = one_per;
  count = of_them;
  return *this;
}

Key& Key::or_empty() {
  may_be_empty = true;
  return *this;
}

Key& Key::at_least(std::int64_t items) {
  least = items;
  return *this;
}

Key& Key::up_to(std::int64_t items) {
  most = items;
  return *this;
}

Key& Key::for_each(std::string_view one_per) {
  form = Form::one_or_list;
  each = one_per;
  return *this;
}

Key& Key::matrix(std::string_view one_per, bool or_its_diagonal) {
  form = Form::matrix;
  or_diagonal = or_its_diagonal;
  each = one_per;
  return *this;
}

Key& Key::optional(std::string_view without) {
  need = Need::optional;
  otherwise = without;
  return *this;
}

Key& Key::by_default(double value) {
  default_value = value;
  return optional(otherwise);
}

Key& Key::one_of(std::string_view of_group, Need how) {
  group = of_group;
  need = how;
  return *this;
}

Key& Key::when(std::string_view key, std::vector<std::string_view> any_of) {
  conditions.push_back({.key = key, .words = std::move(any_of)});
  return *this;
}

Key& Key::goes_with(std::string_view key) {
  with = key;
  return *this;
}

Key& Key::or_one_of(std::vector<std::string_view> known) {
  words = std::move(known);
  return *this;
}

Key& Key::called(std::vector<Label> words_for_people) {
  word_labels = std::move(words_for_people);
  return *this;
}

Label Key::label_of(std::string_view word) const {
  const auto at = static_cast<std::size_t>(std::find(words.begin(), words.end(), word) - words.begin());
  if (at < word_labels.size() && !word_labels[at].english.empty()) return word_labels[at];
  return {word, word};
}

Key& Key::or_table(const KeyTable& keys) {
  table = &keys;
  return *this;
}

Key& Key::may_join(std::string_view key) {
  beside = key;
  return *this;
}

Key& Key::counted_in(std::string_view unit) {
  own_unit = unit;
  return *this;
}

bool Key::is_for(std::string_view key, std::string_view word) const {
  return std::all_of(conditions.begin(), conditions.end(), [&](const Condition& one) {
    return one.key != key || std::find(one.words.begin(), one.words.end(), word) != one.words.end();
  });
}

const Key* KeyTable::find(std::string_view key) const {
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const Key& one) { return one.name == key; });
  return found == keys.end() ? nullptr : &*found;
}

const Key& KeyTable::at(std::string_view key) const {
  if (const Key* const found = find(key)) return *found;
  throw std::out_of_range(std::string(name) + " has no key " + std::string(key));
}

std::vector<std::string> KeyTable::names() const {
  std::vector<std::string> all;
  for (const Key& key : keys) {
    if (std::find(all.begin(), all.end(), key.name) == all.end()) all.emplace_back(key.name);
  }
  return all;
}

std::vector<std::string> KeyTable::names_of(std::string_view group) const {
  std::vector<std::string> all;
  for (const Key& key : keys) {
    const bool is_new = std::find(all.begin(), all.end(), key.name) == all.end();
    if (key.group == group && is_new) all.emplace_back(key.name);
  }
  return all;
}

std::vector<std::string_view> KeyTable::owners(std::string_view key, std::string_view by) const {
  std::vector<std::string_view> all;
  for (const Key& one : keys) {
    if (one.name != key) continue;
    bool of_all = true;
    for (const Condition& condition : one.conditions) {
      if (condition.key != by) continue;
      of_all = false;
      for (const std::string_view word : condition.words) {
        if (std::find(all.begin(), all.end(), word) == all.end()) all.push_back(word);
      }
    }
    if (of_all) return {};
  }
  return all;
}

}  // namespace bentur
