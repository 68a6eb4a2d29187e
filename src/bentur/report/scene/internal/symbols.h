#pragma once

#include <vector>

#include "bentur/report/scene/scene.h"

namespace bentur::scene {

using SceneLine = std::vector<ScenePoint>;

/// The point that is `share` of the way from a to b, wherever the two move, and `rise` above it [length].
[[nodiscard]] ScenePoint between(const ScenePoint& a, const ScenePoint& b, double share, double rise = 0);

// Symbols between two points that move, `size` the half of their thickness [length].

using Symbol = std::vector<SceneLine>(const ScenePoint& a, const ScenePoint& b, double size);
Symbol spring;
Symbol damper;  ///< a piston in a pot
Symbol plates;  ///< two that slide on one another
Symbol cable;   ///< it sags
Symbol bar;
[[nodiscard]] SceneLine upright_spring(const ScenePoint& a, const ScenePoint& b, double size);

}  // namespace bentur::scene
