#include "bentur/solve/effort.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bentur/contact/laws/rubbing.h"
#include "bentur/solve/engine/motion/modal_system.h"
#include "bentur/solve/engine/motion/series.h"
#include "bentur/solve/engine/motion/step_buffer.h"
#include "bentur/solve/engine/motion/time_grid.h"

namespace bentur {
namespace {

using By = Effort::Fastest::By;
using engine::ModalSystem;

constexpr double two_pi = 2.0 * std::numbers::pi;
// By measurement (effort_test.cpp): what the pair takes in radians of the fastest mode, from slow to damped ones.
constexpr double pair_least = 5.5;
constexpr double pair_most = 1.0;
constexpr double unstable = 2.83;        // ω · step beyond which the rule of order four lets an oscillator grow [-]
constexpr double seconds_a_step = 3e-6;  // in contact; by measurement, as the next one
constexpr double seconds_a_coordinate = 3e-7;  // of a step
constexpr double copies = 4.0;                 // of histories while their file is made, and of a record
constexpr double overhead = 48e6;              // [byte] of the program and of what its search for peaks keeps

/// The force of every point while its bodies touch, and of every joint where it is stiffest.
engine::ElementForces touching(const System& system, const ModalSystem& modal, bool& nonlinear) {
  engine::ElementForces forces;
  for (Eigen::Index i = 0; i < std::ssize(system.contacts); ++i) {
    const Law& law = *system.contacts[i].law;
    const LawState closed = law.next({}, 0, 0.0, 0.0, 1.0);
    const Branch branch = law.branch(closed);
    forces.linear.push_back({0.0, branch.stiffness, branch.damping});
    forces.pressing.push_back(i);
    nonlinear = nonlinear || !branch.linear;
    const Branch after = law.branch(law.next(closed, 0, 0.0, 0.0, -1.0));
    for (std::size_t g = 0; g < after.guard_count; ++g) {
      if (after.guards[g].decaying != 0.0) forces.fading = std::max(forces.fading, after.guards[g].rate);
    }
  }
  for (const Element& joint : system.joints) {
    Branch stiffest = joint.law->branch({});
    for (std::size_t g = 0; g < stiffest.guard_count; ++g) {
      const Branch next = joint.law->branch(joint.law->next({}, g, 0.0, 0.0, 0.0));
      if (next.stiffness > stiffest.stiffness) stiffest = next;
    }
    forces.pressing.push_back(std::ssize(forces.linear));
    forces.linear.push_back({0.0, stiffest.stiffness, stiffest.damping});
  }
  // Of what rubs, both deformations as if each were alone, and it sticks.
  forces.linear.resize(modal.elements.size());
  for (std::size_t n = 0; n < system.rubbing.size(); ++n) {
    const Rubbing& rubbing = *system.rubbing[n].law;
    const Eigen::Index i = modal.opening(modal.switched + static_cast<Eigen::Index>(n));
    const Branch branch = rubbing.normal().branch(rubbing.normal().next({}, 0, 0.0, 0.0, 1.0));
    forces.linear[i] = {0.0, branch.stiffness, branch.damping};
    forces.linear[i + 1] = {0.0, rubbing.tangential_stiffness(), 0.0};
    for (const Eigen::Index row : {i, i + 1}) forces.pressing.push_back(row);
  }
  return forces;
}

void raise(Effort::Fastest& fastest, double rate, const Effort::Fastest& other) {
  if (!(rate > two_pi * fastest.frequency)) return;
  fastest = other;
  fastest.frequency = rate / two_pi;
}

/// Of the bodies and the motion.
Effort::Fastest fastest_apart(const System& given, const ModalSystem& system) {
  Effort::Fastest fastest;
  raise(fastest, system.fastest_input(), {.by = By::motion});
  for (Eigen::Index b = 0; b < std::ssize(given.bodies); ++b) {
    if (given.bodies[b].is_rigid()) continue;
    Eigen::Index mode = 0;
    const double omega = given.bodies[b].modes.omega.maxCoeff(&mode);
    raise(fastest, omega, {.by = By::mode, .building = b, .mode = mode});
    raise(fastest, system.blocks[b].half_damping, {.by = By::damping, .building = b});
  }
  return fastest;
}

/// The same with contacts, each as if it were the only one.
Effort::Fastest fastest_in_contact(const ModalSystem& system, const engine::ElementForces& forces,
                                   Effort::Fastest fastest) {
  for (Eigen::Index point = 0; point < system.points(); ++point) {
    const Eigen::Index first = system.opening(point);
    for (Eigen::Index i = first; i <= (point < system.switched ? first : first + 1); ++i) {
      const double own = system.coupling(i, i);
      raise(fastest, std::sqrt(own * forces.linear[i].stiffness), {.by = By::contact, .point = point});
      raise(fastest, 0.5 * own * forces.linear[i].damping, {.by = By::contact, .point = point});
    }
    raise(fastest, forces.fading, {.by = By::contact, .point = point});
  }
  return fastest;
}

/// Bytes that grow with the case, into the effort.
void add_memory(Effort& effort, const System& given, const ModalSystem& system, double segments) {
  double peaks = 0.0, sampled = 0.0;  // outputs of which there are some
  for (const auto& block : system.blocks) {
    for (const auto& group : block.outputs) {
      if (group.has_peak) peaks += static_cast<double>(group.count());
      sampled += static_cast<double>(group.count());
    }
  }
  const auto points = static_cast<double>(system.points());
  const auto size = static_cast<double>(system.size);
  const auto inputs = static_cast<double>(given.bodies.size() * given.motions.size());
  const double plan = segments * inputs * sizeof(engine::kernels::FlightInput);
  const double reaches = 16.0 * segments * points;
  const double checkpoints = segments / static_cast<double>(engine::StepBuffer::most) * 8.0 * (2.0 * size + peaks);
  const double histories =
      8.0 * effort.samples * (1.0 + static_cast<double>(given.motions.size()) + sampled + 2.0 * points);
  double motions = 0.0;
  for (const GroundMotion& motion : given.motions) {
    const auto* record = std::get_if<SampledMotion>(&motion);
    if (record != nullptr) motions += 8.0 * static_cast<double>(record->acceleration.size());
  }
  effort.memory_of_steps = plan + reaches + checkpoints + copies * motions;
  effort.memory = overhead + effort.memory_of_steps + copies * histories;
}

}  // namespace

Effort effort(const System& given, const Solver& solver, const RunOptions& options) {
  const bool exact = std::holds_alternative<ExactSolver>(solver);
  const ModalSystem system(given);
  const engine::TimeGrid grid(given, exact);
  bool nonlinear = false;
  const engine::ElementForces forces = touching(given, system, nonlinear);

  Effort result;
  result.apart = fastest_apart(given, system);
  result.in_contact = fastest_in_contact(system, forces, result.apart);
  const double free_rate = system.rate({});
  const double contact_rate = system.rate(forces);
  double period = 0.0;
  double series = 0.0;  // in a period of the grid, without contact
  double halved = 0.0;
  double closed = 0.0;  // in contact all the time
  for (std::size_t kind = 0; kind < grid.kinds(); ++kind) {
    const double product = grid.length(kind) * free_rate / engine::series_reach;
    period += grid.length(kind);
    series += std::max(1.0, std::ceil(product));
    const double parts = std::exp2(std::ceil(std::log2(std::max(1.0, product))));
    halved += parts;
    // A contact is solved in the parts that a segment is halved into, each by whole steps.
    const double taken = system.classical ? parts : 1.0;
    closed += taken * std::ceil(grid.length(kind) / taken * contact_rate / engine::series_reach);
  }
  const double periods = given.duration / period;
  constexpr double round_off = 1e-12;
  const double segments = std::ceil(periods * static_cast<double>(grid.kinds()) * (1.0 - round_off));
  if (options.output_step > 0.0) result.samples = std::floor(given.duration / options.output_step) + 1.0;
  if (exact) {
    result.steps = system.classical ? segments : periods * series;
    // Contact cuts steps short, and what is near to one is halved.
    result.steps_in_contact = nonlinear ? contact_rate / pair_most : closed / period;
    const double audited = options.energy_audit ? periods * halved : 0.0;
    result.certain_steps = result.steps + audited;
    result.most_steps = 2.0 * (result.steps + result.samples) + audited + given.duration * result.steps_in_contact;
  } else if (const auto* fixed = std::get_if<RungeKuttaSolver>(&solver)) {
    result.growing_step = unstable / (two_pi * result.apart.frequency);
    result.steps = segments + given.duration / fixed->step;
    result.steps_in_contact = 3.0 / fixed->step + segments / given.duration;
    result.most_steps = result.steps + given.duration * result.steps_in_contact;
  } else {
    result.steps = std::max(segments, given.duration * free_rate / pair_least);
    result.steps_in_contact = contact_rate / pair_most + segments / given.duration;
    result.most_steps = 2.0 * given.duration * result.steps_in_contact;
  }
  result.certain_steps = std::max(result.certain_steps, result.steps);
  add_memory(result, given, system, exact && system.classical ? segments : 0.0);
  result.seconds = result.most_steps * (seconds_a_step + seconds_a_coordinate * static_cast<double>(system.size));
  return result;
}

}  // namespace bentur
