#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include "bentur/core/diagnostics.h"

namespace bentur {

/// Where JSON ends to be JSON. @param byte of the text, from 1, at which its reader gave up
[[nodiscard]] inline SourcePosition json_position(const std::string& file, const std::string& text, std::size_t byte) {
  const std::size_t at = std::min(text.size(), byte > 0 ? byte - 1 : 0);
  const std::size_t newline = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  const std::size_t line_begin = newline == std::string::npos ? 0 : newline + 1;
  const auto lines = std::count(text.data(), text.data() + line_begin, '\n');
  return {file, static_cast<int>(lines) + 1, static_cast<int>(at - line_begin) + 1};
}

inline constexpr const char* no_json = "is not JSON from here on";

}  // namespace bentur
