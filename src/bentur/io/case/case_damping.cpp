#include <algorithm>
#include <cmath>

#include "bentur/io/case/case_parts.h"

namespace bentur {
namespace {

Damping read_rayleigh(const TomlView& view) {
  RayleighDamping damping;
  if (!view.is_table_of({"ratios", "periods"})) return damping;
  damping.ratios = view.numbers("ratios", Rule::share, {2, "for two modes"});
  const auto periods = view.get("periods");
  if (periods) damping.periods = periods->as_numbers(Rule::positive, {2, "of two modes"});
  if (damping.periods.size() == 2 && damping.periods[0] == damping.periods[1])
    periods->error("must be two different periods");
  return damping;
}

/// Whether some storey can yield, as far as it was read.
bool some_storey_yields(const BuildingSpec& spec) {
  const auto* stick = std::get_if<Stick>(&spec.structure);
  return stick != nullptr && std::any_of(stick->yield_forces.begin(), stick->yield_forces.end(),
                                         [](double force) { return std::isfinite(force); });
}

/// Whether a stiffness part is there, and is one that a storey's dashpot can be made of; an error unless it is.
void check_stiffness_part(const TomlView& word, const Damping& damping, bool tangent) {
  if (const auto* rayleigh = std::get_if<RayleighDamping>(&damping)) {
    const bool whole =
        rayleigh->ratios.size() == 2 && rayleigh->periods.size() == 2 && rayleigh->periods[0] != rayleigh->periods[1];
    if (tangent && whole && *stiffness_part(damping, 1) < 0) {
      word.error_value(
          "needs a stiffness part that is not negative: these ratios at these periods make it so; give a larger ratio "
          "at the shorter period");
    }
  } else if (!std::holds_alternative<StiffnessProportionalDamping>(damping)) {
    word.error_value("needs damping with a stiffness part: rayleigh or stiffness_proportional");
  }
}

}  // namespace

Damping read_damping(const TomlView& view, std::size_t modes) {
  if (view.is_number()) return ModalDamping{{view.as_number(Rule::share).value_or(0)}};
  const std::vector<std::string> forms = {"modal", "rayleigh", "mass_proportional", "stiffness_proportional"};
  if (!view.is(TomlValue::Kind::table)) {
    view.error_value("must be a number or a table of modal, rayleigh, mass_proportional or stiffness_proportional");
    return ModalDamping{};
  }
  (void)view.is_table_of(forms);
  const auto form = view.exactly_one(forms);
  if (form == "modal") return ModalDamping{view.numbers("modal", Rule::share, {modes, "one per mode"})};
  if (form == "rayleigh") return read_rayleigh(*view.find("rayleigh"));
  if (form == "mass_proportional")
    return MassProportionalDamping{view.number("mass_proportional", Rule::share).value_or(0)};
  if (form == "stiffness_proportional")
    return StiffnessProportionalDamping{view.number("stiffness_proportional", Rule::share).value_or(0)};
  return ModalDamping{};
}

void read_damping_stiffness(const TomlView& view, ReadBuilding& building) {
  const auto word = view.find("damping_stiffness");
  if (!word) return;
  const auto choice = word->as_word({"initial", "tangent"});
  if (choice != "initial" && choice != "tangent") return;
  building.spec.tangent_damping = choice == "tangent";
  check_stiffness_part(*word, building.spec.damping, choice == "tangent");
  const auto stick = view.find("stick");
  const bool yields = stick && stick->is(TomlValue::Kind::table) && stick->has("yield_forces");
  // Yield forces that could not be read have been reported.
  const auto* read = std::get_if<Stick>(&building.spec.structure);
  const bool unread = yields && (read == nullptr || read->yield_forces.empty());
  if (!unread && !some_storey_yields(building.spec)) {
    word->error_value("needs storeys that can yield: stick.yield_forces");
  }
}

}  // namespace bentur
