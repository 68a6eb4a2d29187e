#pragma once

#include <functional>
#include <string>

#include "bentur/core/key.h"
#include "bentur/io/toml/toml_value.h"

namespace bentur {

/// Gives every file that a table and those in it name another name.
/// @param name of the one that stands there
void rename_files(TomlValue& table, const KeyTable& keys, const std::function<std::string(const std::string&)>& name);

}  // namespace bentur
