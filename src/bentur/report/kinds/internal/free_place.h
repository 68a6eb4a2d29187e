#pragma once

#include <string>

#include "bentur/report/figures/figure.h"

namespace bentur {

/// Adds a text beside a point of a picture to scale whose axes have ends: at most a centimetre away, where it lies on
/// no line and no other text that the panel has by now and is nearest to its own point, best right beside, above or
/// below it; where that is not so it is joined to the point by a thin line. Where there is no such place, on as few
/// lines as can be.
/// @param one_cm what a centimetre is [length] @param uncrossed lines which that line does not pass
/// @returns how far from the best place that is [length], where it lies on lines a centimetre more for each
double add_beside(Panel& panel, double x, double y, const std::string& text, double one_cm, const Curve& uncrossed);

}  // namespace bentur
