#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "bentur/elements/kinematic_hardening.h"
#include "bentur/elements/link_laws.h"
#include "bentur/elements/peak_oriented.h"
#include "bentur/elements/softening/backbone_law.h"
#include "tests/support/example_laws.h"
#include "tests/support/yielding_buildings.h"

namespace bentur::test {

/// A problem by chance.
struct RandomYielding {
  Problem problem;
  bool straight = true;  ///< no contact is integrated
};

/// Draws rows of two to four sticks of one to eight storeys [m, N, s]: storeys that stay elastic, bilinear and
/// peak-oriented ones; every kind of damping, some of it following the stiffness; every contact law; links of every
/// law; records, harmonic motion, starts out of rest and beyond yield; delays; both kinematics. Or storeys that lose
/// strength in place of those that keep it.
class YieldingGenerator {
 public:
  explicit YieldingGenerator(std::uint64_t seed, bool softening = false) : random_(seed), softening_(softening) {}

  RandomYielding make() {
    RandomYielding result;
    Problem& problem = result.problem;
    peak_ = uniform(0.5, 6);
    problem.duration = uniform(0.8, 2.2);
    const int buildings = among(2, 4);
    for (int b = 0; b < buildings; ++b) problem.buildings.push_back(building());
    for (int b = 0; b + 1 < buildings; ++b) gap(result, b);
    if (chance(0.4)) {
      for (int count = among(1, 2); count > 0; --count) link(problem);
    }
    shake(problem);
    return result;
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double logarithmic(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  bool chance(double p) { return uniform(0, 1) < p; }
  int among(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  Backbone backbone(double stiffness, double yield_force) {
    const double at_yield = yield_force / stiffness;
    Backbone side = {.yield = yield_force, .cap = 1 + uniform(0, 0.3)};
    side.plastic = at_yield * logarithmic(0.5, 5);
    side.softening = at_yield * logarithmic(1, 20);
    side.residual = chance(0.3) ? 0 : uniform(0, 0.6);
    if (chance(0.2)) side.ultimate = at_yield * uniform(4, 15);
    return side;
  }

  /// Of any kind, worn out or not.
  std::shared_ptr<const HystereticLaw> softening(double stiffness, double yield_force) {
    BackboneLaw::Parameters of = {.stiffness = stiffness, .positive = backbone(stiffness, yield_force), .negative = {}};
    of.negative = chance(0.5) ? of.positive : backbone(stiffness, yield_force * uniform(0.6, 1.4));
    of.reloading = static_cast<Reloading>(among(0, 2));
    for (double* gamma : {&of.deterioration.strength, &of.deterioration.cap, &of.deterioration.reloading,
                          &of.deterioration.unloading}) {
      if (chance(0.5)) *gamma = logarithmic(15, 300);
    }
    of.pinching_force = uniform(0.2, 0.9);
    of.pinching_deformation = uniform(0, 0.8);
    return std::make_shared<BackboneLaw>(of);
  }

  std::shared_ptr<const HystereticLaw> hysteresis(double stiffness, double yield_force) {
    if (softening_) return softening(stiffness, yield_force);
    const double hardening = chance(0.3) ? 0 : uniform(0, 0.3);
    if (chance(0.5)) return std::make_shared<KinematicHardening>(stiffness, yield_force, hardening);
    return std::make_shared<PeakOriented>(stiffness, yield_force, hardening, chance(0.4) ? 0 : uniform(0, 1));
  }

  Building building() {
    const int storeys = chance(0.5) ? among(1, 3) : among(1, 8);
    const double mass = logarithmic(1e4, 1e5), omega = 2 * std::numbers::pi / logarithmic(0.15, 1.2);
    const double chain_factor = std::max(1.0, 0.4 * storeys * storeys);
    const double strength = logarithmic(0.1, 1.5) * peak_;  // of the mass above, as an acceleration
    const bool elastic = chance(0.15);
    const double dashpot = chance(0.15) ? 0 : uniform(0.0005, 0.004);
    const double damping = uniform(0, 1);
    std::vector<StickStorey> list;
    for (int j = 0; j < storeys; ++j) {
      StickStorey storey{mass * uniform(0.6, 1.2), mass * omega * omega * chain_factor * uniform(0.6, 1.2)};
      // Proportional to the stiffness, or storey by storey.
      storey.dashpot = dashpot * storey.stiffness * (damping < 0.5 ? 1 : uniform(0.2, 2));
      if (!elastic && !chance(0.25)) {
        storey.law = hysteresis(storey.stiffness, strength * mass * (storeys - j) * uniform(0.7, 1.3));
      }
      list.push_back(storey);
    }
    Building result = yielding_stick(list);
    if (damping < 0.25) {
      result.tangent_damping = dashpot;
    } else if (damping > 0.7) {
      result.modal_damping = modal_damping(ModalDamping{{uniform(0, 0.1)}}, result.modes);
    } else if (damping > 0.6) {
      result.modal_damping = modal_damping(MassProportionalDamping{uniform(0, 0.1)}, result.modes);
    }
    return result;
  }

  void gap(RandomYielding& result, int left) {
    const Building &one = result.problem.buildings[static_cast<std::size_t>(left)],
                   &other = result.problem.buildings[static_cast<std::size_t>(left) + 1];
    const auto floors = static_cast<int>(std::min(one.model.floors(), other.model.floors()));
    const auto laws = example_laws();
    const double kind = uniform(0, 1);
    const double width = kind < 0.1 ? 0 : kind < 0.2 ? logarithmic(1e-9, 1e-4) : uniform(0.0005, 0.03);
    const LawExample* example = &laws[static_cast<std::size_t>(among(0, static_cast<int>(laws.size()) - 1))];
    // From rest, where the damping is divided by next to nothing, hertz-damp takes a hundred thousand steps and more.
    if (width == 0 && example->law == "hertz-damp") example = &laws.front();
    for (int floor = 0; floor < floors; ++floor) {
      if (floor + 1 < floors && chance(0.3)) continue;
      const auto f = static_cast<std::size_t>(floor);
      ContactPoint point = contact(width, 1, floor, left);
      const double m1 = one.model.floor_masses[f], m2 = other.model.floor_masses[f];
      point.law = example->make(m1 * m2 / (m1 + m2));
      result.problem.points.push_back(point);
    }
    result.straight = result.straight && example->straight;
  }

  void link(Problem& problem) {
    const int buildings = static_cast<int>(problem.buildings.size());
    Link result;
    result.left = among(0, buildings - 2);
    result.right = among(static_cast<int>(result.left) + 1, buildings - 1);
    const Building& one = problem.buildings[static_cast<std::size_t>(result.left)];
    const Building& other = problem.buildings[static_cast<std::size_t>(result.right)];
    const Eigen::Index floor = among(0, static_cast<int>(std::min(one.model.floors(), other.model.floors())) - 1);
    result.left_floor = result.right_floor = floor;
    result.elevation = static_cast<double>(floor + 1);
    const double stiffness = logarithmic(0.01, 1) * one.model.stiffness(0, 0);
    const double mass = one.model.floor_masses[0];
    switch (among(0, 3)) {
      case 0:
        result.law = std::make_shared<SpringDashpot>(stiffness, chance(0.5) ? 0 : 0.1 * std::sqrt(stiffness * mass));
        break;
      case 1:
        result.law = std::make_shared<SpringDashpot>(0, 0.2 * std::sqrt(stiffness * mass));
        break;
      case 2:
        result.law = std::make_shared<Cable>(stiffness, chance(0.2) ? 0 : logarithmic(1e-4, 0.03));
        break;
      default:
        result.law = hysteresis(stiffness, logarithmic(0.05, 0.5) * peak_ * mass);
    }
    problem.links.push_back(result);
  }

  void shake(Problem& problem) {
    const double kind = uniform(0, 1);
    if (kind < 0.6) {
      SampledMotion motion{uniform(0.01, 0.03), {0.0}};
      while (static_cast<double>(motion.acceleration.size()) * motion.time_step < 0.8 * problem.duration) {
        motion.acceleration.push_back(0.8 * motion.acceleration.back() + uniform(-peak_, peak_));
      }
      problem.motion = motion;
    } else if (kind < 0.85) {
      HarmonicMotion motion;
      motion.period = logarithmic(0.1, 1.5);
      motion.phase = chance(0.5) ? HarmonicMotion::Phase::sine : HarmonicMotion::Phase::cosine;
      const double nu = 2 * std::numbers::pi / motion.period;
      motion.displacement_amplitude = peak_ / (nu * nu);
      problem.motion = motion;
    }
    if (kind < 0.85 && chance(0.4)) {
      for (std::size_t b = 0; b < problem.buildings.size(); ++b) problem.delays.push_back(uniform(0, 0.3));
    }
    if (chance(0.3)) problem.kinematics = Kinematics::absolute;
    if (kind >= 0.85 || chance(0.15)) start(problem);
  }

  /// Speeds, and in every other case displacements, straight from the ground up: those to the right go further to the
  /// right, so that no gap is closed at first where floors are as high.
  void start(Problem& problem) {
    const bool displaced = chance(0.5);
    double slope = -uniform(0, 0.02);
    for (const Building& building : problem.buildings) {
      const Eigen::VectorXd heights =
          Eigen::VectorXd::LinSpaced(building.model.floors(), 1.0, static_cast<double>(building.model.floors()));
      problem.initial_displacement.emplace_back((displaced ? slope : 0.0) * heights);
      problem.initial_velocity.emplace_back(uniform(-1, 1) / heights.maxCoeff() * heights);
      slope += uniform(0, 0.015);
    }
  }

  std::mt19937_64 random_;
  bool softening_ = false;
  double peak_ = 1;  ///< [m/s²], of the ground acceleration
};

}  // namespace bentur::test
