#pragma once

#include <vector>

#include "bentur/solve/engine/run/gap_monitor.h"

namespace bentur::engine {

/// How near watched floors (Problem::watched) come to what they face, and when: the largest x_left − x_right of the
/// continuous response. Like peaks: an interval is looked into unless its ends and a proven bound of its curvature show
/// that no floor can have come nearer in it (T-4); flights that this leaves unsettled are kept, as most are settled by
/// what follows. Nothing is done where no floor is watched.
class FloorWatch {
 public:
  FloorWatch(const ModalSystem& system, const TimeGrid& grid);

  struct Nearest {
    double reach = 0;  ///< max(0, x_left − x_right) so far [length]
    double time = 0;   ///< when [s]
  };
  /// Per watched floor.
  [[nodiscard]] const std::vector<Nearest>& nearest() const { return nearest_; }
  /// Goes on with such ones.
  void resume(const std::vector<Nearest>& nearest);

  /// Takes in where a run has been.
  void take(const StepBuffer& buffer);
  /// Takes in [0, end] of an expanded step from one state to another, which began at `time` [s].
  void take(const Expansion& motion, double end, const State& from, const State& to, double time);

  /// A flight in which a floor may have come nearer.
  struct Unsettled {
    const Flights* flights = nullptr;
    std::size_t halvings = 0;
    double time = 0, length = 0;  ///< [s]
    State start;
    std::vector<GroundInput> inputs;
    std::size_t gaps = 0;   ///< between which neighbours
    Eigen::VectorXd reach;  ///< of each of their floors
  };
  /// Whether it is time to look into what is unsettled: it bounds the memory of a long run.
  [[nodiscard]] bool much_is_unsettled() const;
  /// All that is unsettled, to be expanded again and taken in step by step.
  [[nodiscard]] std::vector<Unsettled> take_unsettled();
  /// Whether one may come nearer between two states, from whose chord coordinates stray by `rise` at most.
  [[nodiscard]] bool may_come_nearer(const State& from, const State& to, const Eigen::VectorXd& rise);
  /// Whether by now it is known that none has.
  [[nodiscard]] bool settled(const Unsettled& flight) const;

 private:
  void note(const Gaps& gaps, Eigen::Index n, double time);
  void note_ends(const Gaps& gaps, const double* start, const double* end, double start_time, double end_time);
  void search(Gaps& gaps, const Curves& left, const Curves& right, double time);

  const ModalSystem* system_;
  const TimeGrid* grid_;
  std::vector<Gaps> gaps_;  ///< peaks are the reaches so far
  std::vector<Nearest> nearest_;
  std::vector<Unsettled> unsettled_;
};

}  // namespace bentur::engine
