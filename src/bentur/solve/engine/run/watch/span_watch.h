#pragma once

#include <array>
#include <functional>
#include <vector>

#include "bentur/solve/engine/motion/series.h"
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
  /// Whether two like bodies moved alike all the way there: the δ of such a group were zero.
  [[nodiscard]] bool moved_alike(std::size_t group) const { return moved_alike_[group] != 0; }
  /// Takes in [0, end] of an expanded step from one state to another, which began at `time` [s].
  void take(const Expansion& motion, double end, const State& from, const State& to, double time);

  /// Takes in the δ of one relation over a step of `h` [s] that began at `time` [s].
  void take(Eigen::Index relation, const Polynomial& delta, double h, double time);

  /// Whether it is time for settle(): it bounds the memory of a long run.
  [[nodiscard]] bool much_is_unsettled() const;
  /// Learns how many steps the search takes next; false: it ends there.
  using GoOn = std::function<bool(long)>;
  /// Looks into all flights that are unsettled, each of the bodies alone whose δ may have gone further.
  void settle(Series& series, Expansion& motion, const GoOn& go_on);

 private:
  /// Of one or two bodies, one per component.
  using Inputs = std::array<std::array<GroundInput, most_components>, 2>;
  /// A flight of the bodies of a group, or a part of it.
  struct Stretch {
    std::size_t group = 0;
    const Flights* flights = nullptr;
    std::size_t halvings = 0;
    double time = 0;  ///< of its start [s]
    Inputs inputs;    ///< there
  };
  /// One in which a δ may have gone further. kept_ has, from `at` on, the reach of each relation of the group, and q, v
  /// and q̈ of its bodies at the start.
  struct Unsettled {
    Stretch stretch;
    std::size_t at = 0;
  };
  /// What a search works with.
  struct Tools {
    Series& series;
    Expansion& motion;
    const GoOn& go_on;
    std::array<const double*, 2> loads;  ///< constant, on the coordinates of each body; null: none
  };
  struct Place {
    State state;
    Eigen::VectorXd acceleration;  ///< q̈
  };
  /// Scratch of one halving: the instants at the middle and the end, reach of a half.
  struct Halving {
    Place middle, end;
    Eigen::VectorXd reach;
  };

  [[nodiscard]] bool are_alike(const StepBuffer& buffer, Eigen::Index instant, std::size_t group) const;
  [[nodiscard]] bool are_driven_alike(const StepBuffer& buffer, Eigen::Index step, std::size_t group) const;
  [[nodiscard]] bool move_alike(const StepBuffer& buffer, std::size_t group) const;
  void keep(const StepBuffer& buffer, Eigen::Index step, std::size_t group, double time);
  [[nodiscard]] bool settled(const Unsettled& flight) const;
  [[nodiscard]] bool settled_by_cubics(const Stretch& stretch, const Place& from, const double* before, Place& to,
                                       Eigen::VectorXd& reach, Tools& tools);
  void replay(const Stretch& stretch, const Place& from, const double* before, Tools& tools);
  void take(RelationGroup& group, const Expansion& motion, double end, const State& from, const State& to, double time);
  void note(const RelationGroup& group, Eigen::Index n, double time);
  void note_ends(const RelationGroup& group, const double* start, const double* end, double start_time,
                 double end_time);
  void search(RelationGroup& group, const Curves& left, const Curves& right, double time);

  const ModalSystem* system_;
  const TimeGrid* grid_;
  std::vector<ModalSystem::Relation> relations_;
  std::vector<RelationGroup> groups_;
  std::vector<Reach> nearest_;
  std::vector<std::vector<Eigen::Index>> bodies_;  ///< of each group, one or two
  std::vector<char> twins_;                        ///< of each group: are_twins()
  std::vector<char> together_;                     ///< of each group: whether the ground moves its bodies together
  std::vector<char> moved_alike_;                  ///< of each group
  double rate_;                                    ///< growth bound of a power series in flight [1/s]
  std::vector<Unsettled> unsettled_;
  std::vector<double> kept_;
  std::vector<Halving> halvings_;                     ///< scratch
  Place start_, end_;                                 ///< scratch
  Eigen::VectorXd reach_, rise_, acceleration_rise_;  ///< scratch
  Eigen::MatrixXd slopes_;                            ///< scratch: of q and q̈ at both ends
  std::array<Eigen::VectorXd, 2> loads_;              ///< scratch
};

}  // namespace bentur::engine
