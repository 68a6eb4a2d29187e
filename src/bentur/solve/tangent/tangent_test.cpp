#include "bentur/solve/tangent/tangent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <random>
#include <string>

#include "bentur/contact/laws/hertz.h"
#include "bentur/contact/laws/kelvin_voigt.h"
#include "bentur/contact/laws/linear.h"
#include "bentur/contact/laws/restitution.h"
#include "bentur/core/errors.h"
#include "bentur/pounding/assemble.h"
#include "bentur/structure/damping.h"
#include "bentur/structure/stick.h"
#include "tests/support/random_numbers.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

enum class Kind { spring, zero_force, separation, creep, restitution };

/// A row of sticks whose every number is one of a list.
struct Row {
  std::vector<int> floors;
  Kind kind = Kind::spring;
  bool absolute = false, harmonic = false;
  SampledMotion record;
  double duration = 6;
  std::vector<double> numbers = {};
};

std::vector<std::string> names_of(const Row& row) {
  std::vector<std::string> names = {"scale"};
  if (row.harmonic) names.push_back("period");
  for (std::size_t b = 0; b < row.floors.size(); ++b) {
    const std::string of = " " + std::to_string(b);
    for (const char* name : {"mass", "stiffness", "damping", "delay"}) names.push_back(name + of);
    if (b + 1 == row.floors.size()) break;
    for (const char* name : {"width", "contact", "law"}) names.push_back(name + of);
  }
  return names;
}

std::shared_ptr<const ContactLaw> law_of(Kind kind, double stiffness, double number, double mass) {
  using Release = KelvinVoigt::Release;
  switch (kind) {
    case Kind::spring:
      return std::make_shared<Linear>(stiffness);
    case Kind::zero_force:
      return std::make_shared<KelvinVoigt>(stiffness, 0.3 * number, mass, Release::zero_force);
    case Kind::separation:
      return std::make_shared<KelvinVoigt>(stiffness, 0.3 * number, mass, Release::separation);
    case Kind::creep:
      return std::make_shared<KelvinVoigt>(stiffness, 0.3 * number, mass, Release::creep);
    case Kind::restitution:
      break;
  }
  return std::make_shared<Restitution>(number);
}

System system_of(const Row& row, const std::vector<double>& x) {
  Problem problem;
  std::size_t at = 0;
  const double scale = x[at++];
  if (row.harmonic) {
    problem.motion = HarmonicMotion{.period = x[at++], .displacement_amplitude = 0.03 * scale};
  } else {
    SampledMotion motion = row.record;
    for (double& a : motion.acceleration) a *= scale;
    problem.motion = motion;
  }
  for (std::size_t b = 0; b < row.floors.size(); ++b) {
    const double mass = x[at++], stiffness = x[at++], damping = x[at++];
    problem.delays.push_back(x[at++]);
    const std::size_t floors = row.floors[b];
    std::vector<double> masses(floors, mass);
    masses.back() *= 0.7;
    const Stick stick{std::vector<double>(floors, 3.0), masses, std::vector<double>(floors, stiffness)};
    problem.buildings.push_back(make_building("b", stick_model(stick), ModalDamping{{damping}}));
    if (b + 1 == row.floors.size()) break;
    const double width = x[at++], contact = x[at++], number = x[at++];
    const int level = std::min(row.floors[b], row.floors[b + 1]) - 1;
    for (int f = row.kind == Kind::restitution ? level : 0; f <= level; ++f) {
      problem.points.push_back({.left = static_cast<Index>(b),
                                .left_floor = f,
                                .right_floor = f,
                                .elevation = 3.0 * (f + 1),
                                .width = width,
                                .law = law_of(row.kind, contact, number, 0.5 * mass)});
    }
  }
  problem.kinematics = row.absolute ? Kinematics::absolute : Kinematics::relative;
  problem.duration = row.duration;
  return bentur::system_of(problem);
}

Row random_row(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  const auto count = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
  Row row;
  row.kind = static_cast<Kind>(count(0, 4));
  row.absolute = count(0, 3) == 0;
  row.harmonic = count(0, 3) == 0;
  for (int b = count(2, 3); b > 0; --b) row.floors.push_back(count(1, 3));
  row.record.time_step = 0.02;
  for (int n = 0; n < 250; ++n) row.record.acceleration.push_back(between(-3, 3));
  row.numbers.push_back(between(0.5, 1.5));
  if (row.harmonic) row.numbers.push_back(between(0.3, 0.8));
  for (std::size_t b = 0; b < row.floors.size(); ++b) {
    const double mass = between(1e4, 3e4);
    for (const double x : {mass, mass * between(400, 4000), between(0.02, 0.08), between(0.01, 0.2)}) {
      row.numbers.push_back(x);
    }
    if (b + 1 == row.floors.size()) break;
    for (const double x : {between(0.002, 0.03), mass * between(1e4, 1e6), between(0.3, 0.9)}) row.numbers.push_back(x);
  }
  return row;
}

struct Run {
  FreeSolution free;
  Solution found;
};

Run run_of(const System& system) {
  FreeSolution free(system, ExactSolver{});
  Solution found = free.solve(system.contacts, {.changes = true});
  return {free, found};
}

/// All that is found, in the order of Tangents.
struct Found {
  std::vector<double> values;
  std::vector<std::size_t> impacts;
};

Found found_of(const System& system) {
  const Run run = run_of(system);
  Found all;
  all.values = run.free.solution().needed;
  std::vector<double> forces(system.contacts.size(), 0.0);
  all.impacts.resize(system.contacts.size());
  for (const Impact& impact : run.found.impacts) {
    forces[impact.point] = std::max(forces[impact.point], impact.peak_force);
    ++all.impacts[impact.point];
  }
  all.values.insert(all.values.end(), forces.begin(), forces.end());
  for (const Solution* of : {&run.found, &run.free.solution()}) {
    for (const auto& body : of->outputs) {
      for (const double peak : body.front().peak) all.values.push_back(peak);
    }
  }
  return all;
}

std::vector<Derivative> all_of(const Tangents& tangents) {
  std::vector<Derivative> all = tangents.needed;
  all.insert(all.end(), tangents.peak_force.begin(), tangents.peak_force.end());
  for (const auto* of : {&tangents.displacement, &tangents.displacement_free}) {
    for (const auto& body : *of) all.insert(all.end(), body.begin(), body.end());
  }
  return all;
}

std::vector<Variation> variations_of(const Row& row, double relative) {
  std::vector<Variation> variations;
  for (std::size_t p = 0; p < row.numbers.size(); ++p) {
    std::vector<double> less = row.numbers, more = row.numbers;
    const double step = relative * row.numbers[p];
    less[p] -= step;
    more[p] += step;
    variations.push_back({step, system_of(row, less), system_of(row, more)});
  }
  return variations;
}

constexpr double nothing = 1e-12;  // of lengths of centimetres and forces of kilonewtons

struct Compared {
  long compared = 0, left_out = 0, refused = 0;
};

void compare(unsigned seed, Compared& counts) {
  SCOPED_TRACE("row " + std::to_string(seed));
  const Row row = random_row(seed);
  const System system = system_of(row, row.numbers);
  const Run run = run_of(system);
  ASSERT_EQ(run.found.status, Status::done) << run.found.message;
  std::vector<Derivative> derivatives;
  try {
    derivatives = all_of(tangents(run.free, run.found, variations_of(row, 1e-6)));
  } catch (const InvalidParameter& error) {
    ASSERT_EQ(row.kind, Kind::restitution) << error.what();  // one that comes to rest
    ++counts.refused;
    return;
  }
  const Found at = found_of(system);
  ASSERT_EQ(derivatives.size(), at.values.size());
  const std::vector<std::string> names = names_of(row);
  // Elasticities, p/y ∂y/∂p. Differences err by their width and by round-off over it, and blows multiply both: what no
  // width agrees with is wrong.
  const auto largest = [&](const Derivative& of, double value) {
    double most = 0;
    for (std::size_t p = 0; p < names.size(); ++p) {
      if (of.by.size() > 0) most = std::max(most, std::abs(of.by(p)) * row.numbers[p] / value);
    }
    return most;
  };
  Eigen::MatrixXd errors = Eigen::MatrixXd::Constant(std::ssize(derivatives), std::ssize(names), 1e300);
  Eigen::MatrixXd differences = errors;
  bool same_impacts = true;
  for (const double width : {1e-6, 1e-7, 1e-5, 3e-6, 3e-7, 3e-8}) {
    bool all_agree = true;
    const std::vector<Variation> variations = variations_of(row, width);
    for (std::size_t p = 0; p < names.size(); ++p) {
      const Found below = found_of(variations[p].below), above = found_of(variations[p].above);
      same_impacts = same_impacts && (width > 2e-6 || (below.impacts == at.impacts && above.impacts == at.impacts));
      for (std::size_t i = 0; i < derivatives.size(); ++i) {
        if (derivatives[i].by.size() == 0) continue;
        const double by = (above.values[i] - below.values[i]) / (2.0 * variations[p].step);
        const double error = std::abs(by - derivatives[i].by(p)) * row.numbers[p] / at.values[i];
        const auto n = static_cast<Index>(i), m = static_cast<Index>(p);
        if (error < errors(n, m)) {
          errors(n, m) = error;
          differences(n, m) = by;
        }
        all_agree = all_agree && errors(n, m) <= 1e-5 * largest(derivatives[i], at.values[i]);
      }
    }
    if (all_agree) break;
  }
  if (!same_impacts) {
    ++counts.left_out;
    return;
  }
  for (std::size_t i = 0; i < derivatives.size(); ++i) {
    const Derivative& of = derivatives[i];
    if (at.values[i] <= nothing) continue;
    if (of.by.size() == 0 && row.kind == Kind::restitution) continue;
    ASSERT_GT(of.by.size(), 0) << "number " << i << " of " << derivatives.size() << " has none";
    EXPECT_NEAR(of.value, at.values[i], 1e-6 * at.values[i]);
    if (of.grazing < 1e-3 || of.is_equalled || of.is_simultaneous) {
      ++counts.left_out;
      continue;
    }
    ++counts.compared;
    for (std::size_t p = 0; p < names.size(); ++p) {
      const auto n = static_cast<Index>(i), m = static_cast<Index>(p);
      EXPECT_LE(errors(n, m), 1e-5 * largest(of, at.values[i]))
          << "number " << i << " by " << names[p] << ", kind " << static_cast<int>(row.kind) << ": " << of.by(p)
          << ", by differences " << differences(n, m) << ", grazing " << of.grazing << " at " << of.time;
    }
  }
}

/// A tenth of those of ./dev soak; BENTUR_RANDOM_ROWS=FIRST:COUNT compares others.
TEST(Tangent, IsThatOfCentralDifferences) {
  const auto [first, count] = test::seeds_of("BENTUR_RANDOM_ROWS", {1, 100}, {1, 10});
  Compared counts;
  for (unsigned seed = first; seed < first + count; ++seed) compare(seed, counts);
  std::printf("%ld numbers compared, %ld left out, %ld rows refused\n", counts.compared, counts.left_out,
              counts.refused);
  EXPECT_GT(counts.compared, 4 * counts.left_out);
}

/// An oscillator, from rest or from a velocity, maybe beside a wall.
System oscillator(double stiffness, double mass, const GroundMotion& motion, double velocity = 0) {
  Problem problem;
  problem.buildings = {make_building("b", stick_model({{3.0}, {mass}, {stiffness}}), ModalDamping{{0.0}})};
  problem.motion = motion;
  problem.initial_displacement = {VectorXd::Zero(1)};
  problem.initial_velocity = {VectorXd::Constant(1, velocity)};
  problem.duration = 1.0;
  return bentur::system_of(problem);
}

TEST(Tangent, OfAnOscillatorUnderHarmonicMotionIsThatOfItsClosedForm) {
  const double mass = 2e4, omega = 11, nu = 7, amplitude = 0.03;
  const auto system = [&](double stiffness) {
    return oscillator(stiffness, mass, HarmonicMotion{2 * std::numbers::pi / nu, amplitude});
  };
  const double stiffness = mass * omega * omega, step = 1e-6 * stiffness;
  const auto run = run_of(system(stiffness));
  const Tangents found = tangents(run.free, run.found, {{step, system(stiffness - step), system(stiffness + step)}});
  const Derivative& peak = found.displacement_free[0][0];
  ASSERT_EQ(peak.by.size(), 1);
  // x = c (sin νt − ν/Ω sin Ωt), c = A ν²/(Ω² − ν²), and its derivative by Ω² = k/m at the instant of the peak.
  const double t = peak.time, gap = omega * omega - nu * nu, c = amplitude * nu * nu / gap;
  const double x = c * (std::sin(nu * t) - nu / omega * std::sin(omega * t));
  const double by_omega =
      -2 * omega / gap * x + c * (nu / (omega * omega) * std::sin(omega * t) - nu / omega * t * std::cos(omega * t));
  const double sign = x > 0 ? 1 : -1;
  EXPECT_NEAR(peak.value, sign * x, 1e-12);
  // 1e-9: the difference of K has ten digits.
  EXPECT_NEAR(peak.by(0), sign * by_omega / (2 * omega * mass), 1e-9 * std::abs(by_omega / (2 * omega * mass)));
}

/// Struck off a wall at w with the speed v₁, v₁² = v₀² − Ω²w², it swings to the other side: x² = w² + e² v₁²/Ω².
TEST(Tangent, OfOneBlowIsThatOfEnergy) {
  const double mass = 2e4, omega = 11, v = 0.4, w = 0.02, e = 0.6;
  const auto system = [&](double width, double restitution, double speed) {
    System one = oscillator(mass * omega * omega, mass, NoMotion{}, speed);
    one.contacts = {
        {{{0, VectorXd::Ones(1), VectorXd::Zero(1), 0}}, std::make_shared<Restitution>(restitution), width}};
    one.duration = 0.4;
    return one;
  };
  constexpr double step = 1e-6;
  const auto run = run_of(system(w, e, v));
  ASSERT_EQ(run.found.impacts.size(), 1u);
  const Tangents found = tangents(run.free, run.found,
                                  {{step, system(w - step, e, v), system(w + step, e, v)},
                                   {step, system(w, e - step, v), system(w, e + step, v)},
                                   {step, system(w, e, v - step), system(w, e, v + step)}});
  const Derivative& peak = found.displacement[0][0];
  ASSERT_EQ(peak.by.size(), 3);
  const double struck = v * v / (omega * omega) - w * w, x = std::sqrt(w * w + e * e * struck);
  EXPECT_NEAR(peak.value, x, 1e-12);
  EXPECT_NEAR(peak.by(0), (1 - e * e) * w / x, 1e-8);
  EXPECT_NEAR(peak.by(1), e * struck / x, 1e-8);
  EXPECT_NEAR(peak.by(2), e * e * v / (omega * omega * x), 1e-8);
  // The gap needed is the free amplitude v₀/Ω.
  EXPECT_NEAR(found.needed[0].by(2), 1 / omega, 1e-8);
  EXPECT_NEAR(found.needed[0].by(0), 0, 1e-12);
}

/// A wall at w that is just reached: the speed there is small beside those on the way.
TEST(Tangent, SaysWhereAContactGrazes) {
  const double mass = 2e4, omega = 11, v = 0.4;
  System one = oscillator(mass * omega * omega, mass, NoMotion{}, v);
  const auto law = std::make_shared<KelvinVoigt>(4e7, 0.3, mass, KelvinVoigt::Release::zero_force);
  one.contacts = {{{{0, VectorXd::Ones(1), VectorXd::Zero(1), 0}}, law, 0.02}};
  const auto grazing = [&](double width) {
    one.contacts[0].width = width;
    const auto run = run_of(one);
    System above = one;
    above.contacts[0].width += 1e-9;
    System below = one;
    below.contacts[0].width -= 1e-9;
    return tangents(run.free, run.found, {{1e-9, below, above}}).peak_force[0].grazing;  // the first contact's
  };
  // The speed at w over the largest, which is that at the start.
  for (const double width : {0.02, 0.036, 0.0363636}) {
    EXPECT_NEAR(grazing(width), std::sqrt(1 - std::pow(omega * width / v, 2)), 1e-3) << width;
  }
}

TEST(Tangent, IsRefusedWhereAForceIsCurvedOrABodyYields) {
  System one = oscillator(1e6, 1e4, NoMotion{}, 0.1);
  EXPECT_FALSE(why_no_tangents(one));
  one.contacts = {{{{0, VectorXd::Ones(1), VectorXd::Zero(1), 0}}, std::make_shared<Hertz>(1e8), 0.001}};
  ASSERT_TRUE(why_no_tangents(one));
  EXPECT_NE(why_no_tangents(one)->find("hertz"), std::string::npos);
  const auto run = run_of(one);
  EXPECT_THROW((void)tangents(run.free, run.found, {}), InvalidParameter);
}

/// The row of the benchmark's kind: two frames of three floors, 10 s of a record every 0.02 s, some dozens of impacts.
Row usual_row() {
  Row row = random_row(1);
  row.kind = Kind::zero_force;
  row.absolute = row.harmonic = false;
  row.floors = {3, 3};
  row.duration = 10;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-3, 3);
  row.record.acceleration.clear();
  for (int n = 0; n < 500; ++n) row.record.acceleration.push_back(any(random));
  row.numbers = {1.0, 2e4, 3.8e7, 0.05, 0.02, 0.004, 4e9, 0.5, 2e4, 2.9e7, 0.05, 0.1};
  return row;
}

/// Processor seconds of one call: a machine that others use, too, is no slower by them.
template <class Do>
double seconds_of(const Do& once) {
  const std::clock_t start = std::clock();
  once();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST(Tangent, OfTenNumbersTakesAsLongAsFourRunsAtMost) {
  const Row row = usual_row();
  const System system = system_of(row, row.numbers);
  std::vector<Variation> variations = variations_of(row, 1e-6);
  variations.resize(10);
  const auto found = run_of(system);
  EXPECT_GT(found.found.impacts.size(), 20u);
  double run = 1e300, tangent = 1e300;  // the least of many taken in turn, so that both see the same machine
  for (int n = 0; n < 25; ++n) {
    run = std::min(run, seconds_of([&] { (void)run_of(system); }));
    tangent = std::min(tangent, seconds_of([&] { (void)tangents(found.free, found.found, variations); }));
  }
  std::printf("run %.3g ms, tangents %.3g ms: %.3g times\n", 1e3 * run, 1e3 * tangent, (run + tangent) / run);
#ifndef BENTUR_SANITIZED
  EXPECT_LE(run + tangent, (1 + 0.3 * 10) * run);
#endif
}

}  // namespace
}  // namespace bentur
