#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "bentur/model/closer/nearest_floor.h"
#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"
#include "bentur/report/figures/figure.h"

namespace bentur {

// The picture of the buildings as plain data: one description for stills (kinds/scene_figure.cpp) and for what moves on
// a page (html/motion/motion.js).

/// What a point of the scene follows, or a part of it: a place on a building.
struct SceneMover {
  Eigen::Index building = 0;
  std::optional<Eigen::Index> row = {};  ///< of its SceneMotion; nothing: it stays with the ground below
  double weight = 1;                     ///< of this place among those of the point, which add up to 1
  double offset = 0;                     ///< from the building's left face [length]
  double apart = 0;                      ///< further to the right, magnified as gaps and displacements are [length]
};

struct ScenePoint {
  double height = 0;  ///< [length]
  std::vector<SceneMover> movers = {};
};

enum class SceneRole { ground, soil, bearing, spring, damper, yielding, cable, link, wall, column, slab };
/// "ground", "soil", …
[[nodiscard]] const char* role_name(SceneRole role);

/// Lines of one thing; a line of one point alone is a mark there.
struct SceneShape {
  SceneRole role = SceneRole::ground;
  Eigen::Index item = 0;  ///< number of the building; of a link that in Problem::links
  Tone tone = Tone::grey;
  std::vector<std::vector<ScenePoint>> lines = {};
};

/// A plastic hinge, a dot near the end of its member. How far it has turned is shown in levels: 1 it has yielded, 2 to
/// 4 it has turned beyond the first to the third of its bounds.
struct SceneHinge {
  static constexpr int levels = 4;
  Eigen::Index building = 0, hinge = 0;  ///< of StructuralModel::hinges
  ScenePoint at;
  std::array<double, levels> reached{};  ///< when it comes to each level [s]; infinite: never
  int order = 0;                         ///< from 1, of those of its building by when they first yield; 0: never
  [[nodiscard]] int level(double time) const;
};

/// A column that breaks in shear, or a piece of one that is struck: a cross in the middle of it.
struct SceneBreak {
  Eigen::Index building = 0, column = 0;  ///< of Hinges::columns
  ScenePoint at;
  double time = 0;  ///< when it breaks [s]
};

/// What the bounds of hinges are.
struct HingeBounds {
  /// Limits IO, LS and CP of those that have such; else a quarter, a half and three quarters of `largest`.
  bool are_limits = false;
  double largest = 0;  ///< max |θ| of all [rad]
  static constexpr std::array<double, 3> parts{0.25, 0.5, 0.75};
};
/// Of a level from 1 to 4: the worse the more it warns, where levels are limits; parts of the largest rotation say
/// nothing about damage and have the tone of all that is not a building.
[[nodiscard]] Tone hinge_tone(const HingeBounds& bounds, int level);
/// Each level has a shape of its own, by which it is known without colours.
[[nodiscard]] Mark hinge_mark(int level);

struct Scene {
  std::vector<double> breadths;  ///< of the buildings [length]
  std::vector<double> gaps;      ///< at rest, but none wider than a picture can hold [length]
  double bottom = 0, top = 0;    ///< [length]
  double storey = 0;             ///< the lowest one [length]
  double largest = 0;            ///< displacement of all [length]
  double magnification = 1;      ///< that shows most: 1, 2 or 5 times a power of ten
  std::vector<SceneShape> shapes;
  std::vector<ScenePoint> contacts;  ///< left face of each contact point
  std::vector<SceneHinge> hinges;
  std::vector<SceneBreak> breaks;
  HingeBounds bounds;
};

/// A number that people can say, such as a magnification: 1, 2 or 5 times a power of ten, the nearest.
[[nodiscard]] double round_125(double value);
/// The largest of these that is not above a positive value, for the bar of a scale.
[[nodiscard]] double at_most_125(double value);

/// The response must have histories.
[[nodiscard]] Scene scene_of(const Problem& problem, const Response& response);

/// Displacements [length] of a building: of its floors, then of the nodes in its columns, then of its foundation on
/// soil, which sways; rows × samples.
[[nodiscard]] Eigen::MatrixXd scene_rows(const Histories& histories, std::size_t building);

/// Of each building a column of these.
using SceneMotion = std::vector<Eigen::VectorXd>;
[[nodiscard]] SceneMotion motion_at(const Histories& histories, Eigen::Index column);
[[nodiscard]] SceneMotion at_rest(const Histories& histories);

/// Where points are [length], from the left face of the leftmost building and the datum of elevations.
class ScenePlaces {
 public:
  ScenePlaces(const Scene& scene, double magnification, const SceneMotion& motion);
  [[nodiscard]] std::array<double, 2> operator()(const ScenePoint& point) const;

 private:
  std::vector<double> faces_;
  double magnification_;
  const SceneMotion* motion_;
};

/// What a still shows: the hardest impact, else the moment at which something is nearest to being hit.
struct SceneInstant {
  double time = 0;                          ///< [s]
  std::optional<Eigen::Index> impact = {};  ///< index into Response::impacts
  std::optional<Eigen::Index> point = {};   ///< contact point that is hit, or nearest to it
  const Histories* histories = nullptr;     ///< whose column shows it
  Eigen::Index column = 0;
  const NearestFloor* nearest = nullptr;  ///< where no contact point is as near as this floor
};
/// Of one contact point, or of all and the nearest watched floor.
[[nodiscard]] SceneInstant telling_instant(const Response& response, std::optional<Eigen::Index> point = {},
                                           const NearestFloor* nearest = nullptr);

}  // namespace bentur
