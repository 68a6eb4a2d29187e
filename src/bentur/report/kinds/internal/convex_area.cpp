#include "bentur/report/kinds/internal/convex_area.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bentur/core/not_known.h"

namespace bentur {

void add_area(Curve& curve, const std::vector<Eigen::Vector2d>& corners) {
  if (!curve.x.empty()) {
    for (std::vector<double>* const one : {&curve.x, &curve.y, &curve.top}) one->push_back(not_known);
  }
  std::vector<double> places;  // along x
  for (const Eigen::Vector2d& at : corners) places.push_back(at.x());
  std::sort(places.begin(), places.end());
  const double round_off = 1e-9 * (places.back() - places.front());
  places.erase(
      std::unique(places.begin(), places.end(), [&](double a, double b) { return std::abs(a - b) <= round_off; }),
      places.end());
  for (const double x : places) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector2d &a = corners[i], &b = corners[(i + 1) % corners.size()];
      if (x < std::min(a.x(), b.x()) - round_off || x > std::max(a.x(), b.x()) + round_off) continue;
      const bool is_upright = std::abs(b.x() - a.x()) <= round_off;
      const double part = is_upright ? 0 : std::clamp((x - a.x()) / (b.x() - a.x()), 0.0, 1.0);
      for (const double y : {a.y() + part * (b.y() - a.y()), is_upright ? b.y() : a.y() + part * (b.y() - a.y())}) {
        low = std::min(low, y);
        high = std::max(high, y);
      }
    }
    curve.x.push_back(x);
    curve.y.push_back(low);
    curve.top.push_back(high);
  }
}

}  // namespace bentur
