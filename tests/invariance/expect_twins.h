#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "bentur/model/plan/plan_run.h"
#include "tests/invariance/plan_twin.h"

// Responses of buildings in plan held against those of the rows that they stand for.
namespace bentur::test {

/// Of the largest of a list.
inline void expect_alike(const Eigen::VectorXd& plan, const Eigen::VectorXd& row, double tolerance, const char* what) {
  ASSERT_EQ(plan.size(), row.size()) << what;
  const double largest = row.cwiseAbs().maxCoeff();
  EXPECT_LE((plan - row).cwiseAbs().maxCoeff(), tolerance * largest) << what << "\n" << plan << "\n\n" << row;
}

/// What is needed at one level both ways round, and how far both sides go; `turned`: L is the row's right.
template <class Summary>
inline void expect_level(const Summary& plan, const Summary& row, double tolerance, bool turned) {
  EXPECT_NEAR(plan.gap_needed, row.gap_needed, tolerance * (1e-9 + row.gap_needed));
  ASSERT_EQ(plan.gap_needed_reversed.has_value(), row.gap_needed_reversed.has_value());
  const double reversed = row.gap_needed_reversed.value_or(0);
  EXPECT_NEAR(plan.gap_needed_reversed.value_or(0), reversed, tolerance * (1e-9 + reversed));
  const double moves = tolerance * (1e-9 + std::max(row.peak_left, row.peak_right));
  EXPECT_NEAR(plan.peak_left, turned ? row.peak_right : row.peak_left, moves);
  EXPECT_NEAR(plan.peak_right, turned ? row.peak_left : row.peak_right, moves);
}

/// What the gaps watch, each floor of the row at both ends. @return how many
inline int expect_watched_twins(const PlanProblem& problem, const PlanResponse& plan, const Problem& row_problem,
                                const Response& row, double tolerance) {
  std::size_t at = 0;
  int count = 0;
  for (const PlanGap& gap : problem.gaps) {
    const Eigen::Index left = std::min(gap.left, gap.right);
    const std::vector<Eigen::Index> of_row = gap_at(row_problem, left).watched;
    EXPECT_EQ(gap.watched.size(), 2 * of_row.size());
    for (const PlanWatched& one : gap.watched) {
      // Floors that meet are of L, which may be either building.
      const auto same = std::find_if(of_row.begin(), of_row.end(), [&](Eigen::Index i) {
        const WatchedFloor& floor = row_problem.watched[i];
        if (floor.floor_of == one.floor_of) return floor.floor == one.floor && floor.facing_floor == one.facing_floor;
        return floor.facing_floor == one.floor && one.facing_floor == floor.floor;
      });
      if (same == of_row.end()) {
        ADD_FAILURE() << "a floor at " << one.elevation << " is not watched in the row";
        return count;
      }
      const WatchedSummary &found = plan.watched.at(at++), &wanted = row.watched[*same];
      expect_level(found, wanted, tolerance, gap.left > gap.right);
      EXPECT_NEAR(found.least_opening, wanted.least_opening, tolerance * (gap.stretch.width + wanted.gap_needed));
      EXPECT_EQ(found.closes, wanted.closes);
      ++count;
    }
  }
  EXPECT_EQ(plan.watched.size(), at);
  return count;
}

/// Of lists in which nothing is NaN.
inline void expect_known_alike(const Eigen::VectorXd& plan, const Eigen::VectorXd& row, double tolerance) {
  ASSERT_EQ(plan.size(), row.size());
  for (Eigen::Index i = 0; i < row.size(); ++i) {
    ASSERT_EQ(std::isnan(plan(i)), std::isnan(row(i)));
    if (std::isnan(row(i))) continue;
    EXPECT_NEAR(plan(i), row(i), tolerance * (1 + std::abs(row(i))));
  }
}

inline void expect_collapse(const std::optional<Collapse>& plan, const std::optional<Collapse>& row) {
  ASSERT_EQ(plan.has_value(), row.has_value());
  if (!row) return;
  EXPECT_EQ(plan->building, row->building);
  EXPECT_EQ(plan->storey, row->storey);
  EXPECT_NEAR(plan->time, row->time, 1e-9 * row->time);
}

/// Each of two frames is half of the row's. @return how many of its hinges have formed
inline int expect_frame(const PlanPeaks::Plane& plane, const BuildingPeaks& row, double tolerance) {
  const BuildingPeaks& frame = plane.frame;
  int formed = 0;
  EXPECT_EQ(frame.hinges.size(), row.hinges.size());
  EXPECT_EQ(frame.columns.size(), row.columns.size());
  for (std::size_t h = 0; h < std::min(frame.hinges.size(), row.hinges.size()); ++h) {
    const BuildingPeaks::Hinge &found = frame.hinges[h], &wanted = row.hinges[h];
    const double turned = tolerance * (1e-3 + wanted.peak_rotation);
    EXPECT_NEAR(2 * found.peak_moment, wanted.peak_moment, tolerance * wanted.peak_moment);
    EXPECT_NEAR(found.peak_rotation, wanted.peak_rotation, turned);
    EXPECT_NEAR(found.residual_rotation, wanted.residual_rotation, turned);
    EXPECT_NEAR(2 * found.dissipated_energy, wanted.dissipated_energy, turned * wanted.peak_moment * 10);
    EXPECT_EQ(found.half_cycles, wanted.half_cycles);
    EXPECT_EQ(found.first_yield.has_value(), wanted.first_yield.has_value());
    EXPECT_NEAR(found.first_yield.value_or(0), wanted.first_yield.value_or(0), tolerance);
    formed += wanted.first_yield ? 1 : 0;
  }
  EXPECT_EQ(frame.mechanism.has_value(), row.mechanism.has_value());
  if (frame.mechanism && row.mechanism) {
    EXPECT_NEAR(frame.mechanism->time, row.mechanism->time, tolerance);
    EXPECT_EQ(frame.mechanism->storeys, row.mechanism->storeys);
  }
  const double drift = tolerance * (1e-4 + row.drift_ratio.maxCoeff());
  for (Eigen::Index j = 0; j < plane.drift_ratio.size(); ++j) {
    EXPECT_NEAR(plane.drift_ratio(j), row.drift_ratio(j), drift);
    EXPECT_NEAR(2 * plane.shear(j), row.storey_shear(j), tolerance * row.storey_shear.maxCoeff());
    EXPECT_NEAR(plane.yielding.residual_drift_ratio(j), row.yielding.residual_drift_ratio(j), drift);
  }
  return formed;
}

inline void expect_twins(const PlanProblem& problem, const PlanResponse& plan, const Response& row, double tolerance,
                         bool along_y) {
  ASSERT_TRUE(plan.status == Status::done || plan.status == Status::collapsed) << plan.message;
  ASSERT_EQ(plan.status, row.status) << row.message;
  expect_collapse(plan.collapse, row.collapse);
  expect_collapse(plan.collapse_no_contact, row.collapse_no_contact);
  for (std::size_t b = 0; b < row.buildings.size(); ++b) {
    const PlanPeaks& found = plan.buildings[b];
    const BuildingPeaks& wanted = row.buildings[b];
    const PlanPeaks& free = plan.buildings_no_contact[b];
    const Eigen::VectorXd& moves = along_y ? found.y : found.x;
    expect_alike(moves, wanted.displacement, tolerance, "displacement");
    expect_alike(along_y ? free.y : free.x, wanted.displacement_no_contact, tolerance, "free displacement");
    expect_alike(along_y ? found.east : found.north, wanted.displacement, tolerance, "edge");
    expect_alike(along_y ? found.acceleration_y : found.acceleration_x, wanted.acceleration, tolerance, "acceleration");
    EXPECT_LE(found.rotation.maxCoeff() * twin_size.y(), 1e-9 * moves.maxCoeff());
    EXPECT_LE((along_y ? found.x : found.y).maxCoeff(), 1e-9 * moves.maxCoeff());
    if (problem.buildings[b].is_rigid()) continue;
    for (const PlanPeaks::Plane& plane : found.planes) {
      if (plane.yielding.strength_left.size() == 0) continue;
      expect_known_alike(plane.yielding.strength_left, wanted.yielding.strength_left, tolerance);
      expect_known_alike(plane.yielding.capped_time, wanted.yielding.capped_time, tolerance);
      expect_known_alike(plane.yielding.failed_time, wanted.yielding.failed_time, tolerance);
    }
    expect_alike(along_y ? found.shear_y : found.shear_x, wanted.storey_shear, tolerance, "storey shear");
  }
  std::size_t point = 0, level = 0;
  for (const PlanGap& gap : problem.gaps) {
    // Beside the joint nothing is struck: the buildings keep to one line.
    std::size_t i = 0;
    for (; i < gap.contacts.size() && gap.contacts[i].is_of_joint(); ++level) {
      const PointSummary& wanted = row.points[level];
      double force = 0, impulse = 0;
      const double elevation = gap.contacts[i].elevation;
      for (; i < gap.contacts.size() && gap.contacts[i].is_of_joint() && gap.contacts[i].elevation == elevation;
           ++i, ++point) {
        EXPECT_EQ(plan.points[point].impacts, wanted.impacts);
        expect_level(plan.points[point], wanted, tolerance, gap.left > gap.right);
        force += plan.points[point].peak_force;
        impulse += plan.points[point].impulse;
      }
      EXPECT_NEAR(force, wanted.peak_force, tolerance * wanted.peak_force);
      EXPECT_NEAR(impulse, wanted.impulse, tolerance * wanted.impulse);
    }
    for (; i < gap.contacts.size(); ++i, ++point) EXPECT_EQ(plan.points[point].impacts, 0);
  }
}

}  // namespace bentur::test
