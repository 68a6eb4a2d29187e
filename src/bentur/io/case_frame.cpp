#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bentur/io/case_parts.h"

namespace bentur {
namespace {

/// A section as given: its mass is that of the whole member, or a density times area and length.
struct GivenSection {
  double area = 0;     ///< [length²]
  double inertia = 0;  ///< [length⁴]
  double mass = 0;     ///< [mass]
  double density = 0;  ///< [mass/length³]
  bool by_density = false;
};

/// The member's second moment about the axis normal to the frame: width · depth³/12, depth in the plane of the frame.
void read_shape(const TomlView& view, GivenSection& section) {
  const bool rectangle = view.has("width") || view.has("depth");
  const bool properties = view.has("area") || view.has("inertia");
  if (rectangle == properties) {
    view.error("needs either width and depth, or area and inertia");
    return;
  }
  const auto first = view.number(rectangle ? "width" : "area", Rule::positive);
  const auto second = view.number(rectangle ? "depth" : "inertia", Rule::positive);
  if (!first || !second) return;
  section.area = rectangle ? *first * *second : *first;
  section.inertia = rectangle ? section.area * *second * *second / 12 : *second;
  if (!(std::isfinite(section.inertia) && section.area > 0 && section.inertia > 0)) {
    view.error("has a section too large or too small to compute with");
  }
}

GivenSection read_section(const TomlView& view, double gravity) {
  GivenSection section;
  if (!view.is_table_of({"width", "depth", "area", "inertia", "mass", "density", "unit_weight"})) return section;
  read_shape(view, section);
  const auto basis = view.exactly_one({"mass", "density", "unit_weight"});
  if (!basis) return section;
  const double amount = view.number(*basis, Rule::not_negative).value_or(0);
  section.by_density = *basis != "mass";
  section.mass = section.by_density ? 0 : amount;
  section.density = *basis == "unit_weight" ? amount / gravity : section.by_density ? amount : 0;
  return section;
}

/// One section for each of `lengths`, from a list of one for all or one for each. @param each "one per storey".
std::vector<Section> read_sections(const TomlView& frame, const std::string& key, const std::vector<double>& lengths,
                                   const std::string& each, double gravity, bool lengths_serve) {
  const auto list = frame.get(key, Need::required);
  if (!list || !list->is_list_of("sections")) return {};
  if (!lengths.empty() && list->size() != 1 && list->size() != lengths.size()) {
    list->error(fmt::format("has {} entries, expected 1 or {} ({})", list->size(), lengths.size(), each));
  }
  std::vector<GivenSection> given;
  for (std::size_t i = 0; i < list->size(); ++i) {
    given.push_back(read_section(list->item(i), gravity));
    if (given.back().by_density && !lengths_serve) {
      list->item(i).error(
          "needs mass (of one member) in place of density or unit_weight, because the bays differ in width");
    }
  }
  std::vector<Section> sections;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const GivenSection& one = given[std::min(i, given.size() - 1)];
    sections.push_back({one.area, one.inertia, one.by_density ? one.density * one.area * lengths[i] : one.mass});
  }
  return sections;
}

/// Every floor needs a mass, and joint rotations that are kept need a member with mass at each floor.
void check_masses(const TomlView& view, const PlaneFrame& frame) {
  const std::size_t floors = frame.storey_heights.size();
  if (frame.columns.size() != floors || frame.beams.size() != floors) return;
  const auto member_mass = [&](std::size_t i) {
    return frame.columns[i].mass + frame.beams[i].mass + (i + 1 < floors ? frame.columns[i + 1].mass : 0);
  };
  bool some = false;
  bool all = true;
  for (std::size_t i = 0; i < floors; ++i) {
    const double extra = i < frame.floor_masses.size() ? frame.floor_masses[i] : 0;
    if (!(member_mass(i) + extra > 0)) view.error(fmt::format("has no mass at floor {}", i + 1));
    some = some || member_mass(i) > 0;
    all = all && member_mass(i) > 0;
  }
  if (frame.condensation == Condensation::none && frame.mass_matrix == MassMatrix::consistent && some && !all) {
    view.error("keeps joint rotations (condensation = \"none\"), so each floor needs a column or beam with mass");
  }
}

}  // namespace

void read_frame(const TomlView& view, double gravity, ReadBuilding& building) {
  building.is_frame = true;
  if (!view.is_table_of({"elastic_modulus", "storey_heights", "bay_widths", "columns", "beams", "floor_masses",
                         "mass_matrix", "condensation", "base_coupling"})) {
    return;
  }
  PlaneFrame frame;
  frame.elastic_modulus = view.number("elastic_modulus", Rule::positive).value_or(0);
  frame.storey_heights = view.numbers("storey_heights", Rule::positive).value_or(std::vector<double>{});
  frame.bay_widths = view.numbers("bay_widths", Rule::positive).value_or(std::vector<double>{});

  // A beam's length is that of the bays, where they are all the same.
  const auto [least, most] = std::minmax_element(frame.bay_widths.begin(), frame.bay_widths.end());
  const bool equal_bays = frame.bay_widths.empty() || *most - *least <= 1e-9 * *most;
  const std::size_t storeys = frame.storey_heights.size();
  frame.columns = read_sections(view, "columns", frame.storey_heights, "one per storey", gravity, true);
  frame.beams = read_sections(view, "beams", std::vector<double>(storeys, frame.bay_widths.empty() ? 0 : *least),
                              "one per floor", gravity, equal_bays);
  frame.floor_masses = view.numbers("floor_masses", Rule::not_negative, {storeys, "one per floor"}, Need::optional)
                           .value_or(std::vector<double>(storeys, 0.0));

  const auto mass_matrix = view.word("mass_matrix", {"consistent", "lumped"}, Need::optional);
  if (mass_matrix == "lumped") frame.mass_matrix = MassMatrix::lumped;
  const auto condensation = view.word("condensation", {"static", "dynamic", "none"}, Need::optional);
  if (condensation == "dynamic") frame.condensation = Condensation::dynamic;
  if (condensation == "none") frame.condensation = Condensation::none;
  frame.base_coupling = view.flag("base_coupling", Need::optional).value_or(true);

  if (storeys > 0) {
    check_masses(view, frame);
    building.floors = building.modes = storeys;
    // Lumped masses, or none at all on members, leave rotations massless, so that they are condensed anyway.
    const auto has_mass = [](const Section& section) { return section.mass > 0; };
    const bool rotary = frame.mass_matrix == MassMatrix::consistent &&
                        (std::any_of(frame.columns.begin(), frame.columns.end(), has_mass) ||
                         std::any_of(frame.beams.begin(), frame.beams.end(), has_mass));
    if (frame.condensation == Condensation::none && rotary) {
      building.modes = frame.bay_widths.empty() ? 0 : storeys * (frame.bay_widths.size() + 2);
    }
    building.elevations.resize(storeys);
    std::partial_sum(frame.storey_heights.begin(), frame.storey_heights.end(), building.elevations.begin());
  }
  if (!frame.bay_widths.empty()) {
    building.spec.width = std::accumulate(frame.bay_widths.begin(), frame.bay_widths.end(), 0.0);
  }
  building.spec.structure = std::move(frame);
}

}  // namespace bentur
