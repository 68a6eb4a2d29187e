#include "bentur/report/figures/internal/thin.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>

#include "bentur/report/figures/internal/ticks.h"

namespace bentur {

Points thinned(const std::vector<double>& x, const std::vector<double>& y, int columns) {
  const std::size_t count = x.size();
  const double span = count > 0 ? x.back() - x.front() : 0;
  if (count <= 4 * static_cast<std::size_t>(columns) || !(span > 0) || !std::is_sorted(x.begin(), x.end())) {
    return {x, y};
  }
  const auto column = [&](std::size_t i) {
    return std::min(columns - 1, static_cast<int>((x[i] - x.front()) / span * columns));
  };
  // Of values that differ by round-off alone the first is taken, on every machine.
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const double one : y) {
    if (std::isfinite(one)) least = std::min(least, one), most = std::max(most, one);
  }
  const double tiny = least < most ? round_off * (most - least) : 0;
  Points kept;
  for (std::size_t first = 0; first < count;) {
    std::size_t end = first;
    std::set<std::size_t> chosen = {first};
    std::size_t low = first;
    std::size_t high = first;
    for (; end < count && column(end) == column(first); ++end) {
      if (std::isnan(y[end])) {
        if (end == first || !std::isnan(y[end - 1])) chosen.insert(end);
        continue;
      }
      if (!(y[low] <= y[end] + tiny)) low = end;
      if (!(y[high] >= y[end] - tiny)) high = end;
    }
    chosen.insert({low, high, end - 1});
    for (const std::size_t i : chosen) {
      kept.x.push_back(x[i]);
      kept.y.push_back(y[i]);
    }
    first = end;
  }
  return kept;
}

}  // namespace bentur
