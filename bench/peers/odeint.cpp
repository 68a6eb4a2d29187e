#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint.hpp>
#include <cstdint>
#include <optional>
#include <vector>

#include "bench/peers/peers.h"

namespace bentur::bench {
namespace {

namespace odeint = boost::numeric::odeint;
using Vector = std::vector<double>;
using Stepper = odeint::result_of::make_dense_output<odeint::runge_kutta_dopri5<Vector>>::type;

/// The last step of the stepper, searched for what happens at the contact points.
class Step {
 public:
  Step(Equations& equations, Stepper& stepper) : equations_(equations), stepper_(stepper), state_(equations.size()) {}

  /// The state at the first instant at which a point touches or parts, and the points that do so; nothing where none
  /// does.
  std::optional<double> first_change(std::vector<std::size_t>& changing);
  /// Notes the largest forces up to `end`.
  void note_peaks(double end);
  [[nodiscard]] const Vector& state_at(double time) {
    stepper_.calc_state(time, state_);
    return state_;
  }

 private:
  double opening(std::size_t point, double time) { return equations_.opening(point, state_at(time).data()); }
  double rate(std::size_t point, double time) { return equations_.opening_rate(point, state_at(time).data()); }

  template <class Function>
  double root(Function function, double a, double b) {
    std::uintmax_t iterations = 100;
    const auto found =
        boost::math::tools::toms748_solve(function, a, b, boost::math::tools::eps_tolerance<double>(50), iterations);
    return found.second;
  }
  /// Where the opening turns, if it does so between the ends.
  std::optional<double> turn(std::size_t point) {
    const double a = stepper_.previous_time(), b = stepper_.current_time();
    const double first = equations_.opening_rate(point, stepper_.previous_state().data());
    const double last = equations_.opening_rate(point, stepper_.current_state().data());
    if (!(first * last < 0)) return std::nullopt;
    return root([&](double time) { return rate(point, time); }, a, b);
  }
  /// When a point leaves the side it is on: +1 open, −1 closed.
  std::optional<double> change(std::size_t point);

  Equations& equations_;
  Stepper& stepper_;
  Vector state_;
};

std::optional<double> Step::change(std::size_t point) {
  const double side = equations_.closed(point) ? -1 : 1;
  const double last = side * equations_.opening(point, stepper_.current_state().data());
  const double first = side * equations_.opening(point, stepper_.previous_state().data());
  double a = stepper_.previous_time(), b = stepper_.current_time();
  if (last >= 0) {  // it may have left and come back
    if (!(side * equations_.opening_rate(point, stepper_.previous_state().data()) < 0)) return std::nullopt;
    const auto lowest = turn(point);
    if (!lowest || side * opening(point, *lowest) >= 0) return std::nullopt;
    b = *lowest;
  }
  if (first <= 0) {  // it has just come to this side: a step begins where a contact does
    const auto furthest = turn(point);
    if (!furthest || side * opening(point, *furthest) <= 0) return last >= 0 ? std::nullopt : std::optional(a);
    a = *furthest;
  }
  return root([&](double time) { return opening(point, time); }, a, b);
}

std::optional<double> Step::first_change(std::vector<std::size_t>& changing) {
  std::optional<double> first;
  changing.clear();
  for (std::size_t i = 0; i < equations_.points(); ++i) {
    const auto time = change(i);
    if (!time || (first && *time > *first)) continue;
    if (!first || *time < *first) changing.clear();
    first = time;
    changing.push_back(i);
  }
  return first;
}

void Step::note_peaks(double end) {
  for (std::size_t i = 0; i < equations_.points(); ++i) {
    if (!equations_.closed(i)) continue;
    const auto time = turn(i);
    if (time && *time <= end) equations_.note_peak(i, state_at(*time).data());
  }
}

}  // namespace

void integrate_with_odeint(Equations& equations, double tolerance, FloorPeaks* peaks) {
  const auto system = [&equations](const Vector& y, Vector& rate, double time) {
    equations.derivative(time, y.data(), rate.data());
  };
  Stepper stepper =
      odeint::make_dense_output(tolerance * equations.scale(), tolerance, odeint::runge_kutta_dopri5<Vector>());
  const std::vector<double>& times = equations.breakpoints();
  Vector state(equations.size(), 0.0);
  Step step(equations, stepper);
  std::vector<std::size_t> changing;
  double time = 0, length = 1e-3 * (times[1] - times[0]);
  for (std::size_t j = 0; j + 1 < times.size(); ++j) {
    const double until = times[j + 1];
    equations.enter(j);
    stepper.initialize(state, time, std::min(length, until - time));
    while (time < until) {
      length = stepper.current_time_step();
      if (time + length > until) {  // a step must not reach into the next interval
        state = stepper.current_state();
        stepper.initialize(state, time, until - time);
      }
      stepper.do_step(system);
      const auto change = step.first_change(changing);
      time = change ? *change : stepper.current_time();
      step.note_peaks(time);
      if (until - time < 1e-12 * until) time = until;
      if (change) {
        for (const std::size_t point : changing) equations.set_closed(point, !equations.closed(point));
        state = step.state_at(*change);
        length = stepper.current_time_step();
        if (time < until) stepper.initialize(state, time, std::min(length, until - time));
      } else {
        state = stepper.current_state();
      }
      if (peaks != nullptr) peaks->look(time, state.data());
    }
  }
}

}  // namespace bentur::bench
