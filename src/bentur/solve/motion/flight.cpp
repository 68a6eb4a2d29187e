#include "bentur/solve/motion/flight.h"

#include <algorithm>
#include <cmath>

#include "bentur/solve/motion/series.h"

namespace bentur::engine {
namespace {

using Eigen::Index;

/// End position and speed of the oscillator q̈ + d q̇ + ω²q = f, f̈ = −ν²f, after `length`, by its power series in as
/// many equal steps as series_reach asks for.
struct Oscillator {
  double omega_squared, two_sigma, nu;

  void advance(double length, double& q, double& v, double f, double g) const {
    const double rate = std::max(0.5 * two_sigma + std::hypot(0.5 * two_sigma, std::sqrt(omega_squared)), nu);
    const auto steps = std::max(1L, std::lround(std::ceil(rate * length / series_reach)));
    const double h = length / static_cast<double>(steps);
    for (long n = 0; n < steps; ++n) step(h, q, v, f, g);
  }

 private:
  void step(double h, double& q, double& v, double& f, double& g) const {
    Polynomial c{q, v * h};
    Polynomial a{f, g * h};
    for (int k = 0; k + 2 <= highest_degree; ++k) {
      const double scale = 1.0 / ((k + 2.0) * (k + 1.0));
      c[k + 2] = (h * h * (a[k] - omega_squared * c[k]) - h * two_sigma * (k + 1.0) * c[k + 1]) * scale;
      a[k + 2] = -nu * nu * h * h * a[k] * scale;
    }
    q = value(c, 1.0);
    v = first_derivative(c, 1.0) / h;
    f = value(a, 1.0);
    g = first_derivative(a, 1.0) / h;
  }
};

}  // namespace

Flight::Flight(const ModalSystem& system, double length) : system_(&system), length_(length) {
  const Index n = system.size;
  for (auto* array :
       {&qq_,           &qv_,      &vq_,      &vv_,           &qa_,     &qb_,           &va_,     &vb_,
        &shift_,        &p_value_, &p_slope_, &p_rate_,       &second_, &second_force_, &fourth_, &fourth_force_,
        &fourth_slope_, &value_,   &slope_,   &start_energy_, &force_,  &force_slope_}) {
    array->setZero(n);
  }
  rise_.setZero(n);
  acceleration_rise_.setZero(n);
  const double nu = system.nu;
  const double chord = length * length / 8.0;
  for (Index j = 0; j < n; ++j) {
    const double w2 = system.omega_squared(j);
    const double d = system.two_sigma(j);
    const Oscillator oscillator{w2, d, nu};
    const auto column = [&](double q, double v, double f, double g, double& q_end, double& v_end) {
      oscillator.advance(length, q, v, f, g);
      q_end = q;
      v_end = v;
    };
    column(1, 0, 0, 0, qq_(j), vq_(j));
    column(0, 1, 0, 0, qv_(j), vv_(j));
    column(0, 0, 1, 0, qa_(j), va_(j));
    column(0, 0, 0, 1, qb_(j), vb_(j));

    if (nu == 0.0 && std::sqrt(w2) * length > 1.0) {
      shift_(j) = 1.0;
      p_value_(j) = 1.0 / w2;
      p_slope_(j) = -d / (w2 * w2);
      p_rate_(j) = 1.0 / w2;
    }
    const double kappa = std::sqrt(w2 + d * d);
    second_(j) = chord * kappa;
    fourth_(j) = chord * (d * (d * kappa + w2) + w2 * kappa);
    if (shift_(j) != 0.0) {  // u and ü stay within ±S/Ω and ±√(Ω² + D²) S: twice that is as far as a chord can be
      second_(j) = std::min(second_(j), 2.0 / std::sqrt(w2));
      fourth_(j) = std::min(fourth_(j), 2.0 * kappa);
    } else {
      second_force_(j) = chord;
      fourth_force_(j) = chord * (d * d + w2 + nu * nu);
      fourth_slope_(j) = chord * d;
    }
  }
}

void Flight::fill_inputs(const std::vector<GroundInput>& inputs) {
  const double nu = system_->nu;
  for (std::size_t b = 0; b < inputs.size(); ++b) {
    const auto& block = system_->blocks[b];
    const GroundInput& in = inputs[b];
    const double largest = nu > 0.0 ? std::hypot(in.value, in.slope / nu)
                                    : std::max(std::abs(in.value), std::abs(in.value + in.slope * length_));
    const double steepest = nu > 0.0 ? nu * largest : std::abs(in.slope);
    const auto gamma = system_->gamma.segment(block.begin, block.size).array();
    value_.segment(block.begin, block.size) = gamma * in.value;
    slope_.segment(block.begin, block.size) = gamma * in.slope;
    force_.segment(block.begin, block.size) = gamma.abs() * largest;
    force_slope_.segment(block.begin, block.size) = gamma.abs() * steepest;
  }
}

void Flight::advance(const State& from, const std::vector<GroundInput>& inputs, State& to) {
  fill_inputs(inputs);
  const auto q = from.q.array();
  const auto v = from.v.array();
  to.q.array() = qq_ * q + qv_ * v + qa_ * value_ + qb_ * slope_;
  to.v.array() = vq_ * q + vv_ * v + va_ * value_ + vb_ * slope_;
  start_energy_ = ((v - p_rate_ * slope_).square() +
                   system_->omega_squared.array() * (q - p_value_ * value_ - p_slope_ * slope_).square())
                      .sqrt() +
                  (1.0 - shift_) * length_ * force_;
  rise_ = second_ * start_energy_ + second_force_ * force_;
  acceleration_rise_ = fourth_ * start_energy_ + fourth_force_ * force_ + fourth_slope_ * force_slope_;
}

}  // namespace bentur::engine
