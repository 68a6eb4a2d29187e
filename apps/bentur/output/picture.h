#pragma once

#include <filesystem>
#include <vector>

#include "bentur/io/output/output_rules.h"
#include "bentur/report/files/figure_files.h"

namespace bentur::cli {

/// Whether a file's name ends as a picture's does.
[[nodiscard]] bool is_picture(const std::filesystem::path& file);

/// Before the work: @throws Failure when the name has no such ending (exit_bad_input) or what draws it is missing
/// (exit_other), RefusedOutput when it or what stands beside it must not be written.
void expect_picture(const std::filesystem::path& file, const OutputRules& rules);

/// Says which letters of the figures their font has not; nothing where it has all.
void tell_letters(const std::vector<NamedFigure>& figures);

/// Draws a figure into `file` and puts data and script beside it. @throws as expect_picture().
void write_picture(const std::filesystem::path& file, const Figure& figure, const OutputRules& rules);

}  // namespace bentur::cli
