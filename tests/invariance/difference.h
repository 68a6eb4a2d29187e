#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bentur/pounding/response.h"

namespace bentur::test {

inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double weak = 1e-3;     // of the hardest impact: weaker ones are known to its errors
inline constexpr double nothing = 1e-9;  // of the hardest impact: a rest under so little ends when round-off says so
inline constexpr double same = 1e-6;     // relative: what two descriptions of one case may differ by

/// How far two responses are apart, and in what.
struct Difference {
  double size = 0;  ///< relative; infinite where the impacts are not the same ones
  std::string what;
  void note(double a, double b, double scale, const std::string& of) {
    const double apart = std::abs(a - b) / scale;
    if (apart > size || (std::isnan(apart) && size < infinite)) {
      size = std::isnan(apart) ? infinite : apart;
      what = fmt::format("{}: {:.17g} and {:.17g}", of, a, b);
    }
  }
};

inline std::vector<Impact> impacts_at(const Response& response, int point) {
  std::vector<Impact> list;
  for (const Impact& impact : response.impacts) {
    if (impact.point == point) list.push_back(impact);
  }
  return list;
}

inline double largest(const Response& response, double Impact::*member) {
  double most = 0;
  for (const Impact& impact : response.impacts) most = std::max(most, impact.*member);
  return most;
}

inline double largest(const Response& response, Eigen::VectorXd BuildingPeaks::*member) {
  double most = 0;
  for (const BuildingPeaks& peaks : response.buildings) most = std::max(most, (peaks.*member).maxCoeff());
  return most;
}

inline double farthest_displacement(const Response& response) {
  const double farthest = std::max({std::numeric_limits<double>::min(), largest(response, &BuildingPeaks::displacement),
                                    largest(response, &BuildingPeaks::displacement_no_contact)});
  return farthest;
}

inline Difference difference(const Response& one, const Response& other, double duration) {
  Difference result;
  if (one.status != Status::done || other.status != Status::done) {
    return {infinite, fmt::format("status {} and {}: {}{}", static_cast<int>(one.status),
                                  static_cast<int>(other.status), one.message, other.message)};
  }
  const double hardest = largest(one, &Impact::impulse), strongest = largest(one, &Impact::peak_force);
  const double farthest = farthest_displacement(one);  // gaps needed are differences of such ways
  for (int point = 0; point < static_cast<int>(one.points.size()); ++point) {
    const std::vector<Impact> a = impacts_at(one, point), b = impacts_at(other, point);
    if (a.size() != b.size()) {
      std::size_t i = 0;
      while (i < std::min(a.size(), b.size()) && std::abs(a[i].start - b[i].start) <= same * duration) ++i;
      return {infinite,
              fmt::format("point {}: {} impacts and {}, the first other one at {:.9g} and {:.9g}", point, a.size(),
                          b.size(), i < a.size() ? a[i].start : -1, i < b.size() ? b[i].start : -1)};
    }
    const PointSummary &p = one.points[static_cast<std::size_t>(point)],
                       &q = other.points[static_cast<std::size_t>(point)];
    result.note(p.gap_needed, q.gap_needed, farthest, "gap needed");
    for (std::size_t i = 0; i < a.size(); ++i) {
      const auto of = [&](const char* what) { return fmt::format("point {}, impact {}, {}", point, i, what); };
      result.note(a[i].start, b[i].start, duration, of("start"));
      const bool ends = a[i].impulse > nothing * hardest;
      if (ends) result.note(a[i].end, b[i].end, duration, of("end"));
      const double length = ends ? a[i].end - a[i].start : 0;
      const double weakness = a[i].impulse > 0 ? std::max(1.0, weak * hardest / a[i].impulse) : 1.0;
      if (length > 0) result.note(length, b[i].end - b[i].start, length * weakness, of("duration"));
      const auto of_impact = [&](double Impact::*member, double most, const char* what) {
        const double scale = std::max(a[i].*member, weak * most);
        if (scale > 0) result.note(a[i].*member, b[i].*member, scale, of(what));
      };
      of_impact(&Impact::peak_force, strongest, "peak force");
      of_impact(&Impact::impulse, hardest, "impulse");
    }
  }
  for (std::size_t b = 0; b < one.buildings.size(); ++b) {
    const auto note = [&](Eigen::VectorXd BuildingPeaks::*member, const char* what) {
      const double scale = largest(one, member);
      for (Eigen::Index f = 0; f < (one.buildings[b].*member).size() && scale > 0; ++f) {
        result.note((one.buildings[b].*member)(f), (other.buildings[b].*member)(f), scale,
                    fmt::format("building {}, floor {}, {}", b, f, what));
      }
    };
    note(&BuildingPeaks::displacement, "peak displacement");
    note(&BuildingPeaks::acceleration, "peak acceleration");
    note(&BuildingPeaks::storey_shear, "peak shear");
  }
  for (std::size_t i = 0; i < one.watched.size(); ++i) {
    const WatchedSummary &a = one.watched[i], &b = other.watched[i];
    const double scale = std::max(farthest, std::abs(a.least_opening));
    result.note(a.gap_needed, b.gap_needed, scale, fmt::format("gap needed by watched floor {}", i));
    result.note(a.least_opening, b.least_opening, scale, fmt::format("least opening {}", i));
  }
  return result;
}

}  // namespace bentur::test
