#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "bentur/core/diagnostics.h"
#include "bentur/io/records/record_files.h"
#include "bentur/io/temporary_folder.h"

namespace bentur::test {

/// A record file that lives as long as the test.
class RecordFile : public ::testing::Test {
 protected:
  std::optional<StrongMotionRecord> read(const std::string& text, const RecordOptions& options = {}) {
    std::ofstream(file_, std::ios::binary) << text;
    diagnostics_ = Diagnostics();
    return read_record(file_, options, diagnostics_);
  }

  /// The messages without the file's name, one in a line.
  [[nodiscard]] std::string messages() const {
    std::string all;
    for (const Diagnostic& error : diagnostics_.errors()) all += error.text().substr(file_.string().size()) + "\n";
    return all;
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "record";
  Diagnostics diagnostics_;
};

}  // namespace bentur::test
