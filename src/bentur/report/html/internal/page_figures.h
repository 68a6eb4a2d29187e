#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bentur/report/kinds/kinds.h"

namespace bentur::html {

/// A figure that stands in a page as inline SVG.
struct PageFigure {
  std::string caption;
  std::string svg;         ///< by figure_element()
  bool wide = false;       ///< wider than a journal's column
  bool is_parted = false;  ///< is of several pictures, one below another
  std::string slim = {};   ///< the same for a telephone, where it can be drawn so
};

using MakeKind = std::function<Figure(const std::string& kind, const FigureOptions& options)>;

/// Every figure that tells something of some results, in the order in which a page shows them.
/// @param family of captions in texts.toml: "figure.", "figure.sweep."
[[nodiscard]] std::vector<PageFigure> page_figures(const std::vector<FigureKind>& kinds, const MakeKind& make,
                                                   const std::string& family, const std::string& language);

}  // namespace bentur::html
