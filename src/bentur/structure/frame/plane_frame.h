#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "bentur/elements/hinges/hinge_backbone.h"
#include "bentur/structure/building.h"
#include "bentur/structure/frame/column_node.h"

namespace bentur {

/// A prismatic member: one column of one storey, one beam of one bay.
struct Section {
  double area = 0;       ///< A [length²]
  double inertia = 0;    ///< I [length⁴] about the axis normal to the frame's plane
  double mass = 0;       ///< [mass] of the whole member, whatever its length, ≥ 0
  double line_mass = 0;  ///< [mass/length] of the member, added to that, ≥ 0
  /// Moments at which its ends yield [force·length] > 0, infinite where they stay elastic: of columns one for all, or
  /// one per column line; of beams one, or those with the tension below and above (sagging, hogging). Empty: elastic.
  std::vector<double> moment_capacity = {};
  double hardening = 0;  ///< r of (H-3) [-], in [0, 1)
  /// Rotations [rad] > 0, ascending, that a hinge's are shown as parts of; three, or none.
  std::vector<double> rotation_limits = {};
  HingeBackbone backbone = {};  ///< of its hinges beyond what `hardening` says; moments of it are not asked for (H-17)
  double line_load = 0;         ///< of beams, downwards [force/length] ≥ 0: M₀ of (H-9), and no mass
  /// Shear at which columns break [force] > 0, infinite where they do not: one for all, or one per column line. Empty:
  /// none does.
  std::vector<double> shear_capacity = {};
  double residual_shear = 0;  ///< the part of it that they keep then [-], in [0, 1) (H-14)

  /// Of a member of this length [length].
  [[nodiscard]] double mass_of(double length) const { return mass + line_mass * length; }
  /// Of a column in this line, from 0 [force].
  [[nodiscard]] double shear_capacity_of(Eigen::Index line) const {
    if (shear_capacity.empty()) return std::numeric_limits<double>::infinity();
    return shear_capacity.size() == 1 ? shear_capacity.front() : shear_capacity.at(static_cast<std::size_t>(line));
  }
};

/// What fills every bay of one storey, as a strut across each diagonal: from the panel and what it is made of, or by
/// its stiffness and strength across.
struct Infill {
  /// t [length] > 0, E_me [force/length²] > 0, f'_m, compressive strength along the bed joints [force/length²], and
  /// f_v, strength against sliding along them, infinite where sliding is left out. `thickness` 0: by numbers.
  double thickness = 0, modulus = 0, strength = 0;
  double sliding_strength = std::numeric_limits<double>::infinity();
  double stiffness = 0;  ///< of a panel, storey shear over drift [force/length] > 0
  /// Of a strut, as storey shear and drift; `yield` follows from the strength of a panel of masonry.
  Backbone backbone = {};
};

enum class MassMatrix { consistent, lumped };
enum class Condensation { static_, dynamic, none };

/// A plane frame of `storeys × bays` rectangular cells, fixed at the base, members axially rigid:
/// one sway per floor, one rotation per joint (monograph 2.5, 4.1).
struct PlaneFrame {
  double elastic_modulus = 0;          ///< E [force/length²]
  std::vector<double> storey_heights;  ///< [length], bottom to top
  std::vector<double> bay_widths;      ///< [length], left to right
  std::vector<Section> columns;        ///< one per storey: every column of that storey
  std::vector<Section> beams;          ///< one per floor: every beam of that floor
  std::vector<double> floor_masses;    ///< [mass] added to each floor's sway; one per floor, or empty for none
  MassMatrix mass_matrix = MassMatrix::consistent;
  Condensation condensation = Condensation::static_;
  bool base_coupling = true;  ///< m_g (docs/theory/structure.md, Load); false: without, as the monograph's (2-1)
  std::vector<std::optional<Infill>> infills = {};  ///< one per storey, nothing: it is open; empty: all are
  std::vector<ColumnNode> nodes = {};  ///< any order; their sways are dofs after the floors', in this order
};

/// Mass, stiffness and load of the frame with all rotations: dofs = floors + nodes + floors × (bays + 1) + nodes; sways
/// of floors and nodes first, then rotations of joints floor by floor, left to right, then those of nodes. Element
/// stiffness (2-48), consistent mass (2-50), hinges (H-1). `base_elevation` [length] is that of the base above the
/// ground datum; nothing but `elevations` depends on it.
/// @throws InvalidParameter when list lengths disagree or a value is outside its range.
[[nodiscard]] StructuralModel assemble_plane_frame(const PlaneFrame& frame, double base_elevation = 0.0);

/// The frame reduced as its `condensation` says. Lumped mass leaves rotations massless, so that every choice is static.
/// `base_elevation` [length] and errors as assemble_plane_frame(); also std::runtime_error when the iteration of
/// dynamic condensation does not settle.
[[nodiscard]] StructuralModel plane_frame_model(const PlaneFrame& frame, double base_elevation = 0.0);

}  // namespace bentur
