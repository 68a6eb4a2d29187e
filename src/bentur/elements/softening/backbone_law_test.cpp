// Backbones that soften: what every law keeps to, limits, and what OpenSees answers along the same histories.
#include "bentur/elements/softening/backbone_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/elements/kinematic_hardening.h"
#include "bentur/elements/peak_oriented.h"
#include "tests/support/led_element.h"

namespace bentur {
namespace {

using test::LedElement;

// Of a storey of [kN, m]: yields at 0.02 m.
constexpr double initial = 15e3, strength = 300, at_yield = strength / initial;
// Places of events are known to 1e-13 of the yield deformation (LedElement), forces are of order one of it.
constexpr double rounded = 1e-10;

constexpr Backbone softens = {.yield = strength, .cap = 1.1, .plastic = 0.06, .softening = 0.2, .residual = 0.2};

BackboneLaw::Parameters made(Reloading reloading, const Deterioration& wear = {}, Backbone up = softens,
                             Backbone down = softens) {
  BackboneLaw::Parameters of = {.stiffness = initial, .positive = up, .negative = down, .deterioration = wear};
  of.reloading = reloading;
  if (reloading == Reloading::pinching) of.pinching_force = 0.4, of.pinching_deformation = 0.3;
  return of;
}

/// A law by chance: of any kind, with two sides or one shape for both, worn out at any pace.
BackboneLaw::Parameters any_law(std::mt19937& random) {
  std::uniform_real_distribution<double> number(0, 1);
  const auto side = [&] {
    Backbone of = {.yield = strength * (0.6 + number(random)), .cap = 1 + 0.3 * number(random)};
    of.plastic = at_yield * (0.5 + 5 * number(random));
    of.softening = at_yield * (0.5 + 12 * number(random));
    of.residual = number(random) < 0.3 ? 0 : 0.5 * number(random);
    if (number(random) < 0.3) of.ultimate = 2 * at_yield + 12 * at_yield * number(random);
    return of;
  };
  const Backbone up = side();
  BackboneLaw::Parameters of = made(static_cast<Reloading>(random() % 3), {}, up, random() % 2 == 0 ? up : side());
  for (double* gamma :
       {&of.deterioration.strength, &of.deterioration.cap, &of.deterioration.reloading, &of.deterioration.unloading}) {
    if (random() % 2 == 0) *gamma = 5 + 100 * number(random);
  }
  of.deterioration.exponent = 1 + number(random);
  of.pinching_force = 0.1 + 0.9 * number(random);
  of.pinching_deformation = 0.9 * number(random);
  of.one_sided = random() % 5 == 0;
  return of;
}

/// Turning points, some within the elastic range, some tiny, most up to ten times the yield deformation.
std::vector<double> turns(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<double> points;
  double last = 0;
  for (int i = 0; i < 30; ++i) {
    const double kind = std::abs(number(random)), x = number(random);
    last = kind < 0.2   ? x * at_yield
           : kind < 0.4 ? last + 0.3 * x * at_yield
           : kind < 0.5 ? 0.8 * last
                        : 10 * x * at_yield;
    points.push_back(last);
  }
  return points;
}

constexpr unsigned paths = 4000;

TEST(BackboneLaw, ChangesItsBranchWithoutAJumpUnlessItFailsAtItsUltimateDeformation) {
  for (unsigned seed = 0; seed < paths; ++seed) {
    std::mt19937 random(seed);
    const BackboneLaw::Parameters of = any_law(random);
    const BackboneLaw law(of);
    const bool softer_each_time = !std::isinf(of.deterioration.unloading);
    LedElement element(law, at_yield);
    for (const double point : turns(random)) element.lead_to(point);
    for (const LedElement::Change& change : element.changes()) {
      ASSERT_GE(change.least_guard, -1e-12 * at_yield) << seed << ": " << change.from << "→" << change.to;
      if (change.force_after == 0 && change.stored_after == 0 && law.branch({.branch = change.to}).guard_count == 0) {
        ASSERT_GE(change.stored_before, 0) << seed;  // it has failed
        continue;
      }
      ASSERT_NEAR(change.force_after, change.force_before, rounded * strength)
          << seed << ": " << change.from << "→" << change.to;
      // Each turn makes unloading softer, so that from where one has been there is more to come back.
      if (softer_each_time && change.stored_after > change.stored_before) continue;
      ASSERT_NEAR(change.stored_after, change.stored_before, 1e-9 * strength * at_yield)
          << seed << ": " << change.from << "→" << change.to;
    }
  }
}

TEST(BackboneLaw, StaysBelowItsBackboneAndIsNeverStifferThanAtFirst) {
  for (unsigned seed = 0; seed < paths; ++seed) {
    std::mt19937 random(seed);
    const BackboneLaw::Parameters of = any_law(random);
    const BackboneLaw law(of);
    LedElement element(law, at_yield);
    for (const double point : turns(random)) {
      element.lead_to(point);
      const Backbone& side = element.force() < 0 ? of.negative : of.positive;
      // With `bilinear` the line that falls from the cap grows flatter as the yield force wears, so that it may be met
      // farther out and higher up; it is below what it began with at δ = 0.
      const bool flatter = of.reloading == Reloading::bilinear && std::isfinite(of.deterioration.strength);
      const double most = flatter ? 1 + (side.yield / initial + side.plastic) / side.softening : 1;
      ASSERT_LE(std::abs(element.force()), side.cap * side.yield * most * (1 + rounded)) << seed;
      ASSERT_LE(law.branch(element.state()).stiffness, initial * (1 + 1e-8)) << seed;
      const StrengthLoss loss = *law.loss(element.state(), element.deformation());
      ASSERT_GE(loss.left, 0);
      ASSERT_LE(loss.left, 1 + rounded);
      if (of.one_sided) {
        ASSERT_GE(element.force(), -rounded * strength) << seed;
      }
      if (loss.failed) {
        ASSERT_EQ(element.force(), 0) << seed;
      }
      if (loss.residual) {
        ASSERT_TRUE(loss.capped.has_value()) << seed;
      }
    }
  }
}

TEST(BackboneLaw, GivesBackNoMoreThanItHasTakenIn) {
  for (unsigned seed = 0; seed < paths; ++seed) {
    std::mt19937 random(seed);
    const BackboneLaw law(any_law(random));
    LedElement element(law, at_yield);
    for (const double point : turns(random)) {
      element.lead_to(point);
      ASSERT_GE(element.stored(), 0);
      ASSERT_GE(element.hysteretic(), -1e-9 * strength * at_yield) << seed;
    }
    const double stored = element.stored(), work = element.work();
    element.lead_to(law.residual(element.state(), element.deformation()));
    ASSERT_NEAR(element.force(), 0, 1e-8 * strength) << seed;
    if (law.loss(element.state(), element.deformation())->failed) continue;  // the other side's ultimate came first
    ASSERT_NEAR(work - element.work(), stored, 1e-8 * strength * at_yield) << seed;
  }
}

TEST(BackboneLaw, IsTheSameBothWaysWhereItsSidesAre) {
  for (const Reloading reloading : {Reloading::bilinear, Reloading::peak_oriented, Reloading::pinching}) {
    const BackboneLaw law(made(reloading, {.strength = 40, .cap = 30, .reloading = 50, .unloading = 60}));
    EXPECT_TRUE(law.is_odd());
    for (unsigned seed = 0; seed < 50; ++seed) {
      std::mt19937 random(seed);
      LedElement one(law, at_yield), mirrored(law, at_yield);
      for (const double point : turns(random)) {
        one.lead_to(point);
        mirrored.lead_to(-point);
        ASSERT_EQ(one.force(), -mirrored.force());
        ASSERT_EQ(one.stored(), mirrored.stored());
      }
    }
  }
}

TEST(BackboneLaw, KeepsItsStrengthWhereNothingIsSaidOfItsCap) {
  // Without a cap and without hardening a bilinear one is (L-1) with r = 0, along any path.
  const BackboneLaw law(made(Reloading::bilinear, {}, {.yield = strength}, {.yield = strength}));
  const KinematicHardening other(initial, strength, 0);
  for (unsigned seed = 0; seed < 500; ++seed) {
    std::mt19937 random(seed);
    LedElement one(law, at_yield), two(other, at_yield);
    for (const double point : turns(random)) {
      one.lead_to(point);
      two.lead_to(point);
      ASSERT_NEAR(one.force(), two.force(), rounded * strength) << seed;
      ASSERT_NEAR(one.hysteretic(), two.hysteretic(), 100 * rounded * strength * at_yield) << seed;
    }
    EXPECT_EQ(law.loss(one.state(), 0)->left, 1);
  }
}

TEST(BackboneLaw, IsPeakOrientedAsTheLawWithoutLossIsWhileAmplitudesGrow) {
  // (L-2) knows no last turn of a side; with growing cycles it is the peak.
  const double r = 0.04, farthest = 12 * at_yield;
  const Backbone hardens = {.yield = strength, .cap = 1 + 11 * r, .plastic = 11 * at_yield, .softening = 1};
  const BackboneLaw law(made(Reloading::peak_oriented, {}, hardens, hardens));
  const PeakOriented other(initial, strength, r, 0);
  LedElement one(law, at_yield), two(other, at_yield);
  for (double size = 0.5 * at_yield; size < farthest; size *= 1.3) {
    for (const double point : {size, -size}) {
      for (int part = 1; part <= 10; ++part) {
        const double from = one.deformation(), to = from + (point - from) * part / 10;
        one.lead_to(to);
        two.lead_to(to);
        ASSERT_NEAR(one.force(), two.force(), rounded * strength);
      }
    }
  }
}

TEST(BackboneLaw, LosesItsStrengthOneWayAsItsBackboneSays) {
  Backbone fails = softens;
  fails.ultimate = 0.4;
  const BackboneLaw law(made(Reloading::peak_oriented, {}, fails, fails));
  LedElement element(law, at_yield);
  const double cap = 1.1 * strength, capped = at_yield + 0.06, level = capped + 0.2 * (1 - 0.2 / 1.1);
  for (const auto& [deformation, force] : {std::pair{0.5 * at_yield, 150.0},
                                           {at_yield, strength},
                                           {at_yield + 0.03, 315.0},
                                           {capped, cap},
                                           {capped + 0.1, 0.5 * cap},
                                           {level, 60.0},
                                           {0.39, 60.0},
                                           {0.41, 0.0},
                                           {0.3, 0.0},
                                           {-0.3, 0.0}}) {
    element.lead_to(deformation);
    EXPECT_NEAR(element.force(), force, 1e-8 * strength) << deformation;
  }
  EXPECT_EQ(law.loss(element.state(), 0)->left, 0);
  // All work is lost, and what was stored when it failed with it: the area below the backbone.
  const double area = 0.5 * strength * at_yield + 0.5 * (strength + cap) * 0.06 + 0.5 * (cap + 60) * (level - capped) +
                      60 * (0.4 - level);
  EXPECT_NEAR(element.hysteretic(), area, 1e-9 * area);
}

TEST(BackboneLaw, FailsOnceRepetitionHasTakenItsEnergy) {
  // E_t = γ F_y δ_y. Half cycles of one size without a cap lose F_y (2Δ − 2δ_y) each; as β exceeds 1 nothing is left.
  const Deterioration wear = {.strength = 60};
  const BackboneLaw law(made(Reloading::bilinear, wear, {.yield = strength}, {.yield = strength}));
  LedElement element(law, at_yield);
  int half_cycles = 0;
  for (; half_cycles < 100 && !law.loss(element.state(), element.deformation())->failed; ++half_cycles) {
    element.lead_to(half_cycles % 2 == 0 ? 4 * at_yield : -4 * at_yield);
  }
  EXPECT_GT(half_cycles, 8);
  EXPECT_LT(half_cycles, 40);
  EXPECT_LT(element.work(), 60 * strength * at_yield);
  EXPECT_GT(element.work(), 30 * strength * at_yield);
}

TEST(BackboneLaw, IsAStrutWhereItHasOneSide) {
  BackboneLaw::Parameters of = made(Reloading::peak_oriented);
  of.one_sided = true;
  const BackboneLaw law(of);
  LedElement element(law, at_yield);
  element.lead_to(-0.1);
  EXPECT_EQ(element.force(), 0);
  element.lead_to(0.04);
  const double peak = element.force();
  EXPECT_NEAR(peak, strength * (1 + 0.1 / 3), rounded * strength);
  const double left = 0.04 - peak / initial;
  element.lead_to(0.5 * left);
  EXPECT_EQ(element.force(), 0);
  element.lead_to(left + 0.5 * (0.04 - left));  // slack until there, then straight for its peak
  EXPECT_NEAR(element.force(), 0.5 * peak, rounded * strength);
  EXPECT_FALSE(law.is_odd());
}

/// What OpenSees answers (tests/reference/backbone_opensees.py, which says how well: 3e-9 of the yield force is what
/// was seen, the square of its steps 4e-8).
TEST(BackboneLaw, AnswersAsOpenSeesAlongGivenHistories) {
  std::ifstream file(BENTUR_SOURCE_DIR "/tests/reference/backbone_opensees.txt");
  ASSERT_TRUE(file);
  std::unique_ptr<BackboneLaw> law;
  std::unique_ptr<LedElement> element;
  std::string line, name;
  int histories = 0, points = 0;
  while (std::getline(file, line)) {
    if (line.starts_with('#')) continue;
    if (line.starts_with("case ")) {
      const std::size_t colon = line.find(':');
      name = line.substr(5, colon - 5);
      std::istringstream in(line.substr(colon + 1));
      std::string word;
      in >> word;
      BackboneLaw::Parameters of = {.stiffness = initial, .positive = {}, .negative = {}};
      for (Backbone* side : {&of.positive, &of.negative}) {
        in >> side->yield >> side->cap >> side->plastic >> side->softening >> side->residual >> side->ultimate;
      }
      // OpenSees's energies are γ F_y δ_y of the positive side, here of the weaker one.
      const double of_weaker = of.positive.yield / std::min(of.positive.yield, of.negative.yield);
      Deterioration& wear = of.deterioration;
      for (double* gamma : {&wear.strength, &wear.cap, &wear.reloading, &wear.unloading}) {
        in >> *gamma;
        *gamma = *gamma == 0 ? Deterioration::none : *gamma * of_weaker * of_weaker;
      }
      in >> wear.exponent >> of.pinching_force >> of.pinching_deformation;
      ASSERT_TRUE(in) << name;
      for (const Reloading one : {Reloading::peak_oriented, Reloading::pinching}) {
        if (word_of(one) == word) of.reloading = one;
      }
      law = std::make_unique<BackboneLaw>(of);
      ASSERT_EQ(law->name(), word);
      element = std::make_unique<LedElement>(*law, at_yield);
      ++histories;
      continue;
    }
    std::istringstream in(line);
    double deformation = 0, force = 0;
    in >> deformation >> force;
    ASSERT_TRUE(in) << line;
    element->lead_to(deformation);
    ASSERT_NEAR(element->force(), force, 1e-8 * strength) << name << " at " << deformation;
    ++points;
  }
  EXPECT_EQ(histories, 39);
  EXPECT_GT(points, 2800);
}

TEST(BackboneLaw, RefusesParametersOutsideTheirRanges) {
  const auto refused = [](auto change, const std::string& parameter) {
    BackboneLaw::Parameters of = made(Reloading::pinching);
    change(of);
    try {
      const BackboneLaw law(of);
      ADD_FAILURE() << parameter;
    } catch (const InvalidParameter& error) {
      EXPECT_NE(std::string(error.what()).find(parameter), std::string::npos) << error.what();
    }
  };
  refused([](auto& of) { of.stiffness = 0; }, "stiffness");
  refused([](auto& of) { of.positive.yield = 0; }, "yield");
  refused([](auto& of) { of.negative.cap = 0.9; }, "negative.cap");
  refused([](auto& of) { of.positive.plastic = 0; }, "plastic");
  refused([](auto& of) { of.positive.softening = -1; }, "softening");
  refused([](auto& of) { of.positive.residual = 1.1; }, "residual");
  refused([](auto& of) { of.positive.ultimate = at_yield; }, "ultimate");
  refused([](auto& of) { of.deterioration.unloading = 0; }, "deterioration.unloading");
  refused([](auto& of) { of.deterioration.exponent = 0.5; }, "deterioration.exponent");
  refused([](auto& of) { of.pinching_force = 0; }, "pinching_force");
  refused([](auto& of) { of.pinching_deformation = 1; }, "pinching_deformation");
}

}  // namespace
}  // namespace bentur
