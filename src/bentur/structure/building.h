#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/elements/coupled_law.h"
#include "bentur/elements/hinges/hinge_backbone.h"
#include "bentur/elements/law.h"
#include "bentur/elements/softening/backbone_law.h"

namespace bentur {

/// A spring and a dashpot beside it.
struct Impedance {
  double stiffness = 0;  ///< [force/length], of rocking [force·length]; > 0
  double damping = 0;    ///< [force·s/length], [force·length·s]; ≥ 0
};

/// A foundation that moves: the degrees of freedom of its sway [length] and its rocking [rad], clockwise, and what is
/// under it.
struct Foundation {
  Eigen::Index sway = 0, rocking = 0;
  Impedance under_sway = {}, under_rocking = {};
};

/// A plastic hinge of a frame, for people; all numbers from 1.
struct HingePlace {
  enum class End { bottom, node, top, left, right };
  bool of_beam = false;
  Eigen::Index level = 0;   ///< of a column its storey, of a beam its floor
  Eigen::Index number = 0;  ///< of a column its line, of a beam its bay
  End end = End::bottom;
};

/// "bottom", "node", "top", "left", "right".
[[nodiscard]] std::string_view word_of(HingePlace::End end);
/// @throws InvalidParameter unless it is one of these.
[[nodiscard]] HingePlace::End hinge_end(std::string_view word);

/// A column of a frame that breaks in shear, or a piece of one that is struck; all numbers from 1.
struct BreakingColumn {
  Eigen::Index storey = 0;
  Eigen::Index line = 0;
  Eigen::Index piece = 0;  ///< of a struck column the number of the piece, from below; 0: the whole column
  double capacity = 0;     ///< V [force] > 0
};

/// The plastic hinges of a frame (H-1), (H-2): moments on members' ends, clockwise positive, M = rows · x − stiffness
/// θ. After them the shears of columns that break (H-13), whose "rotation" is how far they slip [length] and whose
/// "moment" is a force.
struct Hinges {
  std::vector<HingePlace> places;
  std::vector<BreakingColumn> columns = {};
  Eigen::MatrixXd rows;       ///< G over the dofs [force·length/length]
  Eigen::MatrixXd stiffness;  ///< K_hh [force·length/rad]
  Eigen::VectorXd hardening;  ///< H [force·length/rad]
  /// M⁺ and M⁻ > 0 [force·length], clockwise and anticlockwise; infinite where an end cannot be brought to flow (H-5).
  Eigen::VectorXd clockwise, anticlockwise;
  Eigen::VectorXd kept = {};  ///< the part of its capacity that each keeps once it has been reached [-]; 1 of hinges;
                              ///< empty where no column breaks
  std::vector<HingeBackbone> backbones = {};  ///< of each, empty where none loses strength (H-17)
  Eigen::VectorXd at_rest;                    ///< M₀ of gravity loads on beams [force·length] (H-9)
  /// Rotations of the levels IO, LS and CP of ASCE 41, hinges × 3 [rad]; NaN where they are not given.
  Eigen::MatrixXd rotation_limits;
  /// What a rotation of 1 does to StructuralModel::column_forces, those × hinges [force·length, force].
  Eigen::MatrixXd column_forces;
  /// Of the frame alone, fixed at its base and without gravity loads: K, G and the drifts of its storeys over its dofs.
  Eigen::MatrixXd frame_stiffness, frame_rows, frame_drifts;
  [[nodiscard]] Eigen::Index size() const { return rows.rows(); }
  /// Scales all that is made of stiffness; what they bear stays.
  void scale_stiffness(double factor) {
    for (Eigen::MatrixXd* const one : {&rows, &stiffness, &column_forces, &frame_stiffness, &frame_rows}) {
      *one *= factor;
    }
    hardening *= factor;
  }
};

/// The masonry that fills a bay of a frame in one storey, across: as storey drift and shear.
struct InfillPanel {
  Eigen::Index storey = 0, bay = 0;  ///< both from 0, the storey that of the frame
  double stiffness = 0;              ///< k of the strut that works [force/length], part of K
  Backbone backbone = {};            ///< of either strut; an infinite `yield`: it stays elastic
  double cosine = 1;                 ///< of the strut's angle with the floor [-]: its force is that across over this
};

/// Mass, stiffness and effective earthquake load of a structure before damping and modes (theory:
/// docs/theory/structure.md). Degrees of freedom: one sway per floor first (bottom to top), then any joint rotations
/// that were kept. p(t) = −load · a_g(t); load = Tᵀ(M r + m_g) (docs/theory/structure.md, Load and Condensation).
struct StructuralModel {
  std::vector<double> elevations;      ///< [length] of the floors above the ground datum, bottom to top; size floors
  std::vector<double> storey_heights;  ///< [length], bottom to top; size floors
  Eigen::MatrixXd mass;                ///< M [mass], symmetric positive definite, dofs × dofs
  Eigen::MatrixXd stiffness;           ///< K [force/length], symmetric positive definite, dofs × dofs
  Eigen::VectorXd load;                ///< M r + m_g [mass], dofs
  /// [mass] of each floor as a rigid body that is hit, for m_e of contact laws: a frame's lumped floor masses whatever
  /// its mass matrix, else the row sums of M; size floors.
  std::vector<double> floor_masses;
  /// θ of a frame's joints, clockwise, as rows over the dofs [1/length, or 1 on a rotation that was kept]: of its
  /// leftmost and its rightmost column line, floors × dofs each; both empty where there are no joints.
  Eigen::MatrixXd left_joints, right_joints;
  /// Rows over the dofs, floors × dofs: each storey's drift Δ_j [-] and its shear V_j [force/length]. Empty: x_j −
  /// x_{j−1}, and the sum of K over floors ≥ j.
  Eigen::MatrixXd drifts = {}, shears = {};
  /// How all of it moves as one rigid body with its base, by sways of 1 and by h, the heights above the base: feet of
  /// columns included.
  struct RigidBody {
    double mass = 0;          ///< [mass]
    double moment = 0;        ///< Σ m h [mass·length]
    double inertia = 0;       ///< Σ m h² [mass·length²]
    Eigen::VectorXd rocking;  ///< M h, dofs [mass·length]
    double foot_mass = 0;     ///< lower halves of the lowest columns [mass]
  };
  RigidBody rigid_body = {};                  ///< `rocking` empty: M r and M h of the floors are all there is
  std::optional<Eigen::Index> slab = {};      ///< the floor on bearings: no height, its drift is a length
  std::optional<Foundation> foundation = {};  ///< on soil
  /// The forces at the ends of both pieces of a column that has a node between floors, as rows over the dofs, six a
  /// node: shears below and above [force/length], moments at the bottom, at the node from below and from above, at the
  /// top [force]. Nodes sway as the dofs after the floors'.
  Eigen::MatrixXd column_forces = {};
  std::vector<double> node_elevations = {};  ///< [length]
  std::vector<double> node_masses = {};      ///< lumped, for m_e of contact laws [mass]
  Hinges hinges = {};                        ///< of a frame that yields
  std::vector<InfillPanel> infills = {};     ///< of a frame, from the lowest storey up, bay by bay

  /// What calibrate_period() has multiplied all that is made of stiffness by [-]; nothing: it has not.
  std::optional<double> stiffness_factor = {};

  [[nodiscard]] Eigen::Index nodes() const { return std::ssize(node_elevations); }
  /// Of a floor itself, of a node (counted after the floors) the floor above it.
  [[nodiscard]] Eigen::Index floor_at_or_above(Eigen::Index floor_or_node) const {
    if (floor_or_node < floors()) return floor_or_node;
    Eigen::Index floor = 0;
    while (floor + 1 < floors() && elevations[floor] < node_elevations[floor_or_node - floors()]) ++floor;
    return floor;
  }
  /// The lowest storey, and floor above it, that is no isolation system: 1 above a slab, else 0.
  [[nodiscard]] Eigen::Index first_storey() const { return slab ? *slab + 1 : 0; }
  /// Of storey `storey`, 0 the lowest, as people count: from 1, without the bearings below a slab, which are 0.
  [[nodiscard]] Eigen::Index storey_number(Eigen::Index storey) const { return storey + 1 - first_storey(); }
  [[nodiscard]] Eigen::Index floors() const { return std::ssize(elevations); }
  [[nodiscard]] Eigen::Index dofs() const { return mass.rows(); }
};

/// Elevations of floors from the heights of the storeys below them and the level of the base [length].
[[nodiscard]] std::vector<double> floor_elevations(const std::vector<double>& storey_heights,
                                                   double base_elevation = 0);

/// Undamped modes: K φ = ω² M φ, ΦᵀMΦ = 1, first non-zero entry of each shape positive, ω ascending.
struct Modes {
  Eigen::VectorXd omega;   ///< [rad/s]
  Eigen::MatrixXd shapes;  ///< Φ [mass^-1/2], one mode a column
};

/// What of a building yields: a storey, the bearings below a slab, or a panel of infill. F of δ takes the place of what
/// K has along its row: the law's initial stiffness is part of K, and is the whole of the storey's unless it is a
/// panel.
struct BuildingElement {
  Eigen::VectorXd row;  ///< δ = row · x over the dofs [length]
  std::shared_ptr<const HystereticLaw> law;
  Eigen::Index storey = 0;                  ///< where it is, 0 the lowest
  std::optional<Eigen::Index> infill = {};  ///< of a panel its number among StructuralModel::infills
  bool damped = true;                       ///< damping of the building has a part that goes with its stiffness
};

/// What of a building yields by several deformations at once: the hinges of a frame. Its forces act beside those of K.
struct CoupledElement {
  Eigen::MatrixXd rows;  ///< δ = rows · x over the dofs
  std::shared_ptr<const CoupledLaw> law;
};

/// Peak displacements of a building that another program has found, in place of all that moves it: for gaps alone.
struct GivenPeaks {
  Eigen::VectorXd displacement;       ///< u of the floors, as given [length] ≥ 0
  double amplification = 1;           ///< what makes them those expected [-] > 0
  std::optional<double> period = {};  ///< T₁ [s]
  double damping_ratio = 0;           ///< ζ₁ [-], of a period that is given
};

/// A building as the rest of the program sees it.
struct Building {
  std::string name;
  StructuralModel model;
  Modes modes;
  Eigen::MatrixXd modal_damping;  ///< Φᵀ C Φ [1/s], modes × modes; diagonal 2ζω for classical damping
  std::vector<BuildingElement> elements =
      {};  ///< from the lowest storey up; of others there is none: they stay elastic
  std::vector<CoupledElement> coupled = {};
  /// β of C = αM + βK where the dashpot of a storey that yields is to follow its stiffness: β k_tangent. 0: it does
  /// not.
  double tangent_damping = 0;

  /// The law of storey `storey` (0 the lowest); none: it stays elastic, but for infill.
  [[nodiscard]] const HystereticLaw* storey_law(Eigen::Index storey) const;
  /// Whole storeys do, or bearings.
  [[nodiscard]] bool storeys_yield() const {
    return std::any_of(elements.begin(), elements.end(), [](const BuildingElement& one) { return !one.infill; });
  }
  /// A storey has a law by which its strength can be lost.
  [[nodiscard]] bool can_lose_strength() const;
  /// Storeys, infill, or hinges at the ends of members.
  [[nodiscard]] bool can_yield() const { return !elements.empty() || !coupled.empty(); }
  /// Known by its peak displacements alone: it has no modes, and nothing is solved of it.
  std::optional<GivenPeaks> given = {};
  /// Moves with the ground (a moat wall): it has no modes, as one known by its peaks.
  [[nodiscard]] bool is_rigid() const { return modes.omega.size() == 0; }
  /// ω₁ [rad/s]; 0 of a free body and of what has no modes.
  [[nodiscard]] double first_omega() const { return is_rigid() ? 0.0 : modes.omega(0); }

  /// Gravity loads act (P-Δ), so that it may collapse.
  bool has_gravity_loads = false;
  std::vector<double> bays = {};  ///< widths [length], left to right, of pictures alone; empty: not known
};

/// Elements of the drifts Δ_j = x_j − x_{j−1} of the storeys that have a law; `laws`: one per storey, or none at all.
/// @throws InvalidParameter when they are neither.
[[nodiscard]] std::vector<BuildingElement> storey_elements(
    const StructuralModel& model, const std::vector<std::shared_ptr<const HystereticLaw>>& laws);
/// A panel of infill, the one with number `number` of a building, by the drift of its storey [length] over the dofs.
/// Nothing where it stays elastic.
[[nodiscard]] std::optional<BuildingElement> infill_element(const InfillPanel& panel, Eigen::VectorXd drift,
                                                            Eigen::Index storey, Eigen::Index number);
/// Adds the panels of infill that can yield, of the drifts of their storeys.
void add_infill(const StructuralModel& model, std::vector<BuildingElement>& elements);
/// The hinges of a model as one law; nothing where it has none.
[[nodiscard]] std::vector<CoupledElement> hinge_elements(const StructuralModel& model);
/// Whether each floor or node is above the floor below each storey, storeys × dofs: the sum of forces there is its
/// shear.
[[nodiscard]] Eigen::MatrixXd above_storeys(const StructuralModel& model);
/// Rows over the dofs: drifts of all storeys [-], shears of all storeys [force/length].
[[nodiscard]] Eigen::MatrixXd drift_rows(const StructuralModel& model);
[[nodiscard]] Eigen::MatrixXd shear_rows(const StructuralModel& model);
/// The rigid body of a model, as it says or of M r and M h.
[[nodiscard]] StructuralModel::RigidBody rigid_body(const StructuralModel& model);

}  // namespace bentur
