#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "bentur/pounding/plan/faces.h"

// Houses whose outlines turn inwards, by chance.
namespace bentur::test {

inline Footprint told(std::vector<PlanPoint> corners, std::vector<std::vector<PlanPoint>> courts = {}) {
  return polygon_footprint({0, 0}, std::move(corners), std::move(courts));
}

/// `x` by `y` with its lower left corner at `at`, turned about that.
inline Footprint box(const PlanPoint& at, double x, double y) {
  return told({at, at + PlanPoint(x, 0), at + PlanPoint(x, y), at + PlanPoint(0, y)});
}

/// An L, of which the upper right is left out.
inline Footprint l_shape(const PlanPoint& at, double x, double y, double arm, double leg) {
  return told({at, at + PlanPoint(x, 0), at + PlanPoint(x, arm), at + PlanPoint(leg, arm), at + PlanPoint(leg, y),
               at + PlanPoint(0, y)});
}

class Shapes {
 public:
  explicit Shapes(unsigned seed) : engine_(seed) {}

  double any(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
  int among(int from, int to) { return std::uniform_int_distribution<int>(from, to)(engine_); }

  /// A star with so many arms, by chance with a court.
  Footprint star() {
    std::vector<PlanPoint> corners, court;
    const int count = among(5, 14);
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * (i + any(0, 0.5)) / count;
      corners.push_back(any(4, 12) * PlanPoint(std::cos(angle), std::sin(angle)));
    }
    for (int i = 0, n = among(3, 6); i < n; ++i) {
      const double angle = 2 * std::numbers::pi * (i + any(0, 0.5)) / n;
      court.push_back(any(0.3, 1.2) * PlanPoint(std::cos(angle), std::sin(angle)));
    }
    if (fault_of_outline(corners)) return star();
    Footprint made = told(corners);
    if (any(0, 1) < 0.5) return made;
    Footprint with = told(corners, {court});
    return fault_of_outline(court) || fault_of_court(with, 0) ? made : with;
  }

  Footprint turned(const Footprint& from, double angle) {
    Footprint made = from;
    const PlanPoint middle = from.corner + from.middle();
    const auto turn = [&](std::vector<PlanPoint>& ring) {
      for (PlanPoint& at : ring) at = middle + Eigen::Rotation2Dd(angle) * (at - middle);
    };
    made.polygon = from.corners();
    made.corner = {0, 0};
    turn(made.polygon);
    for (auto& ring : made.rings) turn(ring);
    return told(made.polygon, made.rings);
  }

 private:
  std::mt19937 engine_;
};

/// Houses around one that turns inwards, some of them in its notch, its court or between its wings.
inline std::vector<Footprint> footprints(Shapes& by) {
  const auto joint = [&] { return by.any(0.004, 0.03); };
  const double x = by.any(16, 24), y = by.any(14, 20), arm = by.any(4, 6), leg = by.any(4, 6);
  const double g = joint(), h = joint();
  const int kind = by.among(0, 5);
  std::vector<Footprint> all;
  if (kind == 0) {  // a house in the notch of an L, and one before it
    all = {l_shape({0, 0}, x, y, arm, leg), box({leg + g, arm + h}, by.any(4, 8), by.any(4, 7)),
           box({x + joint(), by.any(-2, 3)}, by.any(6, 9), by.any(6, 9)),
           box({by.any(-9, 3), -8 - joint()}, by.any(6, 9), 8)};
  } else if (kind == 1) {  // between the wings of a U
    const double wide = by.any(5, 8);
    all = {told({{0, 0},
                 {2 * leg + wide, 0},
                 {2 * leg + wide, y},
                 {leg + wide, y},
                 {leg + wide, arm},
                 {leg, arm},
                 {leg, y},
                 {0, y}}),
           box({leg + g, arm + h}, wide - g - joint(), by.any(4, 7))};
  } else if (kind == 2) {  // in a court
    all = {told({{0, 0}, {x, 0}, {x, y}, {0, y}}, {{{leg, arm}, {x - leg, arm}, {x - leg, y - arm}, {leg, y - arm}}}),
           box({leg + g, arm + h}, x - 2 * leg - g - joint(), y - 2 * arm - h - joint()),
           box({-8 - joint(), by.any(-3, 3)}, 8, by.any(6, 9))};
  } else if (kind == 3) {  // on both sides of the stem of a T
    const double from = 0.5 * (x - leg);
    all = {told({{from, 0},
                 {from + leg, 0},
                 {from + leg, y - arm},
                 {x, y - arm},
                 {x, y},
                 {0, y},
                 {0, y - arm},
                 {from, y - arm}}),
           box({from - g - 6, y - arm - h - 7}, 6, 7), box({from + leg + joint(), y - arm - joint() - 8}, 5, 8)};
  } else if (kind == 4) {  // four L's around a crossing
    const auto mirrored = [](const Footprint& from, double sx, double sy) {
      std::vector<PlanPoint> corners = from.corners();
      for (PlanPoint& at : corners) at = {sx * at.x(), sy * at.y()};
      return told(corners);
    };
    const double w = 0.5 * by.any(0.002, 0.03);
    for (const double sx : {1.0, -1.0}) {
      for (const double sy : {1.0, -1.0}) {
        all.push_back(
            mirrored(l_shape({w, 0.5 * g}, by.any(9, 14), by.any(9, 14), by.any(3, 5), by.any(3, 5)), sx, sy));
      }
    }
  } else {  // steps of a façade before a long house, with a bay that is round
    std::vector<PlanPoint> corners = {{0, 0}, {x, 0}, {x, 6}};
    const double step = by.any(0.01, 0.08);
    for (int i = 0; i <= 8; ++i) {
      const double angle = std::numbers::pi * i / 8;
      corners.emplace_back(0.5 * x + 2 + 2 * std::cos(angle), 6 + step * std::sin(angle));
    }
    corners.insert(corners.end(), {{0.3 * x, 6}, {0.3 * x, 6 - step}, {0, 6 - step}});
    all = {told(corners), box({by.any(-3, 3), 6 + step + g}, x, 7)};
  }
  if (by.any(0, 1) < 0.4) {
    for (Footprint& one : all) one = by.turned(one, by.any(-0.001, 0.001));
  }
  std::vector<Footprint> apart;
  for (const Footprint& one : all) {
    if (std::none_of(apart.begin(), apart.end(), [&](const Footprint& other) { return overlap(one, other); })) {
      apart.push_back(one);
    }
  }
  return apart;
}

}  // namespace bentur::test
