// What every solver owes, whatever its way of stepping. A new solver adds its entry to solvers() and passes all of
// this.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <ostream>
#include <string>
#include <tuple>

#include "bentur/core/errors.h"
#include "bentur/pounding/pounding.h"
#include "tests/support/free_masses.h"
#include "tests/support/same_response.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using std::numbers::pi;
using namespace bentur::test;

struct Entry {
  std::string label;
  Solver solver;
  double accuracy = 0;  ///< of states and impacts relative to their size, in these problems of some hundred steps
};

void PrintTo(const Entry& entry, std::ostream* out) { *out << entry.label; }

std::vector<Entry> solvers() {
  return {{"exact", ExactSolver{}, 2e-13},
          // The local error of each step is below 1e-9.
          {"adaptive", AdaptiveSolver{1e-9}, 3e-9},
          // ω h = 0.02: an error of (ω h)⁴/120 a radian, of which free vibration has 40.
          {"runge_kutta", RungeKuttaSolver{1e-3}, 1e-7}};
}

class EverySolver : public testing::TestWithParam<Entry> {
 protected:
  [[nodiscard]] Response run(const Problem& problem, double output_step = 0) const {
    SolveOptions options;
    options.output_step = output_step;
    return solve(problem, GetParam().solver, options);
  }
  const double accuracy_ = GetParam().accuracy;
};

/// Two sticks of two floors with a record, contacts at both floors, and damping.
Problem sticks(double width = 0.004) {
  MatrixXd mass = MatrixXd::Identity(2, 2), stiffness(2, 2);
  stiffness << 800, -400, -400, 400;
  MatrixXd heavy = 1.7 * mass;
  Problem problem = pair(matrix_building(mass, stiffness, 0.002 * stiffness),
                         matrix_building(heavy, 0.8 * stiffness, 0.003 * stiffness),
                         {contact(width, 2e4, 0), contact(width, 3e4, 1)}, 2.0);
  SampledMotion motion{0.02, {}};
  for (int i = 0; i < 90; ++i) motion.acceleration.push_back(3 * std::sin(0.31 * i) + 2 * std::sin(0.13 * i * i));
  problem.motion = motion;
  problem.delays = {0, 0.05};
  return problem;
}

TEST_P(EverySolver, FreeVibration) {
  const double omega = 20, zeta = 0.05, x0 = 0.3, v0 = -2;
  Problem problem = pair(oscillator(2, 2 * omega * omega, zeta), wall(), {contact(10, 1e3)}, 2);
  problem.initial_displacement[0](0) = x0;
  problem.initial_velocity[0](0) = v0;
  const Response response = run(problem, 0.01);
  ASSERT_EQ(response.histories.time.size(), 201u);
  const double damped = omega * std::sqrt(1 - zeta * zeta);
  for (std::size_t i = 0; i < 201; ++i) {
    const double t = response.histories.time[i];
    const double x = std::exp(-zeta * omega * t) *
                     (x0 * std::cos(damped * t) + (v0 + zeta * omega * x0) / damped * std::sin(damped * t));
    ASSERT_NEAR(response.histories.displacement[0](0, static_cast<Index>(i)), x, accuracy_) << t;
  }
  EXPECT_TRUE(response.impacts.empty());
}

// At the critical ratio, and beyond it as stiffness-proportional damping makes fast modes, nothing swings.
TEST_P(EverySolver, CriticalDampingAndBeyond) {
  const double omega = 20, x0 = 0.3, v0 = -2;
  for (const double zeta : {1.0, 1.5}) {
    Problem problem = pair(oscillator(2, 2 * omega * omega, zeta), wall(), {contact(10, 1e3)}, 2);
    problem.initial_displacement[0](0) = x0;
    problem.initial_velocity[0](0) = v0;
    const Response response = run(problem, 0.01);
    ASSERT_EQ(response.histories.time.size(), 201u);
    const double slow = omega * (zeta - std::sqrt(zeta * zeta - 1)), fast = omega * (zeta + std::sqrt(zeta * zeta - 1));
    for (std::size_t i = 0; i < 201; ++i) {
      const double t = response.histories.time[i];
      const double x =
          zeta == 1 ? (x0 + (v0 + omega * x0) * t) * std::exp(-omega * t)
                    : ((v0 + fast * x0) * std::exp(-slow * t) - (v0 + slow * x0) * std::exp(-fast * t)) / (fast - slow);
      ASSERT_NEAR(response.histories.displacement[0](0, static_cast<Index>(i)), x, accuracy_) << zeta << " " << t;
    }
  }
}

TEST_P(EverySolver, FreeImpactOnASpring) {
  const double m1 = 3, m2 = 5, k = 2000, v0 = 3, width = 0.3;
  const double effective = m1 * m2 / (m1 + m2);
  const Response response = run(free_masses(m1, m2, width, v0, std::make_shared<Linear>(k), 0.5), 0.5);
  ASSERT_EQ(response.status, Status::done);
  ASSERT_EQ(response.impacts.size(), 1u);
  const Impact& impact = response.impacts[0];
  const double duration = pi * std::sqrt(effective / k), peak = v0 * std::sqrt(k * effective);
  EXPECT_NEAR(impact.start, width / v0, 1e-13);  // a straight line for every solver
  EXPECT_NEAR((impact.end - impact.start) / duration, 1, accuracy_);
  EXPECT_NEAR(impact.peak_force / peak, 1, accuracy_);
  EXPECT_NEAR(impact.peak_penetration / (peak / k), 1, accuracy_);
  EXPECT_NEAR((impact.peak_force_time - impact.start) / duration, 0.5, std::sqrt(accuracy_));  // a flat top
  EXPECT_NEAR(impact.impulse / (2 * effective * v0), 1, accuracy_);
  EXPECT_NEAR(*impact.restitution(), 1, accuracy_);
  EXPECT_NEAR(m1 * last_velocity(response, 0) + m2 * last_velocity(response, 1), m1 * v0, 1e-12 * m1 * v0);
  EXPECT_NEAR(last_velocity(response, 0) / v0, (m1 - m2) / (m1 + m2), accuracy_);
}

TEST_P(EverySolver, NoImpactInAGapThatIsWideEnough) {
  const double needed = run(sticks(1)).points[1].gap_needed;
  ASSERT_GT(needed, 0.01);
  const Response wide = run(sticks(needed * (1 + 2 * accuracy_)));
  EXPECT_TRUE(wide.impacts.empty());
  EXPECT_EQ(wide.points[1].peak_force, 0);
  EXPECT_FALSE(wide.points[1].peak_force_time);
  for (std::size_t b = 0; b < 2; ++b) {
    const auto& peaks = wide.buildings[b];
    EXPECT_LE((peaks.displacement - peaks.displacement_no_contact).norm(), accuracy_ * peaks.displacement.norm());
  }
  // A step of fixed length sees a contact where it ends in one: not the short ones.
  EXPECT_EQ(run(sticks(needed * 0.95)).impacts.empty(), false);
}

TEST_P(EverySolver, StopsWhenAsked) {
  SolveOptions options;
  int calls = 0;
  options.progress = [&](double done) {
    EXPECT_GE(done, 0);
    EXPECT_LE(done, 1);
    return ++calls < 2;
  };
  const Response response = solve(sticks(), GetParam().solver, options);
  EXPECT_EQ(response.status, Status::stopped);
  EXPECT_EQ(calls, 2);
  EXPECT_FALSE(response.message.empty());
}

TEST_P(EverySolver, HistoriesAreTheResponseAtTheirTimes) {
  const double step = 1e-3;
  const Problem problem = sticks();
  const Response response = run(problem, step);
  const Histories& histories = response.histories;
  ASSERT_EQ(histories.time.size(), 2001u);
  ASSERT_EQ(histories.opening.cols(), 2001);
  for (std::size_t i = 0; i < histories.time.size(); ++i) {
    const auto at = static_cast<Index>(i);
    ASSERT_DOUBLE_EQ(histories.time[i], static_cast<double>(i) * step);
    ASSERT_DOUBLE_EQ(histories.ground_acceleration[i], acceleration_at(problem.motion, histories.time[i]));
    for (Index p = 0; p < 2; ++p) {
      const double opening =
          problem.points[0].width + histories.displacement[1](p, at) - histories.displacement[0](p, at);
      ASSERT_NEAR(histories.opening(p, at), opening, 1e-15);
      const double k = p == 0 ? 2e4 : 3e4;
      ASSERT_NEAR(histories.force(p, at), std::max(0.0, -k * opening), k * 1e-15);
    }
  }
  // Samples come near the peaks from below: by ½ |f''| (step/2)².
  for (std::size_t b = 0; b < 2; ++b) {
    for (Index f = 0; f < 2; ++f) {
      const auto& peaks = response.buildings[b];
      const double x = histories.displacement[b].row(f).cwiseAbs().maxCoeff();
      const double largest = 2 * peaks.acceleration.maxCoeff();  // of ẍ, with that of the ground
      EXPECT_LE(x, peaks.displacement(f) * (1 + 1e-14));
      EXPECT_GE(x, peaks.displacement(f) - largest * step * step / 8);
      const double a = histories.acceleration[b].row(f).cwiseAbs().maxCoeff();
      EXPECT_LE(a, peaks.acceleration(f) * (1 + 1e-12));
      EXPECT_GE(a, 0.97 * peaks.acceleration(f));  // contacts last some 20 steps
    }
  }
  for (Index p = 0; p < 2; ++p) {
    const auto& point = response.points[static_cast<std::size_t>(p)];
    EXPECT_LE(histories.force.row(p).maxCoeff(), point.peak_force * (1 + 1e-12));
    EXPECT_GE(histories.force.row(p).maxCoeff(), 0.97 * point.peak_force);
  }
}

TEST_P(EverySolver, AMirroredRowRespondsAsItsImage) {
  const Problem problem = sticks();
  Problem mirrored = problem;
  std::swap(mirrored.buildings[0], mirrored.buildings[1]);
  std::swap(mirrored.delays[0], mirrored.delays[1]);
  for (double& a : std::get<SampledMotion>(mirrored.motion).acceleration) a = -a;
  const Response one = run(problem), other = run(mirrored);
  ASSERT_GT(one.impacts.size(), 5u);
  ASSERT_EQ(one.impacts.size(), other.impacts.size());
  for (std::size_t i = 0; i < one.impacts.size(); ++i) {
    // The same steps: round-off, which a row of impacts makes some hundred times larger.
    EXPECT_NEAR(one.impacts[i].start, other.impacts[i].start, 1e-11);
    EXPECT_NEAR(one.impacts[i].end, other.impacts[i].end, 1e-11);
    EXPECT_NEAR(one.impacts[i].peak_force / other.impacts[i].peak_force, 1, 1e-9);
  }
  EXPECT_NEAR(one.buildings[0].displacement(1) / other.buildings[1].displacement(1), 1, 1e-11);
}

TEST_P(EverySolver, TheListOfImpactsIsComplete) {
  const Problem problem = sticks();
  const Response response = run(problem);
  ASSERT_GT(response.impacts.size(), 5u);
  std::vector<double> last_end(problem.points.size(), -1);
  std::vector<PointSummary> sums(problem.points.size());
  for (std::size_t i = 0; i < response.impacts.size(); ++i) {
    const Impact& impact = response.impacts[i];
    const auto p = static_cast<std::size_t>(impact.point);
    ASSERT_LT(p, problem.points.size());
    EXPECT_GE(impact.start, i > 0 ? response.impacts[i - 1].start : 0);
    EXPECT_GE(impact.start, last_end[p]);
    EXPECT_LT(impact.start, impact.end);
    EXPECT_LE(impact.end, problem.duration);
    EXPECT_GT(impact.closing_speed, 0);
    EXPECT_EQ(impact.open_ended, impact.separation_speed == 0);
    EXPECT_GT(impact.peak_penetration, 0);
    EXPECT_GT(impact.peak_force, 0);
    EXPECT_GT(impact.peak_force_time, impact.start);
    EXPECT_LT(impact.peak_force_time, impact.end);
    EXPECT_GT(impact.impulse, 0);
    EXPECT_LT(impact.impulse, impact.peak_force * (impact.end - impact.start));
    EXPECT_EQ(impact.peak_tension, 0);
    EXPECT_NEAR(impact.energy_lost, 0, 1e-12 * impact.peak_force * impact.peak_penetration);  // a spring
    last_end[p] = impact.end;
    ++sums[p].impacts;
    sums[p].contact_duration += impact.end - impact.start;
    sums[p].impulse += impact.impulse;
    sums[p].peak_force = std::max(sums[p].peak_force, impact.peak_force);
    sums[p].peak_closing_speed = std::max(sums[p].peak_closing_speed, impact.closing_speed);
    sums[p].peak_penetration = std::max(sums[p].peak_penetration, impact.peak_penetration);
  }
  for (std::size_t p = 0; p < sums.size(); ++p) {
    const PointSummary& point = response.points[p];
    EXPECT_EQ(point.impacts, sums[p].impacts);
    EXPECT_DOUBLE_EQ(point.contact_duration, sums[p].contact_duration);
    EXPECT_DOUBLE_EQ(point.impulse, sums[p].impulse);
    EXPECT_EQ(point.peak_force, sums[p].peak_force);
    EXPECT_EQ(point.peak_closing_speed, sums[p].peak_closing_speed);
    EXPECT_EQ(point.peak_penetration, sums[p].peak_penetration);
  }
  EXPECT_EQ(response.events, 2 * static_cast<long>(response.impacts.size()));
}

TEST_P(EverySolver, AContactThatLastsToTheEndIsOpenEnded) {
  const double effective = 1.5, k = 2000, touch = pi * std::sqrt(effective / k);
  const Response response = run(free_masses(3, 3, 0.1, 1, std::make_shared<Linear>(k), 0.1 + 0.5 * touch));
  ASSERT_EQ(response.impacts.size(), 1u);
  EXPECT_TRUE(response.impacts[0].open_ended);
  EXPECT_EQ(response.impacts[0].end, 0.1 + 0.5 * touch);
  EXPECT_FALSE(response.impacts[0].restitution());
  EXPECT_NEAR(response.impacts[0].impulse / effective, 1, accuracy_);  // half of 2 m_e v₀
}

TEST_P(EverySolver, AFreeResponseServesOtherGapsToTheBit) {
  const FreeResponse free(sticks(0.5), GetParam().solver);
  const Response one = free.solve(sticks()), other = run(sticks());
  ASSERT_GT(one.impacts.size(), 5u);
  ASSERT_EQ(one.impacts.size(), other.impacts.size());
  for (std::size_t i = 0; i < one.impacts.size(); ++i) {
    EXPECT_EQ(one.impacts[i].start, other.impacts[i].start);
    EXPECT_EQ(one.impacts[i].peak_force, other.impacts[i].peak_force);
  }
  EXPECT_EQ(one.points[1].gap_needed, other.points[1].gap_needed);
}

TEST_P(EverySolver, AFreeResponseIsThatOfGapsThatNeverClose) {
  const FreeResponse free(sticks(), GetParam().solver);
  const Response far = run(sticks(1e6));
  const Response& response = free.response();
  ASSERT_EQ(far.status, Status::done);
  ASSERT_EQ(response.status, Status::done);
  EXPECT_TRUE(response.impacts.empty());
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_EQ(response.buildings[b].displacement, far.buildings[b].displacement_no_contact);
    EXPECT_EQ(response.buildings[b].displacement_no_contact, far.buildings[b].displacement_no_contact);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_GT(response.points[i].gap_needed, 0);
    EXPECT_EQ(response.points[i].gap_needed, far.points[i].gap_needed);
  }
}

TEST_P(EverySolver, NoDelaysAreDelaysOfZero) {
  Problem said = sticks();
  said.delays = {0, 0};
  Problem unsaid = said;
  unsaid.delays.clear();
  const FreeResponse free(unsaid, GetParam().solver);
  expect_same(free.solve(said), run(said));
  expect_same(run(unsaid), run(said));
  unsaid.delays = {0};
  EXPECT_THROW((void)run(unsaid), InvalidParameter);
}

TEST_P(EverySolver, AnInfiniteMotionIsAFailureWithATime) {
  Problem problem = sticks();
  std::get<SampledMotion>(problem.motion).acceleration[10] = std::numeric_limits<double>::infinity();
  const Response response = run(problem);
  EXPECT_EQ(response.status, Status::failed);
  EXPECT_NE(response.message.find("t = 0.1"), std::string::npos) << response.message;
}

INSTANTIATE_TEST_SUITE_P(, EverySolver, testing::ValuesIn(solvers()), [](const auto& one) { return one.param.label; });

TEST(Solvers, RefuseParametersOutsideTheirRange) {
  const Problem problem = sticks();
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double tolerance : {0.0, -1e-9, 0.9e-13, 1.1e-2, nan, infinity}) {
    try {
      (void)solve(problem, AdaptiveSolver{tolerance});
      ADD_FAILURE() << tolerance;
    } catch (const InvalidParameter& error) {
      EXPECT_EQ(error.parameter(), "tolerance");
    }
  }
  for (const double step : {0.0, -1e-3, nan, infinity}) {
    try {
      (void)solve(problem, RungeKuttaSolver{step});
      ADD_FAILURE() << step;
    } catch (const InvalidParameter& error) {
      EXPECT_EQ(error.parameter(), "step");
    }
  }
  for (const double tolerance : {1e-13, 1e-2}) EXPECT_NO_THROW((void)solve(problem, AdaptiveSolver{tolerance}));
  EXPECT_EQ(solve(problem, RungeKuttaSolver{5}).status, Status::done);  // longer than the run: one step a segment
}

// Of three points of a gap the last one is at a floor that another has, on either side.
TEST(Solvers, RefuseTwoPointsAtOneFloorOfAGap) {
  const Eigen::Matrix3d mass = Eigen::Vector3d(2, 3, 1).asDiagonal(), stiffness = 9 * mass;
  const auto given = [&](Eigen::Index left, Eigen::Index right) {
    Problem problem =
        test::pair(test::matrix_building(mass, stiffness, mass), test::matrix_building(mass, stiffness, mass),
                   {test::contact(1, 1, 0), test::contact(1, 1, 1), test::contact(1, 1, 2)}, 1);
    problem.points[2].left_floor = left;
    problem.points[2].right_floor = right;
    return problem;
  };
  EXPECT_NO_THROW(validate(given(2, 2)));
  for (const auto& [left, right, refused] :
       {std::tuple(0, 2, "points[2].left_floor"), std::tuple(2, 1, "points[2].right_floor"),
        std::tuple(1, 1, "points[2].left_floor")}) {
    try {
      validate(given(left, right));
      ADD_FAILURE() << refused;
    } catch (const InvalidParameter& error) {
      EXPECT_EQ(error.parameter(), refused);
      EXPECT_NE(std::string(error.what()).find(left == 0 ? "points[0]" : "points[1]"), std::string::npos)
          << error.what();
    }
  }
}

TEST(Solvers, GoByTheirNames) {
  EXPECT_EQ(name(ExactSolver{}), "exact");
  EXPECT_EQ(name(AdaptiveSolver{}), "adaptive");
  EXPECT_EQ(name(RungeKuttaSolver{}), "runge-kutta");
}

}  // namespace
}  // namespace bentur
