#include "bentur/io/toml/toml_writing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/io/toml/toml_view.h"

namespace bentur {
namespace {

using Kind = TomlValue::Kind;

constexpr std::size_t line_width = 100;

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (c == '\n') {
      result += "\\n";
    } else if (c == '\t') {
      result += "\\t";
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      result += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string written_key(const std::string& key) {
  const bool bare = !key.empty() && key.find_first_not_of(bare_key_characters) == std::string::npos;
  return bare ? key : quoted(key);
}

/// With a point or an exponent, so that it stays a number that is not whole.
std::string written_real(double x) {
  std::string text = fmt::format("{}", x);
  if (text.find_first_of(".einf") == std::string::npos) text += ".0";
  return text;
}

bool is_tables(const TomlValue& value) {
  const auto is_table = [](const TomlValue& item) { return item.kind == Kind::table; };
  return value.kind == Kind::list && !value.items.empty() &&
         std::all_of(value.items.begin(), value.items.end(), is_table);
}

/// A value as it stands behind its key, all in one line.
std::string written(const TomlValue& value);

std::string joined(const std::vector<std::string>& parts, std::size_t indent) {
  std::size_t length = indent + 2;
  for (const std::string& part : parts) length += part.size() + 2;
  std::string text = "[";
  if (length <= line_width) {
    for (const std::string& part : parts) text += (text.size() > 1 ? ", " : "") + part;
    return text + "]";
  }
  std::size_t column = line_width;  // of the line that is being filled
  for (const std::string& part : parts) {
    if (column + part.size() + 2 > line_width) {
      text += "\n    ";
      column = 4;
    } else {
      text += ' ';
      ++column;
    }
    text += part + ",";
    column += part.size() + 1;
  }
  return text + "\n]";
}

std::vector<std::string> parts_of(const TomlValue& list) {
  std::vector<std::string> parts;
  if (list.numbers) {
    for (const double x : *list.numbers) parts.push_back(written_real(x));
  }
  for (const TomlValue& item : list.items) parts.push_back(written(item));
  return parts;
}

std::string written(const TomlValue& value) {
  switch (value.kind) {
    case Kind::table: {
      std::string text = "{";
      for (const TomlMember& member : value.members) {
        text += fmt::format("{} {} = {}", text.size() > 1 ? "," : "", written_key(member.key), written(member.value));
      }
      return text + (value.members.empty() ? "}" : " }");
    }
    case Kind::list: {
      std::string text = "[";
      for (const std::string& part : parts_of(value)) text += (text.size() > 1 ? ", " : "") + part;
      return text + "]";
    }
    case Kind::integer:
      return fmt::format("{}", value.integer);
    case Kind::real:
      return written_real(value.real);
    case Kind::boolean:
      return value.boolean ? "true" : "false";
    case Kind::date:
      return value.text;
    case Kind::text:
      break;
  }
  return quoted(value.text);
}

/// What stands under a heading: first what has none of its own, since it would go to the last heading.
void write_table(const TomlValue& table, const std::string& path, std::string& text) {
  const auto below = [&](const TomlMember& member) {
    return path.empty() ? written_key(member.key) : path + "." + written_key(member.key);
  };
  const auto has_heading = [&](const TomlValue& value) {
    return value.kind == Kind::table || (path.empty() && is_tables(value));
  };
  for (const TomlMember& member : table.members) {
    const TomlValue& value = member.value;
    if (has_heading(value)) continue;
    const std::string key = written_key(member.key);
    if (value.law) text += "# a law of Python's own: no file can say more of it than its name\n";
    const bool is_list = value.kind == Kind::list;
    text += fmt::format("{} = {}\n", key, is_list ? joined(parts_of(value), key.size() + 3) : written(value));
  }
  for (const TomlMember& member : table.members) {
    if (!has_heading(member.value)) continue;
    const bool is_list = member.value.kind == Kind::list;
    const std::string heading = below(member);
    const auto write_one = [&](const TomlValue& one) {
      if (!text.empty()) text += "\n";
      text += is_list ? "[[" + heading + "]]\n" : "[" + heading + "]\n";
      write_table(one, heading, text);
    };
    if (!is_list) write_one(member.value);
    for (const TomlValue& one : member.value.items) write_one(one);
  }
}

bool same_lists(const TomlValue& a, const TomlValue& b, const SameLaw& same_law) {
  if (a.size() != b.size()) return false;
  const auto number = [](const TomlValue& list, std::size_t i) {
    return list.numbers ? toml_number((*list.numbers)[i]) : list.items[i];
  };
  if (a.numbers && b.numbers) return *a.numbers == *b.numbers;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool is_same = a.numbers || b.numbers ? same_content(number(a, i), number(b, i), same_law)
                                                : same_content(a.items[i], b.items[i], same_law);
    if (!is_same) return false;
  }
  return true;
}

}  // namespace

std::string toml_file(const TomlValue& table) {
  std::string text;
  write_table(table, "", text);
  return text;
}

bool same_content(const TomlValue& a, const TomlValue& b, const SameLaw& same_law) {
  if (a.is_number() && b.is_number()) return a.real == b.real;
  if (a.kind != b.kind) return false;
  switch (a.kind) {
    case Kind::table:
      return a.members.size() == b.members.size() &&
             std::all_of(a.members.begin(), a.members.end(), [&](const TomlMember& member) {
               const TomlValue* const other = b.find(member.key);
               return other != nullptr && same_content(member.value, *other, same_law);
             });
    case Kind::list:
      return same_lists(a, b, same_law);
    case Kind::boolean:
      return a.boolean == b.boolean;
    default:
      break;
  }
  if (a.law && b.law) return a.law == b.law || (same_law && same_law(*a.law, *b.law));
  return a.text == b.text && !a.law == !b.law;
}

}  // namespace bentur
