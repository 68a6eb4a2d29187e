// What a run is said to take beforehand, beside what it takes.
#include "bentur/pounding/pounding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "bentur/core/errors.h"
#include "bentur/solve/engine/motion/series.h"
#include "tests/support/example_laws.h"
#include "tests/support/free_masses.h"
#include "tests/support/small_buildings.h"

namespace bentur {
namespace {

using namespace bentur::test;
using By = Effort::Fastest::By;

constexpr double m = 2e5;  // [kg]

SampledMotion short_record() {
  SampledMotion motion{0.02, {}};
  for (int i = 0; i < 140; ++i) motion.acceleration.push_back(3 * std::sin(0.31 * i) + 2 * std::sin(0.13 * i * i));
  return motion;
}

/// Two oscillators under a record, in contact often; the left one stands on a second, `stiff` storey.
Problem with_stiff_storey(const LawExample& law, double stiff) {
  const Eigen::Matrix2d mass = m * Eigen::Matrix2d::Identity();
  const Eigen::Matrix2d stiffness = m * (Eigen::Matrix2d() << stiff + 150, -stiff, -stiff, stiff).finished();
  Building left = matrix_building(mass, stiffness, Eigen::Matrix2d::Zero());
  left.modal_damping = (0.1 * left.modes.omega).asDiagonal();
  Problem problem = pair(std::move(left), oscillator(m, m * 60, 0.03), {contact(0.005, law.make(m / 2))}, 3);
  problem.motion = short_record();
  problem.delays = {0, 0.013};
  return problem;
}

double contact_time(const Response& response) {
  double time = 0;
  for (const PointSummary& point : response.points) time += point.contact_duration;
  return time;
}

/// Whether contact ends with parting: else the run goes on by steps for as long as the law remembers, which no time of
/// contact tells.
bool ends_with_parting(const LawExample& law) {
  return law.straight && law.label != "kelvin_voigt_zero_force" && law.label != "kelvin_voigt_overdamped" &&
         law.label != "kelvin_voigt_creep";
}

class EffortOf : public testing::TestWithParam<LawExample> {};

// Steps while apart are those of the ground motion's grid, two lengths for two phases; those of a contact with straight
// branches follow from its time. An event cuts a step in two, and what leads up to one is halved down to a series:
// log₂(0.02 r/2.4) times, r the rate.
TEST_P(EffortOf, IsWhatTheExactSolverTakes) {
  for (const double stiff : {1e3, 1e6, 1e9}) {
    const Problem problem = with_stiff_storey(GetParam(), stiff);
    SCOPED_TRACE(stiff);
    const Effort said = effort(problem, ExactSolver{}, {});
    const Response response = solve(problem);
    ASSERT_EQ(response.status, Status::done) << response.message;
    ASSERT_GT(response.events, 3);
    const auto steps = static_cast<double>(response.steps);
    EXPECT_EQ(said.steps, 300);
    EXPECT_GE(steps, said.steps);
    const double halvings = std::ceil(std::log2(0.02 * std::sqrt(2 * stiff) * 1.2 / engine::series_reach)) + 1;
    const double allowed = said.steps + contact_time(response) * said.steps_in_contact +
                           static_cast<double>(response.events) * (2 * std::max(halvings, 1.0) + 3);
    if (ends_with_parting(GetParam())) {
      EXPECT_LE(steps, allowed);
    }
    EXPECT_LE(steps, said.most_steps);
    EXPECT_EQ(said.apart.by, By::mode);
    EXPECT_EQ(said.apart.building, 0u);
    EXPECT_EQ(said.apart.mode, 1);
    EXPECT_NEAR(said.apart.frequency, problem.buildings[0].modes.omega(1) / (2 * std::numbers::pi), 1e-9 * stiff);
  }
}

/// Laws whose contact takes time and is neither estimated nor remembering.
std::vector<LawExample> laws_of_known_time() {
  std::vector<LawExample> laws = example_laws();
  std::erase_if(laws, [](const auto& one) { return !ends_with_parting(one) || one.law == "restitution"; });
  return laws;
}
class EffortInContact : public EffortOf {};

// A contact of much time: what is said of a second of it is within a tenth of what it takes.
TEST_P(EffortInContact, IsThatOfItsTime) {
  const Problem problem = with_stiff_storey(GetParam(), 1e9);
  const Response response = solve(problem);
  const Effort said = effort(problem, ExactSolver{}, {});
  const double in_contact = static_cast<double>(response.steps) - said.steps;
  EXPECT_NEAR(in_contact / (contact_time(response) * said.steps_in_contact), 1.0, 0.1);
}

INSTANTIATE_TEST_SUITE_P(, EffortOf, testing::ValuesIn(example_laws()),
                         [](const auto& one) { return one.param.label; });
INSTANTIATE_TEST_SUITE_P(, EffortInContact, testing::ValuesIn(laws_of_known_time()),
                         [](const auto& one) { return one.param.label; });

TEST(Effort, OfTheOtherSolversEnclosesTheirSteps) {
  for (const double stiff : {1e3, 1e6}) {
    const Problem problem = with_stiff_storey(example_laws().front(), stiff);
    for (const Solver& solver :
         {Solver(AdaptiveSolver{1e-9}), Solver(AdaptiveSolver{1e-4}), Solver(RungeKuttaSolver{1e-3})}) {
      const Effort said = effort(problem, solver, {});
      if (said.growing_step > 0 && std::get<RungeKuttaSolver>(solver).step > said.growing_step) continue;
      const Response response = solve(problem, solver);
      ASSERT_EQ(response.status, Status::done) << response.message;
      EXPECT_GE(static_cast<double>(response.steps), 0.99 * said.steps) << name(solver) << stiff;
      EXPECT_LE(static_cast<double>(response.steps), said.most_steps) << name(solver) << stiff;
    }
  }
}

// |R(iy)| of the classical rule of order four is 1 at y = 2√2.
TEST(Effort, KnowsFromWhichStepOnRungeKuttaGrows) {
  Problem problem = pair(oscillator(m, m * 1e4), oscillator(m, m * 60), {contact(100.0, 1e8)}, 20);
  problem.initial_displacement = {Eigen::VectorXd::Constant(1, 0.01), Eigen::VectorXd::Zero(1)};
  const double limit = effort(problem, RungeKuttaSolver{0.01}, {}).growing_step;
  EXPECT_NEAR(limit, 2 * std::numbers::sqrt2 / 100, 1e-4);
  const auto peak = [&](double step) {
    return solve(problem, RungeKuttaSolver{step}).buildings[0].displacement_no_contact(0);
  };
  EXPECT_LT(peak(0.99 * limit), 0.05);
  EXPECT_GT(peak(1.03 * limit), 1.0);
}

TEST(Effort, SaysWhatIsFastest) {
  Problem problem = pair(oscillator(m, m * 150), oscillator(m, m * 60), {contact(0.1, m * 5e4)}, 3);
  Effort said = effort(problem, ExactSolver{}, {});
  EXPECT_EQ(said.in_contact.by, By::contact);
  EXPECT_NEAR(said.in_contact.frequency, std::sqrt(2 * 5e4) / (2 * std::numbers::pi), 1e-9);
  problem.buildings[1] = oscillator(m, m * 60, 50.0);  // ½ · 2ζω
  said = effort(problem, ExactSolver{}, {});
  EXPECT_EQ(said.in_contact.by, By::damping);
  EXPECT_EQ(said.in_contact.building, 1u);
  problem.motion = HarmonicMotion{1e-4, 1e-6, HarmonicMotion::Phase::sine};
  said = effort(problem, ExactSolver{}, {});
  EXPECT_EQ(said.apart.by, By::motion);
  EXPECT_DOUBLE_EQ(said.apart.frequency, 1e4);
}

// Every stretch is gone over again in steps of a series, halved down to that: 2⁹ a segment of 0.013 or 0.007 s and
// less.
TEST(Effort, OfAnEnergyAuditIsCertain) {
  Problem problem = with_stiff_storey(example_laws().front(), 1e9);
  problem.points[0].width = 10.0;
  SolveOptions options;
  options.energy_audit = true;
  const Effort said = effort(problem, ExactSolver{}, options);
  EXPECT_GT(said.certain_steps, 100 * said.steps);
  options.limits.steps = static_cast<long>(0.9 * said.certain_steps);
  EXPECT_EQ(solve(problem, ExactSolver{}, options).status, Status::failed);
  options.limits.steps = static_cast<long>(3 * said.certain_steps);  // halves are counted, and the series at their ends
  EXPECT_EQ(solve(problem, ExactSolver{}, options).status, Status::done);
}

// 24 bytes of histories a floor and 16 a point, plus time and ground; four times while they are written.
TEST(Effort, CountsTheHistories) {
  const Problem problem = with_stiff_storey(example_laws().front(), 1e3);
  SolveOptions options;
  const double without = effort(problem, ExactSolver{}, options).memory;
  options.output_step = 1e-6;
  const Effort with = effort(problem, ExactSolver{}, options);
  EXPECT_EQ(with.samples, 3000001);
  EXPECT_NEAR(with.memory - without, 4 * 3000001.0 * 8 * (2 + 5 * 3 + 2), 1.0)
      << "displacement, velocity, acceleration, drift and shear of three floors";
}

// Sampling and peaks between contacts cost the logarithm of a fast mode's frequency, not the frequency.
TEST(Work, ApartDoesNotGrowWithAFastMode) {
  Problem problem = with_stiff_storey(example_laws().front(), 1e12);
  problem.points[0].width = 10.0;
  problem.duration = 2.507;  // not a whole number of steps
  SolveOptions options;
  options.output_step = 0.003;
  options.limits.steps = 60000;  // of 2.5 s at 1.4e6 rad/s: 1.5e6 power series
  const Response response = solve(problem, ExactSolver{}, options);
  ASSERT_EQ(response.status, Status::done) << response.message;
  ASSERT_EQ(response.histories.time.size(), 836u);
  // As one floor: the storey is rigid. Its stiffness has 150 of 1e12 to 1e-6.
  Problem rigid = problem;
  rigid.buildings[0] = oscillator(2 * m, m * 150, 0.05);
  rigid.initial_displacement.clear();
  rigid.initial_velocity.clear();
  const Response expected = solve(rigid, ExactSolver{}, options);
  EXPECT_NEAR(response.buildings[0].displacement(0), expected.buildings[0].displacement(0),
              1e-5 * expected.buildings[0].displacement(0));
  for (Eigen::Index n = 0; n < 836; ++n) {
    EXPECT_NEAR(response.histories.displacement[0](0, n), expected.histories.displacement[0](0, n), 1e-6);
  }
}

TEST(Work, EndsAtItsLimit) {
  const Problem problem = with_stiff_storey(example_laws().front(), 1e12);
  SolveOptions options;
  options.limits.steps = 5000;
  const Response response = solve(problem, ExactSolver{}, options);
  EXPECT_EQ(response.status, Status::failed);
  EXPECT_NE(response.message.find("the limit of 5000 steps is reached at t = "), std::string::npos) << response.message;
  options.limits = {.events = 3};
  const Response eventful = solve(with_stiff_storey(example_laws().front(), 150), ExactSolver{}, options);
  EXPECT_EQ(eventful.status, Status::failed);
  EXPECT_NE(eventful.message.find("the limit of 3 events is reached at t = "), std::string::npos) << eventful.message;
  options.limits = {.seconds = 1e-6};
  const Response late = solve(problem, ExactSolver{}, options);
  EXPECT_EQ(late.status, Status::failed);
  EXPECT_NE(late.message.find("the limit of 1e-06 s of wall time is reached at t = "), std::string::npos)
      << late.message;
  options.limits.steps = 299;  // the grid alone has more
  EXPECT_THROW((void)solve(problem, ExactSolver{}, options), InvalidParameter);
}

TEST(Work, StopsWithinOneLongStepOfTheMotion) {
  const Problem problem = with_stiff_storey(example_laws().front(), 1e14);
  long calls = 0;
  SolveOptions options;
  options.progress = [&](double fraction) {
    EXPECT_LE(fraction, 1.0);
    return ++calls < 10;
  };
  EXPECT_EQ(solve(problem, ExactSolver{}, options).status, Status::stopped);
  EXPECT_EQ(calls, 10);
}

/// What no number can follow is said before anything is made of it.
TEST(Validate, RefusesTimesThatNumbersCannotTellApart) {
  const LawExample law = example_laws().front();
  const auto refused = [](const Problem& problem) { EXPECT_THROW((void)solve(problem), InvalidParameter); };
  refused(pair(oscillator(m, m * 1e32), oscillator(m, m), {contact(0.1, law.make(m))}, 3));
  Problem problem = with_stiff_storey(law, 1e3);
  problem.motion = HarmonicMotion{1e-308, 1.0, HarmonicMotion::Phase::sine};
  refused(problem);
  problem.motion = HarmonicMotion{1e-10, 1e300, HarmonicMotion::Phase::sine};
  refused(problem);
  problem.motion = short_record();
  std::get<SampledMotion>(problem.motion).time_step = 1e-300;
  refused(problem);
  problem.motion = short_record();
  problem.buildings[0].modal_damping(0, 0) = std::numeric_limits<double>::infinity();
  refused(problem);
}

// A delay beyond the end of the analysis is one of just that length: the building stays at rest.
TEST(Delays, BeyondTheEndAreAsLongAsTheAnalysis) {
  Problem problem = with_stiff_storey(example_laws().front(), 1e3);
  problem.delays = {0, 1e308};
  const Response late = solve(problem);
  ASSERT_EQ(late.status, Status::done) << late.message;
  problem.delays = {0, 3.0};
  const Response end = solve(problem);
  EXPECT_EQ(late.buildings[1].displacement_no_contact(0), 0.0);
  ASSERT_EQ(late.impacts.size(), end.impacts.size());
  ASSERT_GT(late.impacts.size(), 1u);
  for (std::size_t i = 0; i < late.impacts.size(); ++i) {
    EXPECT_NEAR(late.impacts[i].start, end.impacts[i].start, 1e-9);
    EXPECT_NEAR(late.impacts[i].peak_force, end.impacts[i].peak_force, 1e-6 * end.impacts[i].peak_force);
  }
}

}  // namespace
}  // namespace bentur
