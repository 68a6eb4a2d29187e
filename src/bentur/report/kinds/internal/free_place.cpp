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

Box around(double x, double y, double half_width, double half_height) {
  return {x - half_width, x + half_width, y - half_height, y + half_height};
}

/// Lines, marks and texts of a panel near a point, on which a text beside it should not lie.
struct Obstacles {
  struct Segment {
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  };
  std::vector<Segment> lines;
  std::vector<Box> boxes;

  [[nodiscard]] int met_by(const Box& box) const {
    return static_cast<int>(std::count_if(boxes.begin(), boxes.end(), [&](const Box& one) { return box.meets(one); }) +
                            std::count_if(lines.begin(), lines.end(), [&](const Segment& one) {
                              return box.meets(one.x0, one.y0, one.x1, one.y1);
                            }));
  }
};

/// @param near the box within which they count
Obstacles obstacles_of(const Panel& panel, const Box& near, double one_cm) {
  Obstacles found;
  for (const PlaceText& one : panel.texts) {
    const double half = one_cm * text_width(one.text) / 2;
    const double right = one.side == PlaceText::Side::right ? half : one.side == PlaceText::Side::left ? -half : 0;
    found.boxes.push_back(around(one.x + right, one.y, half, one_cm * high / 2));
  }
  for (const Curve& curve : panel.curves) {
    if (!curve.top.empty()) continue;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (std::isnan(curve.x[i])) continue;
      if (curve.mark != Mark::none) {
        const double half = of_mark * one_cm * curve.mark_size;
        found.boxes.push_back(around(curve.x[i], curve.y[i], half, half));
      }
      if (i == 0 || curve.line == Line::none || std::isnan(curve.x[i - 1])) continue;
      if (near.meets(curve.x[i - 1], curve.y[i - 1], curve.x[i], curve.y[i])) {
        found.lines.push_back({curve.x[i - 1], curve.y[i - 1], curve.x[i], curve.y[i]});
      }
    }
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

double add_beside(Panel& panel, double x, double y, const std::string& text, double one_cm) {
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
      const double across = std::max(0.0, std::abs(here.x - x) - half_width);
      const double up = std::max(0.0, std::abs(here.y - y) - half_height);
      here.far = std::hypot(across, up);
      if (here.far < 0.5 * clear * one_cm) continue;  // on the point itself
      here.askew = std::min({std::abs(here.x - x) / half_width, std::abs(here.y - y) / half_height, 1.0});
      here.cost = here.far + 0.5 * one_cm * here.askew * here.askew;
      places.push_back(here);
    }
  }
  const double round_off = 1e-6 * one_cm;  // of places to the left and to the right as far, the first is taken
  std::stable_sort(places.begin(), places.end(), [&](const Place& a, const Place& b) {
    return std::floor(a.cost / round_off) < std::floor(b.cost / round_off);
  });
  const Obstacles obstacles = obstacles_of(
      panel, around(x, y, (reach / 4 + 1) * half_width + near, (reach / 2 + 1) * half_height + near), one_cm);
  Place best{.x = x, .y = y};
  int met = 1 << 20;
  for (const Place& place : places) {
    if (met == 0) break;
    const int here = obstacles.met_by(around(place.x, place.y, half_width, half_height));
    if (here >= met) continue;
    met = here;
    best = place;
  }
  if (places.empty()) met = 0;
  constexpr double most_askew = 0.8;
  if (best.far > 2 * clear * one_cm || best.askew > most_askew) {
    panel.curves.push_back({.x = {x, std::clamp(x, best.x - half_width, best.x + half_width)},
                            .y = {y, std::clamp(y, best.y - half_height, best.y + half_height)},
                            .width = 0.7,
                            .complete = true});
  }
  panel.texts.push_back({.x = best.x, .y = best.y, .text = text, .side = PlaceText::Side::middle});
  return best.cost + one_cm * met;
}

}  // namespace bentur
