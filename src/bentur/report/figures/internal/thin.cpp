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

namespace {

/// How often a line goes up or down by a part of its range that can be seen.
std::size_t swings(const std::vector<double>& y) {
  constexpr double seen = 0.05;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const double one : y) {
    if (std::isfinite(one)) least = std::min(least, one), most = std::max(most, one);
  }
  const double step = seen * (most - least);
  std::size_t count = 0;
  double turn = y.front();  // the furthest since it turned
  bool rises = true;
  for (const double one : y) {
    if (!std::isfinite(one)) continue;
    const double back = rises ? turn - one : one - turn;
    if (back > step) {
      rises = !rises;
      ++count;
    }
    if (back < 0 || back > step) turn = one;
  }
  return count;
}

}  // namespace

Points envelope(const std::vector<double>& x, const std::vector<double>& y, int columns) {
  constexpr std::size_t filling = 4;  // ups and downs a column
  const std::size_t fewest = filling * static_cast<std::size_t>(std::max(columns, 1));
  if (x.size() < fewest || !(x.back() > x.front()) || !std::is_sorted(x.begin(), x.end()) || swings(y) < fewest) {
    return {};
  }
  Points band;
  const double width = (x.back() - x.front()) / columns;
  for (std::size_t i = 0; i < x.size();) {
    const auto column = std::min(columns - 1, static_cast<int>((x[i] - x.front()) / width));
    double least = std::numeric_limits<double>::infinity(), most = -least;
    const double end = column + 1 < columns ? x.front() + (column + 1) * width : x.back();
    for (const std::size_t first = i; i < x.size() && (i == first || x[i] < end || column + 1 == columns); ++i) {
      if (std::isfinite(y[i])) least = std::min(least, y[i]), most = std::max(most, y[i]);
    }
    const bool is_there = least <= most;
    band.x.push_back(column == 0 ? x.front() : column + 1 == columns ? x.back() : x.front() + (column + 0.5) * width);
    band.y.push_back(is_there ? least : NAN);
    band.top.push_back(is_there ? most : NAN);
  }
  return band;
}

}  // namespace bentur
