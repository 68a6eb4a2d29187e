#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "bentur/contact/laws/bilinear.h"
#include "bentur/contact/laws/kelvin_voigt_approach.h"
#include "bentur/contact/laws/linear.h"
#include "bentur/contact/laws/rubbing.h"
#include "bentur/pounding/plan/plan_pounding.h"

namespace bentur::test {

/// Two buildings of twisting storeys side by side, by chance: some on soil, of these some under gravity loads.
class DrawnPlan {
 public:
  explicit DrawnPlan(unsigned seed) : engine_(seed) {
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
    const Eigen::Index floors = std::min(problem.buildings[0].model.floors(), problem.buildings[1].model.floors());
    for (Eigen::Index floor = 0; floor < floors; ++floor) {
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

}  // namespace bentur::test
