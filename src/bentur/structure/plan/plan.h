#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/elements/bearing_laws.h"
#include "bentur/elements/hinges/polygon_yield.h"
#include "bentur/structure/building.h"
#include "bentur/structure/damping.h"
#include "bentur/structure/known/modal.h"
#include "bentur/structure/plan/footprint.h"
#include "bentur/structure/plan/plan_plane.h"

// A building in plan (docs/theory/plan.md): floors that are rigid in their plane, with three degrees of freedom each,
// u_x, u_y [length] and θ [rad, counter-clockwise] of the centre of mass, floor after floor from the lowest up.
namespace bentur {

/// What holds storeys otherwise (P-5): of each list one for all or one per storey; of stiffnesses none: 0.
struct PlanRigidity {
  std::vector<PlanPoint> centres;      ///< of rigidity, from the footprint's corner [length]
  std::vector<double> x = {}, y = {};  ///< [force/length] ≥ 0
  std::vector<double> torsion = {};    ///< about that centre [force·length] ≥ 0
};

/// What holds all floors at once at one place in plan: stiffnesses against the sways of all floors there along x and
/// along y [force/length], and against their rotations [force·length], each floors × floors (P-26).
struct PlanCantilever {
  PlanPoint at = PlanPoint::Zero();  ///< from the footprint's corner [length]
  Eigen::MatrixXd x, y, torsion;
};

/// Stiffness from another program: of each floor u_x, u_y [length] and θ [rad] of a point (P-32).
struct PlanStiffness {
  std::vector<PlanPoint> at;  ///< one per floor, from the footprint's corner [length]
  Eigen::MatrixXd matrix;     ///< 3 floors × 3 floors, positive definite
};

/// A foundation on springs and dashpots, at the middle of the footprint (P-27). Rocking is measured by the way that it
/// moves what stands on it: along x or along y.
struct PlanSoil {
  Impedance sway_x, sway_y, rocking_x, rocking_y;
  std::optional<Impedance> twist = {};  ///< about the vertical; nothing: the foundation does not turn
  double mass = 0;                      ///< of the foundation [mass] > 0
  double inertia_x = 0, inertia_y = 0;  ///< of its rocking, likewise [mass·length²] > 0
  double twist_inertia = 0;             ///< about the vertical [mass·length²] > 0
};

/// One bearing: its law holds along x and along y, each by itself (P-29), or within a polygon (P-31).
struct PlanBearing {
  PlanPoint at = PlanPoint::Zero();       ///< from the footprint's corner [length]
  Bearings bearing = {};                  ///< with a stiffness > 0
  int sides = PolygonYield::least_sides;  ///< of the polygon that its force stays within, as polygon_yield()'s
  double damping = 0;                     ///< of a dashpot beside it along x and along y [force·s/length] ≥ 0
};

/// Bearings below a slab: one more floor, at the base, the first of all lists.
struct PlanIsolation {
  double mass = 0;                       ///< of the slab [mass] > 0
  PlanPoint centre = PlanPoint::Zero();  ///< of its mass, from the footprint's corner [length]
  double inertia = 0;                    ///< about that [mass·length²] > 0
  std::vector<PlanBearing> bearings = {};
};

/// What an engineer knows of a building in plan; lists from the lowest up.
struct Plan {
  Footprint footprint;
  std::vector<double> storey_heights;           ///< [length]
  std::vector<double> masses;                   ///< [mass]
  std::vector<PlanPoint> centres_of_mass = {};  ///< from the footprint's corner, one for all or one per floor
                                                ///< [length]; empty: its middle
  /// By what of the size along x and y they are moved already [-].
  PlanPoint accidental_eccentricity = PlanPoint::Zero();
  double eccentricity_both_ways =
      0;  ///< by what of the size they may stand elsewhere, along x or y, either way [-] ≥ 0
  std::vector<double> inertias = {};  ///< about these, one per floor [mass·length²]; empty: (P-2)
  std::vector<PlanPlane> planes = {};
  std::optional<PlanRigidity> rigidity = {};      ///< beside the planes
  std::optional<PlanCantilever> cantilever = {};  ///< beside both
  std::optional<PlanStiffness> known = {};        ///< in place of all of these
  /// In place of them too, of a building that stands as it is given: shapes are u_x, u_y [length] and θ [rad] of the
  /// centres of mass, floor after floor (P-33).
  std::optional<GivenModes> modes = {};
  std::vector<double> gravity_loads = {};  ///< of P-Δ, on each floor, spread as its mass is [force] ≥ 0; empty: none
  std::optional<PlanSoil> soil = {};       ///< below it; nothing: its base moves with the ground
  std::optional<PlanIsolation> isolation = {};  ///< not together with soil
  /// What calibrate_period() has multiplied all that holds the floors by [-]; nothing: it has not.
  std::optional<double> stiffness_factor = {};
};

/// A direction in which nothing holds a storey, counted from 0.
struct UnheldStorey {
  Eigen::Index storey = 0;
  std::string_view direction;  ///< "x", "y" or "rotation"
};

/// Mass and stiffness of a building in plan, or of a wall that moves with the ground, whose matrices are zero. Sways of
/// nodes in columns that are struck come after the degrees of freedom of the floors, then those of a foundation that
/// moves, in the order of FoundationDof; then all others are relative to the free field.
struct PlanModel {
  Footprint footprint;
  std::vector<double> elevations;        ///< [length] of the floors above the common datum
  std::vector<double> storey_heights;    ///< [length]
  std::vector<double> floor_masses;      ///< [mass]; infinite of a wall
  std::vector<double> floor_inertias;    ///< about the centre of mass [mass·length²]; of a wall none
  std::vector<PlanPoint> centres;        ///< c_f from the footprint's corner [length]
  Eigen::MatrixXd mass, stiffness;       ///< dofs × dofs
  std::optional<KnownModes> known = {};  ///< of a building known by its modes: it moves in these alone
  Eigen::MatrixXd softening = {};  ///< what gravity loads have taken from the stiffness (P-22); empty: there are none
  std::vector<double> gravity_loads = {};  ///< those loads [force]
  std::optional<PlanSoil> soil = {};       ///< what the foundation stands on
  Eigen::MatrixXd load;                    ///< dofs × 2: p = −load · (a_x, a_y) [mass]
  /// A plane as rows over the dofs, storey by storey.
  struct Plane {
    std::string name;
    Eigen::MatrixXd drifts;  ///< Δ_j, storeys × dofs
    Eigen::MatrixXd pushes;  ///< what V_j = 1 is on the floor above: x, y and about its centre of mass, 3 × storeys
    Eigen::MatrixXd shears;  ///< V_j of what stays elastic, storeys × dofs [force/length]
    std::vector<std::shared_ptr<const HystereticLaw>> laws;  ///< null: that storey stays elastic
    Hinges hinges = {};  ///< of a frame, over the dofs; `frame_rows` and its like over the sways of its floors
    std::vector<InfillPanel> infills = {};        ///< of a frame, from its lowest storey up, bay by bay
    std::vector<double> bays = {};                ///< as PlanPlane's
    std::vector<Eigen::Index> node_storeys = {};  ///< of its nodes, as PlanPlane::Nodes
    Eigen::MatrixXd column_forces = {};           ///< of its struck columns, 6 · nodes × dofs
    [[nodiscard]] PlanPoint direction() const { return pushes.rightCols<1>().topRows<2>(); }  ///< of its line, length 1
  };
  std::vector<Plane> planes;
  /// A node in a column that a neighbour's floor strikes. It sways along its frame's line by itself [length], and moves
  /// across it with the edge that it is in.
  struct Node {
    Eigen::Index plane = 0;
    double elevation = 0;  ///< above the common datum [length]
    double mass = 0;       ///< [mass]
    PlanPoint through;     ///< a point of the frame's line, from the footprint's corner [length]
    PlanPoint along;       ///< the line's direction, of length 1
  };
  std::vector<Node> nodes = {};  ///< plane after plane
  /// A bearing as rows over the dofs: how far it is moved along x and y, and the forces of what stays elastic.
  struct Bearing {
    PlanPoint at;                              ///< from the footprint's corner [length]
    Eigen::MatrixXd drifts;                    ///< 2 × dofs
    Eigen::MatrixXd shears;                    ///< 2 × dofs [force/length]
    Eigen::MatrixXd pushes;                    ///< as a plane's on the slab, 3 × 2
    std::shared_ptr<const HystereticLaw> law;  ///< of each direction; null: it stays elastic
    std::optional<PolygonYield> polygon = {};  ///< of both at once, in place of that law in each
    /// Elements of one direction that it is.
    [[nodiscard]] Eigen::Index elements() const { return law && !polygon ? 2 : 0; }
  };
  std::vector<Bearing> bearings = {};
  std::optional<Eigen::Index> slab = {};        ///< the floor on bearings: no height
  std::optional<double> stiffness_factor = {};  ///< as Plan's
  /// Of storeys, three rows each over the dofs: shear along x and y [force/length] and torque about the centre of mass
  /// of the floor above [force], of planes and rigidity.
  Eigen::MatrixXd storey_forces;

  [[nodiscard]] Eigen::Index floors() const { return std::ssize(elevations); }
  /// The lowest storey, and floor above it, that is no isolation system: 1 above a slab, else 0.
  [[nodiscard]] Eigen::Index first_storey() const { return slab ? *slab + 1 : 0; }
  /// Of storey `storey`, 0 the lowest, as people count: from 1, without the bearings below a slab, which are 0.
  [[nodiscard]] Eigen::Index storey_number(Eigen::Index storey) const { return storey + 1 - first_storey(); }
  /// Of a foundation, after all others: sway [length], rocking [rad], twist [rad, counter-clockwise].
  enum FoundationDof { sway_x, sway_y, rocking_x, rocking_y, twist };
  [[nodiscard]] Eigen::Index foundation_dofs() const { return soil ? (soil->twist ? 5 : 4) : 0; }
  [[nodiscard]] Eigen::Index first_node_dof() const { return 3 * floors(); }
  [[nodiscard]] Eigen::Index first_foundation_dof() const { return 3 * floors() + std::ssize(nodes); }
  [[nodiscard]] Eigen::Index dofs() const { return first_foundation_dof() + foundation_dofs(); }
  /// Of a floor itself, of a node (counted after the floors) the floor above it.
  [[nodiscard]] Eigen::Index floor_at_or_above(Eigen::Index floor_or_node) const;
  /// How far the point at `at` of the common plan moves along `direction` with a floor, or with a node, counted after
  /// the floors, as a row over the dofs (P-1).
  [[nodiscard]] Eigen::VectorXd movement(Eigen::Index floor, const PlanPoint& at, const PlanPoint& direction) const;
  /// The same at an elevation [length] between base and top: on the straight line between floors, as sway_at() of a
  /// stick. @throws InvalidParameter as storey_place().
  [[nodiscard]] Eigen::VectorXd movement_at(double elevation, const PlanPoint& at, const PlanPoint& direction) const;
  /// The same of the foundation, without its rocking; zero where it does not move.
  [[nodiscard]] Eigen::VectorXd base_movement(const PlanPoint& at, const PlanPoint& direction) const;
  /// How far that point of floor `storey` moves along a direction against the same point of the floor below, or of the
  /// foundation: all of it, and without what rocking makes of it, as the storey itself deforms.
  [[nodiscard]] Eigen::VectorXd lean(Eigen::Index storey, const PlanPoint& at, const PlanPoint& direction) const;
  [[nodiscard]] Eigen::VectorXd drift(Eigen::Index storey, const PlanPoint& at, const PlanPoint& direction) const;
};

/// A building in plan as the rest of the program sees it.
struct PlanBuilding {
  std::string name;
  PlanModel model;
  Modes modes;
  Eigen::MatrixXd modal_damping;  ///< Φᵀ C Φ [1/s]
  double tangent_damping = 0;     ///< as Building's [s]
  /// Hinges of frames, plane by plane, then bearings that yield within a polygon.
  std::vector<CoupledElement> coupled = {};
  [[nodiscard]] bool is_rigid() const { return modes.omega.size() == 0; }
  /// ω₁ [rad/s]; 0 of a free body and of what has no modes.
  [[nodiscard]] double first_omega() const { return is_rigid() ? 0.0 : modes.omega(0); }
  /// Gravity loads act (P-Δ), so that it may collapse.
  [[nodiscard]] bool has_gravity_loads() const { return model.softening.size() > 0; }
};

/// The directions in which storeys are not held: the least eigenvalue of their stiffness, rotations times the longer
/// side, is at most 1e-12 of the largest. Of a plan whose lists have the right lengths.
[[nodiscard]] std::vector<UnheldStorey> unheld_storeys(const Plan& plan);

/// The centre of rigidity of a storey that is held, from the footprint's corner [length]: of its stiffness before
/// anything yields, where forces through it do not turn the floor above against the one below (P-5).
[[nodiscard]] PlanPoint centre_of_rigidity(const Plan& plan, Eigen::Index storey);

/// @throws InvalidParameter, naming the key, when lists have wrong lengths, a value is out of its range, a centre of
/// mass is outside the footprint, a storey is not held or the building does not stand under its gravity loads.
[[nodiscard]] PlanModel plan_model(const Plan& plan, double base_elevation = 0.0);

/// Scales what holds the floors until their longest period is this [s], on a base that does not move and without
/// gravity loads; what yields and breaks has the strength that it had. plan_calibration.cpp
/// @throws InvalidParameter as plan_model(), and unless the period is > 0.
void calibrate_period(Plan& plan, double first_period);

/// With its modes and damping. @param model on a base that does not move; damping is of this, and acts on what moves
/// relative to the foundation @param tangent whether the stiffness part of damping follows that of a plane that yields
/// @throws InvalidParameter as modal_damping(), and when damping is to follow the stiffness but has no such part, a
/// value of the soil or the isolation is out of its range, both are given, or the building does not stand on them under
/// its gravity loads.
[[nodiscard]] PlanBuilding make_plan_building(std::string name, PlanModel model, const Damping& damping,
                                              bool tangent = false, const std::optional<PlanSoil>& soil = {},
                                              const std::optional<PlanIsolation>& isolation = {});

/// A wall that moves with the ground; elevations above the common datum ascend.
[[nodiscard]] PlanBuilding rigid_plan_building(std::string name, const Footprint& footprint,
                                               const std::vector<double>& elevations);

}  // namespace bentur
