#pragma once

#include <optional>
#include <vector>

#include "bentur/solve/exact/series.h"
#include "bentur/solve/response.h"

namespace bentur::exact {

/// Which points are in contact, when that changes next, and the list of impacts.
///
/// An open point closes when its opening becomes less than −tolerance, a closed one opens when its opening becomes
/// more than zero. The band between, a few units of round-off of the displacements there, keeps round-off from
/// opening and closing a point at one instant; nothing deeper than it is missed.
class Contacts {
 public:
  struct Event {
    std::size_t point = 0;
    double s = 0;  ///< place in the expanded step
  };

  Contacts(const ModalSystem& system, const Problem& problem, std::vector<double> tolerances);

  [[nodiscard]] const std::vector<char>& closed() const { return closed_; }
  [[nodiscard]] bool any_closed() const { return closed_count_ > 0; }

  /// True when no open point can have closed between two states, given a bound of |q̈| times length²/8 per coordinate.
  [[nodiscard]] bool clear(const State& from, const State& to, const Eigen::VectorXd& rise) const;

  /// The first change in the expanded step; `from` and `to` are the states at its ends.
  [[nodiscard]] std::optional<Event> next_event(const Series& series, const State& from, const State& to) const;

  /// Adds [0, end] of the expanded step, which began at `time`, to the impacts under way.
  void accumulate(const Series& series, double time, double end);

  /// Notes which open points have come into the round-off band by `end` of the expanded step, which began at `time`;
  /// `state` is that at `end`. To be called after every step, before change().
  void note_touches(const Series& series, double time, double end, const State& state);

  /// Closes or opens the point of the event, at `time`.
  void change(const Event& event, const Series& series, double time);

  /// Ends the run at `time`: contacts still closed count as impacts.
  void finish(double time);

  [[nodiscard]] long events() const { return events_; }
  [[nodiscard]] std::vector<Impact>& impacts() { return impacts_; }

 private:
  const ModalSystem* system_;
  const Problem* problem_;
  std::vector<double> tolerances_;  ///< [length] per point
  std::vector<char> closed_;
  /// When the opening of an open point became zero, and its closing speed then; negative time: it is above zero.
  struct Touch {
    double time = -1;
    double closing_speed = 0;
  };
  std::vector<Touch> touches_;
  std::vector<Impact> under_way_;  ///< per point, meaningful while closed
  std::size_t closed_count_ = 0;
  long events_ = 0;
  std::vector<Impact> impacts_;
};

}  // namespace bentur::exact
