// What runs of a plan share that differ in contacts, or in the size of the ground motion alone, against runs of their
// own.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bentur/contact/laws/bilinear.h"
#include "bentur/contact/laws/kelvin_voigt_approach.h"
#include "bentur/contact/laws/linear.h"
#include "bentur/contact/laws/rubbing.h"
#include "bentur/core/errors.h"
#include "bentur/pounding/plan/plan_pounding.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

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

/// Two buildings of twisting storeys side by side, by chance: some on soil, of these some under gravity loads.
class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {
    const PlanPoint size(any(8, 16), any(8, 18));
    for (const PlanPoint& corner :
         {PlanPoint(0, 0), PlanPoint(size.x() + any(0.002, 0.02), any(-0.5, 0.5) * size.y())}) {
      plans.push_back(building(corner, corner.isZero() ? size : PlanPoint(any(8, 16), any(8, 18))));
    }
    stiffness = std::pow(10, any(4.8, 6));
    friction = chance(0.7) ? any(0.05, 0.8) : 0;
    absolute = chance(0.4);
    angle = any(0, 6);
    if (chance(0.3)) delays = {0, any(0, 0.05)};
    for (double& period : periods) period = any(0.25, 0.8);
    for (double& amplitude : amplitudes) amplitude = any(0.005, 0.03);
  }

  [[nodiscard]] std::shared_ptr<const ContactLaw> law_of(double share) const {
    if (law == 0) return std::make_shared<Linear>(share * stiffness);
    if (law == 1) return std::make_shared<KelvinVoigtApproach>(share * stiffness, 0.2, share * 100);
    return std::make_shared<Bilinear>(share * stiffness, 0.4 * share * stiffness, 2e-3);
  }

  [[nodiscard]] PlanProblem problem() const {
    PlanProblem problem;
    for (const Plan& plan : plans) {
      problem.buildings.push_back(make_plan_building("B", plan_model(plan), ModalDamping{{0.04}}, false, plan.soil));
    }
    PlanGap& gap = problem.gaps.emplace_back();
    gap.left = 0;
    gap.right = 1;
    gap.stretch = facing(plans[0].footprint, plans[1].footprint).value();
    gap.stretch.width += wider;
    const Index floors = std::min(problem.buildings[0].model.floors(), problem.buildings[1].model.floors());
    for (Index floor = 0; floor < floors; ++floor) {
      for (const StretchPoint& point : points_of(gap.stretch, 3)) {
        PlanContact& contact = gap.contacts.emplace_back();
        contact.left_floor = contact.right_floor = floor;
        contact.elevation = problem.buildings[0].model.elevations[floor];
        contact.along = point.along;
        contact.law = law_of(point.share);
        if (friction > 0) contact.rubbing = std::make_shared<Rubbing>(contact.law, friction, point.share * stiffness);
      }
    }
    for (const double end : gap.stretch.corners_along()) {
      gap.watched.push_back({.floor_of = 0, .elevation = 2, .along = end});
    }
    for (std::size_t i = 0; i < 2; ++i) {
      SampledMotion record{.time_step = 0.02, .acceleration = std::vector<double>(151)};
      const HarmonicMotion wave{.period = periods[i], .displacement_amplitude = amplitudes[i]};
      for (std::size_t n = 0; n < record.acceleration.size(); ++n) {
        record.acceleration[n] = times * acceleration_at(wave, record.time_step * static_cast<double>(n));
      }
      problem.motions[i] = record;
    }
    problem.axes << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    problem.delays = delays;
    problem.kinematics = absolute ? Kinematics::absolute : Kinematics::relative;
    problem.duration = 4;
    return problem;
  }

  [[nodiscard]] bool falls() const {
    return std::any_of(plans.begin(), plans.end(), [](const Plan& plan) { return !plan.gravity_loads.empty(); });
  }

  std::vector<Plan> plans;
  int law = 0;
  double stiffness = 0, friction = 0, angle = 0, wider = 0, times = 1;
  bool absolute = false;
  std::vector<double> delays = {};
  std::array<double, 2> periods = {}, amplitudes = {};

 private:
  double any(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
  bool chance(double of) { return any(0, 1) < of; }

  Plan building(const PlanPoint& corner, const PlanPoint& size) {
    const auto count = static_cast<std::size_t>(any(1, 3.999));
    const auto list = [&](double from, double to) {
      std::vector<double> values(count);
      for (double& value : values) value = any(from, to);
      return values;
    };
    const auto plane = [&](const PlanPoint& through, const PlanPoint& direction) {
      PlanPlane result{.name = "P", .through = through, .direction = direction};
      result.storeys.stiffnesses = list(1e4, 8e4);
      return result;
    };
    Plan plan{.footprint = {.corner = corner, .size = size},
              .storey_heights = std::vector<double>(count, 3.0),
              .masses = list(60, 300)};
    const PlanPoint x = PlanPoint::UnitX(), y = PlanPoint::UnitY();
    plan.planes = {plane({0, any(0, 0.4) * size.y()}, x), plane({0, any(0.6, 1) * size.y()}, x),
                   plane({any(0, 1) * size.x(), 0}, y), plane({any(0, 1) * size.x(), 0}, y)};
    if (chance(0.7)) return plan;
    plan.soil = PlanSoil{.sway_x = {1e5, 1e3},
                         .sway_y = {2e5, 1e3},
                         .rocking_x = {1e7, 1e5},
                         .rocking_y = {2e7, 1e5},
                         .mass = 50,
                         .inertia_x = 500,
                         .inertia_y = 600};
    if (chance(0.5)) return plan;
    for (const double mass : plan.masses) plan.gravity_loads.push_back(9.81 * mass);
    return plan;
  }

  std::mt19937 engine_;
};

/// The same with other widths and laws.
PlanProblem with_other_contacts(Draw draw, const std::function<void(PlanProblem&)>& change = {}) {
  draw.law = (draw.law + 1) % 3;
  draw.stiffness *= 0.7;
  draw.wider = 0.003;
  PlanProblem problem = draw.problem();
  if (change) change(problem);
  return problem;
}

PlanProblem times(Draw draw, double factor) {
  draw.times = factor;
  return draw.problem();
}

TEST(PlanFreeResponse, ServesOtherContactsToTheBit) {
  std::size_t impacts = 0;
  for (unsigned seed = 101; seed <= 120; ++seed) {
    SCOPED_TRACE(seed);
    Draw draw(seed);
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
    Draw draw(seed);
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
  Draw draw(103);
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
