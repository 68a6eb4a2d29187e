// Two buildings at many gaps: what they share is solved once, and only what follows the first contact again.
#include <bentur/contact/laws/linear.h>
#include <bentur/pounding/pounding.h>
#include <bentur/structure/damping.h>
#include <bentur/structure/stick.h>

#include <cstdio>
#include <memory>

using namespace bentur;

int main() {
  Problem problem;  // height [m], mass [kg], stiffness [N/m] of one storey each
  problem.buildings = {make_building("soft", stick_model({{3.0}, {1e5}, {4e6}}), ModalDamping{{0.05}}),
                       make_building("stiff", stick_model({{3.0}, {1e5}, {9e6}}), ModalDamping{{0.05}})};
  problem.points = {{.elevation = 3.0, .law = std::make_shared<Linear>(1e8)}};
  problem.motion = HarmonicMotion{.period = 0.5, .displacement_amplitude = 0.02};
  problem.duration = 10.0;

  const FreeResponse free(problem);
  for (const double gap : {0.0, 0.02, 0.04, 0.06, 0.08, 0.1}) {
    problem.points[0].width = gap;
    const Response response = free.solve(problem);
    std::printf("%3.0f mm: %3d impacts, %5.0f kN\n", gap * 1e3, response.points[0].impacts,
                response.points[0].peak_force / 1e3);
  }
}
