#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bentur/structure/building.h"

namespace bentur {

/// Degrees of freedom of a member's ends (y₁, φ₁, y₂, φ₂); −1: one that does not move.
using ElementDofs = std::array<Eigen::Index, 4>;

/// Gathers the ends of members of a frame while its stiffness is assembled, and makes hinges of those that yield.
class FrameHinges {
 public:
  /// An end of a member that may turn against what it joins.
  struct End {
    HingePlace place;
    double clockwise = 0, anticlockwise = 0;   ///< capacities [force·length] > 0, may be infinite
    double hardening = 0;                      ///< H [force·length/rad]
    std::vector<double> rotation_limits = {};  ///< three [rad], or none
    HingeBackbone backbone = {};               ///< but for its moments
    Eigen::Index joint = -1;  ///< rotation of the joint that it belongs to; −1: of none that may balance
  };
  /// A member, or a piece of one, with the freedoms and the stiffness (2-48) of its ends; nothing: an end that does not
  /// turn against what it joins.
  /// Returns the number of the piece.
  Eigen::Index add(const ElementDofs& dofs, const Eigen::Matrix4d& stiffness, const std::optional<End>& first,
                   const std::optional<End>& second);
  /// The shear of the piece number `piece`, which breaks and keeps `kept` of its capacity. (H-13)
  void add_shear(Eigen::Index piece, const BreakingColumn& column, double kept);
  /// Row `row` of the forces in columns is end force `force` (of y₁, φ₁, y₂, φ₂) of the piece number `piece`.
  void add_column_force(Eigen::Index row, Eigen::Index piece, Eigen::Index force);
  /// Moments on the two ends added last, of a load on a member whose joints do not turn [force·length].
  void add_fixed_end_moments(double first, double second);

  /// The hinges over all dofs of a frame with this stiffness: of ends with a capacity that is finite, in the order in
  /// which they were added. @throws InvalidParameter where loads alone bring an end to yield: it names it.
  [[nodiscard]] Hinges hinges(const Eigen::MatrixXd& stiffness) const;

 private:
  struct Piece {
    ElementDofs dofs;
    Eigen::Matrix4d stiffness;
    Eigen::Index first = -1, second = -1;  ///< of ends_
    Eigen::Index shear = -1;               ///< of shears_
  };
  std::vector<End> ends_;
  struct Shear {
    BreakingColumn column;
    double kept;
  };
  /// Those of a piece that turn or slip, after all ends its shear, with the end force that each is.
  [[nodiscard]] std::vector<std::pair<Eigen::Index, Eigen::Index>> places_of(const Piece& piece) const;
  std::vector<Shear> shears_;
  std::vector<Piece> pieces_;
  std::vector<double> fixed_end_moments_;  ///< per end
  struct ColumnForce {
    Eigen::Index row, piece, force;
  };
  std::vector<ColumnForce> column_forces_;
};

/// That hinges which lose strength lose less than their members unload by, so that each can be followed alone [Ibarra &
/// Krawinkler 2005], and harden to less than twice their capacity. (H-17) @throws InvalidParameter: it names the end.
void check_backbones(const Hinges& hinges);

/// Hinges, which there are, as one law over the degrees of freedom of their rows. @throws as check_backbones()
[[nodiscard]] CoupledElement element_of(const Hinges& hinges);

/// "left end of the beam of bay 1, floor 2", "bottom of the column of line 3, storey 1".
[[nodiscard]] std::string name_of(const HingePlace& place);
/// "column of line 3, storey 1", "piece 2 of the column of line 3, storey 1".
[[nodiscard]] std::string name_of(const BreakingColumn& column);

}  // namespace bentur
