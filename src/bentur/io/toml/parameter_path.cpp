#include "bentur/io/toml/parameter_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <utility>

#include "bentur/core/number_text.h"
#include "bentur/io/toml/toml_view.h"

namespace bentur {
namespace {

/// What stands in brackets, from behind the first to behind the last; nothing when it is neither a number nor a text.
std::optional<PathStep> bracketed(const std::string& text, std::size_t& at) {
  PathStep step;
  if (at < text.size() && (text[at] == '"' || text[at] == '\'')) {
    const std::size_t end = text.find(text[at], at + 1);
    if (end == std::string::npos) return std::nullopt;
    step = text.substr(at + 1, end - at - 1);
    at = end + 1;
  } else {
    std::size_t index = 0;
    const auto [end, failure] = std::from_chars(text.data() + at, text.data() + text.size(), index);
    if (failure != std::errc()) return std::nullopt;
    step = index;
    at = static_cast<std::size_t>(end - text.data());
  }
  if (at >= text.size() || text[at] != ']') return std::nullopt;
  ++at;
  return step;
}

const TomlValue* next_value(const TomlValue& value, const PathStep& step) {
  if (const auto* key = std::get_if<std::string>(&step)) return value.find(*key);
  const std::size_t index = std::get<std::size_t>(step);
  return value.kind == TomlValue::Kind::list && index < value.items.size() ? &value.items[index] : nullptr;
}

std::vector<std::string> keys_of(const TomlValue& table) {
  std::vector<std::string> keys;
  for (const TomlMember& member : table.members) keys.push_back(member.key);
  return keys;
}

/// The place of the entry of a list whose `name` is `name`.
std::optional<std::size_t> named_entry(const TomlValue& list, const std::string& name, std::string& error) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const TomlValue* own = list.items[i].find("name");
    if (own == nullptr) continue;
    if (own->text == name) return i;
    names.push_back(own->text);
  }
  error = names.empty() ? "needs a place, as in [0]: the entries of this list have no names"
                        : fmt::format("is not in the case, {}", suggestion(name, names, "there are"));
  return std::nullopt;
}

void mark(TomlValue& value, int origin) {
  value.line = value.column = 0;
  value.origin = origin;
  for (TomlValue& item : value.items) mark(item, origin);
  for (TomlMember& member : value.members) {
    member.line = member.column = 0;
    mark(member.value, origin);
  }
}

}  // namespace

std::optional<ParameterPath> parse_path(const std::string& text, std::string& error) {
  ParameterPath path;
  std::size_t at = 0;
  const auto refuse = [&](const char* reason) {
    error = reason;
    return std::nullopt;
  };
  while (at < text.size()) {
    if (text[at] == '[') {
      if (path.empty()) return refuse("must begin with a key");
      ++at;
      const auto step = bracketed(text, at);
      if (!step)
        return refuse("must have a number or a text in quotes between brackets, as in gap[0] or building[\"A\"]");
      path.push_back(*step);
      continue;
    }
    if (!path.empty() && text[at++] != '.') return refuse("must have keys joined by dots, as in gap[0].width");
    const std::size_t begin = at;
    at = std::min(text.find_first_not_of(bare_key_characters, begin), text.size());
    if (at == begin) return refuse("must have keys joined by dots, as in gap[0].width");
    path.emplace_back(text.substr(begin, at - begin));
  }
  if (path.empty()) return refuse("is empty");
  return path;
}

std::optional<ParameterPath> resolved(const TomlValue& root, const ParameterPath& path, std::string& error) {
  ParameterPath result;
  const TomlValue* value = &root;  // null behind what is missing
  const auto refuse = [&](const std::string& reason) {
    error = reason;
    return std::nullopt;
  };
  for (std::size_t i = 0; i < path.size(); ++i) {
    PathStep step = path[i];
    const std::string here = path_text(result);
    if (value == nullptr) {
      result.push_back(step);
      continue;
    }
    if (const auto* key = std::get_if<std::string>(&step)) {
      if (value->kind == TomlValue::Kind::list) {
        const auto place = named_entry(*value, *key, error);
        if (!place) return std::nullopt;
        step = *place;
      } else if (value->kind != TomlValue::Kind::table) {
        return refuse(fmt::format("does not exist: {} has no keys", here));
      } else if (value->find(*key) == nullptr) {
        // Legal where the key is an optional one that a table may have, but what is missing has no entries.
        const bool entries = std::any_of(path.begin() + static_cast<std::ptrdiff_t>(i), path.end(),
                                         [](const PathStep& s) { return std::holds_alternative<std::size_t>(s); });
        if (entries) {
          return refuse(fmt::format("does not exist: {} has no {}, {}", here.empty() ? "the case" : here, *key,
                                    suggestion(*key, keys_of(*value), "it has")));
        }
      }
    } else {
      const std::size_t index = std::get<std::size_t>(step);
      if (value->kind != TomlValue::Kind::list) return refuse(fmt::format("does not exist: {} is not a list", here));
      if (index >= value->items.size()) {
        return refuse(fmt::format("does not exist: {} has {}, counted from 0", here,
                                  counted(value->items.size(), "entry", "entries")));
      }
    }
    result.push_back(step);
    value = next_value(*value, step);
  }
  return result;
}

const TomlValue* find_value(const TomlValue& root, const ParameterPath& path) {
  const TomlValue* value = &root;
  for (const PathStep& step : path) {
    value = next_value(*value, step);
    if (value == nullptr) return nullptr;
  }
  return value;
}

void put_value(TomlValue& root, const ParameterPath& path, const TomlValue& value, int origin) {
  TomlValue* at = &root;
  for (const PathStep& step : path) {
    auto* next = const_cast<TomlValue*>(next_value(*at, step));
    if (next == nullptr) {  // resolved: a key of a table
      next = &at->members.emplace_back(TomlMember{std::get<std::string>(step), 0, 0, {}}).value;
      next->origin = origin;
    }
    at = next;
  }
  *at = value;
  mark(*at, origin);
}

bool overlap(const ParameterPath& a, const ParameterPath& b) {
  const std::size_t common = std::min(a.size(), b.size());
  return std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(common), b.begin());
}

std::string path_text(const ParameterPath& path) {
  std::string text;
  for (const PathStep& step : path) {
    const auto* index = std::get_if<std::size_t>(&step);
    text = index != nullptr ? fmt::format("{}[{}]", text, *index) : key_path(text, std::get<std::string>(step));
  }
  return text;
}

const TomlValue* TomlValue::find(const std::string& key) const {
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const TomlMember& member) { return member.key == key; });
  return found == members.end() ? nullptr : &found->value;
}

TomlValue* TomlValue::find(const std::string& key) { return const_cast<TomlValue*>(std::as_const(*this).find(key)); }

TomlValue toml_number(double value) {
  TomlValue result;
  result.kind = TomlValue::Kind::real;
  result.real = value;
  return result;
}

TomlValue toml_numbers(std::vector<double> numbers) {
  TomlValue result;
  result.kind = TomlValue::Kind::list;
  result.numbers = std::make_shared<const std::vector<double>>(std::move(numbers));
  return result;
}

TomlValue toml_text(const std::string& text) {
  TomlValue result;
  result.kind = TomlValue::Kind::text;
  result.text = text;
  return result;
}

}  // namespace bentur
