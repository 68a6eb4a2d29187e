#pragma once

#include <string>

#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/scene/scene.h"

namespace bentur {

/// The instant that the options ask for: of the contact point they name, else of all.
[[nodiscard]] SceneInstant chosen_instant(const RunResults& run, const FigureOptions& options);
/// The floor that is nearest to what it faces, where the options ask for no other place.
[[nodiscard]] const NearestFloor* asked_nearest(const RunResults& run, const FigureOptions& options);
/// The same where it goes inside what it faces, nothing is struck there, and its opening is known over time.
[[nodiscard]] const NearestFloor* asked_inside(const RunResults& run, const FigureOptions& options);
/// "roof of Low 0.0714 m inside High, contact not modelled". @param depth with its unit
[[nodiscard]] std::string inside_words(const Problem& problem, const WatchedFloor& floor, const std::string& depth,
                                       const std::string& length, const FigureWords& say);
[[nodiscard]] std::string inside_text(const RunResults& run, const NearestFloor& nearest, const FigureOptions& options);
/// The opening at the level of a floor that goes inside what it faces.
[[nodiscard]] Figure inside_opening(const RunResults& run, const NearestFloor& inside, const FigureOptions& options);
/// What a still's title does not say of floors inside what they face: how many are at this instant, and the deepest of
/// the run, so that a picture of what is modelled does not pass over what is not; empty where there is none.
[[nodiscard]] std::string inside_besides(const RunResults& run, const FigureOptions& options);
/// The lines of a shape as one curve, with a gap between each two.
[[nodiscard]] Curve curve_of(const SceneShape& shape, const ScenePlaces& places);
/// The buildings at that instant, at most so high [cm]; its title tells time, magnification and impact.
[[nodiscard]] Panel scene_panel(const RunResults& run, const SceneInstant& instant, const FigureOptions& options,
                                double height);

}  // namespace bentur
