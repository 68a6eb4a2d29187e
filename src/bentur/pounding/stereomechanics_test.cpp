// Impacts that take no time: several at once, ever faster ones, and contact that rests.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <random>

#include "bentur/contact/laws/restitution.h"
#include "bentur/pounding/pounding.h"
#include "tests/support/free_masses.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace bentur::test;

std::shared_ptr<const ContactLaw> law(double e) { return std::make_shared<Restitution>(e); }

struct Way {
  const char* label;
  Solver solver;
  double accuracy;
};

void PrintTo(const Way& way, std::ostream* out) { *out << way.label; }

class Stereomechanics : public testing::TestWithParam<Way> {
 protected:
  [[nodiscard]] Response run(const Problem& problem, double output_step = 0) const {
    SolveOptions options;
    options.output_step = output_step;
    options.energy_audit = true;
    Response response = solve(problem, GetParam().solver, options);
    EXPECT_EQ(response.status, Status::done) << response.message;
    EXPECT_LE(response.energy->relative_residual(), accuracy_);
    return response;
  }
  const double accuracy_ = GetParam().accuracy;
};

INSTANTIATE_TEST_SUITE_P(, Stereomechanics,
                         testing::Values(Way{"exact", ExactSolver{}, 1e-12}, Way{"adaptive", AdaptiveSolver{}, 1e-8},
                                         Way{"runge_kutta", RungeKuttaSolver{1e-3}, 1e-8}),
                         [](const auto& one) { return one.param.label; });

constexpr double mass = 3, push = 2, gap = 0.04;  // a free mass reaches the wall after 0.2 s, at 0.4

/// A mass on a spring (none: free) that the ground pushes towards a wall with the acceleration `push` until
/// `end_of_push`, and then, from one sample to the next, away from it.
Problem pushed_to_a_wall(double stiffness, double zeta, double e, double end_of_push, double time) {
  Problem problem = pair(oscillator(mass, stiffness, zeta), wall(), {contact(gap, law(e))}, time);
  SampledMotion motion{0.02, {}};
  for (int i = 0; 0.02 * i < time + 0.1; ++i)
    motion.acceleration.push_back(0.02 * i < end_of_push + 1e-9 ? -push : push);
  problem.motion = motion;
  problem.delays = {0, 1e3};
  return problem;
}

/// Depth that is taken for zero: 2⁻⁴⁶ of the gap and the displacement without contact. A bounce begins and ends that
/// deep, so its closing speed is larger by band·push/speed; and it is dated early by so much as it takes to fall out of
/// the band, or where it does not rise above it by the whole bounce.
double band(double duration) { return 0x1p-46 * (gap + 0.5 * push * duration * duration); }
double dating(double duration, double speed) {
  const double rise = 0.5 * speed * speed / push;
  return 4 * band(duration) / speed + (rise < band(duration) ? 2 * speed / push : 0);
}

/// Impacts until it does not bounce any more: slower than 2⁻²⁰ of the fastest speed.
std::size_t bounces_of(double e) { return static_cast<std::size_t>(std::ceil(20 * std::log(2) / -std::log(e))); }

constexpr double sample = 0.02, until = 1.6, duration = 2.0;

TEST_P(Stereomechanics, BouncesEverFasterAndComesToRest) {
  const double first = std::sqrt(2 * gap / push), speed = push * first;
  for (const double e : {0.2, 0.65}) {
    const Response response = run(pushed_to_a_wall(0, 0, e, until, duration), 0.01);
    const std::size_t bounces = bounces_of(e);
    ASSERT_GT(response.impacts.size(), bounces) << e;
    double time = first, closing = speed;
    for (std::size_t n = 0; n < bounces; ++n) {
      const Impact& impact = response.impacts[n];
      const double slack = 10 * accuracy_ + dating(duration, closing);
      EXPECT_NEAR(impact.start, time, slack) << n;
      EXPECT_EQ(impact.start, impact.end);
      EXPECT_NEAR(impact.closing_speed, closing, slack * push) << n;
      EXPECT_NEAR(*impact.restitution(), e, 1e-12) << n;
      EXPECT_NEAR(impact.impulse, mass * (1 + e) * impact.closing_speed, 1e-12 * impact.impulse) << n;
      const double energy = 0.5 * mass * impact.closing_speed * impact.closing_speed;
      EXPECT_NEAR(impact.energy_lost, energy * (1 - e * e), 1e-12 * energy);
      EXPECT_EQ(impact.peak_force, 0);
      time += 2 * e * closing / push;
      closing *= e;
    }
    const Impact& rest = response.impacts[bounces];
    EXPECT_NEAR(rest.start, time, 10 * accuracy_ + dating(duration, closing));
    EXPECT_NEAR(rest.start, first * (1 + e) / (1 - e), 1e-6);  // where all bounces would end: less than 2⁻²⁰ later
    EXPECT_FALSE(rest.open_ended);
    EXPECT_NEAR(rest.end, until + sample / 2, 10 * accuracy_);  // where the push becomes a pull
    EXPECT_NEAR(rest.peak_force / (mass * push), 1, accuracy_);
    EXPECT_NEAR(rest.separation_speed, 0, accuracy_ * speed);
    const double impulse = mass * closing + mass * push * (until - time + sample / 4);
    EXPECT_NEAR(rest.impulse / impulse, 1, 10 * accuracy_ + 1e-12);
    double lost = 0;
    for (const Impact& impact : response.impacts) lost += impact.energy_lost;
    EXPECT_NEAR(lost / (0.5 * mass * speed * speed), 1, 10 * accuracy_ + dating(duration, speed));
    int resting = 0;
    for (std::size_t i = 0; i < response.histories.time.size(); ++i) {
      const double t = response.histories.time[i];
      const double force = response.histories.force(0, static_cast<Index>(i));
      const double opening = response.histories.opening(0, static_cast<Index>(i));
      EXPECT_GE(opening, -10 * accuracy_ * gap);
      if (t > rest.start && t < until) {
        ++resting;
        EXPECT_NEAR(force / (mass * push), 1, accuracy_) << t;
        EXPECT_NEAR(opening, 0, 10 * accuracy_ * gap) << t;
      } else if (t > rest.end + accuracy_ || t < rest.start) {
        EXPECT_EQ(force, 0) << t;
      }
    }
    EXPECT_GT(resting, 60);
    const double last = -push * (duration - until - sample) - 0.5 * push * sample / 2;  // pull from rest.end on
    EXPECT_NEAR(last_velocity(response, 0), last, 10 * accuracy_ * speed);
  }
}

TEST_P(Stereomechanics, LettingGoIsNoImpact) {
  for (const double e : {0.2, 0.65}) {
    EXPECT_EQ(run(pushed_to_a_wall(0, 0, e, until, duration)).impacts.size(), bounces_of(e) + 1) << e;
  }
}

TEST_P(Stereomechanics, WithoutLossItBouncesForEver) {
  const double first = std::sqrt(2 * gap / push), speed = push * first;
  const int bounces = 20;
  const double time = first * 2 * bounces;
  const Response response = run(pushed_to_a_wall(0, 0, 1, 1e3, time));
  ASSERT_EQ(response.impacts.size(), static_cast<std::size_t>(bounces));
  for (int n = 0; n < bounces; ++n) {
    const Impact& impact = response.impacts[static_cast<std::size_t>(n)];
    EXPECT_NEAR(impact.start, first * (1 + 2 * n), (n + 1) * (accuracy_ + dating(time, speed))) << n;
    EXPECT_NEAR(impact.closing_speed / speed, 1, (n + 1) * accuracy_ + push / speed * dating(time, speed)) << n;
    EXPECT_NEAR(impact.energy_lost, 0, 1e-14);
  }
}

TEST_P(Stereomechanics, RestsUnderTheForceThatHoldsIt) {
  // Held at the wall the spring takes k w of the push; it lets go where m a(t) = k w, and swings from there.
  const double stiffness = 60, end_of_push = 4;
  const Response response = run(pushed_to_a_wall(stiffness, 0.05, 0.65, end_of_push, 4.5), 0.01);
  ASSERT_LE(response.impacts.size(), 60u);
  const Impact& rest = *std::max_element(response.impacts.begin(), response.impacts.end(),
                                         [](const Impact& a, const Impact& b) { return a.impulse < b.impulse; });
  EXPECT_LT(rest.start, 3);
  EXPECT_FALSE(rest.open_ended);
  EXPECT_NEAR(rest.peak_force, mass * push - stiffness * gap, 10 * accuracy_);
  const double left = stiffness * gap / (mass * push);  // a/push when it lets go; a falls to −push in one sample
  EXPECT_NEAR(rest.end, end_of_push + sample * (1 - left) / 2, 10 * accuracy_);
  EXPECT_GT(response.histories.opening.rightCols(1)(0), 0.1 * gap);
}

TEST_P(Stereomechanics, AllFloorsComeToRest) {
  MatrixXd stiffness(3, 3), masses = 2 * MatrixXd::Identity(3, 3);
  stiffness << 200, -100, 0, -100, 200, -100, 0, -100, 100;
  VectorXd widths(3);
  widths << 0.02, 0.035, 0.04;
  const MatrixXd rigid = MatrixXd::Identity(3, 3);
  Problem problem = pair(matrix_building(masses, stiffness, 0.01 * stiffness),
                         matrix_building(1e15 * rigid, 1e20 * rigid, 0 * rigid), {}, 8);
  for (int f = 0; f < 3; ++f) {
    problem.points.push_back(contact(widths(f), law(0.5)));
    problem.points.back().left_floor = problem.points.back().right_floor = f;
  }
  problem.motion = SampledMotion{0.02, std::vector<double>(1000, -push)};
  problem.delays = {0, 1e3};
  const Response response = run(problem, 0.01);
  EXPECT_LT(response.impacts.size(), 600u);
  const VectorXd held = masses.rowwise().sum() * push - stiffness * widths;
  ASSERT_GT(held.minCoeff(), 0.1);
  int open_ended = 0;
  for (const Impact& impact : response.impacts) open_ended += impact.open_ended ? 1 : 0;
  EXPECT_EQ(open_ended, 3);
  // The three forces of the rest of the run, and the floors that do not move.
  for (Index i = 790; i <= 800; ++i) {
    EXPECT_LE((response.histories.force.col(i) - held).norm(), 100 * accuracy_ * held.norm());
    EXPECT_LE((response.histories.displacement[0].col(i) - widths).norm(), 100 * accuracy_ * widths.norm());
  }
}

MatrixXd random_mass(std::mt19937_64& random, Index size) {
  std::normal_distribution<double> normal;
  MatrixXd root(size, size);
  for (double& x : root.reshaped()) x = normal(random);
  return root * root.transpose() + 0.3 * MatrixXd::Identity(size, size);
}

TEST_P(Stereomechanics, SeveralFloorsAtOneInstant) {
  // Free buildings with full mass matrices; each gap so wide that its floors meet at 0.25 s.
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(0.1, 1);
  const double when = 0.25;
  int not_pushed = 0;
  for (int n = 0; n < 50; ++n) {
    const Index floors = 2 + n % 3;
    const MatrixXd left = random_mass(random, floors), right = random_mass(random, floors);
    Problem problem = pair(free_building(left), free_building(right), {}, 0.5);
    const double e = unit(random);
    VectorXd closing(floors);
    for (Index f = 0; f < floors; ++f) {
      problem.initial_velocity[0](f) = unit(random);
      problem.initial_velocity[1](f) = -unit(random);
      closing(f) = problem.initial_velocity[0](f) - problem.initial_velocity[1](f);
      problem.points.push_back(contact(closing(f) * when, law(e)));
      problem.points.back().left_floor = problem.points.back().right_floor = static_cast<int>(f);
    }
    const Response response = run(problem, 0.5);
    const VectorXd left_after = response.histories.velocity[0].col(1),
                   right_after = response.histories.velocity[1].col(1);
    VectorXd impulse = VectorXd::Zero(floors);
    double lost = 0;
    for (const Impact& impact : response.impacts) {
      EXPECT_NEAR(impact.start, when, 1e-12);
      EXPECT_EQ(impulse(impact.point), 0) << "two impacts of one point";
      EXPECT_GT(impact.impulse, 0);
      impulse(impact.point) = impact.impulse;
      lost += impact.energy_lost;
    }
    // Momentum of every floor.
    EXPECT_LE((left * (left_after - problem.initial_velocity[0]) + impulse).norm(), 1e-11) << n;
    EXPECT_LE((right * (right_after - problem.initial_velocity[1]) - impulse).norm(), 1e-11) << n;
    // Each is pushed and rebounds as asked, or is not pushed and opens faster than that.
    for (Index f = 0; f < floors; ++f) {
      const double opening = right_after(f) - left_after(f);
      if (impulse(f) > 0) {
        EXPECT_NEAR(opening, e * closing(f), 1e-12) << n;
      } else {
        EXPECT_GT(opening, e * closing(f)) << n;
        ++not_pushed;
      }
    }
    const auto energy = [&](const VectorXd& l, const VectorXd& r) -> double {
      return 0.5 * l.dot(left * l) + 0.5 * r.dot(right * r);
    };
    const double before = energy(problem.initial_velocity[0], problem.initial_velocity[1]);
    EXPECT_NEAR(energy(left_after, right_after) + lost, before, 1e-11 * before) << n;
    EXPECT_GE(lost, -1e-12 * before) << n;
  }
  EXPECT_GT(not_pushed, 0);
}

/// Equal free masses in a row.
Problem row(const std::vector<double>& speeds, const std::vector<double>& widths, double e, double time = 1) {
  Problem problem;
  problem.duration = time;
  for (const double speed : speeds) {
    problem.buildings.push_back(oscillator(mass, 0));
    problem.delays.push_back(0);
    problem.initial_displacement.emplace_back(VectorXd::Zero(1));
    problem.initial_velocity.emplace_back(VectorXd::Constant(1, speed));
  }
  for (std::size_t i = 0; i < widths.size(); ++i) {
    problem.points.push_back(contact(widths[i], law(e), static_cast<int>(i)));
  }
  return problem;
}

TEST_P(Stereomechanics, ThreeInARowPassTheBlowOn) {
  for (const double e : {0.2, 0.65, 1.0}) {
    const Response response = run(row({1, 0, 0}, {0.1, 0.1}, e, 0.3), 0.3);
    ASSERT_EQ(response.impacts.size(), 2u);
    const double passed = (1 + e) / 2;
    EXPECT_NEAR(response.impacts[1].start, 0.1 + 0.1 / passed, 1e-12);
    EXPECT_NEAR(last_velocity(response, 0), (1 - e) / 2, 1e-12);
    EXPECT_NEAR(last_velocity(response, 1), passed * (1 - e) / 2, 1e-12);
    EXPECT_NEAR(last_velocity(response, 2), passed * passed, 1e-12);
  }
}

TEST_P(Stereomechanics, TheMiddleOneHitFromBothSides) {
  for (const double e : {0.2, 0.65, 1.0}) {
    const Response response = run(row({1, 0, -1}, {0.1, 0.1}, e), 1);
    ASSERT_EQ(response.impacts.size(), 2u);
    for (const Impact& impact : response.impacts) {
      EXPECT_NEAR(impact.start, 0.1, 1e-13);
      EXPECT_NEAR(*impact.restitution(), e, 1e-12);
      EXPECT_NEAR(impact.impulse, mass * (1 + e), 1e-12);
      EXPECT_NEAR(impact.energy_lost, 0.5 * mass * (1 - e * e), 1e-12);
    }
    EXPECT_NEAR(last_velocity(response, 0), -e, 1e-12);
    EXPECT_NEAR(last_velocity(response, 1), 0, 1e-12);
    EXPECT_NEAR(last_velocity(response, 2), e, 1e-12);
  }
}

TEST_P(Stereomechanics, ThoseThatTouchTakeABlowTogether) {
  // Newton's rule at both points at once: the second, at rest before, is at rest after; so two masses are hit as one.
  for (const double e : {0.2, 0.65, 1.0}) {
    const Response response = run(row({1, 0, 0}, {0.1, 0.0}, e), 1);
    const double together = (1 + e) / 3;
    EXPECT_NEAR(last_velocity(response, 0), 1 - 2 * together, 1e-12);
    EXPECT_NEAR(last_velocity(response, 1), together, 1e-12);
    EXPECT_NEAR(last_velocity(response, 2), together, 1e-12);
    EXPECT_LE(response.impacts.size(), 3u);
  }
}

TEST_P(Stereomechanics, TouchingBuildingsThatMoveAlikeNeverCollide) {
  const MatrixXd masses = MatrixXd::Identity(2, 2);
  MatrixXd stiffness(2, 2);
  stiffness << 800, -400, -400, 400;
  const Building building = matrix_building(masses, stiffness, 0.002 * stiffness);
  Problem problem = pair(building, building, {contact(0.0, law(0.65)), contact(0.0, law(0.65))}, 2);
  problem.points[1].left_floor = problem.points[1].right_floor = 1;
  SampledMotion motion{0.02, {}};
  for (int i = 0; i < 90; ++i) motion.acceleration.push_back(3 * std::sin(0.31 * i) + 2 * std::sin(0.13 * i * i));
  problem.motion = motion;
  EXPECT_TRUE(run(problem).impacts.empty());
  problem.delays = {0, 0.1};
  const Response response = run(problem);
  EXPECT_FALSE(response.impacts.empty());
  EXPECT_LT(response.impacts.size(), 1000u);
  for (const Impact& impact : response.impacts) EXPECT_GE(impact.energy_lost, -1e-15);
}

TEST_P(Stereomechanics, BuildingsThatAreShakenTogetherAndApart) {
  // Chatter, rest and letting go many times, from all sorts of motion: it always ends, after a bounded number of
  // impacts. From a rest of so low a restitution some ten bounces follow each other.
  SampledMotion motion{0.02, {}};
  for (int i = 0; i < 90; ++i) motion.acceleration.push_back(3 * std::sin(0.31 * i) + 2 * std::sin(0.13 * i * i));
  MatrixXd pattern(2, 2);
  pattern << 2, -1, -1, 1;
  const double heavy = 2e5;
  for (const bool tall : {false, true}) {
    const auto building = [&](double k) {
      return tall ? matrix_building(heavy * MatrixXd::Identity(2, 2), k * pattern, 0.003 * k * pattern)
                  : oscillator(heavy, k, 0.04);
    };
    for (const double e : {0.3, 0.65}) {
      for (const double delay : {0.0, 0.03, 0.05}) {
        for (const double width : {0.0, 0.003, 0.006}) {
          Problem problem = pair(building(1.5e8), building(0.5e8), {contact(width, law(e))}, 3);
          problem.motion = motion;
          problem.delays = {0, delay};
          SolveOptions options;
          options.energy_audit = true;
          const Response response = solve(problem, GetParam().solver, options);
          EXPECT_EQ(response.status, Status::done) << response.message << (tall ? ", two floors" : ", one floor")
                                                   << ", e " << e << " delay " << delay << " width " << width;
          EXPECT_LT(response.impacts.size(), 200u);
          EXPECT_LE(response.energy->relative_residual(), 1e-7);
        }
      }
    }
  }
}

}  // namespace
}  // namespace bentur
