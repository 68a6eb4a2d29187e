#pragma once

#include <optional>
#include <vector>

#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"
#include "bentur/structure/frame/member_forces.h"

namespace bentur {

/// Moments [force·length], shears and axial forces [force] of the members of a frame, as MemberForces has them.
struct FrameForces {
  Eigen::Index building = 0;
  double time = 0;  ///< of the instant [s]
  std::vector<FrameMember> members = {};
  struct Forces {
    Eigen::MatrixXd moments;        ///< MemberForces::stations × members
    Eigen::VectorXd shears, axial;  ///< members; axial of beams NaN
  };
  Forces instant = {};
  Forces most = {}, least = {};                                  ///< over the run
  Forces most_without_contact = {}, least_without_contact = {};  ///< the same with contact switched off
};

/// Of a frame that is a building of a problem, whose factor on stiffness it is given. Nothing where MemberForces does
/// not know it, or where columns have broken, whose slips are no history.
[[nodiscard]] std::optional<MemberForces> forces_of(const PlaneFrame& frame, const Building& building);

/// Sways of the frame's floors and struck columns against its own base: without bearings or soil below. [length]
[[nodiscard]] Eigen::MatrixXd frame_sways(const Histories& histories, const PlaneFrame& frame, const Problem& problem,
                                          Eigen::Index building);

}  // namespace bentur
