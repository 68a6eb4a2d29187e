#pragma once

#include <vector>

#include "bentur/report/scene/internal/symbols.h"
#include "bentur/report/scene/scene.h"

namespace bentur::scene {

[[nodiscard]] HingeBounds hinge_bounds(const Problem& problem, const Response& response);

/// All hinges of a building, without their places.
[[nodiscard]] std::vector<SceneHinge> hinges_of(const Problem& problem, const Response& response, Eigen::Index building,
                                                const HingeBounds& bounds);

/// How many hinges of struck nodes of the same column come before this one.
[[nodiscard]] std::size_t nodes_before(const std::vector<HingePlace>& places, Eigen::Index hinge);

/// The columns of a building that break, without their places.
[[nodiscard]] std::vector<SceneBreak> breaks_of(const Problem& problem, const Response& response,
                                                Eigen::Index building);

/// The middle of a column from the level below to the one above it, on its line, or of one of its pieces, from 1.
[[nodiscard]] ScenePoint amid_column(const SceneLine& line, Eigen::Index piece, double below, double above);

// Clear of the joint, so that those that meet there can be distinguished.

/// Of a column from the level below to the one above it, on its line; `node`: which of its struck places, from 0.
[[nodiscard]] ScenePoint on_column(const SceneLine& line, HingePlace::End end, double below, double above,
                                   std::size_t node);
/// Of a beam from one share of a floor, so wide [length], to another.
[[nodiscard]] ScenePoint on_beam(const SceneLine& floor, HingePlace::End end, double from, double to, double breadth,
                                 double storey);

}  // namespace bentur::scene
