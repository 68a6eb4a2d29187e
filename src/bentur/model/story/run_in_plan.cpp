#include <algorithm>
#include <numeric>
#include <utility>

#include "bentur/model/plan/plan_pairs.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/plan/plan_screening.h"
#include "bentur/model/story/internal/run_parts.h"
#include "bentur/model/story/internal/small_movements.h"

// What the story of a run asks of buildings in plan.
namespace bentur::story {
namespace {

using Eigen::Index;

/// The word for the corner of a footprint that a place is at; nullptr where it is none.
const char* corner_word(const Footprint& footprint, const PlanPoint& at) {
  const auto side = [&](int i) {
    return at[i] == footprint.corner[i] ? 0 : at[i] == footprint.far_corner()[i] ? 1 : -1;
  };
  if (!footprint.polygon.empty()) return nullptr;
  constexpr const char* words[2][2] = {{"story.corner.lower_left", "story.corner.upper_left"},
                                       {"story.corner.lower_right", "story.corner.upper_right"}};
  return side(0) < 0 || side(1) < 0 ? nullptr : words[side(0)][side(1)];
}

/// The floor that contact turns the most of those that do not turn alone; with the value 0 none.
LargestOfFloors turned_by_contact(const PlanRun& run) {
  constexpr double round_off = 1e-9;
  LargestOfFloors most{.value = 0};
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const PlanPeaks &in_contact = run.response.buildings[b], &alone = run.response.buildings_no_contact[b];
    const double unseen = round_off / run.problem.buildings[b].model.footprint.size.maxCoeff();
    for (const QuantityPlace& at : floors_of(run.problem, b)) {
      const double still = unseen * std::max(in_contact.x(at.floor), in_contact.y(at.floor));
      const double turns = in_contact.rotation(at.floor);
      if (alone.rotation(at.floor) <= still && turns > std::max(still, most.value)) most = {turns, at, {}};
    }
  }
  return most;
}

}  // namespace

std::vector<std::vector<ScreeningFinding>> screened(const Case& c, const PlanProblem& problem) {
  std::vector<std::vector<ScreeningFinding>> all;
  for (std::size_t gap = 0; gap < problem.gaps.size(); ++gap) all.push_back(plan_screening(c, problem, gap));
  return all;
}

GapView judged_view_of(const PlanRun& run) {
  const std::shared_ptr<const RunResults> row = row_of(run);
  GapView view = view_of(*row);
  view.plan = &run.problem;
  view.screened = screened(run.c, run.problem);
  view.masses = mass_choices(run.problem);
  for (const BuildingSpec& building : run.c.buildings) {
    const auto* const plan = std::get_if<Plan>(&building.structure);
    view.mass_parts.push_back(plan != nullptr ? plan->eccentricity_both_ways : 0);
  }
  view.gaps = judged_gaps(run);
  view.row = row;
  return view;
}

void add_place(const PlanProblem& problem, const PlanGap& gap, bool is_point, Index index, const std::string& length,
               std::vector<StoryValue>& values) {
  const StretchCorner place = is_point ? gap.at(gap.contacts[index]) : gap.at(gap.watched[index]);
  const double elevation = is_point ? gap.contacts[index].elevation : gap.watched[index].elevation;
  const char* corner = nullptr;
  for (const int side : {0, 1}) {
    const PlanBuilding& building = problem.buildings[side == 0 ? gap.left : gap.right];
    if (corner != nullptr) break;
    corner = corner_word(building.model.footprint, side == 0 ? place.left : place.right);
    if (corner == nullptr) continue;
    values.push_back(text_of("corner_of", building.name));
    values.push_back(word_of("corner", corner));
  }
  const PlanPoint at = 0.5 * (place.left + place.right);
  values.push_back(value_in("elevation", elevation, length));
  values.push_back(value_in("x", at.x(), length));
  values.push_back(value_in("y", at.y(), length));
  values.push_back(word_of("level", corner != nullptr ? "story.place_at_corner" : "story.place"));
}

bool has_bearings_by_axes(const PlanProblem& problem) {
  return std::any_of(problem.buildings.begin(), problem.buildings.end(), [](const PlanBuilding& one) {
    const auto& bearings = one.model.bearings;
    return std::any_of(bearings.begin(), bearings.end(), [](const auto& bearing) { return bearing.elements() > 0; });
  });
}

bool some_building_yields(const PlanProblem& problem, const PlanResponse& response) {
  for (const PlanBuilding& building : problem.buildings) {
    for (const PlanModel::Plane& plane : building.model.planes) {
      const auto is_law = [](const auto& law) { return law != nullptr; };
      if (plane.hinges.size() > 0 || std::any_of(plane.laws.begin(), plane.laws.end(), is_law)) return true;
    }
  }
  return std::any_of(response.buildings.begin(), response.buildings.end(), [](const PlanPeaks& peaks) {
    const auto yields = [](const PlanPeaks::Plane& plane) { return plane.yielding.ductility.size() > 0; };
    return std::any_of(peaks.planes.begin(), peaks.planes.end(), yields);  // of results read back
  });
}

std::vector<Index> points_from_top(const PlanProblem& problem, std::size_t gap) {
  const std::vector<PlanContact>& contacts = problem.gaps[gap].contacts;
  std::vector<Index> points(contacts.size());
  const Index first = first_contact(problem, gap);
  std::iota(points.begin(), points.end(), first);
  std::stable_sort(points.begin(), points.end(),
                   [&](Index a, Index b) { return contacts[a - first].elevation > contacts[b - first].elevation; });
  return points;
}

void tell_columns(const PlanRun& run, std::vector<Statement>& statements) { tell_columns(*row_of(run), statements); }

void put_place(const PlanRun& run, std::size_t gap, Index point, long points, Statement& statement) {
  const PlanGap& of = run.problem.gaps[gap];
  const Index place = point - first_contact(run.problem, gap);
  statement.level = of.contacts[place].elevation;
  statement = with(std::move(statement), count_of("n", points), word_of("points", "story.count.contact_points.many"));
  add_place(run.problem, of, true, place, run.c.units.length, statement.values);
}

void tell_pairs_without_contact(const PlanRun& run, std::vector<Statement>& statements) {
  const std::string& length = run.c.units.length;
  const auto name = [&](Index b) -> const std::string& { return run.problem.buildings[b].name; };
  for (const PairWithoutContact& pair : pairs_without_contact(run)) {
    statements.push_back({.kind = "pair_without_contact",
                          .severity = Severity::danger,
                          .buildings = {pair.first, pair.second},
                          .values = {text_of("left", name(pair.first)), text_of("right", name(pair.second)),
                                     value_in("width", pair.width, length), value_in("reach", pair.reach, length)}});
  }
}

void tell_slips(const PlanRun& run, std::vector<Statement>& statements) {
  const ShownUnits shown = shown_units(run);
  const std::vector<Impact>& all = run.response.impacts;
  if (std::none_of(all.begin(), all.end(), [](const Impact& one) { return one.slipped; })) return;
  for (std::size_t g = 0; g < run.problem.gaps.size(); ++g) {
    const Index first = first_contact(run.problem, g), end = first + std::ssize(run.problem.gaps[g].contacts);
    const Impact *earliest = nullptr, *most = nullptr;
    long slips = 0;
    for (const Impact& one : all) {
      if (!one.slipped || one.point < first || one.point >= end) continue;
      ++slips;
      if (earliest == nullptr || one.end < earliest->end) earliest = &one;
      if (most == nullptr || one.energy_lost > most->energy_lost) most = &one;
    }
    if (slips == 0) continue;
    const auto [left, right] = std::minmax(run.problem.gaps[g].left, run.problem.gaps[g].right);
    const std::string energy = unit_text("F L", shown.units);
    Statement statement{.kind = "slips",
                        .gap = static_cast<Index>(g),
                        .buildings = {left, right},
                        .level = contact_at(run.problem, most->point).contact->elevation,
                        .values = {text_of("left", run.problem.buildings[left].name),
                                   text_of("right", run.problem.buildings[right].name), count_of("times", slips),
                                   value_in("time", earliest->end, "s"),
                                   value_in("energy", shown.factor("F L") * most->energy_lost, energy)}};
    add_place(run.problem, run.problem.gaps[g], true, most->point - first, run.c.units.length, statement.values);
    statements.push_back(std::move(statement));
  }
}

namespace {

/// That needs are of masses elsewhere too, and of which buildings by how much.
void tell_masses_elsewhere(const PlanRun& run, std::vector<Statement>& statements) {
  Statement statement{.kind = "masses_elsewhere", .severity = Severity::remark};
  for (std::size_t b = 0; b < run.c.buildings.size(); ++b) {
    const auto* const plan = std::get_if<Plan>(&run.c.buildings[b].structure);
    if (plan == nullptr || plan->eccentricity_both_ways == 0) continue;
    statement.buildings.push_back(static_cast<Index>(b));
    statement.items.push_back(
        {text_of("building", run.c.buildings[b].name), value_in("part", percent * plan->eccentricity_both_ways, "%")});
  }
  if (!statement.items.empty()) statements.push_back(std::move(statement));
}

}  // namespace

bool tell_turning(const PlanRun& run, std::vector<Statement>& statements) {
  constexpr double more = 1 + 1e-9;
  const LargestOfFloors turns = largest_of_floors(run, "amplification_rotation");
  const auto milliradians = [&](const char* key) {
    return 1e3 * value_of(quantity_named(key, Owner::floor, true), run, turns.at);
  };
  if (turns.value > more) {
    statements.push_back(with(of_floor(run, turns, "turned"), value_in("factor", turns.value),
                              value_in("with", milliradians("peak_rotation"), "mrad"),
                              value_in("without", milliradians("peak_rotation_no_contact"), "mrad")));
  }
  const LargestOfFloors starts = turned_by_contact(run);
  if (starts.value > 0) {
    statements.push_back(
        with(of_floor(run, starts, "turned_by_contact"), value_in("with", 1e3 * starts.value, "mrad")));
  }
  return turns.value > more || starts.value > 0;
}

void tell_left_out(const PlanRun& run, std::vector<Statement>& statements) {
  tell_masses_elsewhere(run, statements);
  tell_rotations(run, statements);
  tell_ends_of_edges(run, statements);
}

double ductility_of_bearings(const PlanRun& run, Index b) {
  const PlanPeaks::Bearings& peaks = run.response.buildings[b].bearings;
  double ductility = 0;
  for (Index n = 0; n < peaks.x.size(); ++n) {
    const HystereticLaw* const law = run.problem.buildings[b].model.bearings[n].law.get();
    if (law == nullptr) continue;
    ductility = std::max(ductility, std::max(peaks.x(n), peaks.y(n)) / law->yield_deformation());
  }
  return ductility;
}

std::vector<Storeys> storeys_of(const PlanProblem& problem, const PlanResponse& response, Index b) {
  static const BuildingPeaks none;
  const PlanPeaks &with = response.buildings[b], &alone = response.buildings_no_contact[b];
  const std::string& name = problem.buildings[b].name;
  std::vector<Storeys> all;
  for (std::size_t p = 0; p < with.planes.size(); ++p) {
    const PlanPeaks::Plane &one = with.planes[p], &other = alone.planes[p];
    all.push_back({name + ", " + problem.buildings[b].model.planes[p].name, one.drift_ratio, other.drift_ratio,
                   &one.yielding, &other.yielding, &one.frame});
  }
  const Index lowest = problem.buildings[b].model.first_storey();
  const auto shear = [&](const PlanPeaks& peaks) {
    double most = 0;
    for (const Eigen::VectorXd* const one : {&peaks.shear_x, &peaks.shear_y}) {
      if (lowest < one->size()) most = std::max(most, (*one)(lowest));
    }
    return most;
  };
  all.push_back({name, with.edge_drift_ratio(), alone.edge_drift_ratio(), &none.yielding, &none.yielding_no_contact,
                 &none, shear(with), shear(alone)});
  return all;
}

}  // namespace bentur::story
