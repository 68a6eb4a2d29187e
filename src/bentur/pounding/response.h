#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "bentur/core/not_known.h"
#include "bentur/solve/solution.h"

namespace bentur {

/// Extrema of the continuous response of one building; each list bottom to top, one entry per floor or storey.
struct BuildingPeaks {
  Eigen::VectorXd displacement;             ///< max |x| relative to the own base [length]
  Eigen::VectorXd displacement_no_contact;  ///< the same with contact switched off
  Eigen::VectorXd drift_ratio;              ///< max |Δ| over storey height [-]; NaN of a slab and of rigid buildings
  Eigen::VectorXd acceleration;             ///< max |ẍ + a_g| [length/s²]
  Eigen::VectorXd storey_shear;             ///< max |Σ_{floors ≥ j} (K x)| [force], of storeys that yield max |V|
  /// What yielding does. Of all storeys where one of the building can yield, else empty: NaN, 0, 0 of one that cannot.
  struct Yielding {
    Eigen::VectorXd ductility;  ///< max |Δ| over Δ_y [-]; NaN where the storey cannot yield
    /// (Δ − V/k_u)/h at the end [-], signed; of frames with hinges, that have no other list, the drifts of K⁻¹Gᵀθ
    /// (H-11)
    Eigen::VectorXd residual_drift_ratio;
    Eigen::VectorXd hysteretic_energy;  ///< ∫V dΔ less what could still be given back, at the end [force·length]
    /// Where storeys can lose strength, else empty; NaN of those that cannot. Of its largest shear what the weaker side
    /// could still reach at the end [-], and when the storey first softened, was down to its residual strength, and had
    /// failed [s], NaN: not.
    Eigen::VectorXd strength_left = {}, capped_time = {}, residual_time = {}, failed_time = {};
  };
  // With contact switched off, as displacement_no_contact; empty where that is not known.
  Eigen::VectorXd acceleration_no_contact = {};
  Eigen::VectorXd drift_ratio_no_contact = {};
  Eigen::VectorXd storey_shear_no_contact = {};
  /// max of each of StructuralModel::column_forces [force, force·length], and the same with contact switched off; empty
  /// where there are none.
  Eigen::VectorXd column_forces = {}, column_forces_no_contact = {};
  /// max |u| [length] and max |θ| [rad] of the foundation; empty where the building stands on none.
  Eigen::VectorXd foundation = {};
  /// What a plastic hinge did, in the order of StructuralModel::hinges.
  struct Hinge {
    double peak_moment = 0;                  ///< max |M + M₀| [force·length]
    double peak_rotation = 0;                ///< max |θ| [rad]
    double residual_rotation = 0;            ///< θ at the end [rad], signed
    double dissipated_energy = 0;            ///< Σ capacity |Δθ| [force·length] (H-10)
    std::optional<double> first_yield = {};  ///< [s]
    int half_cycles = 0;                     ///< stretches of flow in one direction
    /// Of one with a backbone, nothing of others: σ at the end [-], when it came to its cap and when it had nothing
    /// left [s], energy lost as it snapped or failed [force·length]. (H-18), (H-20)
    std::optional<double> strength_left = {}, cap_time = {}, failed_time = {}, released_energy = {};
  };
  std::vector<Hinge> hinges = {};
  /// What a column did that breaks in shear, in the order of Hinges::columns.
  struct Breaking {
    double peak_shear = 0;                  ///< max |Q + Q₀| [force]
    double shear_demand_capacity = 0;       ///< that over its capacity [-]
    std::optional<double> break_time = {};  ///< [s]; nothing: it is whole
    double released_energy = 0;             ///< elastic, when it broke [force·length] (H-15)
    double residual_slip = 0;               ///< v at the end [length], signed
  };
  std::vector<Breaking> columns = {};
  /// When hinges first made a frame movable without bending, and the storeys that drift then, from 0. (H-12)
  struct Mechanism {
    double time = 0;  ///< [s]
    std::vector<Eigen::Index> storeys;
  };
  std::optional<Mechanism> mechanism = {};
  /// What infill did, of all storeys of a frame that has some, else empty; NaN of those that are open. Of several bays
  /// the largest, of their strength the least, of energies the sum.
  struct Infill {
    Eigen::VectorXd force;          ///< max N of a strut [force]
    Eigen::VectorXd shear;          ///< its part across, with which it pushes on a column [force]
    Eigen::VectorXd ductility;      ///< max |Δ| over that at which a strut yields [-]; NaN also of what cannot
    Eigen::VectorXd strength_left;  ///< of a strut at the end, over its largest force at first [-]
    Eigen::VectorXd energy;         ///< dissipated [force·length]
    Eigen::VectorXd failed_time;    ///< when the first panel failed [s]; NaN: none has
    /// max |Q + N cos θ| over V of the columns with a shear capacity beside its struts [-], Q what they bear as part of
    /// the frame; NaN where there is none, empty where none of the building has one
    Eigen::VectorXd column_demand = {};
  };
  Infill infill = {};
  Yielding yielding = {};
  Yielding yielding_no_contact = {};  ///< the same with contact switched off
};

/// Hinges by when they first yielded, those that did so within 10⁻⁹ of `duration` [s] in one group; numbers from 0.
[[nodiscard]] std::vector<std::vector<Eigen::Index>> hinge_order(const BuildingPeaks& peaks, double duration);

/// Largest forces at the ends of the two pieces of a column that a floor strikes between floors
/// (docs/theory/structure.md, Columns that are struck). Elastic, from K: without dashpots.
struct ColumnPeaks {
  double shear = 0, moment = 0;                               ///< the largest of both pieces [force], [force·length]
  double shear_no_contact = 0, moment_no_contact = 0;         ///< the same with contact switched off
  double shear_below = 0, shear_above = 0;                    ///< of the piece below the node, above it [force]
  double moment_bottom = 0, moment_node = 0, moment_top = 0;  ///< at the node the larger of both pieces [force·length]
};

/// Totals of one contact point over the run.
struct PointSummary {
  double gap_needed = 0;  ///< max(0, max over time of x_left − x_right) in the free response [length]
  /// The same under the ground motion times −1; nothing where that was not asked for or has no end.
  std::optional<double> gap_needed_reversed = {};
  /// How much the free vibration after the end could need at most, of this motion and of the reversed one [length];
  /// nothing where that is not known, or of a motion that does not end.
  std::optional<double> to_come = {}, to_come_reversed = {};
  /// How far the vibration after the end of the run with contact could go at most, were nothing struck [length];
  /// infinite where bodies touch at the end.
  std::optional<double> to_come_struck = {};
  /// In plan the choice of mass_choices() that needs so much, counted from 1; 0: masses are where they are expected.
  int masses = 0, masses_reversed = 0;
  /// max |x| of both faces in the free response, relative to the own base [length]; NaN where not asked for.
  double peak_left = not_known, peak_right = not_known;
  int impacts = 0;                             ///< but for those that settle
  int slow_starts = 0;                         ///< of these, Impact::slow_start
  int settling = 0;                            ///< Impact::settling, in the totals below with all others
  double contact_duration = 0;                 ///< [s]
  double peak_force = 0;                       ///< [force]
  std::optional<double> peak_force_time = {};  ///< [s]
  double peak_tension = 0;                     ///< [force]
  double peak_penetration = 0;                 ///< [length]
  double peak_closing_speed = 0;               ///< [length/s]
  double impulse = 0;                          ///< [force·s]
  double energy_lost = 0;                      ///< [force·length]
  std::optional<ColumnPeaks> column = {};      ///< of the column that it strikes; nothing where floors meet
};

/// What a link did over the run.
struct LinkSummary {
  double peak_compression = 0;   ///< max F, dashpot included [force] ≥ 0
  double peak_tension = 0;       ///< max −F [force] ≥ 0
  double peak_closing = 0;       ///< max δ [length] ≥ 0
  double peak_opening = 0;       ///< max −δ [length] ≥ 0
  double energy_dissipated = 0;  ///< [force·length]
};

/// How near a watched floor came to what it faces, of the continuous response.
struct WatchedSummary {
  double gap_needed = 0;                           ///< as PointSummary::gap_needed [length]
  std::optional<double> gap_needed_reversed = {};  ///< likewise [length]
  int masses = 0, masses_reversed = 0;             ///< likewise
  std::optional<double> to_come = {}, to_come_reversed = {}, to_come_struck = {};  ///< likewise [length]
  double peak_left = not_known, peak_right = not_known;                            ///< likewise [length]
  double least_opening =
      0;                  ///< of the run; what it is at most where the floor never comes nearer than at rest [length]
  double least_time = 0;  ///< when [s]
  bool closes = false;    ///< the least opening is negative by more than round-off
};

/// Samples for plots; never used to find a peak. One column per sample time.
struct Histories {
  std::vector<double> time;                   ///< [s]
  std::vector<Eigen::MatrixXd> displacement;  ///< per building, floors × samples [length]
  std::vector<Eigen::MatrixXd> velocity;      ///< [length/s]
  std::vector<Eigen::MatrixXd> acceleration;  ///< absolute [length/s²]
  std::vector<Eigen::MatrixXd> drift_ratio;   ///< per storey, relative floor displacement over storey height [-]
  std::vector<Eigen::MatrixXd> storey_shear;  ///< per storey, Σ_{floors ≥ j} (K x) [force]
  std::vector<double> ground_acceleration;    ///< of the motion without delay [length/s²]
  /// Per building, nodes in struck columns × samples [length], and StructuralModel::column_forces, 6 · nodes × samples
  /// [force, force·length]; no rows where it has none.
  std::vector<Eigen::MatrixXd> node_displacement, column_forces;
  /// Per building, hinges × samples: M + M₀ [force·length] and θ [rad]; no rows where it has none.
  std::vector<Eigen::MatrixXd> hinge_moment, hinge_rotation;
  /// Per building, panels of infill × samples: N [force] of the strut at work and what its diagonal has been shortened
  /// by [length], > 0 of the one that drifts to the right shorten; no rows where it has none.
  std::vector<Eigen::MatrixXd> infill_force = {}, infill_shortening = {};
  /// Per building on soil its foundation's sway [length] and rocking [rad], and the force and moment that the springs
  /// and dashpots below take [force], [force·length], 4 × samples; no rows where there is none.
  std::vector<Eigen::MatrixXd> foundation;
  Eigen::MatrixXd opening;                       ///< points × samples [length]
  Eigen::MatrixXd force;                         ///< points × samples [force]
  Eigen::MatrixXd link_deformation, link_force;  ///< links × samples, δ [length] and F [force] of Link
};

/// What ends a run before its time.
struct Collapse {
  Eigen::Index building = 0;
  Eigen::Index storey = 0;  ///< from 0
  double time = 0;          ///< [s]
};

/// The storey of a building that drifts farthest, over its height.
struct LargestDrift {
  double ratio = 0;  ///< [-]
  Eigen::Index storey = 0;
};

/// Of the storeys of a building; those of which nothing is known are left out.
[[nodiscard]] LargestDrift largest_drift(const Eigen::VectorXd& ratios);
/// The ratios of the storeys of a building of which the largest alone is known, the others 0.
[[nodiscard]] Eigen::VectorXd drift_ratios_with(Eigen::Index storeys, const LargestDrift& largest);

/// The run with the ground motion times −1, as far as gaps are judged by it.
struct ReversedRun {
  std::optional<Collapse> collapse, collapse_no_contact;
  std::vector<LargestDrift> drifts;  ///< per building, without contact
  /// With contact, as Response has them, where some gap of several closes. Else it was not run: a gap is struck exactly
  /// where it needs more than it has.
  bool has_contact = false;
  std::vector<PointSummary> points;
  std::vector<WatchedSummary> watched;
};

/// A number that was reached by two ways, and is not the same but for round-off.
struct Discrepancy {
  std::string key;  ///< which, as the texts of remarks name it
  double size = 0;  ///< as a part of the largest [-]
};

/// What a run came to, whatever stands there: a row or buildings in plan. Points are those of all gaps.
struct RunOutcome {
  Status status = Status::done;
  std::string message = {};               ///< why and when, unless done
  double duration = 0;                    ///< to where it went unless it ended before, Problem::duration or longer [s]
  long steps = 0;                         ///< intervals over which the solution was advanced (with contact)
  long events = 0;                        ///< contacts closed or opened
  double wall_time = 0;                   ///< of the solution alone [s]
  std::optional<Collapse> collapse = {};  ///< where the status says so; all else is up to that time
  std::optional<Collapse> collapse_no_contact = {};  ///< of the response with contact switched off
  std::vector<PointSummary> points = {};
  std::vector<WatchedSummary> watched = {};     ///< as the problem watches
  std::vector<LinkSummary> links = {};          ///< as the problem's links
  std::vector<Impact> impacts = {};             ///< by start, then point, then end
  std::optional<EnergyAudit> energy = {};       ///< when asked for
  std::optional<ReversedRun> reversed = {};     ///< where both ways were asked for and the ground moves
  std::vector<Discrepancy> discrepancies = {};  ///< that the solver explains: more is a failure (self_checks.h)
};

/// Of a row.
struct Response : RunOutcome {
  std::vector<BuildingPeaks> buildings = {};
  std::vector<CoupledState> coupled = {};  ///< at the end, of Building::coupled, building after building
  Histories histories = {};                ///< empty unless asked for
  /// Displacements, openings and forces at instants chosen so that straight lines between them follow the solution:
  /// starts, peaks and ends of contacts, yields and extrema, and as many others as leave no curve by more than 10⁻³ of
  /// its scale; where a force jumps two at one time. Of buildings that can yield drifts and shears too, of struck
  /// columns, links and foundations all that Histories have. Empty unless asked for, and where the motion is so fast
  /// that this would take too many steps.
  Histories course = {};
};

/// The largest drift of each building without contact.
[[nodiscard]] std::vector<LargestDrift> drifts_no_contact(const Response& response);

}  // namespace bentur
