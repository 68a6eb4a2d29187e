#pragma once

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "bentur/solve/engine/motion/expansion.h"
#include "bentur/solve/engine/motion/sets_over_modes.h"
#include "bentur/solve/engine/run/watch/guard_monitor.h"

namespace bentur::engine {

/// Where the elements of several deformations stand, for Elements, whose rules they share: each guard has its band of
/// round-off. They are the bodies' own, and contacts that rub. A guard that is to begin its branch at zero is divided
/// by the power of time that it begins with.
class CoupledElements {
 public:
  using Laws = std::vector<std::shared_ptr<const CoupledLaw>>;
  /// Brought to `state` from rest in one go. Those beyond the last law do nothing.
  /// `sets`: what other runs of the system have met; null: nothing.
  CoupledElements(const ModalSystem& system, const Laws& laws, const std::vector<double>& offsets, const State& state,
                  std::shared_ptr<SetsOverModes> sets);

  /// What a monitor is to know of each deformation, beginning with the first, where nothing has happened.
  [[nodiscard]] static std::vector<Branch> first_branches(const ModalSystem& system, const Laws& laws);
  /// Tells the monitor of all branches, after which it learns of every change.
  void watch(GuardMonitor& monitor);

  /// Adds what they do, and writes their force coordinates into `state`. Whether they leave bodies to fly.
  [[nodiscard]] bool gather(ElementForces& forces, State& state);
  /// Adds F of each deformation.
  void add_forces(const State& state, Eigen::VectorXd& forces) const;
  /// Adds what the constant ones of these do to every coordinate.
  void add_loads(Eigen::VectorXd& load) const;

  struct Event {
    std::size_t element = 0, guard = 0;
    double s = 0;  ///< place in the expanded step
  };
  /// What a guard may be below zero by.
  struct Bands {
    const std::vector<double>& displacement;  ///< of each of ModalSystem::elements [length]
    double part = 0;                          ///< of speeds and constants [-]
    double start_slack = 0;                   ///< bands: what begins so far below zero begins at zero
  };
  /// The first change in the expanded step from one state to another, which began at `time` [s]. `apart`: where it is
  /// cut, bodies of elements that do not change go on as it has them, as nothing joins them to others.
  [[nodiscard]] std::optional<Event> next_event(const Expansion& motion, const State& from, const State& to,
                                                const Bands& bands, double time, bool apart);
  /// A change that is due at a state; `acceleration` is q̈ there.
  [[nodiscard]] std::optional<Event> due(const State& state, const Eigen::VectorXd& acceleration,
                                         const Bands& bands) const;
  /// Takes in how large the displacements of a state are.
  void gauge(const State& state, double part, std::vector<double>& displacement);
  /// A step that lasts has been taken: nothing is at its beginning any more.
  void go_on();

  /// What follows from a guard at `time`; `acceleration` is q̈ there.
  void change(const Event& event, double time, const State& state, const Eigen::VectorXd& acceleration);
  /// An element is in this state now.
  void enter_state(std::size_t element, CoupledState state);
  /// What follows when speeds have jumped.
  void settle(double time, const State& state, const Eigen::VectorXd& acceleration);

  [[nodiscard]] bool none() const { return states_.empty(); }
  [[nodiscard]] const CoupledBranch& branch(std::size_t element) const { return now_[element].branch; }
  [[nodiscard]] const std::vector<CoupledState>& states() const { return states_; }
  /// Of each element, the size of every coordinate at most so far.
  [[nodiscard]] const std::vector<Eigen::VectorXd>& largest() const { return largest_; }
  /// Of the first ones; the others begin.
  void resume(const std::vector<CoupledState>& states, const std::vector<Eigen::VectorXd>& largest);
  // Of the bodies' own:
  /// With what they remember up to date.
  [[nodiscard]] std::vector<CoupledState> states_at(const State& state) const;
  /// Beyond what the modes hold of them [force·length].
  [[nodiscard]] double stored_energy(const State& state) const;
  [[nodiscard]] double lost_energy(const State& state) const;

 private:
  struct Now {
    CoupledBranch branch;  ///< constants of its guards with the offsets of δ
    std::shared_ptr<const SetOverModes> known;
    std::vector<Eigen::Index> constant;  ///< of ModalSystem::elements: what does not move and pushes
    Eigen::VectorXd load;                ///< what these do to what moves of the bodies
    bool may_fly = false;
    bool begins = true;
    bool is_new = true;  ///< not gathered yet
    /// What is known of its guards while nothing but other such elements of other bodies changes: which is the next to
    /// fail, at `until` [s]; −1: none does before then.
    double until = -std::numeric_limits<double>::infinity();
    int next = -1;
    // What guards of deformations alone say of each row, least ≤ row ≤ most, and which of the guards say it (−1: the
    // bounds of the branch, or none); the other guards.
    Eigen::VectorXd least, most;
    std::vector<int> below, above, others;
    bool delayed = false;  ///< some of these are guards of deformations that begin the branch at zero
  };
  [[nodiscard]] Eigen::VectorXd deformation(std::size_t element, const State& state) const;
  [[nodiscard]] CoupledMotion motion_of(std::size_t element, const State& state,
                                        const Eigen::VectorXd& acceleration) const;
  [[nodiscard]] double band(std::size_t element, const CoupledGuard& guard, const State& state,
                            const Bands& bands) const;
  [[nodiscard]] Eigen::Index begin_of(std::size_t element) const {
    return system_->elements[system_->coupled[element].first].relation.left_begin;
  }
  [[nodiscard]] Polynomial row_of(std::size_t element, Eigen::Index row, const Expansion& motion) const;
  [[nodiscard]] std::optional<double> end_of(std::size_t element, const CoupledGuard& guard, const Expansion& motion,
                                             const State& from, const Bands& bands) const;
  [[nodiscard]] std::optional<Event> search(std::size_t element, const Expansion& motion, const State& from,
                                            const State& to, const Bands& bands, bool& risen);
  [[nodiscard]] bool keeps_speed(std::size_t element, const CoupledGuard& guard, const State& from,
                                 const State& to) const;
  void sort_guards(Now& now) const;
  [[nodiscard]] std::shared_ptr<const SetOverModes> known(std::size_t element,
                                                          const std::shared_ptr<const CoupledSet>& set);
  void enter(std::size_t element);
  void tell_monitor(std::size_t element);

  const ModalSystem* system_;
  Laws laws_;
  std::size_t own_ = 0;  ///< of bodies: the first ones
  std::vector<double> offsets_;
  std::vector<std::vector<Eigen::Index>> all_;  ///< per element: of ModalSystem::elements
  std::vector<Eigen::MatrixXd> rows_,
      pushes_;  ///< δ of each over what moves of its bodies, and what F does: a column each
  std::vector<Eigen::MatrixXd> along_, sizes_;  ///< δ again and |δ|, a row each
  std::vector<Eigen::VectorXd> largest_;        ///< size of each coordinate so far
  std::vector<Eigen::VectorXd> shifts_;         ///< offsets of each δ
  std::shared_ptr<SetsOverModes> sets_;         ///< of the bodies' own; of what rubs:
  std::map<std::pair<std::size_t, const CoupledSet*>, std::shared_ptr<const SetOverModes>> known_;
  std::vector<CoupledState> states_;
  std::vector<Now> now_;
  GuardMonitor* monitor_ = nullptr;
  double soon_ = 0;                                 ///< [s]
  Eigen::VectorXd low_, high_, speed_rise_, sums_;  ///< scratch
  std::vector<Eigen::Index> beyond_;                ///< scratch
  std::vector<int> asked_;                          ///< scratch
};

}  // namespace bentur::engine
