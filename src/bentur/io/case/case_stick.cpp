#include <algorithm>
#include <cmath>

#include "bentur/io/case/case_parts.h"

namespace bentur {
namespace {

/// What says how storeys yield.
void read_yielding(const TomlView& view, const Length& per_storey, Stick& stick) {
  const auto hardening = view.find("hardening");
  const auto word = view.word("hysteresis", {"bilinear", "peak-oriented"}, Need::optional);
  const auto exponent = view.number("unloading_exponent", Rule::share, Need::optional);
  if (hardening) stick.hardening = hardening->as_number_or_numbers(Rule::ratio, per_storey);
  if (word == "peak-oriented") {
    stick.hysteresis = Hysteresis::peak_oriented;
    stick.unloading_exponent = exponent.value_or(0);
  } else if (!view.has("hysteresis") || word == "bilinear") {
    view.refuse({"unloading_exponent"}, "is for hysteresis = \"peak-oriented\"");
  }
  const auto forces = view.find("yield_forces");
  if (forces) {
    stick.yield_forces = forces->as_number_or_numbers(Rule::positive_or_infinite, per_storey);
  } else {
    view.refuse({"hardening", "hysteresis", "unloading_exponent"},
                "is of storeys that yield: give yield_forces too, without them all stay elastic");
  }
}

}  // namespace

void read_stick(const TomlView& view, ReadBuilding& building) {
  if (!view.is_table_of({"storey_heights", "masses", "stiffnesses", "yield_forces", "hardening", "hysteresis",
                         "unloading_exponent"})) {
    return;
  }
  Stick stick;
  const auto heights = view.get("storey_heights");
  const Length per_storey = {heights ? heights->size() : 0, "one per storey"};
  if (heights) stick.storey_heights = heights->as_numbers(Rule::size);
  stick.masses = view.numbers("masses", Rule::positive, per_storey);
  stick.stiffnesses = view.numbers("stiffnesses", Rule::positive, per_storey);
  read_yielding(view, per_storey, stick);
  building.modes = stick.storey_heights.size();
  building.elevations = floor_elevations(stick.storey_heights);
  building.spec.structure = std::move(stick);
}

}  // namespace bentur
