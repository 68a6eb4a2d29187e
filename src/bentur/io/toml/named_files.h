#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bentur/io/toml/toml_view.h"

namespace bentur {

/// The files that a text of a case or a study names: one, or those that a pattern such as "records/*.AT2" matches,
/// sorted by name. None, and an error at `named`, where there are none.
/// @param folder that names are relative to
/// @param relative_to what people call it: "the study"
/// @param otherwise goes on where nothing is there: where such files come from; may be empty
[[nodiscard]] std::vector<std::filesystem::path> named_files(const TomlView& named, const std::string& text,
                                                             const std::filesystem::path& folder,
                                                             const std::string& relative_to,
                                                             const std::string& otherwise = {});

/// The way from a folder to a file; the file's own whole name where there is none.
[[nodiscard]] std::string way_from(const std::filesystem::path& folder, const std::filesystem::path& file);

}  // namespace bentur
