#pragma once

#include "bentur/core/not_known.h"
#include "bentur/pounding/plan/plan_problem.h"
#include "bentur/pounding/pounding.h"

namespace bentur {

/// Extrema of the continuous response of a building in plan; each list from the lowest floor or storey up.
struct PlanPeaks {
  Eigen::VectorXd x, y;  ///< max |u_x|, max |u_y| of the centres of mass, from the own base [length]
  Eigen::VectorXd south, north, west, east;  ///< max |u_x| at the lower and upper edge, |u_y| at the left and right one
  Eigen::VectorXd rotation;                  ///< max |θ| [rad]
  Eigen::VectorXd acceleration_x, acceleration_y;  ///< absolute [length/s²]
  Eigen::VectorXd angular_acceleration;            ///< [rad/s²]
  Eigen::VectorXd shear_x, shear_y, torque;        ///< of storeys [force], [force·length]; empty of a wall
  /// Of one plane, storey by storey.
  struct Plane {
    Eigen::VectorXd drift_ratio;  ///< max |Δ_j|/h_j [-]
    Eigen::VectorXd shear;        ///< max |V_j| [force]
    /// Empty where no storey of it can yield; of a frame with hinges residual drifts alone, those of the frame itself.
    BuildingPeaks::Yielding yielding = {};
    BuildingPeaks frame =
        {};  ///< of a frame what its hinges, its columns that break and its infill did, and its mechanism
  };
  std::vector<Plane> planes;
  /// max of each of the forces at the ends of struck columns, six a node of PlanModel::nodes, as
  /// StructuralModel::column_forces [force, force·length]; empty where none is struck.
  Eigen::VectorXd column_forces = {};
  /// Of the foundation: sway along x and y [length], rocking that moves what is above along x and y, twist [rad]; empty
  /// without soil.
  Eigen::VectorXd foundation = {};
  /// Of the bearings below a slab, in their order.
  struct Bearings {
    Eigen::VectorXd x = {}, y = {};                    ///< max |Δ| [length]
    Eigen::VectorXd force_x = {}, force_y = {};        ///< max |F|, without dashpots [force]
    Eigen::VectorXd residual_x = {}, residual_y = {};  ///< Δ that would be left without force [length]; 0: elastic
    Eigen::VectorXd hysteretic_energy = {};            ///< [force·length]
  };
  Bearings bearings = {};
  /// max |Δ|/h of the edges along themselves, of a building without planes; empty of others [-].
  Eigen::VectorXd drift_south = {}, drift_north = {}, drift_west = {}, drift_east = {};
  /// The largest of the four, storey by storey.
  [[nodiscard]] Eigen::VectorXd edge_drift_ratio() const {
    return drift_south.cwiseMax(drift_north).cwiseMax(drift_west.cwiseMax(drift_east));
  }
  /// How far some edge moves along itself, floor by floor [length].
  [[nodiscard]] Eigen::VectorXd edge_displacement() const {
    return south.cwiseMax(north).cwiseMax(west.cwiseMax(east));
  }
  /// Of all planes, or without any of the edges.
  [[nodiscard]] LargestDrift largest_drift() const;
};

/// What a contact point did along the joint.
struct PlanFriction {
  double peak_tangential_force = 0;  ///< [force]
  double tangential_impulse = 0;     ///< ∫F_t dt, along t = e_z × n as it acts against L [force·s]
  double sliding = 0;                ///< path slid [length]
  double friction_loss = 0;          ///< [force·length]
};

/// Samples, a column each; of every building its floors, of contacts those of all gaps in their order.
struct PlanHistories {
  std::vector<double> time = {};                ///< [s]
  Eigen::MatrixXd ground_acceleration = {};     ///< of both motions along their own axes, without delay [length/s²]
  std::vector<Eigen::MatrixXd> x = {}, y = {};  ///< of the centres of mass, from the own base [length]
  std::vector<Eigen::MatrixXd> rotation = {};   ///< [rad]
  std::vector<Eigen::MatrixXd> acceleration_x = {}, acceleration_y = {};  ///< absolute [length/s²]
  /// Per building on soil its foundation's movements, in the order of PlanPeaks::foundation, and below them the forces
  /// and moments that the springs and dashpots there bear: 10 × samples; others: 0 × 0.
  std::vector<Eigen::MatrixXd> foundation = {};
  /// Per building on bearings their movements along x and y, x and y of one after the other [length], and below them
  /// the forces, without dashpots: 4 n × samples; others: 0 × 0.
  std::vector<Eigen::MatrixXd> bearing = {};
  /// Of the hinges of all frames of a building, one frame after the other: M + M₀ [force·length] and θ [rad]; no rows
  /// where it has none.
  std::vector<Eigen::MatrixXd> hinge_moment = {}, hinge_rotation = {};
  /// Likewise of panels of infill, as Histories has them.
  std::vector<Eigen::MatrixXd> infill_force = {}, infill_shortening = {};
  Eigen::MatrixXd opening = {}, force = {};     ///< [length], [force]
  Eigen::MatrixXd slip = {}, force_along = {};  ///< s and F_t (P-6); 0 where nothing rubs
};

/// Of buildings in plan.
struct PlanResponse : RunOutcome {
  /// Of the ground along x and along y as applied [length/s²]; NaN: not known, as peak_acceleration() of two has it.
  Eigen::Vector2d peak_ground_acceleration = Eigen::Vector2d::Constant(not_known);
  std::vector<PlanPeaks> buildings = {};
  std::vector<PlanPeaks> buildings_no_contact = {};  ///< the same with contact switched off
  std::vector<PlanFriction> friction = {};           ///< of the points; zero where nothing rubs
  PlanHistories histories = {};                      ///< empty unless asked for
  /// The exact course as Response's, of movements, rotations, openings and contact forces; empty unless asked for, and
  /// of more than `most_followed` buildings.
  PlanHistories course = {};
  static constexpr std::size_t most_followed = 6;
  /// Where masses may stand elsewhere (PlanProblem::elsewhere), the largest of each building without contact, and of
  /// all of them are collapse_no_contact and what points and watched floors need; empty: nowhere.
  std::vector<LargestDrift> drifts_elsewhere = {};
};

/// The largest drift of each building without contact, wherever its masses may stand.
[[nodiscard]] std::vector<LargestDrift> drifts_no_contact(const PlanResponse& response);

/// The free response first, then the response with contact. Numerical trouble is a status with time and reason, never
/// an exception. @throws InvalidParameter when the problem or the solver's parameter is not valid.
[[nodiscard]] PlanResponse solve(const PlanProblem& problem, const Solver& solver = ExactSolver{},
                                 const SolveOptions& options = {});

/// What runs share that differ in widths and laws of contacts alone.
using PlanFreeResponse = FreeResponseOf<PlanProblem, PlanResponse>;
extern template class FreeResponseOf<PlanProblem, PlanResponse>;

/// What a run takes (effort.h). @throws InvalidParameter as solve().
[[nodiscard]] Effort effort(const PlanProblem& problem, const Solver& solver, const SolveOptions& options);

}  // namespace bentur
