// A soft storey that yields beside a stiff neighbour: ductility with and without contact, and where the energy went.
#include <bentur/contact/laws/linear.h>
#include <bentur/pounding/pounding.h>
#include <bentur/structure/damping.h>
#include <bentur/structure/stick.h>

#include <cstdio>
#include <memory>

using namespace bentur;

int main() {
  const Stick stick{.storey_heights = {3.5, 3.0},
                    .masses = {1e5, 8e4},
                    .stiffnesses = {2e7, 3e7},
                    .yield_forces = {1.5e5, 2e5},
                    .hardening = {0.05}};
  Building soft = make_building("soft", stick_model(stick), ModalDamping{{0.05}});
  soft.elements = storey_elements(soft.model, storey_laws(stick, soft.model));
  Problem problem;
  problem.buildings = {soft,
                       make_building("stiff", stick_model({{3.5, 3.0}, {1e5, 8e4}, {9e7, 9e7}}), ModalDamping{{0.05}})};
  problem.points = {
      {.left_floor = 1, .right_floor = 1, .elevation = 6.5, .width = 0.01, .law = std::make_shared<Linear>(2e8)}};
  problem.motion = HarmonicMotion{.period = 0.6, .displacement_amplitude = 0.02};
  problem.duration = 6.0;

  const Response response = solve(problem, ExactSolver{}, {.output_step = 0.5, .energy_audit = true});
  const BuildingPeaks& peaks = response.buildings[0];
  std::printf("ductility %.3f with contact, %.3f without\n", peaks.yielding.ductility(0),
              peaks.yielding_no_contact.ductility(0));
  const EnergyHistories& energy = response.energy->histories;
  const Eigen::Index end = energy.input.size() - 1;
  std::printf("of %.1f kJ damping took %.1f and yielding %.1f\n", energy.input(end) / 1e3, energy.damping(end) / 1e3,
              energy.hysteretic(end) / 1e3);
}
