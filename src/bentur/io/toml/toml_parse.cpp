// The only source that knows toml++. Its assertions must hold in every build and throw instead of ending the program
// (some malformed inputs, such as "[#", trip one): see docs/case-file.md.
#undef NDEBUG

#include <stdexcept>

namespace bentur {
namespace {

struct ParserAssertion : std::logic_error {
  using std::logic_error::logic_error;
};
[[noreturn]] void parser_assertion_failed() { throw ParserAssertion("assertion of the TOML parser"); }

}  // namespace
}  // namespace bentur

#define TOML_ASSERT(expr) ((expr) ? static_cast<void>(0) : ::bentur::parser_assertion_failed())
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 1
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "bentur/io/toml/toml_value.h"

namespace bentur {
namespace {

TomlValue copied(const toml::node& node) {
  TomlValue value;
  value.line = static_cast<int>(node.source().begin.line);
  value.column = static_cast<int>(node.source().begin.column);
  if (const toml::table* table = node.as_table()) {
    value.kind = TomlValue::Kind::table;
    for (auto&& [key, child] : *table) {
      value.members.push_back({std::string(key.str()), static_cast<int>(key.source().begin.line),
                               static_cast<int>(key.source().begin.column), copied(child)});
    }
    std::stable_sort(value.members.begin(), value.members.end(), [](const TomlMember& a, const TomlMember& b) {
      return std::tie(a.line, a.column) < std::tie(b.line, b.column);
    });
  } else if (const toml::array* list = node.as_array()) {
    value.kind = TomlValue::Kind::list;
    for (const toml::node& child : *list) value.items.push_back(copied(child));
  } else if (const auto* text = node.as_string()) {
    value.kind = TomlValue::Kind::text;
    value.text = text->get();
  } else if (const auto* integer = node.as_integer()) {
    value.kind = TomlValue::Kind::integer;
    value.integer = integer->get();
    value.real = static_cast<double>(integer->get());
  } else if (const auto* real = node.as_floating_point()) {
    value.kind = TomlValue::Kind::real;
    value.real = real->get();
  } else if (const auto* boolean = node.as_boolean()) {
    value.kind = TomlValue::Kind::boolean;
    value.boolean = boolean->get();
  } else {
    value.kind = TomlValue::Kind::date;
  }
  return value;
}

bool trips_assertion(std::string_view text) {
  try {
    const toml::table parsed = toml::parse(text);
    return false;
  } catch (const ParserAssertion&) {
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

/// The first line with which the parser trips: it reads on and on, so all longer texts trip as well.
int tripping_line(const std::string& text) {
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') ends.push_back(i + 1);
  }
  ends.push_back(text.size());
  const auto line = std::partition_point(ends.begin(), ends.end(), [&](std::size_t end) {
    return !trips_assertion(std::string_view(text).substr(0, end));
  });
  return static_cast<int>(line - ends.begin()) + 1;
}

}  // namespace

std::optional<TomlValue> parse_toml(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  if (!check_toml_text(text, file, diagnostics)) return std::nullopt;
  try {
    TomlValue root = copied(toml::parse(std::string_view(text)));
    root.line = root.column = 0;
    return root;
  } catch (const toml::parse_error& error) {
    diagnostics.error(
        {file, static_cast<int>(error.source().begin.line), static_cast<int>(error.source().begin.column)},
        "not valid TOML: " + std::string(error.description()));
  } catch (const ParserAssertion&) {
    diagnostics.error({file, tripping_line(text), 0}, "not valid TOML: cannot be understood from here on");
  } catch (const std::exception& error) {
    diagnostics.error({file, 0, 0}, std::string("not valid TOML: ") + error.what());
  }
  return std::nullopt;
}

}  // namespace bentur
