// With storeys that yield and links too: sampling changes nothing, a free response kept gives what solving anew gives,
// samples stay within the peaks, and the monograph's scheme comes to the same.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bentur/contact/laws/linear.h"
#include "tests/support/random_yielding.h"
#include "tests/support/same_response.h"

namespace bentur::reused_runs {
namespace {

using namespace bentur::test;

void expect_same_numbers(const Eigen::VectorXd& one, const Eigen::VectorXd& other) {
  ASSERT_EQ(one.size(), other.size());
  for (Eigen::Index i = 0; i < one.size(); ++i) {
    EXPECT_TRUE(one(i) == other(i) || (std::isnan(one(i)) && std::isnan(other(i)))) << one(i) << ' ' << other(i);
  }
}

void expect_same_yielding(const Response& one, const Response& other) {
  for (std::size_t b = 0; b < one.buildings.size(); ++b) {
    for (const auto which : {&BuildingPeaks::yielding, &BuildingPeaks::yielding_no_contact}) {
      const auto &a = one.buildings[b].*which, &z = other.buildings[b].*which;
      expect_same_numbers(a.ductility, z.ductility);
      expect_same_numbers(a.residual_drift_ratio, z.residual_drift_ratio);
      expect_same_numbers(a.hysteretic_energy, z.hysteretic_energy);
    }
  }
  ASSERT_EQ(one.links.size(), other.links.size());
  for (std::size_t i = 0; i < one.links.size(); ++i) {
    EXPECT_EQ(one.links[i].peak_closing, other.links[i].peak_closing);
    EXPECT_EQ(one.links[i].peak_opening, other.links[i].peak_opening);
    EXPECT_EQ(one.links[i].peak_compression, other.links[i].peak_compression);
    EXPECT_EQ(one.links[i].peak_tension, other.links[i].peak_tension);
    EXPECT_EQ(one.links[i].energy_dissipated, other.links[i].energy_dissipated);
  }
}

TEST(YieldingRuns, AreNotChangedByLooking) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const Problem problem = YieldingGenerator(seed).make().problem;
    SolveOptions looked;
    looked.output_step = 0.0137;
    looked.energy_audit = true;
    for (const Solver& solver : {Solver(ExactSolver{}), Solver(AdaptiveSolver{1e-9})}) {
      const Response one = solve(problem, solver), other = solve(problem, solver, looked);
      expect_same(one, other);
      expect_same_yielding(one, other);
    }
  }
}

TEST(YieldingRuns, AreTheSameFromAFreeResponseThatIsKept) {
  // A long record, so that the response with contact is taken up far from its start, where storeys have yielded.
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    Problem problem = YieldingGenerator(seed).make().problem;
    SampledMotion motion{0.02, {}};
    std::mt19937 random(seed);
    std::normal_distribution<double> number(0, 1);
    for (int i = 0; i < 500; ++i) motion.acceleration.push_back(0.008 * i * number(random));
    problem.motion = motion;
    problem.duration = 10;
    problem.initial_displacement.clear();
    problem.initial_velocity.clear();
    const FreeResponse free(problem);
    for (const double width : {0.2, 0.1, 0.05}) {
      for (ContactPoint& point : problem.points) point.width = width;
      const Response kept = free.solve(problem), anew = solve(problem);
      ASSERT_EQ(anew.status, Status::done) << anew.message;
      expect_same(kept, anew);
      expect_same_yielding(kept, anew);
    }
  }
}

TEST(YieldingRuns, HaveSamplesWithinTheirPeaks) {
  for (unsigned seed = 101; seed <= 130; ++seed) {
    SCOPED_TRACE(seed);
    const Problem problem = YieldingGenerator(seed).make().problem;
    SolveOptions options;
    options.output_step = problem.duration / 3000;
    const Response response = solve(problem, ExactSolver{}, options);
    for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
      const BuildingPeaks& peaks = response.buildings[b];
      for (Eigen::Index j = 0; j < peaks.drift_ratio.size(); ++j) {
        const auto near = [&](const Eigen::MatrixXd& samples, double peak) {
          const double most = samples.row(j).cwiseAbs().maxCoeff();
          // Both are sums over the modes, with the round-off of these: relative to what is largest in the building, not
          // to the shear of a top storey, which is a small difference of large terms (by another mathematical library
          // 1/140 of the base's, and 100 ε of the base's beyond its peak).
          EXPECT_LE(most, peak + 1e-13 * samples.cwiseAbs().maxCoeff());
          EXPECT_GE(most, 0.98 * peak) << "storey " << j << " of " << b;
        };
        near(response.histories.displacement[b], peaks.displacement(j));
        near(response.histories.drift_ratio[b], peaks.drift_ratio(j));
        near(response.histories.storey_shear[b], peaks.storey_shear(j));
        const HystereticLaw* law = problem.buildings[b].storey_law(j);
        if (law == nullptr) continue;
        EXPECT_NEAR(peaks.yielding.ductility(j) * law->yield_deformation(), peaks.drift_ratio(j),
                    1e-12 * peaks.drift_ratio(j));  // storeys are 1 high
      }
    }
  }
}

TEST(YieldingRuns, ComeToTheSameByTheMonographsScheme) {
  Problem problem = pair(yielding_oscillator(3, 1200, 25, 0.05, 0.03), yielding_oscillator(2, 2500, 30, 0.1, 0.05),
                         {contact(0.02, 1e5)}, 3);
  SampledMotion motion{0.02, {}};
  for (int i = 0; i < 120; ++i) motion.acceleration.push_back(8 * std::sin(0.31 * i) + 5 * std::sin(0.013 * i * i));
  problem.motion = motion;
  problem.delays = {0, 0.05};
  Link link;
  link.elevation = 1;
  link.law = bilinear_law(300, 4);
  problem.links = {link};
  const Response exact = solved(problem, ExactSolver{});
  ASSERT_GT(exact.impacts.size(), 5u);
  double before = 1;
  for (const double step : {2e-3, 5e-4, 1.25e-4}) {
    const Response other = solve(problem, RungeKuttaSolver{step});
    ASSERT_EQ(other.status, Status::done) << other.message;
    double error = 0;
    for (std::size_t b = 0; b < 2; ++b) {
      const BuildingPeaks &a = exact.buildings[b], &z = other.buildings[b];
      error = std::max(error, std::abs(z.displacement(0) / a.displacement(0) - 1));
      error = std::max(error, std::abs(z.yielding.hysteretic_energy(0) / a.yielding.hysteretic_energy(0) - 1));
      error = std::max(error, std::abs(z.storey_shear(0) / a.storey_shear(0) - 1));
    }
    error = std::max(error, std::abs(other.links[0].energy_dissipated / exact.links[0].energy_dissipated - 1));
    EXPECT_LT(error, 0.5 * before) << step;
    before = error;
  }
  EXPECT_LT(before, 1e-6);
}

}  // namespace
}  // namespace bentur::reused_runs
