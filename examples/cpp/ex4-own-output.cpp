// A quantity of one's own: the overturning moment at the base, with the peak of its continuous course.
#include <bentur/contact/laws/linear.h>
#include <bentur/pounding/assemble.h>
#include <bentur/solve/solver.h>
#include <bentur/structure/damping.h>
#include <bentur/structure/stick.h>

#include <cstdio>
#include <memory>

using namespace bentur;

int main() {
  Problem problem;
  problem.buildings = {make_building("soft", stick_model({{3.5, 3.0}, {1e5, 8e4}, {2e7, 3e7}}), ModalDamping{{0.05}}),
                       make_building("stiff", stick_model({{3.5, 3.0}, {1e5, 8e4}, {9e7, 9e7}}), ModalDamping{{0.05}})};
  problem.points = {
      {.left_floor = 1, .right_floor = 1, .elevation = 6.5, .width = 0.01, .law = std::make_shared<Linear>(2e8)}};
  problem.motion = HarmonicMotion{.period = 0.6, .displacement_amplitude = 0.02};
  problem.duration = 6.0;

  System system = system_of(problem);
  for (Body& body : system.bodies) {  // floors at 3.5 and 6.5 m, in rows over their displacements
    const Eigen::RowVector2d heights(3.5, 6.5);
    body.outputs.push_back({.count = 1, .rows = heights * body.stiffness, .has_peak = true});
  }
  const FreeSolution free(system, ExactSolver{});
  const Solution solution = free.solve(system.contacts);
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    std::printf("%s: %.0f kN·m with contact, %.0f without\n", system.bodies[b].name.c_str(),
                solution.outputs[b].back().peak(0) / 1e3, free.solution().outputs[b].back().peak(0) / 1e3);
  }
}
