#include "bentur/solve/tangent/tangent.h"

#include <algorithm>
#include <cmath>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/solve/engine/tangent/peak_places.h"

namespace bentur {
namespace engine {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

using Sought = PeakPlaces::Sought;
using Place = PeakPlaces::Place;

constexpr double near_peak = 1e-6;       // of a peak: what is found so near is it
constexpr double event_instant = 1e-11;  // of the duration: of an event, and of what stands there
constexpr double same_force = 1e-6;
constexpr double no_peak = 1e-12;  // of the largest displacement: less is round-off

/// A relation as one row over all coordinates.
VectorXd row_of(const ModalSystem& modal, const ModalSystem::Relation& at) {
  VectorXd row = VectorXd::Zero(modal.size);
  row.segment(at.left_begin, at.left_size) += at.left_row;
  if (at.right_size > 0) row.segment(at.right_begin, at.right_size) += at.right_row;
  return row;
}

/// How a row of the first outputs of a body changes with the numbers.
std::vector<Dependence::OfRow> moved_output(const System& system, const ModalSystem& modal,
                                            const std::vector<Variation>& variations, std::size_t body, Index row) {
  std::vector<Dependence::OfRow> moved;
  for (Index p = 0; p < std::ssize(variations); ++p) {
    const Variation& by = variations[p];
    const RowVectorXd less = by.below.bodies[body].outputs.front().rows.row(row);
    const RowVectorXd more = by.above.bodies[body].outputs.front().rows.row(row);
    if (less == more) continue;
    Dependence::OfRow& of = moved.emplace_back(Dependence::OfRow{p, VectorXd::Zero(modal.size), {}});
    const MatrixXd& shapes = system.bodies[body].modes.shapes;
    of.row.segment(modal.blocks[body].begin, shapes.cols()) =
        shapes.transpose() * (more - less).transpose() / (2 * by.step);
  }
  return moved;
}

/// Of each contact the deformation without width, and then the first outputs of each body.
std::vector<Sought> sought_of(const System& system, const ModalSystem& modal, const Dependence& by,
                              const std::vector<Variation>& variations, const std::vector<double>* needed,
                              const std::vector<std::vector<OutputsFound>>& outputs) {
  std::vector<Sought> result;
  for (std::size_t i = 0; needed != nullptr && i < system.contacts.size(); ++i) {
    const auto element = static_cast<Index>(i);
    result.push_back({row_of(modal, modal.elements[i].relation), 0.0, false, (*needed)[i], by.rows(element)});
  }
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (outputs[b].empty()) continue;
    const ModalSystem::Block& block = modal.blocks[b];
    const VectorXd& peak = outputs[b].front().peak;
    for (Index r = 0; r < peak.size(); ++r) {
      VectorXd row = VectorXd::Zero(modal.size);
      row.segment(block.begin, block.size) = block.outputs.front().of_position.row(r);
      result.push_back(
          {row, block.outputs.front().at_rest(r), true, peak(r), moved_output(system, modal, variations, b, r)});
    }
  }
  return result;
}

/// A run without derivatives, by which it is found when peaks are, and how fast contacts are at most.
std::vector<Place> places_of(const TangentRun::Setup& setup, const std::vector<Sought>& sought,
                             const std::vector<Change>& changes, bool with_contact, std::vector<double>& speeds) {
  std::vector<Place> result;
  for (const bool thorough : {false, true}) {
    PeakPlaces places(setup, sought, thorough);
    TangentRun run(setup, with_contact);
    const auto take = [&](const TangentRun::Stretch& stretch, const TangentState& to) { places.take(stretch, to); };
    places.take_end(0.0, run.state());
    for (const Change& change : changes) {
      run.go_to(change.time, take);
      run.change(change);
      places.take_event(change.time, run.before_event(), run.state());
    }
    run.go_to(setup.system.duration, take);
    places.take_end(setup.system.duration, run.state());
    result = places.places();
    speeds = run.speeds();
    if (places.all()) break;
  }
  return result;
}

/// What is wanted at an instant.
struct Want {
  double time = 0;
  const Sought* sought = nullptr;  ///< null: the force of a contact
  Index contact = -1;
  double force = 0;  ///< of that, as it is known
  Derivative* into = nullptr;
};

void take_want(const Want& want, TangentRun& run, bool at_event) {
  Derivative& into = *want.into;
  into.time = want.time;
  into.grazing = run.grazing();
  into.is_simultaneous = run.is_simultaneous();
  if (want.sought == nullptr) {
    RowVectorXd by;
    into.value = run.force(want.contact, by);
    if (at_event) by += run.force_rate(want.contact) * run.event_by();
    const bool is_whole = std::abs(into.value - want.force) <= same_force * want.force;
    if (is_whole && by.allFinite()) into.by = by.transpose();
    into.value = want.force;  // else it has ended there at once, where bodies slipped off
    return;
  }
  const TangentState& state = at_event ? run.before_event() : run.state();
  into.value = want.sought->row.dot(state.q) + want.sought->offset;
  const double sign = want.sought->of_size && into.value < 0.0 ? -1.0 : 1.0;
  RowVectorXd by = want.sought->row.transpose() * state.by_q;
  for (const Dependence::OfRow& moved : want.sought->moved) by(moved.parameter) += moved.row.dot(state.q);
  if (at_event) by += want.sought->row.dot(state.v) * run.event_by();
  into.value *= sign;
  if (by.allFinite()) into.by = sign * by.transpose();
}

/// Goes to all that is wanted, in order of time, and to the changes before the last of it.
void follow(TangentRun& run, std::vector<Want> wants, const std::vector<Change>& changes, double duration) {
  std::stable_sort(wants.begin(), wants.end(), [](const Want& a, const Want& b) { return a.time < b.time; });
  const double slack = event_instant * duration;
  std::size_t next = 0;
  for (const Want& want : wants) {
    while (next < changes.size() && changes[next].time < want.time - slack) {
      run.go_to(changes[next].time);
      run.change(changes[next++]);
    }
    // What stands at an event goes with it: a force that sets in with its own, what a blow ends with its blow.
    bool at_event = false;
    if (want.time > 0.0) {
      while (next < changes.size() && changes[next].time <= want.time + slack) {
        run.go_to(changes[next].time);
        run.change(changes[next++]);
      }
      at_event = next > 0 && std::abs(changes[next - 1].time - want.time) <= slack && changes[next - 1].time > 0.0;
    }
    if (!at_event) run.go_to(want.time);
    take_want(want, run, at_event);
  }
}

}  // namespace
}  // namespace engine

using namespace engine;

std::optional<std::string> why_no_tangents(const System& system) {
  for (const Body& body : system.bodies) {
    if (!body.elements.empty() || !body.coupled.empty()) return "a building that yields is not followed";
    if (!body.is_rigid() && body.modes.omega.size() != body.dofs()) return "of a building not all modes are known";
  }
  if (!system.rubbing.empty()) return "contacts that rub are not followed";
  for (const Contact& contact : system.contacts) {
    LawState touching;
    touching.branch = 1;
    if (!contact.law->branch(touching).linear) {
      return "the law '" + std::string(contact.law->name()) + "' has a curved force, which is not followed";
    }
  }
  for (const Element& joint : system.joints) {
    const Branch branch = joint.law->branch({});
    if (!branch.linear || branch.guard_count > 0) {
      return "the link '" + std::string(joint.law->name()) + "' has more than one branch, which is not followed";
    }
  }
  return std::nullopt;
}

std::optional<std::string> why_no_tangents(const System& system, const Variation& by) { return trouble_of(system, by); }

Tangents tangents(const FreeSolution& free, const Solution& found, const std::vector<Variation>& variations) {
  const System& system = free.system();
  if (const auto why = why_no_tangents(system))
    throw InvalidParameter("system", "this one", "must be followed: " + *why);
  for (std::size_t p = 0; p < variations.size(); ++p) {
    if (const auto why = trouble_of(system, variations[p]))
      throw InvalidParameter(indexed("variations", p), *why, "must not");
  }
  const ModalSystem modal(system);
  const TimeGrid grid(system);
  const ElementLaws laws = laws_of(system, modal, system.contacts);
  const Dependence none(system, modal), by(system, modal, variations);
  const TangentRun::Setup still{system, modal, grid, laws, none}, setup{system, modal, grid, laws, by};

  const Solution& alone = free.solution();
  const std::vector<Sought> free_sought = sought_of(system, modal, by, variations, &alone.needed, alone.outputs);
  const std::vector<Sought> sought = sought_of(system, modal, by, variations, nullptr, found.outputs);
  std::vector<double> speeds;
  const std::vector<Place> free_places = places_of(still, free_sought, {}, false, speeds);
  const bool touches = !found.changes.empty();
  const std::vector<Place> places =
      touches ? places_of(still, sought, found.changes, true, speeds)
              : std::vector<Place>(free_places.begin() + std::ssize(alone.needed), free_places.end());

  Tangents result;
  result.needed.resize(system.contacts.size());
  result.peak_force.resize(system.contacts.size());
  result.displacement.resize(system.bodies.size());
  std::vector<Want> free_wants, wants;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (!alone.outputs[b].empty()) result.displacement[b].resize(alone.outputs[b].front().peak.size());
  }
  result.displacement_free = result.displacement;
  double least = 0.0;
  for (const Sought& one : free_sought) least = std::max(least, no_peak * one.peak);
  const auto want = [least](std::vector<Want>& list, const Sought& of, const Place& place, Derivative& into) {
    into.is_equalled = place.is_equalled;
    const double size = of.of_size ? std::abs(place.value) : place.value;
    if (place.time >= 0.0 && of.peak > least && std::abs(size - of.peak) <= near_peak * of.peak) {
      list.push_back({place.time, &of, -1, 0, &into});
    }
  };
  std::size_t at = 0;
  for (Derivative& into : result.needed) {
    want(free_wants, free_sought[at], free_places[at], into);
    ++at;
  }
  std::size_t of_contact = 0;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    for (std::size_t r = 0; r < result.displacement[b].size(); ++r, ++at, ++of_contact) {
      want(free_wants, free_sought[at], free_places[at], result.displacement_free[b][r]);
      want(touches ? wants : free_wants, sought[of_contact], places[of_contact], result.displacement[b][r]);
    }
  }
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Impact* hardest = nullptr;
    for (const Impact& impact : found.impacts) {
      if (impact.point != static_cast<Index>(i) || !(impact.peak_force > 0.0)) continue;
      if (hardest == nullptr || impact.peak_force > hardest->peak_force) hardest = &impact;
    }
    if (hardest == nullptr || laws.laws[i]->restitution()) continue;
    for (const Impact& impact : found.impacts) {
      if (&impact == hardest || impact.point != static_cast<Index>(i)) continue;
      if (impact.peak_force >= (1.0 - same_force) * hardest->peak_force) result.peak_force[i].is_equalled = true;
    }
    wants.push_back(
        {hardest->peak_force_time, nullptr, static_cast<Index>(i), hardest->peak_force, &result.peak_force[i]});
  }

  TangentRun run(setup, false);
  if (!touches) {
    follow(run, free_wants, {}, system.duration);
    return result;
  }
  TangentRun struck(setup, true);
  struck.set_usual_speeds(speeds);
  follow(run, free_wants, {}, system.duration);
  follow(struck, wants, found.changes, system.duration);
  return result;
}

}  // namespace bentur
