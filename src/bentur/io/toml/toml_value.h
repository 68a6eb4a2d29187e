#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bentur/core/diagnostics.h"

namespace bentur {

struct OwnLaw;
struct TomlMember;

/// A value of a TOML file, copied out of the parser so that only one source file knows the parser.
struct TomlValue {
  enum class Kind { table, list, text, integer, real, boolean, date };

  Kind kind = Kind::table;
  int line = 0;    ///< from 1; 0 for the file itself
  int column = 0;  ///< from 1, counted in characters
  int origin = 0;  ///< 0: the file; else whatever has put the value in, as SourcePosition::origin
  std::string text;
  std::int64_t integer = 0;
  double real = 0;  ///< also set for integers [unit of the key]
  bool boolean = false;
  std::vector<TomlValue> items;     ///< of a list
  std::vector<TomlMember> members;  ///< of a table, in the order of the file
  /// Of a list of numbers that no file has, such as a record of Python's, in place of `items`.
  std::shared_ptr<const std::vector<double>> numbers;
  std::shared_ptr<const OwnLaw> law;  ///< a law that is not listed; then `text` is its name. No file can say so

  /// How many a list has.
  [[nodiscard]] std::size_t size() const { return numbers ? numbers->size() : items.size(); }
  [[nodiscard]] bool is_number() const { return kind == Kind::integer || kind == Kind::real; }
  /// The value of a key; null where this is no table or has no such key.
  [[nodiscard]] const TomlValue* find(const std::string& key) const;
  [[nodiscard]] TomlValue* find(const std::string& key);
  /// Where it stands in its file, named `file`.
  [[nodiscard]] SourcePosition position(const std::string& file) const { return {file, line, column, origin}; }
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
[[nodiscard]] TomlValue toml_numbers(std::vector<double> numbers);

/// Parses a TOML text. A syntax error is the only one reported then, with its line and column.
/// @param file the name that messages carry.
[[nodiscard]] std::optional<TomlValue> parse_toml(const std::string& text, const std::string& file,
                                                  Diagnostics& diagnostics);

/// Refuses what the parser cannot be trusted with: invalid UTF-8, characters beyond ASCII outside strings and comments
/// (TOML forbids them), or after a backslash at the end of a line in a multi-line string, and nesting beyond 32 levels.
/// @return true when there is nothing of that kind.
[[nodiscard]] bool check_toml_text(const std::string& text, const std::string& file, Diagnostics& diagnostics);

}  // namespace bentur
