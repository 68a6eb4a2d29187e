#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bentur/core/diagnostics.h"

namespace bentur {

struct TomlMember;

/// A value of a TOML file, copied out of the parser so that only one source file knows the parser.
struct TomlValue {
  enum class Kind { table, list, text, integer, real, boolean, date };

  Kind kind = Kind::table;
  int line = 0;    ///< from 1; 0 for the file itself
  int column = 0;  ///< from 1, counted in characters
  std::string text;
  std::int64_t integer = 0;
  double real = 0;  ///< also set for integers [unit of the key]
  bool boolean = false;
  std::vector<TomlValue> items;     ///< of a list
  std::vector<TomlMember> members;  ///< of a table, in the order of the file
};

/// One `key = value` of a table.
struct TomlMember {
  std::string key;
  int line = 0;  ///< of the key
  int column = 0;
  TomlValue value;
};

/// A number as the case reader takes it.
[[nodiscard]] TomlValue toml_number(double value);
[[nodiscard]] TomlValue toml_text(const std::string& text);

/// Parses a TOML text. A syntax error is the only one reported then, with its line and column.
/// @param file the name that messages carry.
[[nodiscard]] std::optional<TomlValue> parse_toml(const std::string& text, const std::string& file,
                                                  Diagnostics& diagnostics);

/// Refuses what the parser cannot be trusted with: invalid UTF-8, characters beyond ASCII outside strings and comments
/// (TOML forbids them), or after a backslash at the end of a line in a multi-line string, and nesting beyond 32 levels.
/// @return true when there is nothing of that kind.
[[nodiscard]] bool check_toml_text(const std::string& text, const std::string& file, Diagnostics& diagnostics);

}  // namespace bentur
