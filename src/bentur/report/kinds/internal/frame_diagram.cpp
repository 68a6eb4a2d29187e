#include "bentur/report/kinds/internal/frame_diagram.h"

#include <algorithm>
#include <cmath>

#include "bentur/core/not_known.h"
#include "bentur/report/kinds/internal/convex_area.h"

namespace bentur {
namespace {

void stop(Curve& curve) {
  curve.x.push_back(not_known);
  curve.y.push_back(not_known);
}

void add(Curve& curve, const std::pair<double, double>& place) {
  curve.x.push_back(place.first);
  curve.y.push_back(place.second);
}

}  // namespace

std::vector<double> Carried::of(const FrameForces::Forces& forces, Eigen::Index member) const {
  if (!is_moment) return std::vector(2, (is_axial ? forces.axial : forces.shears)(member));
  const auto column = forces.moments.col(member);
  return {column.begin(), column.end()};
}

std::vector<double> Carried::stations() const {
  if (!is_moment) return {0, 1};
  return {std::begin(MemberForces::stations), std::end(MemberForces::stations)};
}

std::pair<double, double> Diagram::at(Eigen::Index member, double station, double value) const {
  const FrameMember& of = frame_->members[member];
  const double along = of.from + station * of.length();
  return of.of_beam ? std::pair(along, of.place - scale_ * value) : std::pair(of.place + scale_ * value, along);
}

Curve Diagram::members(Tone tone, const std::string& label) const {
  Curve lines{.label = label, .tone = tone, .width = 1.2, .complete = true, .in_legend = false};
  for (Eigen::Index n = 0; n < std::ssize(frame_->members); ++n) {
    for (const double station : {0.0, 1.0}) add(lines, at(n, station, 0));
    stop(lines);
  }
  return lines;
}

std::vector<Diagram::Station> Diagram::stations_of(const Band& band, Eigen::Index member) const {
  // What no eye sees is nothing, so that round-off makes no other areas.
  const auto seen = [&](const FrameForces::Forces& forces) {
    constexpr double of_length = 1e-6;
    std::vector<double> values = carried_->of(forces, member);
    for (double& one : values) {
      if (std::abs(scale_ * one) < of_length * frame_->members[member].length()) one = 0;
    }
    return values;
  };
  const std::vector<double> along = carried_->stations(), high = seen(*band.high);
  const std::vector<double> low = band.low != nullptr ? seen(*band.low) : std::vector<double>{};
  std::vector<Station> all;
  for (std::size_t k = 0; k < high.size(); ++k) {
    if (!low.empty()) {
      all.push_back({along[k], low[k], high[k]});
      continue;
    }
    if (k > 0 && high[k - 1] * high[k] < 0) {  // where a diagram passes its member
      all.push_back({along[k - 1] + (along[k] - along[k - 1]) * high[k - 1] / (high[k - 1] - high[k]), 0, 0});
    }
    all.push_back({along[k], std::fmin(0.0, high[k]), std::fmax(0.0, high[k])});
  }
  return all;
}

Curve Diagram::area(const Band& band, bool of_beams, Curve style) const {
  for (Eigen::Index n = 0; n < std::ssize(frame_->members); ++n) {
    if (frame_->members[n].of_beam != of_beams || std::isnan(carried_->of(*band.high, n).front())) continue;
    const std::vector<Station> stations = stations_of(band, n);
    const auto corner = [&](double along, double value) {
      const auto [x, y] = at(n, along, value);
      return Eigen::Vector2d(x, y);
    };
    for (std::size_t k = 1; k < stations.size(); ++k) {
      const Station &from = stations[k - 1], &to = stations[k];
      add_area(style, {corner(from.along, from.low), corner(from.along, from.high), corner(to.along, to.high),
                       corner(to.along, to.low)});
    }
  }
  return style;
}

Curve Diagram::outline(const Band& band, bool of_beams, Curve style) const {
  for (Eigen::Index n = 0; n < std::ssize(frame_->members); ++n) {
    if (frame_->members[n].of_beam != of_beams || std::isnan(carried_->of(*band.high, n).front())) continue;
    const std::vector<double> along = carried_->stations(), high = carried_->of(*band.high, n);
    if (band.low == nullptr) {
      add(style, at(n, 0, 0));
      for (std::size_t k = 0; k < high.size(); ++k) add(style, at(n, along[k], high[k]));
      add(style, at(n, 1, 0));
    } else {
      const std::vector<double> low = carried_->of(*band.low, n);
      for (std::size_t k = 0; k < low.size(); ++k) add(style, at(n, along[k], low[k]));
      if (of_beams) stop(style);
      for (std::size_t k = high.size(); k-- > 0;) add(style, at(n, along[k], high[k]));
      if (!of_beams) add(style, at(n, along.front(), low.front()));
    }
    stop(style);
  }
  return style;
}

}  // namespace bentur
