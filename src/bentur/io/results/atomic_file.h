#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bentur {

/// Writes files of one folder so that a reader sees each of them whole or not at all: every file goes to a temporary
/// name in the same folder, and only when all are there do they take their names. Without commit() nothing stays, not
/// even the folder if it was made here.
/// All functions throw std::runtime_error with the path and the system's reason.
class AtomicFiles {
 public:
  /// Makes the folder if missing and proves that it can be written to.
  explicit AtomicFiles(std::filesystem::path directory);
  ~AtomicFiles();
  AtomicFiles(const AtomicFiles&) = delete;
  AtomicFiles& operator=(const AtomicFiles&) = delete;

  /// Writes `content` under a temporary name beside `name`, a plain file name.
  void add(const std::string& name, std::string_view content);

  /// Renames every file added to its own name, replacing what was there.
  void commit();

 private:
  std::filesystem::path directory_;
  std::vector<std::filesystem::path> made_;                                     // folders made here, outermost first
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> files_;  // temporary and final path
};

}  // namespace bentur
