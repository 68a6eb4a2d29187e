// exact against adaptive at 1e-12, which share no way of stepping, on rows with everything at once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "bentur/core/errors.h"
#include "bentur/elements/link_laws.h"
#include "bentur/pounding/pounding.h"
#include "tests/support/example_laws.h"
#include "tests/support/free_masses.h"

namespace bentur {
namespace {

using Eigen::MatrixXd;
using namespace bentur::test;

Building stick(int floors, double mass, double stiffness) {
  MatrixXd k = MatrixXd::Zero(floors, floors);
  for (int f = 0; f < floors; ++f) {
    k(f, f) += stiffness;
    if (f > 0) {
      k(f - 1, f - 1) += stiffness;
      k(f - 1, f) -= stiffness;
      k(f, f - 1) -= stiffness;
    }
  }
  return matrix_building(mass * MatrixXd::Identity(floors, floors), k, 0.003 * k);
}

SampledMotion record() {
  SampledMotion motion{0.02, {}};
  for (int i = 0; i < 90; ++i) motion.acceleration.push_back(3 * std::sin(0.31 * i) + 2 * std::sin(0.13 * i * i));
  return motion;
}

/// Largest difference of impacts and peaks, each relative to the largest of its kind.
double difference(const Response& one, const Response& other) {
  EXPECT_EQ(one.status, Status::done) << one.message;
  EXPECT_EQ(other.status, Status::done) << other.message;
  EXPECT_EQ(one.impacts.size(), other.impacts.size());
  if (one.impacts.size() != other.impacts.size()) return 1;
  double force = 0, impulse = 0, speed = 0;
  for (const Impact& impact : one.impacts) {
    force = std::max(force, impact.peak_force);
    impulse = std::max(impulse, impact.impulse);
    speed = std::max(speed, impact.closing_speed);
  }
  double worst = 0;
  const auto compare = [&worst](double a, double b, double scale) {
    if (scale > 0) worst = std::max(worst, std::abs(a - b) / scale);
  };
  for (std::size_t i = 0; i < one.impacts.size(); ++i) {
    const Impact &a = one.impacts[i], &b = other.impacts[i];
    EXPECT_EQ(a.point, b.point);
    compare(a.start, b.start, 1);
    compare(a.end, b.end, 1);
    compare(a.closing_speed, b.closing_speed, speed);
    compare(a.separation_speed, b.separation_speed, speed);
    compare(a.peak_force, b.peak_force, force);
    compare(a.impulse, b.impulse, impulse);
  }
  for (std::size_t b = 0; b < one.buildings.size(); ++b) {
    const auto vectors = [&](const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
      compare((x - y).cwiseAbs().maxCoeff(), 0, x.maxCoeff());
    };
    vectors(one.buildings[b].displacement, other.buildings[b].displacement);
    vectors(one.buildings[b].displacement_no_contact, other.buildings[b].displacement_no_contact);
    vectors(one.buildings[b].drift_ratio, other.buildings[b].drift_ratio);
    vectors(one.buildings[b].acceleration, other.buildings[b].acceleration);
    vectors(one.buildings[b].storey_shear, other.buildings[b].storey_shear);
  }
  return worst;
}

std::shared_ptr<const ContactLaw> law(const std::string& label, double effective_mass) {
  for (const LawExample& example : example_laws()) {
    if (example.label == label) return example.make(effective_mass);
  }
  ADD_FAILURE() << label;
  return nullptr;
}

constexpr double mass = 2e5;

ContactPoint point(int left, int floor, double width, const std::string& label) {
  ContactPoint result = contact(width, law(label, mass / 2), left);
  result.left_floor = result.right_floor = floor;
  return result;
}

TEST(ExactAndAdaptive, AgreeOnEveryLawInOneGap) {
  // Two towers with one floor for every law, all of them in contact at times.
  const auto laws = example_laws();
  const int floors = static_cast<int>(laws.size());
  Problem problem = pair(stick(floors, mass, 4e9), stick(floors, mass, 1.5e9), {}, 3.0);
  for (int f = 0; f < floors; ++f) {
    problem.points.push_back(point(0, f, 0.002 * (f + 1), laws[static_cast<std::size_t>(f)].label));
  }
  problem.motion = record();
  problem.delays = {0, 0.07};
  const Response exact = solve(problem), adaptive = solve(problem, AdaptiveSolver{1e-12});
  for (const PointSummary& p : exact.points) EXPECT_GT(p.impacts, 0);
  EXPECT_LE(difference(exact, adaptive), 1e-8);
}

TEST(ExactAndAdaptive, AgreeOnFillersWhoseLossesAddUpToWhatIsCrushed) {
  std::mt19937 random(31);
  const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  int crushed = 0, locked = 0, again = 0;
  for (int n = 0; n < 12; ++n) {
    Problem problem;
    for (const double stiffness : {between(1e8, 2e8), between(0.5e8, 1e8), between(1e8, 2e8)}) {
      problem.buildings.push_back(stick(3, mass, stiffness));
      problem.delays.push_back(between(0, 0.1));
    }
    const double force = between(5e4, 6e5), thickness = between(0.01, 0.06), begins = 0.03, ends = between(0.2, 0.7);
    for (const int left : {0, 1}) {
      for (const int floor : {1, 2}) {
        problem.points.push_back(point(left, floor, between(0, 0.008), "linear"));
        problem.points.back().law = find_law("filler")->make({{{"crushing_force", force},
                                                               {"thickness", thickness},
                                                               {"crushing_strain", begins},
                                                               {"locking_strain", ends},
                                                               {"locked_stiffness", 1e9}},
                                                              {},
                                                              mass / 2});
      }
    }
    problem.motion = record();
    problem.duration = 3.0;
    SolveOptions options;
    options.energy_audit = true;
    const Response exact = solve(problem, ExactSolver{}, options), adaptive = solve(problem, AdaptiveSolver{1e-12});
    EXPECT_LE(difference(exact, adaptive), 1e-8) << n;
    EXPECT_LE(exact.energy->relative_residual(), 1e-13) << n;
    for (const PointSummary& p : exact.points) {
      // (C-26) over all impacts together: what is crushed is remembered from one to the next.
      const double elastic = begins * thickness, most = (ends - begins) * thickness;
      const double of_this = std::clamp(p.peak_penetration - elastic, 0.0, most);
      EXPECT_NEAR(p.energy_lost, force * of_this, 1e-11 * force * thickness) << n;
      crushed += of_this > 0 ? 1 : 0;
      locked += of_this == most ? 1 : 0;
      again += of_this > 0 && p.impacts > 1 ? 1 : 0;
    }
    // No force before the bodies are at what was left of the foam.
    for (const Impact& impact : exact.impacts) EXPECT_GT(impact.closing_speed, 0) << n;
  }
  EXPECT_GT(crushed, 20);
  EXPECT_GT(locked, 3);
  EXPECT_GT(again, 20);
}

/// Nonlinear contact in the outer gaps, straight or instant ones between: while two buildings are an island of
/// nonlinear contact the others fly, or are an island of their own.
Problem row_of_four(const std::string& lowest) {
  Problem problem;
  for (const double stiffness : {2.0e8, 0.7e8, 1.5e8, 0.5e8}) {
    problem.delays.push_back(0.03 * static_cast<double>(problem.buildings.size()));
    problem.buildings.push_back(stick(3, mass, stiffness));
  }
  problem.points = {point(0, 1, 0.01, "hertz_damp"), point(0, 2, 0.012, "jankowski"),
                    point(1, 1, 0.008, "bilinear"),  point(1, 2, 0.01, "kelvin_voigt_zero_force"),
                    point(2, 0, 0.006, lowest),      point(2, 2, 0.01, "hertz")};
  problem.motion = record();
  problem.duration = 3.0;
  return problem;
}

TEST(ExactAndAdaptive, AgreeOnARowOfFour) {
  Problem problem = row_of_four("linear");
  for (const Kinematics kinematics : {Kinematics::relative, Kinematics::absolute}) {
    problem.kinematics = kinematics;
    const Response exact = solve(problem), adaptive = solve(problem, AdaptiveSolver{1e-12});
    for (const PointSummary& p : exact.points) EXPECT_GT(p.impacts, 0);
    EXPECT_LE(difference(exact, adaptive), 1e-8);
    // Islands of their own: impacts of both outer gaps that overlap in time.
    bool overlap = false;
    for (const Impact& a : exact.impacts) {
      for (const Impact& b : exact.impacts) {
        overlap = overlap || (a.point <= 1 && b.point == 5 && a.start < b.end && b.start < a.end);
      }
    }
    EXPECT_TRUE(overlap);
  }
}

TEST(ExactAndAdaptive, AgreeOnARowOfFourThatRestsAtTimes) {
  const Problem problem = row_of_four("restitution");
  EXPECT_LE(difference(solve(problem), solve(problem, AdaptiveSolver{1e-12})), 1e-8);
}

TEST(ExactAndAdaptive, AgreeWhereAnIntegratedContactBeginsBesideOneThatRests) {
  // A free building is pushed against one with a spring, on which it rests, and both meet a third one.
  for (const std::string label : {"hertz", "jankowski"}) {
    Problem problem;
    problem.buildings = {oscillator(mass, 0), oscillator(mass, 2e7), oscillator(mass, 4e8)};
    problem.points = {point(0, 0, 0, "restitution"), point(1, 0, 0.02, label)};
    problem.motion = SampledMotion{0.5, {-4, -4, -4}};
    problem.duration = 0.5;
    SolveOptions options;
    options.energy_audit = true;
    const Response exact = solve(problem, ExactSolver{}, options);
    Response adaptive = solve(problem, AdaptiveSolver{1e-12});
    EXPECT_LE(exact.energy->relative_residual(), 1e-9);
    ASSERT_GE(exact.impacts.size(), 2u);
    ASSERT_EQ(adaptive.impacts.size(), exact.impacts.size());
    // The first two touch and are pressed by the fourth power of time: when that leaves round-off depends on the steps.
    EXPECT_NEAR(exact.impacts[0].start, adaptive.impacts[0].start, 1e-4);
    adaptive.impacts[0].start = exact.impacts[0].start;
    EXPECT_LT(exact.impacts[0].start, exact.impacts[1].start);
    EXPECT_GT(exact.impacts[0].end, exact.impacts[1].start);
    EXPECT_LE(difference(exact, adaptive), 1e-8) << label;
  }
}

TEST(ExactAndAdaptive, AgreeOnADampingMatrixThatModesDoNotDiagonalise) {
  Problem problem = pair(stick(2, mass, 2e8), stick(2, mass, 0.6e8), {}, 2.0);
  MatrixXd c = 0.003 * problem.buildings[0].model.stiffness;
  c(0, 0) *= 3;
  problem.buildings[0] = matrix_building(problem.buildings[0].model.mass, problem.buildings[0].model.stiffness, c);
  problem.motion = record();
  for (const std::string label : {"kelvin_voigt_approach", "jankowski", "restitution"}) {
    problem.points = {point(0, 0, 0.005, label), point(0, 1, 0.008, label)};
    const Response exact = solve(problem), adaptive = solve(problem, AdaptiveSolver{1e-12});
    EXPECT_GT(exact.impacts.size(), 2u);
    EXPECT_LE(difference(exact, adaptive), 1e-8) << label;
  }
}

/// Two sticks of one or two floors and what shakes them, by chance.
Problem random_pair(std::mt19937& random, const std::string& label) {
  const auto between = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const int floors = std::uniform_int_distribution<int>(1, 2)(random);
  Problem problem = pair(stick(floors, mass, between(0.3e8, 3e8)), stick(floors, mass, between(0.3e8, 3e8)), {}, 2.0);
  for (int f = 0; f < floors; ++f) problem.points.push_back(point(0, f, between(0.0, 0.03), label));
  SampledMotion motion{0.02, {0.0}};
  for (int i = 0; i < 90; ++i) motion.acceleration.push_back(0.8 * motion.acceleration.back() + between(-2.0, 2.0));
  problem.motion = motion;
  problem.delays = {between(0.0, 0.3), 0.0};
  return problem;
}

TEST(ExactAndAdaptive, AgreeOnPairsByChance) {
  // One-storey buildings have few quantities, so that bounds settle nearly everything; dampers make accelerations jump.
  std::mt19937 random(1);
  int impacts = 0;
  for (const std::string label : {"linear", "kelvin_voigt_overdamped", "kelvin_voigt_approach", "restitution"}) {
    for (int n = 0; n < 30; ++n) {
      const Problem problem = random_pair(random, label);
      const Response exact = solve(problem), adaptive = solve(problem, AdaptiveSolver{1e-11});
      EXPECT_LE(difference(exact, adaptive), 1e-6) << label << ' ' << n;
      impacts += static_cast<int>(exact.impacts.size());
    }
  }
  EXPECT_GT(impacts, 500);
}

/// The same with every acceleration so many times larger.
Problem scaled(Problem problem, double factor) {
  for (double& value : std::get<SampledMotion>(problem.motion).acceleration) value *= factor;
  return problem;
}

TEST(ScaledFreeResponse, IsThatOfTheScaledMotion) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> logarithm(-2.0, 2.0);
  std::size_t impacts = 0;
  for (const std::string label : {"linear", "kelvin_voigt_overdamped", "kelvin_voigt_separation", "kelvin_voigt_creep",
                                  "kelvin_voigt_approach", "restitution"}) {
    for (int n = 0; n < 20; ++n) {
      SCOPED_TRACE(label + ' ' + std::to_string(n));
      Problem base = random_pair(random, label);
      if (n % 2 == 0) base.kinematics = Kinematics::absolute;
      if (n % 3 == 0) base.links = {{.law = std::make_shared<SpringDashpot>(1e7, 2e5)}};
      const Problem problem = scaled(base, std::exp(logarithm(random)));
      const SolveOptions options{.output_step = 0.05, .energy_audit = true};
      const std::optional<FreeResponse> free = FreeResponse(base).scaled(problem);
      ASSERT_TRUE(free);
      const Response one = free->solve(problem, options), other = solve(problem, ExactSolver{}, options);
      ASSERT_EQ(one.impacts.size(), other.impacts.size());
      EXPECT_LE(difference(one, other), 1e-9);
      for (std::size_t b = 0; b < 2; ++b) {
        const BuildingPeaks &peaks = one.buildings[b], &long_way = other.buildings[b];
        EXPECT_LE((peaks.displacement_no_contact - long_way.displacement_no_contact).norm(),
                  1e-13 * long_way.displacement_no_contact.norm());
        EXPECT_LE((one.histories.displacement[b] - other.histories.displacement[b]).norm(),
                  1e-9 * other.histories.displacement[b].norm());
      }
      for (std::size_t i = 0; i < one.impacts.size(); ++i) {
        EXPECT_NEAR(one.impacts[i].impulse, other.impacts[i].impulse, 1e-8 * mass) << i;
        EXPECT_NEAR(one.impacts[i].energy_lost, other.impacts[i].energy_lost, 1e-8 * mass) << i;
      }
      EXPECT_NEAR(one.energy->peak_input, other.energy->peak_input, 1e-9 * other.energy->peak_input);
      impacts += one.impacts.size();
    }
  }
  EXPECT_GT(impacts, 500U);
}

TEST(ScaledFreeResponse, IsNothingWhereItIsNoMultiple) {
  std::mt19937 random(8);
  const Problem base = random_pair(random, "linear");
  const FreeResponse free(base);
  Problem other = scaled(base, 2);
  std::get<SampledMotion>(other.motion).acceleration[40] *= 1.001;
  EXPECT_FALSE(free.scaled(other)) << "another motion";
  EXPECT_FALSE(free.scaled(scaled(base, -2))) << "what is to the left is not what is to the right";
  Problem moving = scaled(base, 2);
  moving.initial_velocity = {Eigen::VectorXd::Ones(base.buildings[0].model.dofs()),
                             Eigen::VectorXd::Zero(base.buildings[1].model.dofs())};
  EXPECT_FALSE(free.scaled(moving)) << "not from rest";
  EXPECT_FALSE(FreeResponse(base, AdaptiveSolver{}).scaled(scaled(base, 2)));
  Problem cable = scaled(base, 2);
  cable.links = {{.law = std::make_shared<Cable>(1e7, 0.01)}};
  EXPECT_FALSE(free.scaled(cable)) << "slack is a length";
  Problem hertz = scaled(base, 2);
  for (ContactPoint& at : hertz.points) at.law = point(0, 0, 0.0, "hertz").law;
  EXPECT_THROW((void)free.scaled(hertz)->solve(hertz), InvalidParameter);
}

}  // namespace
}  // namespace bentur
