#include <algorithm>
#include <cmath>

#include "bentur/io/case/case_parts.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"

namespace bentur {
namespace {

Damping read_rayleigh(const TableView& view) {
  RayleighDamping damping;
  damping.ratios = view.numbers("ratios");
  damping.periods = view.numbers("periods");
  if (damping.periods.size() == 2 && damping.periods[0] == damping.periods[1])
    view.find("periods")->error("must be two different periods");
  return damping;
}

/// Whether some storey can yield, as far as it was read.
bool some_storey_yields(const BuildingSpec& spec) {
  const auto* stick = std::get_if<Stick>(&spec.structure);
  if (stick == nullptr) return false;
  const std::vector<double>& forces = stick->backbone ? stick->backbone->positive.yield : stick->yield_forces;
  return std::any_of(forces.begin(), forces.end(), [](double force) { return std::isfinite(force); });
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

Damping read_damping(const TomlView& given, std::size_t modes) {
  if (given.is_number()) return ModalDamping{{given.as_number(building_keys().at("damping").range).value_or(0)}};
  if (!given.is(TomlValue::Kind::table)) {
    given.error_value("must be a number or a table of modal, rayleigh, mass_proportional or stiffness_proportional");
    return ModalDamping{};
  }
  const TableView view = *TableView::of(given, damping_keys());
  const auto form = view.exactly_one("form");
  if (form == "modal") return ModalDamping{view.numbers("modal", modes)};
  if (form == "rayleigh") {
    const auto two = view.table("rayleigh");
    return two ? read_rayleigh(*two) : RayleighDamping{};
  }
  if (form == "mass_proportional") return MassProportionalDamping{view.number(*form).value_or(0)};
  if (form == "stiffness_proportional") return StiffnessProportionalDamping{view.number(*form).value_or(0)};
  return ModalDamping{};
}

void read_damping_stiffness(const TableView& view, ReadBuilding& building) {
  const auto word = view.find("damping_stiffness");
  if (!word) return;
  const auto choice = view.word("damping_stiffness");
  if (choice != "initial" && choice != "tangent") return;
  building.spec.tangent_damping = choice == "tangent";
  check_stiffness_part(*word, building.spec.damping, choice == "tangent");
  const auto stick = view.find("stick");
  const bool yields =
      stick && stick->is(TomlValue::Kind::table) && (stick->has("yield_forces") || stick->has("backbone"));
  // Yield forces that could not be read have been reported.
  const auto* read = std::get_if<Stick>(&building.spec.structure);
  const bool unread = yields && (read == nullptr || (read->yield_forces.empty() && !read->backbone));
  if (!unread && !some_storey_yields(building.spec)) {
    word->error_value("needs storeys that can yield: stick.yield_forces");
  }
}

}  // namespace bentur
