#pragma once

#include <functional>
#include <string>

#include "bentur/io/toml/toml_value.h"

namespace bentur {

/// A table as a TOML file: what parse_toml() makes of it says the same (same_content()), to the last bit of each
/// number. Tables and lists of tables have headings, keys stand in their order, numbers have the fewest digits that
/// give them back. Of a law that is not listed (TomlValue::law) the name is written, with a comment that no file can
/// say more.
[[nodiscard]] std::string toml_file(const TomlValue& table);

/// Whether two laws that are not listed are the same.
using SameLaw = std::function<bool(const OwnLaw&, const OwnLaw&)>;

/// Whether two values say the same: whole numbers and others count alike, and keys in any order.
[[nodiscard]] bool same_content(const TomlValue& a, const TomlValue& b, const SameLaw& same_law = {});

}  // namespace bentur
