#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bentur/contact/law.h"
#include "bentur/excitation/ground_motion.h"
#include "bentur/pounding/plan/faces.h"
#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"
#include "bentur/solve/system.h"
#include "bentur/structure/plan/plan.h"

namespace bentur {

/// A place where two buildings in plan can touch.
struct PlanContact {
  /// Of L and R, 0 the lowest; after the floors a node in a column that is struck there.
  Eigen::Index left_floor = 0, right_floor = 0;
  double elevation = 0;                         ///< [length]
  double along = 0;                             ///< on the stretch [length]
  std::shared_ptr<const ContactLaw> law;        ///< with the share of this point
  std::shared_ptr<const Rubbing> rubbing = {};  ///< that law with friction along the stretch; null: without
  /// Of which family of places at its level: 0 that of the joint, further ones beside it. They touch in the one that
  /// closes last, while all are closed. −1: there is no other.
  Eigen::Index family = -1;
  std::optional<StretchCorner> beside = {};  ///< where it is, of those beside the joint
  Eigen::Index pair = 0;                     ///< of which pair of convex parts, whose families are its own
  double column_shear_capacity = 0;          ///< of a struck column [force]; 0: not given
  double column_moment_capacity = 0;         ///< of a struck column [force·length]; 0: not given

  [[nodiscard]] bool is_of_joint() const { return !beside; }
};

/// A place of a seam between parts of an outline that is not convex: nothing acts there, but contacts of the same pair
/// and level hang on whether its family is closed.
struct PlanSeam {
  Eigen::Index left_floor = 0, right_floor = 0;  ///< as a contact's
  double elevation = 0;                          ///< [length]
  Eigen::Index family = 0, pair = 0;
  StretchCorner at = {};
};

/// An end of the stretch at a floor that faces the other building where no contact is modelled: nothing acts there, but
/// how near it comes is watched.
struct PlanWatched {
  Eigen::Index floor_of = 0;                      ///< index of the building whose floor it is: L or R
  Eigen::Index floor = 0;                         ///< index of that floor
  std::optional<Eigen::Index> facing_floor = {};  ///< of the other building; nothing: the edge between two floors
  double elevation = 0;                           ///< [length]
  double along = 0;                               ///< on the stretch [length]
  std::optional<StretchCorner> beside = {};       ///< where it is, of those beside the joint
};

/// What lies between two buildings that face each other.
struct PlanGap {
  Eigen::Index left = 0, right = 0;  ///< L and R of the stretch, indices into PlanProblem::buildings
  Stretch stretch;
  /// Level after level from the lowest up, each along the stretch; then those beside it, likewise.
  std::vector<PlanContact> contacts = {};
  std::vector<PlanWatched> watched = {};  ///< likewise
  std::vector<PlanSeam> seams = {};       ///< in any order

  /// Whether a contact is of the joint of its pair of parts, so that what it needs they need: of outlines that turn
  /// inwards each pair has one of its own, or where that is a seam its other places that are open at rest.
  [[nodiscard]] bool is_of_pair(const PlanContact& contact) const {
    if (contact.family <= 0) return true;
    return width_at(contact) >= 0 && std::none_of(contacts.begin(), contacts.end(), [&](const PlanContact& other) {
             return other.family <= 0 && other.pair == contact.pair && other.elevation == contact.elevation;
           });
  }
  /// Where a contact of it is, or what is watched.
  template <class Place>
  [[nodiscard]] StretchCorner at(const Place& place) const {
    return place.beside ? *place.beside : stretch.at(place.along);
  }
  /// w there [length]; below zero of a family beside the joint that is closed at rest.
  template <class Place>
  [[nodiscard]] double width_at(const Place& place) const {
    return stretch.width + at(place).beyond;
  }
  /// In the middle of both edges.
  template <class Place>
  [[nodiscard]] PlanPoint middle(const Place& place) const {
    const StretchCorner corner = at(place);
    return 0.5 * (corner.left + corner.right);
  }
  /// How much that place opens where the gap widens by 1, its buildings going apart along the joint's normal [-].
  template <class Place>
  [[nodiscard]] double opens(const Place& place) const {
    return place.beside ? place.beside->normal.dot(stretch.n) : 1.0;
  }
};

/// What joins a floor of L and one of R at a place of their joint: the deformation is how far their edges come nearer
/// along a direction there (P-24).
struct PlanLink {
  Link link;  ///< of buildings L and R of the stretch, in this order
  Stretch stretch;
  double along = 0;                          ///< on the stretch [length]
  PlanPoint direction = PlanPoint::UnitX();  ///< of length 1
};

/// Buildings in plan and what a solver needs of them, in consistent units: what Problem is of a row.
struct PlanProblem {
  std::vector<PlanBuilding> buildings;
  std::vector<PlanGap> gaps;                           ///< by their buildings
  std::vector<PlanLink> links = {};                    ///< in any order
  std::array<GroundMotion, 2> motions;                 ///< two components, by default along x and y
  Eigen::Matrix2d axes = Eigen::Matrix2d::Identity();  ///< columns: along which they act (P-3)
  std::vector<double> delays = {};                     ///< [s] ≥ 0, one per building; empty: all zero
  Kinematics kinematics = Kinematics::relative;
  std::vector<Eigen::VectorXd> initial_displacement;  ///< per building, dofs [length, rad]; empty: at rest
  std::vector<Eigen::VectorXd> initial_velocity;      ///< likewise [length/s, rad/s]
  double duration = 0;                                ///< [s] > 0
  bool goes_on = false;                               ///< as Problem's
  /// Drift ratio [-] > 0 of an edge, along it, at which a storey of a building with gravity loads has collapsed, which
  /// ends the run.
  double collapse_drift = 0.1;
  /// Per building the same with its masses where they may stand as well, none of a building whose masses stand where
  /// they are; empty: of none. What gaps need is then the most of all choices (masses_elsewhere.h).
  std::vector<std::vector<PlanBuilding>> elsewhere = {};
};

/// "A | B", as the buildings stand in the problem.
[[nodiscard]] std::string gap_name(const PlanProblem& problem, const PlanGap& gap);

/// The column that is struck at a contact: of L or R, and which of PlanModel::nodes; nothing where floors meet.
[[nodiscard]] std::optional<StruckColumn> struck_column(const PlanProblem& problem, const PlanGap& gap,
                                                        const PlanContact& contact);

/// The floor of L (0) or R (1) at a contact; of a column that is struck the floor above.
[[nodiscard]] Eigen::Index floor_at(const PlanProblem& problem, const PlanGap& gap, const PlanContact& contact,
                                    int side);

/// Of each point of its system the place among the contacts of all gaps, −1 of seams: those that rub are the system's
/// last, and seams before them.
[[nodiscard]] std::vector<Eigen::Index> places_of(const PlanProblem& problem);

/// @throws InvalidParameter when sizes disagree or a value is outside its range.
void validate(const PlanProblem& problem);

/// Bodies and contacts of a valid problem, gap after gap (P-6), those that rub apart, and what is watched. @param
/// levels what rules for gaps take is watched in the free response: level_interfaces() of the contacts of all gaps,
/// then of all that is watched, no face of which is a floor
[[nodiscard]] System system_of(const PlanProblem& problem, bool levels = false);

/// The storey, from 0, whose edge passed its limit, where one did.
[[nodiscard]] std::optional<Collapse> collapse_of(const PlanProblem& problem, const Solution& solution);

}  // namespace bentur
