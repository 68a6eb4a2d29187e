#pragma once

#include <span>

#include "bentur/files/example_files.h"

namespace bentur {

/// report.css and report.js as they stood when the program was built.
[[nodiscard]] std::span<const EmbeddedFile> report_assets();

}  // namespace bentur
