#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "bentur/solve/engine/run/element_laws.h"
#include "bentur/solve/engine/tangent/tangent_step.h"

namespace bentur::engine {

/// Goes along a run whose events are known, and takes the derivatives of its state along: (S-1) between events, (S-2)
/// and (S-3) at them.
class TangentRun {
 public:
  struct Setup {
    const System& system;
    const ModalSystem& modal;
    const TimeGrid& grid;
    const ElementLaws& laws;
    const Dependence& by;
  };
  /// At the start. The contacts act where `with_contact`.
  TangentRun(const Setup& setup, bool with_contact);

  /// The largest |δ̇| of every contact at the ends of stretches so far [length/s], and those of the whole run, which are
  /// usual.
  [[nodiscard]] const std::vector<double>& speeds() const { return speeds_; }
  void set_usual_speeds(std::vector<double> speeds) { usual_speeds_ = std::move(speeds); }

  /// A stretch without events, at its start.
  struct Stretch {
    double start, length;  ///< [s]
    const TangentState& from;
    const TangentInputs& inputs;
    const std::vector<Pressing>& pressing;
  };
  using Take = std::function<void(const Stretch&, const TangentState& to)>;
  /// Goes on to a time [s] before which nothing happens; `take` learns of every stretch on the way.
  void go_to(double time, const Take& take = {});
  /// What happens there. @throws InvalidParameter of what (S-3) does not describe
  void change(const Change& change);

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] const TangentState& state() const { return state_; }
  [[nodiscard]] double longest_step() const { return longest_; }
  /// Takes the derivatives of a row of coordinates that is looked at now.
  [[nodiscard]] Eigen::RowVectorXd of_row(const Eigen::VectorXd& row) const { return row.transpose() * state_.by_q; }
  /// F of an element now, and its derivatives.
  [[nodiscard]] double force(Eigen::Index element, Eigen::RowVectorXd& by);
  /// Ḟ of an element now.
  [[nodiscard]] double force_rate(Eigen::Index element);
  [[nodiscard]] bool presses(Eigen::Index element) const;

  /// τ_p of the last event, the velocities before it, and their size after.
  [[nodiscard]] const Eigen::RowVectorXd& event_by() const { return event_by_; }
  [[nodiscard]] const TangentState& before_event() const { return before_; }
  [[nodiscard]] double grazing() const { return grazing_; }
  [[nodiscard]] bool is_simultaneous() const { return simultaneous_; }

 private:
  /// Of a kind of segment in which nothing presses: the state at its end, of that at its start and the inputs.
  struct Flight {
    bool is_made = false;
    Eigen::VectorXd qq, qv, vq, vv;   ///< of every coordinate: modes and ground are oscillators of their own
    Eigen::MatrixXd q_of_u, v_of_u;   ///< coordinates × (values, slopes) per component
    std::vector<Eigen::MatrixXd> by;  ///< per body: of each of its parameters q and v, over q, v, values and slopes
  };
  void make_flight(Flight& flight, double h);
  void fly(const Flight& flight);
  void enter_segment();
  void set_pressing();
  void note_speeds();
  void note_grazing(Eigen::Index element, double rate, double usual, double slope);
  void collide(const Change& change);
  void take_memory(const Change& change, const Eigen::VectorXd& a);
  [[nodiscard]] Eigen::RowVectorXd deformations_by(Eigen::Index element) const;
  [[nodiscard]] Eigen::RowVectorXd speeds_by(Eigen::Index element) const;

  const Setup setup_;
  TangentStep step_;
  TangentState state_, before_;
  TangentInputs inputs_;
  long segment_ = 0;
  double time_ = 0, longest_ = 0;
  std::vector<LawState> law_states_;
  /// since, closing speed and memory of an element's law, × parameters; empty: none of it depends on any.
  std::vector<Eigen::MatrixXd> memories_;
  std::vector<Pressing> pressing_;
  std::vector<Flight> flights_;
  std::vector<double> speeds_, usual_speeds_;  ///< of contacts; the latter empty: not known
  std::vector<double> peaks_;                  ///< of the motions
  Eigen::RowVectorXd event_by_;
  double last_jump_ = -1, grazing_ = 1;
  bool simultaneous_ = false;
  Eigen::VectorXd scratch_q_, scratch_v_, column_, product_;
  bool with_contact_ = false;
};

}  // namespace bentur::engine
