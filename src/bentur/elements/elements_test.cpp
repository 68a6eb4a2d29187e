// What every law with linear branches owes, laws that yield and links, and what single ones do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/elements/kinematic_hardening.h"
#include "bentur/elements/link_laws.h"
#include "bentur/elements/peak_oriented.h"
#include "tests/support/led_element.h"

namespace bentur {
namespace {

using test::LedElement;

// Of a storey of [kN, m]: yields at 0.02 m.
constexpr double stiffness = 15e3, yield_force = 300, yield_deformation = yield_force / stiffness;

// Places of events are known to 1e-13 of the yield deformation (LedElement), forces and slopes are of order one of it.
constexpr double round_off = 1e-11;

struct ElementExample {
  std::string label;
  std::shared_ptr<const Law> law;
  bool same_both_ways = true;  // F(−δ) = −F(δ)
};

void PrintTo(const ElementExample& example, std::ostream* out) { *out << example.label; }

std::vector<ElementExample> element_examples() {
  std::vector<ElementExample> list = {
      {"spring", std::make_shared<SpringDashpot>(stiffness, 0)},
      {"dashpot", std::make_shared<SpringDashpot>(0, 1e3)},
      {"cable", std::make_shared<Cable>(stiffness, 0.7 * yield_deformation), false},
      {"cable_without_slack", std::make_shared<Cable>(stiffness, 0), false},
  };
  for (const double r : {0.0, 0.05, 0.3, 0.9}) {
    list.push_back({"bilinear_" + std::to_string(static_cast<int>(100 * r)),
                    std::make_shared<KinematicHardening>(stiffness, yield_force, r)});
  }
  for (const double a : {0.0, 0.4, 1.0}) {
    for (const double r : {0.0, 0.05, 0.3}) {
      list.push_back({"peak_oriented_" + std::to_string(static_cast<int>(10 * a)) + "_" +
                          std::to_string(static_cast<int>(100 * r)),
                      std::make_shared<PeakOriented>(stiffness, yield_force, r, a)});
    }
  }
  return list;
}

/// Turning points of a path: some within the elastic range, some tiny, most up to eight times the yield deformation.
std::vector<double> turning_points(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<double> points;
  double last = 0;
  for (int i = 0; i < 40; ++i) {
    const double kind = std::abs(number(random)), x = number(random);
    last = kind < 0.2   ? x * yield_deformation
           : kind < 0.4 ? std::clamp(last + 0.3 * x * yield_deformation, -8 * yield_deformation, 8 * yield_deformation)
           : kind < 0.6 ? 0.8 * last
                        : 8 * x * yield_deformation;
    points.push_back(last);
  }
  return points;
}

class EveryElement : public testing::TestWithParam<ElementExample> {
 protected:
  const Law& law_ = *GetParam().law;
};

INSTANTIATE_TEST_SUITE_P(, EveryElement, testing::ValuesIn(element_examples()),
                         [](const auto& one) { return one.param.label; });

TEST_P(EveryElement, ChangesItsBranchWithoutAJumpAndInsideTheNextOne) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    LedElement element(law_, yield_deformation);
    for (const double point : turning_points(seed)) element.lead_to(point);
    for (const LedElement::Change& change : element.changes()) {
      ASSERT_NEAR(change.force_after, change.force_before, round_off * yield_force) << change.from << "→" << change.to;
      ASSERT_NEAR(change.stored_after, change.stored_before, round_off * yield_force * yield_deformation)
          << change.from << "→" << change.to << " seed " << seed;
    }
  }
}

TEST_P(EveryElement, HasGuardsThatHoldWhereTheBranchBegins) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    LedElement element(law_, yield_deformation);
    for (const double point : turning_points(seed)) element.lead_to(point);
    for (const LedElement::Change& change : element.changes()) {
      ASSERT_GE(change.least_guard, -1e-12 * yield_deformation) << change.from << "→" << change.to;
    }
  }
}

TEST_P(EveryElement, StoresEnergyAndNeverGivesBackWhatItDissipated) {
  const double unit = yield_force * yield_deformation;
  for (unsigned seed = 0; seed < 200; ++seed) {
    LedElement element(law_, yield_deformation);
    double dissipated = 0;
    for (const double point : turning_points(seed)) {
      const double start = element.deformation();
      for (int part = 1; part <= 20; ++part) {
        element.lead_to(start + (point - start) * part / 20);
        ASSERT_GE(element.stored(), 0);
        ASSERT_GE(element.hysteretic(), dissipated - round_off * unit) << seed << ' ' << element.state().branch;
        dissipated = element.hysteretic();
      }
    }
  }
}

TEST_P(EveryElement, GivesBackWhatItSaysWhenUnloaded) {
  // Unloaded slowly until no force is left: the work done on the way back is the energy stored.
  for (unsigned seed = 0; seed < 200; ++seed) {
    LedElement element(law_, yield_deformation);
    for (const double point : turning_points(seed)) element.lead_to(point);
    const auto* yields = dynamic_cast<const HystereticLaw*>(&law_);
    if (yields == nullptr || law_.name() == "bilinear") continue;  // bilinear: below, it comes to rest on the way
    const double stored = element.stored(), work = element.work();
    element.lead_to(yields->residual(element.state(), element.deformation()));
    EXPECT_NEAR(element.force(), 0, round_off * yield_force);
    EXPECT_NEAR(work - element.work(), stored, round_off * yield_force * yield_deformation);
  }
}

TEST_P(EveryElement, IsTheSameBothWays) {
  if (!GetParam().same_both_ways) return;
  for (unsigned seed = 0; seed < 100; ++seed) {
    LedElement one(law_, yield_deformation), mirrored(law_, yield_deformation);
    for (const double point : turning_points(seed)) {
      one.lead_to(point);
      mirrored.lead_to(-point);
      ASSERT_EQ(one.force(), -mirrored.force());
      ASSERT_EQ(one.stored(), mirrored.stored());
      ASSERT_EQ(one.work(), mirrored.work());
    }
  }
}

TEST_P(EveryElement, IsNeverStifferThanAtFirstNorHasANegativeSlope) {
  // What the growth bound of the power series rests on (docs/theory/elements.md).
  const auto* yields = dynamic_cast<const HystereticLaw*>(&law_);
  if (yields == nullptr) return;
  EXPECT_EQ(law_.branch({}).stiffness, yields->initial_stiffness());
  EXPECT_EQ(law_.branch({}).base, 0);
  for (unsigned seed = 0; seed < 200; ++seed) {
    LedElement element(law_, yield_deformation);
    for (const double point : turning_points(seed)) {
      element.lead_to(point);
      const Branch branch = law_.branch(element.state());
      ASSERT_GE(branch.stiffness, 0);
      ASSERT_LE(branch.stiffness, stiffness * (1 + 1e-15));
    }
  }
}

TEST_P(EveryElement, PassesOnWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(law_.force({.branch = law_.name() == "cable" ? 1 : 0}, nan, nan)));
}

/// (L-1) in another form: a spring k and a slider with a back stress H ε_p, H = r k/(1 − r), by return mapping.
struct ReturnMapping {
  double k, vy, r;
  double slip = 0, deformation = 0, slid = 0;  // ε_p, Δ, ∫|dε_p|
  [[nodiscard]] double force() const { return k * (deformation - slip); }
  void lead_to(double target) {
    deformation = target;
    const double back = r * k / (1 - r), trial = k * (target - slip) - back * slip;
    const double beyond = std::abs(trial) - vy;
    if (beyond <= 0) return;
    slip += std::copysign(beyond / (k + back), trial);
    slid += beyond / (k + back);
  }
};

TEST(KinematicHardening, IsWhatReturnMappingGives) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> hardening(0, 0.95);
  for (unsigned path = 0; path < 1000; ++path) {
    const double r = path % 4 == 0 ? 0 : hardening(random);
    const KinematicHardening law(stiffness, yield_force, r);
    LedElement element(law, yield_deformation);
    ReturnMapping other{stiffness, yield_force, r};
    for (const double point : turning_points(path)) {
      element.lead_to(point);
      other.lead_to(point);
      ASSERT_NEAR(element.force(), other.force(), round_off * yield_force) << path;
      // Once slid, the slider's friction V_y works on its slip: what is lost for good.
      ASSERT_NEAR(element.hysteretic(), yield_force * other.slid, 100 * round_off * yield_force * yield_deformation);
      ASSERT_NEAR(law.residual(element.state(), point), other.slip, round_off * yield_deformation);
    }
  }
}

TEST(KinematicHardening, HasTheLoopAreaOfItsClosedForm) {
  for (const double r : {0.0, 0.1, 0.5}) {
    for (const double amplitude : {1.0, 1.5, 4.0}) {
      const KinematicHardening law(stiffness, yield_force, r);
      LedElement element(law, yield_deformation);
      const double d = amplitude * yield_deformation;
      element.lead_to(d);
      double work = element.work();
      for (int cycle = 0; cycle < 3; ++cycle) {
        element.lead_to(-d);
        element.lead_to(d);
        EXPECT_NEAR(element.work() - work, 4 * (1 - r) * yield_force * (d - yield_deformation),
                    1e-11 * yield_force * d);
        work = element.work();
      }
    }
  }
}

/// (L-2) in another form: the straight line on which it may go to and fro, with ends, and how it goes on beyond them.
struct WindowOfReturn {
  double k, vy, r, a;
  double extreme[2] = {vy / k, vy / k};  // below and above zero
  double deformation = 0, force = 0, work = 0;
  struct Place {
    double deformation, force;
  };
  Place low = {-vy / k, -vy}, high = {vy / k, vy};

  void lead_to(double target) {
    const double way = target < deformation ? -1 : 1;
    while (deformation != target) {
      const Place& end = way > 0 ? high : low;
      if (way * deformation < way * end.deformation) {  // within the window
        const double slope = (high.force - low.force) / (high.deformation - low.deformation);
        if (way * target < way * end.deformation) {
          go(target, end.force + slope * (target - end.deformation));
        } else {
          go(end.deformation, end.force);
        }
        continue;
      }
      double& most = extreme[way > 0];
      if (way * deformation >= most) {
        go(target, way * backbone(way * target));
        most = way * target;
      } else {
        const double until = std::min(way * target, most);
        const double slope = (backbone(most) - way * force) / (most - way * deformation);
        go(way * until, until == most ? way * backbone(most) : force + slope * (way * until - deformation));
      }
      const double back = std::max(k * std::pow(vy / k / most, a), backbone(most) / most);
      const Place turned = {deformation, force}, unloaded = {deformation - force / back, 0};
      low = way > 0 ? unloaded : turned;
      high = way > 0 ? turned : unloaded;
    }
  }
  [[nodiscard]] double backbone(double size) const { return vy + r * k * (size - vy / k); }
  void go(double to, double with) {
    work += 0.5 * (force + with) * (to - deformation);
    deformation = to;
    force = with;
  }
};

TEST(PeakOriented, IsWhatItsRulesGiveInAnotherForm) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(0, 1);
  for (unsigned path = 0; path < 1000; ++path) {
    const double r = path % 5 == 0 ? 0 : 0.3 * any(random);
    const double a = path % 3 == 0 ? 0 : path % 3 == 1 ? 0.4 : any(random) < 0.5 ? 1 : any(random);
    const PeakOriented law(stiffness, yield_force, r, a);
    LedElement element(law, yield_deformation);
    WindowOfReturn other{stiffness, yield_force, r, a};
    for (const double point : turning_points(path)) {
      element.lead_to(point);
      other.lead_to(point);
      ASSERT_NEAR(element.force(), other.force, 10 * round_off * yield_force) << path << ' ' << r << ' ' << a;
      ASSERT_NEAR(element.work(), other.work, 100 * round_off * yield_force * yield_deformation);
    }
  }
}

TEST(PeakOriented, SettlesIntoALoopOfKnownArea) {
  // Through (D, V), (Δ₀, 0), (−D, −V), (−Δ₀, 0) with Δ₀ = D − V/k_u: half the product of its diagonals, 2 V Δ₀.
  for (const double a : {0.0, 0.4, 1.0}) {
    for (const double r : {0.0, 0.1, 0.3}) {
      const PeakOriented law(stiffness, yield_force, r, a);
      LedElement element(law, yield_deformation);
      const double d = 5 * yield_deformation, v = yield_force * (1 + 4 * r);
      const double back = std::max(stiffness * std::pow(5, -a), v / d);
      element.lead_to(d);
      element.lead_to(-d);
      element.lead_to(d);
      const double work = element.work();
      element.lead_to(-d);
      element.lead_to(d);
      EXPECT_NEAR(element.work() - work, 2 * v * (d - v / back), 1e-11 * yield_force * d) << a << ' ' << r;
    }
  }
}

TEST(PeakOriented, GivesBackMoreThanItTookInOneCorner) {
  // A property of the rules, not of the program: where k_u softens and the backbone is steep, what could be given back
  // grows faster than the work: r μ/(1 − r + r μ) + a/2 > k_u Δ/V. Then ∫V dΔ − V²/(2 k_u) falls, by little.
  const PeakOriented law(stiffness, yield_force, 0.3, 0.4);
  LedElement element(law, yield_deformation);
  const auto at = [&](double ductility) {
    element.lead_to(ductility * yield_deformation);
    return element.hysteretic() / (yield_force * yield_deformation);
  };
  const double rising = at(5), most = at(11.864), least = at(13.686);
  EXPECT_LT(rising, most);
  EXPECT_LT(least, most);
  EXPECT_GT(least, 0.95 * most);
  EXPECT_GT(at(20), least);  // beyond, k_u is V/Δ of the extreme point
}

TEST(Cable, PullsBeyondItsSlackAlone) {
  const Cable cable(stiffness, 0.01);
  LedElement element(cable, 0.01);
  element.lead_to(0.05);
  EXPECT_EQ(element.force(), 0);
  element.lead_to(-0.01);
  EXPECT_EQ(element.state().branch, 0);
  element.lead_to(-0.03);
  EXPECT_NEAR(element.force(), -stiffness * 0.02, 1e-12);
  EXPECT_NEAR(element.stored(), 0.5 * stiffness * 0.02 * 0.02, 1e-12);
  element.lead_to(0);
  EXPECT_EQ(element.force(), 0);
  EXPECT_NEAR(element.work(), 0, 1e-12);
}

TEST(SpringDashpot, IsTheSumOfBoth) {
  const SpringDashpot link(3, 5);
  EXPECT_EQ(link.force({}, 2, 7), 3 * 2 + 5 * 7);
  EXPECT_EQ(link.stored_energy({}, 2), 6);
}

TEST(Elements, RefuseParametersOutsideTheirRanges) {
  const double infinite = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, infinite, nan}) {
    EXPECT_THROW(KinematicHardening(bad, 1, 0), InvalidParameter) << bad;
    EXPECT_THROW(KinematicHardening(1, bad, 0), InvalidParameter) << bad;
    EXPECT_THROW(PeakOriented(bad, 1, 0, 0), InvalidParameter) << bad;
    EXPECT_THROW(PeakOriented(1, bad, 0, 0), InvalidParameter) << bad;
    EXPECT_THROW(Cable(bad, 0), InvalidParameter) << bad;
  }
  for (const double bad : {-0.1, 1.0, 2.0, infinite, nan}) {
    EXPECT_THROW(KinematicHardening(1, 1, bad), InvalidParameter) << bad;
    EXPECT_THROW(PeakOriented(1, 1, bad, 0), InvalidParameter) << bad;
  }
  for (const double bad : {-0.1, 1.1, infinite, nan}) {
    EXPECT_THROW(PeakOriented(1, 1, 0, bad), InvalidParameter) << bad;
  }
  for (const double bad : {-1.0, infinite, nan}) {
    EXPECT_THROW(Cable(1, bad), InvalidParameter) << bad;
    EXPECT_THROW(SpringDashpot(bad, 1), InvalidParameter) << bad;
    EXPECT_THROW(SpringDashpot(1, bad), InvalidParameter) << bad;
  }
  EXPECT_THROW(SpringDashpot(0, 0), InvalidParameter);
}

}  // namespace
}  // namespace bentur
