#include "bentur/model/story/remarks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "bentur/model/plan/plan_places.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/story/internal/remark_checks.h"
#include "bentur/model/story/internal/storeys.h"
#include "bentur/model/suite/suite.h"

// What is unusual of a case and a run of it, of a row as in plan: what only one of both has stands in a function of its
// own for each.
namespace bentur {
namespace {

using Eigen::Index;
using namespace remarking;

template <class AnyProblem>
void check_buildings(const Case& c, const AnyProblem& problem, List& list) {
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const auto& building = problem.buildings[b];
    if (building.is_rigid()) continue;
    const auto& model = building.model;
    const double omega = building.first_omega();
    if (omega > 0 && !model.slab) {  // which is there to change both
      const auto storeys = static_cast<double>(model.floors() - model.first_storey());
      list.check("period_per_storey", building.name, 2 * std::numbers::pi / omega / storeys);
      list.check("damping", building.name, building.modal_damping(0, 0) / (2 * omega));
    }
    if constexpr (requires { model.stiffness_factor; }) {
      if (model.stiffness_factor) list.check("stiffness_factor", building.name, *model.stiffness_factor);
    }
    for (const double mass : model.floor_masses) list.check("storey_weight", building.name, mass * c.units.gravity);
    // Of results read back no more is known.
    if (b < c.buildings.size()) check_given(c.buildings[b], model.storey_heights, model.floor_masses, list);
  }
}

/// Damping of the modes that take a blow at a column that is struck: by the squares of their shapes there. Modes of its
/// node are fast, so that damping which grows with frequency all but holds it.
void check_blows(const Problem& problem, List& list) {
  for (const ContactPoint& point : problem.points) {
    const auto struck = struck_column(problem, point);
    if (!struck) continue;
    const Building& building = problem.buildings[struck->building];
    const Eigen::VectorXd shape = building.modes.shapes.row(building.model.floors() + struck->node);
    for (Eigen::Index mode = 0; mode < shape.size(); ++mode) {
      const double omega = building.modes.omega(mode);
      constexpr double least_share = 0.1;  // of the energy of a blow, that makes a mode matter
      if (shape(mode) * shape(mode) < least_share * shape.squaredNorm() || !(omega > 0)) continue;
      list.check("impact_damping", building.name, building.modal_damping(mode, mode) / (2 * omega));
    }
  }
}

/// Floors that can be struck, of buildings that move in few modes.
void check_modes(const Case& c, const Problem& problem, List& list) {
  for (const ContactPoint& point : problem.points) {
    for (const auto& [b, floor] :
         {std::pair(point.left, point.left_floor), std::pair(point.right, point.right_floor)}) {
      if (b >= std::ssize(c.buildings) || !std::holds_alternative<ModalBuilding>(c.buildings[b].structure)) continue;
      const Building& building = problem.buildings[b];
      // M φ is m_i φ_i, since M is diagonal.
      list.check("modal_mass", building.name,
                 building.model.mass(floor, floor) * building.modes.shapes.row(floor).squaredNorm());
    }
  }
}

/// The same of places in plan: what all modes would make of a blow there, over what those do that are given.
void check_modes(const PlanProblem& problem, List& list) {
  const bool any = std::any_of(problem.buildings.begin(), problem.buildings.end(),
                               [](const PlanBuilding& one) { return one.model.known.has_value(); });
  if (!any) return;
  const System system = system_of(problem);
  for (const Interface* const at : contact_interfaces(problem, system)) {
    for (const BodyRow* const side : {&at->left, &at->right}) {
      const PlanBuilding& building = problem.buildings[side->body];
      if (!building.model.known) continue;
      const double all = side->row.cwiseAbs2().cwiseQuotient(building.model.mass.diagonal()).sum();
      list.check("modal_mass", building.name, (building.modes.shapes.transpose() * side->row).squaredNorm() / all);
    }
  }
}

/// How far each contact point of a joint overlaps at the start [length]; empty where no building starts displaced.
std::vector<double> overlaps(const Problem& problem) {
  std::vector<double> found;
  const auto& start = problem.initial_displacement;
  if (start.empty()) return found;
  for (const ContactPoint& point : problem.points) {
    found.push_back(start[point.left](point.left_floor) - start[point.right](point.right_floor) - point.width);
  }
  return found;
}

std::vector<double> overlaps(const PlanProblem& problem) {
  std::vector<double> found;
  if (problem.initial_displacement.empty()) return found;
  const System system = system_of(problem);
  const std::vector<const Interface*> contacts = contact_interfaces(problem, system);
  const auto of = [&](const BodyRow& row) { return row.row.dot(problem.initial_displacement[row.body]); };
  std::size_t i = 0;
  for (const PlanGap& gap : problem.gaps) {
    for (const Index n : contacts_in_row(gap)) {
      const Interface& at = *contacts[i + static_cast<std::size_t>(n)];
      found.push_back(of(at.left) + of(at.right) - gap.width_at(gap.contacts[n]));
    }
    i += gap.contacts.size();
  }
  return found;
}

/// How far the floors of a contact lie apart in height, and how deep the upper one's beam is, within which they meet
/// [length]; nothing where a column is struck. @param metre 1 m in the case's unit
std::optional<std::pair<double, double>> apart_and_depth(const Case& c, const Problem& row, const ContactPoint& point,
                                                         double metre) {
  const StructuralModel &left = row.buildings[point.left].model, &right = row.buildings[point.right].model;
  if (point.left_floor >= left.floors() || point.right_floor >= right.floors()) return std::nullopt;
  const double above = left.elevations[point.left_floor] - right.elevations[point.right_floor];
  const auto depth = above > 0 ? beam_depth(c, point.left, point.left_floor - left.first_storey())
                               : beam_depth(c, point.right, point.right_floor - right.first_storey());
  return std::pair(std::abs(above), depth.value_or(0.6 * metre));
}

/// The width of a gap at some level. Both buildings fall before they close one of a twentieth of their height: it is in
/// doubt, as one of 5 cm is where it stands in metres.
/// @param at anything in that gap, a contact or a watched floor
void check_width(const Case& c, const Problem& row, const auto& at, List& list) {
  static const RemarkKind& kind = remark_kind("gap_width");
  const double width = at.width - at.beyond, metre = 1 / list.si("L");
  if (!(width > kind.most * metre)) return;  // of many floors most, whose gap needs no name
  const bool is_spanned = std::any_of(c.links.begin(), c.links.end(), [&](const LinkSpec& link) {
    const auto a = static_cast<Index>(link.left), b = static_cast<Index>(link.right);
    return std::min(a, b) == std::min(at.left, at.right) && std::max(a, b) == std::max(at.left, at.right);
  });
  if (is_spanned) return;  // a bridge may be as long as it likes
  constexpr double several = 3, of_height = 0.05;
  const std::string name = gap_name(row, at.gap);
  const double usual = kind.usual_to * metre;
  double height = std::numeric_limits<double>::infinity();
  for (const Index b : {at.left, at.right}) height = std::min(height, row.buildings[b].model.elevations.back());
  if (width > several * usual && width > of_height * height) {
    list.add(kind.key, name, width, std::nullopt, usual);
  } else {
    list.check(kind, name, width);
  }
}

/// Level after level of every gap, with all contacts of its joint together. @param row the problem, of buildings in
/// plan row_of() it @param overlaps overlaps()
void check_levels(const Case& c, const Problem& row, const std::vector<double>& overlaps, List& list) {
  const double metre = 1 / list.si("L");
  for (std::size_t i = 0; i < row.points.size();) {
    const ContactPoint& first = row.points[i];
    const std::string name = gap_name(row, first.gap);
    const std::string law = first.gap < std::ssize(c.gaps) ? c.gaps[first.gap].contact.law : "";
    // Floors meet though the beam of the upper one ends above the lower one.
    if (const auto floors = apart_and_depth(c, row, first, metre))
      list.check("level_tolerance", name, floors->first, floors->second, floors->second);
    double overlap = 0, stiffness = 0;  // that at the start; 0: no law has one that is constant
    for (; i < row.points.size() && row.points[i].gap == first.gap && row.points[i].elevation == first.elevation; ++i) {
      // Beside the joint other walls have a contact of their own.
      if (!row.points[i].beside) stiffness += stiffness_of(law, row.points[i].law->parameters()).value_or(0);
      if (!overlaps.empty()) overlap = std::max(overlap, overlaps[i]);
    }
    const double width = first.width - first.beyond;
    list.check("initial_overlap", name, overlap);
    check_width(c, row, first, list);
    if (!(stiffness > 0)) continue;
    list.check("contact_stiffness", name, stiffness);
    if (width > 0) continue;
    double shorter = std::numeric_limits<double>::infinity(), compliance = 0;  // first periods; 1/m of what moves
    for (const auto& [b, at] : {std::pair(first.left, first.left_floor), std::pair(first.right, first.right_floor)}) {
      const StructuralModel& model = row.buildings[b].model;
      const Index floors = model.floors();
      if (!(row.buildings[b].first_omega() > 0)) continue;
      shorter = std::min(shorter, 2 * std::numbers::pi / row.buildings[b].first_omega());
      compliance += 1 / (at < floors ? model.floor_masses[at] : model.node_masses[at - floors]);
    }
    // Buildings that touch at rest through something soft.
    if (compliance > 0)
      list.check("soft_contact", name, std::numbers::pi / std::sqrt(stiffness * compliance) / shorter);
  }
  for (const WatchedFloor& floor : row.watched) check_width(c, row, floor, list);
}

/// Floors that are said to be aligned and face columns, or meet though they lie further apart than a beam is deep.
/// @param row as of check_levels()
void check_alignment(const Case& c, const Problem& row, List& list) {
  std::vector<double> facing(static_cast<std::size_t>(gap_count(row)), 0);
  for (std::size_t i = 0; i < row.points.size(); ++i) {
    const ContactPoint& point = row.points[i];
    const bool is_first =
        i == 0 || row.points[i - 1].gap != point.gap || row.points[i - 1].elevation != point.elevation;
    const auto floors = is_first ? apart_and_depth(c, row, point, 1 / list.si("L")) : std::nullopt;
    if (floors && floors->first > floors->second) ++facing[static_cast<std::size_t>(point.gap)];
  }
  for (const WatchedFloor& floor : row.watched) {
    if (!floor.facing_floor && !floor.beside) ++facing[static_cast<std::size_t>(floor.gap)];
  }
  for (std::size_t gap = 0; gap < facing.size() && !c.code.rules.empty(); ++gap) {
    if (facing[gap] == 0 || !c.code.is_aligned(gap)) continue;
    list.add("floors_aligned", gap_name(row, static_cast<Index>(gap)), facing[gap], std::nullopt, 0.0);
  }
}

void check_gaps(const Case& c, const Problem& problem, List& list) {
  check_alignment(c, problem, list);
  check_modes(c, problem, list);
  check_blows(problem, list);
  check_levels(c, problem, overlaps(problem), list);
}

void check_gaps(const Case& c, const PlanProblem& problem, List& list) {
  check_modes(problem, list);
  const Problem row = row_of(problem);
  check_alignment(c, row, list);
  check_levels(c, row, overlaps(problem), list);
  for (const PlanGap& gap : problem.gaps) {
    list.check("merged_corners", gap_name(problem, gap), static_cast<double>(merged_corners(problem, gap).size()));
  }
}

std::vector<const GroundMotion*> motions_of(const Problem& problem) { return {&problem.motion}; }
std::vector<const GroundMotion*> motions_of(const PlanProblem& problem) {
  return {&problem.motions[0], &problem.motions[1]};
}

template <class AnyProblem>
void check_motions(const Case& c, const AnyProblem& problem, List& list) {
  const std::vector<const GroundMotion*> motions = motions_of(problem);
  const auto moving = std::count_if(motions.begin(), motions.end(), [](const GroundMotion* motion) {
    return !std::holds_alternative<NoMotion>(*motion);
  });
  constexpr const char* axes[] = {"x", "y"};
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const char* const subject = moving > 1 ? axes[i] : "";
    const ExcitationSpec& excitation = *c.excitations()[i];
    if (excitation.record) check_record(*excitation.record, subject, list);
    check_motion(*motions[i], excitation, subject, problem.duration, list);
  }
  if (const auto& spectrum = c.excitation.spectrum; spectrum && !spectrum->of_displacements)
    list.check("spectrum", "", largest_ordinate(spectrum->spectrum) / list.units().gravity);
  if (!c.excitation.suite) return;
  for (const SuiteRecord& record : c.excitation.suite->records) {
    check_record(record.echo, record.echo.file, list);
    if (record.along_y) check_record(record.along_y->echo, record.along_y->echo.file, list);
  }
}

template <class AnyProblem>
void check_before(const Case& c, const AnyProblem& problem, List& list) {
  list.check("gravity", "", c.units.gravity * list.si("L"));
  check_buildings(c, problem, list);
  check_strengths(c, problem, list);
  check_gaps(c, problem, list);
  check_motions(c, problem, list);
  double shortest = problem.duration;
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const auto& building = problem.buildings[b];
    if (building.first_omega() > 0) shortest = std::min(shortest, 2 * std::numbers::pi / building.first_omega());
    if (b >= problem.delays.size() || problem.delays[b] < problem.duration) continue;
    list.add("delay", building.name, problem.delays[b], std::nullopt, problem.duration);
  }
  if (!c.excitation.spectrum) check_codes(c.code, list);
  list.check("output_step", "", c.analysis.output_step, shortest / 4, shortest / 20);  // fewer samples draw no curve
}

/// The largest ductility of storeys from `first` on: of none that yields 0.
double largest_ductility(const Eigen::VectorXd& of_storeys, Index first) {
  double largest = 0;
  for (Index j = first; j < of_storeys.size(); ++j) {
    if (of_storeys(j) > largest) largest = of_storeys(j);  // NaN: that storey cannot yield
  }
  return largest;
}

template <class AnyProblem, class AnyResponse>
void check_response(const AnyProblem& problem, const AnyResponse& response, std::size_t b, List& list) {
  const auto& building = problem.buildings[b];
  if (!(building.first_omega() > 0)) return;  // it moves with the ground, or freely
  bool yields = false;
  double drift = 0, drift_alone = 0, shear = 0, shear_alone = 0, ductility = 0;
  std::ptrdiff_t broken = 0;
  for (const story::Storeys& all : story::storeys_of(problem, response, static_cast<Index>(b))) {
    drift = std::max(drift, largest_drift(all.drift).ratio);
    drift_alone = std::max(drift_alone, largest_drift(all.drift_alone).ratio);
    shear = std::max(shear, all.base_shear);
    shear_alone = std::max(shear_alone, all.base_shear_alone);
    yields = yields || all.yielding->ductility.size() > 0 || !all.frame->hinges.empty() || !all.frame->columns.empty();
    for (const BuildingPeaks::Yielding* const run : {all.yielding, all.yielding_alone}) {
      ductility = std::max(ductility, largest_ductility(run->ductility, building.model.first_storey()));
    }
    broken += std::count_if(all.frame->columns.begin(), all.frame->columns.end(),
                            [](const BuildingPeaks::Breaking& column) { return column.break_time.has_value(); });
  }
  list.check("broken_columns", building.name, static_cast<double>(broken));
  if (yields) {
    list.check("ductility", building.name, ductility);
    list.check("drift_yielding", building.name, std::max(drift, drift_alone) / 0.01);
    return;
  }
  // Both say what the linear elastic model overlooks.
  const auto larger = [&](const char* key, double with, const char* key_alone, double alone, double unit) {
    constexpr double round_off = 1e-9;  // where nothing touches it both are one
    list.check(alone > (1 + round_off) * with ? key_alone : key, building.name, std::max(with, alone) / unit);
  };
  larger("drift", drift, "drift_alone", drift_alone, 0.01);
  const auto& masses = building.model.floor_masses;
  const double weight = list.units().gravity * std::accumulate(masses.begin(), masses.end(), 0.0);
  if (weight > 0) larger("base_shear", shear, "base_shear_alone", shear_alone, weight);
}

template <class AnyProblem, class AnyResponse>
std::vector<Remark> remarks_of(const Case& c, const AnyProblem& problem, const AnyResponse* response) {
  List list(c.units);
  check_before(c, problem, list);
  if (response == nullptr) return list.take();
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) check_response(problem, *response, b, list);
  const std::vector<std::string> names = gap_names(problem);
  for (std::size_t gap = 0; gap < names.size(); ++gap) {
    double slow_starts = 0;
    for (const Index i : story::points_from_top(problem, gap)) {
      list.check("penetration", names[gap], response->points[i].peak_penetration);
      slow_starts += static_cast<double>(response->points[i].slow_starts);
    }
    list.check("slow_starts", names[gap], slow_starts);
  }
  for (const Discrepancy& one : response->discrepancies) list.add(one.key, "", one.size, std::nullopt, 1e-9, false);
  return list.take();
}

}  // namespace

std::vector<Remark> remarks(const Case& c, const Problem& problem, const Response* response) {
  return remarks_of(c, problem, response);
}
std::vector<Remark> remarks(const Case& c, const PlanProblem& problem, const PlanResponse* response) {
  return remarks_of(c, problem, response);
}

std::vector<Remark> remarks(const RecordEcho& record, const Units& units) {
  List list(units);
  check_record(record, "", list);
  list.check(record.pga == 0 ? "motion_of_zeros" : "pga", "", record.pga / units.gravity);
  return list.take();
}

}  // namespace bentur
