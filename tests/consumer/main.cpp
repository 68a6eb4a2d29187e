/// The library from outside: two equal undamped one-storey buildings are thrown at each other and hit once.
///
/// With m, k, gap w, contact stiffness k_c and speeds ±v: the opening g = w − 2(v/ω) sin ωt, ω² = k/m, closes at
/// t₁ = asin(ωw/2v)/ω with the speed c = 2v cos ωt₁. The penetration then follows δ'' = −ω_c²δ − ω²w, δ(t₁) = 0,
/// δ'(t₁) = c, ω_c² = ω² + 2k_c/m, so its peak is √(b² + (c/ω_c)²) − b, b = ω²w/ω_c².

#include <cmath>
#include <cstdio>
#include <memory>

#include "bentur/contact/laws/linear.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/pounding/pounding.h"
#include "bentur/structure/damping.h"
#include "bentur/structure/stick.h"

namespace {

bool near(const char* what, double computed, double expected) {
  // The solution is exact to round-off and the event is located to round-off of the displacement.
  const bool ok = std::abs(computed - expected) <= 1e-10 * std::abs(expected);
  std::printf("%s: %.15g, expected %.15g%s\n", what, computed, expected, ok ? "" : "  <-- wrong");
  return ok;
}

}  // namespace

int main() {
  const double mass = 1e5, stiffness = 4e6, gap = 0.02, contact_stiffness = 1e8, speed = 0.5;  // kg, N/m, m, N/m, m/s

  bentur::Problem problem;
  for (const char* name : {"left", "right"}) {
    bentur::Stick stick;
    stick.storey_heights = {3.0};
    stick.masses = {mass};
    stick.stiffnesses = {stiffness};
    problem.buildings.push_back(bentur::make_building(name, bentur::stick_model(stick), bentur::ModalDamping{{0.0}}));
  }
  bentur::ContactPoint point;
  point.elevation = 3.0;
  point.width = gap;
  point.law = std::make_shared<bentur::Linear>(contact_stiffness);
  problem.points = {point};
  problem.delays = {0.0, 0.0};
  problem.initial_displacement.assign(2, Eigen::VectorXd::Zero(1));
  problem.initial_velocity = {Eigen::VectorXd::Constant(1, speed), Eigen::VectorXd::Constant(1, -speed)};
  problem.duration = 0.2;

  const bentur::Response response = bentur::solve(problem);
  if (response.status != bentur::Status::done || response.impacts.empty()) {
    std::printf("no impact: %s\n", response.message.c_str());
    return 1;
  }
  const bentur::Impact& impact = response.impacts.front();
  const double omega = std::sqrt(stiffness / mass);
  const double start = std::asin(omega * gap / (2 * speed)) / omega;
  const double closing_speed = 2 * speed * std::cos(omega * start);
  const double contact_omega = std::sqrt(omega * omega + 2 * contact_stiffness / mass);
  const double offset = omega * omega * gap / (contact_omega * contact_omega);
  const double penetration = std::hypot(offset, closing_speed / contact_omega) - offset;

  bool ok = near("start of the impact [s]", impact.start, start);
  ok = near("closing speed [m/s]", impact.closing_speed, closing_speed) && ok;
  ok = near("peak force [N]", impact.peak_force, contact_stiffness * penetration) && ok;

  // A file that is not there is a diagnostic, not a crash: the file formats are linked too.
  bentur::Diagnostics diagnostics;
  ok = !bentur::read_case("no-such-case.toml", diagnostics) && !diagnostics.ok() && ok;
  return ok ? 0 : 1;
}
