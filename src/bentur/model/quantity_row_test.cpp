#include "bentur/model/quantity_row.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/elements/kinematic_hardening.h"
#include "tests/support/small_buildings.h"

namespace bentur {
namespace {

using Eigen::VectorXd;

/// Three buildings of two floors, three points in two gaps.
Problem row_of_three() {
  const auto building = [](int floors) {
    const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(floors, floors);
    return test::matrix_building(2 * unit, 32 * unit, 0 * unit);  // ω = 4
  };
  Problem problem = test::pair(building(2), building(2), {}, 1);
  problem.buildings.insert(problem.buildings.begin() + 1, building(2));
  problem.points = {test::contact(0.11, 1, 0, 0), test::contact(0.12, 1, 1, 0), test::contact(0.13, 1, 0, 1)};
  problem.delays = {0, 0, 0};
  problem.motion = SampledMotion{0.1, {1, -5, 2}};
  return problem;
}

/// Every number another one.
Response some_response() {
  Response response;
  double next = 1;
  const auto two = [&next] {
    next += 2;
    return VectorXd(Eigen::Vector2d(next, next + 1));
  };
  for (int b = 0; b < 3; ++b) {
    response.buildings.push_back({two(), two(), two(), two(), two()});
    response.buildings.back().drift_ratio_no_contact = two();
  }
  for (int i = 0; i < 3; ++i) {
    next += 20;
    response.points.push_back({.gap_needed = next,
                               .impacts = static_cast<int>(next) + 1,
                               .contact_duration = next + 2,
                               .peak_force = next + 3,
                               .peak_force_time = next + 4,
                               .peak_tension = next + 5,
                               .peak_penetration = next + 6,
                               .peak_closing_speed = next + 7,
                               .impulse = next + 8,
                               .energy_lost = next + 9});
  }
  response.events = 1234;
  return response;
}

class SweepRow : public testing::Test {
 protected:
  void fill() {
    const std::vector<RowPart> parts = row_parts(problem_, {}, false);
    std::vector<double> row(row_size(parts));
    fill_row(parts, {problem_, response_, units_}, row);
    values_.clear();
    for (const RowPart& quantity : parts) {
      const auto first = row.begin() + static_cast<std::ptrdiff_t>(quantity.first);
      values_[quantity.name] = {first, first + static_cast<std::ptrdiff_t>(quantity.count)};
    }
  }
  [[nodiscard]] const std::vector<double>& operator[](const std::string& name) const { return values_.at(name); }

  Problem problem_ = row_of_three();
  Response response_ = some_response();
  Units units_;
  std::map<std::string, std::vector<double>> values_;
};

TEST_F(SweepRow, HoldsEachNumberUnderItsName) {
  fill();
  const auto list = [](const VectorXd& values) { return std::vector<double>(values.begin(), values.end()); };
  for (std::size_t b = 0; b < 3; ++b) {
    const BuildingPeaks& peaks = response_.buildings[b];
    const std::string number = "_" + std::to_string(b + 1);
    EXPECT_EQ((*this)["peak_displacement" + number], list(peaks.displacement));
    EXPECT_EQ((*this)["peak_displacement_no_contact" + number], list(peaks.displacement_no_contact));
    EXPECT_EQ((*this)["amplification" + number], list(peaks.displacement.cwiseQuotient(peaks.displacement_no_contact)));
    EXPECT_EQ((*this)["peak_drift_ratio" + number], list(peaks.drift_ratio));
    EXPECT_EQ((*this)["peak_drift_ratio_no_contact" + number], list(peaks.drift_ratio_no_contact));
    EXPECT_EQ((*this)["peak_acceleration" + number], list(peaks.acceleration));
    EXPECT_EQ((*this)["peak_storey_shear" + number], list(peaks.storey_shear));
    EXPECT_NEAR((*this)["first_period" + number].at(0), std::numbers::pi / 2, 1e-14);
  }
  const auto of_points = [&](auto value) {
    return std::vector<double>{value(response_.points[0]), value(response_.points[1]), value(response_.points[2])};
  };
  using P = PointSummary;
  EXPECT_EQ((*this)["point_width"], (std::vector<double>{0.11, 0.12, 0.13}));
  EXPECT_EQ((*this)["point_gap_needed"], of_points([](const P& p) { return p.gap_needed; }));
  EXPECT_EQ((*this)["impacts"], of_points([](const P& p) { return static_cast<double>(p.impacts); }));
  EXPECT_EQ((*this)["contact_duration"], of_points([](const P& p) { return p.contact_duration; }));
  EXPECT_EQ((*this)["peak_force"], of_points([](const P& p) { return p.peak_force; }));
  EXPECT_EQ((*this)["peak_force_time"], of_points([](const P& p) { return *p.peak_force_time; }));
  EXPECT_EQ((*this)["peak_tension"], of_points([](const P& p) { return p.peak_tension; }));
  EXPECT_EQ((*this)["peak_penetration"], of_points([](const P& p) { return p.peak_penetration; }));
  EXPECT_EQ((*this)["peak_closing_speed"], of_points([](const P& p) { return p.peak_closing_speed; }));
  EXPECT_EQ((*this)["impulse"], of_points([](const P& p) { return p.impulse; }));
  EXPECT_EQ((*this)["energy_lost"], of_points([](const P& p) { return p.energy_lost; }));
  EXPECT_EQ((*this)["peak_ground_acceleration"], std::vector<double>{5});
  EXPECT_EQ((*this)["events"], std::vector<double>{1234});
}

TEST_F(SweepRow, YieldingOfBuildingsThatCanAndEveryLink) {
  fill();
  EXPECT_EQ(values_.count("ductility_1"), 0U);
  EXPECT_TRUE((*this)["link_peak_tension"].empty());
  const Problem elastic = problem_;
  const auto law = std::make_shared<KinematicHardening>(32, 1, 0);
  problem_.buildings[1].elements = storey_elements(problem_.buildings[1].model, {law, nullptr});
  Link link;
  link.right = 2;
  link.law = law;
  problem_.links = {link, link};
  response_.buildings[1].yielding = {Eigen::Vector2d(3, std::nan("")), Eigen::Vector2d(-1, 0), Eigen::Vector2d(5, 0)};
  response_.links = {{.peak_tension = 8}, {.peak_tension = 9}};
  fill();
  EXPECT_EQ(values_.count("ductility_1"), 0U);
  EXPECT_EQ((*this)["ductility_2"].at(0), 3);
  EXPECT_TRUE(std::isnan((*this)["ductility_2"].at(1)));
  EXPECT_EQ((*this)["residual_drift_ratio_2"], (std::vector<double>{-1, 0}));
  EXPECT_EQ((*this)["hysteretic_energy_2"], (std::vector<double>{5, 0}));
  EXPECT_TRUE(std::isnan((*this)["hysteretic_energy_no_contact_2"].at(0))) << "which this response does not have";
  EXPECT_EQ((*this)["link_peak_tension"], (std::vector<double>{8, 9}));
  EXPECT_EQ((*this)["peak_tension"].size(), 3U) << "of the contact points";
  EXPECT_TRUE(same_places(problem_, problem_));
  EXPECT_FALSE(same_places(problem_, elastic));
  Problem other = problem_;
  other.links.pop_back();
  EXPECT_FALSE(same_places(problem_, other));
}

TEST_F(SweepRow, AGapNeedsWhatTheMostDemandingOfItsPointsNeeds) {
  for (const bool upper : {false, true}) {
    response_.points[0].gap_needed = upper ? 0.2 : 0.7;
    response_.points[1].gap_needed = upper ? 0.7 : 0.2;
    response_.points[2].gap_needed = 0.4;
    fill();
    EXPECT_EQ((*this)["gap_needed"], (std::vector<double>{0.7, 0.4})) << "upper floor " << upper;
  }
}

TEST_F(SweepRow, WhatDoesNotExistIsNotANumber) {
  response_.points[1].peak_force_time.reset();
  response_.buildings[0].displacement_no_contact(1) = 0;
  fill();
  EXPECT_TRUE(std::isnan((*this)["peak_force_time"].at(1)));
  EXPECT_FALSE(std::isnan((*this)["peak_force_time"].at(2)));
  EXPECT_TRUE(std::isnan((*this)["amplification_1"].at(1)));
  EXPECT_TRUE(std::isnan((*this)["restitution_smallest"].at(0))) << "there is no impact";
}

TEST_F(SweepRow, RefusesARowOfAnotherLength) {
  const std::vector<RowPart> parts = row_parts(problem_, {}, false);
  std::vector<double> row(row_size(parts) - 1);
  EXPECT_THROW(fill_row(parts, {problem_, response_, units_}, row), InvalidParameter);
  row.resize(row.size() + 2);
  EXPECT_THROW(fill_row(parts, {problem_, response_, units_}, row), InvalidParameter);
}

}  // namespace
}  // namespace bentur
