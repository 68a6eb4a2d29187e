#include "bentur/io/case/parameter_units.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bentur/core/number_text.h"
#include "bentur/io/toml/toml_view.h"
#include "bentur/model/quantities.h"

namespace bentur {
namespace {

/// The unit of a key, by the table it stands in ("*": any; the first that fits counts): L length, F force; mass is
/// F s2 L-1.
struct KeyUnit {
  const char* table;
  const char* key;
  const char* units;
};

constexpr const char* mass = "F s2 L-1";

const KeyUnit key_units[] = {
    {"units", "gravity", "L s-2"},
    {"gap", "width", "L"},
    {"gap", "elevations", "L"},
    {"gap", "level_tolerance", "L"},
    {"building", "width", "L"},
    {"building", "damping", "1"},
    {"building", "calibrate_period", "s"},
    {"building", "base_elevation", "L"},
    {"building", "elevations", "L"},
    {"building", "gravity_loads", "F"},
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
    {"foundation", "mass", mass},
    {"foundation", "inertia", "F s2 L"},
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
    {"half_space", "shear_wave_velocity", "L s-1"},
    {"half_space", "poisson", "1"},
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
    {"modal", "shapes", "1"},
    {"generic", "storeys", "1"},
    {"isolation", "damping", "F s L-1"},
    {"*", "radius", "L"},
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
    {"analysis", "collapse_drift", "1"},
    {"limits", "steps", "1"},
};

constexpr const char* hertz_stiffness = "F L-1.5";  // UDUNITS has no such powers

/// A contact's stiffness [force/length], or of Hertz's laws [force/length^1.5].
std::string stiffness_form(ParameterPath path, const TomlValue& root) {
  while (!path.empty() && path.back() != PathStep("contact")) path.pop_back();
  path.emplace_back("law");
  const TomlValue* law = find_value(root, path);
  if (law == nullptr) return "";
  const bool hertz = law->text == "hertz" || law->text == "hertz-damp" || law->text == "jankowski";
  return hertz ? hertz_stiffness : "F L-1";
}

std::string form_of(const ParameterPath& path, const TomlValue& root) {
  std::vector<std::string> keys;
  for (const PathStep& step : path) {
    if (const auto* key = std::get_if<std::string>(&step)) keys.push_back(*key);
  }
  if (keys.size() < 2) return "";
  const std::string& table = keys[keys.size() - 2];
  const std::string& key = keys.back();
  if (table == "contact" && key == "stiffness") return stiffness_form(path, root);
  for (const KeyUnit& known : key_units) {
    const std::string known_table = known.table;
    const std::string known_key = known.key;
    if ((known_table == "*" || known_table == table) && (known_key == "*" || known_key == key)) return known.units;
  }
  return "";
}

/// What a number of this form is to be multiplied by where a unit of length is `length` new ones and one of force
/// `force`.
double factor_of(const std::string& form, double length, double force) {
  double factor = 1;
  for (std::size_t at = 0; at < form.size();) {
    const std::size_t end = std::min(form.find(' ', at), form.size());
    double power = 1;
    if (end > at + 1) from_chars(form.data() + at + 1, form.data() + end, power);
    if (form[at] == 'L') factor *= std::pow(length, power);
    if (form[at] == 'F') factor *= std::pow(force, power);
    at = end + 1;
  }
  return factor;
}

/// A number of at most 13 digits; of 10 where these say as much.
std::string digits_of(double value, bool is_real) {
  double few = 0;
  std::string text = fmt::format("{:.10g}", value);
  from_chars(text.data(), text.data() + text.size(), few);
  if (!(std::abs(few - value) <= 2e-12 * std::abs(value))) text = fmt::format("{:.13g}", value);
  if (is_real && text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

/// A piece of a text and what comes in its place.
struct Change {
  std::size_t from, to;
  std::string with;
};

class TextInUnits {
 public:
  TextInUnits(const std::string& text, const TomlValue& root, double length, double force)
      : text_(text), root_(root), length_(length), force_(force) {
    lines_.push_back(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;) lines_.push_back(++at);
  }

  void convert(const TomlValue& value, ParameterPath& path) {
    for (const TomlMember& member : value.members) {
      path.emplace_back(member.key);
      convert(member.value, path);
      path.pop_back();
    }
    for (std::size_t i = 0; i < value.items.size(); ++i) {
      path.emplace_back(i);
      convert(value.items[i], path);
      path.pop_back();
    }
    if (!value.is_number() || !std::isfinite(value.real)) return;
    const double factor = factor_of(form_of(path, root_), length_, force_);
    if (factor == 1) return;
    const std::size_t from = place(value);
    const std::size_t to = std::min(text_.find_first_of(" \t\r\n,]}#", from), text_.size());
    changes_.push_back({from, to, digits_of(factor * value.real, value.kind == TomlValue::Kind::real)});
  }

  /// A word of [units]; where it is not there yet it comes before the first key there, or in a table of its own.
  void put_unit(const std::string& key, const std::string& word) {
    const TomlValue* units = root_.find("units");
    const TomlValue* old = units == nullptr ? nullptr : units->find(key);
    if (old != nullptr) {
      const std::size_t from = place(*old);
      changes_.push_back({from, text_.find(text_[from], from + 1) + 1, fmt::format("\"{}\"", word)});
    } else if (units == nullptr) {
      missing_ += fmt::format("{} = \"{}\"\n", key, word);
    } else if (units->members.empty()) {
      const std::size_t end = std::min(text_.find('\n', place(*units)), text_.size() - 1) + 1;
      changes_.push_back({end, end, fmt::format("{} = \"{}\"\n", key, word)});
    } else {
      // Before the first key that there is: on a line of its own, dotted as that one is, or in braces.
      const std::size_t from = place(units->members.front());
      const std::size_t line = lines_[static_cast<std::size_t>(units->members.front().line - 1)];
      const std::size_t before = text_.find_last_not_of(" \t", from - 1);
      const std::string made = fmt::format("{} = \"{}\"", key, word);
      if (from > line && before >= line && text_[before] == '.') {
        changes_.push_back({line, line, "units." + made + "\n"});
      } else {
        changes_.push_back({from, from, made + (from == line || before < line ? "\n" : ", ")});
      }
    }
  }

  std::string text() {
    if (!missing_.empty()) {  // before the first table that has a line of its own: keys before it belong to none
      std::size_t at = text_.size();
      for (const TomlMember& member : root_.members) {
        const std::size_t line = lines_[static_cast<std::size_t>(std::max(member.line, 1) - 1)];
        if (text_.find_first_not_of(" \t", line) == text_.find('[', line)) at = std::min(at, line);
      }
      changes_.push_back({at, at, fmt::format("{}[units]\n{}\n", at == text_.size() ? "\n" : "", missing_)});
    }
    std::stable_sort(changes_.begin(), changes_.end(),
                     [](const Change& a, const Change& b) { return a.from > b.from; });
    std::string made = text_;
    for (const Change& change : changes_) made.replace(change.from, change.to - change.from, change.with);
    return made;
  }

 private:
  /// Columns count characters; a byte that goes on with one has the bits 10.
  [[nodiscard]] std::size_t place(int line, int column) const {
    std::size_t at = lines_[static_cast<std::size_t>(line - 1)];
    for (int k = 1; k < column; ++k) {
      do {
        ++at;
      } while (at < text_.size() && (static_cast<unsigned char>(text_[at]) & 0xC0U) == 0x80U);
    }
    return at;
  }
  template <typename Value>
  [[nodiscard]] std::size_t place(const Value& value) const {
    return place(value.line, value.column);
  }

  const std::string& text_;
  const TomlValue& root_;
  const double length_, force_;
  std::vector<std::size_t> lines_;
  std::vector<Change> changes_;
  std::string missing_;
};

/// The unit that a case states, or the default; nothing where it is none.
std::optional<std::string> stated_unit(const TomlValue& root, const std::string& key, const std::string& otherwise,
                                       const std::vector<std::string>& known, const std::string& file,
                                       Diagnostics& diagnostics) {
  const TomlValue* units = root.find("units");
  const TomlValue* value = units == nullptr ? nullptr : units->find(key);
  if (value == nullptr) return otherwise;
  if (std::find(known.begin(), known.end(), value->text) != known.end()) return value->text;
  return TomlView(*value, key_path("units", key), file, diagnostics).as_word(known);
}

}  // namespace

std::optional<std::string> text_in_units(const std::string& text, const std::string& file, const std::string& length,
                                         const std::string& force, Diagnostics& diagnostics) {
  const double metre = metres(length), newton = newtons(force);
  const std::optional<TomlValue> root = parse_toml(text, file, diagnostics);
  if (!root) return std::nullopt;
  const auto old_length = stated_unit(*root, "length", "m", length_units(), file, diagnostics);
  const auto old_force = stated_unit(*root, "force", "N", force_units(), file, diagnostics);
  if (!old_length || !old_force) return std::nullopt;
  TextInUnits made(text, *root, metres(*old_length) / metre, newtons(*old_force) / newton);
  ParameterPath path;
  made.convert(*root, path);
  if (*old_length != length) made.put_unit("length", length);
  if (*old_force != force) made.put_unit("force", force);
  return made.text();
}

std::string parameter_units(const ParameterPath& path, const TomlValue& root, const Units& units) {
  const std::string form = form_of(path, root);
  return form == hertz_stiffness ? "" : udunits(form, units);
}

}  // namespace bentur
