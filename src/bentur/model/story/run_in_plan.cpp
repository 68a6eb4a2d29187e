#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "bentur/model/plan/plan_frames.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/plan/plan_screening.h"
#include "bentur/model/story/internal/run_parts.h"
#include "bentur/model/story/internal/small_movements.h"
#include "bentur/pounding/plan/outline/near.h"

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

/// Whether two buildings could meet by how far both move: along every direction in which they are apart.
bool could_meet(const PlanRun& run, Index left, Index right, const Stretch& joint) {
  const auto reaches = [&](const PlanPoint& n, double width) {
    return reach_of(run.response.buildings[left], n) + reach_of(run.response.buildings[right], n) >= width;
  };
  if (!reaches(joint.n, joint.width)) return false;
  const std::vector<FamilyBeside> apart = families_beside(run.problem.buildings[left].model.footprint,
                                                          run.problem.buildings[right].model.footprint, joint, 0);
  return std::all_of(apart.begin(), apart.end(), [&](const FamilyBeside& one) {
    return reaches(one.places.front().normal, joint.width + one.places.front().beyond);
  });
}

/// "A, south wall".
std::string plane_name(const PlanRun& run, Index b, std::size_t plane) {
  return run.problem.buildings[b].name + ", " + run.problem.buildings[b].model.planes[plane].name;
}

/// The floor that contact turns the most of those that do not turn alone.
std::optional<LargestOfFloors> turned_by_contact(const PlanRun& run) {
  constexpr double round_off = 1e-9;
  LargestOfFloors most;
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const PlanPeaks &with = run.response.buildings[b], &alone = run.response.buildings_no_contact[b];
    const double side = run.problem.buildings[b].model.footprint.size.maxCoeff();
    for (const QuantityPlace& at : floors_of(run.problem, b)) {
      const double moves = round_off * std::max(with.x(at.floor), with.y(at.floor));
      const double value = with.rotation(at.floor);
      if (side * alone.rotation(at.floor) > moves || !(side * value > moves) || value <= most.value) continue;
      most.value = value;
      most.at = at;
    }
  }
  if (std::isnan(most.value)) return std::nullopt;
  return most;
}

}  // namespace

std::vector<std::vector<ScreeningFinding>> screened(const Case& c, const PlanProblem& problem) {
  std::vector<std::vector<ScreeningFinding>> all;
  for (std::size_t gap = 0; gap < problem.gaps.size(); ++gap) all.push_back(plan_screening(c, problem, gap));
  return all;
}

GapView judged_view_of(const PlanRun& run, const RunResults& row) {
  GapView view = view_of(row);
  view.plan = &run.problem;
  view.screened = screened(run.c, run.problem);
  for (JudgedGap& one : judged_gaps(run)) {
    view.facts.push_back(std::move(one.facts));
    view.judged.push_back(std::move(one.judgement));
  }
  return view;
}

void add_place(const PlanProblem& problem, const PlanGap& gap, bool is_point, Index index, const std::string& length,
               std::vector<StoryValue>& values) {
  const StretchCorner place = is_point ? gap.at(gap.contacts[index]) : gap.stretch.at(gap.watched[index].along);
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

Statement model_statement(const PlanRun& run) {
  bool yields = false;
  std::size_t counted = 0, loaded = 0,
              moved = 0;  // buildings that move, those with gravity loads, those on soil or bearings
  for (const PlanBuilding& building : run.problem.buildings) {
    counted += building.is_rigid() ? 0 : 1;
    loaded += building.has_gravity_loads() ? 1 : 0;
    moved += building.model.soil || building.model.slab ? 1 : 0;
  }
  const bool by_axes = std::any_of(run.problem.buildings.begin(), run.problem.buildings.end(), [](const auto& one) {
    const auto& bearings = one.model.bearings;
    return std::any_of(bearings.begin(), bearings.end(), [](const auto& bearing) { return bearing.elements() > 0; });
  });
  std::vector<std::vector<StoryValue>> left_out = gravity_left_out(loaded, counted);
  if (by_axes) left_out.push_back({word_of("what", "remarks.bearings_by_axes")});
  if (moved < counted) left_out.push_back({word_of("what", moved == 0 ? "remarks.no_soil" : "remarks.soil_of")});
  for (const PlanPeaks& peaks : run.response.buildings) {
    for (const PlanPeaks::Plane& plane : peaks.planes) yields = yields || plane.yielding.ductility.size() > 0;
  }
  for (const PlanBuilding& building : run.problem.buildings) {
    for (const PlanModel::Plane& plane : building.model.planes) {
      yields =
          yields || std::any_of(plane.laws.begin(), plane.laws.end(), [](const auto& law) { return law != nullptr; });
    }
  }
  yields = yields || !frames_that_yield(run.problem).empty();
  return {.kind = "model_plan",
          .severity = Severity::remark,
          .values = {word_of("planes", yields ? "remarks.planes_yield" : "remarks.planes_elastic")},
          .items = std::move(left_out)};
}

Hit hit_of(const PlanRun& run, std::size_t gap) {
  const Index first = first_contact(run.problem, gap);
  Hit hit{.points = std::ssize(run.problem.gaps[gap].contacts), .point = first};
  for (Index i = first; i < first + hit.points; ++i) {
    const PointSummary& point = run.response.points[i];
    hit.impacts += point.impacts + point.settling;
    hit.touched += point.impacts + point.settling > 0 ? 1 : 0;
  }
  if (hit.touched == 0) return hit;
  for (const Impact& one : run.response.impacts) {  // of equal ones that of the first point
    if (one.point < first || one.point >= first + hit.points) continue;
    const bool is_first = hit.hardest == nullptr || is_harder(one, *hit.hardest) ||
                          (one.point < hit.point && !is_harder(*hit.hardest, one));
    if (!is_first) continue;
    hit.hardest = &one;
    hit.point = one.point;
  }
  return hit;
}

void put_place(const PlanRun& run, std::size_t gap, const Hit& hit, Statement& statement) {
  statement.level = contact_at(run.problem, hit.point).contact->elevation;
  statement.values.push_back(count_of("n", hit.points));
  statement.values.push_back(word_of("points", "story.count.contact_points.many"));
  add_place(run.problem, run.problem.gaps[gap], true, hit.point - first_contact(run.problem, gap), run.c.units.length,
            statement.values);
}

void tell_pairs_without_contact(const PlanRun& run, std::vector<Statement>& statements) {
  const std::vector<PlanBuilding>& buildings = run.problem.buildings;
  std::set<std::pair<Index, Index>> modelled;
  for (const PlanGap& gap : run.problem.gaps) modelled.insert(std::minmax({gap.left, gap.right}));
  std::vector<Footprint> footprints;
  double furthest = 0;  // of a building, in any direction
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    footprints.push_back(buildings[b].model.footprint);
    furthest = std::max(furthest, reach_of(run.response.buildings[b], {1, 1}));
  }
  for (const auto& [first, second] : pairs_near(footprints, 2 * furthest)) {
    const auto a = static_cast<Index>(first), b = static_cast<Index>(second);
    if (modelled.contains({a, b}) || (buildings[a].is_rigid() && buildings[b].is_rigid())) continue;
    const auto stretch = joint_between(footprints[first], footprints[second]);
    if (!stretch) continue;
    const double reach =
        reach_of(run.response.buildings[a], stretch->n) + reach_of(run.response.buildings[b], stretch->n);
    if (!(stretch->swapped ? could_meet(run, b, a, *stretch) : could_meet(run, a, b, *stretch))) continue;
    const std::string& length = run.c.units.length;
    statements.push_back({.kind = "pair_without_contact",
                          .severity = Severity::danger,
                          .buildings = {a, b},
                          .values = {text_of("left", buildings[a].name), text_of("right", buildings[b].name),
                                     value_in("width", stretch->width, length), value_in("reach", reach, length)}});
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

bool tell_turning(const PlanRun& run, std::vector<Statement>& statements) {
  constexpr double more = 1 + 1e-9;
  const LargestOfFloors turns = largest_of_floors(run, "amplification_rotation");
  const auto milliradians = [&](const char* key) {
    return 1e3 * value_of(quantity_named(key, Owner::floor, true), run, turns.at);
  };
  if (turns.value > more) {
    statements.push_back(of_floor(run, turns, "turned"));
    auto& values = statements.back().values;
    values.push_back(value_in("factor", turns.value));
    values.push_back(value_in("with", milliradians("peak_rotation"), "mrad"));
    values.push_back(value_in("without", milliradians("peak_rotation_no_contact"), "mrad"));
  }
  const std::optional<LargestOfFloors> starts = turned_by_contact(run);
  if (starts) {
    statements.push_back(of_floor(run, *starts, "turned_by_contact"));
    statements.back().values.push_back(value_in("with", 1e3 * starts->value, "mrad"));
  }
  return turns.value > more || starts;
}

void tell_left_out(const PlanRun& run, std::vector<Statement>& statements) {
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

std::vector<Storeys> storeys_of(const PlanRun& run, Index b) {
  const PlanPeaks &with = run.response.buildings[b], &alone = run.response.buildings_no_contact[b];
  std::vector<Storeys> all;
  for (std::size_t p = 0; p < with.planes.size(); ++p) {
    all.push_back({plane_name(run, b, p), with.planes[p].drift_ratio, alone.planes[p].drift_ratio,
                   with.planes[p].yielding, alone.planes[p].yielding});
  }
  all.push_back({run.problem.buildings[b].name, with.edge_drift_ratio(), alone.edge_drift_ratio(), {}, {}});
  return all;
}

}  // namespace bentur::story
