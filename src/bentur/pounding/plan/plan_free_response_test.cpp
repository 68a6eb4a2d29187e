// What runs of a plan share that differ in contacts, or in the size of the ground motion alone, against runs of their
// own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "bentur/core/errors.h"
#include "tests/invariance/drawn_plan.h"

namespace bentur {
namespace {

using Eigen::VectorXd;
using test::DrawnPlan;

/// The numbers of a response, those of one kind together.
std::vector<std::vector<double>> numbers_of(const PlanResponse& response) {
  std::vector<std::vector<double>> all;
  const auto put = [](std::vector<double>& values, const VectorXd& list) {
    values.insert(values.end(), list.begin(), list.end());
  };
  for (const auto* const buildings : {&response.buildings, &response.buildings_no_contact}) {
    for (const auto list : std::initializer_list<VectorXd PlanPeaks::*>{
             &PlanPeaks::x, &PlanPeaks::y, &PlanPeaks::south, &PlanPeaks::east, &PlanPeaks::rotation,
             &PlanPeaks::acceleration_x, &PlanPeaks::angular_acceleration, &PlanPeaks::shear_y, &PlanPeaks::torque}) {
      std::vector<double>& values = all.emplace_back();
      for (const PlanPeaks& peaks : *buildings) put(values, peaks.*list);
    }
    std::vector<double>& shears = all.emplace_back();
    for (const PlanPeaks& peaks : *buildings) {
      for (const PlanPeaks::Plane& plane : peaks.planes) put(shears, plane.shear);
    }
  }
  for (const auto of : std::initializer_list<double PointSummary::*>{
           &PointSummary::gap_needed, &PointSummary::peak_left, &PointSummary::peak_force, &PointSummary::impulse}) {
    std::vector<double>& values = all.emplace_back();
    for (const PointSummary& point : response.points) values.push_back(point.*of);
  }
  for (const auto of : std::initializer_list<double PlanFriction::*>{
           &PlanFriction::tangential_impulse, &PlanFriction::sliding, &PlanFriction::friction_loss}) {
    std::vector<double>& values = all.emplace_back();
    for (const PlanFriction& point : response.friction) values.push_back(point.*of);
  }
  std::vector<double>& energies = all.emplace_back();  // what linear contact loses is round-off of what went in
  for (const PointSummary& point : response.points) energies.push_back(point.energy_lost);
  if (response.energy) energies.push_back(response.energy->peak_input);
  std::vector<double>& openings = all.emplace_back();
  for (const WatchedSummary& one : response.watched) openings.push_back(one.least_opening);
  return all;
}

/// The largest difference, as a part of the largest of its kind; infinite where a count differs.
double apart(const PlanResponse& one, const PlanResponse& other) {
  if (one.status != other.status || one.impacts.size() != other.impacts.size()) return HUGE_VAL;
  const std::vector<std::vector<double>> a = numbers_of(one), b = numbers_of(other);
  double worst = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const std::vector<double>&mine = a[k], &theirs = b[k];
    if (mine.size() != theirs.size()) return HUGE_VAL;
    double largest = 0;
    for (const double value : theirs) largest = std::max(largest, std::abs(value));
    for (std::size_t i = 0; i < mine.size(); ++i) {
      if (std::isnan(mine[i] + theirs[i])) return HUGE_VAL;
      if (mine[i] != theirs[i]) worst = std::max(worst, std::abs(mine[i] - theirs[i]) / largest);
    }
  }
  return worst;
}

/// The same with other widths and laws.
PlanProblem with_other_contacts(DrawnPlan draw, const std::function<void(PlanProblem&)>& change = {}) {
  draw.law = (draw.law + 1) % 3;
  draw.stiffness *= 0.7;
  draw.wider = 0.003;
  PlanProblem problem = draw.problem();
  if (change) change(problem);
  return problem;
}

PlanProblem times(DrawnPlan draw, double factor) {
  draw.times = factor;
  return draw.problem();
}

TEST(PlanFreeResponse, ServesOtherContactsToTheBit) {
  std::size_t impacts = 0;
  for (unsigned seed = 101; seed <= 120; ++seed) {
    SCOPED_TRACE(seed);
    DrawnPlan draw(seed);
    draw.law = static_cast<int>(seed % 3);
    const PlanFreeResponse free(draw.problem(), ExactSolver{}, {}, {}, true);
    const PlanProblem other = with_other_contacts(draw);
    ASSERT_TRUE(free.serves(other));
    const PlanResponse alone = solve(other, ExactSolver{}, {.levels = true});
    EXPECT_EQ(apart(free.solve(other, {.levels = true}), alone), 0);
    impacts += alone.impacts.size();
  }
  EXPECT_GT(impacts, 100U);
}

/// 10⁻⁹ as of a row: the same operations with other numbers round otherwise, by 10⁻¹⁶ a step, which impacts amplify.
TEST(PlanFreeResponse, IsScaledWithTheMotion) {
  std::size_t impacts = 0, scaled = 0;
  for (unsigned seed = 101; seed <= 140; ++seed) {
    SCOPED_TRACE(seed);
    DrawnPlan draw(seed);
    draw.law = static_cast<int>(seed % 2);
    const PlanProblem base = draw.problem(), problem = times(draw, 0.3 + 0.1 * (seed % 20));
    const auto free = PlanFreeResponse(base, ExactSolver{}, {}, {}, true).scaled(problem);
    ASSERT_EQ(free.has_value(), !draw.falls()) << "gravity loads are of their own";
    if (!free) continue;
    ++scaled;
    const SolveOptions options{.levels = true, .energy_audit = true};
    const PlanResponse one = free->solve(problem, options), alone = solve(problem, ExactSolver{}, options);
    EXPECT_LE(apart(one, alone), 1e-9);
    EXPECT_LE((one.peak_ground_acceleration - alone.peak_ground_acceleration).norm(), 0);
    impacts += alone.impacts.size();
  }
  EXPECT_GT(scaled, 20U);
  EXPECT_GT(impacts, 100U);
}

TEST(PlanFreeResponse, RefusesAnotherPlan) {
  DrawnPlan draw(103);
  draw.absolute = false;
  draw.friction = 0.3;
  for (Plan& plan : draw.plans) {
    plan.soil.reset();
    plan.gravity_loads.clear();
  }
  const PlanProblem base = draw.problem();
  const PlanFreeResponse free(base);
  const std::pair<const char*, std::function<void(PlanProblem&)>> changes[] = {
      {"buildings[0]", [](PlanProblem& p) { p.buildings[0].model.mass(0, 0) *= 2; }},
      {"buildings[1]", [](PlanProblem& p) { p.buildings[1].modes.omega(0) *= 1 + 1e-15; }},
      {"buildings[0]", [](PlanProblem& p) { p.buildings[0].model.storey_heights[0] *= 2; }},
      {"buildings[0]", [](PlanProblem& p) { p.axes << 0, -1, 1, 0; }},
      {"points[0]", [](PlanProblem& p) { p.gaps[0].contacts[0].along += 0.1; }},
      {"points", [](PlanProblem& p) { p.gaps[0].contacts.pop_back(); }},
      {"points", [](PlanProblem& p) { p.gaps[0].contacts[0].rubbing = nullptr; }},
      {"watched", [](PlanProblem& p) { p.gaps[0].watched.pop_back(); }},
      {"motion", [](PlanProblem& p) { std::get<SampledMotion>(p.motions[0]).acceleration[3] += 1; }},
      {"motion", [](PlanProblem& p) { p.motions[1] = NoMotion{}; }},
      {"kinematics", [](PlanProblem& p) { p.kinematics = Kinematics::absolute; }},
      {"duration", [](PlanProblem& p) { p.duration = 2; }},
  };
  for (const auto& [what, change] : changes) {
    const PlanProblem other = with_other_contacts(draw, change);
    EXPECT_FALSE(free.serves(other)) << what;
    try {
      (void)free.solve(other);
      ADD_FAILURE() << what << " was taken";
    } catch (const InvalidParameter& error) {
      EXPECT_EQ(std::string(error.what()).rfind(std::string(what) + " = ", 0), 0U) << error.what();
    }
  }
  PlanProblem bilinear = times(draw, 2);
  const auto scaled = free.scaled(bilinear);
  ASSERT_TRUE(scaled);
  for (PlanGap& gap : bilinear.gaps) {
    for (PlanContact& contact : gap.contacts) {
      contact.law = std::make_shared<Bilinear>(1e5, 1e4, 1e-3);
      contact.rubbing = std::make_shared<Rubbing>(contact.law, 0.3, 1e5);
    }
  }
  EXPECT_FALSE(scaled->serves(bilinear)) << "a penetration is a length";
  EXPECT_THROW((void)scaled->solve(bilinear), InvalidParameter);
}

}  // namespace
}  // namespace bentur
