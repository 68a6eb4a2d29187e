#pragma once

#include <filesystem>

#include "bentur/report/figures/figure.h"

namespace bentur::cli {

/// Whether a file's name ends as a picture's does.
[[nodiscard]] bool is_picture(const std::filesystem::path& file);

/// Draws a figure into `file` and puts data and script beside it. @throws Failure when the name has no such ending
/// (exit_bad_input) or gnuplot is missing (exit_other).
void write_picture(const std::filesystem::path& file, const Figure& figure);

}  // namespace bentur::cli
