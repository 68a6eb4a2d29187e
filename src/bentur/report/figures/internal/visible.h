#pragma once

#include "bentur/report/figures/figure.h"
#include "bentur/report/figures/internal/thin.h"

namespace bentur {

// What of a figure's data is drawn.

/// @throws InvalidParameter when a panel has nothing to draw, or sizes disagree.
void check(const Figure& figure);

/// Whether a panel has nothing to draw.
[[nodiscard]] bool is_empty(const Panel& panel);

/// The points of a curve that can be seen in a frame of this width [cm]; of a line that would fill its envelope that.
[[nodiscard]] Points visible(const Curve& curve, double width);

/// Of the envelope of a line.
constexpr double band_opacity = 0.3;

/// A map whose neighbouring cells are merged, keeping the largest, until there are few enough for a file.
[[nodiscard]] HeatMap merged(const HeatMap& map);

}  // namespace bentur
