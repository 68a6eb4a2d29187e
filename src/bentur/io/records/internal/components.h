#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bentur/io/records/internal/record_text.h"

// Components of ground motion by the names that files and users have for them.
namespace bentur::records {

/// Whether two names are of the same component: "N-S", "NS", "NORTH", "N00E", "Chan 1: 360 Deg" are one; other names
/// are the same where their letters and digits are.
[[nodiscard]] bool same_component(const std::string& one, const std::string& other);

/// Whether a name is one of a direction, as "N-S", "Up" or "N80W".
[[nodiscard]] bool is_direction(const std::string& name);

/// The place among `names` of the component that the user asks for. An error where it is not there, or twice.
/// @param otherwise the key that chooses by number, "column" or "channel"
[[nodiscard]] std::optional<std::size_t> named_component(const std::vector<std::string>& names, const char* otherwise,
                                                         const RecordOptions& options, RecordErrors& errors);

/// A name between quotes, as messages have it.
[[nodiscard]] std::string in_words(const std::string& name);

/// Without what is no printable ASCII.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace bentur::records
