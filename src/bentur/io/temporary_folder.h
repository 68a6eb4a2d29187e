#pragma once

#include <filesystem>

namespace bentur {

/// A private folder that is gone, with all that is in it, when this is.
/// @throws std::runtime_error with the path and the system's reason when it cannot be made.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace bentur
