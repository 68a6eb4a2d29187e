#include "bentur/pounding/internal/summaries.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bentur/core/algebra/factors.h"
#include "bentur/core/algebra/symmetric.h"
#include "bentur/core/not_known.h"
#include "bentur/elements/hinges.h"
#include "bentur/pounding/assemble.h"
#include "bentur/pounding/internal/levels.h"
#include "bentur/structure/body.h"
#include "bentur/structure/frame/infill.h"

namespace bentur {
namespace {

constexpr double round_off_watched = 0x1p-40;  // of the displacements that an opening is the difference of

/// The outputs of one kind of one building.
template <class Found>
auto& of_kind(Found& solution, std::size_t building, OutputKind kind) {
  return solution.outputs[building][static_cast<std::size_t>(kind)];
}

/// What yielding did in storeys, of a building whose peaks are known.
BuildingPeaks::Yielding yielding_of(const Building& building, const std::vector<ElementFound>& members,
                                    const BuildingPeaks& peaks) {
  BuildingPeaks::Yielding yielding;
  const Eigen::Index floors = building.model.floors();
  yielding.ductility.setConstant(floors, not_known);
  yielding.residual_drift_ratio.setZero(floors);
  if (building.model.slab) yielding.residual_drift_ratio(*building.model.slab) = not_known;
  yielding.hysteretic_energy.setZero(floors);
  for (std::size_t i = 0; i < members.size(); ++i) {
    const BuildingElement& element = building.elements[i];
    if (element.infill) continue;
    const Eigen::Index f = element.storey;
    const double of_storey = building.model.storey_heights[f];
    const double height = of_storey > 0.0 ? of_storey : 1.0;  // a slab's drift is told as a length
    yielding.ductility(f) = ductility(*element.law, peaks.drift_ratio(f) * height, members[i]);
    const double residual = members[i].residual / height;
    yielding.residual_drift_ratio(f) = of_storey > 0.0 ? residual : not_known;
    yielding.hysteretic_energy(f) = members[i].energy_lost;
    if (members[i].loss) take_loss(*members[i].loss, floors, f, yielding);
  }
  return yielding;
}

constexpr double still = 1e-6;  // of the largest part of a shape that does not bend: a storey that has none in it

/// Drifts of the storeys of a frame when nothing acts on it, with what hinges have turned; what has broken and keeps
/// nothing slips along (H-11). NaN of a storey that nothing holds any more.
Eigen::VectorXd unloaded_drifts(const Hinges& hinges, const HingeLaw& law, const CoupledState& state,
                                Eigen::VectorXd theta) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index h = 0; h < law.size(); ++h) {
    if (!law.is_free(state, h)) continue;
    free.push_back(h);
    theta(h) = 0.0;
  }
  const Eigen::MatrixXd& k = hinges.frame_stiffness;
  Eigen::VectorXd pushed = hinges.frame_rows.transpose() * theta;
  if (free.empty()) return hinges.frame_drifts * Cholesky(k).solve(pushed);
  // Their forces Q = G x − K_hh θ are those at rest, −Q₀.
  const Eigen::MatrixXd rows = hinges.frame_rows(free, Eigen::all);
  const Cholesky of_free(hinges.stiffness(free, free));
  const Eigen::VectorXd fixed = hinges.at_rest(free) - hinges.stiffness(free, Eigen::all) * theta;
  pushed += rows.transpose() * of_free.solve(fixed);
  const Eigen::MatrixXd left = k - rows.transpose() * of_free.solve(rows);
  const SymmetricModes shapes = generalised_modes(0.5 * (left + left.transpose()), k);
  Eigen::VectorXd drifts = Eigen::VectorXd::Zero(hinges.frame_drifts.rows());
  for (Eigen::Index n = 0; n < k.rows(); ++n) {
    const Eigen::VectorXd shape = shapes.vectors.col(n);
    const Eigen::VectorXd of_storeys = hinges.frame_drifts * shape;
    if (shapes.values(n) > HingeLaw::bends) {
      drifts += of_storeys * (shape.dot(pushed) / shapes.values(n));
      continue;
    }
    const double least = still * shape.cwiseAbs().maxCoeff();
    drifts = (of_storeys.array().abs() > least).select(not_known, drifts);
  }
  return drifts;
}

InfilledFrame infilled_frame(const Building& building) {
  const StructuralModel& model = building.model;
  return {model.infills, model.hinges, model.first_storey(), model.storey_heights};
}

/// Of each panel of infill what its element did; null: it stays elastic.
std::vector<const ElementFound*> panels_of(const Building& building, const std::vector<ElementFound>& members) {
  std::vector<const ElementFound*> panels(building.model.infills.size(), nullptr);
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (building.elements[i].infill) panels[*building.elements[i].infill] = &members[i];
  }
  return panels;
}

BuildingPeaks peaks_of(const Building& building, std::size_t b, const Solution& solution) {
  const auto peak = [&](OutputKind kind) -> const Eigen::VectorXd& { return of_kind(solution, b, kind).peak; };
  BuildingPeaks peaks;
  peaks.displacement = peak(OutputKind::displacement);
  peaks.drift_ratio = peak(OutputKind::drift_ratio);
  peaks.storey_shear = peak(OutputKind::storey_shear);
  peaks.acceleration = peak(OutputKind::acceleration);
  peaks.column_forces = peak(OutputKind::column_force);
  peaks.foundation = peak(OutputKind::foundation);
  take_hinge_peaks(building.model.hinges, peak(OutputKind::hinge_moment), peak(OutputKind::hinge_rotation),
                   peak(OutputKind::breaking_shear), peaks);
  peaks.infill = infill_of(infilled_frame(building), panels_of(building, solution.members[b]),
                           peak(OutputKind::infill_force), peak(OutputKind::infill_push), peaks.drift_ratio);
  if (building.storeys_yield()) peaks.yielding = yielding_of(building, solution.members[b], peaks);
  return peaks;
}

/// Slabs have no storey, and nothing holds or strains what moves with the ground.
void leave_out_what_is_not_there(const Problem& problem, std::vector<BuildingPeaks>& buildings) {
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    const Building& building = problem.buildings[b];
    if (building.model.slab) buildings[b].drift_ratio(*building.model.slab) = not_known;
    if (!building.is_rigid()) continue;
    buildings[b].drift_ratio.setConstant(not_known);
    buildings[b].storey_shear.setConstant(not_known);
  }
}

/// Of all buildings.
std::vector<BuildingPeaks> peaks_of(const Problem& problem, const Solution& solution) {
  std::vector<BuildingPeaks> buildings;
  std::size_t coupled = 0;
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Building& building = problem.buildings[b];
    buildings.push_back(peaks_of(building, b, solution));
    for (const CoupledElement& element : building.coupled) {
      take_hinges(building.model.hinges, building.model.storey_heights, *element.law, solution.coupled[coupled++],
                  buildings.back());
    }
  }
  leave_out_what_is_not_there(problem, buildings);
  return buildings;
}

}  // namespace

ColumnPeaks column_peaks(const Eigen::Vector<double, 6>& with, const Eigen::Vector<double, 6>& without) {
  return {.shear = with.head<2>().maxCoeff(),
          .moment = with.tail<4>().maxCoeff(),
          .shear_no_contact = without.head<2>().maxCoeff(),
          .moment_no_contact = without.tail<4>().maxCoeff(),
          .shear_below = with(0),
          .shear_above = with(1),
          .moment_bottom = with(2),
          .moment_node = std::max(with(3), with(4)),
          .moment_top = with(5)};
}

namespace {

/// What the columns bear that are struck, of what their buildings' pieces did.
void summarise_columns(const Problem& problem, const std::vector<BuildingPeaks>& buildings,
                       std::vector<PointSummary>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::optional<StruckColumn> struck = struck_column(problem, problem.points[i]);
    if (!struck) continue;
    const BuildingPeaks& peaks = buildings[struck->building];
    points[i].column = column_peaks(peaks.column_forces.segment<6>(6 * struck->node),
                                    peaks.column_forces_no_contact.segment<6>(6 * struck->node));
  }
}

/// The storey whose limit a run passed, where it did.
std::optional<Collapse> collapse_of(const Problem& problem, const Solution& solution) {
  if (!solution.passed) return std::nullopt;
  Eigen::Index limit = solution.passed->limit;
  for (Eigen::Index b = 0; b < std::ssize(problem.buildings); ++b) {
    const Building& building = problem.buildings[b];
    if (!building.has_gravity_loads) continue;
    const Eigen::Index storeys = building.model.floors() - building.model.first_storey();
    if (limit < storeys) return Collapse{b, building.model.first_storey() + limit, solution.passed->time};
    limit -= storeys;
  }
  return std::nullopt;
}

/// The lists of outputs, `of` the samples or the course.
void take_lists(const Problem& problem, Solution& solution, Eigen::MatrixXd OutputsFound::*of, Histories& to) {
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const auto take = [&](OutputKind kind, std::vector<Eigen::MatrixXd>& list) {
      list.push_back(std::move(of_kind(solution, b, kind).*of));
    };
    if (of == &OutputsFound::history) {
      auto [force, shortening] = infill_histories(infilled_frame(problem.buildings[b]),
                                                  std::move(of_kind(solution, b, OutputKind::infill_force).*of),
                                                  of_kind(solution, b, OutputKind::drift_ratio).*of);
      to.infill_force.push_back(std::move(force));
      to.infill_shortening.push_back(std::move(shortening));
    }
    take(OutputKind::displacement, to.displacement);
    take(OutputKind::drift_ratio, to.drift_ratio);
    take(OutputKind::storey_shear, to.storey_shear);
    take(OutputKind::node, to.node_displacement);
    const Eigen::MatrixXd& moved = of_kind(solution, b, OutputKind::foundation).*of;
    const Eigen::MatrixXd& forces = of_kind(solution, b, OutputKind::foundation_force).*of;
    Eigen::MatrixXd& foundation = to.foundation.emplace_back(moved.rows() + forces.rows(), moved.cols());
    foundation.topRows(moved.rows()) = moved;
    foundation.bottomRows(forces.rows()) = forces;
    take(OutputKind::hinge_moment, to.hinge_moment);
    take(OutputKind::hinge_rotation, to.hinge_rotation);
    take(OutputKind::column_force, to.column_forces);
    if (of == &OutputsFound::course) continue;
    take(OutputKind::velocity, to.velocity);
    take(OutputKind::acceleration, to.acceleration);
  }
}

Histories histories_of(const Problem& problem, Sampled&& sampled, Solution& solution,
                       Eigen::MatrixXd OutputsFound::*of) {
  Histories histories;
  if (sampled.time.empty()) return histories;
  take_lists(problem, solution, of, histories);
  histories.time = std::move(sampled.time);
  if (sampled.ground_acceleration.size() > 0) {
    const auto first = sampled.ground_acceleration.row(0);
    histories.ground_acceleration.assign(first.begin(), first.end());
  }
  histories.opening = std::move(sampled.opening);
  histories.force = std::move(sampled.force);
  histories.link_deformation = std::move(sampled.joint_deformation);
  histories.link_force = std::move(sampled.joint_force);
  return histories;
}

}  // namespace

double ductility(const HystereticLaw& law, double drift, const ElementFound& found) {
  if (!law.yields_unevenly()) return drift / law.yield_deformation();
  return std::max(found.closing.reach / law.yield_deformation(), found.opening.reach / law.yield_deformation_below());
}

void take_hinge_peaks(const Hinges& hinges, const Eigen::VectorXd& moments, const Eigen::VectorXd& rotations,
                      const Eigen::VectorXd& shears, BuildingPeaks& peaks) {
  for (const double moment : moments) peaks.hinges.push_back({.peak_moment = moment});
  for (Eigen::Index h = 0; h < rotations.size(); ++h) peaks.hinges[h].peak_rotation = rotations(h);
  for (const double shear : shears) {
    const double capacity = hinges.columns[peaks.columns.size()].capacity;
    peaks.columns.push_back({.peak_shear = shear, .shear_demand_capacity = shear / capacity});
  }
}

void take_hinges(const Hinges& hinges, const std::vector<double>& storey_heights, const CoupledLaw& of,
                 const CoupledState& state, BuildingPeaks& peaks) {
  const auto* const hinge_law = dynamic_cast<const HingeLaw*>(&of);
  if (hinge_law == nullptr) return;
  const HingeLaw& law = *hinge_law;
  const Eigen::Index floors = std::ssize(storey_heights);
  Eigen::VectorXd theta(law.size());
  for (Eigen::Index h = 0; h < law.size(); ++h) {
    const HingeLaw::Record record = law.record(state, h);
    theta(h) = record.rotation;
    if (const Eigen::Index column = h - std::ssize(peaks.hinges); column >= 0) {
      BuildingPeaks::Breaking& breaking = peaks.columns[column];
      breaking.break_time = record.broke;
      breaking.released_energy = record.released;
      breaking.residual_slip = record.rotation;
      continue;
    }
    BuildingPeaks::Hinge& hinge = peaks.hinges[h];
    // Until it fails it turns farthest at an event; from then on it may at any time.
    hinge.peak_rotation = record.failed ? std::max(hinge.peak_rotation, record.peak_rotation) : record.peak_rotation;
    hinge.residual_rotation = record.rotation;
    hinge.dissipated_energy = record.lost + hinges.at_rest(h) * record.rotation;
    hinge.first_yield = record.first_yield;
    hinge.half_cycles = record.half_cycles;
    if (hinges.backbones.empty() || !hinges.backbones[h].loses_strength()) continue;
    hinge.strength_left = record.strength_left;
    hinge.cap_time = record.cap;
    hinge.failed_time = record.failed;
    hinge.released_energy = record.released;
  }
  const Eigen::Index storeys = hinges.frame_drifts.rows();
  const Eigen::Index first = floors - storeys;  // above a slab
  Eigen::VectorXd& residual = peaks.yielding.residual_drift_ratio;
  residual.setConstant(floors, not_known);
  residual.tail(storeys) = unloaded_drifts(hinges, law, state, theta);
  for (Eigen::Index j = first; j < residual.size(); ++j) residual(j) /= storey_heights[j];
  peaks.mechanism.reset();
  const std::optional<HingeLaw::Mechanism> mechanism = law.mechanism(state);
  if (!mechanism) return;
  const auto shape = free_shape(hinges.frame_stiffness, hinges.frame_rows, hinges.stiffness, mechanism->hinges);
  const Eigen::VectorXd drifts = (hinges.frame_drifts * *shape).cwiseAbs();
  peaks.mechanism = BuildingPeaks::Mechanism{.time = mechanism->time, .storeys = {}};
  for (Eigen::Index j = 0; j < storeys; ++j) {
    if (drifts(j) > still * shape->cwiseAbs().maxCoeff()) peaks.mechanism->storeys.push_back(first + j);
  }
}

LargestDrift largest_drift(const Eigen::VectorXd& ratios) {
  LargestDrift largest;
  for (Eigen::Index storey = 0; storey < ratios.size(); ++storey) {
    if (ratios(storey) > largest.ratio) largest = {ratios(storey), storey};
  }
  return largest;
}

Eigen::VectorXd drift_ratios_with(Eigen::Index storeys, const LargestDrift& largest) {
  return largest.ratio * Eigen::VectorXd::Unit(std::max(storeys, largest.storey + 1), largest.storey);
}

std::vector<std::vector<Eigen::Index>> hinge_order(const BuildingPeaks& peaks, double duration) {
  constexpr double at_once = 1e-9;  // of the duration
  std::vector<std::pair<double, Eigen::Index>> yields;
  for (Eigen::Index h = 0; h < std::ssize(peaks.hinges); ++h) {
    if (peaks.hinges[h].first_yield) yields.emplace_back(*peaks.hinges[h].first_yield, h);
  }
  std::sort(yields.begin(), yields.end());
  std::vector<std::vector<Eigen::Index>> groups;
  double latest = 0;
  for (const auto& [time, hinge] : yields) {
    if (groups.empty() || time - latest > at_once * duration) {
      groups.emplace_back();
      latest = time;
    }
    groups.back().push_back(hinge);
  }
  for (std::vector<Eigen::Index>& group : groups) std::sort(group.begin(), group.end());
  return groups;
}

void summarise(const std::vector<Impact>& impacts, std::vector<PointSummary>& points) {
  for (const Impact& impact : impacts) {
    PointSummary& point = points[impact.point];
    ++(impact.settling ? point.settling : point.impacts);
    if (impact.slow_start) ++point.slow_starts;
    point.contact_duration += impact.end - impact.start;
    point.impulse += impact.impulse;
    point.energy_lost += impact.energy_lost;
    point.peak_penetration = std::max(point.peak_penetration, impact.peak_penetration);
    point.peak_closing_speed = std::max(point.peak_closing_speed, impact.closing_speed);
    point.peak_tension = std::max(point.peak_tension, impact.peak_tension);
    if (impact.peak_force > point.peak_force) {
      point.peak_force = impact.peak_force;
      point.peak_force_time = impact.peak_force_time;
    }
  }
}

void summarise(const Solution& solution, const std::vector<double>& widths, std::vector<WatchedSummary>& watched) {
  for (std::size_t i = 0; i < watched.size(); ++i) {
    watched[i].least_opening = widths[i] - solution.watched[i].reach;
    watched[i].least_time = solution.watched[i].time;
    watched[i].closes = watched[i].least_opening < -round_off_watched * (widths[i] + solution.scales[i]);
  }
}

void take_end(const Solution& solution, RunOutcome& outcome) {
  outcome.status = solution.status;
  outcome.message = solution.message;
  outcome.steps = solution.steps;
  outcome.links.clear();
  for (const ElementFound& joint : solution.joints) {
    outcome.links.push_back(
        {joint.peak_force, joint.peak_tension, joint.closing.reach, joint.opening.reach, joint.energy_lost});
  }
}

BuildingPeaks::Infill infill_of(const InfilledFrame& frame, const std::vector<const ElementFound*>& panels,
                                const Eigen::VectorXd& across, const Eigen::VectorXd& on_columns,
                                const Eigen::VectorXd& drift_ratios) {
  BuildingPeaks::Infill infill;
  if (frame.panels.empty()) return infill;
  const auto floors = static_cast<Eigen::Index>(frame.storey_heights.size());
  for (auto* list :
       {&infill.force, &infill.shear, &infill.ductility, &infill.strength_left, &infill.energy, &infill.failed_time}) {
    list->setConstant(floors, not_known);
  }
  for (std::size_t n = 0; n < frame.panels.size(); ++n) {
    const InfillPanel& panel = frame.panels[n];
    const Eigen::Index f = frame.first_storey + panel.storey;
    infill.force(f) = std::fmax(infill.force(f), across(static_cast<Eigen::Index>(n)) / panel.cosine);
    infill.shear(f) = std::fmax(infill.shear(f), across(static_cast<Eigen::Index>(n)));
    if (std::isfinite(panel.backbone.yield)) {
      const double drift = drift_ratios(f) * frame.storey_heights[f];
      infill.ductility(f) = std::fmax(infill.ductility(f), drift * panel.stiffness / panel.backbone.yield);
    }
    infill.strength_left(f) = std::fmin(infill.strength_left(f), 1.0);
    infill.energy(f) = std::fmax(infill.energy(f), 0.0);
  }
  const std::vector<StrutOnColumn> pushes = struts_on_columns(frame.panels, frame.hinges);
  if (!pushes.empty()) infill.column_demand.setConstant(floors, not_known);
  for (std::size_t n = 0; n < pushes.size(); ++n) {
    double& most = infill.column_demand(frame.first_storey + frame.panels[pushes[n].panel].storey);
    most = std::fmax(most, on_columns(static_cast<Eigen::Index>(n)) / frame.hinges.columns[pushes[n].column].capacity);
  }
  for (std::size_t n = 0; n < panels.size(); ++n) {
    if (panels[n] == nullptr) continue;
    const Eigen::Index f = frame.first_storey + frame.panels[n].storey;
    infill.energy(f) += panels[n]->energy_lost;
    const auto& loss = panels[n]->loss;
    if (!loss) continue;
    infill.strength_left(f) = std::fmin(infill.strength_left(f), loss->left);
    if (loss->failed) infill.failed_time(f) = std::fmin(infill.failed_time(f), *loss->failed);
  }
  return infill;
}

InfillHistories infill_histories(const InfilledFrame& frame, Eigen::MatrixXd across,
                                 const Eigen::MatrixXd& drift_ratios) {
  InfillHistories histories{std::move(across), {}};
  histories.shortening.resize(histories.force.rows(), histories.force.cols());
  for (std::size_t n = 0; n < frame.panels.size() && histories.force.size() > 0; ++n) {
    const InfillPanel& panel = frame.panels[n];
    const auto row = static_cast<Eigen::Index>(n), f = frame.first_storey + panel.storey;
    histories.force.row(row) /= panel.cosine;
    histories.shortening.row(row) = panel.cosine * frame.storey_heights[f] * drift_ratios.row(f);
  }
  return histories;
}

void take_loss(const StrengthLoss& loss, Eigen::Index storeys, Eigen::Index storey, BuildingPeaks::Yielding& yielding) {
  for (auto* list : {&yielding.strength_left, &yielding.capped_time, &yielding.residual_time, &yielding.failed_time}) {
    if (list->size() == 0) list->setConstant(storeys, not_known);
  }
  yielding.strength_left(storey) = loss.left;
  yielding.capped_time(storey) = loss.capped.value_or(not_known);
  yielding.residual_time(storey) = loss.residual.value_or(not_known);
  yielding.failed_time(storey) = loss.failed.value_or(not_known);
}

Response free_response(const Problem& problem, const Solution& free) {
  Response response;
  take_end(free, response);
  response.collapse = response.collapse_no_contact = collapse_of(problem, free);
  response.buildings = peaks_of(problem, free);
  for (BuildingPeaks& peaks : response.buildings) {
    peaks.displacement_no_contact = peaks.displacement;
    peaks.column_forces_no_contact = peaks.column_forces;
    peaks.yielding_no_contact = peaks.yielding;
    peaks.acceleration_no_contact = peaks.acceleration;
    peaks.drift_ratio_no_contact = peaks.drift_ratio;
    peaks.storey_shear_no_contact = peaks.storey_shear;
  }
  for (const double needed : free.needed) response.points.push_back({.gap_needed = needed});
  for (const Reach& reach : free.watched) response.watched.push_back({.gap_needed = reach.reach});
  summarise_columns(problem, response.buildings, response.points);
  response.coupled = free.coupled;
  return response;
}

void take_levels(const Problem& problem, const Solution& free, bool reversed, Response& response) {
  const auto peak_of = [&](std::size_t level, int side) -> std::optional<double> {
    const std::optional<Eigen::Index> floor = face_floor(problem, level, side);
    if (!floor) return std::nullopt;
    const std::size_t points = problem.points.size();
    const Eigen::Index left = level < points ? problem.points[level].left : problem.watched[level - points].left;
    return response.buildings[left + side].displacement_no_contact(*floor);
  };
  report_levels(free.watched_free, reversed, peak_of, response.points, response.watched);
}

std::vector<LargestDrift> drifts_no_contact(const Response& response) {
  std::vector<LargestDrift> drifts;
  for (const BuildingPeaks& one : response.buildings) drifts.push_back(largest_drift(one.drift_ratio_no_contact));
  return drifts;
}

void take_solution(const Problem& problem, Solution&& solution, Response& response) {
  take_end(solution, response);
  response.events = solution.events;
  response.collapse = collapse_of(problem, solution);
  std::vector<BuildingPeaks> buildings = peaks_of(problem, solution);
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    BuildingPeaks& free = response.buildings[b];
    buildings[b].displacement_no_contact = std::move(free.displacement_no_contact);
    buildings[b].column_forces_no_contact = std::move(free.column_forces_no_contact);
    buildings[b].yielding_no_contact = std::move(free.yielding_no_contact);
    buildings[b].acceleration_no_contact = std::move(free.acceleration_no_contact);
    buildings[b].drift_ratio_no_contact = std::move(free.drift_ratio_no_contact);
    buildings[b].storey_shear_no_contact = std::move(free.storey_shear_no_contact);
  }
  response.buildings = std::move(buildings);
  response.coupled = std::move(solution.coupled);
  response.impacts = std::move(solution.impacts);
  summarise(response.impacts, response.points);
  summarise_columns(problem, response.buildings, response.points);
  std::vector<double> widths;
  for (const WatchedFloor& floor : problem.watched) widths.push_back(floor.width);
  summarise(solution, widths, response.watched);
  response.histories = histories_of(problem, std::move(solution.samples), solution, &OutputsFound::history);
  response.course = histories_of(problem, std::move(solution.course), solution, &OutputsFound::course);
  response.energy = std::move(solution.energy);
}

}  // namespace bentur
