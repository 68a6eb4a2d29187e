#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bentur/io/output/output_rules.h"
#include "bentur/report/files/figure_files.h"
#include "output/output.h"

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

/// The figures of a run in the folder "figures" beside its results.
class RunPictures {
 public:
  /// Before the work: @throws RefusedOutput when one of them must not be written. Nothing is drawn without formats.
  RunPictures(const RunFolder& results, std::vector<std::string> formats);
  /// Draws them, and says so unless `quiet`; where a converter is missing, that.
  void write(const std::vector<NamedFigure>& figures, bool quiet) const;
  [[nodiscard]] static FigureOptions options(const std::string& language);

 private:
  std::filesystem::path folder_;
  std::vector<std::string> formats_;
  OutputRules rules_;
};

}  // namespace bentur::cli
