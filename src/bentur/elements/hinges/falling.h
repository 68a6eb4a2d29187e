#pragma once

#include "bentur/elements/hinges.h"

namespace bentur {

/// A hinge whose lines come down at deformations that are held: where they are, and where they end. (H-20)
struct HingeLaw::Fall {
  Eigen::Index hinge = 0;
  double line[2] = {0, 0}, end[2] = {0, 0};  ///< above and below
  bool fails = false;                        ///< nothing is left; else what it keeps for good

  [[nodiscard]] static int number(double side) { return side > 0 ? 0 : 1; }
  [[nodiscard]] double at(double side) const { return line[number(side)]; }
  [[nodiscard]] double drop(double side) const {
    return line[number(side)] > end[number(side)] ? line[number(side)] - end[number(side)] : 0.0;
  }
};

}  // namespace bentur
