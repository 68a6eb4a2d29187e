#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bentur/model/plan/plan_run.h"

// Buildings seen from above as plain data: one description for stills and for what moves on a page.
namespace bentur {

/// What a still in plan shows: the hardest impact, else the moment at which something is nearest to being hit.
struct PlanInstant {
  double time = 0;                          ///< [s]
  std::optional<Eigen::Index> impact = {};  ///< index into PlanResponse::impacts
  std::optional<Eigen::Index> point = {};   ///< contact that is hit, or nearest to it; nothing where there is none
};
/// Of these contacts, or of all.
[[nodiscard]] PlanInstant telling_instant(const PlanResponse& response, const std::vector<Eigen::Index>& points);

/// A centre of a floor.
struct PlanCentre {
  Eigen::Index building = 0, floor = 0;
  PlanPoint at;              ///< in the common plan, at rest [length]
  bool of_rigidity = false;  ///< of the storey below, before anything yields; else of mass
};
/// Of all floors but those of walls, of rigidity of a slab on bearings none.
[[nodiscard]] std::vector<PlanCentre> centres_of(const PlanRun& run);

/// Where the parts of a plan are drawn: gaps and displacements are magnified alike, so that floors that touch in the
/// picture touch: of a gap whose edges are not parallel where they are nearest. Whatever stands across the line of a
/// gap is drawn that much wider.
class PlanScene {
 public:
  /// The response must have histories.
  explicit PlanScene(const PlanRun& run);

  /// 1, 2 or 5 times a power of ten.
  [[nodiscard]] double magnification() const { return magnification_; }
  /// The largest displacement of all, of a rotation half that of the longer side [length].
  [[nodiscard]] double largest() const { return largest_; }
  /// How much further a place at rest is drawn for every 1 of magnification beyond 1 [length].
  [[nodiscard]] PlanPoint spread(const PlanPoint& at) const;
  /// Of a place of the plan at rest [length].
  [[nodiscard]] PlanPoint place(const PlanPoint& at) const;
  /// The same after it has moved [length].
  [[nodiscard]] PlanPoint place(const PlanPoint& at, const PlanPoint& moved) const;
  /// The corners of all there is to see at rest.
  [[nodiscard]] const PlanPoint& lower() const { return lower_; }
  [[nodiscard]] const PlanPoint& upper() const { return upper_; }
  /// The edges of each ring of a footprint, that of its lower left corner first, round and back, with every point at
  /// which a line of a gap begins or ends that crosses an edge obliquely: others are longer for it, no more. Straight
  /// edges stay straight when the footprint turns; a contact along one is then off it by what the magnified gaps across
  /// it turn.
  [[nodiscard]] std::vector<std::vector<PlanPoint>> outlines(const Footprint& footprint) const;

 private:
  /// What lies between two buildings that face each other: all of the plan with from < n · at < to [length].
  struct Line {
    PlanPoint n;
    double from = 0, to = 0;
  };
  [[nodiscard]] std::vector<PlanPoint> outline(const std::vector<PlanPoint>& corners) const;

  std::vector<Line> lines_;  ///< those of one direction together, ascending, and none on another
  double magnification_ = 1, largest_ = 0;
  PlanPoint lower_, upper_;
};

/// u_x, u_y [length] and θ [rad] of a floor at an instant, between two samples in a straight line.
[[nodiscard]] Eigen::Vector3d floor_motion(const PlanHistories& histories, Eigen::Index building, Eigen::Index floor,
                                           double time);
/// How a point of the plan moves with a floor (P-1) [length].
[[nodiscard]] PlanPoint movement_of(const PlanModel& model, Eigen::Index floor, const PlanPoint& at,
                                    const Eigen::Vector3d& motion);
/// Where a contact is along its stretch: "y = 18 m".
[[nodiscard]] std::string along_text(const PlanRun& run, Eigen::Index contact);
/// Whether floors of the buildings are those nearest to a link, which is drawn with them then.
[[nodiscard]] bool is_at(const PlanLink& link, const std::vector<Eigen::Index>& floors, const PlanProblem& problem);
/// Closed lines around an area and its courts, the last point of each the first again.
using PlanRings = std::vector<std::vector<PlanPoint>>;
[[nodiscard]] bool lies_in(const PlanPoint& at, const PlanRings& rings);
/// The parts of a closed line that none of the areas covers.
[[nodiscard]] PlanRings seen_parts(const std::vector<PlanPoint>& ring, const std::vector<PlanRings>& areas);

/// The floor nearest to a level.
[[nodiscard]] Eigen::Index nearest_floor(const PlanModel& model, double elevation);

}  // namespace bentur
