#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "bentur/structure/frame/plane_frame.h"

namespace bentur {

/// A column of one storey, a piece of one that is struck, or a beam of one bay.
struct FrameMember {
  bool of_beam = false;
  Eigen::Index level = 0;   ///< of a column its storey, of a beam its floor; from 1
  Eigen::Index number = 0;  ///< of a column its line, of a beam its bay; from 1
  double from = 0, to = 0;  ///< its ends: of a column heights above the base, of a beam from the left line [length]
  double place = 0;         ///< where it is: of a column from the left line, of a beam above the base [length]
  [[nodiscard]] double length() const { return to - from; }
};

/// What the members of a plane frame carry when its floors and struck columns sway by y and its hinges have turned by
/// θ: ends of members follow from (2-48) of their joints' rotations, and these from the balance of all joints,
///   φ = −K_φφ⁻¹ (K_φy y − Σ k e θ).
/// Forces of beams' loads, which act at rest, are not among them.
///   moment M [force·length]: where the member is bent so that a column's right or a beam's lower side is in tension >
///   0 shear V [force]: of a column its part of the storey shear, pushing its top to the right > 0; of a beam what it
///     lifts its left end by, M of both ends clockwise over its length
///   axial N [force]: of a column, compression > 0: the shears of all beams above it. What beams carry along
///     themselves is not known, as floors move as one.
class MemberForces {
 public:
  /// Members: columns storey by storey, in it line by line, in it pieces from below; then beams floor by floor.
  /// @param hinges of the model of the frame, StructuralModel::hinges
  /// @throws InvalidParameter as assemble_plane_frame()
  explicit MemberForces(const PlaneFrame& frame, const std::vector<HingePlace>& hinges = {});

  /// Whether joints turn as they do here: rotations have no mass, or are condensed statically; and no hinge stands at
  /// one of two nodes of one column, of which places say no more.
  [[nodiscard]] static bool knows(const PlaneFrame& frame, const std::vector<HingePlace>& hinges = {});

  [[nodiscard]] const std::vector<FrameMember>& members() const { return members_; }
  /// Where along a member its moments are, as parts of its length [-].
  static constexpr double stations[] = {0, 0.25, 0.5, 0.75, 1};

  /// An instant a column.
  struct Forces {
    Eigen::MatrixXd moments;        ///< at the stations of members, one member after the other
    Eigen::MatrixXd shears, axial;  ///< of members; axial of beams NaN
  };
  /// @param sways of floors, then of nodes [length]; @param turned by hinges [rad]; an instant a column
  [[nodiscard]] Forces forces(const Eigen::MatrixXd& sways, const Eigen::MatrixXd& turned) const;

 private:
  struct Rows {
    Eigen::MatrixXd of_sways, of_hinges;
    [[nodiscard]] Eigen::MatrixXd operator()(const Eigen::MatrixXd& sways, const Eigen::MatrixXd& turned) const;
  };
  std::vector<FrameMember> members_;
  Rows ends_;   ///< moments that act on both ends of members
  Rows axial_;  ///< of columns, which come first
};

}  // namespace bentur
