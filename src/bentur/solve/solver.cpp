#include "bentur/solve/solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/solve/engine/run/account/to_come.h"
#include "bentur/solve/engine/run/free_run.h"
#include "bentur/solve/engine/run/pounding_run.h"

namespace bentur {
namespace engine {
namespace {

/// How large the lengths are whose difference a δ is: of its rows in the free response, or where that is not known the
/// largest of their bodies, and of the ground.
double largest_length(const Interface& at, const Solution& free, const Run& run, Eigen::Index components) {
  double sum = 0.0;
  for (const BodyRow* side : {&at.left, &at.right}) {
    if (side->body < 0) continue;
    const Eigen::VectorXd& lengths = free.outputs[side->body].front().peak;
    sum += side->output >= 0 ? lengths(side->output) : lengths.maxCoeff();
    for (Eigen::Index c = 0; c < components; ++c) sum += run.largest_ground_displacement(side->body, c);
  }
  return sum;
}

/// How far from zero openings were where they are zero, as a part of the displacements there [-].
double worst_opening(const System& system, const Elements& elements, const std::vector<double>& scales,
                     const Solution& solution) {
  double worst = 0.0;
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    double moved = 0.0;
    for (const BodyRow* side : {&system.contacts[i].at.left, &system.contacts[i].at.right}) {
      if (side->body >= 0) moved += solution.outputs[side->body].front().peak.maxCoeff();
    }
    const double opening = elements.worst_opening(static_cast<Eigen::Index>(i));
    if (opening > 0.0) worst = std::max(worst, opening / (scales[i] + moved));
  }
  return worst;
}

/// How far any sample lies beyond the peak that is found of it, as a part of the largest peak of its kind [-].
double beyond_peaks(const Solution& solution) {
  // Of what an output is a sum of: smaller ones are known no better. What is beyond by 1e-9 of the scale is reported,
  // so that this allows 1e-13 of the sum, some hundred times the precision of a number.
  constexpr double round_off = 1e-4;
  if (solution.samples.time.empty()) return 0.0;
  double worst = 0.0;
  const auto compare = [&worst](const auto& samples, double peak, double scale) {
    if (samples.size() > 0 && scale > 0.0) worst = std::max(worst, (samples.maxCoeff() - peak) / scale);
  };
  for (const std::vector<OutputsFound>& body : solution.outputs) {
    for (const OutputsFound& output : body) {
      if (output.peak.size() == 0) continue;
      for (Eigen::Index i = 0; i < output.history.rows(); ++i) {
        const double scale = std::max(output.peak.maxCoeff(), round_off * output.size(i));
        compare(output.history.row(i).cwiseAbs(), output.peak(i), scale);
      }
    }
  }
  std::vector<double> pushed(solution.samples.force.rows(), 0.0), pulled = pushed;
  double hardest = 0.0;
  for (const Impact& impact : solution.impacts) {
    pushed[impact.point] = std::max(pushed[impact.point], impact.peak_force);
    pulled[impact.point] = std::max(pulled[impact.point], impact.peak_tension);
    hardest = std::max({hardest, impact.peak_force, impact.peak_tension});
  }
  for (Eigen::Index i = 0; i < solution.samples.force.rows(); ++i) {
    compare(solution.samples.force.row(i), pushed[i], hardest);
    compare(-solution.samples.force.row(i), pulled[i], hardest);
  }
  for (Eigen::Index i = 0; i < solution.samples.joint_force.rows(); ++i) {
    const ElementFound& joint = solution.joints[i];
    const double force = std::max(joint.peak_force, joint.peak_tension);
    const double moved = std::max(joint.closing.reach, joint.opening.reach);
    compare(solution.samples.joint_force.row(i), joint.peak_force, force);
    compare(-solution.samples.joint_force.row(i), joint.peak_tension, force);
    compare(solution.samples.joint_deformation.row(i), joint.closing.reach, moved);
    compare(-solution.samples.joint_deformation.row(i), joint.opening.reach, moved);
  }
  return worst;
}

std::vector<Contact> without_widths(std::vector<Contact> contacts) {
  for (Contact& contact : contacts) contact.width = 0.0;
  return contacts;
}

/// The grid, whose plan is large where it has many segments. @throws InvalidParameter when there are too many.
const TimeGrid& affordable(const TimeGrid& grid, double duration, const RunLimits& limits) {
  double period = 0.0;
  for (std::size_t kind = 0; kind < grid.kinds(); ++kind) period += grid.length(kind);
  const double segments = duration / period * static_cast<double>(grid.kinds());
  if (limits.steps > 0 && segments > static_cast<double>(limits.steps)) {
    throw InvalidParameter("limits.steps", fmt::format("{}", limits.steps),
                           fmt::format("must be {:.3g} at least", segments));
  }
  return grid;
}

}  // namespace

/// In the order in which each part is made of those before. Gaps have no width here: what is found serves all widths.
struct FreeParts {
  FreeParts(System s, const Solver& by, const RunLimits& most) : system(std::move(s)), solver(by), limits(most) {
    laws.sets = std::make_shared<SetsOverModes>();
  }
  FreeParts(const FreeParts&) = delete;  // its members point to one another
  FreeParts& operator=(const FreeParts&) = delete;

  System system;
  Solver solver;
  RunLimits limits;
  bool exact = std::holds_alternative<ExactSolver>(solver);
  ModalSystem modal{system};
  Elements::Laws laws = laws_of(system, modal, without_widths(system.contacts));
  TimeGrid grid{system, exact};
  FlightPlan plan{modal, affordable(grid, system.duration, limits), system.duration, exact};
  FreeResult result;
  Solution solution;
  // Scales per contact, those that rub last: of both sides and the ground together.
  std::vector<double> largest_displacement;  ///< [length]
  std::vector<double> largest_speed;         ///< [length/s]; where nothing moves there, the largest of all
};

namespace {

/// What every run has found, as it left it.
void report(const System& system, const ModalSystem& modal, Status status, Run& run, Solution& solution) {
  solution.status = status;
  if (status == Status::stopped) solution.message = "stopped on request";
  if (status == Status::failed) solution.message = run.trouble();
  solution.steps = run.steps();
  solution.passed = run.passed();
  solution.outputs.resize(system.bodies.size());
  solution.members.resize(system.bodies.size());
  Eigen::Index element = modal.members;
  const std::vector<Reach>& spans = run.spans().nearest();
  std::size_t span = 2 * system.joints.size();
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    solution.outputs[b].resize(system.bodies[b].outputs.size());
    run.watch().report(b, solution.outputs[b]);
    solution.members[b].resize(system.bodies[b].elements.size());
    for (std::size_t i = 0; i < solution.members[b].size(); ++i) {
      ElementFound& member = solution.members[b][i];
      if (system.bodies[b].elements[i].law->yields_unevenly()) {
        member.closing = spans[span++];
        member.opening = spans[span++];
      }
      member.residual = run.elements().residual(element, run.state());
      member.loss = run.elements().loss(element, run.state());
      member.energy_lost = run.elements().energy_lost(element++, run.state());
    }
  }
  solution.coupled = run.elements().coupled(run.state());
  solution.joints.resize(system.joints.size());
  for (std::size_t i = 0; i < solution.joints.size(); ++i) {
    const Eigen::Index joint = modal.joint(static_cast<Eigen::Index>(i));
    const Elements::Account& account = run.elements().account(joint);
    solution.joints[i] = {.peak_force = account.peak_force,
                          .peak_tension = account.peak_tension,
                          .closing = spans[i],
                          .opening = spans[solution.joints.size() + i],
                          .energy_lost = run.elements().energy_lost(joint, run.state())};
  }
  solution.watched = run.watched().nearest();
}

}  // namespace
}  // namespace engine

std::string_view name(const Solver& solver) {
  if (std::holds_alternative<AdaptiveSolver>(solver)) return "adaptive";
  if (std::holds_alternative<RungeKuttaSolver>(solver)) return "runge-kutta";
  return "exact";
}

void validate(const Solver& solver) {
  if (const auto* adaptive = std::get_if<AdaptiveSolver>(&solver)) {
    if (!(adaptive->tolerance >= 1e-13 && adaptive->tolerance <= 1e-2)) {
      throw InvalidParameter("tolerance", fmt::format("{}", adaptive->tolerance), "must be in [1e-13, 1e-2]");
    }
  }
  if (const auto* fixed = std::get_if<RungeKuttaSolver>(&solver)) require_positive("step", fixed->step);
}

FreeSolution::FreeSolution(System system, const Solver& solver, const std::function<bool(double)>& progress,
                           const RunLimits& limits) {
  validate(solver);
  const auto parts = std::make_shared<engine::FreeParts>(std::move(system), solver, limits);
  const System& given = parts->system;
  engine::FreeRun run({parts->modal, given, parts->laws, parts->solver, parts->grid, parts->plan, limits});
  const Status status = run.to_end(progress);
  Solution& solution = parts->solution;
  engine::report(given, parts->modal, status, run, solution);
  for (const Reach& reach : run.idle().nearest()) solution.needed.push_back(reach.reach);
  solution.watched_free = run.others().nearest();
  for (const Interface& watched : given.watched) {
    solution.scales.push_back(engine::largest_length(watched, solution, run, parts->modal.components()));
  }
  for (const Contact& contact : given.contacts) {
    parts->largest_displacement.push_back(engine::largest_length(contact.at, solution, run, parts->modal.components()));
  }
  for (const RubbingContact& contact : given.rubbing) {
    parts->largest_displacement.push_back(engine::largest_length(contact.at, solution, run, parts->modal.components()));
  }
  solution.to_come = engine::to_come(given, parts->modal, run.state(), run.elements());
  parts->result = run.take_result();
  std::vector<double>& speeds = parts->largest_speed;
  speeds = parts->result.speeds;
  const double fastest = speeds.empty() ? 0.0 : *std::max_element(speeds.begin(), speeds.end());
  std::replace(speeds.begin(), speeds.end(), 0.0, fastest);
  parts_ = parts;
}

struct FreeSolution::Scaled {
  double factor;  // the motions of the system are so many times those of the parts
  System system;
  Solution solution;
};

std::optional<FreeSolution> FreeSolution::scaled(const std::vector<GroundMotion>& motions) const {
  const auto factor = times(motions, parts_->system.motions);
  if (!factor || !parts_->exact || parts_->solution.status != Status::done || !is_homogeneous(parts_->system)) {
    return std::nullopt;
  }
  Scaled scaled{*factor, parts_->system, bentur::scaled(parts_->solution, *factor)};
  scaled.system.motions = motions;
  FreeSolution free = *this;
  free.scaled_ = std::make_shared<const Scaled>(std::move(scaled));
  return free;
}

bool FreeSolution::takes(const std::vector<Contact>& contacts, const std::vector<RubbingContact>& rubbing) const {
  return !scaled_ || are_homogeneous(contacts, rubbing);
}

const System& FreeSolution::system() const { return scaled_ ? scaled_->system : parts_->system; }

const Solution& FreeSolution::solution() const { return scaled_ ? scaled_->solution : parts_->solution; }

Solution FreeSolution::solve(const std::vector<Contact>& contacts, const std::vector<RubbingContact>& rubbing,
                             const RunOptions& options) const {
  if (scaled_) {
    if (!takes(contacts, rubbing)) {
      throw InvalidParameter("contacts.law", "one of them", "must be homogeneous where a free solution is scaled");
    }
    const auto narrower = [&](auto list) {
      for (auto& one : list) one.width /= scaled_->factor;
      return list;
    };
    FreeSolution of_parts = *this;
    of_parts.scaled_ = nullptr;
    return bentur::scaled(of_parts.solve(narrower(contacts), narrower(rubbing), options), scaled_->factor);
  }
  const engine::FreeParts& parts = *parts_;
  Solution solution = parts.solution;
  if (solution.status != Status::done && solution.status != Status::collapsed) return solution;
  std::vector<double> widths;
  for (const Contact& contact : contacts) widths.push_back(contact.width);
  for (const RubbingContact& contact : rubbing) widths.push_back(contact.width);
  // Of approximate solvers the state alone is not all there is to go on with.
  const long first_contact = parts.exact ? engine::first_contact(parts.result, widths) : 0;
  const bool records = options.output_step > 0.0 || options.course || options.energy_audit;
  if (first_contact == std::numeric_limits<long>::max() && !records) return solution;

  engine::Elements::Scales scales{parts.largest_displacement, parts.largest_speed};
  for (std::size_t i = 0; i < widths.size(); ++i) scales.displacement[i] += widths[i];
  engine::Elements::Laws laws = engine::laws_of(parts.system, parts.modal, contacts, rubbing);
  laws.sets = parts.laws.sets;
  engine::PoundingRun run({parts.modal, parts.system, laws, parts.solver, parts.grid, parts.plan, options.limits},
                          scales, first_contact, options);
  if (options.course) {
    run.trace({parts.modal, parts.system, laws.offsets, parts.solution, parts.largest_displacement});
  }
  if (!records) {
    const auto& checkpoints = parts.result.checkpoints;
    const auto later = std::find_if(checkpoints.begin(), checkpoints.end(),
                                    [&](const auto& checkpoint) { return checkpoint.segment > first_contact; });
    if (later != checkpoints.begin()) run.resume(*std::prev(later));
  }
  const Status status = run.to_end(options.progress);
  run.elements().finish(run.passed() ? run.passed()->time : parts.system.duration);
  engine::report(parts.system, parts.modal, status, run, solution);
  solution.to_come = engine::to_come(parts.system, parts.modal, run.state(), run.elements());
  solution.impacts = std::move(run.elements().impacts());
  solution.events = run.elements().events();
  run.sampler().finish(solution);
  if (run.tracer()) run.tracer()->finish(solution);
  solution.changes = std::move(run.changes());
  if (run.energy()) solution.energy = run.energy()->finish();
  solution.checks = {run.momentum().worst(),
                     engine::worst_opening(parts.system, run.elements(), scales.displacement, solution),
                     engine::force_imbalance(parts.system, parts.modal, run.state(), run.inputs(), run.elements()),
                     engine::beyond_peaks(solution)};
  return solution;
}

}  // namespace bentur
