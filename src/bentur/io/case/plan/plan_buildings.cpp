#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>

#include "bentur/core/errors.h"
#include "bentur/io/case/plan/plan_parts.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/footprint_keys.h"
#include "bentur/io/schema/table_view.h"
#include "bentur/structure/plan/footprint_parts.h"
#include "bentur/structure/plan/plan_masses.h"

namespace bentur {
namespace {

std::optional<PlanPoint> read_pair(const TomlView& view, Range range) {
  const std::vector<double> pair = view.as_numbers(range, {2, "x and y"});
  return pair.size() == 2 ? std::optional(PlanPoint(pair[0], pair[1])) : std::nullopt;
}

std::optional<PlanPoint> read_pair(const TableView& table, const char* key) {
  const auto given = table.get(key);
  return given ? read_pair(*given, table.key(key).range) : std::nullopt;
}

/// The corners of a ring, at the list or the corner that is wrong; none (and an error) where they break a rule.
std::vector<PlanPoint> read_ring(const TableView& table) {
  const auto given = table.get("polygon");
  const Key& key = table.key("polygon");
  if (!given || !given->is_list_of("pairs") || given->has_more_than(key.most)) return {};
  std::vector<PlanPoint> corners;
  for (const TomlView& item : given->items()) {
    if (const auto corner = read_pair(item, key.range)) corners.push_back(*corner);
  }
  if (corners.size() != given->size()) return {};
  if (const auto fault = fault_of_outline(corners)) {
    given->error(*fault);
    return {};
  }
  return corners;
}

/// Rings of a list of tables, and where each stands.
struct Rings {
  std::vector<std::vector<PlanPoint>> corners;
  std::vector<TomlView> places;
  bool known = true;
};

Rings read_rings(const TableView& table, const char* key, const KeyTable& keys) {
  Rings rings;
  const auto list = table.find(key);
  rings.known = !list || list->is_list_of("tables");
  for (const TomlView& entry : list&& rings.known ? list->items() : std::vector<TomlView>()) {
    const auto one = TableView::of(entry, keys);
    rings.corners.push_back(one ? read_ring(*one) : std::vector<PlanPoint>());
    rings.places.push_back(entry);
    rings.known = rings.known && !rings.corners.back().empty();
  }
  return rings;
}

bool read_polygon(const TableView& table, Footprint& footprint) {
  std::vector<PlanPoint> corners = read_ring(table);
  const auto origin = table.has("corner") ? read_pair(table, "corner") : std::optional(PlanPoint(0, 0));
  Rings courts = read_rings(table, "court", court_keys()), parts = read_rings(table, "part", part_keys());
  if (corners.empty() || !origin || !courts.known || !parts.known) return false;
  footprint = polygon_footprint(*origin, std::move(corners), std::move(courts.corners));
  footprint = with_parts(std::move(footprint), std::move(parts.corners));
  bool known = true;
  const std::size_t count = courts.places.size();
  for (std::size_t i = 0; i < footprint.rings.size(); ++i) {
    const auto fault = i < count ? fault_of_court(footprint, i) : fault_of_part(footprint, i);
    if (fault) (i < count ? courts.places[i] : parts.places[i - count]).error(*fault);
    known = known && !fault;
  }
  return known;
}

bool read_footprint(const TableView& table, Footprint& footprint) {
  const auto shape = table.exactly_one("footprint");
  if (shape == "polygon") return read_polygon(table, footprint);
  if (shape && !table.has("corner")) table.error_missing("corner", "where a rectangle stands");
  const auto corner = read_pair(table, "corner");
  if (!shape) return false;
  const auto size = read_pair(table, "size");
  if (!corner || !size) return false;
  footprint = {.corner = *corner, .size = *size};
  return (size->array() > 0).all();
}

/// Centres of mass stand on the floor.
void check_centres(const TableView& table, const Plan& plan) {
  const auto given = table.find("centres_of_mass");
  for (std::size_t i = 0; given && i < plan.centres_of_mass.size(); ++i) {
    const PlanPoint& centre = plan.centres_of_mass[i];
    if (plan.footprint.contains(centre)) continue;
    const bool nested = given->item(0).is(TomlValue::Kind::list);
    const TomlView at = nested ? given->item(i) : *given;
    if (!plan.footprint.polygon.empty()) {
      at.error("is outside the polygon");
      continue;
    }
    at.error(fmt::format("is outside the footprint of {} by {}", plan.footprint.size.x(), plan.footprint.size.y()));
  }
}

/// Moves all centres of mass, or takes by how much they may stand elsewhere; there they must stand on the floor still.
void move_centres(const TableView& table, Plan& plan) {
  const auto given = table.find("accidental_eccentricity");
  const std::vector<double> parts = table.numbers("accidental_eccentricity", 2);
  if (!given || parts.empty()) return;
  const bool both_ways = given->is_number();
  if (both_ways && parts.front() < 0) {
    given->error_value("must be ≥ 0: a number is of both ways, a list of one");
    return;
  }
  Plan moved = plan;
  moved.eccentricity_both_ways = both_ways ? parts.front() : 0;
  const std::vector<Plan> all =
      both_ways ? with_masses_elsewhere(moved) : std::vector{with_masses_moved(plan, {parts.front(), parts.back()})};
  for (const Plan& one : all) {
    for (Eigen::Index f = 0; f < std::ssize(one.masses); ++f) {
      if (one.footprint.contains(centre_of_mass(one, f))) continue;
      given->error(fmt::format("moves the centre of mass of floor {} out of the footprint", f + 1));
      return;
    }
  }
  plan = both_ways ? std::move(moved) : all.front();
}

/// The line that a plane stands on.
void read_line(const TableView& table, PlanPlane& plane) {
  const auto line = table.exactly_one("line");
  if (line == "along") {
    table.refuse({"through"}, "goes with angle, which is not given");
    const auto axis = table.word("along");
    if (!table.has("at")) table.error_missing("at", "where along is given");
    const double at = table.number("at").value_or(0);
    if (axis == "y") plane.direction = PlanPoint::UnitY();
    plane.through = axis == "y" ? PlanPoint(at, 0) : PlanPoint(0, at);
  } else if (line == "angle") {
    table.refuse({"at"}, "goes with along, which is not given");
    const double angle = table.number("angle").value_or(0) * std::numbers::pi / 180;
    plane.direction = {std::cos(angle), std::sin(angle)};
    if (!table.has("through")) table.error_missing("through", "where angle is given");
    if (table.has("through")) plane.through = read_pair(table, "through").value_or(PlanPoint::Zero());
  }
}

/// @return whether its stiffnesses are known
bool read_plane(const TableView& table, const std::vector<double>& heights, const std::vector<ColumnNode>& nodes,
                PlanPlane& plane) {
  const std::size_t storeys = heights.size();
  read_line(table, plane);
  const auto holds = table.exactly_one("holds");
  if (table.has("frame")) {
    std::vector<std::string> yields = plane_keys().names();
    std::erase_if(yields, [](const std::string& key) {
      return key == "name" || key == "along" || key == "at" || key == "angle" || key == "through" ||
             key == "stiffnesses" || key == "frame";
    });
    table.refuse(yields, "does not go with frame, whose members yield by moment_capacity of their sections");
    const auto frame = table.table("frame");
    return holds && frame && read_frame_of_plane(*frame, heights, nodes, plane);
  }
  if (!holds) return false;
  plane.storeys.stiffnesses = table.numbers_for_each("stiffnesses", storeys);
  const std::vector<double>& stiffnesses = plane.storeys.stiffnesses;
  const bool known = stiffnesses.size() == storeys && storeys > 0;
  if (known && std::all_of(stiffnesses.begin(), stiffnesses.end(), [](double k) { return k == 0; })) {
    table.find("stiffnesses")->error("must have one that is > 0");
  }
  read_yielding(table, storeys, plane.storeys);
  read_backbone(table, storeys, plane.storeys);
  return known;
}

/// A plane that stands beside its building by more than half of what that measures across it.
void check_stands_in(const Footprint& footprint, const PlanPlane& plane, const TableView& table) {
  const PlanPoint across(-plane.direction.y(), plane.direction.x());
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const PlanPoint& corner : {PlanPoint(0, 0), PlanPoint(footprint.size.x(), 0), PlanPoint(0, footprint.size.y()),
                                  PlanPoint(footprint.size)}) {
    const double at = across.dot(corner - plane.through);
    least = std::min(least, at);
    most = std::max(most, at);
  }
  if (std::max(least, -most) <= 0.5 * (most - least)) return;
  const auto place = table.find(table.has("at") ? "at" : "through");
  const std::string size = fmt::format("{} by {}", footprint.size.x(), footprint.size.y());
  if (place) place->error(fmt::format("is far outside the footprint of {}", size));
}

/// @param of which building, from 0 @return whether all that holds the storeys is known
bool read_planes(const TableView& building, std::size_t of, const StruckNodes& nodes, Plan& plan) {
  const auto list = building.find("plane");
  if (!list) return true;
  if (!list->is_list_of("tables")) return false;
  bool known = true;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string number = fmt::format("plane {}", i + 1);
    TomlView entry = list->item(i);
    const TomlValue* const named = entry.value().find("name");
    if (named != nullptr && !named->text.empty()) {
      entry = entry.renamed(fmt::format("{}[{}]", list->path(), in_quotes(named->text)));
    }
    const auto table = TableView::of(entry, plane_keys());
    if (!table) {
      known = false;
      continue;
    }
    PlanPlane plane;
    const auto name = table->find("name");
    plane.name = name ? name->as_line().value_or(number) : number;
    const auto same = [&](const PlanPlane& other) { return other.name == plane.name; };
    if (std::any_of(plan.planes.begin(), plan.planes.end(), same)) {
      (name ? *name : entry).error(fmt::format("another plane of the building is called {}", in_quotes(plane.name)));
    }
    const auto struck = nodes.find({of, i});
    known = read_plane(*table, plan.storey_heights, struck != nodes.end() ? struck->second : std::vector<ColumnNode>(),
                       plane) &&
            known;
    if (plan.footprint.size.minCoeff() > 0) check_stands_in(plan.footprint, plane, *table);
    plan.planes.push_back(std::move(plane));
  }
  return known;
}

bool read_rigidity(const TableView& building, std::size_t storeys, Plan& plan) {
  const auto table = building.table("rigidity");
  if (!table) return !building.has("rigidity");
  PlanRigidity rigidity{.centres = read_pairs(*table, "centre", storeys)};
  for (const auto& [key, list] :
       {std::pair{"x", &rigidity.x}, std::pair{"y", &rigidity.y}, std::pair{"torsion", &rigidity.torsion}}) {
    if (!table->has(key)) continue;
    *list = table->numbers(key, storeys);
    if (list->empty()) return false;
  }
  if (rigidity.centres.empty()) return false;
  plan.rigidity = std::move(rigidity);
  return true;
}

/// Storeys that nothing holds, at the building.
void check_held(const TableView& building, const Plan& plan) {
  if (plan.planes.empty() && !plan.rigidity) {
    building.error(
        "has no planes and no rigidity: give [[building.plane]] tables, [building.rigidity] or both, "
        "[building.matrices], "
        "[building.modal] or [building.generic]");
    return;
  }
  for (const UnheldStorey& found : unheld_storeys(plan)) {
    building.error(found.direction == "rotation"
                       ? fmt::format("has nothing that holds storey {} against rotation", found.storey + 1)
                       : fmt::format("has nothing that holds storey {} along {}", found.storey + 1, found.direction));
  }
}

void read_wall(const TableView& building, ReadBuilding& read) {
  std::vector<std::string> keys = building.keys().names();
  std::erase_if(keys, [](const std::string& key) {
    return key == "name" || key == "rigid" || key == "elevations" || key == "base_elevation" || key == "plan";
  });
  building.refuse(keys, "is not for a rigid building, which moves with the ground");
  read_rigid(building, read);
  PlanWall wall{.footprint = {}, .elevations = read.elevations};
  const auto table = building.table("plan");
  if (!building.has("plan")) building.error_missing("plan", "buildings stand in plan, all of them or none");
  const bool placed = table && read_footprint(*table, wall.footprint);
  read.is_whole = placed && !wall.elevations.empty();
  read.spec.structure = std::move(wall);
}

/// @return how many
std::size_t read_storeys(const TableView& table, Plan& plan) {
  for (const char* const key : {"storey_heights", "masses"}) {
    if (!table.has(key)) table.error_missing(key);
  }
  const auto heights = table.find("storey_heights");
  const std::size_t storeys = heights ? heights->size() : 0;
  plan.storey_heights = table.numbers("storey_heights");
  plan.masses = table.numbers("masses", storeys);
  return storeys;
}

/// What a generic building is held by, where all of it has been read without errors.
void stand(const TomlView& generic, const GenericPlan& little, bool is_known, Plan& plan) {
  const bool has_period = little.along_x.period > 0 || little.along_x.period_formula;
  if (!is_known || !has_period) return;
  try {
    stand_generic(little, plan);
  } catch (const std::exception& error) {
    generic.error(std::string("cannot be computed with: ") + error.what());
  }
}

/// Brings a building whose planes, rigidity or generic have been read to a period; one that nothing holds has its own
/// error.
void calibrate(const TomlView& given, Plan& plan) {
  const auto period = given.as_number(Range::positive);
  if (!period || !unheld_storeys(plan).empty()) return;
  try {
    calibrate_period(plan, *period);
  } catch (const std::exception& error) {
    given.error(std::string("cannot be computed with: ") + error.what());
  }
}

/// @param number of the building, from 0
void read_floors(const TableView& building, std::size_t number, const Units& units, const CaseFiles& files,
                 const StruckNodes& nodes, ReadBuilding& read) {
  building.refuse({"elevations"}, "goes with rigid = true: floors of other buildings stand in their plan");
  building.refuse({"width", "frame", "stick", "displacements"}, "does not go with buildings in plan");
  Plan plan;
  if (!building.has("plan")) building.error_missing("plan", "buildings stand in plan, all of them or none");
  const auto table = building.table("plan");
  bool known = table && read_footprint(*table, plan.footprint);
  const auto generic = building.find("generic");
  const auto little = generic ? read_generic_in_plan(*generic, units) : std::nullopt;
  std::size_t storeys = 0;
  if (little) {
    storeys = little->along_x.storey_heights.size();
    plan.storey_heights = little->along_x.storey_heights;
    plan.masses = little->along_x.floor_masses;
  }
  if (table) {
    if (!generic) storeys = read_storeys(*table, plan);
    if (generic) table->refuse({"storey_heights", "masses"}, "follows from generic, which has the storeys");
    if (table->has("centres_of_mass")) {
      plan.centres_of_mass = read_pairs(*table, "centres_of_mass", storeys);
      known = known && !plan.centres_of_mass.empty();
    }
    if (table->has("inertias")) plan.inertias = table->numbers("inertias", storeys);
    known = known && plan.storey_heights.size() == storeys && storeys > 0 && plan.masses.size() == storeys;
    if (known) check_centres(*table, plan);
  }
  if (generic) {
    building.refuse({"plane", "rigidity", "matrices", "modal"},
                    "does not go with generic, whose periods say what holds the storeys");
    if (little) stand(*generic, *little, known, plan);
  } else if (const auto matrices = building.find("matrices")) {
    building.refuse({"plane", "rigidity", "modal"}, "does not go with matrices, which say what holds the storeys");
    PlanStiffness stiffness{.at = {}, .matrix = read_stiffness_in_plan(*matrices, storeys)};
    known = known && stiffness.matrix.size() > 0;
    for (std::size_t f = 0; known && f < storeys; ++f) {
      stiffness.at.push_back(centre_of_mass(plan, static_cast<Eigen::Index>(f)));
    }
    if (known) plan.known = std::move(stiffness);
  } else if (const auto modal = building.find("modal")) {
    building.refuse({"plane", "rigidity"}, "does not go with modal, whose modes say how the floors move");
    building.refuse({"calibrate_period", "p_delta", "gravity_loads", "isolation", "soil", "damping_stiffness"},
                    "needs the storeys of a building: one known by its modes stands as it is given");
    if (table) {
      table->refuse({"accidental_eccentricity"},
                    "needs what holds the storeys: a building known by its modes stands as it is given");
    }
    plan.modes = read_modes_in_plan(*modal, units, files, plan.storey_heights, read.spec);
    known = known && !plan.modes->shapes.empty();
  } else {
    const bool planes = read_planes(building, number, nodes, plan);
    const bool held = read_rigidity(building, storeys, plan) && planes;
    if (known && held) check_held(building, plan);
  }
  if (const auto period = building.get("calibrate_period"); period && known) calibrate(*period, plan);
  if (known) move_centres(*table, plan);
  read.modes = plan.modes ? plan.modes->periods.size() : 3 * storeys;
  read.elevations = floor_elevations(plan.storey_heights);
  read_gravity(building, read);
  plan.gravity_loads = read.spec.gravity_loads;
  if (read.spec.p_delta && plan.gravity_loads.empty()) {
    for (const double mass : plan.masses) plan.gravity_loads.push_back(mass * units.gravity);
  }
  const auto isolation = building.find("isolation");
  if (isolation) {
    building.refuse({"soil"}, "and isolation exclude one another: a slab on bearings stands on firm ground");
    if (known) plan.isolation = read_isolation(*isolation, plan, units.gravity);
    known = known && plan.isolation;
    read.elevations.insert(read.elevations.begin(), 0.0);
  }
  if (const auto soil = building.find("soil"); soil && !isolation) plan.soil = read_soil_in_plan(*soil, plan.footprint);
  if (const auto damping = building.get("damping")) {
    read.spec.damping = read_damping(*damping, read.modes);
  } else {
    building.error_missing("damping");
  }
  if (const auto word = building.find("damping_stiffness")) {
    read.spec.tangent_damping = building.word("damping_stiffness") == "tangent";
    const auto yields = [](const PlanPlane& plane) {
      return !plane.storeys.yield_forces.empty() || plane.storeys.backbone;
    };
    if (!plan.modes && std::none_of(plan.planes.begin(), plan.planes.end(), yields)) {
      word->error_value("needs planes that can yield: plane.yield_forces or plane.backbone");
    }
  }
  read.is_whole = known;
  read.spec.structure = std::move(plan);
}

}  // namespace

std::vector<PlanPoint> read_pairs(const TableView& table, const char* key, std::size_t count) {
  const auto given = table.get(key);
  if (!given) return {};
  const Range range = table.key(key).range;
  const bool nested = given->is(TomlValue::Kind::list) && given->size() > 0 && given->item(0).is(TomlValue::Kind::list);
  if (!nested) {
    const auto one = read_pair(*given, range);
    return one ? std::vector<PlanPoint>{*one} : std::vector<PlanPoint>{};
  }
  if (!given->is_list_of("pairs", count > 0 ? Length{count, "one per storey"} : Length{})) return {};
  std::vector<PlanPoint> pairs;
  for (const TomlView& item : given->items()) {
    const auto one = read_pair(item, range);
    if (one) pairs.push_back(*one);
  }
  return pairs.size() == given->size() ? pairs : std::vector<PlanPoint>{};
}

std::vector<ReadBuilding> read_plan_buildings(const TomlView& root, const Units& units, const CaseFiles& files,
                                              const StruckNodes& nodes) {
  std::vector<ReadBuilding> buildings;
  const auto list = root.tables("building", "two or more [[building]] tables");
  if (!list || list->has_more_than(case_keys().at("building").most)) return buildings;
  for (const TomlView& entry : list->items()) {
    ReadBuilding read;
    read.spec.structure = Plan{};
    if (read_name(entry, buildings, read)) {
      const TableView view = *TableView::of(entry.renamed(read.path), building_keys());
      read.spec.base_elevation = view.number("base_elevation").value_or(0);
      if (view.flag("rigid")) {
        read_wall(view, read);
      } else {
        read_floors(view, buildings.size(), units, files, nodes, read);
      }
      for (double& elevation : read.elevations) elevation += read.spec.base_elevation;
    }
    buildings.push_back(std::move(read));
  }
  if (list->size() < 2) list->error("has " + list->entries() + ", expected two or more");
  return buildings;
}

std::vector<PlanBuilding> make_buildings(const TomlView& root, const Case& c,
                                         const std::vector<ReadBuilding>& buildings, std::vector<PlanBuilding> made) {
  const bool known = !made.empty();
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    const TomlView view = view_of(root, buildings, b);
    try {
      const PlanBuilding& one = known ? made[b] : made.emplace_back(make_plan_building(buildings[b].spec));
      check_mode_times(view, one.modes, one.modal_damping, c.analysis.duration);
    } catch (const std::exception& error) {
      view.error(std::string("cannot be computed with: ") + error.what());
    }
  }
  return made;
}

void refuse_masses_elsewhere(const TomlView& root, const Case& c, const std::vector<ReadBuilding>& buildings) {
  if (!c.excitation.spectrum) return;
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    const auto* const plan = std::get_if<Plan>(&buildings[b].spec.structure);
    if (plan == nullptr || plan->eccentricity_both_ways == 0) continue;
    const TomlView given = *view_of(root, buildings, b).find("plan")->find("accidental_eccentricity");
    given.error_value("goes both ways under ground motions, not under a spectrum: give a list, [0.05, 0]");
  }
}

}  // namespace bentur
