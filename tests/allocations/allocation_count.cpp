// The loop over time allocates nothing: a run of twice the length takes no more memory from the heap, apart from lists
// that grow by doubling.
#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <numbers>
#include <utility>

#include "bentur/elements/kinematic_hardening.h"
#include "bentur/elements/link_laws.h"
#include "bentur/pounding/pounding.h"
#include "tests/support/example_laws.h"
#include "tests/support/small_buildings.h"

namespace {
std::atomic<long> allocations{0}, bytes{0};
}

// What the linker makes of malloc (Eigen's matrices) and of operator new (everything else).
extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier): the linker's names
void* __real_malloc(std::size_t size);
void* __real__Znwm(std::size_t size);
void* __wrap_malloc(std::size_t size) {
  ++allocations;
  bytes += static_cast<long>(size);
  return __real_malloc(size);
}
void* __wrap__Znwm(std::size_t size) {
  ++allocations;
  bytes += static_cast<long>(size);
  return __real__Znwm(size);
}
// NOLINTEND(bugprone-reserved-identifier)
}

namespace bentur {
namespace {

struct Count {
  long allocations = 0, steps = 0, events = 0;
  std::size_t impacts = 0;
  long bytes = 0;
};

/// Two sticks of three floors [N, m, kg] under a harmonic motion that makes them collide at each period.
/// `yielding`: their storeys yield, and a cable and a dashpot link them.
Count run_of(const test::LawExample& law, const Solver& solver, double duration, bool yielding = false) {
  const auto stick = [](double stiffness) {
    Eigen::MatrixXd mass = Eigen::MatrixXd::Identity(3, 3) * 2e5;
    Eigen::MatrixXd k(3, 3);
    k << 2, -1, 0, -1, 2, -1, 0, -1, 1;
    return test::matrix_building(mass, stiffness * k, 0.02 * std::sqrt(stiffness * 2e5) * k);
  };
  std::vector<ContactPoint> points;
  for (int floor = 0; floor < 3; ++floor) {
    points.push_back(test::contact(0.01, 1, floor));
    points.back().law = law.make(1e5);
  }
  Problem problem = test::pair(stick(2e8), stick(8e7), points, duration);
  if (yielding) {
    for (const auto& [building, stiffness] : {std::pair(0, 2e8), std::pair(1, 8e7)}) {
      Building& one = problem.buildings[building];
      one.elements =
          storey_elements(one.model, {3, std::make_shared<KinematicHardening>(stiffness, 0.005 * stiffness, 0.1)});
    }
    problem.links.push_back({0, 1, 1, 1, 0.0, std::make_shared<Cable>(1e6, 0.01)});
    problem.links.push_back({0, 1, 2, 2, 0.0, std::make_shared<SpringDashpot>(0.0, 1e4)});
  }
  problem.motion = HarmonicMotion{.period = 0.8, .displacement_amplitude = 0.05};
  const FreeResponse free(problem, solver);
  const long before = allocations, bytes_before = bytes;
  const Response response = free.solve(problem);
  const long after = allocations, bytes_after = bytes;
  EXPECT_EQ(response.status, Status::done) << response.message;
  return {after - before, response.steps, response.events, response.impacts.size(), bytes_after - bytes_before};
}

class TheLoop : public testing::TestWithParam<test::LawExample> {};

TEST_P(TheLoop, AllocatesNothing) {
  for (const Solver& solver : {Solver(ExactSolver{}), Solver(AdaptiveSolver{1e-6})}) {
    const Count once = run_of(GetParam(), solver, 8), twice = run_of(GetParam(), solver, 16);
    ASSERT_GE(once.impacts, 10U);
    ASSERT_GE(twice.impacts, once.impacts + 8);
    ASSERT_GE(twice.steps, once.steps + 100);
    constexpr long doublings = 12;  // of the lists of impacts and of what is still open, which grow with the run
    // Impacts without duration solve equations for the impulses at all points that are closed.
    const long equations = GetParam().law == "restitution" ? 24 * static_cast<long>(twice.impacts - once.impacts) : 0;
    EXPECT_LE(twice.allocations, once.allocations + doublings + equations)
        << name(solver) << ": " << once.allocations << " allocations in " << once.steps << " steps with "
        << once.impacts << " impacts, " << twice.allocations << " in " << twice.steps << " with " << twice.impacts;
  }
}

// What lists take that grow by doubling counts each time they are copied, three times their end at most.
TEST(AnImpact, TakesNoMoreThanAKilobyte) {
  for (const Solver& solver : {Solver(ExactSolver{}), Solver(AdaptiveSolver{1e-6})}) {
    const Count once = run_of(test::example_laws().front(), solver, 40),
                longer = run_of(test::example_laws().front(), solver, 160);
    ASSERT_GE(longer.impacts, once.impacts + 300);
    EXPECT_LE(longer.bytes - once.bytes, 1024 * static_cast<long>(longer.impacts - once.impacts))
        << name(solver) << ": " << once.bytes << " bytes with " << once.impacts << " impacts, " << longer.bytes
        << " with " << longer.impacts;
  }
}

TEST(TheLoopWithYieldingAndLinks, AllocatesNothing) {
  const test::LawExample linear = test::example_laws().front();
  ASSERT_EQ(linear.law, "linear");
  for (const Solver& solver : {Solver(ExactSolver{}), Solver(AdaptiveSolver{1e-6})}) {
    const Count once = run_of(linear, solver, 8, true), twice = run_of(linear, solver, 16, true);
    ASSERT_GE(once.impacts, 4U);
    ASSERT_GE(twice.events, once.events + 40);
    constexpr long doublings = 12;  // of lists that grow with the run
    EXPECT_LE(twice.allocations, once.allocations + doublings)
        << name(solver) << ": " << once.allocations << " allocations with " << once.events << " events, "
        << twice.allocations << " with " << twice.events;
  }
}

INSTANTIATE_TEST_SUITE_P(, TheLoop, testing::ValuesIn(test::example_laws()),
                         [](const auto& law) { return law.param.label; });

}  // namespace
}  // namespace bentur
