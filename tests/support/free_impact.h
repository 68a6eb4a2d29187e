#pragma once

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "bentur/contact/law.h"

namespace bentur::test {

/// One instant of a free impact.
struct ImpactSample {
  double time = 0, penetration = 0, closing_speed = 0, force = 0;
  double kinetic = 0;  ///< ½ m_e δ̇²
  double stored = 0;
  int branch = 0;
  bool touching = false;
};

/// Two free bodies, the left one arriving at v₀ where the right one rests.
struct FreeImpact {
  double separation_speed = 0;
  double duration = 0;  ///< while touching
  double peak_force = 0, peak_force_time = 0, least_force = 0;
  double peak_penetration = 0, peak_penetration_time = 0;
  double momentum = 0;  ///< of both bodies, at the end
  LawState end;
  std::vector<ImpactSample> samples;  ///< four to a step, and both sides of every change of branch
};

/// A free impact by Runge-Kutta-Fehlberg 7(8) of both bodies, steps held to a local error of 1e-14 in units of the
/// impact, changes of branch located to the last bit. It knows a law by its interface alone. Against closed forms it is
/// good to about 1e-12 (free_impact_test.cpp).
class FreeImpactRun {
 public:
  FreeImpactRun(const ContactLaw& law, double left_mass, double right_mass, double closing_speed)
      : law_(law), masses_{left_mass, right_mass}, v0_(closing_speed) {
    effective_mass_ = left_mass * right_mass / (left_mass + right_mass);
    y_ = {0, 0, 1, 0};
  }

  [[nodiscard]] FreeImpact run() {
    if (const auto e = law_.restitution()) {
      out_.separation_speed = *e * v0_;
      out_.momentum = masses_[0] * v0_;
      return out_;
    }
    change(0);
    length_ = elastic_depth();
    time_ = length_ / v0_;
    double h = 1e-3;
    record(0);
    while (!(branch_.guard_count > 0 && !branch_.touching() && penetration(y_) <= 0 && speed(y_) < 0)) {
      if (++steps_ > 100000) throw std::runtime_error("free impact: no end");
      const auto event = first_event(h);
      const double step = event ? event->second : h;
      // A step that ends in an event is judged as the shorter step that it is: Hertz's force has a singularity there.
      const double error = step_error(step);
      // The error of one step grows as h⁹; where the force leaves zero as δ^¼ it does not, and only shorter steps help.
      const double factor = std::clamp(0.8 * std::pow(tolerance / std::max(error, 1e-30), 1.0 / 9), 0.1, 4.0);
      if (error > tolerance && step > 1e-13) {
        h = step * factor;
        continue;
      }
      advance(step, event);
      h = event ? h : step * factor;
    }
    out_.separation_speed = -speed(y_) * v0_;
    out_.momentum = (masses_[0] * y_[2] + masses_[1] * y_[3]) * v0_;
    out_.end = state_;
    return out_;
  }

 private:
  static constexpr double tolerance = 1e-14;  // of one step
  using Vector = std::array<double, 4>;       // x_left, x_right in length_, their velocities in v₀

  static double penetration(const Vector& y) { return y[0] - y[1]; }
  static double speed(const Vector& y) { return y[2] - y[3]; }
  double force(const Vector& y) const { return law_.force(state_, penetration(y) * length_, speed(y) * v0_); }

  double guard(std::size_t i, const Vector& y, double t) const {
    const Guard& g = branch_.guards[i];
    return g.constant + g.deformation * penetration(y) * length_ + g.speed * speed(y) * v0_ +
           (g.decaying == 0 ? 0 : g.decaying * std::exp(-g.rate * (t * time_ - state_.since)));
  }

  /// The depth at which the law's force without speed would balance the kinetic energy: the unit of length.
  double elastic_depth() const {
    const double energy = effective_mass_ * v0_ * v0_;
    double low = 1e-300, high = 1e300;
    for (int i = 0; i < 60; ++i) {
      const double middle = std::sqrt(low) * std::sqrt(high);
      (law_.force(state_, middle, 0) * middle < energy ? low : high) = middle;
    }
    return low;
  }

  Vector step_from(const Vector& start, double h) {
    Vector after = start;
    const auto motion = [&](const Vector& y, Vector& rate, double) {
      const double push = force(y) * time_ / v0_;
      rate = {y[2], y[3], -push / masses_[0], push / masses_[1]};
    };
    if (h > 0) stepper_.do_step(motion, start, 0.0, after, h);
    return after;
  }
  Vector part(double h) { return step_from(y_, h); }

  /// One step against two of half its length. (The pair's own estimate is blind to some errors.)
  double step_error(double h) {
    const Vector one = part(h), two = step_from(part(h / 2), h / 2);
    double worst = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
      // Bodies that have come far know their place no better than its round-off.
      worst = std::max(worst, std::abs(one[i] - two[i]) / std::max(1.0, std::abs(one[i])));
    }
    return worst;
  }

  using Event = std::optional<std::pair<std::size_t, double>>;  // which guard fails, and when

  Event first_event(double h) {
    Event first;
    const Vector after = part(h);
    for (std::size_t i = 0; i < branch_.guard_count; ++i) {
      if (guard(i, after, t_ + h) >= 0) continue;
      const double when = crossing([&](double part_h) { return guard(i, part(part_h), t_ + part_h); }, h);
      if (!first || when < first->second) first = {i, when};
    }
    return first;
  }

  void advance(double h, const Event& event) {
    const Vector end = part(h);
    look_at(h, end);
    y_ = end;
    t_ += h;
    if (event) {
      record(0);
      change(event->first);
    }
    record(0);
  }

  /// Where f comes down through zero in [0, h]; it is negative at h.
  template <class Function>
  static double crossing(const Function& f, double h) {
    const double start = f(0), end = f(h);
    if (start <= 0) return 0;
    std::uintmax_t most = 200;
    const auto closed = [](double a, double b) { return std::nextafter(a, b) == b || a == b; };
    return boost::math::tools::toms748_solve(f, 0.0, h, start, end, closed, most).second;
  }

  void change(std::size_t failed) {
    if (++changes_ > 1000) throw std::runtime_error("free impact: branches without end");
    state_ = law_.next(state_, failed, t_ * time_, penetration(y_) * length_, speed(y_) * v0_);
    branch_ = law_.branch(state_);
  }

  void look_at(double h, const Vector& end) {
    if (branch_.touching()) out_.duration += h * time_;
    if (speed(y_) > 0 && speed(end) <= 0) {
      const double when = crossing([&](double part_h) { return speed(part(part_h)); }, h);
      out_.peak_penetration = penetration(part(when)) * length_;
      out_.peak_penetration_time = (t_ + when) * time_;
    }
    for (const double at : {0.25, 0.5, 0.75}) record(at * h);
    const auto pull = [&](double part_h) { return -force(part(part_h)); };
    std::uintmax_t most = 100;
    const auto inside = boost::math::tools::brent_find_minima(pull, 0.0, h, 50, most);
    for (const auto& [when, value] : {inside, std::pair{0.0, pull(0)}, std::pair{h, pull(h)}}) {
      if (-value > out_.peak_force) out_.peak_force = -value, out_.peak_force_time = (t_ + when) * time_;
    }
  }

  void record(double h) {
    const Vector y = part(h);
    ImpactSample s;
    s.time = (t_ + h) * time_;
    s.penetration = penetration(y) * length_;
    s.closing_speed = speed(y) * v0_;
    s.force = force(y);
    s.kinetic = 0.5 * effective_mass_ * s.closing_speed * s.closing_speed;
    s.stored = law_.stored_energy(state_, s.penetration);
    s.branch = state_.branch;
    s.touching = branch_.touching();
    out_.least_force = std::min(out_.least_force, s.force);
    out_.samples.push_back(s);
  }

  const ContactLaw& law_;
  std::array<double, 2> masses_;
  double v0_, effective_mass_ = 0, length_ = 1, time_ = 1;
  Vector y_{};
  double t_ = 0;
  int steps_ = 0, changes_ = 0;
  LawState state_;
  Branch branch_;
  FreeImpact out_;
  boost::numeric::odeint::runge_kutta_fehlberg78<Vector> stepper_;  // its eighth-order result
};

[[nodiscard]] inline FreeImpact free_impact(const ContactLaw& law, double left_mass, double right_mass,
                                            double closing_speed) {
  return FreeImpactRun(law, left_mass, right_mass, closing_speed).run();
}

}  // namespace bentur::test
