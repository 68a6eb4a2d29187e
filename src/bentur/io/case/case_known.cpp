#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "bentur/core/number_text.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/case/plan/plan_parts.h"
#include "bentur/io/exchange/mode_shapes.h"
#include "bentur/io/number_table.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"

namespace bentur {
namespace {

/// α of a word, as [MirandaTaghavi2005] tells of such systems.
double ratio_of(const std::string& system) {
  if (system == "wall") return 1;
  return system == "dual" ? 4 : 12;
}

/// Shapes of a table beside the case; empty (and an error) where something is wrong.
std::vector<std::vector<double>> read_shapes_file(const TableView& view, const CaseFiles& files, ShapesAsked asked,
                                                  BuildingSpec& spec) {
  const TomlView file = *view.find("shapes_file");
  const auto name = file.as_text();
  if (!name) return {};
  asked.component = view.word("shapes_column");
  if (const auto given = view.find("shapes_modes")) {
    for (const double number : view.numbers("shapes_modes", asked.modes)) {
      asked.numbers.push_back(static_cast<int>(std::min(number, 1e9)));
      if (number != std::floor(number)) given->error("must be whole numbers");
    }
  }
  if (const auto names = view.find("floor_names");
      names && names->is_list_of("texts", {asked.elevations.size(), "one per floor"})) {
    for (const TomlView& one : names->items()) asked.names.push_back(one.as_text().value_or(""));
  }
  const auto path = input_path(file, *name, files.folder, table_input);
  if (!path) return {};
  spec.shapes_path = path->string();
  const auto text = read_input(*path, table_input, files.diagnostics);
  return text
             ? mode_shapes(*text, path->string(), asked, files.diagnostics).value_or(std::vector<std::vector<double>>())
             : std::vector<std::vector<double>>();
}

/// Periods and shapes of [building.modal]. @param floors how many @param asked of a file: elevations, empty where they
/// are not known, and whether floors move in plan
GivenModes read_modes(const TableView& view, const CaseFiles& files, std::size_t floors, ShapesAsked asked,
                      BuildingSpec& spec) {
  GivenModes modes;
  const std::size_t dofs = asked.in_plan ? 3 * floors : floors;
  const auto periods = view.find("periods");
  modes.periods = view.numbers("periods");
  if (periods && floors > 0 && modes.periods.size() > dofs) {
    periods->error("has " + periods->entries() + ": a building has " + (asked.in_plan ? "three times " : "") +
                   "as many modes as floors at most");
  }
  const auto kind = view.exactly_one("shapes");
  if (kind != "shapes_file") {
    view.refuse({"shapes_modes", "floor_names"}, "goes with shapes_file, which is not given");
    if (!asked.in_plan) view.refuse({"shapes_column"}, "goes with shapes_file, which is not given");
  }
  asked.modes = modes.periods.size();
  if (kind == "shapes_file") {
    if (!asked.elevations.empty() && asked.modes > 0) {
      modes.shapes = read_shapes_file(view, files, std::move(asked), spec);
    }
  } else if (const auto shapes = view.find("shapes");
             shapes && shapes->is_list_of("lists, one per mode", {modes.periods.size(), "one per mode"})) {
    for (const TomlView& shape : shapes->items()) {
      modes.shapes.push_back(
          shape.as_numbers(Range::finite, {dofs, asked.in_plan ? "three per floor" : "one per floor"}));
    }
  }
  return modes;
}

/// What is the same of buildings in a row and in plan; without storeys where their number is not known.
GenericBuilding read_cantilever(const TableView& view, const Units& units) {
  GenericBuilding generic;
  const auto storeys = static_cast<std::size_t>(view.whole("storeys").value_or(0));
  if (storeys > 0) {
    generic.storey_heights = view.numbers_for_each("storey_height", storeys);
    generic.floor_masses = view.numbers_for_each("floor_mass", storeys);
  }
  if (const auto kind = view.exactly_one("period")) {
    if (*kind == "period") {
      generic.period = view.number("period").value_or(0);
    } else if (const auto formula = view.table("period_formula")) {
      const double coefficient = formula->number("coefficient").value_or(0);
      const double exponent = formula->number("exponent").value_or(0);
      generic.period_formula = {{coefficient, exponent, 1 / metres(units.length)}};
    }
  }
  if (const auto kind = view.exactly_one("system")) {
    if (*kind == "stiffness_ratio") {
      generic.stiffness_ratio = view.number("stiffness_ratio").value_or(0);
    } else if (const auto system = view.word("system")) {
      generic.stiffness_ratio = ratio_of(*system);
    }
  }
  return generic;
}

}  // namespace

void read_modal(const TomlView& given, const Units& units, const CaseFiles& files, ReadBuilding& building) {
  const auto table = TableView::of(given, modal_keys());
  if (!table) return;
  const TableView& view = *table;
  for (const char* const key : {"elevations", "masses"}) {
    if (!view.has(key)) view.error_missing(key);
  }
  ModalBuilding modal;
  modal.elevations = view.numbers("elevations");
  const std::size_t floors = modal.elevations.size();
  const bool ascends = std::adjacent_find(modal.elevations.begin(), modal.elevations.end(), std::greater_equal<>()) ==
                       modal.elevations.end();
  if (!ascends) view.find("elevations")->error("must ascend");
  modal.masses = view.numbers("masses", floors);
  ShapesAsked asked{.elevations = {}, .metre = 1 / metres(units.length)};
  if (ascends) asked.elevations = modal.elevations;
  modal.modes = read_modes(view, files, floors, std::move(asked), building.spec);
  building.modes = modal.modes.periods.size();
  if (ascends) building.elevations = modal.elevations;
  building.spec.structure = std::move(modal);
}

GivenModes read_modes_in_plan(const TomlView& given, const Units& units, const CaseFiles& files,
                              const std::vector<double>& storey_heights, BuildingSpec& spec) {
  const auto table = TableView::of(given, modal_keys());
  if (!table) return {};
  table->refuse({"elevations", "masses"}, "follows from plan, which has storey_heights, masses and inertias");
  table->refuse({"shapes_column"}, "is not for buildings in plan, whose files have UX, UY and RZ or U1, U2 and R3");
  ShapesAsked asked{.elevations = floor_elevations(storey_heights), .metre = 1 / metres(units.length), .in_plan = true};
  GivenModes modes = read_modes(*table, files, storey_heights.size(), std::move(asked), spec);
  const auto is_wrong = [](const std::vector<double>& shape) { return shape.empty(); };
  if (std::any_of(modes.shapes.begin(), modes.shapes.end(), is_wrong)) modes.shapes.clear();
  return modes;
}

void read_generic(const TomlView& given, const Units& units, ReadBuilding& building) {
  const auto table = TableView::of(given, generic_keys());
  if (!table) return;
  const TableView& view = *table;
  view.refuse({"period_y", "torsion_ratio", "eccentricity"}, "goes with plan, which is not given");
  building.spec.gravity = units.gravity;
  GenericBuilding generic = read_cantilever(view, units);
  const std::size_t storeys = generic.storey_heights.size();
  const auto yields = view.exactly_one("yields");
  if (yields == "design_base_shear") {
    const auto design = view.number("design_base_shear");
    if (!view.has("overstrength")) {
      view.error_missing("overstrength",
                         "design_base_shear times it is the base shear at yield; 1 where they are the same");
    }
    generic.yield_base_shear = design.value_or(1) * view.number("overstrength").value_or(1);
  } else {
    generic.yield_base_shear = view.number("yield_base_shear");
    view.refuse({"overstrength"}, "goes with design_base_shear");
  }
  generic.hardening = view.number("hardening").value_or(0);
  if (!yields) view.refuse({"hardening"}, "goes with yield_base_shear or design_base_shear");
  if (storeys == 0) return;
  read_storey_columns(view, storeys, building.spec);
  building.modes = storeys;
  building.elevations = floor_elevations(generic.storey_heights);
  building.spec.structure = std::move(generic);
}

std::optional<GenericPlan> read_generic_in_plan(const TomlView& given, const Units& units) {
  const auto table = TableView::of(given, generic_keys());
  if (!table) return std::nullopt;
  const TableView& view = *table;
  view.refuse({"yield_base_shear", "design_base_shear", "overstrength", "hardening"},
              "is not for buildings in plan, which yield in their planes alone");
  view.refuse({"columns"}, "is not for buildings in plan, whose columns are not struck");
  GenericPlan generic{.along_x = read_cantilever(view, units), .period_y = view.number("period_y")};
  generic.torsion_ratio = view.number("torsion_ratio").value_or(1);
  if (view.has("eccentricity")) {
    const std::vector<double> pair = view.numbers("eccentricity");
    if (pair.size() == 2) generic.eccentricity = {pair[0], pair[1]};
  }
  return generic;
}

void read_displacements(const TomlView& given, ReadBuilding& building) {
  const auto table = TableView::of(given, displacements_keys());
  building.spec.structure = DisplacementsSpec{};  // whatever is wrong with it
  if (!table) return;
  const TableView& view = *table;
  DisplacementsSpec known;
  known.elevations = view.numbers("elevations");
  const bool ascends = std::adjacent_find(known.elevations.begin(), known.elevations.end(), std::greater_equal<>()) ==
                       known.elevations.end();
  if (!ascends) view.find("elevations")->error("must ascend");
  known.displacements = view.numbers("u", known.elevations.size());
  known.amplification = view.number("amplification").value_or(1);
  known.period = view.number("period");
  known.damping_ratio = view.number("damping_ratio").value_or(0);
  if (known.period && !view.has("damping_ratio"))
    view.error_missing("damping_ratio", "DDC combines it with the period");
  if (!view.has("period")) view.refuse({"damping_ratio"}, "goes with period, which is not given");
  building.modes = 1;
  if (ascends) building.elevations = known.elevations;
  building.spec.structure = std::move(known);
}

void read_rigid(const TableView& view, ReadBuilding& building) {
  RigidSpec rigid;
  rigid.elevations = view.numbers("elevations");
  if (std::adjacent_find(rigid.elevations.begin(), rigid.elevations.end(), std::greater_equal<>()) !=
      rigid.elevations.end()) {
    view.find("elevations")->error("must ascend");
  } else {
    building.elevations = rigid.elevations;
  }
  building.spec.structure = std::move(rigid);
}

}  // namespace bentur
