#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "tests/invariance/random_building.h"

namespace bentur::test {

/// A case by chance, and which of its buildings are alike.
struct RandomCase {
  Case c;
  std::vector<std::size_t> kind;  ///< per building; identical buildings have the same
  bool from_rest = true;
};

/// Draws rows of two to four buildings [m, N, s]: sticks, matrices and frames with every kind of damping; every law in
/// every way that it can be given; gaps that are wide, tiny or exactly zero, and rows that touch throughout, some of
/// them of identical buildings; harmonic motion, records of a few pulses, free vibration; delays; both kinematics.
class CaseGenerator : private BuildingGenerator {
 public:
  using BuildingGenerator::BuildingGenerator;

  RandomCase make() {
    RandomCase result;
    Case& c = result.c;
    c.title = "by chance";
    const int buildings = among(2, 4);
    for (int b = 0; b < buildings; ++b) {
      const bool twin = b > 0 && chance(0.12);
      result.kind.push_back(twin ? result.kind.back() : c.buildings.size());
      c.buildings.push_back(twin ? c.buildings.back() : building());
      c.buildings.back().name = fmt::format("B{}", b);
    }
    const bool all_touch = chance(0.25);
    for (std::size_t b = 0; b + 1 < c.buildings.size(); ++b) {
      c.gaps.push_back(gap(std::min(floors(c.buildings[b]), floors(c.buildings[b + 1])), all_touch));
    }
    if (chance(0.25)) {
      set_in_motion(result);
    } else {
      shake(c);
      if (chance(0.1)) set_in_motion(result);
    }
    return result;
  }

 private:
  GapSpec gap(std::size_t common_floors, bool all_touch) {
    GapSpec result;
    double elevation = 0;
    for (std::size_t f = 0; f < common_floors; ++f) {
      elevation += heights_[f];
      if (f + 1 == common_floors || chance(0.8)) result.elevations.push_back(elevation);
    }
    const double kind = uniform(0, 1);
    const auto width = [&] {
      return all_touch || kind < 0.25 ? 0 : kind < 0.4 ? logarithmic(1e-9, 1e-4) : uniform(0.0005, 0.03);
    };
    result.widths.assign(result.elevations.size(), width());
    if (chance(0.2)) {
      for (double& w : result.widths) w = width();
    }
    int law = among(0, 8);
    // From rest, where the damping is divided by next to nothing, hertz-damp takes a hundred thousand steps and more.
    const bool touches = std::find(result.widths.begin(), result.widths.end(), 0.0) != result.widths.end();
    if (law == hertz_damp && touches && chance(0.98)) law = hertz_damp - 1;
    result.contact = contact_by(law);
    return result;
  }

  static constexpr int hertz_damp = 5;

  ContactSpec contact_by(int law) {
    ContactSpec spec;
    const double stiffness = logarithmic(1e7, 2e9), restitution = chance(0.1) ? 1 : uniform(0.2, 0.95);
    const auto damped = [&](const char* otherwise, double most) {
      if (chance(0.6)) {
        spec.numbers["restitution"] = {restitution};
      } else {
        spec.numbers[otherwise] = {uniform(0, most)};
      }
    };
    static constexpr std::array names = {"linear",    "kelvin-voigt", "kelvin-voigt-approach",
                                         "darmawan",  "hertz",        "hertz-damp",
                                         "jankowski", "bilinear",     "restitution"};
    spec.law = names.at(static_cast<std::size_t>(law));
    if (law == 8) {
      spec.numbers["restitution"] = {restitution};
      return spec;
    }
    spec.numbers["stiffness"] = {law >= 4 && law <= 6 ? 20 * stiffness : stiffness};  // Hertz: N/m^1.5
    if (law == 1) {
      static constexpr std::array releases = {"zero-force", "separation", "creep"};
      const auto release = static_cast<std::size_t>(among(0, 2));
      spec.words["release"] = releases.at(release);
      damped("damping_ratio", release == 1 ? 0.9 : 1.5);
    }
    if (law == 2) damped("damping_ratio", 2.5);
    if (law == 3) spec.numbers["alpha"] = {uniform(0, 2)};
    if (law == 5) damped("damping_factor", 2);
    if (law == 6) damped("damping_ratio", 0.8);
    if (law == 7) {
      const double share = uniform(0.1, 0.9), yield = logarithmic(1e-4, 1e-2);
      if (restitution < 0.6) return filler(stiffness, share, yield);
      spec.numbers["second_stiffness"] = {stiffness * share};
      spec.numbers["yield_penetration"] = {yield};
    }
    return spec;
  }

  static ContactSpec filler(double stiffness, double locking_strain, double yield) {
    ContactSpec spec;
    spec.law = "filler";
    spec.numbers["crushing_force"] = {stiffness * yield};
    spec.numbers["thickness"] = {20 * yield};
    spec.numbers["crushing_strain"] = {0.05};
    spec.numbers["locking_strain"] = {locking_strain};
    spec.numbers["locked_stiffness"] = {3 * stiffness};
    return spec;
  }

  void shake(Case& c) {
    const double peak = uniform(0.5, 6);
    c.analysis.duration = uniform(0.8, 2.2);
    if (chance(0.5)) {
      HarmonicMotion motion;
      motion.period = logarithmic(0.1, 1.5);
      motion.phase = chance(0.5) ? HarmonicMotion::Phase::sine : HarmonicMotion::Phase::cosine;
      motion.displacement_amplitude = peak * motion.period * motion.period / (4 * std::numbers::pi * std::numbers::pi);
      c.excitation.motion = motion;
    } else {
      c.excitation.motion = pulses(peak, c.analysis.duration);
    }
    const double kind = uniform(0, 1);
    const double unit = chance(0.5) ? 0.02 : 0.005;
    for (std::size_t b = 0; b < c.buildings.size(); ++b) {
      c.excitation.delays.push_back(kind < 0.5 ? 0 : kind < 0.75 ? unit * among(0, 12) : uniform(0, 0.2));
    }
    if (chance(0.25)) c.excitation.kinematics = Kinematics::absolute;
  }

  /// Half sines from zero to zero, with rest in between; now and then with rest before.
  SampledMotion pulses(double peak, double duration) {
    static constexpr std::array steps = {0.005, 0.01, 0.02};
    SampledMotion motion{steps.at(static_cast<std::size_t>(among(0, 2))), {0}};
    const auto rest = [&] {
      motion.acceleration.insert(motion.acceleration.end(), static_cast<std::size_t>(among(1, 15)), 0.0);
    };
    if (chance(0.3)) rest();
    while (static_cast<double>(motion.acceleration.size()) * motion.time_step < 0.8 * duration) {
      const int samples = among(2, 25);
      const double size = peak * uniform(-1, 1);
      for (int i = 1; i < samples; ++i) motion.acceleration.push_back(size * std::sin(std::numbers::pi * i / samples));
      motion.acceleration.push_back(0);
      if (chance(0.3)) rest();
    }
    return motion;
  }

  /// Some of the buildings; without ground motion, at least one.
  void set_in_motion(RandomCase& result) {
    Case& c = result.c;
    result.from_rest = false;
    if (std::holds_alternative<NoMotion>(c.excitation.motion)) {
      c.analysis.duration = uniform(0.8, 2.2);
      c.excitation.delays.assign(c.buildings.size(), 0);
    }
    const auto certain = static_cast<std::size_t>(among(0, static_cast<int>(c.buildings.size()) - 1));
    // What overlaps at the start needs a force that parts it.
    const auto has_no_force = [](const GapSpec& gap) { return gap.contact.law == "restitution"; };
    const bool displaced = chance(0.2) && std::none_of(c.gaps.begin(), c.gaps.end(), has_no_force);
    for (std::size_t b = 0; b < c.buildings.size(); ++b) {
      std::vector<double> velocities(floors(c.buildings[b]), 0), displacements(velocities);
      if (b == certain || chance(0.3)) {
        for (double& v : velocities) v = uniform(-1, 1);
        if (displaced) {
          for (double& x : displacements) x = uniform(-0.005, 0.005);
        }
      }
      c.initial.velocities.push_back(velocities);
      if (displaced) c.initial.displacements.push_back(displacements);
    }
  }
};

}  // namespace bentur::test
