#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "bentur/solve/engine/motion/expansion.h"
#include "bentur/solve/engine/run/gap_monitor.h"
#include "bentur/solve/engine/run/impact_log.h"

namespace bentur::engine {

/// Where every contact stands, when that changes next, and what it does to the buildings.
///
/// Every branch of a law is guarded by functions of δ and δ̇ (law.h); a branch ends when one of them falls below minus
/// its tolerance, some units of round-off of the displacements and speeds it is computed from. The band keeps round-off
/// from changing a contact to and fro at one instant; nothing deeper than it is missed. A contact ends without
/// tolerance where its opening becomes more than zero. One that began by going below the band is dated from where its
/// opening became negative: an opening of zero is open.
class Contacts {
 public:
  struct Event {
    Eigen::Index point = 0;
    std::size_t guard = 0;
    double s = 0;  ///< place in the expanded step
  };
  /// Velocities that changed at one instant.
  struct Jump {
    Eigen::Index point = 0;
    double impulse = 0;      ///< [force·s]
    double energy_lost = 0;  ///< [force·length]
  };

  /// How large the numbers are whose difference an opening is, and how fast they change, per point.
  struct Scales {
    std::vector<double> displacement;  ///< [length]; grows with what the run does
    std::vector<double> speed;         ///< [length/s]
  };
  /// `accuracy`: how well states at events are known, relative to displacements and speeds; a guard that starts its
  /// branch below zero by no more starts at zero.
  Contacts(const ModalSystem& system, const Problem& problem, const Scales& scales, double accuracy);

  [[nodiscard]] const ContactForces& forces() const { return forces_; }
  /// No contact remembers anything, so that a free flight need only watch openings.
  [[nodiscard]] bool all_apart() const { return all_apart_; }

  /// Takes in how large the displacements are in a step between two states, at the points that `monitor` could not
  /// prove open. To be called before events are looked for in it.
  void gauge(const State& from, const State& to, const GapMonitor& monitor);

  /// The first change in the expanded step, which began at `time` with the state `from`; `monitor` has looked at it.
  [[nodiscard]] std::optional<Event> next_event(const Expansion& motion, const State& from, const GapMonitor& monitor,
                                                double time);

  /// A change that is due at a state, looking at nothing before it.
  [[nodiscard]] std::optional<Event> due(const State& state, const std::vector<GroundInput>& inputs, double time) const;

  /// The force of every point [force].
  void forces_at(const State& state, const std::vector<GroundInput>& inputs, Eigen::VectorXd& result) const;
  /// Energy stored in all contacts [force·length].
  [[nodiscard]] double stored_energy(const State& state) const;

  /// Adds [0, end] of the expanded step, which began at `time`, to the impacts under way.
  void accumulate(const Expansion& motion, double time, double end);

  /// Notes when the openings of open points last were zero, up to `end` of the expanded step, which began at `time` and
  /// at which `monitor` has looked; `state` is that at `end`. To be called after every step, before change().
  void note_touches(const Expansion& motion, const GapMonitor& monitor, double time, double end, const State& state);

  /// What follows from an event at `time`. An impact that takes no time changes the speeds in `state`.
  void change(const Event& event, double time, State& state);
  /// Whether the last change found no impulses (E-1).
  [[nodiscard]] bool failed() const { return failed_; }
  /// Whether the last change began a contact.
  [[nodiscard]] bool began() const { return began_; }
  /// The jumps of the last change.
  [[nodiscard]] const std::vector<Jump>& jumps() const { return jumps_; }

  /// Ends the run at `time`: contacts still closed count as impacts.
  void finish(double time) { log_.finish(branches_, time); }

  [[nodiscard]] long events() const { return events_; }
  [[nodiscard]] std::vector<Impact>& impacts() { return log_.impacts(); }

 private:
  [[nodiscard]] const Law& law(Eigen::Index point) const { return *problem_->points[point].law; }
  [[nodiscard]] double penetration(Eigen::Index point, const State& state) const;
  [[nodiscard]] double closing_speed(Eigen::Index point, const State& state) const;
  [[nodiscard]] bool resting(Eigen::Index point) const;
  [[nodiscard]] bool from_rest(Eigen::Index point, double closing_speed) const {
    return std::abs(closing_speed) < least_speeds_[point];
  }
  [[nodiscard]] double tolerance(Eigen::Index point, const Guard& guard, const State& state) const;
  [[nodiscard]] Polynomial guarded(Eigen::Index point, const Guard& guard, const Polynomial& opening, double h,
                                   double time) const;
  void set(Eigen::Index point, const LawState& state);
  void forget_faded(double time);
  void let_go(Eigen::Index point, State& state);
  void collide(Eigen::Index point, double time, State& state);

  const ModalSystem* system_;
  const Problem* problem_;
  std::vector<double> tolerances_;    ///< the band [length] per point
  std::vector<double> least_speeds_;  ///< slowest start of a contact that a law is told of [length/s] per point
  double start_slack_;                ///< accuracy, in tolerances
  std::vector<LawState> states_;  ///< per point
  std::vector<Branch> branches_;      ///< of states_
  ContactForces forces_;
  bool all_apart_ = true;
  /// When the opening of an open point last was zero, and its closing speed then; negative time: it is above zero.
  struct Touch {
    double time = -1;
    double closing_speed = 0;
  };
  std::vector<Touch> touches_;
  std::vector<char> leaves_band_;  ///< whether the opening of an open point does, in the step last looked at
  ImpactLog log_;
  std::vector<Jump> jumps_;
  double fastest_ = 0;  ///< speed that modes have added up to at any event, or a part of free ones [length/s]
  bool began_ = false;
  bool failed_ = false;
  long events_ = 0;
};

}  // namespace bentur::engine
