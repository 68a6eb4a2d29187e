#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bentur/io/toml/toml_value.h"

namespace bentur {

/// One step of a path: a key of a table, or a place in a list.
using PathStep = std::variant<std::string, std::size_t>;

/// The way to a value of a case, as in `building["Model 2"].frame.beams[0].mass`.
using ParameterPath = std::vector<PathStep>;

/// Takes a path apart. A text in brackets is a key; of a list of tables it is the `name` of one of them.
/// @return nothing where it is not well formed; `error` then says why.
[[nodiscard]] std::optional<ParameterPath> parse_path(const std::string& text, std::string& error);

/// The path in a given case: names of list entries become their places. The last key, and tables on the way to it, may
/// be missing in the case; whether there is such a key is for whoever reads the case to say.
/// @return nothing where there is no such place; `error` then says why, with what may have been meant.
[[nodiscard]] std::optional<ParameterPath> resolved(const TomlValue& root, const ParameterPath& path,
                                                    std::string& error);

/// The value at a resolved path; null when it is missing.
[[nodiscard]] const TomlValue* find_value(const TomlValue& root, const ParameterPath& path);

/// Puts a value at a resolved path, making what is missing. What is put in or made has no line, but `origin`.
void put_value(TomlValue& root, const ParameterPath& path, const TomlValue& value, int origin = 0);

/// Whether one path leads to the other or to a part of it.
[[nodiscard]] bool overlap(const ParameterPath& a, const ParameterPath& b);

/// As a user writes it: `gap[0].width`.
[[nodiscard]] std::string path_text(const ParameterPath& path);

}  // namespace bentur
