#pragma once

#include <string>

#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/scene/scene.h"

namespace bentur {

/// The instant that the options ask for: of the contact point they name, else of all.
[[nodiscard]] SceneInstant chosen_instant(const RunResults& run, const FigureOptions& options);
/// The lines of a shape as one curve, with a gap between each two.
[[nodiscard]] Curve curve_of(const SceneShape& shape, const ScenePlaces& places);
/// The buildings at that instant, at most so high [cm]; its title tells time, magnification and impact.
[[nodiscard]] Panel scene_panel(const RunResults& run, const SceneInstant& instant, const FigureOptions& options,
                                double height);

}  // namespace bentur
