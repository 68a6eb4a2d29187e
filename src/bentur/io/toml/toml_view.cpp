#include "bentur/io/toml/toml_view.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "bentur/core/number_text.h"

namespace bentur {
namespace {

/// Bytes of the character that a text begins with where that is none to be seen, but changes how others are shown:
/// controls, ends of lines, marks of direction; else 0.
std::size_t unseen(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  if (byte(0) < 0x20 || byte(0) == 0x7F) return 1;
  if (byte(0) == 0xC2 && byte(1) >= 0x80 && byte(1) <= 0x9F) return 2;  // U+0080 to U+009F
  if (byte(0) == 0xD8 && byte(1) == 0x9C) return 2;                     // U+061C
  if (byte(0) != 0xE2) return 0;
  const bool of_general =
      byte(1) == 0x80 && (byte(2) == 0x8E || byte(2) == 0x8F || (byte(2) >= 0xA8 && byte(2) <= 0xAE));
  const bool isolates = byte(1) == 0x81 && byte(2) >= 0xA6 && byte(2) <= 0xA9;
  return of_general || isolates ? 3 : 0;  // U+200E, 200F, 2028 to 202E, 2066 to 2069
}

/// The code point of a character of two or three bytes.
unsigned code_of(std::string_view character) {
  unsigned code = static_cast<unsigned char>(character[0]) & (character.size() == 2 ? 0x1FU : 0x0FU);
  for (const char c : character.substr(1)) code = (code << 6U) | (static_cast<unsigned char>(c) & 0x3FU);
  return code;
}

}  // namespace

std::string key_path(const std::string& path, const std::string& key) {
  const bool bare = !key.empty() && key.find_first_not_of(bare_key_characters) == std::string::npos;
  if (!bare) return fmt::format("{}[{}]", path, in_quotes(key));
  return path.empty() ? key : path + "." + key;
}

std::string in_quotes(const std::string& text) {
  std::string shown = "\"";
  std::size_t characters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) != 0x80 && ++characters > 60) return shown + "...\"";
    if (const std::size_t hidden = unseen(std::string_view(text).substr(i)); hidden == 1) {
      shown += fmt::format("\\x{:02x}", byte);
    } else if (hidden > 1) {
      shown += fmt::format("\\u{:04x}", code_of(std::string_view(text).substr(i, hidden)));
      i += hidden - 1;
    } else {
      if (c == '"' || c == '\\') shown += '\\';
      shown += c;
    }
  }
  return shown + "\"";
}

bool is_one_line(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (unseen(std::string_view(text).substr(i)) > 0) return false;
  }
  return true;
}

std::string likely(const std::string& word, const std::vector<std::string>& known) {
  const auto same_letters = [&](const std::string& other) {
    return std::equal(word.begin(), word.end(), other.begin(), other.end(),
                      [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
  };
  const auto other_case = std::find_if(known.begin(), known.end(), same_letters);
  // The table of distances grows with the word, and no known one is that long.
  std::string near = other_case != known.end() ? *other_case : word.size() > 60 ? std::string() : nearest(word, known);
  for (const std::string& one : known) {  // "inch" for "in"; single letters begin too much
    if (near.empty() && one.size() > 1 && word.starts_with(one) && 2 * one.size() >= word.size()) near = one;
  }
  return near;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known, const std::string& otherwise) {
  const std::string near = likely(word, known);
  return near.empty() ? fmt::format("{} {}", otherwise, fmt::join(known, ", "))
                      : fmt::format("did you mean \"{}\"?", near);
}

std::nullopt_t TomlView::error(const std::string& message) const {
  diagnostics_->add({.position = position(), .key = path_, .rule = message});
  return std::nullopt;
}

std::nullopt_t TomlView::error_shown(const std::string& value, const std::string& rule) const {
  diagnostics_->add({.position = position(), .key = path_, .value = value, .rule = rule});
  return std::nullopt;
}

std::nullopt_t TomlView::error_value(const std::string& rule, const std::string& suggestion) const {
  std::string shown;
  switch (value_->kind) {
    case TomlValue::Kind::text:
      shown = in_quotes(value_->text);
      break;
    case TomlValue::Kind::integer:
      shown = fmt::format("{}", value_->integer);
      break;
    case TomlValue::Kind::real:
      shown = fmt::format("{}", value_->real);
      break;
    case TomlValue::Kind::boolean:
      shown = fmt::format("{}", value_->boolean);
      break;
    case TomlValue::Kind::table:
      shown = "a table";
      break;
    case TomlValue::Kind::list:
      shown = "a list";
      break;
    case TomlValue::Kind::date:
      shown = "a date";
      break;
  }
  diagnostics_->add({.position = position(), .key = path_, .value = shown, .rule = rule, .suggestion = suggestion});
  return std::nullopt;
}

std::nullopt_t TomlView::error_missing(const std::string& key, const std::string& reason) const {
  const std::string rule = "is missing" + (reason.empty() ? "" : " (" + reason + ")");
  diagnostics_->add({.position = position(), .key = key_path(path_, key), .rule = rule});
  return std::nullopt;
}

bool TomlView::has_error() const {
  const std::vector<Diagnostic> errors = diagnostics_->errors();
  return std::any_of(errors.begin(), errors.end(), [&](const Diagnostic& one) {
    // What was not read from a file has no place in one, but a name.
    return one.position.line == value_->line && one.position.column == value_->column &&
           one.position.origin == value_->origin && (value_->line > 0 || one.key == path_);
  });
}

bool TomlView::is_table_of(const std::vector<std::string>& known, const std::vector<std::string>* listed,
                           const std::function<std::string(const std::string&)>& elsewhere) const {
  if (listed == nullptr) listed = &known;
  if (!is(TomlValue::Kind::table)) {
    error_value("must be a table");
    return false;
  }
  for (const TomlMember& member : value_->members) {
    if (std::find(known.begin(), known.end(), member.key) != known.end()) continue;
    std::string near = likely(member.key, known);
    if (near.empty() && elsewhere) near = elsewhere(member.key);
    const std::string others = !near.empty()     ? ""
                               : listed->empty() ? ": there are none"
                                                 : fmt::format(", the known ones are {}", fmt::join(*listed, ", "));
    diagnostics_->add({.position = {*file_, member.line, member.column, member.value.origin},
                       .key = key_path(path_, member.key),
                       .rule = "is not a known key" + others,
                       .suggestion = near,
                       .unknown_key = true});
  }
  return true;
}

std::optional<TomlView> TomlView::find(const std::string& key) const {
  const TomlValue* found = value_->find(key);
  if (found == nullptr) return std::nullopt;
  return TomlView(*found, key_path(path_, key), *file_, *diagnostics_);
}

std::optional<TomlView> TomlView::get(const std::string& key, Need need) const {
  std::optional<TomlView> found = find(key);
  if (!found && need == Need::required) error_missing(key);
  return found;
}

std::optional<TomlView> TomlView::tables(const std::string& key, const std::string& reason) const {
  const auto list = find(key);
  if (!list) return error_missing(key, reason);
  if (!list->is(TomlValue::Kind::list)) {
    return list->error_value(fmt::format("must be a list of tables, each headed [[{}]]", key));
  }
  return list;
}

void TomlView::refuse(const std::vector<std::string>& keys, const std::string& reason) const {
  for (const std::string& key : keys) {
    if (const auto given = find(key)) given->error(reason);
  }
}

std::optional<std::string> TomlView::exactly_one(const std::vector<std::string>& keys, Need need) const {
  std::vector<std::string> given;
  for (const std::string& key : keys) {
    if (has(key)) given.push_back(key);
  }
  if (given.size() == 1) return given.front();
  if (!given.empty()) {
    return error(fmt::format("has {}, but these exclude one another: give exactly one", fmt::join(given, " and ")));
  }
  if (need == Need::required) error(fmt::format("needs exactly one of {}", fmt::join(keys, ", ")));
  return std::nullopt;
}

TomlView TomlView::item(std::size_t index) const {
  return {value_->items[index], fmt::format("{}[{}]", path_, index), *file_, *diagnostics_};
}

std::vector<TomlView> TomlView::items() const {
  std::vector<TomlView> all;
  for (std::size_t i = 0; i < value_->items.size(); ++i) all.push_back(item(i));
  return all;
}

bool TomlView::is_list_of(const std::string& what, const Length& length) const {
  if (!is(TomlValue::Kind::list)) {
    error_value("must be a list of " + what);
    return false;
  }
  if (length.count > 0 && size() != length.count) {
    error(fmt::format("has {}, expected {} ({})", entries(), length.count, length.each));
    return false;
  }
  if (size() == 0) {
    error("is empty, must have at least one entry");
    return false;
  }
  return true;
}

bool TomlView::has_more_than(std::int64_t most) const {
  const bool too_many = most > 0 && is(TomlValue::Kind::list) && std::cmp_greater(size(), most);
  if (too_many) error(fmt::format("has {}, must have at most {}", entries(), most));
  return too_many;
}

std::string TomlView::entries() const { return counted(size(), "entry", "entries"); }

std::optional<double> TomlView::as_number(Range range) const {
  if (!is_number()) return error_value("must be a number");
  const std::string_view why = broken_rule(range, value_->real);
  if (!why.empty()) return error_value(std::string(why));
  return value_->real;
}

std::optional<std::int64_t> TomlView::as_whole(std::int64_t least, std::int64_t most) const {
  const bool good = is(TomlValue::Kind::integer) && value_->integer >= least && value_->integer <= most;
  if (good) return value_->integer;
  return error_value(fmt::format("must be a whole number from {} to {}", least, most));
}

std::vector<double> TomlView::as_numbers(Range range, const Length& length) const {
  bool good = is_list_of("numbers", length);
  std::vector<double> numbers;
  if (good && value_->numbers) {
    for (std::size_t i = 0; i < size(); ++i) {
      const double x = (*value_->numbers)[i];
      if (broken_rule(range, x).empty()) continue;
      good = false;
      const TomlValue one = toml_number(x);
      (void)TomlView(one, fmt::format("{}[{}]", path_, i), *file_, *diagnostics_).as_number(range);
    }
    return good ? *value_->numbers : numbers;
  }
  for (const TomlView& one : items()) {
    const auto number = one.as_number(range);
    good = good && number.has_value();
    if (number) numbers.push_back(*number);
  }
  return good ? numbers : std::vector<double>();
}

std::vector<double> TomlView::as_number_or_numbers(Range range, const Length& length) const {
  if (is(TomlValue::Kind::list)) return as_numbers(range, length);
  if (!is_number()) error_value("must be a number or a list of numbers");
  const auto number = is_number() ? as_number(range) : std::nullopt;
  return number ? std::vector<double>{*number} : std::vector<double>();
}

std::vector<double> TomlView::as_number_for_each(Range range, const Length& length) const {
  std::vector<double> numbers = as_number_or_numbers(range, length);
  if (numbers.size() == 1) numbers.resize(length.count, double{numbers.front()});
  return numbers;
}

std::optional<std::string> TomlView::as_text() const {
  if (is(TomlValue::Kind::text)) return value_->text;
  return error_value("must be a text in quotes");
}

std::optional<std::string> TomlView::as_line() const {
  auto text = as_text();
  if (text && !is_one_line(*text)) {
    return error_value("must be one line without control characters and marks of direction");
  }
  return text;
}

std::optional<std::string> TomlView::as_word(const std::vector<std::string>& known) const {
  const auto word = as_text();
  if (!word || std::find(known.begin(), known.end(), *word) != known.end()) return word;
  return error_value(fmt::format("must be one of {}", fmt::join(known, ", ")), likely(*word, known));
}

std::optional<bool> TomlView::as_flag() const {
  if (is(TomlValue::Kind::boolean)) return value_->boolean;
  return error_value("must be true or false");
}

}  // namespace bentur
