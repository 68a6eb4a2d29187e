#include "bentur/io/toml/toml_view.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace bentur {
namespace {

bool obeys(Rule rule, double x) {
  switch (rule) {
    case Rule::finite:
      return std::isfinite(x);
    case Rule::positive:
      return std::isfinite(x) && x > 0;
    case Rule::not_negative:
      return std::isfinite(x) && x >= 0;
    case Rule::not_zero:
      return std::isfinite(x) && x != 0;
    case Rule::ratio:
      return x >= 0 && x < 1;
    case Rule::restitution:
      return x > 0 && x <= 1;
  }
  return false;
}

std::string stated(Rule rule, double x) {
  if (!std::isfinite(x)) return "must be finite";
  switch (rule) {
    case Rule::positive:
      return "must be > 0";
    case Rule::not_negative:
      return "must be >= 0";
    case Rule::not_zero:
      return "must not be 0";
    case Rule::ratio:
      return "must be in [0, 1)";
    case Rule::restitution:
      return "must be in (0, 1]";
    case Rule::finite:
      break;
  }
  return "must be finite";
}

bool is_bare(const std::string& key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

std::string joined(const std::string& path, const std::string& key) {
  if (!is_bare(key)) return fmt::format("{}[{}]", path, in_quotes(key));
  return path.empty() ? key : path + "." + key;
}

const char* kind_name(TomlValue::Kind kind) {
  switch (kind) {
    case TomlValue::Kind::table:
      return "a table";
    case TomlValue::Kind::list:
      return "a list";
    default:
      return "a date";
  }
}

}  // namespace

std::string in_quotes(const std::string& text) {
  std::string shown = "\"";
  std::size_t characters = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) != 0x80 && ++characters > 60) return shown + "...\"";
    if (byte < 0x20 || byte == 0x7F) {
      shown += fmt::format("\\x{:02x}", byte);
    } else {
      if (c == '"' || c == '\\') shown += '\\';
      shown += c;
    }
  }
  return shown + "\"";
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known, const std::string& otherwise) {
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
  return near.empty() ? fmt::format("{} {}", otherwise, fmt::join(known, ", "))
                      : fmt::format("did you mean \"{}\"?", near);
}

void TomlView::error(const std::string& message) const {
  diagnostics_->error({*file_, value_->line, value_->column}, path_.empty() ? message : path_ + " " + message);
}

void TomlView::error_value(const std::string& rule) const {
  std::string shown;
  switch (value_->kind) {
    case TomlValue::Kind::text:
      shown = "= " + in_quotes(value_->text);
      break;
    case TomlValue::Kind::integer:
      shown = fmt::format("= {}", value_->integer);
      break;
    case TomlValue::Kind::real:
      shown = fmt::format("= {}", value_->real);
      break;
    case TomlValue::Kind::boolean:
      shown = fmt::format("= {}", value_->boolean);
      break;
    default:
      shown = std::string("is ") + kind_name(value_->kind);
  }
  error(shown + ", " + rule);
}

void TomlView::error_missing(const std::string& key, const std::string& reason) const {
  diagnostics_->error({*file_, value_->line, value_->column},
                      joined(path_, key) + " is missing" + (reason.empty() ? "" : " (" + reason + ")"));
}

bool TomlView::is_table_of(const std::vector<std::string>& known) const {
  if (!is(TomlValue::Kind::table)) {
    error_value("must be a table");
    return false;
  }
  for (const TomlMember& member : value_->members) {
    if (std::find(known.begin(), known.end(), member.key) != known.end()) continue;
    diagnostics_->error({*file_, member.line, member.column},
                        fmt::format("{} is not a known key, {}", joined(path_, member.key),
                                    suggestion(member.key, known, "the known ones are")));
  }
  return true;
}

bool TomlView::has(const std::string& key) const { return find(key).has_value(); }

std::optional<TomlView> TomlView::find(const std::string& key) const {
  for (const TomlMember& member : value_->members) {
    if (member.key == key) return TomlView(member.value, joined(path_, key), *file_, *diagnostics_);
  }
  return std::nullopt;
}

std::optional<TomlView> TomlView::get(const std::string& key, Need need) const {
  std::optional<TomlView> found = find(key);
  if (!found && need == Need::required) error_missing(key);
  return found;
}

std::optional<double> TomlView::number(const std::string& key, Rule rule, Need need) const {
  const auto found = get(key, need);
  return found ? found->as_number(rule) : std::nullopt;
}

std::optional<std::vector<double>> TomlView::numbers(const std::string& key, Rule rule, const Length& length,
                                                     Need need) const {
  const auto found = get(key, need);
  return found ? found->as_numbers(rule, length) : std::nullopt;
}

std::optional<std::string> TomlView::text(const std::string& key, Need need) const {
  const auto found = get(key, need);
  return found ? found->as_text() : std::nullopt;
}

std::optional<std::string> TomlView::word(const std::string& key, const std::vector<std::string>& known,
                                          Need need) const {
  const auto found = get(key, need);
  return found ? found->as_word(known) : std::nullopt;
}

std::optional<bool> TomlView::flag(const std::string& key, Need need) const {
  const auto found = get(key, need);
  return found ? found->as_flag() : std::nullopt;
}

std::optional<std::string> TomlView::exactly_one(const std::vector<std::string>& keys, Need need) const {
  std::vector<std::string> given;
  for (const std::string& key : keys) {
    if (has(key)) given.push_back(key);
  }
  if (given.size() == 1) return given.front();
  if (given.empty()) {
    if (need == Need::required) error(fmt::format("needs exactly one of {}", fmt::join(keys, ", ")));
  } else {
    error(fmt::format("has {}, but these exclude one another: give exactly one", fmt::join(given, " and ")));
  }
  return std::nullopt;
}

TomlView TomlView::item(std::size_t index) const {
  return {value_->items[index], fmt::format("{}[{}]", path_, index), *file_, *diagnostics_};
}

bool TomlView::is_list_of(const std::string& what, const Length& length) const {
  if (!is(TomlValue::Kind::list)) {
    error_value("must be a list of " + what);
    return false;
  }
  if (length.count > 0 && size() != length.count) {
    error(fmt::format("has {} {}, expected {} ({})", size(), size() == 1 ? "entry" : "entries", length.count,
                      length.each));
    return false;
  }
  if (size() == 0) {
    error("is empty, must have at least one entry");
    return false;
  }
  return true;
}

std::optional<double> TomlView::as_number(Rule rule) const {
  if (!is_number()) {
    error_value("must be a number");
    return std::nullopt;
  }
  if (!obeys(rule, value_->real)) {
    error_value(stated(rule, value_->real));
    return std::nullopt;
  }
  return value_->real;
}

std::optional<std::vector<double>> TomlView::as_numbers(Rule rule, const Length& length) const {
  bool good = is_list_of("numbers", length);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < size(); ++i) {
    const auto number = item(i).as_number(rule);
    good = good && number.has_value();
    if (number) numbers.push_back(*number);
  }
  return good ? std::optional(numbers) : std::nullopt;
}

std::optional<std::vector<double>> TomlView::as_number_or_numbers(Rule rule, const Length& length) const {
  if (is(TomlValue::Kind::list)) return as_numbers(rule, length);
  if (!is_number()) {
    error_value("must be a number or a list of numbers");
    return std::nullopt;
  }
  const auto number = as_number(rule);
  return number ? std::optional(std::vector<double>{*number}) : std::nullopt;
}

std::optional<std::string> TomlView::as_text() const {
  if (is(TomlValue::Kind::text)) return value_->text;
  error_value("must be a text in quotes");
  return std::nullopt;
}

std::optional<std::string> TomlView::as_word(const std::vector<std::string>& known) const {
  const auto word = as_text();
  if (!word || std::find(known.begin(), known.end(), *word) != known.end()) return word;
  error_value(suggestion(*word, known));
  return std::nullopt;
}

std::optional<bool> TomlView::as_flag() const {
  if (is(TomlValue::Kind::boolean)) return value_->boolean;
  error_value("must be true or false");
  return std::nullopt;
}

}  // namespace bentur
