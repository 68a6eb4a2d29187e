#pragma once

#include <string>

namespace bentur {

/// A length in pixels, to a hundredth, "-1.5"; far outside of every frame where it would have no end or is none.
[[nodiscard]] std::string length(double pixels);

/// The same at the end of a text: of the points of a curve there are many.
void add_length(std::string& text, double pixels);

}  // namespace bentur
