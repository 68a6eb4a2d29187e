#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "tests/invariance/random_building.h"

namespace bentur::test {

/// Draws rows of two or three buildings of every kind [m, N, s] whose floors are at the same heights: sticks that
/// yield, on bearings or on soil, with gravity loads, frames with or without struck columns, given matrices, buildings
/// known by their modes or by little, walls; links of every law. Some of them stand exactly still, for a time or for
/// good.
class EveryKindGenerator : private BuildingGenerator {
 public:
  using BuildingGenerator::BuildingGenerator;

  Case make() {
    Case c;
    c.title = "every kind, by chance";
    const int count = among(2, 3);
    for (int b = 0; b < count; ++b) {
      c.buildings.push_back(b == 0 && chance(0.1) ? wall() : of_any_kind());
      c.buildings.back().name = fmt::format("B{}", b);
    }
    for (int b = 0; b + 1 < count; ++b) {
      GapSpec gap;
      gap.elevations = {heights_[0]};
      gap.widths = {chance(0.15) ? 0.0 : logarithmic(1e-4, 0.02)};
      const auto left = static_cast<std::size_t>(b);
      if (chance(0.3)) strike_a_column(gap, c.buildings[left], c.buildings[left + 1]);
      static const std::vector<std::string> laws = {"linear",      "kelvin-voigt", "kelvin-voigt-approach",
                                                    "restitution", "hertz",        "hertz-damp"};
      // Force laws that are no straight lines are integrated, which takes longer.
      gap.contact.law = laws[static_cast<std::size_t>(among(0, chance(0.2) && gap.widths[0] > 0 ? 5 : 3))];
      gap.contact.numbers["restitution"] = {uniform(0.3, 0.9)};
      if (gap.contact.law == "linear" || gap.contact.law == "hertz") gap.contact.numbers.clear();
      if (gap.contact.law != "restitution") gap.contact.numbers["stiffness"] = {logarithmic(1e7, 1e9)};
      c.gaps.push_back(gap);
    }
    if (chance(0.5)) c.links.push_back(link(static_cast<std::size_t>(among(0, count - 2))));
    move(c);
    return c;
  }

 private:
  BuildingSpec of_any_kind() {
    const double kind = uniform(0, 1);
    if (kind < 0.15) return building();
    BuildingSpec spec;
    spec.damping = ModalDamping{{uniform(0.01, 0.1)}};
    spec.gravity = 9.81;
    const std::vector<double> heights(heights_.begin(), heights_.begin() + among(1, 3));
    if (kind < 0.25) {
      PlaneFrame plane = frame(heights);
      spec.structure = plane;
    } else if (kind < 0.35) {
      ModalBuilding modal;
      modal.elevations = {heights_[0], heights_[0] + heights_[1]};
      const double mass = logarithmic(1e4, 8e4), period = uniform(0.2, 0.8);
      modal.masses = {mass, mass};
      modal.modes.periods = {period, 0.35 * period};
      modal.modes.shapes = {{0.6, 1.0}, {1.0, -0.6}};
      if (chance(0.3)) {
        modal.modes.periods.pop_back();
        modal.modes.shapes.pop_back();
      }
      spec.structure = modal;
    } else if (kind < 0.45) {
      GenericBuilding generic;
      generic.storey_heights = heights;
      generic.floor_masses.assign(heights.size(), logarithmic(1e4, 8e4));
      generic.period = uniform(0.2, 0.9);
      generic.stiffness_ratio = chance(0.5) ? 30.0 : uniform(0, 20);
      if (generic.stiffness_ratio >= 30 && chance(0.6)) generic.yield_base_shear = uniform(0.05, 0.4);
      spec.structure = generic;
    } else {
      Stick one = stick(heights);
      if (chance(0.7)) {
        for (std::size_t f = 0; f < heights.size(); ++f) {
          one.yield_forces.push_back(logarithmic(0.5, 8) * one.masses[f] * static_cast<double>(heights.size() - f));
        }
        one.hardening = {chance(0.5) ? 0.0 : 0.05};
        one.hysteresis = chance(0.5) ? "bilinear" : "peak-oriented";
      }
      spec.p_delta = chance(0.3);
      const double mass = one.masses[0], stiffness = one.stiffnesses[0];
      const double support = uniform(0, 1);
      if (support < 0.3) {
        IsolationSpec isolation;
        isolation.mass = mass;
        isolation.numbers = {{"stiffness", 0.03 * stiffness},
                             {"characteristic_strength", chance(0.7) ? uniform(0.2, 1.0) * mass : 0.0},
                             {"yield_displacement", 0.005}};
        spec.isolation = isolation;
      } else if (support < 0.5) {
        SoilSpec soil;
        soil.soil = {{5 * stiffness, 0.01 * stiffness}, {200 * stiffness, 0.2 * stiffness}, mass, 10 * mass};
        spec.soil = soil;
      }
      spec.structure = one;
    }
    return spec;
  }

  BuildingSpec wall() {
    BuildingSpec spec;
    spec.structure = RigidSpec{{0.0, heights_[0]}};
    return spec;
  }

  /// Where one of both is a frame, at a third of a storey of it: the other's floors are moved there.
  void strike_a_column(GapSpec& gap, BuildingSpec& left, BuildingSpec& right) {
    auto* frame = std::get_if<PlaneFrame>(&left.structure);
    BuildingSpec& other = frame != nullptr ? right : left;
    if (frame == nullptr) frame = std::get_if<PlaneFrame>(&right.structure);
    auto* stick = std::get_if<Stick>(&other.structure);
    if (frame == nullptr || stick == nullptr || stick->masses.size() > 1 || other.isolation || other.soil) return;
    stick->storey_heights = {0.6 * heights_[0]};
    gap.elevations = {0.6 * heights_[0]};
    gap.strikes_columns = true;
  }

  LinkSpec link(std::size_t left) {
    LinkSpec spec;
    spec.left = left;
    spec.right = left + 1;
    spec.elevations = {heights_[0]};
    static const std::vector<std::string> laws = {"spring-dashpot", "cable", "yielding"};
    spec.law = laws[static_cast<std::size_t>(among(0, 2))];
    spec.numbers["stiffness"] = {logarithmic(1e5, 1e7)};
    if (spec.law == "spring-dashpot") spec.numbers["damping"] = {logarithmic(1e3, 1e5)};
    if (spec.law == "cable") spec.numbers["slack"] = {logarithmic(1e-4, 1e-2)};
    if (spec.law == "yielding") spec.numbers["yield_force"] = {logarithmic(1e3, 1e5)};
    return spec;
  }

  void move(Case& c) {
    c.analysis.duration = uniform(0.8, 2.0);
    c.excitation.delays.assign(c.buildings.size(), 0.0);
    const double kind = uniform(0, 1);
    if (kind < 0.7) {
      SampledMotion motion{0.01 + 0.01 * among(0, 1), {0.0}};
      const double peak = uniform(1, 6);
      while (static_cast<double>(motion.acceleration.size()) * motion.time_step < c.analysis.duration) {
        motion.acceleration.push_back(0.7 * motion.acceleration.back() + uniform(-peak, peak));
      }
      c.excitation.motion = motion;
      // The wave comes to all but the first building late, or never.
      if (chance(0.5)) c.excitation.delays.back() = chance(0.3) ? 5.0 : uniform(0.1, 1.0);
    } else {
      c.excitation.motion = NoMotion{};
    }
    if (kind < 0.4) return;
    // The first one that can starts with a speed; the others stand still, or wait for the wave.
    for (std::size_t b = 0; b < c.buildings.size(); ++b)
      c.initial.velocities.emplace_back(floors_of(c.buildings[b]), 0);
    const std::size_t first = std::holds_alternative<RigidSpec>(c.buildings[0].structure) ? 1 : 0;
    const bool away = chance(0.5);
    for (std::size_t f = 0; f < c.initial.velocities[first].size(); ++f) {
      c.initial.velocities[first][f] = (f % 2 == 0) == away ? -uniform(0, 1) : uniform(0, 1);
    }
  }

  static std::size_t floors_of(const BuildingSpec& building) { return make_building(building).model.elevations.size(); }
};

}  // namespace bentur::test
