#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "bentur/solve/engine/motion/expansion.h"
#include "bentur/solve/engine/run/coupled_elements.h"
#include "bentur/solve/engine/run/element_laws.h"
#include "bentur/solve/engine/run/impact_log.h"
#include "bentur/solve/engine/run/meetings.h"
#include "bentur/solve/engine/run/watch/guard_monitor.h"

namespace bentur::engine {

inline constexpr double round_off_band = 0x1p-46;  ///< of displacements and speeds at an element, and resting forces

/// Where every element stands, when that changes next, and what it does to the bodies.
///
/// Every branch of a law is guarded by functions of δ and δ̇ (law.h); a branch ends when one of them falls below minus
/// its tolerance, some units of round-off of the displacements and speeds it is computed from. The band keeps round-off
/// from changing an element to and fro at one instant; nothing deeper than it is missed. A contact ends without
/// tolerance where its opening becomes more than zero. One that began by going below the band is dated from where its
/// opening became negative: an opening of zero is open.
class Elements {
 public:
  struct Event {
    Eigen::Index element = 0;  ///< of several deformations: its number beyond those that have one
    std::size_t guard = 0;
    double s = 0;  ///< place in the expanded step
  };
  /// δ over a step of `h` [s] that began at `time` [s].
  struct Course {
    const Polynomial& deformation;
    double h = 0, time = 0;
  };
  /// Velocities that changed at one instant.
  struct Jump {
    Eigen::Index element = 0;
    double impulse = 0;      ///< [force·s]
    double energy_lost = 0;  ///< [force·length]
  };

  using Scales = ElementScales;
  using Account = ElementAccount;
  using Laws = ElementLaws;
  /// The first `idle` elements do nothing. `accuracy`: how well states at events are known, relative to displacements
  /// and speeds; a guard that starts its branch below zero by no more starts at zero. `state` is that at the start,
  /// whose force coordinates are filled in.
  Elements(const ModalSystem& system, const Laws& laws, Eigen::Index idle, const Scales& scales, double accuracy,
           State& state);

  [[nodiscard]] const ElementForces& forces() const { return forces_; }
  [[nodiscard]] Eigen::Index count() const { return std::ssize(laws_); }  ///< of one deformation; others come after
  [[nodiscard]] const LawState& law_state(Eigen::Index element) const { return states_[element]; }
  /// No force changes, and guards watch δ alone, so that bodies fly.
  [[nodiscard]] bool may_fly() const { return may_fly_; }
  [[nodiscard]] bool any_touching() const { return any_touching_; }  ///< bodies do

  /// How many of `count` flights after the last step of a buffer come before the first in which something may happen to
  /// the elements [first, end).
  [[nodiscard]] Eigen::Index quiet(const StepBuffer& buffer, Eigen::Index count, Eigen::Index first, Eigen::Index end) {
    return monitor_.quiet(buffer, count, first, end);
  }
  /// Looks at an interval between two states, whose coordinates leave their chords by `rise` at most. What follows is
  /// known of the interval last looked at.
  void look(const State& from, const State& to, const Eigen::VectorXd& rise) {
    (void)monitor_.look(from.q.data(), to.q.data(), rise.data(), idle_, count());
  }
  /// Takes in how large the displacements are at its end. To be called before events are looked for.
  void gauge(const State& to);
  /// The first change in the expanded step, which began at `time`; `by_series`: cut, it goes on the same, to round-off.
  [[nodiscard]] std::optional<Event> next_event(const Expansion& motion, const State& from, const State& to,
                                                double time, bool by_series);

  /// A change that is due at a state, looking at nothing before it.
  [[nodiscard]] std::optional<Event> due(const State& state, const std::vector<GroundInput>& inputs, double time) const;

  /// The force of every element [force].
  void forces_at(const State& state, const std::vector<GroundInput>& inputs, Eigen::VectorXd& result) const;
  /// Energy stored in all contacts [force·length].
  [[nodiscard]] double stored_in_contacts(const State& state) const;
  /// Energy that all other elements would give back, beyond what the modes hold of them [force·length].
  [[nodiscard]] double stored_in_others(const State& state) const;
  /// Power that their dashpots take in, beyond what D does [force·length/s].
  [[nodiscard]] double damping_power(const State& state) const;
  /// Work of the forces of all other elements by which the initial state came about [force·length].
  [[nodiscard]] double initial_work() const { return initial_work_; }
  [[nodiscard]] bool two_bodies(Eigen::Index element) const { return bodies_[element] != 0; }
  /// Whether it is one of two bodies of one deformation.
  [[nodiscard]] bool of_contact(const Event& event) const {
    return event.element < count() && two_bodies(event.element);
  }

  /// Adds [0, end] of the expanded step that began at `time` to the impacts under way and to what links do.
  void accumulate(const Expansion& motion, double time, double end);

  /// Notes when the openings of bodies that are apart last were zero, up to `end` of the expanded step, which began at
  /// `time`; `state` is that at `end`. To be called after every step, before change().
  void note_touches(const Expansion& motion, double time, double end, const State& state);

  /// A surface that has come back to within round-off of its place at `time` is a fresh one. To be called between
  /// steps, once what ended the last one has changed: its branch may be the one that is left.
  void forget_faded(double time, State& state);
  void go_on() { coupled_.go_on(); }  ///< a flight has been taken: nothing is at the beginning of its branch any more
  /// What follows from an event at `time`. An impact that takes no time changes the speeds in `state`.
  void change(const Event& event, double time, const std::vector<GroundInput>& inputs, State& state);
  /// Whether positions, speeds and forces were after the last change what they were before it, to round-off.
  [[nodiscard]] bool goes_on() const { return goes_on_; }
  [[nodiscard]] bool failed() const { return failed_; }  ///< the last change found no impulses (E-1)
  /// The element whose limit the last change has passed.
  [[nodiscard]] std::optional<Eigen::Index> limit_passed() const { return limit_passed_; }
  [[nodiscard]] bool began() const { return began_; }                      ///< it began a contact
  [[nodiscard]] const std::vector<Jump>& jumps() const { return jumps_; }  ///< of the last change
  [[nodiscard]] const Meetings& meetings() const { return meetings_; }     ///< and what they did at it

  /// Ends the run at `time`: contacts still closed count as impacts.
  void finish(double time);

  /// Of elements that are not idle, to go on from some state without contact.
  struct Memory {
    std::vector<LawState> states;
    std::vector<Account> accounts;
    std::vector<double> tolerances;
    std::vector<CoupledState> coupled;
    std::vector<Eigen::VectorXd> largest;  ///< of CoupledElements
  };
  [[nodiscard]] Memory memory() const;
  void resume(const Memory& memory, State& state);

  [[nodiscard]] long events() const { return events_; }
  [[nodiscard]] std::vector<Impact>& impacts() { return log_.impacts(); }
  [[nodiscard]] double energy_lost(Eigen::Index element, const State& state) const;
  [[nodiscard]] double residual(Eigen::Index element, const State& state) const;
  [[nodiscard]] std::optional<StrengthLoss> loss(Eigen::Index element, const State& state) const;
  /// Of those of several deformations.
  [[nodiscard]] std::vector<CoupledState> coupled(const State& state) const { return coupled_.states_at(state); }
  [[nodiscard]] const Account& account(Eigen::Index element) const { return accounts_[element]; }
  /// How far from zero the opening of two bodies was at any instant at which they began or ceased to touch because it
  /// was zero [length].
  [[nodiscard]] double worst_opening(Eigen::Index element) const { return worst_openings_[element]; }

 private:
  friend class Islands;
  enum class Force { resting, nonlinear, pressing, constant };
  [[nodiscard]] const Law& law(Eigen::Index element) const { return *laws_[element]; }
  [[nodiscard]] const ModalSystem::Relation& relation(Eigen::Index element) const {
    return system_->elements[element].relation;
  }
  [[nodiscard]] double deformation(Eigen::Index element, const State& state) const {
    return offsets_[element] + relation(element).along(state.q);
  }
  [[nodiscard]] double speed(Eigen::Index element, const State& state) const {
    return relation(element).along(state.v);
  }
  [[nodiscard]] bool resting(Eigen::Index element) const {
    return branches_[element].touching() && law(element).restitution().has_value();
  }
  [[nodiscard]] bool awaits(Eigen::Index element) const { return branches_[element].bodies == Bodies::apart; }
  [[nodiscard]] bool from_rest(Eigen::Index element, double closing_speed) const {
    return std::abs(closing_speed) < 1e3 * least_speeds_[element];  // 10⁻⁶ of the speeds at the point
  }
  void begin_impact(Eigen::Index element, Eigen::Index of_log, double start, double closing_speed, double stored);
  [[nodiscard]] double tolerance(Eigen::Index element, const Guard& guard, const State& state) const;
  [[nodiscard]] Polynomial guarded(Eigen::Index element, const Guard& guard, const Polynomial& deformation, double h,
                                   double time) const;
  void gauge(Eigen::Index element, const State& to);
  [[nodiscard]] std::optional<Event> next_event(Eigen::Index element, const Course& course, const State& from);
  void accumulate(Eigen::Index contact, const Course& course, double end, double speeds);
  void load(Eigen::Index element, const State& state);
  void enter(Eigen::Index element, const LawState& law_state);
  void set(Eigen::Index element, const LawState& law_state, State& state);
  void gather(State& state);
  [[nodiscard]] Force take_force(Eigen::Index element);
  void take_work(Eigen::Index element, double deformation);
  void let_go(Eigen::Index element, State& state);
  void note_opening(Eigen::Index element, double time, const State& state);
  void collide(Eigen::Index element, double time, State& state);
  /// A contact that rubs, as CoupledElements has it now.
  struct Rub {
    std::size_t number = 0;        ///< of those that rub
    std::size_t coupled = 0;       ///< of those that are coupled
    Eigen::Index at = 0, log = 0;  ///< its first element, and where its impacts are noted
    const Rubbing* law = nullptr;
  };
  [[nodiscard]] Rub rub(std::size_t number) const;
  [[nodiscard]] bool touches(const Rub& of) const;
  [[nodiscard]] bool touches_at(Eigen::Index point) const;
  [[nodiscard]] bool is_closed(Eigen::Index point) const;
  [[nodiscard]] bool may_touch(Eigen::Index point, const State& state);
  [[nodiscard]] bool is_settled(Eigen::Index point, double time, State& state);
  void take(Eigen::Index contact, int sharing);
  void part(Eigen::Index point, double time, State& state);
  void slip_off(Eigen::Index point, double time, State& state);
  void pass(Eigen::Index point, double time, State& state);
  void accumulate_rubbing(const Expansion& motion, double time, double end);
  void change_coupled(const Event& event, double time, const std::vector<GroundInput>& inputs, State& state);
  /// When the opening of bodies that are apart last was zero, and δ̇ then; negative time: it is above zero.
  struct Touch {
    double time = -1;
    double closing_speed = 0;
  };
  /// Where it is zero, and how far beyond round-off may go.
  struct Opening {
    Eigen::Index at = 0, log = 0;  ///< as of a Rub
    double surface = 0, band = 0;
    bool leaves_band = false;  ///< in the step last looked at
  };
  void note_touch(const Opening& of, const Expansion& motion, double time, double end, const State& state);
  void note_touch(const Opening& of, const Course& course, double end);
  [[nodiscard]] CoupledElements::Bands bands() const;
  [[nodiscard]] Eigen::VectorXd acceleration(const State& state, const std::vector<GroundInput>& inputs) const;

  const ModalSystem* system_;
  std::vector<std::shared_ptr<const Law>> laws_;
  std::vector<double> offsets_;       ///< of δ [length]
  Eigen::Index idle_;                 ///< the first elements, which do nothing
  std::vector<double> tolerances_;    ///< the band [length] per element
  std::vector<double> least_speeds_;  ///< slowest start of a contact that a law gets [length/s] per element
  double start_slack_;                ///< accuracy, in tolerances
  std::vector<LawState> states_;      ///< per element
  std::vector<Branch> branches_;      ///< of states_
  std::vector<char> bodies_;          ///< whether an element is two bodies
  std::vector<char> watched_;         ///< whether the monitor watches all that ends its branch
  std::vector<std::shared_ptr<const Rubbing>> rubbing_;
  Meetings meetings_;
  std::vector<double> along_;  ///< force of each along, where the last step ended [force]
  CoupledElements coupled_;
  GuardMonitor monitor_;
  ElementForces forces_;
  bool by_islands_ = false;  ///< what all elements do together is gathered later
  bool may_fly_ = true;
  bool any_touching_ = false;
  std::vector<Touch> touches_;     ///< per element, then of what rubs
  std::vector<char> leaves_band_;  ///< whether the opening of such bodies does, in the step last looked at
  ImpactLog log_;
  std::vector<Account> accounts_;
  std::vector<Jump> jumps_;
  double initial_work_ = 0;
  double fastest_ = 0;  ///< speed that modes have added up to at any event, or a part of free ones [length/s]
  std::optional<Eigen::Index> limit_passed_;
  bool began_ = false;
  bool goes_on_ = false;
  bool failed_ = false;
  long events_ = 0;
  std::vector<double> worst_openings_;
};

}  // namespace bentur::engine
