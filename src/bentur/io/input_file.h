#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "bentur/core/diagnostics.h"

namespace bentur {

/// A kind of file that a user names, and how much of it is read.
struct InputKind {
  const char* what;          ///< as messages call it: "case file"
  std::uintmax_t largest{};  ///< bytes
};

inline constexpr InputKind case_input{"case file", std::uintmax_t{16} << 20};
inline constexpr InputKind study_input{"study", std::uintmax_t{16} << 20};
inline constexpr InputKind record_input{"record", std::uintmax_t{64} << 20};
inline constexpr InputKind figure_input{"figure", std::uintmax_t{64} << 20};
inline constexpr InputKind logo_input{"logo", std::uintmax_t{256} << 10};
inline constexpr InputKind result_input{"result", std::uintmax_t{1} << 40};

/// What keeps a file from being read, as a message says it: it is not there, is no regular file (a folder, a device, a
/// pipe), is too large, or the system forbids it. Empty where nothing does. Nothing is opened.
[[nodiscard]] std::string input_problem(const std::filesystem::path& file, const InputKind& kind);

/// The bytes of a regular file, or nothing and why in `problem`. Devices and pipes are not waited for, and no more than
/// `kind.largest` bytes are read, whatever the file's size is said to be.
[[nodiscard]] std::optional<std::string> read_input(const std::filesystem::path& file, const InputKind& kind,
                                                    std::string& problem);
/// The same; why not goes to `diagnostics`, about the file as a whole.
[[nodiscard]] std::optional<std::string> read_input(const std::filesystem::path& file, const InputKind& kind,
                                                    Diagnostics& diagnostics);

}  // namespace bentur
