#pragma once

#include <cstdlib>
#include <filesystem>

namespace bentur::test {

/// Answers of an independent program, and records, which the project does not ship: ../shared beside the repository, or
/// the folder that BENTUR_SHARED names. Where it does not exist, as for most users, tests that need it are skipped;
/// `./dev test` runs them like that once more.
inline std::filesystem::path shared_folder() {
  if (const char* named = std::getenv("BENTUR_SHARED")) return named;
  return std::filesystem::path(BENTUR_SOURCE_DIR) / ".." / "shared";
}

}  // namespace bentur::test
