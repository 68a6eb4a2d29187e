#include "bentur/report/figures/internal/visible.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bentur/core/errors.h"
#include "bentur/report/figures/internal/layout.h"

namespace bentur {
namespace {

constexpr double columns_per_cm = 90;       // points of a curve closer than that cannot be told apart
constexpr std::size_t most_points = 50000;  // of a curve that is drawn completely
constexpr std::size_t most_cells = 120;     // of a heat map along an axis; more are merged

[[noreturn]] void refuse(const std::string& what) {
  throw InvalidParameter("figure", what, "must have something to draw, sizes that agree");
}

bool has_values(const Curve& curve) {
  if (curve.x.size() != curve.y.size() || (!curve.top.empty() && curve.top.size() != curve.x.size())) {
    refuse("a curve's x and y are not as many");
  }
  bool any = false;
  for (const double y : curve.y) any = any || std::isfinite(y);
  return any;
}

bool has_values(const HeatMap& map) {
  if (map.x_edges.size() < 2 || map.y_edges.size() < 2 ||
      map.values.size() != (map.x_edges.size() - 1) * (map.y_edges.size() - 1)) {
    refuse("a map's values and edges do not go together");
  }
  bool any = false;
  for (const double value : map.values) any = any || (std::isfinite(value) && (!map.ratio || value > 0));
  return any;
}

std::vector<double> every(const std::vector<double>& edges, std::size_t stride) {
  std::vector<double> kept;
  for (std::size_t i = 0; i < edges.size(); i += stride) kept.push_back(edges[i]);
  if ((edges.size() - 1) % stride != 0) kept.push_back(edges.back());
  return kept;
}

}  // namespace

void check(const Figure& figure) {
  if (figure.panels.empty()) refuse("no panels");
  for (const Panel& panel : figure.panels) {
    bool anything = false;
    for (const Curve& curve : panel.curves) anything = has_values(curve) || anything;
    if (panel.map && !has_values(*panel.map)) refuse("an empty map");
    if (!anything && !panel.map) refuse("an empty panel");
  }
}

bool is_empty(const Panel& panel) {
  return !panel.map &&
         std::none_of(panel.curves.begin(), panel.curves.end(), [](const Curve& curve) { return has_values(curve); });
}

Points visible(const Curve& curve, double width) {
  if (!curve.top.empty() || (curve.complete && curve.x.size() <= most_points)) return {curve.x, curve.y, curve.top};
  if (curve.line != Line::none && curve.mark == Mark::none) {
    constexpr double columns_of_band = 12;  // a centimetre
    Points band = envelope(curve.x, curve.y, static_cast<int>(width * columns_of_band));
    if (!band.x.empty()) return band;
  }
  return thinned(curve.x, curve.y, static_cast<int>(width * columns_per_cm));
}

bool has_bands(const Figure& figure) {
  const Layout placing = layout(figure);
  return std::any_of(placing.panels.begin(), placing.panels.end(), [](const PlacedPanel& placed) {
    const std::vector<Curve>& curves = placed.panel->curves;
    return std::any_of(curves.begin(), curves.end(), [&](const Curve& curve) {
      return curve.top.empty() && !visible(curve, placed.right - placed.left).top.empty();
    });
  });
}

HeatMap merged(const HeatMap& map) {
  const std::size_t nx = map.x_edges.size() - 1, ny = map.y_edges.size() - 1;
  const std::size_t by_x = (nx + most_cells - 1) / most_cells, by_y = (ny + most_cells - 1) / most_cells;
  HeatMap coarse{every(map.x_edges, by_x), every(map.y_edges, by_y), {}, map.label, map.ratio, map.range};
  const std::size_t columns = coarse.x_edges.size() - 1;
  coarse.values.assign(columns * (coarse.y_edges.size() - 1), NAN);
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    double& cell = coarse.values[i / nx / by_y * columns + i % nx / by_x];
    if (!(cell >= map.values[i])) cell = std::isnan(map.values[i]) ? cell : map.values[i];
  }
  return coarse;
}

}  // namespace bentur
