#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bentur/pounding/response.h"

namespace bentur::test {

/// The same to the bit; what is in neither (the drift of a slab) counts as the same.
inline void expect_same_values(const Eigen::VectorXd& one, const Eigen::VectorXd& other) {
  ASSERT_EQ(one.size(), other.size());
  for (Eigen::Index i = 0; i < one.size(); ++i) {
    if (std::isnan(one(i)) && std::isnan(other(i))) continue;
    EXPECT_EQ(one(i), other(i)) << i;
  }
}

/// The same impacts, peaks and counts, to the bit.
inline void expect_same(const Response& one, const Response& other) {
  ASSERT_EQ(one.impacts.size(), other.impacts.size());
  for (std::size_t i = 0; i < one.impacts.size(); ++i) {
    const Impact &a = one.impacts[i], &b = other.impacts[i];
    EXPECT_EQ(a.point, b.point);
    EXPECT_EQ(a.start, b.start);
    EXPECT_EQ(a.end, b.end);
    EXPECT_EQ(a.closing_speed, b.closing_speed);
    EXPECT_EQ(a.separation_speed, b.separation_speed);
    EXPECT_EQ(a.peak_force, b.peak_force);
    EXPECT_EQ(a.peak_force_time, b.peak_force_time);
    EXPECT_EQ(a.peak_penetration, b.peak_penetration);
    EXPECT_EQ(a.impulse, b.impulse);
    EXPECT_EQ(a.energy_lost, b.energy_lost);
  }
  ASSERT_EQ(one.buildings.size(), other.buildings.size());
  for (std::size_t b = 0; b < one.buildings.size(); ++b) {
    const BuildingPeaks &mine = one.buildings[b], &theirs = other.buildings[b];
    expect_same_values(mine.displacement, theirs.displacement);
    expect_same_values(mine.displacement_no_contact, theirs.displacement_no_contact);
    expect_same_values(mine.drift_ratio, theirs.drift_ratio);
    expect_same_values(mine.acceleration, theirs.acceleration);
    expect_same_values(mine.storey_shear, theirs.storey_shear);
  }
  EXPECT_EQ(one.steps, other.steps);
  EXPECT_EQ(one.events, other.events);
}

/// What points need and what happens there is the same to the bit.
inline void expect_same_points(const std::vector<PointSummary>& one, const std::vector<PointSummary>& other) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].gap_needed, other[i].gap_needed) << i;
    EXPECT_EQ(one[i].gap_needed_reversed, other[i].gap_needed_reversed) << i;
    EXPECT_EQ(one[i].to_come_reversed, other[i].to_come_reversed) << i;
    EXPECT_EQ(one[i].to_come_struck, other[i].to_come_struck) << i;
    EXPECT_EQ(one[i].impacts, other[i].impacts) << i;
    EXPECT_EQ(one[i].peak_force, other[i].peak_force) << i;
    EXPECT_EQ(one[i].impulse, other[i].impulse) << i;
  }
}

/// The same of the reversed motion too, rows and plans alike.
inline void expect_same_outcome(const RunOutcome& one, const RunOutcome& other) {
  EXPECT_EQ(one.status, other.status) << one.message << other.message;
  EXPECT_EQ(one.steps, other.steps);
  EXPECT_EQ(one.events, other.events);
  expect_same_points(one.points, other.points);
  ASSERT_EQ(one.reversed.has_value(), other.reversed.has_value());
  if (!one.reversed) return;
  EXPECT_EQ(one.reversed->has_contact, other.reversed->has_contact);
  ASSERT_EQ(one.reversed->drifts.size(), other.reversed->drifts.size());
  for (std::size_t b = 0; b < one.reversed->drifts.size(); ++b) {
    EXPECT_EQ(one.reversed->drifts[b].ratio, other.reversed->drifts[b].ratio) << b;
  }
  expect_same_points(one.reversed->points, other.reversed->points);
}

}  // namespace bentur::test
