#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "bentur/report/figures/figure.h"

namespace bentur {

/// There is no rsvg-convert among the programs of this machine; what() says how to get it.
class NoConverter : public std::runtime_error {
 public:
  NoConverter();
};

/// svg, pdf, png.
[[nodiscard]] const std::vector<std::string>& picture_formats();

/// Whether pictures of this format can be had here: SVG is written by this library, PDF and PNG by rsvg-convert.
[[nodiscard]] bool can_draw(const std::string& format);

/// The bytes of a picture.
/// @throws NoConverter; std::runtime_error with what rsvg-convert says when it cannot draw; as figure_svg().
[[nodiscard]] std::string draw(const Figure& figure, const std::string& format);

}  // namespace bentur
