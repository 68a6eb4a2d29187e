#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bentur/io/case/plan/plan_parts.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"

namespace bentur {
namespace {

/// τ_b = (s · C_b − min)/v [s] of a wave that goes along s: C_b is the middle of the footprint.
std::vector<double> wave_delays_in_plan(const TableView& view, const std::vector<ReadPlanBuilding>& buildings) {
  const double velocity = view.number("wave_velocity").value_or(1);
  const double angle = view.number("wave_angle").value_or(0) * std::numbers::pi / 180;
  const PlanPoint along(std::cos(angle), std::sin(angle));
  std::vector<double> delays;
  double first = std::numeric_limits<double>::infinity();
  for (const ReadPlanBuilding& building : buildings) {
    const Footprint& footprint = building.spec.footprint();
    delays.push_back(along.dot(footprint.corner + footprint.middle()));
    first = std::min(first, delays.back());
  }
  for (double& delay : delays) delay = (delay - first) / velocity;
  return delays;
}

std::vector<double> read_delays_in_plan(const TableView& view, const std::vector<ReadPlanBuilding>& buildings) {
  const auto key = view.exactly_one("delay");
  if (key != "wave_velocity") {
    view.refuse({"wave_angle"}, "goes with wave_velocity, which is not given");
  } else {
    return wave_delays_in_plan(view, buildings);
  }
  if (key == "delays") {
    std::vector<double> delays = view.numbers("delays", buildings.size());
    if (!delays.empty()) return delays;
  }
  return std::vector<double>(buildings.size(), 0.0);
}

/// One list of triples per building, flat; empty where the table is missing.
std::vector<std::vector<double>> read_triples(const TableView& initial, const std::string& key,
                                              const std::vector<ReadPlanBuilding>& buildings, bool& moves) {
  const auto table = initial.find(key);
  if (!table) return {};
  const Range range = initial.key(key).range;
  std::vector<std::string> names;
  std::vector<std::vector<double>> lists;
  for (const ReadPlanBuilding& building : buildings) {
    names.push_back(building.spec.name);
    lists.emplace_back(3 * building.told.elevations.size(), 0.0);
  }
  const auto take = [&](std::size_t b, const TomlView& given) {
    if (buildings[b].spec.is_rigid()) {
      given.error("is of a wall, which moves with the ground");
      return;
    }
    const std::size_t floors = buildings[b].told.elevations.size();
    if (floors == 0 || !given.is_list_of("[x, y, rotation]", {floors, "one per floor"})) return;
    for (std::size_t f = 0; f < floors; ++f) {
      const std::vector<double> triple = given.item(f).as_numbers(range, {3, "x, y and rotation"});
      if (triple.size() != 3) continue;
      std::copy(triple.begin(), triple.end(), lists[b].begin() + static_cast<std::ptrdiff_t>(3 * f));
      moves = moves || std::any_of(triple.begin(), triple.end(), [](double x) { return x != 0; });
    }
  };
  const bool is_table = read_by_building(*table, "list of one [x, y, rotation] per floor", names, take);
  return is_table ? lists : std::vector<std::vector<double>>{};
}

}  // namespace

void read_plan_excitation(const TomlView& root, const std::vector<ReadPlanBuilding>& buildings, const CaseFiles& files,
                          PlanCase& c) {
  const auto given = root.get("excitation");
  const auto view = given ? TableView::of(*given, excitation_keys()) : std::nullopt;
  if (!view) return;
  const auto kind = view->find("kind");
  if (kind && (kind->value().text == "spectrum" || kind->value().text == "suite")) {
    kind->error_value("does not go with buildings in plan");
    return;
  }
  read_motion(*view, c.units, files.folder, files.diagnostics, c.excitation[0], files.memo);
  c.excitation[0].delays = read_delays_in_plan(*view, buildings);
  if (view->word("kinematics") == "absolute") c.excitation[0].kinematics = Kinematics::absolute;
  c.angle = view->number("angle").value_or(0);
  if (!view->has("y")) return;
  if (const auto along_y = view->table("y")) {
    read_motion(*along_y, c.units, files.folder, files.diagnostics, c.excitation[1], files.memo);
  }
}

InitialSpec read_plan_initial(const TomlView& root, const std::vector<ReadPlanBuilding>& buildings, bool& moves) {
  InitialSpec initial;
  const auto given = root.find("initial");
  const auto view = given ? TableView::of(*given, initial_keys()) : std::nullopt;
  if (!view) return initial;
  initial.displacements = read_triples(*view, "displacements", buildings, moves);
  initial.velocities = read_triples(*view, "velocities", buildings, moves);
  return initial;
}

}  // namespace bentur
