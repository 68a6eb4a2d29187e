// Rows of buildings by chance that yield, pound and are linked: `exact` against `adaptive`, which share no way of
// stepping; their mirror images; and where the energy went.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "bentur/pounding/pounding.h"
#include "tests/support/random_numbers.h"
#include "tests/support/random_yielding.h"

namespace bentur::random_yielding {
namespace {

using Eigen::VectorXd;
using namespace bentur::test;

/// What two ways to solve one case may differ by, relative to the largest number of the kind, and the energy that may
/// be missed, as a part of the input.
struct Allowed {
  double difference, energy;
};
Allowed allowed(const RandomYielding& random) {
  // Steps of `adaptive`, of 1e-11, add up over thousands of them; contacts that are integrated by `exact` have 1e-10
  // and begin by steps that know nothing of one another.
  return random.straight ? Allowed{1e-6, 1e-9} : Allowed{1e-6, 1e-7};
}
// A case that numbers moved by 1e-12 move by more than this is too sensitive to say more of it than that.
constexpr double moved_by = 1e-12, amplifies = 1e4;

/// How far two responses are apart, and in what.
struct Apart {
  double size = 0;
  std::string what;
  void note(const VectorXd& a, const VectorXd& b, double scale, const std::string& of) {
    if (a.size() != b.size()) {
      *this = {std::numeric_limits<double>::infinity(), of + ": sizes"};
      return;
    }
    for (Eigen::Index i = 0; i < a.size(); ++i) {
      if (std::isnan(a(i)) && std::isnan(b(i))) continue;  // a ductility of what cannot yield
      const double by = a(i) == b(i) ? 0 : std::abs(a(i) - b(i)) / scale;
      if (by > size || std::isnan(by)) {
        size = std::isnan(by) ? std::numeric_limits<double>::infinity() : by;
        what = fmt::format("{} {}: {:.17g} and {:.17g}", of, i, a(i), b(i));
      }
    }
  }
};

double greatest(const VectorXd& list) {
  double most = std::numeric_limits<double>::min();
  for (const double x : list) most = std::isnan(x) ? most : std::max(most, std::abs(x));
  return most;
}

void note_yielding(Apart& apart, const BuildingPeaks::Yielding& a, const BuildingPeaks::Yielding& b, double drift,
                   double energy, const std::string& of) {
  if (a.ductility.size() + b.ductility.size() == 0) return;
  apart.note(a.ductility, b.ductility, greatest(a.ductility), of + "ductility");
  apart.note(a.residual_drift_ratio, b.residual_drift_ratio, drift, of + "residual");
  apart.note(a.hysteretic_energy, b.hysteretic_energy, energy, of + "hysteretic energy");
}

Apart difference(const Response& one, const Response& other) {
  Apart apart;
  if (one.status != Status::done || other.status != Status::done) {
    return {std::numeric_limits<double>::infinity(), "status: " + one.message + other.message};
  }
  // What a building does, its neighbours do to it: kinds of numbers have one scale for the row.
  const auto scale = [&one](VectorXd BuildingPeaks::*member) {
    double most = std::numeric_limits<double>::min();
    for (const BuildingPeaks& peaks : one.buildings) most = std::max(most, greatest(peaks.*member));
    return most;
  };
  const double x = scale(&BuildingPeaks::displacement), drift = scale(&BuildingPeaks::drift_ratio),
               shear = scale(&BuildingPeaks::storey_shear), energy = one.energy->peak_input;
  for (std::size_t b = 0; b < one.buildings.size(); ++b) {
    const BuildingPeaks &a = one.buildings[b], &z = other.buildings[b];
    const std::string of = fmt::format("building {}, ", b);
    apart.note(a.displacement, z.displacement, x, of + "displacement");
    apart.note(a.displacement_no_contact, z.displacement_no_contact, x, of + "free displacement");
    apart.note(a.drift_ratio, z.drift_ratio, drift, of + "drift");
    apart.note(a.storey_shear, z.storey_shear, shear, of + "shear");
    note_yielding(apart, a.yielding, z.yielding, drift, energy, of);
    note_yielding(apart, a.yielding_no_contact, z.yielding_no_contact, drift, energy, of + "free ");
  }
  for (std::size_t i = 0; i < one.links.size(); ++i) {
    const auto ways = [](const LinkSummary& l) { return Eigen::Vector2d(l.peak_closing, l.peak_opening); };
    const auto forces = [](const LinkSummary& l) { return Eigen::Vector2d(l.peak_compression, l.peak_tension); };
    const auto lost = [](const LinkSummary& l) { return VectorXd::Constant(1, l.energy_dissipated); };
    apart.note(ways(one.links[i]), ways(other.links[i]), x, fmt::format("link {}, way", i));
    apart.note(forces(one.links[i]), forces(other.links[i]), std::max(shear, greatest(forces(one.links[i]))),
               fmt::format("link {}, force", i));
    apart.note(lost(one.links[i]), lost(other.links[i]), energy, fmt::format("link {}, energy", i));
  }
  return apart;
}

Response audited(const Problem& problem, const Solver& solver) {
  SolveOptions options;
  options.energy_audit = true;
  options.limits.steps = 20'000'000;
  return solve(problem, solver, options);
}

/// Gaps wider and narrower, and the motion stronger, by parts of 1e-12.
Problem moved(Problem problem, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(-moved_by, moved_by);
  for (ContactPoint& point : problem.points) point.width *= 1 + part(random);
  if (auto* sampled = std::get_if<SampledMotion>(&problem.motion)) {
    for (double& a : sampled->acceleration) a *= 1 + part(random);
  }
  if (auto* harmonic = std::get_if<HarmonicMotion>(&problem.motion))
    harmonic->displacement_amplitude *= 1 + part(random);
  for (VectorXd& v : problem.initial_velocity) v *= 1 + part(random);
  return problem;
}

/// A law whose answer to −δ is that of this one to δ, negated.
std::shared_ptr<const HystereticLaw> mirrored(const std::shared_ptr<const HystereticLaw>& law) {
  const auto* const uneven = dynamic_cast<const BackboneLaw*>(law.get());
  if (law->is_odd() || uneven == nullptr) return law;
  BackboneLaw::Parameters of = uneven->made_of();
  std::swap(of.positive, of.negative);
  return std::make_shared<BackboneLaw>(of);
}

Problem mirrored(Problem problem) {
  const Eigen::Index last = std::ssize(problem.buildings) - 1;
  // δ = x_left − x_right of links is the same in a mirror, drifts are not.
  for (Building& building : problem.buildings) {
    for (BuildingElement& element : building.elements) element.law = mirrored(element.law);
  }
  std::reverse(problem.buildings.begin(), problem.buildings.end());
  std::reverse(problem.delays.begin(), problem.delays.end());
  std::reverse(problem.initial_displacement.begin(), problem.initial_displacement.end());
  std::reverse(problem.initial_velocity.begin(), problem.initial_velocity.end());
  for (VectorXd& x : problem.initial_displacement) x = -x;
  for (VectorXd& v : problem.initial_velocity) v = -v;
  for (ContactPoint& point : problem.points) {
    point.left = point.gap = last - 1 - point.left;
    point.right = point.left + 1;
    std::swap(point.left_floor, point.right_floor);
  }
  std::stable_sort(problem.points.begin(), problem.points.end(),
                   [](const ContactPoint& a, const ContactPoint& b) { return a.left < b.left; });
  for (Link& link : problem.links) {
    const Eigen::Index left = link.left;
    link.left = last - link.right;
    link.right = last - left;
    std::swap(link.left_floor, link.right_floor);
  }
  if (auto* sampled = std::get_if<SampledMotion>(&problem.motion)) {
    for (double& a : sampled->acceleration) a = -a;
  }
  if (auto* harmonic = std::get_if<HarmonicMotion>(&problem.motion)) harmonic->displacement_amplitude *= -1;
  return problem;
}

Response mirrored_back(Response response) {
  std::reverse(response.buildings.begin(), response.buildings.end());
  for (BuildingPeaks& peaks : response.buildings) {
    for (auto* yielding : {&peaks.yielding, &peaks.yielding_no_contact}) {
      yielding->residual_drift_ratio = -yielding->residual_drift_ratio;
    }
  }
  return response;
}

/// BENTUR_RANDOM_YIELDING=FIRST:COUNT runs others than those that the test always runs.
std::pair<unsigned, unsigned> chosen() { return test::seeds_of("BENTUR_RANDOM_YIELDING", {1, 60}, {1, 8}); }

void expect_same(const RandomYielding& random, const Response& base, const Response& other, unsigned seed,
                 int& sensitive, const char* what) {
  const Apart apart = difference(base, other);
  if (apart.size <= allowed(random).difference) return;
  double most = 0;
  for (unsigned i = 0; i < 6 && amplifies * most < apart.size; ++i) {
    most = std::max(most, difference(base, audited(moved(random.problem, i), ExactSolver{})).size);
  }
  if (amplifies * most >= apart.size) {
    ++sensitive;
    return;
  }
  ADD_FAILURE() << "case " << seed << ", " << what << ": " << apart.what << ", apart by " << apart.size
                << "; by perturbations " << most;
}

class RandomYieldingRows : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(, RandomYieldingRows, testing::Bool(),
                         [](const auto& one) { return one.param ? "LosingStrength" : "KeepingStrength"; });

TEST_P(RandomYieldingRows, AreTheSameByAnotherSolverAndInAMirror) {
  const bool softening = GetParam();
  auto [first, count] = chosen();
  if (softening) count = std::max(1U, count / 3);
  int sensitive = 0, yielding = 0;
  long impacts = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    const RandomYielding random = YieldingGenerator(seed, softening).make();
    const Problem& problem = random.problem;
    const Response exact = audited(problem, ExactSolver{});
    ASSERT_EQ(exact.status, Status::done) << "case " << seed << ": " << exact.message;
    impacts += static_cast<long>(exact.impacts.size());
    EXPECT_LE(exact.energy->relative_residual(), allowed(random).energy) << "case " << seed;
    bool yields = false;
    for (const BuildingPeaks& peaks : exact.buildings) {
      for (const auto* is : {&peaks.yielding, &peaks.yielding_no_contact}) {
        for (const double energy : is->hysteretic_energy) {
          // Where unloading softens with each turn, more comes back than was left by the turn before.
          EXPECT_GE(energy, -(softening ? 1e-2 : 1e-12) * exact.energy->peak_input) << "case " << seed;
          yields = yields || energy > 1e-6 * exact.energy->peak_input;
        }
      }
    }
    for (const LinkSummary& link : exact.links) {
      EXPECT_GE(link.energy_dissipated, -(softening ? 1e-2 : 1e-9) * exact.energy->peak_input) << "case " << seed;
    }
    yielding += yields ? 1 : 0;
    expect_same(random, exact, audited(problem, AdaptiveSolver{1e-11}), seed, sensitive, "adaptive");
    const Response other = mirrored_back(audited(mirrored(problem), ExactSolver{}));
    expect_same(random, exact, other, seed, sensitive, "mirrored");
  }
  fmt::print("{} cases, {} impacts, {} of them yield, {} comparisons too sensitive\n", count, impacts, yielding,
             sensitive);
  if (count < 20) return;
  EXPECT_GT(yielding, static_cast<int>(count) / 2);
  EXPECT_GT(impacts, 2 * static_cast<long>(count));
  EXPECT_LT(sensitive, 0.3 * count);
}

/// Every number of a history within its peak, as each run checks itself; storeys that lose strength, alike on both
/// sides or not, worn or not.
TEST(RandomYieldingMirror, IsTheRowItselfHoweverUneven) {
  auto [first, count] = chosen();
  count *= 2;
  int sensitive = 0, uneven = 0, worn = 0, weaker_side = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    const RandomYielding random = YieldingGenerator(1000 + seed, true).make();
    SolveOptions options{.output_step = 0.003, .energy_audit = true};
    const Response exact = solve(random.problem, ExactSolver{}, options);
    ASSERT_EQ(exact.status, Status::done) << "case " << seed << ": " << exact.message;
    for (const Discrepancy& found : exact.discrepancies) {
      EXPECT_NE(found.key, "check_peaks") << found.size << ", case " << seed;
    }
    const Response other = mirrored_back(audited(mirrored(random.problem), ExactSolver{}));
    expect_same(random, exact, other, seed, sensitive, "mirrored");
    for (std::size_t b = 0; b < exact.buildings.size(); ++b) {
      for (const BuildingElement& element : random.problem.buildings[b].elements) {
        if (!element.law->yields_unevenly()) continue;
        ++uneven;
        const Deterioration& wear = dynamic_cast<const BackboneLaw&>(*element.law).made_of().deterioration;
        worn += std::isfinite(std::min({wear.strength, wear.cap, wear.reloading, wear.unloading})) ? 1 : 0;
        // Of one side alone it would be another number.
        const double drift = exact.buildings[b].drift_ratio(element.storey) *
                             random.problem.buildings[b].model.storey_heights[element.storey];
        const double ductility = exact.buildings[b].yielding.ductility(element.storey);
        EXPECT_GE(ductility, (1 - 1e-9) * drift /
                                 std::max(element.law->yield_deformation(), element.law->yield_deformation_below()));
        EXPECT_LE(ductility, (1 + 1e-9) * drift /
                                 std::min(element.law->yield_deformation(), element.law->yield_deformation_below()));
        weaker_side += ductility > (1 + 1e-9) * drift / element.law->yield_deformation() ? 1 : 0;
      }
    }
  }
  fmt::print(
      "{} cases, {} uneven storeys, {} of them wear, {} with more ductility to the lower side, {} too sensitive\n",
      count, uneven, worn, weaker_side, sensitive);
  if (count < 20) return;
  EXPECT_GT(uneven, static_cast<int>(count));
  EXPECT_GT(worn, static_cast<int>(count) / 2);
  EXPECT_GT(weaker_side, 0);
  EXPECT_LT(sensitive, 0.3 * count);
}

}  // namespace
}  // namespace bentur::random_yielding
