#pragma once

#include <span>
#include <string_view>

#include "bentur/files/example_files.h"

namespace bentur {

/// report.css, the scripts, texts.toml and errors.toml as they stood when the program was built.
[[nodiscard]] std::span<const EmbeddedFile> report_assets();

namespace html {

/// The content of one of them. @throws InvalidParameter when there is none of that name.
[[nodiscard]] std::string_view asset(std::string_view name);

}  // namespace html
}  // namespace bentur
