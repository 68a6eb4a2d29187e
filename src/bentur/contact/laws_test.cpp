// What every contact law owes, whatever its force. A new law adds its entry to examples() and passes all of this.
#include "bentur/contact/laws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "bentur/core/errors.h"
#include "tests/support/free_impact.h"
#include "tests/support/restitution_laws.h"

namespace bentur {
namespace {

using test::Asked;
using test::laws_with_a_restitution;

struct Example {
  std::string label;
  std::string law;
  LawInput input;  // for m_e = 1e5
  int branches = 2;
  bool pulls = false;      // F < 0 happens
  bool remembers = false;  // a free impact leaves something behind …
  bool fades = false;      // … that fades with time
};

void PrintTo(const Example& example, std::ostream* out) { *out << example.label; }

const std::vector<Example>& examples() {
  static const std::vector<Example> list = {
      {"Linear", "linear", {{{"stiffness", 1e8}}, {}, 1e5}},
      {"KelvinVoigtZeroForce", "kelvin-voigt", {{{"stiffness", 1e8}, {"restitution", 0.5}}, {}, 1e5}, 3},
      {"KelvinVoigtOverdamped", "kelvin-voigt", {{{"stiffness", 1e8}, {"damping_ratio", 1.4}}, {}, 1e5}, 3},
      {"KelvinVoigtUndamped", "kelvin-voigt", {{{"stiffness", 1e8}, {"damping", 0}}, {{"release", "creep"}}, 1e5}},
      {"KelvinVoigtSeparation",
       "kelvin-voigt",
       {{{"stiffness", 1e8}, {"damping", 1e6}}, {{"release", "separation"}}, 1e5},
       2,
       true},
      {"KelvinVoigtCreep",
       "kelvin-voigt",
       {{{"stiffness", 1e8}, {"restitution", 0.3}}, {{"release", "creep"}, {"calibration", "published"}}, 1e5},
       4,
       false,
       true,
       true},
      {"KelvinVoigtApproach", "kelvin-voigt-approach", {{{"stiffness", 1e8}, {"restitution", 0.65}}, {}, 1e5}, 3},
      {"KelvinVoigtApproachByRatio", "kelvin-voigt-approach", {{{"stiffness", 1e8}, {"damping_ratio", 2}}, {}, 1e5}, 3},
      {"Darmawan", "darmawan", {{{"stiffness", 1e8}, {"alpha", 5}}, {}, 1e5}, 3},
      {"DarmawanUndamped", "darmawan", {{{"stiffness", 1e8}, {"alpha", 0}}, {}, 1e5}},
      {"Hertz", "hertz", {{{"stiffness", 2e9}}, {}, 1e5}},
      {"HertzDamp", "hertz-damp", {{{"stiffness", 2e9}, {"restitution", 0.4}}, {}, 1e5}, 3},
      {"HertzDampByFactor", "hertz-damp", {{{"stiffness", 2e9}, {"damping_factor", 0.9}}, {}, 1e5}, 3},
      {"HertzDampUndamped", "hertz-damp", {{{"stiffness", 2e9}, {"damping_factor", 0}}, {}, 1e5}},
      {"Jankowski", "jankowski", {{{"stiffness", 2e9}, {"restitution", 0.65}}, {}, 1e5}, 3},
      {"JankowskiByRatio", "jankowski", {{{"stiffness", 2e9}, {"damping_ratio", 0.4}}, {}, 1e5}, 3},
      {"Bilinear",
       "bilinear",
       {{{"stiffness", 1e8}, {"second_stiffness", 3e7}, {"yield_penetration", 1e-3}}, {}, 1e5},
       4},
      {"BilinearWithoutYield",
       "bilinear",
       {{{"stiffness", 1e8}, {"second_stiffness", 1e8}, {"yield_penetration", 1e-3}}, {}, 1e5}},
      {"Filler",
       "filler",
       {{{"crushing_force", 1e5},
         {"thickness", 6e-3},
         {"crushing_strain", 0.05},
         {"locking_strain", 0.6},
         {"locked_stiffness", 1e9}},
        {},
        1e5},
       5,
       false,
       true},
      {"Restitution", "restitution", {{{"restitution", 0.65}}, {}, 1e5}},
  };
  return list;
}

std::shared_ptr<const ContactLaw> make(const Example& example, double effective_mass = 1e5) {
  LawInput input = example.input;
  input.effective_mass = effective_mass;
  return find_law(example.law)->make(input);
}

TEST(ContactLaws, EveryRegisteredLawHasAnExample) {
  for (const LawEntry& entry : contact_laws()) {
    bool found = false;
    for (const Example& example : examples()) found = found || example.law == entry.name;
    EXPECT_TRUE(found) << entry.name << " has no entry in examples()";
    EXPECT_EQ(find_law(entry.name), &entry);
  }
  EXPECT_EQ(find_law("spring"), nullptr);
}

class EveryLaw : public testing::TestWithParam<Example> {
 protected:
  const Example& example_ = GetParam();
  std::shared_ptr<const ContactLaw> law_ = make(example_);
};

TEST_P(EveryLaw, GoesByItsNameAndShowsWhatItWasGiven) {
  EXPECT_EQ(law_->name(), example_.law);
  const LawParameters shown = law_->parameters();
  for (const auto& [key, value] : example_.input.numbers) {
    const std::string& wanted = key;
    const auto found = std::find_if(shown.begin(), shown.end(), [&](const auto& p) { return p.first == wanted; });
    ASSERT_NE(found, shown.end()) << key;
    EXPECT_DOUBLE_EQ(found->second, value) << key;  // damping comes back through the damping ratio: round-off
  }
  for (const auto& [key, value] : shown) EXPECT_TRUE(std::isfinite(value)) << key;
}

TEST_P(EveryLaw, ApartThereIsNoForce) {
  const LawState state;
  const Branch branch = law_->branch(state);
  EXPECT_FALSE(branch.touching());
  ASSERT_EQ(branch.guard_count, 1);
  const Guard& guard = branch.guards[0];
  EXPECT_EQ(guard.deformation, -1);
  for (const double rest : {guard.constant, guard.speed, guard.decaying}) EXPECT_EQ(rest, 0);
  for (const double penetration : {-1e-3, -1e-12, 0.0}) {
    for (const double speed : {-2.0, 0.0, 2.0}) {
      EXPECT_EQ(law_->force(state, penetration, speed), 0);
      EXPECT_EQ(law_->stored_energy(state, penetration), 0);
    }
  }
}

/// A law that is homogeneous by its numbers alone, such as one without the damping that it could have, may say no.
TEST_P(EveryLaw, IsHomogeneousWhereNoLengthOrForceIsItsOwn) {
  constexpr double depth = 1e-3, speed = 0.2, factor = 3;
  const LawState apart;
  const LawState one = law_->next(apart, 0, 0, 0, speed), other = law_->next(apart, 0, 0, 0, factor * speed);
  bool scales = true;
  for (const double closing : {speed, 0.5 * speed, -0.1 * speed}) {
    const double force = law_->force(one, depth, closing);
    scales = scales &&
             std::abs(law_->force(other, factor * depth, factor * closing) - factor * force) <= 1e-12 * std::abs(force);
  }
  const Branch branch = law_->branch(one);
  for (std::size_t g = 0; g < branch.guard_count; ++g) scales = scales && branch.guards[g].constant == 0.0;
  EXPECT_TRUE(scales || !law_->is_homogeneous());
  const std::string name(law_->name());
  EXPECT_EQ(law_->is_homogeneous(), name == "linear" || name == "restitution" || name.starts_with("kelvin-voigt"));
}

TEST_P(EveryLaw, AContactBeginsWithItsClosingSpeed) {
  const LawState begun = law_->next({}, 0, 2.5, 0, 0.3);
  EXPECT_EQ(begun.branch, 1);
  EXPECT_EQ(begun.since, 2.5);
  EXPECT_EQ(begun.closing_speed, 0.3);
  EXPECT_EQ(begun.memory[0], 0);
  EXPECT_TRUE(law_->branch(begun).touching());
}

// A prescribed motion δ(t), driven through the branch machine; calls `look` at closely spaced times and after each
// event.
class Driven {
 public:
  struct Moment {
    double time, penetration, speed, work;
  };
  using Look = std::function<void(const LawState&, const Branch&, const Moment&)>;

  Driven(const ContactLaw& law, Look look) : law_(law), look_(std::move(look)) {}

  void run(double duration, double h) {
    branch_ = law_.branch(state_);
    while (time_ < duration && events_ < 10000) step(h);
    EXPECT_LT(events_, 10000) << "branches without end at " << time_;
  }

  // Apart at the start. Three frequencies that never repeat, so that contacts begin, turn back and end at all depths
  // and speeds.
  static double penetration(double t) {
    return amplitude *
           (0.55 * std::sin(omega * t) + 0.45 * std::sin(2.7 * omega * t - 0.4) + 0.3 * std::sin(8.3 * omega * t));
  }
  static double speed(double t) {
    return amplitude * omega *
           (0.55 * std::cos(omega * t) + 2.7 * 0.45 * std::cos(2.7 * omega * t - 0.4) +
            8.3 * 0.3 * std::cos(8.3 * omega * t));
  }

 private:
  static constexpr double amplitude = 5e-3, omega = 12;

  double guard(const Guard& g, double t) const {
    return g.constant + g.deformation * penetration(t) + g.speed * speed(t) +
           g.decaying * std::exp(-g.rate * (t - state_.since));
  }

  void step(double h) {
    double end = time_ + h;
    std::size_t failed = branch_.guard_count;
    for (std::size_t i = 0; i < branch_.guard_count; ++i) {
      if (guard(branch_.guards[i], end) >= 0) continue;
      double low = time_, high = end;
      for (int n = 0; n < 60; ++n) {
        const double middle = (low + high) / 2;
        (guard(branch_.guards[i], middle) >= 0 ? low : high) = middle;
      }
      if (high < end || failed == branch_.guard_count) failed = i, end = high;
    }
    const auto power = [&](double t) { return law_.force(state_, penetration(t), speed(t)) * speed(t); };
    if (end > time_) work_ += boost::math::quadrature::gauss<double, 7>::integrate(power, time_, end);
    time_ = end;
    look_(state_, branch_, {time_, penetration(time_), speed(time_), work_});
    if (failed == branch_.guard_count) return;
    ++events_;
    state_ = law_.next(state_, failed, time_, penetration(time_), speed(time_));
    branch_ = law_.branch(state_);
    look_(state_, branch_, {time_, penetration(time_), speed(time_), work_});
  }

  const ContactLaw& law_;
  Look look_;
  LawState state_;
  Branch branch_;
  double time_ = 0, work_ = 0;
  int events_ = 0;
};

constexpr double driven_time = 20, driven_step = 2e-4;

// Restitution has no force of its own, and no guards: it cannot be driven.
class EveryForce : public EveryLaw {};

std::vector<Example> laws_with_a_force() {
  std::vector<Example> list;
  for (const Example& example : examples()) {
    if (!make(example)->restitution()) list.push_back(example);
  }
  return list;
}

TEST_P(EveryForce, DrivenThroughAllItsBranchesItPushesOnlyWhileTouching) {
  std::set<int> seen;
  double least = 0, most = 0;
  Driven(*law_, [&](const LawState& state, const Branch& branch, const Driven::Moment& now) {
    seen.insert(state.branch);
    const double force = law_->force(state, now.penetration, now.speed);
    if (branch.touching()) {
      ASSERT_GE(now.penetration, -1e-12);
    } else {
      ASSERT_EQ(force, 0) << "branch " << state.branch << " at " << now.time;
    }
    if (branch.linear) {
      const double straight = branch.base + branch.stiffness * now.penetration + branch.damping * now.speed;
      ASSERT_EQ(force, straight);
    }
    least = std::min(least, force);
    most = std::max(most, force);
  }).run(driven_time, driven_step);
  EXPECT_EQ(static_cast<int>(seen.size()), example_.branches);
  EXPECT_GT(most, 1e4);
  // Branches end within the round-off of the time (4e-15 s): 1e-10 of a force that changes within milliseconds.
  if (example_.pulls) {
    EXPECT_LT(least, -1e-2 * most);
  } else {
    EXPECT_GE(least, -1e-10 * most);
  }
}

TEST_P(EveryForce, DrivenAnyWayItNeverGivesMoreThanItGot) {
  double lost = 0, least_step = 0, least = 0, most_work = 0;
  Driven(*law_, [&](const LawState& state, const Branch&, const Driven::Moment& now) {
    const double stored = law_->stored_energy(state, now.penetration);
    ASSERT_GE(stored, 0);
    const double now_lost = now.work - stored;
    least_step = std::min(least_step, now_lost - lost);
    least = std::min(least, now_lost);
    lost = now_lost;
    most_work = std::max(most_work, now.work);
  }).run(driven_time, driven_step);
  // Gauss's rule errs where a force begins as δ^1.5; at all ends of contact together by 1e-9 of the work.
  EXPECT_GE(least, -1e-8 * most_work);
  // What a dented surface holds when the bodies leave it counts as lost, and comes back if they return in time.
  if (!example_.fades) {
    EXPECT_GE(least_step, -1e-8 * most_work);
  }
}

TEST_P(EveryLaw, NanPassesThroughEveryBranch) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int branch = 0; branch < example_.branches; ++branch) {
    const LawState state = {.branch = branch, .closing_speed = 0.3};
    EXPECT_TRUE(std::isnan(law_->force(state, nan, 0.1))) << branch;
    EXPECT_TRUE(std::isnan(law_->force(state, 1e-3, nan))) << branch;
  }
}

TEST_P(EveryLaw, AStepALittleOutsideABranchIsFinite) {
  for (int branch = 0; branch < example_.branches; ++branch) {
    const LawState state = {.branch = branch, .closing_speed = 0.3};
    for (const double penetration : {-1e-4, -1e-300, -0.0, 0.0, 1e-300, 1e-3}) {
      for (const double speed : {-100.0, -1e-9, 0.0, 1e-9, 100.0}) {
        EXPECT_TRUE(std::isfinite(law_->force(state, penetration, speed)));
      }
    }
  }
}

TEST_P(EveryLaw, AFreeImpactGainsNoEnergyAndLeavesNothingBehind) {
  for (const double speed : {1e-4, 1e-3, 1e-2, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0}) {
    const auto impact = test::free_impact(*law_, 2e5, 2e5, speed);  // m_e = 1e5
    EXPECT_GT(impact.separation_speed, 0) << speed;
    EXPECT_LE(impact.separation_speed, speed * (1 + 1e-12)) << speed;
    EXPECT_NEAR(impact.momentum / (2e5 * speed), 1, 1e-12) << speed;
    const double energy = 0.5 * 1e5 * speed * speed;
    double before = energy;
    for (const auto& sample : impact.samples) {
      const double total = sample.kinetic + sample.stored;
      ASSERT_LE(total, before + 1e-11 * energy) << speed << " at " << sample.time;
      before = total;
      if (!sample.touching) {
        ASSERT_EQ(sample.force, 0);
      }
    }
    // The end of contact is found within the last bits of time, which the force's slope turns into 1e-12 of the peak.
    if (!example_.pulls) {
      EXPECT_GE(impact.least_force, -1e-12 * impact.peak_force) << speed;
    }
    EXPECT_FALSE(law_->branch(impact.end).touching());
    EXPECT_EQ(impact.end.closing_speed, 0);
    if (!example_.remembers) {
      EXPECT_EQ(impact.end.branch, 0) << speed;
      EXPECT_EQ(impact.end.memory[0], 0) << speed;
    }
  }
}

TEST_P(EveryLaw, ItIsTheSameWhicheverBodyIsTheHeavier) {
  const double heavy = 3e5, light = 4e4;
  const auto law = make(example_, heavy * light / (heavy + light));
  for (const double speed : {0.05, 0.5, 5.0}) {
    const auto one = test::free_impact(*law, heavy, light, speed);
    const auto other = test::free_impact(*law, light, heavy, speed);
    EXPECT_NEAR(one.separation_speed / other.separation_speed, 1, 1e-11);
    if (law->restitution()) continue;
    EXPECT_NEAR(one.duration / other.duration, 1, 1e-11);
    EXPECT_NEAR(one.peak_force / other.peak_force, 1, 1e-11);
    EXPECT_NEAR(one.peak_penetration / other.peak_penetration, 1, 1e-11);
  }
}

INSTANTIATE_TEST_SUITE_P(, EveryLaw, testing::ValuesIn(examples()), [](const auto& one) { return one.param.label; });

INSTANTIATE_TEST_SUITE_P(, EveryForce, testing::ValuesIn(laws_with_a_force()),
                         [](const auto& one) { return one.param.label; });

// Every law that takes a restitution, in every way that it can be told to let go.
class RestitutionAskedFor : public testing::TestWithParam<Asked> {};

TEST_P(RestitutionAskedFor, IsTheOneObtained) {
  const Asked& asked = GetParam();
  for (const auto& [left, right] : {std::pair{2e5, 6e4}, {30.0, 5e3}}) {
    for (const double stiffness : {3e5, 2e9}) {
      for (const double e : {0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}) {
        LawInput input = {{{"stiffness", stiffness}, {"restitution", e}}, asked.words, left * right / (left + right)};
        const auto law = asked.law->make(input);
        for (const double speed : {0.02, 0.4937, 6.0}) {
          const double obtained = test::free_impact(*law, left, right, speed).separation_speed / speed;
          EXPECT_NEAR(obtained, e, 1e-11) << speed << " " << stiffness;  // the test's integration is good to 1e-12
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, RestitutionAskedFor, testing::ValuesIn(laws_with_a_restitution()),
                         [](const auto& one) { return one.param.label; });

}  // namespace
}  // namespace bentur
