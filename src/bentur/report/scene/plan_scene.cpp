#include "bentur/report/scene/plan_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bentur/core/number_text.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/report/scene/scene.h"

namespace bentur {

using Eigen::Index;

PlanInstant telling_instant(const PlanResponse& response, const std::vector<Index>& points) {
  PlanInstant instant;
  const auto is_among = [&](Index point) { return std::find(points.begin(), points.end(), point) != points.end(); };
  for (Index k = 0; k < std::ssize(response.impacts); ++k) {
    const Impact& impact = response.impacts[k];
    if (!is_among(impact.point)) continue;
    if (!instant.impact || is_harder(impact, response.impacts[*instant.impact])) instant.impact = k;
  }
  if (instant.impact) {
    const Impact& impact = response.impacts[*instant.impact];
    instant.point = impact.point;
    instant.time = impact.peak_force > 0 ? impact.peak_force_time : impact.start;
    return instant;
  }
  double least = std::numeric_limits<double>::infinity();
  const PlanHistories& course = response.course.time.empty() ? response.histories : response.course;
  for (const Index point : points) {
    Index nearest = 0;
    const double opening = course.opening.row(point).minCoeff(&nearest);
    if (!(opening < least)) continue;
    least = opening;
    instant.point = point;
    instant.time = course.time[nearest];
  }
  return instant;
}

std::vector<PlanCentre> centres_of(const PlanRun& run) {
  std::vector<PlanCentre> centres;
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const auto* const plan = std::get_if<Plan>(&run.c.buildings[b].structure);
    if (plan == nullptr) continue;
    const PlanModel& model = run.problem.buildings[b].model;
    for (Index floor = 0; floor < model.floors(); ++floor) {
      const PlanPoint& corner = model.footprint.corner;
      centres.push_back({b, floor, corner + model.centres[floor], false});
      const Index storey = floor - model.first_storey();  // a slab on bearings has none below
      if (storey >= 0 && !model.known) centres.push_back({b, floor, corner + centre_of_rigidity(*plan, storey), true});
    }
  }
  return centres;
}

PlanScene::PlanScene(const PlanRun& run) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  lower_ = PlanPoint::Constant(infinite);
  upper_ = -lower_;
  for (const PlanBuilding& building : run.problem.buildings) {
    lower_ = lower_.cwiseMin(building.model.footprint.lower());
    upper_ = upper_.cwiseMax(building.model.footprint.far_corner());
  }
  std::vector<Line> lines;
  for (const PlanGap& gap : run.problem.gaps) {
    Line line{.n = gap.stretch.n, .from = -infinite, .to = infinite};
    for (const StretchCorner& corner : gap.stretch.corners) {
      line.from = std::max(line.from, line.n.dot(corner.left));
      line.to = std::min(line.to, line.n.dot(corner.right));
    }
    if (line.to >= line.from) lines.push_back(line);
  }
  const PlanPoint size = upper_ - lower_;
  double fits = infinite;
  while (!lines.empty()) {
    const PlanPoint n = lines.front().n;
    const auto others = std::stable_partition(lines.begin(), lines.end(), [&](const Line& line) {
      constexpr double one_direction = 1e-9;
      return (line.n - n).norm() <= one_direction;
    });
    std::sort(lines.begin(), others,
              [](const Line& a, const Line& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); });
    const std::size_t first = lines_.size();
    for (auto line = lines.begin(); line != others; ++line) {
      if (lines_.size() > first && line->from <= lines_.back().to) {
        lines_.back().to = std::max(lines_.back().to, line->to);
      } else {
        lines_.push_back(*line);
      }
    }
    lines.erase(lines.begin(), others);
    double wide = 0;
    for (std::size_t i = first; i < lines_.size(); ++i) wide += lines_[i].to - lines_[i].from;
    constexpr double spread = 0.3;  // of the picture
    if (wide > 0) fits = std::min(fits, spread * n.cwiseAbs().dot(size) / wide);
  }
  for (std::size_t b = 0; b < run.problem.buildings.size(); ++b) {
    const PlanHistories& histories = run.response.histories;
    const double side = run.problem.buildings[b].model.footprint.size.maxCoeff();
    for (const auto& [list, arm] :
         {std::pair(&histories.x, 1.0), std::pair(&histories.y, 1.0), std::pair(&histories.rotation, 0.5 * side)}) {
      if ((*list)[b].size() > 0) largest_ = std::max(largest_, arm * (*list)[b].cwiseAbs().maxCoeff());
    }
  }
  constexpr double sway = 0.07;  // of the picture
  if (largest_ > 0) fits = std::min(fits, sway * size.maxCoeff() / largest_);
  magnification_ = std::isfinite(fits) ? std::max(1.0, round_125(fits)) : 1;
  lower_ = PlanPoint::Constant(infinite);
  upper_ = -lower_;
  for (const PlanBuilding& building : run.problem.buildings) {
    for (const std::vector<PlanPoint>& ring : outlines(building.model.footprint)) {
      for (const PlanPoint& at : ring) {
        lower_ = lower_.cwiseMin(place(at));
        upper_ = upper_.cwiseMax(place(at));
      }
    }
  }
}

PlanPoint PlanScene::spread(const PlanPoint& at) const {
  PlanPoint wider = PlanPoint::Zero();
  for (const Line& line : lines_) wider += (std::clamp(line.n.dot(at), line.from, line.to) - line.from) * line.n;
  return wider;
}

PlanPoint PlanScene::place(const PlanPoint& at) const { return at + (magnification_ - 1) * spread(at); }

PlanPoint PlanScene::place(const PlanPoint& at, const PlanPoint& moved) const {
  return place(at) + magnification_ * moved;
}

std::vector<std::vector<PlanPoint>> PlanScene::outlines(const Footprint& footprint) const {
  std::vector<std::vector<PlanPoint>> all;
  for (const std::vector<PlanPoint>& ring : footprint.all_rings()) all.push_back(outline(ring));
  return all;
}

std::vector<PlanPoint> PlanScene::outline(const std::vector<PlanPoint>& corners) const {
  std::vector<PlanPoint> points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PlanPoint &from = corners[i], &to = corners[(i + 1) % corners.size()];
    points.push_back(from);
    std::vector<double> parts;  // of the edge, where a line begins or ends
    for (const Line& line : lines_) {
      const double start = line.n.dot(from), way = line.n.dot(to) - start;
      constexpr double round_off = 1e-9;
      if (std::abs(way) >= (1 - round_off) * (to - from).norm()) continue;  // longer and as straight
      for (const double at : {line.from, line.to}) {
        const double part = (at - start) / way;
        if (part > 0 && part < 1) parts.push_back(part);
      }
    }
    std::sort(parts.begin(), parts.end());
    for (const double part : parts) points.emplace_back(from + part * (to - from));
  }
  points.push_back(points.front());
  return points;
}

Eigen::Vector3d floor_motion(const PlanHistories& histories, Index building, Index floor, double time) {
  const std::vector<double>& times = histories.time;
  const auto after = std::lower_bound(times.begin(), times.end(), time);
  const Index last = std::ssize(times) - 1;
  const Index right = std::min<Index>(after - times.begin(), last), left = std::max<Index>(right - 1, 0);
  const double length = times[right] - times[left];
  const double part = length > 0 ? std::clamp((time - times[left]) / length, 0.0, 1.0) : 1;
  const auto value = [&](const std::vector<Eigen::MatrixXd>& list) {
    return (1 - part) * list[building](floor, left) + part * list[building](floor, right);
  };
  return {value(histories.x), value(histories.y), value(histories.rotation)};
}

PlanPoint movement_of(const PlanModel& model, Index floor, const PlanPoint& at, const Eigen::Vector3d& motion) {
  const auto along = [&](const PlanPoint& axis) -> Eigen::Vector3d {
    return model.movement(floor, at, axis).segment<3>(3 * floor);
  };
  return {along(PlanPoint::UnitX()).dot(motion), along(PlanPoint::UnitY()).dot(motion)};
}

std::string along_text(const PlanRun& run, Index contact) {
  const PlanContactPlace place = contact_at(run.problem, contact);
  const Stretch& stretch = run.problem.gaps[place.gap].stretch;
  if (stretch.is_oblique() || !place.contact->is_of_joint()) {
    return fmt::format("x = {}, y = {} {}", number(place.at.x()), number(place.at.y()), run.c.units.length);
  }
  return fmt::format("{} = {} {}", stretch.across == 0 ? "y" : "x", number(place.contact->along), run.c.units.length);
}

bool lies_in(const PlanPoint& at, const PlanRings& rings) {
  const auto rounds = std::count_if(rings.begin(), rings.end(), [&](const auto& ring) { return goes_round(ring, at); });
  return rounds % 2 == 1;
}

namespace {

/// Parts of the way from a point to the next at which it crosses the edge of an area, with both ends, ascending.
std::vector<double> crossings(const PlanPoint& from, const PlanPoint& to, const std::vector<PlanRings>& areas) {
  std::vector<double> parts{0, 1};
  const auto cross = [](const PlanPoint& a, const PlanPoint& b) { return a.x() * b.y() - a.y() * b.x(); };
  const PlanPoint way = to - from;
  for (const PlanRings& rings : areas) {
    for (const std::vector<PlanPoint>& ring : rings) {
      for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        const PlanPoint edge = ring[i + 1] - ring[i], apart = ring[i] - from;
        const double both = cross(way, edge);
        const double here = cross(apart, edge) / both, there = cross(apart, way) / both;  // no number: parallel
        if (here > 0 && here < 1 && there >= 0 && there <= 1) parts.push_back(here);
      }
    }
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

}  // namespace

PlanRings seen_parts(const std::vector<PlanPoint>& ring, const std::vector<PlanRings>& areas) {
  PlanRings seen;
  bool goes_on = false;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    const PlanPoint &from = ring[i], &to = ring[i + 1];
    const std::vector<double> parts = crossings(from, to, areas);
    for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
      const auto at = [&](double part) -> PlanPoint { return from + part * (to - from); };
      const PlanPoint middle = at((parts[k] + parts[k + 1]) / 2);
      const bool hidden =
          std::any_of(areas.begin(), areas.end(), [&](const PlanRings& rings) { return lies_in(middle, rings); });
      if (!hidden && !goes_on) seen.push_back({at(parts[k])});
      if (!hidden) seen.back().push_back(at(parts[k + 1]));
      goes_on = !hidden;
    }
  }
  return seen;
}

bool is_at(const PlanLink& link, const std::vector<Index>& floors, const PlanProblem& problem) {
  const auto is_nearest = [&](Index b) {
    return nearest_floor(problem.buildings[b].model, link.link.elevation) == floors.at(static_cast<std::size_t>(b));
  };
  return is_nearest(link.link.left) && is_nearest(link.link.right);
}

Index nearest_floor(const PlanModel& model, double elevation) {
  const auto near = std::min_element(model.elevations.begin(), model.elevations.end(), [&](double a, double b) {
    return std::abs(a - elevation) < std::abs(b - elevation);
  });
  return near - model.elevations.begin();
}

}  // namespace bentur
