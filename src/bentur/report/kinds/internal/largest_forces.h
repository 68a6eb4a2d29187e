#pragma once

#include <optional>
#include <vector>

#include "bentur/report/kinds/internal/frame_diagram.h"
#include "bentur/report/kinds/internal/run_figures.h"

namespace bentur {

/// Members among which the largest is sought: all, or columns of one storey, or beams of one floor.
struct Among {
  Eigen::Index level = 0;  ///< from 1; 0: all
  bool of_beams = false;

  [[nodiscard]] bool has(const FrameMember& member) const {
    return level == 0 || (member.level == level && member.of_beam == of_beams);
  }
};

/// Where the largest of all is.
struct LargestForce {
  double value = 0;  ///< signed
  Eigen::Index member = -1;
  std::size_t station = 0;

  void take(const Carried& carried, const FrameForces& frame, const FrameForces::Forces& forces, Among among = {});
};

/// Those of all that are as large as it, but for round-off, itself among them; of a symmetrical frame there are more.
[[nodiscard]] std::vector<LargestForce> alike_to(const LargestForce& largest, const Carried& carried,
                                                 const FrameForces& frame,
                                                 const std::vector<const FrameForces::Forces*>& drawn, Among among);

/// Of columns that a floor strikes the largest at the blow: the moment there, or the shear of a piece that ends there;
/// member −1 without one. @param time of the instant at which they are struck; nothing: at any
[[nodiscard]] LargestForce largest_at_blow(const RunResults& run, const Carried& carried, const FrameForces& frame,
                                           const std::vector<const FrameForces::Forces*>& drawn,
                                           std::optional<double> time);

}  // namespace bentur
