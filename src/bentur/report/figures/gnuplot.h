#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bentur/report/figures/figure.h"

namespace bentur {

/// There is no gnuplot among the programs of this machine; what() says how to get it.
class NoGnuplot : public std::runtime_error {
 public:
  NoGnuplot();
};

/// "gnuplot 5.4 patchlevel 4", or nothing where it is not installed.
[[nodiscard]] std::optional<std::string> gnuplot_version();

/// svg, pdf, png.
[[nodiscard]] const std::vector<std::string>& picture_formats();

/// The bytes of a picture, drawn by gnuplot in a folder of its own, without a shell and without the user's settings.
/// @throws NoGnuplot; std::runtime_error with what gnuplot says when it cannot draw.
[[nodiscard]] std::string draw(const FigureText& text, const std::string& name, const std::string& format);

}  // namespace bentur
