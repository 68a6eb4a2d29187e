#include "bentur/report/kinds/internal/free_place.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "bentur/report/figures/box.h"
#include "bentur/report/figures/internal/text_width.h"

namespace bentur {
namespace {

constexpr double high = 0.32;     // of a text [cm]
constexpr double clear = 0.12;    // around it [cm]
constexpr double of_mark = 0.04;  // half of one of size 1 [cm]
constexpr double furthest = 1;    // from its point [cm]

Box around(double x, double y, double half_width, double half_height) {
  return {x - half_width, x + half_width, y - half_height, y + half_height};
}

struct Segment {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  [[nodiscard]] double distance(double x, double y) const {
    const double dx = x1 - x0, dy = y1 - y0, square = dx * dx + dy * dy;
    const double part = square > 0 ? std::clamp(((x - x0) * dx + (y - y0) * dy) / square, 0.0, 1.0) : 0;
    return std::hypot(x - x0 - part * dx, y - y0 - part * dy);
  }
  /// The side of this line on which a place lies, by its sign.
  [[nodiscard]] double side(double x, double y) const { return (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0); }
  /// Whether both cross, or come nearer to one another than that.
  [[nodiscard]] bool meets(const Segment& other, double near) const {
    const auto is_beyond = [near](double a0, double a1, double b0, double b1) {
      return std::max(a0, a1) + near < std::min(b0, b1) || std::max(b0, b1) + near < std::min(a0, a1);
    };
    if (is_beyond(x0, x1, other.x0, other.x1) || is_beyond(y0, y1, other.y0, other.y1)) return false;
    if (side(other.x0, other.y0) * side(other.x1, other.y1) < 0 && other.side(x0, y0) * other.side(x1, y1) < 0) {
      return true;
    }
    return std::min({distance(other.x0, other.y0), distance(other.x1, other.y1), other.distance(x0, y0),
                     other.distance(x1, y1)}) < near;
  }
};

double distance(const Box& box, double x, double y) {
  return std::hypot(std::max({0.0, box.left - x, x - box.right}), std::max({0.0, box.bottom - y, y - box.top}));
}

/// Lines, dots and texts of a panel near a point, on which a text beside it should not lie.
struct Obstacles {
  std::vector<Segment> lines, uncrossed;
  std::vector<Box> dots, texts, areas;

  [[nodiscard]] bool is_on_area(const Box& box) const {
    return std::any_of(areas.begin(), areas.end(), [&](const Box& one) { return box.meets(one); });
  }

  [[nodiscard]] bool has_other(const Box& box) const {
    const auto is_met = [&](const Box& one) { return box.meets(one); };
    return std::any_of(dots.begin(), dots.end(), is_met) || std::any_of(texts.begin(), texts.end(), is_met);
  }
  [[nodiscard]] int lines_below(const Box& box) const {
    return static_cast<int>(std::count_if(
        lines.begin(), lines.end(), [&](const Segment& one) { return box.meets(one.x0, one.y0, one.x1, one.y1); }));
  }
  /// What a line from (x, y) costs by the others it meets [cm]: members, and lines that it goes along or across.
  [[nodiscard]] double met_by(const Segment& leader, double x, double y, double near) const {
    constexpr double of_member = 10, along = 1, across = 0.12;
    double cost = 0;
    for (const Segment& one : uncrossed) cost += one.meets(leader, near) ? of_member : 0;
    for (const Segment& one : lines) {
      if (one.meets(leader, near)) cost += one.distance(x, y) < near ? along : across;
    }
    return cost;
  }
  /// How far the nearest of all dots but the one at (x, y) is from a box.
  [[nodiscard]] double to_others(const Box& box, double x, double y) const {
    double nearest = INFINITY;
    for (const Box& dot : dots) {
      const double at_x = (dot.left + dot.right) / 2, at_y = (dot.bottom + dot.top) / 2;
      const bool is_own = std::hypot(at_x - x, at_y - y) < (dot.right - dot.left) / 10;
      if (!is_own) nearest = std::min(nearest, distance(box, at_x, at_y));
    }
    return nearest;
  }
};

/// The lines of a curve that pass through a box.
std::vector<Segment> lines_in(const Curve& curve, const Box& near) {
  std::vector<Segment> found;
  for (std::size_t i = 1; i < curve.x.size() && curve.line != Line::none; ++i) {
    const Segment one{curve.x[i - 1], curve.y[i - 1], curve.x[i], curve.y[i]};
    if (std::isnan(one.x0) || std::isnan(one.x1)) continue;
    if (near.meets(one.x0, one.y0, one.x1, one.y1)) found.push_back(one);
  }
  return found;
}

/// @param near the box within which they count
Obstacles obstacles_of(const Panel& panel, const Curve& uncrossed, const Box& near, double one_cm) {
  Obstacles found;
  found.uncrossed = lines_in(uncrossed, near);
  for (const PlaceText& one : panel.texts) {
    const double half = one_cm * text_width(one.text) / 2;
    const double right = one.side == PlaceText::Side::right ? half : one.side == PlaceText::Side::left ? -half : 0;
    found.texts.push_back(around(one.x + right, one.y, half, one_cm * high / 2));
  }
  for (const Curve& curve : panel.curves) {
    for (std::size_t i = 0; i < curve.x.size() && !curve.top.empty(); ++i) {
      if (i == 0 || std::isnan(curve.x[i]) || std::isnan(curve.x[i - 1])) continue;
      const Box one{curve.x[i - 1], curve.x[i], std::min(curve.y[i - 1], curve.y[i]),
                    std::max(curve.top[i - 1], curve.top[i])};
      if (near.meets(one)) found.areas.push_back(one);
    }
    if (!curve.top.empty()) continue;
    for (std::size_t i = 0; i < curve.x.size() && curve.mark != Mark::none; ++i) {
      const double half = of_mark * one_cm * curve.mark_size;
      found.dots.push_back(around(curve.x[i], curve.y[i], half, half));
    }
    const std::vector<Segment> lines = lines_in(curve, near);
    found.lines.insert(found.lines.end(), lines.begin(), lines.end());
  }
  return found;
}

constexpr int reach = 24;  // steps each way at which a text is tried along one axis

/// These, and where it is right beside the point.
std::vector<double> steps(double step, double beside) {
  std::vector<double> all{-beside, beside};
  for (int i = -reach; i <= reach; ++i) all.push_back(step * i);
  return all;
}

}  // namespace

double add_beside(Panel& panel, double x, double y, const std::string& text, double one_cm, const Curve& uncrossed) {
  const double half_width = one_cm * (text_width(text) / 2 + clear / 2), half_height = one_cm * (high + clear) / 2;
  struct Place {
    double x = 0, y = 0, far = 0;
    double askew = 0;  // 0 right beside, above or below the point, 1 corner to corner [-]
    double cost = 0;   // [length]
  };
  std::vector<Place> places;
  const double near = 0.55 * clear * one_cm;  // from the point
  for (const double across_by : steps(half_width / 4, half_width + near)) {
    for (const double up_by : steps(half_height / 2, half_height + near)) {
      Place here{.x = x + across_by, .y = y + up_by};
      const Box box = around(here.x, here.y, half_width, half_height);
      if (box.left < *panel.x.from || box.right > *panel.x.to || box.bottom < *panel.y.from || box.top > *panel.y.to) {
        continue;
      }
      here.far = distance(box, x, y);
      if (here.far < 0.5 * clear * one_cm || here.far > furthest * one_cm) continue;  // on the point itself, or away
      here.askew = std::min({std::abs(here.x - x) / half_width, std::abs(here.y - y) / half_height, 1.0});
      here.cost = here.far + 0.5 * one_cm * here.askew * here.askew;
      places.push_back(here);
    }
  }
  const double round_off = 1e-6 * one_cm;  // of places to the left and to the right as far, the first is taken
  std::stable_sort(places.begin(), places.end(), [&](const Place& a, const Place& b) {
    return std::nearbyint(a.cost / round_off) < std::nearbyint(b.cost / round_off);
  });
  const double beyond = furthest * one_cm;
  const Obstacles obstacles =
      obstacles_of(panel, uncrossed, around(x, y, 2 * half_width + beyond, 2 * half_height + beyond), one_cm);
  const auto is_joined = [&](const Place& place) {
    constexpr double most_askew = 0.8;
    return place.far > 2 * clear * one_cm || place.askew > most_askew;
  };
  const auto leader = [&](const Place& place) {
    return Segment{x, y, std::clamp(x, place.x - half_width, place.x + half_width),
                   std::clamp(y, place.y - half_height, place.y + half_height)};
  };
  // What a place costs besides [cm], a line to it included, whether it is drawn or not; more than `most` is not looked
  // at.
  const auto besides = [&](const Place& place, double most) {
    constexpr double on_an_area = 0.35, on_a_line = 1, nearer_to_another = 3, on_another = 100;
    const Box box = around(place.x, place.y, half_width, half_height);
    double cost = obstacles.has_other(box) ? on_another : 0;
    if (cost > most) return cost;
    cost += on_a_line * obstacles.lines_below(box) + (obstacles.is_on_area(box) ? on_an_area : 0);
    constexpr double plainly = 0.06;  // [cm]
    if (obstacles.to_others(box, x, y) <= place.far + plainly * one_cm) cost += nearer_to_another;
    if (cost > most) return cost;
    // Lines that pass through the point are met by a leader along them alone.
    const double start = std::min(1.0, 0.1 * one_cm / place.far), along_a_line = 0.03 * one_cm;
    Segment line = leader(place);
    line.x0 += start * (line.x1 - x);
    line.y0 += start * (line.y1 - y);
    return cost + obstacles.met_by(line, x, y, along_a_line);
  };
  Place best{.x = x, .y = y, .cost = INFINITY};
  for (const Place& place : places) {
    if (place.cost >= best.cost) break;
    const double cost = place.cost + one_cm * besides(place, (best.cost - place.cost) / one_cm);
    if (cost >= best.cost - round_off) continue;
    best = place;
    best.cost = cost;
  }
  if (places.empty()) best.cost = 0;
  for (std::size_t i = 0; i < panel.texts.size(); ++i) {  // another's that would be nearer to this dot than to its own
    const Box& other = obstacles.texts[i];
    const bool has_dot = panel.texts[i].side == PlaceText::Side::middle;
    const double plainly = 0.06 * one_cm;
    if (has_dot && distance(other, x, y) <= obstacles.to_others(other, x, y) + plainly) best.cost += 3 * one_cm;
  }
  if (is_joined(best)) {
    const Segment line = leader(best);
    panel.curves.push_back({.label = text,
                            .x = {line.x0, line.x1},
                            .y = {line.y0, line.y1},
                            .width = 0.7,
                            .complete = true,
                            .in_legend = false});
  }
  panel.texts.push_back({.x = best.x, .y = best.y, .text = text, .side = PlaceText::Side::middle});
  return best.cost;
}

}  // namespace bentur
