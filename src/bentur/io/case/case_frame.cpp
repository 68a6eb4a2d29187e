#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"
#include "bentur/structure/frame/infill.h"

namespace bentur {
namespace {

/// The member's second moment about the axis normal to the frame: width · depth³/12, depth in the plane of the frame.
void read_shape(const TableView& view, Section& section) {
  const bool rectangle = view.has("width") || view.has("depth");
  const bool properties = view.has("area") || view.has("inertia");
  if (rectangle == properties) {
    view.error("needs either width and depth, or area and inertia");
    return;
  }
  for (const std::string key : {rectangle ? "width" : "area", rectangle ? "depth" : "inertia"}) {
    if (!view.has(key)) view.error_missing(key);
  }
  const auto first = view.number(rectangle ? "width" : "area");
  const auto second = view.number(rectangle ? "depth" : "inertia");
  if (!first || !second) return;
  section.area = rectangle ? *first * *second : *first;
  section.inertia = rectangle ? section.area * *second * *second / 12 : *second;
  if (!(std::isfinite(section.inertia) && section.area > 0 && section.inertia > 0)) {
    view.error("has a section too large or too small to compute with");
  }
}

/// How its hinges lose strength.
void read_backbone(const TableView& view, HingeBackbone& backbone) {
  const auto table = view.table("backbone");
  if (!table) return;
  backbone.plastic = table->number("plastic_rotation").value_or(backbone.plastic);
  backbone.softening = table->number("softening_rotation").value_or(backbone.softening);
  backbone.residual = table->number("residual").value_or(0);
  backbone.ultimate = table->number("ultimate_rotation").value_or(backbone.ultimate);
  if (table->has("ultimate_rotation") && std::isfinite(backbone.plastic) && backbone.ultimate <= backbone.plastic) {
    table->get("ultimate_rotation")->error_value("must be beyond plastic_rotation");
  }
  backbone.wear = table->number("strength_wear").value_or(backbone.wear);
  if (!table->has("strength_wear")) table->refuse({"wear_exponent"}, "goes with strength_wear, which is not given");
  backbone.wear_exponent = table->number("wear_exponent").value_or(1);
  if (!(backbone.wear_exponent >= 1 && backbone.wear_exponent <= 2)) {
    table->get("wear_exponent")->error_value("must be in [1, 2]");
  }
}

/// Where its ends yield. @param lines of columns; 0: it is a beam
void read_hinges(const TableView& view, std::size_t lines, Section& section) {
  const auto capacity = view.get("moment_capacity");
  if (!capacity) {
    for (const std::string key : {"hardening", "rotation_limits", "backbone"}) {
      view.refuse({key}, "goes with moment_capacity, which is not given");
    }
  }
  section.moment_capacity = view.numbers("moment_capacity");
  const std::size_t given = section.moment_capacity.size();
  const bool of_lines = lines > 0;
  if (given > 1 && given != (of_lines ? lines : 2)) {
    capacity->error(fmt::format("has {} entries, must be a number or {}", given,
                                of_lines ? fmt::format("have one per column line ({})", lines) : "[sagging, hogging]"));
  }
  section.hardening = view.number("hardening").value_or(0);
  section.rotation_limits = view.numbers("rotation_limits", 3);
  if (!std::is_sorted(section.rotation_limits.begin(), section.rotation_limits.end(), std::less_equal<>())) {
    view.get("rotation_limits")->error("must be three numbers > 0 in ascending order");
  }
  if (capacity) read_backbone(view, section.backbone);
  section.line_load = view.number("line_load").value_or(0);
  if (of_lines) view.refuse({"line_load"}, "only beams carry it");
}

/// Where it breaks. @param lines as read_hinges() takes it
void read_shear(const TableView& view, std::size_t lines, Section& section) {
  if (lines == 0) {
    view.refuse({"shear_capacity", "residual_shear"}, "only columns break");
    return;
  }
  const auto capacity = view.get("shear_capacity");
  if (!capacity) view.refuse({"residual_shear"}, "goes with shear_capacity, which is not given");
  section.shear_capacity = view.numbers("shear_capacity");
  const std::size_t given = section.shear_capacity.size();
  if (given > 1 && given != lines) {
    capacity->error(fmt::format("has {} entries, must be a number or have one per column line ({})", given, lines));
  }
  section.residual_shear = view.number("residual_shear").value_or(0);
}

/// From a density a member weighs by its own length. @param lines of columns; 0: it is a beam
Section read_section(const TomlView& given, const KeyTable& keys, double gravity, std::size_t lines) {
  Section section;
  const auto view = TableView::of(given, keys);
  if (!view) return section;
  read_shape(*view, section);
  read_hinges(*view, lines, section);
  read_shear(*view, lines, section);
  if (&keys == &plane_section_keys()) {
    if (lines == 0) view->refuse({"density"}, "is of columns, which may be struck");
    section.line_mass = view->number("density").value_or(0) * section.area;
    return section;
  }
  const auto basis = view->exactly_one("weight");
  if (!basis) return section;
  const double amount = view->number(*basis).value_or(0);
  if (*basis == "mass") {
    section.mass = amount;
  } else {
    section.line_mass = (*basis == "unit_weight" ? amount / gravity : amount) * section.area;
  }
  return section;
}

/// One section for each of `count` storeys or floors, from a list of one for all or one for each. @param each "one per
/// storey". @param lines as read_section() takes it
std::vector<Section> read_sections(const TableView& frame, const std::string& key, std::size_t count,
                                   const std::string& each, double gravity, std::size_t lines) {
  const KeyTable& keys = *frame.key(key).table;
  const auto list = frame.get(key);
  if (!list || !list->is_list_of(fmt::format("sections: one for all is {} = [{{ .. }}]", key))) return {};
  if (count > 0 && list->size() != 1 && list->size() != count) {
    list->error(fmt::format("has {} entries, expected 1 or {} ({})", list->size(), count, each));
  }
  std::vector<Section> given;
  for (const TomlView& section : list->items()) given.push_back(read_section(section, keys, gravity, lines));
  std::vector<Section> sections;
  for (std::size_t i = 0; i < count; ++i) sections.push_back(given[std::min(i, given.size() - 1)]);
  return sections;
}

/// Masses of the floors: those given, and of a load per area on a strip of each floor as long as the frame, q w Σ
/// bays/g.
std::vector<double> read_floor_masses(const TableView& view, double gravity, std::size_t floors, double length) {
  std::vector<double> masses = view.numbers_for_each("floor_masses", floors);
  masses.resize(floors);
  const auto load = view.table("floor_load");
  if (!load) return masses;
  const std::vector<double> pressure = load->numbers_for_each("pressure", floors);
  const std::vector<double> width = load->numbers_for_each("width", floors);
  for (std::size_t i = 0; i < masses.size(); ++i) {
    if (i < pressure.size() && i < width.size()) masses[i] += pressure[i] * width[i] * length / gravity;
  }
  if (std::any_of(masses.begin(), masses.end(), [](double mass) { return !std::isfinite(mass); })) {
    load->error("is too large to compute with");
  }
  return masses;
}

/// Every floor needs a mass, and joint rotations that are kept need a member with mass at each floor.
void check_masses(const TomlView& view, const PlaneFrame& frame) {
  const std::size_t floors = frame.storey_heights.size();
  if (frame.columns.size() != floors || frame.beams.size() != floors) return;
  const auto has_mass = [](const Section& section) { return section.mass + section.line_mass > 0; };
  const auto some_member = [&](std::size_t i) {
    return has_mass(frame.columns[i]) || has_mass(frame.beams[i]) || (i + 1 < floors && has_mass(frame.columns[i + 1]));
  };
  bool some = false;
  bool all = true;
  for (std::size_t i = 0; i < floors; ++i) {
    const double extra = i < frame.floor_masses.size() ? frame.floor_masses[i] : 0;
    if (!some_member(i) && !(extra > 0)) view.error(fmt::format("has no mass at floor {}", i + 1));
    some = some || some_member(i);
    all = all && some_member(i);
  }
  if (frame.condensation == Condensation::none && frame.mass_matrix == MassMatrix::consistent && some && !all) {
    view.error("keeps joint rotations (condensation = \"none\"), so each floor needs a column or beam with mass");
  }
}

/// What fills the bays of one storey; nothing: it is open.
std::optional<Infill> read_infill(const TomlView& given) {
  const auto table = TableView::of(given, infill_keys());
  if (!table) return std::nullopt;
  const TableView& view = *table;
  const bool masonry = view.has("thickness"), numbers = view.has("stiffness");
  const std::vector<std::string> of_masonry = {"modulus", "strength", "sliding_strength"};
  if (!masonry) view.refuse(of_masonry, "goes with thickness, which is not given");
  if (!numbers) view.refuse({"yield"}, "goes with stiffness, which is not given");
  if (masonry && numbers) {
    view.get("stiffness")->error("does not go with thickness, from which it follows");
    return std::nullopt;
  }
  if (!masonry && !numbers) {
    view.refuse({"cap", "plastic_drift", "softening_drift", "residual", "ultimate_drift"},
                "goes with thickness or stiffness: without them the storey is open");
    return std::nullopt;
  }
  const std::vector<std::string> needed =
      masonry ? std::vector<std::string>{"modulus", "strength"} : std::vector<std::string>{"yield"};
  for (const std::string& key : needed) {
    if (!view.has(key)) view.error_missing(key);
  }
  Infill infill;
  infill.thickness = view.number("thickness").value_or(0);
  infill.modulus = view.number("modulus").value_or(0);
  infill.strength = view.number("strength").value_or(0);
  infill.sliding_strength = view.number("sliding_strength").value_or(infill.sliding_strength);
  infill.stiffness = view.number("stiffness").value_or(0);
  Backbone& backbone = infill.backbone;
  backbone.yield = view.number("yield").value_or(0);
  backbone.cap = view.number("cap").value_or(1);
  backbone.plastic = view.number("plastic_drift").value_or(backbone.plastic);
  backbone.softening = view.number("softening_drift").value_or(backbone.softening);
  backbone.residual = view.number("residual").value_or(0);
  backbone.ultimate = view.number("ultimate_drift").value_or(backbone.ultimate);
  if (view.has("cap") && backbone.cap < 1) view.get("cap")->error_value("must be >= 1");
  if (!view.has("plastic_drift")) {
    if (backbone.cap > 1) view.get("cap")->error("needs plastic_drift, the way from yielding to it");
    view.refuse({"softening_drift"}, "goes with plastic_drift, which is not given");
  }
  return infill;
}

/// Of every storey; empty: none has any.
std::vector<std::optional<Infill>> read_infills(const TableView& frame, std::size_t storeys) {
  std::vector<std::optional<Infill>> infills;
  if (!frame.has("infill")) return infills;
  const auto list = frame.get("infill");
  if (!list || !list->is_list_of("tables: one for all is infill = [{ .. }]")) return infills;
  if (storeys > 0 && list->size() != 1 && list->size() != storeys) {
    list->error(fmt::format("has {} entries, expected 1 or {} (one per storey)", list->size(), storeys));
  }
  std::vector<std::optional<Infill>> given;
  for (const TomlView& one : list->items()) given.push_back(read_infill(one));
  if (given.empty()) return infills;
  for (std::size_t j = 0; j < storeys; ++j) infills.push_back(given[std::min(j, given.size() - 1)]);
  return infills;
}

/// Whether members can be computed with.
bool has_right_members(const PlaneFrame& frame) {
  const auto right = [](const Section& section) { return section.area > 0 && section.inertia > 0; };
  return !frame.storey_heights.empty() && !frame.bay_widths.empty() && !frame.columns.empty() && !frame.beams.empty() &&
         frame.elastic_modulus > 0 && std::all_of(frame.columns.begin(), frame.columns.end(), right) &&
         std::all_of(frame.beams.begin(), frame.beams.end(), right);
}

/// Whether where they yield and break can be computed with; else it has been said. @param most of a list of capacities
bool have_right_capacities(const std::vector<Section>& sections, std::size_t most) {
  const auto list = [&](const std::vector<double>& capacities) {
    return (capacities.size() <= 1 || capacities.size() == most) &&
           std::all_of(capacities.begin(), capacities.end(), [](double one) { return one > 0; });
  };
  const auto share = [](double one) { return one >= 0 && one < 1; };
  return std::all_of(sections.begin(), sections.end(), [&](const Section& one) {
    const HingeBackbone& backbone = one.backbone;
    return list(one.moment_capacity) && list(one.shear_capacity) && share(one.hardening) && share(one.residual_shear) &&
           one.line_load >= 0 && share(backbone.residual) && backbone.plastic > 0 && backbone.softening > 0 &&
           backbone.ultimate > 0;
  });
}

/// What follows from columns, beams and infill together; what is wrong of a value alone has been said. @return whether
/// all of it is right
bool check_infills(const TableView& view, const PlaneFrame& frame) {
  bool right = true;
  const std::vector<TomlView> given = view.get("infill")->items();
  for (std::size_t j = 0; j < frame.infills.size(); ++j) {
    PlaneFrame one = frame;
    for (std::size_t i = 0; i < one.infills.size(); ++i) {
      if (i != j) one.infills[i].reset();
    }
    try {
      static_cast<void>(infill_panels(one));
    } catch (const InvalidParameter& error) {
      const TomlView& entry = given[std::min(j, given.size() - 1)];
      const bool of_ultimate = error.parameter().ends_with(".ultimate");
      if (of_ultimate) entry.find("ultimate_drift")->error(error.rule());
      if (error.parameter() == indexed("infills", j)) entry.error(error.rule());
      if (given.size() == 1) return false;
      right = false;
    }
  }
  return right;
}

/// What makes a frame's stiffness; its heights are known.
void read_members(const TableView& view, double gravity, PlaneFrame& frame) {
  const std::size_t storeys = frame.storey_heights.size();
  frame.elastic_modulus = view.number("elastic_modulus").value_or(0);
  frame.bay_widths = view.numbers("bay_widths");
  frame.columns = read_sections(view, "columns", storeys, "one per storey", gravity, frame.bay_widths.size() + 1);
  frame.beams = read_sections(view, "beams", storeys, "one per floor", gravity, 0);
}

}  // namespace

bool at_section(const std::optional<TomlView>& columns, const std::optional<TomlView>& beams,
                const InvalidParameter& error) {
  const std::string& parameter = error.parameter();
  if (parameter == "line_load" && beams) {
    for (const TomlView& beam : beams->items()) {
      if (const auto load = beam.find("line_load")) {
        load->error_value(error.rule());
        return true;
      }
    }
  }
  const std::size_t open = parameter.find('['), close = parameter.find("].backbone.");
  if (open == std::string::npos || close == std::string::npos) return false;
  const auto& sections = parameter.substr(0, open) == "beams" ? beams : columns;
  if (!sections) return false;
  const std::vector<TomlView> given = sections->items();
  const std::size_t level = std::stoul(parameter.substr(open + 1, close - open - 1));
  const auto backbone = given[std::min(level, given.size() - 1)].find("backbone");
  if (!backbone) return false;
  if (const auto value = backbone->find(parameter.substr(parameter.rfind('.') + 1))) {
    value->error_value(error.rule());
  } else {
    backbone->error(error.rule());
  }
  return true;
}

bool read_frame_of_plane(const TableView& view, const std::vector<double>& storey_heights,
                         const std::vector<ColumnNode>& nodes, PlanPlane& plane) {
  PlaneFrame frame;
  frame.nodes = nodes;
  frame.storey_heights = storey_heights;
  read_members(view, 1, frame);
  frame.infills = read_infills(view, storey_heights.size());
  if (!has_right_members(frame) || !have_right_capacities(frame.columns, frame.bay_widths.size() + 1) ||
      !have_right_capacities(frame.beams, 2)) {
    return false;
  }
  if (!frame.infills.empty() && !check_infills(view, frame)) return false;
  try {
    stand_frame(frame, plane);
  } catch (const InvalidParameter& error) {
    if (!at_section(view.find("columns"), view.find("beams"), error)) {
      view.error(std::string("cannot be computed with: ") + error.what());
    }
    return false;
  } catch (const std::exception& error) {
    view.error(std::string("cannot be computed with: ") + error.what());
    return false;
  }
  return true;
}

void read_frame(const TomlView& given, double gravity, ReadBuilding& building) {
  building.is_frame = true;
  const auto table = TableView::of(given, frame_keys());
  if (!table) return;
  const TableView& view = *table;
  PlaneFrame frame;
  frame.storey_heights = view.numbers("storey_heights");
  read_members(view, gravity, frame);

  const std::size_t storeys = frame.storey_heights.size();
  const double length = std::accumulate(frame.bay_widths.begin(), frame.bay_widths.end(), 0.0);
  frame.floor_masses = read_floor_masses(view, gravity, storeys, length);

  frame.infills = read_infills(view, storeys);
  if (!frame.infills.empty() && has_right_members(frame)) static_cast<void>(check_infills(view, frame));

  const auto mass_matrix = view.word("mass_matrix");
  if (mass_matrix == "lumped") frame.mass_matrix = MassMatrix::lumped;
  const auto condensation = view.word("condensation");
  if (condensation == "dynamic") frame.condensation = Condensation::dynamic;
  if (condensation == "none") frame.condensation = Condensation::none;
  frame.base_coupling = view.flag("base_coupling");
  const auto yields = [](const Section& section) {
    const auto finite = [](double capacity) { return std::isfinite(capacity); };
    return std::any_of(section.moment_capacity.begin(), section.moment_capacity.end(), finite) ||
           std::any_of(section.shear_capacity.begin(), section.shear_capacity.end(), finite);
  };
  if (frame.condensation == Condensation::dynamic && (std::any_of(frame.columns.begin(), frame.columns.end(), yields) ||
                                                      std::any_of(frame.beams.begin(), frame.beams.end(), yields))) {
    view.get("condensation")->error_value("must be \"static\" or \"none\" where hinges may form or columns break");
  }

  if (storeys > 0) {
    check_masses(view, frame);
    building.modes = storeys;
    // Lumped masses, or none at all on members, leave rotations massless, so that they are condensed anyway.
    const auto has_mass = [](const Section& section) { return section.mass + section.line_mass > 0; };
    const bool rotary = frame.mass_matrix == MassMatrix::consistent &&
                        (std::any_of(frame.columns.begin(), frame.columns.end(), has_mass) ||
                         std::any_of(frame.beams.begin(), frame.beams.end(), has_mass));
    if (frame.condensation == Condensation::none && rotary) {
      building.modes = frame.bay_widths.empty() ? 0 : storeys * (frame.bay_widths.size() + 2);
    }
    building.elevations = floor_elevations(frame.storey_heights);
  }
  if (!frame.bay_widths.empty()) building.spec.width = length;
  building.spec.structure = std::move(frame);
}

}  // namespace bentur
