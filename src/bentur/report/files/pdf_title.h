#pragma once

#include <string>
#include <string_view>

namespace bentur {

/// A PDF that says what it is: a title in its information, which rsvg-convert does not write, as an update behind its
/// end (ISO 32000-1, 7.5.6 and 14.3.3). One without a table of objects and information before its end is left as it is.
[[nodiscard]] std::string with_title(std::string pdf, std::string_view title);

}  // namespace bentur
