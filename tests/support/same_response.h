#pragma once

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace bentur::test
