#include "bentur/report/kinds/internal/free_place.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "bentur/report/figures/box.h"
#include "bentur/report/figures/internal/text_width.h"

namespace bentur {
namespace {

constexpr double high = 0.32;   // of a text [cm]
constexpr double clear = 0.12;  // around it [cm]

Box around(double x, double y, double half_width, double half_height) {
  return {x - half_width, x + half_width, y - half_height, y + half_height};
}

/// How many lines of a panel pass through a box, and texts that meet it.
int met_by(const Panel& panel, const Box& box, const std::vector<Box>& texts) {
  int met = static_cast<int>(std::count_if(texts.begin(), texts.end(), [&](const Box& one) { return box.meets(one); }));
  for (const Curve& curve : panel.curves) {
    if (curve.line == Line::none) continue;
    for (std::size_t i = 1; i < curve.x.size(); ++i) {
      if (std::isnan(curve.x[i - 1]) || std::isnan(curve.x[i])) continue;
      if (box.meets(curve.x[i - 1], curve.y[i - 1], curve.x[i], curve.y[i])) ++met;
    }
  }
  return met;
}

/// Ways from a point along one axis at which a text is tried, and that at which it is right beside the point.
std::vector<double> steps(double step, double beside) {
  constexpr int reach = 24;  // steps each way
  std::vector<double> all{-beside, beside};
  for (int i = -reach; i <= reach; ++i) all.push_back(step * i);
  return all;
}

}  // namespace

double add_beside(Panel& panel, double x, double y, const std::string& text, double one_cm) {
  const double half_width = one_cm * (text_width(text) / 2 + clear / 2), half_height = one_cm * (high + clear) / 2;
  std::vector<Box> texts;
  for (const PlaceText& one : panel.texts) {
    texts.push_back(around(one.x, one.y, one_cm * text_width(one.text) / 2, one_cm * high / 2));
  }
  struct Place {
    double x = 0, y = 0, far = 0;
    double askew = 0;  // 0 right beside, above or below the point, 1 corner to corner [-]
    double cost = 0;   // [length]
    int met = 0;
  };
  const double round_off = 1e-6 * one_cm;  // of places to the left and to the right as far, the first is taken
  Place best{.met = 1 << 30};
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
      if (best.met == 0 && here.cost >= best.cost - round_off) continue;
      here.met = met_by(panel, box, texts);
      if (here.met < best.met || (here.met == best.met && here.cost < best.cost - round_off)) best = here;
    }
  }
  if (best.met == 1 << 30) best = {.x = x, .y = y};
  constexpr double most_askew = 0.8;
  if (best.far > 2 * clear * one_cm || best.askew > most_askew) {
    panel.curves.push_back({.x = {x, std::clamp(x, best.x - half_width, best.x + half_width)},
                            .y = {y, std::clamp(y, best.y - half_height, best.y + half_height)},
                            .width = 0.5,
                            .complete = true});
  }
  panel.texts.push_back({.x = best.x, .y = best.y, .text = text, .side = PlaceText::Side::middle});
  return best.cost + one_cm * best.met;
}

}  // namespace bentur
