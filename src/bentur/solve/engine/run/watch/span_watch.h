#pragma once

#include <vector>

#include "bentur/solve/engine/motion/step_buffer.h"
#include "bentur/solve/engine/run/watch/relation_group.h"
#include "bentur/solve/solution.h"

namespace bentur::engine {

/// How far the δ of some relations goes, and when: its largest value in the continuous response. Like peaks: an
/// interval is looked into unless its ends and a proven bound of its curvature show that no δ can have gone further in
/// it (T-4); flights that this leaves unsettled are kept, as most are settled by what follows. Nothing is done where
/// there are no relations.
class SpanWatch {
 public:
  SpanWatch(const ModalSystem& system, const std::vector<ModalSystem::Relation>& relations, const TimeGrid& grid);

  /// Per relation, so far.
  [[nodiscard]] const std::vector<Reach>& nearest() const { return nearest_; }
  /// Goes on with such ones.
  void resume(const std::vector<Reach>& nearest);

  /// The relations, with their largest values so far as peaks.
  [[nodiscard]] const std::vector<RelationGroup>& groups() const { return groups_; }

  /// Takes in where a run has been.
  void take(const StepBuffer& buffer);
  /// Takes in [0, end] of an expanded step from one state to another, which began at `time` [s].
  void take(const Expansion& motion, double end, const State& from, const State& to, double time);

  /// A flight in which a δ may have gone further.
  struct Unsettled {
    const Flights* flights = nullptr;
    std::size_t halvings = 0;
    double time = 0, length = 0;  ///< [s]
    State start;
    std::vector<GroundInput> inputs;
    std::size_t group = 0;
    Eigen::VectorXd reach;  ///< of each relation of the group
  };
  /// Whether it is time to look into what is unsettled: it bounds the memory of a long run.
  [[nodiscard]] bool much_is_unsettled() const;
  /// All that is unsettled, to be expanded again and taken in step by step.
  [[nodiscard]] std::vector<Unsettled> take_unsettled();
  /// Whether one may go further between two states, from whose chord coordinates stray by `rise` at most.
  [[nodiscard]] bool may_go_further(const State& from, const State& to, const Eigen::VectorXd& rise);
  /// Whether by now it is known that none has.
  [[nodiscard]] bool settled(const Unsettled& flight) const;

 private:
  void note(const RelationGroup& group, Eigen::Index n, double time);
  void note_ends(const RelationGroup& group, const double* start, const double* end, double start_time,
                 double end_time);
  void search(RelationGroup& group, const Curves& left, const Curves& right, double time);

  const ModalSystem* system_;
  const TimeGrid* grid_;
  std::vector<ModalSystem::Relation> relations_;
  std::vector<RelationGroup> groups_;
  std::vector<Reach> nearest_;
  std::vector<Unsettled> unsettled_;
};

}  // namespace bentur::engine
