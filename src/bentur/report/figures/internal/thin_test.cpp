#include "bentur/report/figures/internal/thin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bentur {
namespace {

Points spiky(std::size_t count) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    points.x.push_back(0.001 * static_cast<double>(i));
    points.y.push_back(std::sin(0.7 * static_cast<double>(i)) + (i == 34567 ? 50 : 0) - (i == 34570 ? 70 : 0));
  }
  return points;
}

TEST(Thin, FewPointsStay) {
  const Points points = spiky(400);
  const Points kept = thinned(points.x, points.y, 100);
  EXPECT_EQ(kept.x, points.x);
  EXPECT_EQ(kept.y, points.y);
}

TEST(Thin, PeaksOfEveryColumnStayWhereTheyAre) {
  constexpr int columns = 100;
  const Points points = spiky(100000);
  const Points kept = thinned(points.x, points.y, columns);
  EXPECT_LE(kept.x.size(), 4U * columns);
  EXPECT_TRUE(std::is_sorted(kept.x.begin(), kept.x.end()));
  EXPECT_EQ(kept.x.front(), points.x.front());
  EXPECT_EQ(kept.x.back(), points.x.back());
  const auto range = [&](const Points& of, double from, double to) {
    double low = INFINITY;
    double high = -INFINITY;
    for (std::size_t i = 0; i < of.x.size(); ++i) {
      if (of.x[i] < from || of.x[i] >= to) continue;
      low = std::min(low, of.y[i]);
      high = std::max(high, of.y[i]);
    }
    return std::pair{low, high};
  };
  const double span = points.x.back();
  for (int column = 0; column + 1 < columns; ++column) {
    const double from = span * column / columns;
    const double to = span * (column + 1) / columns;
    EXPECT_EQ(range(kept, from, to), range(points, from, to)) << column;
  }
  for (std::size_t i = 0; i < kept.x.size(); ++i) {  // nothing made up
    const auto place = static_cast<std::size_t>(std::lround(kept.x[i] / 0.001));
    EXPECT_EQ(kept.y[i], points.y[place]);
  }
}

TEST(Envelope, HoldsTheLowestAndTheHighestOfEachColumn) {
  constexpr int columns = 50;
  Points points = spiky(100000);
  for (std::size_t i = 0; i < points.y.size(); ++i) points.y[i] *= i == 34567 || i == 34570 ? 0.1 : 1;
  const Points band = envelope(points.x, points.y, columns);
  ASSERT_EQ(band.x.size(), static_cast<std::size_t>(columns));
  EXPECT_EQ(band.x.front(), points.x.front());
  EXPECT_EQ(band.x.back(), points.x.back());
  for (std::size_t column = 0; column < columns; ++column) {
    const auto first = points.y.begin() + 2000 * static_cast<std::ptrdiff_t>(column);
    const auto [low, high] = std::minmax_element(first, first + 2000);
    EXPECT_NEAR(band.y[column], *low, 1e-4) << column;
    EXPECT_NEAR(band.top[column], *high, 1e-4) << column;
  }
}

/// What goes up and down seldom is a line, however many points it has and whatever trembles on it.
TEST(Envelope, IsNotOfALineThatCanBeFollowed) {
  Points slow;
  for (std::size_t i = 0; i < 100000; ++i) {
    slow.x.push_back(1e-4 * static_cast<double>(i));
    slow.y.push_back(std::sin(5 * slow.x.back()) + 0.01 * std::sin(static_cast<double>(i)));
  }
  EXPECT_TRUE(envelope(slow.x, slow.y, 50).x.empty());
  Points back = spiky(100000);
  std::reverse(back.x.begin(), back.x.end());
  EXPECT_TRUE(envelope(back.x, back.y, 50).x.empty()) << "not over time";
}

TEST(Thin, GapsStay) {
  Points points = spiky(100000);
  std::fill(points.y.begin() + 40000, points.y.begin() + 60000, std::numeric_limits<double>::quiet_NaN());
  const Points kept = thinned(points.x, points.y, 100);
  EXPECT_TRUE(std::any_of(kept.y.begin(), kept.y.end(), [](double y) { return std::isnan(y); }));
  for (std::size_t i = 0; i < kept.x.size(); ++i) {
    const auto place = static_cast<std::size_t>(std::lround(kept.x[i] / 0.001));
    EXPECT_EQ(std::isnan(kept.y[i]), std::isnan(points.y[place]));
  }
}

TEST(Thin, LoopsAreLeftAlone) {
  std::vector<double> x(1000), y(1000);
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = std::cos(0.01 * static_cast<double>(i));
    y[i] = std::sin(0.01 * static_cast<double>(i));
  }
  EXPECT_EQ(thinned(x, y, 10).x, x);
}

}  // namespace
}  // namespace bentur
