#pragma once

#include <functional>

#include "bentur/report/kinds/kinds.h"

namespace bentur {

/// A figure made by these options.
using MakeFigure = std::function<Figure(const FigureOptions& options)>;

/// For a telephone or a journal's column: of `options.width`, with its panels one below another where they can stand
/// so. What stays broader has panels that belong beside one another.
[[nodiscard]] Figure narrow_figure(const MakeFigure& make, FigureOptions options);

/// A figure `width` [cm] wide, which asks for no more than that even where it has panels beside one another; broader
/// only where these belong together. It is no higher than a page.
[[nodiscard]] Figure figure_of_width(const MakeFigure& make, FigureOptions options, double width);

/// Makes frames that are no pictures lower, as far as can be read, so that the figure is at most so high [cm].
void bound_height(Figure& figure, double most);

}  // namespace bentur
