// Where gaps stay open the response without contact is that with it, and where one may close the way there is not gone
// again. Neither changes anything: not beside a run that keeps samples, nor beside one that looks at every gap all the
// way. Buildings that stand exactly still are among the cases, for a time or for good.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "bentur/pounding/assemble.h"
#include "bentur/solve/engine/run/free_run.h"
#include "bentur/solve/engine/run/pounding_run.h"
#include "tests/support/random_numbers.h"
#include "tests/support/random_yielding.h"
#include "tests/support/same_response.h"
#include "tests/support/small_buildings.h"

namespace bentur::shortcuts {
namespace {

using namespace bentur::test;

/// What a run of a problem looks into.
struct Ready {
  System given;
  engine::ModalSystem system{given};
  engine::Elements::Laws laws = engine::laws_of(given, system, given.contacts);
  engine::TimeGrid grid{given, true};
  Solver solver = ExactSolver{};
  engine::FlightPlan plan{system, grid, given.duration, true};

  explicit Ready(const Problem& problem) : given(system_of(problem)) {}
  Ready(const Ready&) = delete;
  Ready& operator=(const Ready&) = delete;
  [[nodiscard]] engine::Run::Setup setup() const { return {system, given, laws, solver, grid, plan}; }
};

engine::FreeResult free_result(const Problem& problem) {
  const Ready ready(problem);
  engine::FreeRun run(ready.setup());
  EXPECT_EQ(run.to_end({}), Status::done);
  return run.take_result();
}

/// From the first instant on it looks at every gap.
Response whole_run(const Problem& problem) {
  const Ready ready(problem);
  engine::Elements::Scales scales;
  for (const ContactPoint& point : problem.points) {
    scales.displacement.push_back(1e-3 + point.width);
    scales.speed.push_back(1e-2);
  }
  engine::PoundingRun run(ready.setup(), scales, 0, {});
  Response response;
  response.status = run.to_end({});
  run.elements().finish(problem.duration);
  response.impacts = std::move(run.elements().impacts());
  response.message = run.trouble();
  return response;
}

/// Only the first building moves at first: it starts with a speed, and the wave, if there is one, comes to the others
/// later.
Problem with_others_at_rest(Problem problem, unsigned seed) {
  const bool shaken = seed % 2 == 0 && !std::holds_alternative<NoMotion>(problem.motion);
  if (!shaken) problem.motion = NoMotion{};
  problem.delays.assign(problem.buildings.size(), shaken ? 0.7 * problem.duration : 0.0);
  problem.delays[0] = 0;
  problem.initial_displacement.clear();
  problem.initial_velocity.clear();
  for (const Building& building : problem.buildings) {
    problem.initial_velocity.push_back(Eigen::VectorXd::Zero(building.model.floors()));
  }
  // The lower floors may go away from the neighbour: those gaps need nothing.
  Eigen::VectorXd& speed = problem.initial_velocity[0];
  for (Eigen::Index f = 0; f < speed.size(); ++f)
    speed(f) = (f + 1 < speed.size() ? -1.0 : 0.4) / static_cast<double>(f + 1);
  return problem;
}

// Where damping lets no speed grow, the largest at a point is that at the start: |v| of both floors.
TEST(Shortcuts, TheSpeedsOfPointsAreThoseOfTheirFloors) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const std::vector<double> speeds = random_numbers(6, seed);
    const Eigen::MatrixXd mass = Eigen::Vector3d(2, 3, 1).asDiagonal();
    Eigen::MatrixXd stiffness(3, 3);
    stiffness << 4, -2, 0, -2, 4, -2, 0, -2, 2;
    Problem problem = pair(matrix_building(mass, stiffness, 60 * mass), matrix_building(2 * mass, stiffness, 90 * mass),
                           {contact(1, 1, 0), contact(1, 1, 1), contact(1, 1, 2)}, 1);
    problem.initial_velocity = {Eigen::Map<const Eigen::Vector3d>(speeds.data()),
                                Eigen::Map<const Eigen::Vector3d>(speeds.data() + 3)};
    const Ready ready(problem);
    engine::FreeRun run(ready.setup());
    ASSERT_EQ(run.to_end({}), Status::done);
    const std::vector<double> found = run.take_result().speeds;
    ASSERT_EQ(found.size(), 3);
    for (std::size_t f = 0; f < 3; ++f) {
      EXPECT_NEAR(found[f], std::abs(speeds[f]) + std::abs(speeds[f + 3]), 1e-13) << seed;
    }
  }
}

// What two buildings need and how fast they come to each other is the same in a row as alone, where no side is shared:
// to the bit, as they fly by themselves.
TEST(Shortcuts, SidesThatSeveralGapsShareTellEachTheSame) {
  std::vector<Building> buildings;
  for (unsigned b = 0; b < 4; ++b) {
    const Eigen::MatrixXd mass =
        Eigen::Map<const Eigen::VectorXd>(random_numbers(6, b).data(), 6).cwiseAbs().asDiagonal();
    const Eigen::MatrixXd any = Eigen::Map<const Eigen::MatrixXd>(random_numbers(36, 10 + b).data(), 6, 6);
    const Eigen::MatrixXd stiffness = 300 * any * any.transpose();
    buildings.push_back(matrix_building(mass + 0.1 * Eigen::MatrixXd::Identity(6, 6), stiffness, 0.01 * stiffness));
  }
  // Of four points at a time the first ones are alike, and then some or none of the others.
  const std::vector<std::vector<int>> floors{{0, 1, 2, 3, 4, 5}, {0, 1, 2, 5, 4, 3}, {0, 1, 2, 5, 4}};
  const SampledMotion motion{0.02, random_numbers(400, 5)};
  Problem row = pair(buildings[0], buildings[1], {}, 8);
  for (std::size_t b = 2; b < 4; ++b) {
    row.buildings.push_back(buildings[b]);
    row.delays.push_back(0.0);
    row.initial_displacement.push_back(Eigen::VectorXd::Zero(6));
    row.initial_velocity.push_back(Eigen::VectorXd::Zero(6));
  }
  row.motion = motion;
  for (int left = 0; left < 3; ++left) {
    for (const int floor : floors[left]) row.points.push_back(contact(9, 1, floor, left));
  }
  const engine::FreeResult together = free_result(row);
  std::size_t point = 0;
  for (std::size_t left = 0; left < 3; ++left) {
    std::vector<ContactPoint> points;
    for (const int floor : floors[left]) points.push_back(contact(9, 1, floor));
    Problem two = pair(buildings[left], buildings[left + 1], points, 8);
    two.motion = motion;
    const engine::FreeResult alone = free_result(two);
    for (std::size_t n = 0; n < points.size(); ++n, ++point) {
      SCOPED_TRACE(point);
      EXPECT_GT(alone.speeds[n], 0.0);
      EXPECT_EQ(together.speeds[point], alone.speeds[n]);
      EXPECT_NEAR(together.needed[point], alone.needed[n], 1e-14 * alone.needed[n]);
      ASSERT_EQ(together.reaches[point].size(), alone.reaches[n].size());
      for (std::size_t i = 0; i < alone.reaches[n].size(); ++i) {
        EXPECT_EQ(together.reaches[point][i].segment, alone.reaches[n][i].segment);
        EXPECT_EQ(together.reaches[point][i].reach, alone.reaches[n][i].reach);
      }
    }
  }
}

// Like buildings that move alike need no gap, which nothing is looked into for; with another start, delay or neighbour
// they do, as those that differ by a part in 10¹² and are looked into all the way.
TEST(Shortcuts, TwinsNeedAGapWhereTheyMoveApart) {
  Eigen::MatrixXd mass = Eigen::Vector3d(2, 3, 1).asDiagonal(), stiffness(3, 3);
  stiffness << 400, -200, 0, -200, 400, -200, 0, -200, 200;
  SampledMotion motion{0.05, random_numbers(80, 5)};
  for (int moves_apart = 0; moves_apart < 4; ++moves_apart) {
    SCOPED_TRACE(moves_apart);
    const auto solved = [&](double stiffer) {
      const Building one = matrix_building(mass, stiffness, 0.4 * mass);
      const Building other = matrix_building(mass, (moves_apart == 3 ? 1.2 : stiffer) * stiffness, 0.4 * mass);
      Problem problem = pair(one, other, {contact(9, 1, 0), contact(9, 1, 1), contact(9, 1, 2)}, 6);
      problem.motion = motion;
      if (moves_apart == 1) problem.initial_velocity[1](2) = 0.1;
      if (moves_apart == 2) problem.delays[1] = 0.123;
      SolveOptions sampled;
      sampled.output_step = 0.001;
      return solve(problem, ExactSolver{}, sampled);
    };
    const Response twins = solved(1.0), looked = solved(1.0 + 1e-12);
    for (std::size_t n = 0; n < 3; ++n) {
      const double seen = 9.0 - twins.histories.opening.row(static_cast<Eigen::Index>(n)).minCoeff();
      const double needed = twins.points[n].gap_needed;
      EXPECT_NEAR(needed, looked.points[n].gap_needed, 1e-12);
      EXPECT_NEAR(needed, seen, 1e-4 * seen + 1e-15);
      EXPECT_EQ(needed > 1e-6, moves_apart > 0) << needed;
    }
  }
}

// Nothing is noted of them as long as they move alike, be it that the wave has come to none of them yet; then all that
// is noted of two that differ by next to nothing.
TEST(Shortcuts, TwinsReachNothingUntilTheyMoveApart) {
  Eigen::MatrixXd mass = Eigen::Vector3d(2, 3, 1).asDiagonal();
  Eigen::MatrixXd stiffness(3, 3);
  stiffness << 400, -200, 0, -200, 400, -200, 0, -200, 200;
  for (const double delay : {0.0, 0.123}) {
    for (const int at_rest : {0, 70}) {
      SCOPED_TRACE(testing::Message() << delay << " s, " << at_rest);
      const auto found = [&](double stiffer) {
        Building one = matrix_building(mass, stiffness, 0.0 * mass),
                 other = matrix_building(mass, stiffer * stiffness, 0.0 * mass);
        Problem problem = pair(one, other, {contact(9, 1, 0), contact(9, 1, 1), contact(9, 1, 2)}, 8);
        SampledMotion motion{0.05, random_numbers(200, 5)};
        std::fill_n(motion.acceleration.begin(), at_rest, 0.0);
        problem.motion = motion;
        problem.delays[1] = delay;
        return free_result(problem);
      };
      const engine::FreeResult twins = found(1.0), others = found(1.0 + 1e-12);
      for (std::size_t n = 0; n < 3; ++n) {
        const auto& reaches = twins.reaches[n];
        if (delay == 0.0 || at_rest > 0) {
          EXPECT_EQ(reaches.front().reach, 0.0);
        }
        if (delay == 0.0) {
          EXPECT_EQ(twins.needed[n], 0.0);
          EXPECT_EQ(reaches.size(), 1);
          continue;
        }
        EXPECT_GT(twins.needed[n], 1e-3);
        EXPECT_NEAR(twins.needed[n], others.needed[n], 1e-9);
        ASSERT_GT(reaches.size(), 2);
        EXPECT_GE(reaches.back().reach, twins.needed[n]);
        for (const double part : {0.1, 0.5, 0.9}) {
          const std::vector<double> widths{part * twins.needed[n]};
          engine::FreeResult one, other;
          one.needed = {twins.needed[n]}, one.reaches = {reaches};
          other.needed = {others.needed[n]}, other.reaches = {others.reaches[n]};
          EXPECT_EQ(engine::first_contact(one, widths), engine::first_contact(other, widths));
        }
      }
    }
  }
}

TEST(Shortcuts, LoseNoImpact) {
  int impacts = 0, still = 0;
  for (unsigned seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE(seed);
    Problem problem = YieldingGenerator(seed).make().problem;
    if (seed % 4 != 0) problem = with_others_at_rest(problem, seed / 4);
    SolveOptions looked;
    looked.output_step = 0.0137;
    const Response quick = solve(problem), sampled = solve(problem, ExactSolver{}, looked), whole = whole_run(problem);
    ASSERT_EQ(quick.status, Status::done) << quick.message;
    ASSERT_EQ(whole.status, Status::done) << whole.message;
    expect_same(quick, sampled);
    ASSERT_EQ(quick.impacts.empty(), whole.impacts.empty());
    if (!quick.impacts.empty()) {
      EXPECT_NEAR(quick.impacts[0].start, whole.impacts[0].start, 1e-9 * problem.duration);
    }
    // Those after it may depend on its last digits.
    for (Eigen::Index i = 0; i < std::ssize(problem.points); ++i) {
      const auto at_point = [i](const Impact& impact) { return impact.point == i; };
      const auto one = std::find_if(quick.impacts.begin(), quick.impacts.end(), at_point);
      const auto other = std::find_if(whole.impacts.begin(), whole.impacts.end(), at_point);
      ASSERT_EQ(one == quick.impacts.end(), other == whole.impacts.end()) << "point " << i;
      if (one == quick.impacts.end()) continue;
      EXPECT_NEAR(one->start, other->start, 1e-3 * problem.duration) << "point " << i;
    }
    impacts += static_cast<int>(quick.impacts.size());
    still += quick.impacts.empty() ? 1 : 0;
  }
  fmt::print("{} impacts, {} cases without\n", impacts, still);
  EXPECT_GT(impacts, 300);
  EXPECT_GT(still, 5);
}

}  // namespace
}  // namespace bentur::shortcuts
