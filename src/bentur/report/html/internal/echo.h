#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "bentur/core/key.h"
#include "bentur/io/toml/toml_value.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur::html {

/// A record as it was read.
[[nodiscard]] Rows rows_of_record(const RecordEcho& record, const Words& say);

[[nodiscard]] inline std::string label_text(const Label& label, const Words& say) {
  return std::string(say.language() == "id" ? label.indonesian : label.english);
}

/// "3", "2", "1".
[[nodiscard]] std::vector<std::string> numbers_from_the_top(std::size_t count);

/// Unit of the numbers of a key in the units of the case; empty where they have none.
[[nodiscard]] std::string unit_of(const Key& key, const Units& units);

/// A table of the case as it was given.
struct Echoed {
  Html markup;
  HtmlTable row;  ///< a column to a key; lists in their order
};

/// A table of the case, those below it too: every key by its label, with its unit, and what is without it where that is
/// not nothing. In tables, values of storeys, floors and elevations stand from the top down.
/// @param more rows after those of the keys
[[nodiscard]] Echoed echo(const KeyTable& keys, const TomlValue& given, const Report& report, const Rows& more = {});
/// The same without the lines of the case on which it stands.
[[nodiscard]] Echoed echo(const KeyTable& keys, const TomlValue& given, const Words& say, const Units& units,
                          const Rows& more = {});

}  // namespace bentur::html
