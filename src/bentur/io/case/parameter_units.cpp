#include "bentur/io/case/parameter_units.h"

#include <vector>

#include "bentur/model/quantities.h"

namespace bentur {
namespace {

/// The unit of a key, by the table it stands in ("*": any): L length, F force; mass is F s2 L-1.
struct KeyUnit {
  const char* table;
  const char* key;
  const char* units;
};

constexpr const char* mass = "F s2 L-1";

const KeyUnit key_units[] = {
    {"gap", "width", "L"},
    {"gap", "elevations", "L"},
    {"gap", "level_tolerance", "L"},
    {"building", "width", "L"},
    {"building", "damping", "1"},
    {"building", "calibrate_period", "s"},
    {"building", "base_elevation", "L"},
    {"damping", "modal", "1"},
    {"damping", "mass_proportional", "1"},
    {"damping", "stiffness_proportional", "1"},
    {"rayleigh", "ratios", "1"},
    {"rayleigh", "periods", "s"},
    {"frame", "elastic_modulus", "F L-2"},
    {"frame", "floor_masses", mass},
    {"floor_load", "pressure", "F L-2"},
    {"floor_load", "width", "L"},
    {"*", "storey_heights", "L"},
    {"*", "bay_widths", "L"},
    {"columns", "width", "L"},
    {"columns", "depth", "L"},
    {"beams", "width", "L"},
    {"beams", "depth", "L"},
    {"*", "area", "L2"},
    {"*", "inertia", "L4"},
    {"columns", "mass", mass},
    {"beams", "mass", mass},
    {"*", "density", "F s2 L-4"},
    {"*", "unit_weight", "F L-3"},
    {"stick", "masses", mass},
    {"stick", "stiffnesses", "F L-1"},
    {"stick", "yield_forces", "F"},
    {"stick", "hardening", "1"},
    {"stick", "unloading_exponent", "1"},
    {"modal", "elevations", "L"},
    {"modal", "masses", mass},
    {"modal", "periods", "s"},
    {"generic", "storey_height", "L"},
    {"generic", "floor_mass", mass},
    {"generic", "period", "s"},
    {"generic", "stiffness_ratio", "1"},
    {"generic", "yield_base_shear", "1"},
    {"generic", "hardening", "1"},
    {"isolation", "mass", mass},
    {"isolation", "stiffness", "F L-1"},
    {"isolation", "characteristic_strength", "F"},
    {"*", "yield_displacement", "L"},
    {"friction_pendulum", "coefficient", "1"},
    {"friction_pendulum", "radius", "L"},
    {"half_space", "shear_wave_velocity", "L s-1"},
    {"half_space", "poisson", "1"},
    {"half_space", "radius", "L"},
    {"foundation", "mass", mass},
    {"foundation", "inertia", "F s2 L"},
    {"sway", "stiffness", "F L-1"},
    {"sway", "damping", "F s L-1"},
    {"rocking", "stiffness", "F L"},
    {"rocking", "damping", "F L s"},
    {"column_capacity", "shear", "F"},
    {"column_capacity", "moment", "F L"},
    {"matrices", "elevations", "L"},
    {"matrices", "mass", mass},
    {"matrices", "stiffness", "F L-1"},
    {"matrices", "damping", "F s L-1"},
    {"link", "elevations", "L"},
    {"link", "level_tolerance", "L"},
    {"link", "stiffness", "F L-1"},
    {"link", "damping", "F s L-1"},
    {"link", "yield_force", "F"},
    {"link", "hardening", "1"},
    {"link", "slack", "L"},
    {"contact", "second_stiffness", "F L-1"},
    {"contact", "yield_penetration", "L"},
    {"contact", "restitution", "1"},
    {"contact", "damping_ratio", "1"},
    {"contact", "damping_factor", "1"},
    {"contact", "damping", "F s L-1"},
    {"contact", "alpha", "s L-1"},
    {"excitation", "time_step", "s"},
    {"excitation", "pga", "L s-2"},
    {"excitation", "scale", "1"},
    {"excitation", "period", "s"},
    {"excitation", "displacement_amplitude", "L"},
    {"excitation", "acceleration_amplitude", "L s-2"},
    {"excitation", "delays", "s"},
    {"excitation", "wave_velocity", "L s-1"},
    {"displacements", "*", "L"},
    {"velocities", "*", "L s-1"},
    {"analysis", "duration", "s"},
    {"analysis", "step", "s"},
    {"analysis", "tolerance", "1"},
    {"analysis", "output_step", "s"},
    {"limits", "steps", "1"},
};

/// A contact's stiffness [force/length], or of Hertz's laws [force/length^1.5]; UDUNITS has no such powers.
std::string stiffness_units(ParameterPath path, const TomlValue& root) {
  while (!path.empty() && path.back() != PathStep("contact")) path.pop_back();
  path.emplace_back("law");
  const TomlValue* law = find_value(root, path);
  if (law == nullptr) return "";
  const bool hertz = law->text == "hertz" || law->text == "hertz-damp" || law->text == "jankowski";
  return hertz ? "" : "F L-1";
}

std::string form_of(const ParameterPath& path, const TomlValue& root) {
  std::vector<std::string> keys;
  for (const PathStep& step : path) {
    if (const auto* key = std::get_if<std::string>(&step)) keys.push_back(*key);
  }
  if (keys.size() < 2) return "";
  const std::string& table = keys[keys.size() - 2];
  const std::string& key = keys.back();
  if (table == "contact" && key == "stiffness") return stiffness_units(path, root);
  for (const KeyUnit& known : key_units) {
    const std::string known_table = known.table;
    const std::string known_key = known.key;
    if ((known_table == "*" || known_table == table) && (known_key == "*" || known_key == key)) return known.units;
  }
  return "";
}

}  // namespace

std::string parameter_units(const ParameterPath& path, const TomlValue& root, const Units& units) {
  return udunits(form_of(path, root), units);
}

}  // namespace bentur
