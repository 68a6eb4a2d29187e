#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bentur/contact/law.h"
#include "bentur/excitation/ground_motion.h"
#include "bentur/structure/building.h"

namespace bentur {

/// A place where two buildings can touch, at one elevation: of a row two neighbours.
/// Opening g = width + x_right − x_left (T-1).
struct ContactPoint {
  Eigen::Index left = 0;         ///< index of the left building
  Eigen::Index left_floor = 0;   ///< index of its floor (0 the lowest), or, after the floors, of a node in its column
  Eigen::Index right_floor = 0;  ///< the same of the right building
  double elevation = 0;          ///< [length]
  double width = 0;              ///< w [length] ≥ 0
  double beyond = 0;    ///< of w, what edges that are not parallel add to the width of the gap here [length] ≥ 0
  double opens = 1;     ///< how much w grows where the gap widens by 1 [-]
  bool beside = false;  ///< in plan: of other parts than the gap's joint is
  std::shared_ptr<const ContactLaw> law;
  double column_shear_capacity = 0;   ///< of a struck column [force]; 0: not given
  double column_moment_capacity = 0;  ///< of a struck column [force·length]; 0: not given
  Eigen::Index right = left + 1;      ///< index of the right building
  Eigen::Index gap = left;            ///< number of the gap that it is in
};

/// A floor that faces its neighbour where no contact is modelled: nothing acts there, but how near it comes is watched.
/// Opening g = width + x_right − x_left, each x a row over the dofs of its building.
struct WatchedFloor {
  Eigen::Index left = 0;                     ///< index of the left building
  Eigen::Index floor_of = 0;                 ///< index of the building whose floor it is: left or right
  Eigen::Index floor = 0;                    ///< index of that floor
  std::optional<Eigen::Index> facing_floor;  ///< of the other building; nothing: a column between two floors
  double elevation = 0;                      ///< [length]
  double width = 0;                          ///< w [length] ≥ 0
  double beyond = 0;                         ///< as ContactPoint::beyond [length] ≥ 0
  double opens = 1;                          ///< as ContactPoint::opens [-]
  bool beside = false;                       ///< as ContactPoint::beside
  Eigen::VectorXd left_row, right_row;       ///< [-, or length on rotations]
  Eigen::Index right = left + 1;             ///< index of the right building
  Eigen::Index gap = left;                   ///< number of the gap that it is in

  /// The other of the two.
  [[nodiscard]] Eigen::Index faced() const { return floor_of == left ? right : left; }
};

/// What joins two buildings of the row, neighbours or not, at one elevation: F of δ = x_left − x_right pushes left −F
/// and right +F.
struct Link {
  Eigen::Index left = 0, right = 1;              ///< indices of the buildings, left < right
  Eigen::Index left_floor = 0, right_floor = 0;  ///< indices of their floors (0 the lowest)
  double elevation = 0;                          ///< [length]
  std::shared_ptr<const Law> law;
  std::string kind = {};  ///< what it is, for people: "spring", "dashpot", or the name of its law
};

/// The two buildings of a gap, indices.
struct GapPair {
  Eigen::Index left = 0, right = 1;
};

enum class Kinematics { relative, absolute };

/// For how many first periods of the slowest building a run goes on past its motion, at most.
constexpr double most_periods_after = 10;

/// Everything a solver needs, in consistent units. It reads no file and knows no key. Indices of buildings, floors and
/// points count from 0 and are Eigen::Index, the signed type that both vectors and matrices take.
struct Problem {
  std::vector<Building> buildings;         ///< left to right
  std::vector<ContactPoint> points;        ///< ordered by left building, then elevation
  std::vector<WatchedFloor> watched = {};  ///< ordered likewise
  std::vector<Link> links = {};            ///< in any order
  GroundMotion motion;
  std::vector<double> delays = {};  ///< τ_b [s] ≥ 0, one per building; empty: all zero
  Kinematics kinematics = Kinematics::relative;
  std::vector<Eigen::VectorXd> initial_displacement;  ///< per building, dofs [length, rad]; empty: at rest
  std::vector<Eigen::VectorXd> initial_velocity;      ///< per building, dofs [length/s, rad/s]; empty: at rest
  double duration = 0;                                ///< [s] > 0
  /// The run goes on past that until no gap can need more (docs/theory/exact-solver.md, After the motion), at most
  /// `most_periods_after` first periods of the slowest building.
  bool goes_on = false;
  /// Drift ratio [-] > 0 at which a storey of a building with gravity loads has collapsed, which ends the run.
  double collapse_drift = 0.1;
  std::vector<GapPair> sides = {};  ///< of each gap; empty: of each two neighbours, left to right
};

/// A column between floors that a floor strikes: of a building, and which of its nodes.
struct StruckColumn {
  Eigen::Index building = 0, node = 0;
};
/// Index of the floor that the left (0) or right (1) face is; nothing of a column's.
[[nodiscard]] std::optional<Eigen::Index> face_floor(const Problem& problem, const ContactPoint& point, int side);
[[nodiscard]] std::optional<Eigen::Index> face_floor(const WatchedFloor& floor, int side);

/// The one at a contact point; nothing where floors meet.
[[nodiscard]] std::optional<StruckColumn> struck_column(const Problem& problem, const ContactPoint& point);

/// What lies between two buildings: indices into Problem::points and Problem::watched, from the lowest up.
struct Gap {
  Eigen::Index number = 0;  ///< among the gaps of the problem
  Eigen::Index left = 0, right = 1;
  std::vector<Eigen::Index> points, watched;
};

[[nodiscard]] Eigen::Index gap_count(const Problem& problem);
/// @throws InvalidParameter unless there are so many.
[[nodiscard]] GapPair sides_of(const Problem& problem, Eigen::Index gap);
/// The two buildings as people read of them, whichever comes first in the case.
[[nodiscard]] std::vector<Eigen::Index> buildings_of(const Problem& problem, Eigen::Index gap);
/// The gaps of a problem, left to right.
[[nodiscard]] std::vector<Gap> gaps_of(const Problem& problem);
/// One of them. @throws InvalidParameter unless there are so many.
[[nodiscard]] Gap gap_at(const Problem& problem, Eigen::Index gap);

/// τ_b [s] of a building: 0 where the problem gives no delays.
[[nodiscard]] double delay_of(const Problem& problem, std::size_t building);

/// "Model 1 | Model 2", as buildings_of() a gap.
[[nodiscard]] std::string gap_name(const Problem& problem, Eigen::Index gap);
/// Of every gap, left to right.
[[nodiscard]] std::vector<std::string> gap_names(const Problem& problem);

/// w of every point [length].
[[nodiscard]] std::vector<double> gap_widths(const Problem& problem);

/// Whether two floors `width` apart [length] that are displaced by `left` and `right` [length] reach into one another,
/// by more than round-off.
[[nodiscard]] bool overlap(double width, double left, double right);

/// @throws InvalidParameter when sizes disagree or a value is outside its range.
void validate(const Problem& problem);

}  // namespace bentur
