#include <algorithm>
#include <cmath>

#include "bentur/elements/hysteretic_laws.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"

namespace bentur {
namespace {

/// What says how storeys yield.
void read_yielding(const TableView& view, std::size_t storeys, Stick& stick) {
  const auto* const law = view.law("hysteresis", hysteretic_laws(), &OwnLaw::storey, stick.own);
  stick.hardening = view.numbers("hardening", storeys);
  std::vector<std::string> of_yielding = {"hardening", "hysteresis"};
  for (const std::string& name : view.keys().names()) {
    const auto owners = view.keys().owners(name, "hysteresis");
    if (owners.empty()) continue;
    of_yielding.push_back(name);
    const auto number = view.number(name);
    if (number && view.has(name)) stick.law_numbers[name] = *number;
  }
  if (law != nullptr) stick.hysteresis = law->name;
  if (stick.own) view.refuse({"hardening"}, "is not for a law of one's own: its branches say what follows yielding");
  if (view.has("yield_forces")) {
    stick.yield_forces = view.numbers("yield_forces", storeys);
  } else {
    view.refuse(of_yielding, "is of storeys that yield: give yield_forces too, without them all stay elastic");
  }
}

}  // namespace

void read_stick(const TomlView& given, ReadBuilding& building) {
  const auto table = TableView::of(given, stick_keys());
  if (!table) return;
  const TableView& view = *table;
  Stick stick;
  const auto heights = view.find("storey_heights");
  const std::size_t storeys = heights ? heights->size() : 0;
  stick.storey_heights = view.numbers("storey_heights");
  stick.masses = view.numbers("masses", storeys);
  stick.stiffnesses = view.numbers("stiffnesses", storeys);
  read_yielding(view, storeys, stick);
  building.modes = stick.storey_heights.size();
  building.elevations = floor_elevations(stick.storey_heights);
  building.spec.structure = std::move(stick);
}

}  // namespace bentur
