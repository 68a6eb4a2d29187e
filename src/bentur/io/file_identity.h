#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace bentur {

/// SHA-256 [FIPS 180-4] as 64 hexadecimal digits, what `sha256sum` prints.
[[nodiscard]] std::string sha256(std::string_view bytes);

/// A file by its content.
struct FileIdentity {
  std::uintmax_t size = 0;  ///< bytes
  std::string sha256;
};

/// @throws std::runtime_error with the file's name when it cannot be read.
[[nodiscard]] FileIdentity identify(const std::filesystem::path& file);

}  // namespace bentur
