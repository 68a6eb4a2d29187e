// No building at all: a mass on a spring that rattles between two stops, as bodies and contacts for the solver.
#include <bentur/contact/laws/linear.h>
#include <bentur/solve/solver.h>
#include <bentur/structure/modes.h>

#include <cstdio>
#include <memory>

using namespace bentur;

int main() {
  using One = Eigen::Matrix<double, 1, 1>;
  Body body;
  body.name = "mass";
  body.mass = One(2.0);         // kg
  body.stiffness = One(800.0);  // N/m
  body.load = body.mass * Eigen::VectorXd::Ones(1);
  body.modes = modes(body.mass, body.stiffness);
  body.modal_damping = One(2 * 0.02 * body.modes.omega(0));
  body.outputs = {{.kind = OutputKind::displacement, .count = 1, .rows = One(1.0), .has_peak = true}};

  System system;
  system.bodies = {body};
  for (const double side : {1.0, -1.0}) {
    Contact stop;
    stop.at.left = {.body = 0, .row = One(side), .output = 0};
    stop.law = std::make_shared<Linear>(1e6);
    stop.width = 0.01;
    system.contacts.push_back(stop);
  }
  system.motions = {HarmonicMotion{.period = 0.35, .displacement_amplitude = 0.01}};
  system.duration = 5.0;

  const FreeSolution free(system, ExactSolver{});
  const Solution solution = free.solve(system.contacts);
  std::printf("%zu impacts; %.2f mm from the middle at most, %.2f mm without stops\n", solution.impacts.size(),
              solution.outputs[0][0].peak(0) * 1e3, free.solution().outputs[0][0].peak(0) * 1e3);
}
