#pragma once

#include <utility>
#include <vector>

#include "bentur/elements/law.h"
#include "bentur/solve/engine/motion/step_buffer.h"
#include "bentur/solve/engine/run/watch/relation_group.h"

namespace bentur::engine {

/// Proves that elements stay in branches whose guards say no more than how far δ may go: of many flights by one sum for
/// all elements of the same bodies (T-4), or element by element.
class GuardMonitor {
 public:
  /// What is known of an element's guards is how many of them there are in its first branch, and which way they look.
  struct Watched {
    const ModalSystem::Relation* relation = nullptr;
    double offset = 0;  ///< of δ [length]
    Branch first;
    bool switched = false;  ///< the free response does without it
    /// Of one that may be guarded on either side: how far δ is watched where it is on one alone [length]; 0: it is not.
    double span = 0;
  };
  explicit GuardMonitor(const std::vector<Watched>& elements, Eigen::Index stride);

  /// An element is in this branch now. Whether what ends it can be watched here.
  bool enter(Eigen::Index element, const Branch& branch);

  /// How many of `count` flights after the last step of a buffer come before the first in which one of the elements
  /// [first, end) may leave its branch.
  [[nodiscard]] Eigen::Index quiet(const StepBuffer& buffer, Eigen::Index count, Eigen::Index first, Eigen::Index end);

  /// Looks at every element over such an interval. Whether all stay in their branches.
  bool look(const double* q, const double* q_end, const double* rise, Eigen::Index first, Eigen::Index end);
  /// Whether one of them does, as was found then.
  [[nodiscard]] bool stays(Eigen::Index element) const { return stays_[element] != 0; }

 private:
  /// Guards a δ ≤ limit, or of |δ − centre|, as a group's rows have them.
  enum class Sides { none, upper, lower, both };
  [[nodiscard]] static Sides sides_of(const Branch& branch);
  [[nodiscard]] RelationGroup& group_of(Eigen::Index element);
  /// Those that begin with one of the elements [first, end), as [first, end) too.
  [[nodiscard]] std::pair<std::size_t, std::size_t> groups_of(Eigen::Index first, Eigen::Index end) const;
  void limit(std::size_t group);

  std::vector<RelationGroup> groups_;
  std::vector<Sides> sides_;     ///< per element, as its row has been made
  std::vector<double> offsets_;  ///< per element
  std::vector<double> spans_;    ///< per element
  std::vector<double> limits_;   ///< per element: of its row; infinite where that is not watched
  std::vector<char> stays_;
  std::vector<char> changed_;     ///< per group: whether its rows have still to learn of limits
  Eigen::VectorXd group_limits_;  ///< scratch
  Eigen::Index stride_;
};

}  // namespace bentur::engine
