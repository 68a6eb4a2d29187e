#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "bentur/pounding/response.h"
#include "tests/invariance/random_case.h"

// What a case may be turned into without anything happening differently, and the way back from its response.

namespace bentur::test {

inline void scale(std::vector<double>& values, double by) {
  for (double& value : values) value *= by;
}

inline GroundMotion scaled(GroundMotion motion, double by) {
  if (auto* sampled = std::get_if<SampledMotion>(&motion)) scale(sampled->acceleration, by);
  if (auto* harmonic = std::get_if<HarmonicMotion>(&motion)) harmonic->displacement_amplitude *= by;
  return motion;
}

/// Seen from behind: the row is reversed and what went left goes right.
inline Case mirrored(Case c) {
  std::reverse(c.buildings.begin(), c.buildings.end());
  for (BuildingSpec& building : c.buildings) {
    if (auto* frame = std::get_if<PlaneFrame>(&building.structure)) {
      std::reverse(frame->bay_widths.begin(), frame->bay_widths.end());
    }
  }
  std::reverse(c.gaps.begin(), c.gaps.end());
  for (LinkSpec& link : c.links) {
    const std::size_t last = c.buildings.size() - 1;
    std::tie(link.left, link.right) = std::pair(last - link.right, last - link.left);
  }
  std::reverse(c.excitation.delays.begin(), c.excitation.delays.end());
  c.excitation.motion = scaled(c.excitation.motion, -1);
  for (auto* initial : {&c.initial.displacements, &c.initial.velocities}) {
    std::reverse(initial->begin(), initial->end());
    for (auto& values : *initial) scale(values, -1);
  }
  return c;
}

/// `of` is the case that was mirrored.
inline Response mirrored_back(Response response, const Problem& of) {
  // Points and watched floors stand gap by gap, each gap from the lowest up.
  const auto places = [&of](const auto& list) {
    std::vector<std::size_t> back;
    for (int left = static_cast<int>(of.buildings.size()) - 2; left >= 0; --left) {
      for (std::size_t i = 0; i < list.size(); ++i) {
        if (list[i].left == left) back.push_back(i);
      }
    }
    return back;
  };
  const auto put_back = [](auto& list, const std::vector<std::size_t>& back) {
    const auto mirrored = list;
    for (std::size_t i = 0; i < list.size(); ++i) list[back[i]] = mirrored[i];
  };
  const std::vector<std::size_t> points = places(of.points);
  std::reverse(response.buildings.begin(), response.buildings.end());
  put_back(response.points, points);
  put_back(response.watched, places(of.watched));
  for (Impact& impact : response.impacts)
    impact.point = static_cast<int>(points[static_cast<std::size_t>(impact.point)]);
  return response;
}

/// Everything `seconds` later, for a case that starts from rest.
inline Case delayed(Case c, double seconds) {
  for (double& delay : c.excitation.delays) delay += seconds;
  c.analysis.duration += seconds;
  return c;
}

/// The same by zeros in front of a record that begins with one.
inline Case padded(Case c, int zeros) {
  auto& motion = std::get<SampledMotion>(c.excitation.motion);
  motion.acceleration.insert(motion.acceleration.begin(), static_cast<std::size_t>(zeros), 0.0);
  c.analysis.duration += zeros * motion.time_step;
  return c;
}

inline Response earlier(Response response, double seconds) {
  for (Impact& impact : response.impacts) {
    impact.start -= seconds;
    impact.end -= seconds;
    impact.peak_force_time -= seconds;
  }
  for (WatchedSummary& floor : response.watched) floor.least_time -= seconds;
  return response;
}

/// Every number of the case changed by a 1e-12th of itself, up or down; what is zero or identical stays so. With odd
/// seeds gaps are wider by the round-off of coordinates, 1e-15 of the farthest displacement.
inline Case perturbed(const RandomCase& random_case, unsigned seed, double farthest) {
  constexpr double size = 1e-12;
  std::mt19937 random(seed);
  const auto nudge = [&random] { return random() % 2 == 0 ? 1 + size : 1 - size; };
  Case c = random_case.c;
  for (std::size_t b = 0; b < c.buildings.size(); ++b) {
    if (b > 0 && random_case.kind[b] == random_case.kind[b - 1]) {
      c.buildings[b].structure = c.buildings[b - 1].structure;
      continue;
    }
    auto& structure = c.buildings[b].structure;
    if (auto* frame = std::get_if<PlaneFrame>(&structure)) {
      frame->elastic_modulus *= nudge();
      for (double& mass : frame->floor_masses) mass *= nudge();
    } else if (auto* stick = std::get_if<Stick>(&structure)) {
      for (double& mass : stick->masses) mass *= nudge();
      for (double& stiffness : stick->stiffnesses) stiffness *= nudge();
    } else {
      std::get<MatricesSpec>(structure).mass *= nudge();
      std::get<MatricesSpec>(structure).stiffness *= nudge();
    }
  }
  for (GapSpec& gap : c.gaps) {
    for (double& width : gap.widths) width = seed % 2 == 1 ? width + 1e-15 * farthest : width * nudge();
    for (auto& [key, values] : gap.contact.numbers) {
      if (key != "restitution") scale(values, nudge());
    }
  }
  c.excitation.motion = scaled(c.excitation.motion, nudge());
  if (auto* sampled = std::get_if<SampledMotion>(&c.excitation.motion)) sampled->time_step *= nudge();
  if (auto* harmonic = std::get_if<HarmonicMotion>(&c.excitation.motion)) harmonic->period *= nudge();
  scale(c.excitation.delays, nudge());
  for (auto& values : c.initial.velocities) {
    for (double& value : values) value *= nudge();
  }
  return c;
}

}  // namespace bentur::test
