#pragma once

#include <span>
#include <vector>

#include "bentur/solve/engine/motion/modal_system.h"
#include "bentur/solve/engine/run/watch/bounded_outputs.h"

namespace bentur::engine {

/// Relations over the coordinates of the same bodies, one after the other in a list: how far their δ goes.
struct RelationGroup {
  Eigen::Index first = 0, count = 0;  ///< relations of the list
  Eigen::Index begin = 0;             ///< first coordinate of the left body; those up to the right one's follow
  BoundedOutputs rows;                ///< row · q of each
  Eigen::VectorXd reach;              ///< of these, in the interval last looked at

  /// Looks at an interval whose coordinates leave the chords between q and q_end by `rise` at most, lists of all
  /// coordinates. Whether no reach exceeds its peak so far.
  bool look(const double* q, const double* q_end, const double* rise);
};

/// A relation to be bounded, times a sign: of the values or of the sizes of its δ.
struct Bounded {
  const ModalSystem::Relation* relation = nullptr;
  double sign = 1;
  kernels::Peaks of = kernels::Peaks::of_values;
  bool switched = false;  ///< of what the free response does without
};

/// Groups of those that follow one another and are of the same bodies and kind.
[[nodiscard]] std::vector<RelationGroup> relation_groups(const std::vector<Bounded>& relations);
/// Of their values.
[[nodiscard]] std::vector<RelationGroup> relation_groups(const std::vector<ModalSystem::Relation>& relations);

}  // namespace bentur::engine
