// Branch machines of single laws, step by step, and the input they refuse.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "bentur/contact/laws/bilinear.h"
#include "bentur/contact/laws/darmawan.h"
#include "bentur/contact/laws/filler.h"
#include "bentur/contact/laws/hertz.h"
#include "bentur/contact/laws/hertz_damp.h"
#include "bentur/contact/laws/jankowski.h"
#include "bentur/contact/laws/kelvin_voigt.h"
#include "bentur/contact/laws/kelvin_voigt_approach.h"
#include "bentur/contact/laws/restitution.h"
#include "bentur/core/errors.h"

namespace bentur {
namespace {

using Release = KelvinVoigt::Release;

double value(const Guard& guard, double penetration, double speed, double elapsed = 0) {
  return guard.constant + guard.deformation * penetration + guard.speed * speed +
         guard.decaying * std::exp(-guard.rate * elapsed);
}

// k = 100, m_e = 1, ξ = 0.2: c = 4.
const KelvinVoigt zero_force(100, 0.2, 1, Release::zero_force);
const KelvinVoigt creeping(100, 0.2, 1, Release::creep);

TEST(KelvinVoigtZeroForce, PushesAgainWithoutHavingBeenApart) {
  LawState state = zero_force.next({}, 0, 1.0, 0, 0.5);
  EXPECT_EQ(zero_force.force(state, 0, 0.5), 2);  // it jumps to c v₀
  state = zero_force.next(state, 1, 1.1, 0.01, -0.25);
  EXPECT_EQ(state.branch, 2);
  EXPECT_EQ(zero_force.force(state, 0.01, -0.3), 0);
  EXPECT_GT(value(zero_force.branch(state).guards[1], 0.01, -0.3), 0);  // k δ + c δ̇ = −0.2: no push
  EXPECT_LT(value(zero_force.branch(state).guards[1], 0.01, -0.2), 0);  // +0.2
  const LawState again = zero_force.next(state, 1, 1.2, 0.008, -0.2);
  EXPECT_EQ(again.branch, 1);
  EXPECT_EQ(again.closing_speed, -0.2);
  const LawState away = zero_force.next(state, 0, 1.3, 0, -0.4);
  EXPECT_EQ(away.branch, 0);
}

TEST(KelvinVoigtZeroForce, EndsApartWhereForceAndPenetrationEndTogether) {
  const LawState pushing = zero_force.next({}, 0, 0, 0, 1e-9);
  EXPECT_EQ(zero_force.next(pushing, 0, 1, 0, 0).branch, 0);
  EXPECT_EQ(zero_force.next(pushing, 1, 1, 0, 0).branch, 0);  // k δ + c δ̇ = 0 at δ = 0 is no release
  EXPECT_EQ(zero_force.next(pushing, 1, 1, -1e-18, 0).branch, 0);
}

TEST(KelvinVoigtCreep, TheSurfaceRecoversAndIsMetOnItsWay) {
  const double rate = 100 / 4.0;  // k/c
  LawState state = creeping.next({}, 0, 0, 0, 0.5);
  EXPECT_EQ(creeping.branch(state).guard_count, 1);
  state = creeping.next(state, 0, 1.0, 0.01, -0.25);
  EXPECT_EQ(state.branch, 2);
  EXPECT_EQ(state.memory[0], 0.01);
  EXPECT_FALSE(creeping.branch(state).touching());
  // Not before k δ + c δ̇ > 0 is the surface watched, from where it has come to.
  const LawState nearing = creeping.next(state, 0, 1.04, -0.01, 0.25);
  EXPECT_EQ(nearing.branch, 3);
  EXPECT_NEAR(nearing.memory[0], 0.01 * std::exp(-rate * 0.04), 1e-16);
  const Branch watched = creeping.branch(nearing);
  const double surface = nearing.memory[0] * std::exp(-rate * 0.02);
  EXPECT_NEAR(value(watched.guards[0], surface, 1, 0.02), 0, 1e-17);
  EXPECT_GT(value(watched.guards[0], surface * 0.99, 1, 0.02), 0);
  EXPECT_FALSE(watched.touching());
  // The bodies meet it with a push: k δ + c δ̇ > 0.
  const LawState met = creeping.next(nearing, 0, 1.06, surface, 0.3);
  EXPECT_EQ(met.branch, 1);
  EXPECT_EQ(met.closing_speed, 0.3);
  EXPECT_EQ(met.memory[0], 0);
  // Or they turn away before; the dent goes on from where it was.
  const LawState turned = creeping.next(nearing, 1, 1.06, -0.02, 0.5);
  EXPECT_EQ(turned.branch, 2);
  EXPECT_NEAR(turned.memory[0], surface, 1e-16);
}

TEST(KelvinVoigtCreep, FadesFromMemory) {
  LawState state = creeping.next(creeping.next({}, 0, 0, 0, 0.5), 0, 1.0, 0.01, -0.25);
  EXPECT_EQ(creeping.next(state, 0, 1.0 + 35 / 25.0, -0.01, 0.25).branch, 3);
  const LawState faded = creeping.next(state, 0, 1.0 + 37 / 25.0, -0.01, 0.25);  // e⁻³⁷ < 2⁻⁵²
  EXPECT_EQ(faded.branch, 0);
  EXPECT_EQ(faded.memory[0], 0);
}

TEST(KelvinVoigtCreep, NoDentNoMemory) {
  const LawState touching = creeping.next({}, 0, 0, 0, 0.5);
  for (const double round_off : {0.0, -1e-19}) EXPECT_EQ(creeping.next(touching, 0, 1, round_off, -0.1).branch, 0);
  const KelvinVoigt spring(100, 0, 1, Release::creep);
  const LawState sprung = spring.next({}, 0, 0, 0, 0.5);
  EXPECT_EQ(spring.branch(sprung).guards[0].deformation, 1);
  EXPECT_EQ(spring.next(sprung, 0, 1, 0, -0.5).branch, 0);
}

// (C-14): while k δ + c δ̇ ≤ 0 bodies that have left the surface fall behind it; so branch 2 need not watch it.
TEST(KelvinVoigtCreep, WhatIsNotWatchedCannotTouch) {
  // The slowest retreat that branch 2 allows, k δ + c δ̇ = 0, stays exactly on the surface; any faster one behind it.
  const double rate = 100 / 4.0, dent = 0.01;
  for (const double faster : {1.0, 1.1, 3.0}) {
    for (double t = 0; t < 0.2; t += 0.01) {
      const double penetration = dent * std::exp(-faster * rate * t), speed = -faster * rate * penetration;
      EXPECT_LE(100 * penetration + 4 * speed, 1e-15);
      EXPECT_LE(penetration, dent * std::exp(-rate * t) * (1 + 1e-15));
    }
  }
}

TEST(KelvinVoigtApproach, DampsOnlyWhileClosing) {
  const KelvinVoigtApproach law(100, 0.2, 1);
  LawState state = law.next({}, 0, 0, 0, 0.5);
  EXPECT_EQ(law.force(state, 0.01, 0.25), 2);
  state = law.next(state, 1, 1, 0.02, 0);
  EXPECT_EQ(law.force(state, 0.01, -0.25), 1);
  EXPECT_EQ(state.closing_speed, 0.5);  // the same impact still
  const LawState again = law.next(state, 1, 2, 0.01, 0);
  EXPECT_EQ(again.branch, 1);
  EXPECT_EQ(again.closing_speed, 0.5);
  EXPECT_EQ(law.next(state, 0, 2, 0, -0.3).branch, 0);
}

TEST(Bilinear, GoesRoundItsParallelogram) {
  // k₁ = 100, k₂ = 25, δ_y = 0.02: yields at F = 2.
  const Bilinear law(100, 25, 0.02);
  LawState state = law.next({}, 0, 0, 0, 1);
  EXPECT_EQ(law.branch(state).guard_count, 2);
  EXPECT_DOUBLE_EQ(law.force(state, 0.02, 1), 2);
  EXPECT_NEAR(value(law.branch(state).guards[1], 0.02, 1), 0, 1e-15);
  state = law.next(state, 1, 0, 0.02, 1);
  EXPECT_EQ(state.branch, 2);
  EXPECT_DOUBLE_EQ(law.force(state, 0.02, 1), 2);
  EXPECT_DOUBLE_EQ(law.force(state, 0.06, 1), 3);
  state = law.next(state, 1, 0, 0.06, 0);  // turns back: down along k₁
  EXPECT_EQ(state.branch, 1);
  EXPECT_DOUBLE_EQ(law.force(state, 0.06, 0), 3);
  EXPECT_DOUBLE_EQ(law.force(state, 0.05, 0), 2);
  EXPECT_NEAR(value(law.branch(state).guards[2], 0.04, -1), 0, 1e-15);
  const LawState reloaded = law.next(state, 1, 0, 0.06, 1);  // up again to the yield line where it left it
  EXPECT_EQ(reloaded.branch, 2);
  state = law.next(state, 2, 0, 0.04, -1);
  EXPECT_EQ(state.branch, 3);
  EXPECT_DOUBLE_EQ(law.force(state, 0.04, -1), 1);
  EXPECT_DOUBLE_EQ(law.force(state, 0.01, -1), 0.25);
  const LawState turned = law.next(state, 1, 0, 0.01, 0);  // up along k₁ from the line, and yields δ_y further on
  EXPECT_EQ(turned.branch, 1);
  EXPECT_DOUBLE_EQ(law.force(turned, 0.01, 0), 0.25);
  EXPECT_NEAR(value(law.branch(turned).guards[1], 0.03, 0), 0, 1e-15);
  state = law.next(state, 0, 0, 0, -1);
  EXPECT_EQ(state.branch, 0);
  EXPECT_EQ(state.memory[0], 0);
}

TEST(Filler, WhatIsCrushedStaysCrushed) {
  // F_c = 2, δ_c = 0.01, δ_L = 0.06, k = 200, k_L = 400.
  const Filler law(2, 0.1, 0.1, 0.6, 400);
  LawState state = law.next({}, 0, 0, 0, 1);
  EXPECT_DOUBLE_EQ(law.force(state, 0.005, 1), 1);
  state = law.next(state, 1, 0, 0.01, 1);
  EXPECT_EQ(state.branch, 2);
  EXPECT_EQ(law.force(state, 0.03, 1), 2);
  state = law.next(state, 0, 0, 0.03, 0);  // turns back
  EXPECT_EQ(state.branch, 1);
  EXPECT_DOUBLE_EQ(state.memory[0], 0.02);
  EXPECT_NEAR(law.force(state, 0.025, -1), 1, 1e-14);
  state = law.next(state, 0, 1, 0.02, -1);
  EXPECT_EQ(state.branch, 4);
  EXPECT_FALSE(law.branch(state).touching());
  EXPECT_EQ(state.closing_speed, 0);
  EXPECT_GT(value(law.branch(state).guards[0], 0.015, 1), 0);  // within what has been crushed there is room now
  state = law.next(state, 0, 2, 0.02, 0.5);
  EXPECT_EQ(state.branch, 1);
  EXPECT_EQ(state.closing_speed, 0.5);
  EXPECT_NEAR(value(law.branch(state).guards[1], 0.03, 1), 0, 1e-15);  // crushing goes on where it had come to
  state = law.next(law.next(state, 1, 2, 0.03, 0.4), 1, 2, 0.06, 0.3);
  EXPECT_EQ(state.branch, 3);
  EXPECT_NEAR(law.force(state, 0.06, 1), 2, 1e-13);
  EXPECT_NEAR(law.force(state, 0.07, 1), 6, 1e-13);
  state = law.next(state, 0, 2, 0.06, -0.3);
  EXPECT_EQ(state.branch, 1);
  EXPECT_EQ(state.memory[0], 0.06 - 0.01);
  EXPECT_EQ(law.next(state, 1, 2, 0.06, 0.1).branch, 3);  // nothing is left to be crushed
  EXPECT_EQ(law.next(state, 0, 2, 0.05, -0.1).branch, 4);
}

TEST(HertzDamp, WithoutAScaleOfSpeedIsHertz) {
  const HertzDamp law(1e9, 0.8);
  const Hertz plain(1e9);
  for (const double v0 : {0.0, -0.3, 1e-320}) {
    const LawState state = law.next({}, 0, 0, 0, v0);
    EXPECT_EQ(law.branch(state).guard_count, 1) << v0;
    for (const double speed : {-5.0, 0.0, 5.0}) {
      EXPECT_EQ(law.force(state, 1e-3, speed), plain.force({.branch = 1}, 1e-3, speed)) << v0;
    }
  }
}

TEST(HertzDamp, CutWherePartingWouldPull) {
  const HertzDamp law(1e9, 0.5);
  const LawState pushing = law.next({}, 0, 0, 0, 0.2);  // cut at δ̇ = −v₀/d = −0.4
  EXPECT_NEAR(value(law.branch(pushing).guards[1], 1e-3, -0.4), 0, 1e-15);
  const LawState cut = law.next(pushing, 1, 1, 1e-3, -0.4);
  EXPECT_EQ(cut.branch, 2);
  EXPECT_TRUE(law.branch(cut).touching());
  EXPECT_EQ(law.force(cut, 1e-3, -0.6), 0);
  EXPECT_EQ(law.next(cut, 1, 1, 1e-3, -0.4).branch, 1);
  EXPECT_EQ(law.next(cut, 1, 1, 1e-3, -0.4).closing_speed, 0.2);
  EXPECT_EQ(law.next(cut, 0, 1, 0, -0.6).branch, 0);
}

TEST(Darmawan, CutWherePartingWouldPull) {
  const Darmawan law(1e6, 2);
  const LawState pushing = law.next({}, 0, 0, 0, 0.2);
  EXPECT_EQ(law.force(pushing, 1e-3, 0.25), 1500);
  EXPECT_EQ(value(law.branch(pushing).guards[1], 1e-3, -0.5), 0);
  const LawState cut = law.next(pushing, 1, 1, 1e-3, -0.5);
  EXPECT_EQ(law.force(cut, 1e-3, -0.7), 0);
  EXPECT_EQ(law.next(cut, 1, 1, 1e-3, -0.5).branch, 1);
  EXPECT_TRUE(law.branch({.branch = 1}).guard_count == 2 && !law.branch({.branch = 1}).linear);
  EXPECT_TRUE(Darmawan(1e6, 0).branch({.branch = 1}).linear);
}

TEST(Jankowski, LeavesZeroAsTheFourthRoot) {
  const Jankowski law(1e9, 0.3, 4e4);
  const LawState state = law.next({}, 0, 0, 0, 0.2);
  const double damping = 2 * 0.3 * std::sqrt(1e9 * std::sqrt(1e-4) * 4e4);
  EXPECT_DOUBLE_EQ(law.force(state, 1e-4, 0.2), 1e9 * 1e-6 + damping * 0.2);
  EXPECT_EQ(law.force(state, -1e-9, 0.2), 0);
  EXPECT_EQ(law.force(law.next(state, 1, 1, 1e-4, 0), 1e-4, -0.2), law.force(state, 1e-4, 0));
}

TEST(RestitutionLaw, RestsWithoutAForceOfItsOwn) {
  const Restitution law(0.65);
  EXPECT_EQ(law.restitution(), 0.65);
  const LawState resting = law.next({}, 0, 1, 0, 1e-9);
  EXPECT_EQ(law.branch(resting).guard_count, 0);
  EXPECT_TRUE(law.branch(resting).touching());
  EXPECT_EQ(law.next(resting, 0, 2, 0, 0).branch, 0);
}

struct Refused {
  std::string law;
  LawInput input;
  std::string message;
};

TEST(ContactLaws, RefuseWhatMakesNoSense) {
  const auto key = [](const Refused& refused) { return refused.message.substr(0, refused.message.find(' ')); };
  const Refused list[] = {
      {"linear", {{{"stiffness", 0}}, {}, 1}, "stiffness = 0, must be > 0"},
      {"linear", {{}, {}, 1}, "stiffness = nothing, must be given"},
      {"kelvin-voigt", {{{"stiffness", 1}, {"restitution", 1.4}}, {}, 1}, "restitution = 1.4, must be in (0, 1]"},
      {"kelvin-voigt", {{{"stiffness", 1}, {"damping_ratio", -0.1}}, {}, 1}, "damping_ratio = -0.1, must be >= 0"},
      {"kelvin-voigt", {{{"stiffness", 1}, {"damping", -0.1}}, {}, 1}, "damping = -0.1, must be >= 0"},
      {"kelvin-voigt", {{{"stiffness", 1}}, {}, 1}, "damping_ratio = nothing, must be given"},
      {"kelvin-voigt",
       {{{"stiffness", 1}, {"damping_ratio", 1}}, {{"release", "separation"}}, 1},
       "damping_ratio = 1, must be in [0, 1) with release = \"separation\""},
      {"kelvin-voigt",
       {{{"stiffness", 4}, {"damping", 12}}, {{"release", "separation"}}, 9},
       "damping = 12, must be in [0, 12) with release = \"separation\""},
      {"kelvin-voigt",
       {{{"stiffness", 1}, {"damping", 1}}, {{"release", "slow"}}, 1},
       "release = \"slow\", must be one of zero-force, separation, creep"},
      {"kelvin-voigt", {{{"stiffness", 1}, {"damping", 1}}, {}, 0}, "effective_mass = 0, must be > 0"},
      {"kelvin-voigt",
       {{{"stiffness", 1}, {"restitution", 0.5}}, {{"calibration", "ye"}}, 1},
       "calibration = \"ye\", must be one of exact, published"},
      {"kelvin-voigt-approach",
       {{{"stiffness", 1}, {"restitution", 0}}, {{"calibration", "published"}}, 1},
       "restitution = 0, must be in (0, 1]"},
      {"kelvin-voigt-approach", {{{"stiffness", 1}, {"damping_ratio", -1}}, {}, 1}, "damping_ratio = -1, must be >= 0"},
      {"darmawan", {{{"stiffness", 1}, {"alpha", -1}}, {}, 1}, "alpha = -1, must be >= 0"},
      {"hertz", {{{"stiffness", -1}}, {}, 1}, "stiffness = -1, must be > 0"},
      {"hertz-damp",
       {{{"stiffness", 1}, {"restitution", 0.5}}, {{"calibration", "published"}}, 1},
       "calibration = \"published\", leaves two formulas open here: must be exact, muthukumar-desroches or ye"},
      {"hertz-damp", {{{"stiffness", 1}, {"damping_factor", -1}}, {}, 1}, "damping_factor = -1, must be >= 0"},
      {"jankowski", {{{"stiffness", 1}, {"damping_ratio", -1}}, {}, 1}, "damping_ratio = -1, must be >= 0"},
      {"jankowski", {{{"stiffness", 1}, {"restitution", 2}}, {}, 1}, "restitution = 2, must be in (0, 1]"},
      {"bilinear",
       {{{"stiffness", 2}, {"second_stiffness", 3}, {"yield_penetration", 1}}, {}, 1},
       "second_stiffness = 3, must be in (0, 2], at most the stiffness"},
      {"bilinear",
       {{{"stiffness", 2}, {"second_stiffness", 1}, {"yield_penetration", 0}}, {}, 1},
       "yield_penetration = 0, must be > 0"},
      {"filler",
       {{{"crushing_force", 1},
         {"thickness", 1},
         {"crushing_strain", 0.5},
         {"locking_strain", 0.5},
         {"locked_stiffness", 9}},
        {},
        1},
       "locking_strain = 0.5, must be in (0.5, 1), above the crushing strain"},
      {"filler",
       {{{"crushing_force", 1},
         {"thickness", 1},
         {"crushing_strain", 0.25},
         {"locking_strain", 0.5},
         {"locked_stiffness", 3}},
        {},
        1},
       "locked_stiffness = 3, must be >= 4, the stiffness before crushing, crushing_force / (crushing_strain "
       "thickness)"},
      {"restitution", {{{"restitution", 1.01}}, {}, 1}, "restitution = 1.01, must be in (0, 1]"},
  };
  for (const Refused& refused : list) {
    try {
      static_cast<void>(find_law(refused.law)->make(refused.input));
      ADD_FAILURE() << refused.law << " took what should give: " << refused.message;
    } catch (const InvalidParameter& error) {
      EXPECT_EQ(error.what(), refused.message) << refused.law;
      EXPECT_EQ(error.parameter(), key(refused));
    }
  }
}

TEST(ContactLaws, CalibrationsAreTheOnesNamed) {
  const auto shown = [](const char* law, const char* calibration, const char* key) {
    const LawInput input = {{{"stiffness", 1e8}, {"restitution", 0.65}}, {{"calibration", calibration}}, 1e5};
    for (const auto& [name, value] : find_law(law)->make(input)->parameters()) {
      if (name == key) return value;
    }
    return std::numeric_limits<double>::quiet_NaN();
  };
  EXPECT_NEAR(shown("kelvin-voigt", "exact", "damping_ratio"), 0.1499, 5e-5);
  EXPECT_NEAR(shown("kelvin-voigt", "published", "damping_ratio"), 0.1359, 5e-5);
  EXPECT_NEAR(shown("kelvin-voigt-approach", "exact", "damping_ratio"), 0.3293, 5e-5);
  EXPECT_NEAR(shown("kelvin-voigt-approach", "published", "damping_ratio"), 0.3240, 5e-5);
  EXPECT_NEAR(shown("jankowski", "exact", "damping_ratio"), 0.3682, 5e-5);
  EXPECT_NEAR(shown("jankowski", "published", "damping_ratio"), 0.3728, 5e-5);
  EXPECT_NEAR(shown("hertz-damp", "exact", "damping_factor"), 0.7931, 5e-5);
  EXPECT_NEAR(shown("hertz-damp", "muthukumar-desroches", "damping_factor"), 0.4331, 5e-5);
  EXPECT_NEAR(shown("hertz-damp", "ye", "damping_factor"), 0.8615, 5e-5);
}

}  // namespace
}  // namespace bentur
