#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "bentur/io/case/case_memo.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"

namespace bentur {
namespace {

void read_structure(const TableView& view, const Units& units, const CaseFiles& files, ReadBuilding& building) {
  const auto kind = view.exactly_one("structure");
  if (const auto frame = view.find("frame")) read_frame(*frame, units.gravity, building);
  if (const auto stick = view.find("stick")) read_stick(*stick, building);
  if (const auto matrices = view.find("matrices")) read_matrices(*matrices, building);
  if (const auto modal = view.find("modal")) read_modal(*modal, units, files, building);
  if (const auto generic = view.find("generic")) read_generic(*generic, units, building);
  if (const auto known = view.find("displacements")) read_displacements(*known, building);
  if (!kind) {  // what was read does not say which floors are meant
    building.modes = 0;
    building.elevations.clear();
  }
}

ReadBuilding read_building(const TomlView& entry, const Units& units, const CaseFiles& files,
                           const std::vector<ReadBuilding>& before) {
  ReadBuilding building;
  if (!read_name(entry, before, building)) return building;
  const TableView view = *TableView::of(entry.renamed(building.path), building_keys());
  if (view.flag("rigid")) {
    std::vector<std::string> keys = view.keys().names();
    std::erase_if(keys, [](const std::string& key) {
      return key == "name" || key == "rigid" || key == "elevations" || key == "base_elevation";
    });
    view.refuse(keys, "is not for a rigid building, which moves with the ground");
    building.spec.base_elevation = view.number("base_elevation").value_or(0);
    read_rigid(view, building);
    for (double& elevation : building.elevations) elevation += building.spec.base_elevation;
    make(building);
    return building;
  }
  view.refuse({"plane", "rigidity"}, "goes with plan, which is not given");
  view.refuse(
      {"elevations"},
      "goes with rigid = true: floors of other buildings stand in their frame, stick, matrices, modal, generic or "
      "displacements");
  building.spec.calibrate_period = view.number("calibrate_period");
  building.spec.base_elevation = view.number("base_elevation").value_or(0);
  read_structure(view, units, files, building);
  if (view.has("modal")) {
    view.refuse({"calibrate_period", "p_delta", "gravity_loads", "isolation", "soil", "damping_stiffness"},
                "needs the storeys of a building: one known by its modes stands as it is given");
  }
  if (building.has_displacements()) {
    std::vector<std::string> keys = view.keys().names();
    std::erase_if(keys, [](const std::string& key) {
      return key == "name" || key == "displacements" || key == "base_elevation" || key == "rigid";
    });
    view.refuse(keys, "is not for a building known by its displacements, of which nothing is solved");
    for (double& elevation : building.elevations) elevation += building.spec.base_elevation;
    make(building);
    return building;
  }
  read_support(view, units.gravity, building);
  if (building.spec.isolation && !building.elevations.empty()) {
    building.elevations.insert(building.elevations.begin(), 0.0);  // the slab
  }
  if (const auto width = view.find("width")) {
    if (building.is_frame) {
      width->error("is not for a frame, whose width is the sum of its bay_widths");
    } else {
      building.spec.width = view.number("width");
    }
  }
  for (double& elevation : building.elevations) elevation += building.spec.base_elevation;
  const auto matrices = view.find("matrices");
  const auto matrix_damping = matrices ? matrices->find("damping") : std::nullopt;
  const auto damping = view.find("damping");
  if (damping) {
    Damping read = read_damping(*damping, building.modes);
    if (matrix_damping) {
      matrix_damping->error(fmt::format("and {} exclude one another: give exactly one", damping->path()));
    } else {
      building.spec.damping = std::move(read);
    }
  } else if (!matrix_damping) {
    view.error_missing("damping");
  }
  make(building);
  read_damping_stiffness(view, building);
  return building;
}

}  // namespace

bool read_name(const TomlView& entry, const std::vector<ReadBuilding>& before, ReadBuilding& building) {
  building.path = entry.path();
  if (!entry.is(TomlValue::Kind::table)) {
    entry.error_value("must be a table");
    return false;
  }
  const auto given = entry.get("name");
  if (const auto name = given ? given->as_line() : std::nullopt) {
    building.spec.name = *name;
    if (name->empty()) {
      given->error("is empty");
    } else {
      building.path = fmt::format("building[{}]", in_quotes(*name));
      const auto same = [&](const ReadBuilding& other) { return other.spec.name == *name; };
      if (std::any_of(before.begin(), before.end(), same)) {
        given->error_value("another building has this name already");
        building.path = entry.path();
      }
    }
  }
  return true;
}

void make(ReadBuilding& building) {
  building.made = nullptr;  // of what was read before
  try {
    building.model = structural_model(building.spec);
    if (building.spec.isolation) building.model = make_building(building.spec, *building.model).model;
  } catch (const std::exception&) {
    building.model.reset();  // said already, or said once everything else is right
  }
}

std::vector<ReadBuilding> read_buildings(const TomlView& root, const Units& units, const CaseFiles& files,
                                         const CaseMemo* memo) {
  std::vector<ReadBuilding> buildings;
  const auto list = root.tables("building", "two or more [[building]] tables");
  if (!list || list->has_more_than(case_keys().at("building").most)) return buildings;
  for (const TomlView& table : list->items()) {
    const auto known = memo != nullptr ? memo->building(table.value(), units, buildings) : nullptr;
    buildings.push_back(known ? *known : read_building(table, units, files, buildings));
  }
  if (list->size() < 2) list->error("has " + list->entries() + ", expected two or more");
  return buildings;
}

}  // namespace bentur
