#pragma once

#include "bentur/report/figures/figure.h"

namespace bentur {

/// Rays around a place where something strikes.
[[nodiscard]] Curve burst(double x, double y, double size);

}  // namespace bentur
