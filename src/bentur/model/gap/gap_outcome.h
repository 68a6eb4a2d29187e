#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bentur/model/gap/minimum_gap.h"
#include "bentur/model/judgement/compare.h"
#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"

namespace bentur {

/// Where the gap between two neighbours falls short the most, or has least to spare: at a contact point, or at a
/// watched floor.
struct GoverningLevel {
  std::optional<Eigen::Index> watched;  ///< index into Problem::watched; nothing: a contact point
  Eigen::Index point = 0;               ///< of that the index into Problem::points
  double elevation = 0;                 ///< [length]
  // As widths of the whole gap (largest_of()):
  double width = 0;                                ///< given [length]
  double gap_needed = 0;                           ///< [length]
  std::optional<double> gap_needed_reversed = {};  ///< there, under the ground motion times −1 [length]
  double scale = 0;                                ///< displacement_scale() [length]
  /// The same at its place, for people: beside a joint in plan what is given and needed there [length].
  double width_here = 0, needed_here = 0;

  /// Whether the gap is too narrow by more than round-off.
  [[nodiscard]] bool is_short() const;
};

/// The scale of a gap's round-off: the largest displacements of both neighbours together [length].
[[nodiscard]] double displacement_scale(const Problem& problem, const Response& response, Eigen::Index gap);

/// Of the levels of one gap; of those that are alike the highest contact point. A need no larger than round-off is
/// none. Nothing where there are no levels.
[[nodiscard]] std::optional<GoverningLevel> governing_level(const std::vector<LevelSeparation>& levels, double scale);

/// When they move freely. Gaps are counted by the building to their left. A gap has a contact point or a watched floor.
[[nodiscard]] GoverningLevel governing_level(const Problem& problem, const Response& response, Eigen::Index gap);

/// Whether a drift counts as collapse [-] where nothing looks for that, as no gravity acts.
/// @param limit Problem::collapse_drift
[[nodiscard]] inline bool drifts_beyond_collapse(double drift, bool has_gravity, double limit) {
  return !has_gravity && drift > limit;
}

/// Whether without contact a storey collapses, or drifts that far where nothing looks for it: what gaps need is not
/// known then.
[[nodiscard]] bool falls_without_contact(const Problem& problem, const Response& response);
/// The same under the ground motion times −1; where that was not looked at, not.
[[nodiscard]] bool falls_without_contact_reversed(const Problem& problem, const Response& response);

/// The gap needed: the width of the whole gap with which none of its contact points and watched floors closes, the
/// gap's own width + max(need − width of the place) [length].
[[nodiscard]] double gap_needed(const Problem& problem, const Response& response, Eigen::Index gap);
/// The same under the ground motion times −1; nothing where that is not known.
[[nodiscard]] std::optional<double> gap_needed_reversed(const Problem& problem, const Response& response,
                                                        Eigen::Index gap);

/// Indices into Problem::watched of those floors that met what they face in the run, the deepest first.
/// @param watched of a response, or of its reversed run
[[nodiscard]] std::vector<Eigen::Index> unmodelled_contacts(const Problem& problem,
                                                            const std::vector<WatchedSummary>& watched,
                                                            Eigen::Index gap);

/// By peak force, then, as where no force is known, by closing speed.
[[nodiscard]] bool is_harder(const Impact& a, const Impact& b);
/// The hardest impact of a contact point, or of all, the first of those that are alike; nothing where there is none.
[[nodiscard]] const Impact* hardest_impact(const std::vector<Impact>& impacts, std::optional<Eigen::Index> point = {});

/// Contact in a gap.
struct Hit {
  long impacts = 0;                 ///< where there are none, contacts that come to rest
  long touched = 0;                 ///< contact points hit
  Eigen::Index point = 0;           ///< with the largest force, else the fastest impact; of those alike the first
  const Impact* hardest = nullptr;  ///< there; null where it is not known
};
/// @param of_gap its points, at least one
[[nodiscard]] Hit hit_of(const std::vector<PointSummary>& points, const std::vector<Impact>& impacts,
                         const std::vector<Eigen::Index>& of_gap);

/// What is reported first of a gap.
struct GapOutcome {
  Gap gap;
  int impacts = 0;
  int touched = 0;  ///< contact points hit
  std::optional<Eigen::Index> hardest =
      {};                    ///< contact point with the largest force, else the fastest impact; the highest
  GoverningLevel governing;  ///< where the gap falls short the most
  std::vector<Eigen::Index> unmodelled = {};  ///< as unmodelled_contacts()
};
[[nodiscard]] GapOutcome gap_outcome(const Problem& problem, const Response& response, Eigen::Index gap);

/// How a case can model what a watched floor does.
struct Remedy {
  enum class Kind {
    name_elevation,   ///< the two floors are at one level: name it in gap.elevations
    raise_tolerance,  ///< a floor of the other building is near: let them meet by gap.level_tolerance
    strike_column,    ///< it faces a column of a frame: name it in gap.elevations with gap.strikes_columns
    give_columns,     ///< it faces a building whose columns are not known: give that one as a frame
    give_floor,       ///< in plan: nothing is struck between floors
    give_wall,        ///< it faces a base, which is no floor: put a wall in that building's place
  };
  Kind kind = Kind::give_columns;
  double level = 0;      ///< [length] of the level to name, or of the floor that is near
  double tolerance = 0;  ///< [length] that lets them meet
};
/// @param in_plan of a pair of buildings in plan
[[nodiscard]] Remedy remedy_for(const Problem& problem, const WatchedFloor& floor, bool in_plan = false);

/// The same in words. `length` is the case's unit.
[[nodiscard]] std::string remedy_text(const Problem& problem, const WatchedFloor& floor, const std::string& length,
                                      bool in_plan = false);

/// "the floor of A", whose elevation is known from elsewhere.
[[nodiscard]] std::string floor_text(const Problem& problem, const WatchedFloor& floor);

/// Whether it faces the base of the other building, which moves with the ground.
[[nodiscard]] bool faces_base(const Problem& problem, const WatchedFloor& floor);

/// "the column of B", "the floor of B" or "the base of B".
[[nodiscard]] std::string faced_text(const Problem& problem, const WatchedFloor& floor);

}  // namespace bentur
