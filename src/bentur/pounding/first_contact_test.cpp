// Problems that differ in gap widths and laws alone share the way to the first contact; where they leave it is none of
// the solution's business.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "bentur/contact/laws/hertz.h"
#include "bentur/core/errors.h"
#include "bentur/pounding/pounding.h"
#include "tests/support/free_masses.h"
#include "tests/support/same_response.h"

namespace bentur {
namespace {

using namespace bentur::test;

/// Two oscillators under a record of 8 s that grows, so that wide gaps close late: more than three stretches of states
/// that are kept on the way. Delays that are no multiple of its step give two kinds of segments.
Problem problem_with(double width, double delay, Kinematics kinematics) {
  const double m = 2e5;
  Problem problem = pair(oscillator(m, m * 150, 0.03), oscillator(m, m * 60, 0.03), {contact(width, 1e8)}, 8);
  SampledMotion motion{0.01, {}};
  for (int i = 0; i < 800; ++i)
    motion.acceleration.push_back(0.005 * i * (std::sin(0.09 * i) + std::sin(0.013 * i * i)));
  problem.motion = motion;
  problem.delays = {0, delay};
  problem.kinematics = kinematics;
  return problem;
}

/// Recorded runs go all the way, others begin where the gap may close.
TEST(FirstContact, RunsThatBeginLateAreThoseThatGoTheWholeWay) {
  for (const Kinematics kinematics : {Kinematics::relative, Kinematics::absolute}) {
    for (const double delay : {0.0, 0.054}) {
      const FreeResponse free(problem_with(0, delay, kinematics));
      const double needed = free.solve(problem_with(1e3, delay, kinematics)).points[0].gap_needed;
      ASSERT_GT(needed, 0.0);
      double last_first = -1;
      for (const double part : {0.0, 0.02, 0.2, 0.5, 0.8, 0.97, 1 - 1e-9, 1 + 1e-9, 1.2, 10.0}) {
        const Problem problem = problem_with(part * needed, delay, kinematics);
        SolveOptions options;
        options.output_step = 0.005;
        const Response late = free.solve(problem), whole = free.solve(problem, options);
        ASSERT_EQ(late.status, Status::done);
        expect_same(late, whole);
        expect_same(late, solve(problem));
        EXPECT_EQ(late.impacts.empty(), part > 1) << part;
        if (late.impacts.empty()) {
          EXPECT_EQ(late.buildings[0].displacement, late.buildings[0].displacement_no_contact);
          continue;
        }
        EXPECT_GE(late.impacts.front().start, last_first);
        last_first = late.impacts.front().start;
      }
      EXPECT_GT(last_first,
                4 * 1.28);  // states are kept every 1.28 s (of segments twice as many where there are two kinds)
    }
  }
}

/// A mass at a steady speed closes gaps one by one, w after w/v: one in each segment of three stretches of states kept.
TEST(FirstContact, IsFoundInWhicheverSegmentItFalls) {
  const double step = 0.01, speed = 2;
  const auto problem = [&](double width) {
    Problem result = free_masses(1e5, 1e5, width, speed, std::make_shared<Linear>(1e8), 4.2);
    result.motion = SampledMotion{step, std::vector<double>(421, 0.0)};
    return result;
  };
  const FreeResponse free(problem(0));
  for (int segment = 0; segment < 400; ++segment) {
    const double time = (segment + 0.5) * step;
    const Response response = free.solve(problem(speed * time));
    ASSERT_EQ(response.impacts.size(), 1U) << segment;
    ASSERT_NEAR(response.impacts[0].start, time, 1e-12) << segment;
    ASSERT_NEAR(response.impacts[0].closing_speed, speed, 1e-12) << segment;
  }
}

/// An undamped swing A sin(ωt + φ) that is largest in the middle of a segment, a 32nd of its period: ends of segments
/// come no nearer than A cos(π/32) = 0.9952 A, however long it swings.
TEST(FirstContact, IsFoundWhereNoSegmentEnds) {
  const double omega = 20, a = 0.2, phase = std::numbers::pi / 32;
  for (const double part : {0.9955, 0.999, 1 - 1e-6, 1 - 1e-9}) {
    Problem problem = pair(oscillator(1, omega * omega), wall(), {contact(part * a, 1.0)}, 3);
    problem.initial_displacement[0](0) = a * std::sin(phase);
    problem.initial_velocity[0](0) = a * omega * std::cos(phase);
    const Response response = solve(problem);
    ASSERT_FALSE(response.impacts.empty()) << part;
    // The start of a grazing contact is known as well as the square root of what the opening is.
    EXPECT_NEAR(response.impacts[0].start, (std::asin(part) - phase) / omega, 1e-10) << part;
    EXPECT_NEAR(response.impacts[0].closing_speed / (a * omega * std::sqrt((1 - part) * (1 + part))), 1, 1e-5) << part;
  }
}

/// A solver with error control agrees, which shares nothing.
TEST(FirstContact, IsFoundByOthersToo) {
  const FreeResponse free(problem_with(0, 0.054, Kinematics::relative));
  const double needed = free.solve(problem_with(1e3, 0.054, Kinematics::relative)).points[0].gap_needed;
  for (const double part : {0.2, 0.5, 0.9}) {
    const Problem problem = problem_with(part * needed, 0.054, Kinematics::relative);
    const Response exact = free.solve(problem), other = solve(problem, AdaptiveSolver{1e-11});
    ASSERT_EQ(exact.impacts.size(), other.impacts.size());
    for (std::size_t i = 0; i < exact.impacts.size(); ++i) {
      EXPECT_NEAR(exact.impacts[i].start, other.impacts[i].start, 1e-8);
      EXPECT_NEAR(exact.impacts[i].peak_force / other.impacts[i].peak_force, 1, 1e-6);
    }
    for (std::size_t b = 0; b < 2; ++b) {
      EXPECT_NEAR(exact.buildings[b].displacement(0) / other.buildings[b].displacement(0), 1, 1e-8);
      EXPECT_NEAR(exact.buildings[b].acceleration(0) / other.buildings[b].acceleration(0), 1, 1e-6);
      EXPECT_NEAR(exact.buildings[b].storey_shear(0) / other.buildings[b].storey_shear(0), 1, 1e-8);
    }
  }
}

/// What a free response was found for must be what it is asked about: all but widths and laws.
TEST(FirstContact, AFreeResponseRefusesAnotherProblem) {
  const auto row = [] {
    Problem problem = problem_with(0.01, 0.054, Kinematics::relative);
    const Eigen::MatrixXd mass = 2e5 * Eigen::MatrixXd::Identity(3, 3),
                          stiffness = 3e7 * Eigen::MatrixXd::Identity(3, 3);
    problem.buildings[0] = problem.buildings[1] = matrix_building(mass, stiffness, 0 * stiffness);
    problem.points = {contact(0.01, 1e8, 0), contact(0.02, 1e8, 1)};
    problem.initial_displacement.assign(2, Eigen::VectorXd::Zero(3));
    problem.initial_velocity.assign(2, Eigen::VectorXd::Zero(3));
    return problem;
  };
  const FreeResponse free(row());
  Problem other = row();
  other.points[0].width = 0.5;
  other.points[1].law = std::make_shared<Hertz>(1e9);
  EXPECT_NO_THROW((void)free.solve(other));

  const struct {
    std::string what;
    std::function<void(Problem&)> change;
  } changes[] = {
      {"points", [](Problem& p) { p.points.push_back(contact(0.02, 1e8, 2)); }},
      {"points", [](Problem& p) { p.points.pop_back(); }},
      {"points[1]", [](Problem& p) { p.points[1].left_floor = 2; }},
      {"points[1]", [](Problem& p) { p.points[1].right_floor = 2; }},
      {"buildings",
       [](Problem& p) {
         p.buildings.push_back(p.buildings[0]);
         p.delays.push_back(0);
         p.initial_displacement.push_back(p.initial_displacement[0]);
         p.initial_velocity.push_back(p.initial_velocity[0]);
       }},
      {"buildings[1]", [](Problem& p) { p.buildings[1].modes.omega(1) *= 1 + 1e-15; }},
      {"buildings[0]", [](Problem& p) { p.buildings[0].modes.shapes(1, 0) += 1e-9; }},
      {"buildings[0]", [](Problem& p) { p.buildings[0].modal_damping(0, 1) = 1e-3; }},
      {"buildings[0]", [](Problem& p) { p.buildings[0].model.load(0) *= 2; }},
      {"buildings[0]", [](Problem& p) { p.buildings[0].model.mass(0, 0) *= 2; }},
      {"buildings[0]", [](Problem& p) { p.buildings[0].model.stiffness(0, 0) *= 2; }},
      {"buildings[0]", [](Problem& p) { p.buildings[0].model.storey_heights[1] *= 2; }},
      {"motion", [](Problem& p) { std::get<SampledMotion>(p.motion).acceleration[3] += 1; }},
      {"motion", [](Problem& p) { std::get<SampledMotion>(p.motion).acceleration.pop_back(); }},
      {"motion", [](Problem& p) { std::get<SampledMotion>(p.motion).time_step *= 2; }},
      {"motion", [](Problem& p) { p.motion = HarmonicMotion{.period = 1, .displacement_amplitude = 1}; }},
      {"motion", [](Problem& p) { p.motion = NoMotion{}; }},
      {"delays", [](Problem& p) { p.delays[1] = 0; }},
      {"kinematics", [](Problem& p) { p.kinematics = Kinematics::absolute; }},
      {"initial_displacement", [](Problem& p) { p.initial_displacement[1](0) = 1e-3; }},
      {"initial_velocity", [](Problem& p) { p.initial_velocity[0](1) = 1e-3; }},
      {"duration", [](Problem& p) { p.duration = 7; }},
  };
  for (const auto& [what, change] : changes) {
    Problem changed = row();
    change(changed);
    try {
      (void)free.solve(changed);
      ADD_FAILURE() << what << " was taken";
    } catch (const InvalidParameter& error) {
      EXPECT_EQ(std::string(error.what()).rfind(what + " = ", 0), 0U) << error.what();
    }
  }
}

TEST(FirstContact, AtRestIsTheSameWithAndWithoutSayingSo) {
  Problem said = problem_with(0.01, 0, Kinematics::relative), unsaid = said;
  unsaid.initial_displacement.clear();
  unsaid.initial_velocity.clear();
  EXPECT_NO_THROW(expect_same(FreeResponse(said).solve(unsaid), FreeResponse(unsaid).solve(said)));
}

/// Where a load is not that of the masses alone, accelerations jump with the ground's: at the first value of a record
/// that reaches a building late, and after the last one. Both are peaks here.
TEST(Course, EndsWhereTheGroundAccelerationJumps) {
  const auto building = [](double stiffness) {
    Building result = oscillator(2e5, stiffness, 0.03);
    result.model.load *= 0.4;
    return result;
  };
  for (const bool at_the_end : {false, true}) {
    Problem problem = pair(building(2e4), building(1.2e4), {contact(100, 1e8)}, 4);
    SampledMotion motion{0.02, std::vector<double>(50, 0.0)};
    for (std::size_t i = 0; i < 50; ++i) motion.acceleration[i] = std::sin(0.3 * static_cast<double>(i));
    motion.acceleration[at_the_end ? 49 : 0] = 5;
    problem.motion = motion;
    problem.delays = {0, 0.2};
    const Response exact = solve(problem), other = solve(problem, AdaptiveSolver{1e-11});
    for (std::size_t b = 0; b < 2; ++b) {
      EXPECT_NEAR(exact.buildings[b].acceleration(0) / other.buildings[b].acceleration(0), 1, 1e-8) << b;
      EXPECT_GE(exact.buildings[b].acceleration(0), 0.6 * 4.9);
    }
  }
}

}  // namespace
}  // namespace bentur
