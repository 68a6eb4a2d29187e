// The exact solver against responses that are known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "bentur/contact/laws/filler.h"
#include "bentur/contact/laws/kelvin_voigt.h"
#include "bentur/contact/laws/restitution.h"
#include "bentur/pounding/pounding.h"
#include "tests/support/small_buildings.h"

namespace bentur {
namespace {

using std::numbers::pi;
using namespace bentur::test;

// Round-off: about 1e-15 a step of the record and a few hundred steps.
constexpr double round_off = 2e-13;

Response with_histories(const Problem& problem, double step) {
  SolveOptions options;
  options.output_step = step;
  return solve(problem, ExactSolver{}, options);
}

/// x(t) of ẍ + 2ζω ẋ + ω² x = 0, any ζ, in long double and complex arithmetic; critical damping by its own formula.
double free_vibration(double omega, double zeta, double x0, double v0, double t) {
  using Complex = std::complex<long double>;
  const long double w = omega, z = zeta, x = x0, v = v0;
  if (zeta == 1.0) return static_cast<double>(std::exp(-w * t) * (x + (v + w * x) * static_cast<long double>(t)));
  const Complex root = std::sqrt(Complex(z * z - 1.0L)) * w;
  const Complex a = -z * w + root;
  const Complex b = -z * w - root;
  const Complex first = (v - b * x) / (a - b);
  const Complex second = (a * x - v) / (a - b);
  return static_cast<double>(
      (first * std::exp(a * static_cast<long double>(t)) + second * std::exp(b * static_cast<long double>(t))).real());
}

TEST(ClosedForm, FreeVibrationAtEveryDamping) {
  // 1 ± 1e-5 is nearly defective: the closed form itself loses five of long double's nineteen digits there.
  for (const double zeta : {0.0, 0.05, 0.7, 1.0 - 1e-5, 1.0, 1.0 + 1e-5, 3.0}) {
    Problem problem = pair(oscillator(2.0, 800.0, zeta), wall(), {contact(10.0, 1e3)}, 2.0);
    problem.initial_displacement[0](0) = 0.3;
    problem.initial_velocity[0](0) = -2.0;
    const Response response = with_histories(problem, 0.01);
    ASSERT_EQ(response.status, Status::done);
    for (std::size_t i = 0; i < response.histories.time.size(); ++i) {
      ASSERT_NEAR(response.histories.displacement[0](0, static_cast<Eigen::Index>(i)),
                  free_vibration(20.0, zeta, 0.3, -2.0, response.histories.time[i]), round_off)
          << "zeta " << zeta << " t " << response.histories.time[i];
    }
  }
}

TEST(ClosedForm, ACrushedFillerIsMetWhereItWasLeft) {
  // A free mass between a wall, from which it comes back with 0.9 of its speed, and foam of F_c = 100, δ_c = 0.01. The
  // first impact crushes (½ 3² − ½ 100 · 0.01)/100 = 0.04 of it, the others nothing.
  const auto at = [](int left, std::shared_ptr<const ContactLaw> law) {
    ContactPoint point = contact(0.1, 1.0, 0, left);
    point.law = std::move(law);
    return point;
  };
  Problem problem;
  problem.buildings = {wall(), oscillator(1.0, 0.0), wall()};
  problem.points = {at(0, std::make_shared<Restitution>(0.9)),
                    at(1, std::make_shared<Filler>(100, 0.5, 0.02, 0.8, 1e5))};
  problem.delays = {0, 0, 0};
  problem.initial_displacement =
      problem.initial_velocity = {Eigen::VectorXd::Zero(1), Eigen::VectorXd::Zero(1), Eigen::VectorXd::Zero(1)};
  problem.initial_velocity[1](0) = 3.0;
  problem.duration = 2.0;
  const Response response = solve(problem);
  ASSERT_EQ(response.status, Status::done) << response.message;
  ASSERT_GE(response.impacts.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) ASSERT_EQ(response.impacts[i].point, i % 2 == 0 ? 1U : 0U);
  const double back = 0.1 + 0.04 + 0.1, omega = 100.0;  // from the crushed foam to the wall; √(10⁴/1)
  double speed = 1.0, time = response.impacts[0].end;
  EXPECT_NEAR(response.impacts[0].energy_lost, 4.0, 1e-12);
  EXPECT_NEAR(response.impacts[0].separation_speed, speed, 1e-12);
  for (const std::size_t i : {2U, 4U}) {
    EXPECT_NEAR(response.impacts[i - 1].start, time + back / speed, 1e-12);
    time += back / speed + back / (0.9 * speed);
    speed *= 0.9;
    EXPECT_NEAR(response.impacts[i].start, time, 1e-12);
    EXPECT_NEAR(response.impacts[i].closing_speed, speed, 1e-12);
    EXPECT_NEAR(response.impacts[i].peak_force, omega * speed, 1e-10);
    EXPECT_NEAR(response.impacts[i].energy_lost, 0.0, 1e-12);
    time += pi / omega;
    EXPECT_NEAR(response.impacts[i].end, time, 1e-12);
  }
  EXPECT_NEAR(response.points[1].peak_penetration, 0.05, 1e-14);
}

TEST(ClosedForm, PeaksAreThoseOfTheContinuousResponse) {
  Problem problem = pair(oscillator(1.0, 400.0), wall(), {contact(10.0, 1.0)}, 5.0);
  problem.initial_displacement[0](0) = 0.3;
  problem.initial_velocity[0](0) = 8.0;
  const Response response = solve(problem);
  const double amplitude = std::hypot(0.3, 8.0 / 20.0);
  EXPECT_NEAR(response.buildings[0].displacement(0), amplitude, round_off);
  EXPECT_NEAR(response.buildings[0].displacement_no_contact(0), amplitude, round_off);
  EXPECT_NEAR(response.buildings[0].acceleration(0), 400.0 * amplitude, 400.0 * round_off);
  EXPECT_NEAR(response.buildings[0].storey_shear(0), 400.0 * amplitude, 400.0 * round_off);
  EXPECT_NEAR(response.buildings[0].drift_ratio(0), amplitude, round_off);
  EXPECT_NEAR(response.points[0].gap_needed, amplitude, round_off);
}

TEST(ClosedForm, HarmonicGroundMotionFromRest) {
  // ẍ + ω²x = A ν² sin νt from rest: x = A ν²/(ω² − ν²) (sin νt − (ν/ω) sin ωt).
  const double omega = 20.0;
  const double nu = 2.0 * pi / 0.3;
  for (const auto phase : {HarmonicMotion::Phase::sine, HarmonicMotion::Phase::cosine}) {
    Problem problem = pair(oscillator(1.0, omega * omega), wall(), {contact(50.0, 1.0)}, 3.0);
    problem.motion = HarmonicMotion{0.3, 0.5, phase};
    problem.delays = {0.123, 5.0};
    const Response response = with_histories(problem, 0.01);
    const double scale = 0.5 * nu * nu / (omega * omega - nu * nu);
    for (std::size_t i = 0; i < response.histories.time.size(); ++i) {
      const double t = response.histories.time[i] - 0.123;
      const double x = t <= 0.0 ? 0.0
                       : phase == HarmonicMotion::Phase::sine
                           ? scale * (std::sin(nu * t) - nu / omega * std::sin(omega * t))
                           : scale * (std::cos(nu * t) - std::cos(omega * t));
      ASSERT_NEAR(response.histories.displacement[0](0, static_cast<Eigen::Index>(i)), x, 20 * round_off) << t;
    }
  }
}

TEST(ClosedForm, ResonanceGrowsWithoutBound) {
  // ω = ν, where a particular solution of the harmonic kind does not exist: x = A (sin ωt − ωt cos ωt)/2.
  const double omega = 2.0 * pi / 0.3;
  Problem problem = pair(oscillator(1.0, omega * omega), wall(), {contact(500.0, 1.0)}, 3.0);
  problem.motion = HarmonicMotion{0.3, 1.0, HarmonicMotion::Phase::sine};
  const Response response = with_histories(problem, 0.05);
  for (std::size_t i = 0; i < response.histories.time.size(); ++i) {
    const double wt = omega * response.histories.time[i];
    ASSERT_NEAR(response.histories.displacement[0](0, static_cast<Eigen::Index>(i)),
                0.5 * (std::sin(wt) - wt * std::cos(wt)), 100 * round_off);
  }
}

/// ẍ + ω²x = −a(t) from rest, a linear between samples and zero outside, by superposition of steps and ramps.
double record_response(const SampledMotion& motion, double omega, double t) {
  const auto step = [&](double t0) { return t > t0 ? (1.0 - std::cos(omega * (t - t0))) / (omega * omega) : 0.0; };
  const auto ramp = [&](double t0) {
    return t > t0 ? ((t - t0) - std::sin(omega * (t - t0)) / omega) / (omega * omega) : 0.0;
  };
  const std::size_t n = motion.acceleration.size();
  double x = motion.acceleration.front() * step(0.0) -
             motion.acceleration.back() * step(static_cast<double>(n - 1) * motion.time_step);
  double slope = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const double next = k + 1 < n ? (motion.acceleration[k + 1] - motion.acceleration[k]) / motion.time_step : 0.0;
    x += (next - slope) * ramp(static_cast<double>(k) * motion.time_step);
    slope = next;
  }
  return -x;
}

TEST(ClosedForm, RecordFromRestWithAndBetweenSamples) {
  const SampledMotion motion{0.02, {1.0, -3.0, 2.5, 0.0, 4.0, -2.0, -1.0, 3.0, 0.5}};
  for (const double omega : {3.0, 40.0, 400.0}) {  // slow, about the step, much faster than the step
    for (const double delay : {0.0, 0.04, 0.0137}) {
      Problem problem = pair(oscillator(1.0, omega * omega), wall(), {contact(50.0, 1.0)}, 0.5);
      problem.motion = motion;
      problem.delays = {delay, 3.0};
      const Response response = with_histories(problem, 0.003);
      const double scale = 4.0 / std::min(omega * omega, omega * 50.0);
      for (std::size_t i = 0; i < response.histories.time.size(); ++i) {
        ASSERT_NEAR(response.histories.displacement[0](0, static_cast<Eigen::Index>(i)),
                    record_response(motion, omega, response.histories.time[i] - delay), 1e-12 * scale)
            << omega << " " << delay << " " << response.histories.time[i];
      }
    }
  }
}

TEST(ClosedForm, ImpactOfTwoFreeMasses) {
  const double m1 = 3.0, m2 = 5.0, k = 2000.0, v1 = 2.0, v2 = -1.0, width = 0.3;
  Problem problem = pair(oscillator(m1, 0.0), oscillator(m2, 0.0), {contact(width, k)}, 1.0);
  problem.initial_velocity[0](0) = v1;
  problem.initial_velocity[1](0) = v2;
  const Response response = with_histories(problem, 0.01);
  ASSERT_EQ(response.impacts.size(), 1u);
  const Impact& impact = response.impacts[0];
  const double reduced = m1 * m2 / (m1 + m2);
  EXPECT_NEAR(impact.start, width / (v1 - v2), round_off);
  EXPECT_NEAR(impact.end - impact.start, pi * std::sqrt(reduced / k), round_off);
  EXPECT_NEAR(impact.closing_speed, v1 - v2, round_off);
  EXPECT_NEAR(impact.separation_speed, v1 - v2, round_off);  // e = 1
  EXPECT_NEAR(impact.peak_force, (v1 - v2) * std::sqrt(k * reduced), 1e-12 * impact.peak_force);
  EXPECT_NEAR(impact.peak_force_time, 0.5 * (impact.start + impact.end), 1e-9);
  EXPECT_NEAR(impact.impulse, 2.0 * reduced * (v1 - v2), 1e-12 * impact.impulse);
  const Eigen::Index last = static_cast<Eigen::Index>(response.histories.time.size()) - 1;
  const double u1 = response.histories.velocity[0](0, last);
  const double u2 = response.histories.velocity[1](0, last);
  EXPECT_NEAR(m1 * u1 + m2 * u2, m1 * v1 + m2 * v2, 1e-12);                      // momentum
  EXPECT_NEAR(m1 * u1 * u1 + m2 * u2 * u2, m1 * v1 * v1 + m2 * v2 * v2, 1e-11);  // energy
}

TEST(ClosedForm, BouncingOnAWall) {
  // Undamped oscillator with speed v₀ at rest position, wall at w: free flight (π + 2φ)/ω, φ = asin(wω/v₀), between
  // contacts of length 2 atan2(v₁, d ω_c)/ω_c, v₁² = v₀² − ω²w², d = k w/(k + K), ω_c² = (k + K)/m.
  const double m = 2.0, k = 800.0, stop = 5e5, w = 0.02, v0 = 1.0;
  const double omega = std::sqrt(k / m), omega_c = std::sqrt((k + stop) / m);
  const double phi = std::asin(w * omega / v0);
  const double v1 = std::sqrt(v0 * v0 - omega * omega * w * w);
  const double d = k * w / (k + stop);
  const double touch = 2.0 * std::atan2(v1, d * omega_c) / omega_c;
  const double flight = (pi + 2.0 * phi) / omega;
  const int bounces = 400;
  Problem problem =
      pair(oscillator(m, k), wall(), {contact(w, stop)}, phi / omega + bounces * (touch + flight) - 0.5 * flight);
  problem.initial_velocity[0](0) = v0;
  const Response response = solve(problem);
  ASSERT_EQ(response.impacts.size(), static_cast<std::size_t>(bounces));
  for (int n = 0; n < bounces; ++n) {
    const Impact& impact = response.impacts[static_cast<std::size_t>(n)];
    const double start = phi / omega + n * (touch + flight);
    ASSERT_NEAR(impact.start, start, 1e-14 * (n + 10.0) * 10.0) << n;
    ASSERT_NEAR(impact.end - impact.start, touch, 1e-12) << n;
    ASSERT_NEAR(impact.closing_speed, v1, 1e-11) << n;
    ASSERT_NEAR(impact.peak_penetration, std::hypot(d, v1 / omega_c) - d, 1e-13) << n;
  }
}

TEST(ClosedForm, ContactThatIsCriticallyDampedIsDefective) {
  // Two equal oscillators pushed together: their difference y obeys ÿ + 2σẏ + (ω² + 2k/m) y = 0 in contact. With
  // σ² = ω² + 2k/m the state matrix has a double eigenvalue and one eigenvector; y = (y₀ + (ẏ₀ + σy₀)t) e^{−σt}.
  const double m = 1.0, k = 150.0, omega = 10.0;
  const double sigma = std::sqrt(omega * omega + 2.0 * k / m);
  for (const double off : {0.0, 1e-9, -1e-9}) {
    const double zeta = sigma / omega + off;
    Problem problem =
        pair(oscillator(m, omega * omega * m, zeta), oscillator(m, omega * omega * m, zeta), {contact(0.0, k)}, 0.4);
    problem.initial_displacement[0](0) = 0.02;
    problem.initial_displacement[1](0) = -0.01;
    const Response response = with_histories(problem, 0.01);
    ASSERT_EQ(response.points[0].impacts, 1);
    EXPECT_TRUE(response.impacts[0].open_ended);
    EXPECT_EQ(response.impacts[0].start, 0.0);
    for (std::size_t i = 0; i < response.histories.time.size(); ++i) {
      const double t = response.histories.time[i];
      // The nearly critical case differs from the critical one by about off · t · y.
      ASSERT_NEAR(response.histories.opening(0, static_cast<Eigen::Index>(i)),
                  -0.03 * (1.0 + sigma * t) * std::exp(-sigma * t), round_off + 10.0 * std::abs(off));
    }
  }
}

TEST(ClosedForm, FullDampingMatrixIsSolvedWithoutModes) {
  // C = c [[1, −1], [−1, 1]] + c₀ K couples the modes of unequal masses; checked against a fine Taylor-free
  // reference, the energy balance: d/dt (½vᵀMv + ½xᵀKx) = −vᵀCv, integrated by Simpson's rule over the histories.
  Eigen::MatrixXd mass(2, 2), stiffness(2, 2), c(2, 2);
  mass << 2.0, 0.0, 0.0, 1.0;
  stiffness << 900.0, -400.0, -400.0, 400.0;
  c << 8.0, -3.0, -3.0, 4.0;
  Problem problem = pair(matrix_building(mass, stiffness, c), wall(), {contact(10.0, 1.0)}, 1.0);
  problem.initial_velocity[0] << 1.0, -0.5;
  const double step = 1e-3;
  const Response response = with_histories(problem, step);
  const auto& x = response.histories.displacement[0];
  const auto& v = response.histories.velocity[0];
  const auto energy = [&](Eigen::Index i) -> double {
    return 0.5 * v.col(i).dot(mass * v.col(i)) + 0.5 * x.col(i).dot(stiffness * x.col(i));
  };
  const auto power = [&](Eigen::Index i) -> double { return v.col(i).dot(c * v.col(i)); };
  double lost = 0.0;
  for (Eigen::Index i = 0; i + 2 < v.cols(); i += 2)
    lost += step / 3.0 * (power(i) + 4.0 * power(i + 1) + power(i + 2));
  EXPECT_NEAR(energy(0) - energy(v.cols() - 1), lost, 1e-8);  // Simpson's own error
  EXPECT_GT(lost, 0.5 * energy(0));
}

/// Where f changes its sign in [low, high], to the last bit.
template <class Function>
double sign_change(const Function& f, double low, double high) {
  const bool positive = f(low) > 0;
  for (double middle = 0.5 * (low + high); middle > low && middle < high; middle = 0.5 * (low + high)) {
    ((f(middle) > 0) == positive ? low : high) = middle;
  }
  return high;
}

// A mass pushed on by a steady a against a wall that it dents; the dent comes back as e^{−kt/c}, faster than anything
// moves and ten thousand times over within one step of the motion, and is met again before it is gone:
//   in contact δ̈ + 2ξω δ̇ + ω² δ = a until F = m(ω² δ + 2ξω δ̇) = 0, then δ = δ₁ + δ̇₁τ + aτ²/2 = δ₁ e^{−kτ/c}.
TEST(ClosedForm, ADentedSurfaceIsMetWhereItHasCreptBackTo) {
  const double a = 10, omega = 100, zeta = 0.1, v = 0.17, m = 3;
  const double start = v / a, rate = omega / (2 * zeta), damped = omega * std::sqrt(1 - zeta * zeta);
  const double c = -a / (omega * omega), s = (v + zeta * omega * c) / damped;
  const auto depth = [&](double t) {
    return a / (omega * omega) + std::exp(-zeta * omega * t) * (c * std::cos(damped * t) + s * std::sin(damped * t));
  };
  const auto speed = [&](double t) {
    return std::exp(-zeta * omega * t) * ((damped * s - zeta * omega * c) * std::cos(damped * t) -
                                          (damped * c + zeta * omega * s) * std::sin(damped * t));
  };
  const double length = sign_change([&](double t) { return omega * omega * depth(t) + 2 * zeta * omega * speed(t); },
                                    pi / damped, 2 * pi / damped);
  const double left = depth(length), parting = speed(length);
  const double away = sign_change(
      [&](double t) { return left * (1 - std::exp(-rate * t)) + parting * t + 0.5 * a * t * t; }, -parting / a, 1.0);
  ASSERT_GT(left * std::exp(-rate * away), 1e-10) << "something is left of the dent";

  for (const Solver& solver : {Solver(ExactSolver{}), Solver(AdaptiveSolver{1e-12})}) {
    // Not a wall, whose own frequency would keep steps short.
    Problem problem = pair(oscillator(m, 0), oscillator(1e15 * m, 0), {contact(v * v / (2 * a), 1)}, 0.45);
    problem.points[0].law = std::make_shared<KelvinVoigt>(m * omega * omega, zeta, m, KelvinVoigt::Release::creep);
    problem.motion = SampledMotion{0.5, std::vector<double>(3, -a)};
    problem.delays = {0, 5};
    const Response response = solve(problem, solver);
    ASSERT_EQ(response.status, Status::done);
    ASSERT_GE(response.impacts.size(), 2U);
    const double tolerance = std::holds_alternative<ExactSolver>(solver) ? 1e-12 : 1e-10;
    EXPECT_NEAR(response.impacts[0].start, start, tolerance);
    EXPECT_NEAR(response.impacts[0].end, start + length, tolerance);
    EXPECT_NEAR(response.impacts[1].start, start + length + away, tolerance) << name(solver);
    EXPECT_NEAR(response.impacts[1].closing_speed, parting + a * away, 1e2 * tolerance);
  }
}

}  // namespace
}  // namespace bentur
