#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/elements/hysteretic_laws.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"

namespace bentur {

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
  if (view.has("backbone")) return;
  if (view.has("yield_forces")) {
    stick.yield_forces = view.numbers("yield_forces", storeys);
  } else {
    view.refuse(of_yielding, "is of storeys that yield: give yield_forces too, without them all stay elastic");
  }
}

namespace {

/// A rule that every entry of a list has to keep; an error at the list unless they do.
template <class Rule>
void check_each(const TableView& view, const std::string& key, const std::vector<double>& values, Rule keeps,
                const std::string& rule) {
  if (std::all_of(values.begin(), values.end(), keeps)) return;
  view.get(key)->error_value(rule);
}

StoreyBackbones::Side read_backbone_side(const TableView& view, std::size_t storeys, const Stick& stick) {
  StoreyBackbones::Side side;
  side.yield = view.numbers("yield", storeys);
  side.cap = view.numbers("cap", storeys);
  side.plastic = view.numbers("plastic_drift", storeys);
  side.softening = view.numbers("softening_drift", storeys);
  side.residual = view.numbers("residual", storeys);
  side.ultimate = view.numbers("ultimate_drift", storeys);
  check_each(
      view, "cap", side.cap, [](double cap) { return cap >= 1; }, "must be >= 1");
  const bool higher = std::any_of(side.cap.begin(), side.cap.end(), [](double cap) { return cap > 1; });
  if (higher && !view.has("plastic_drift")) view.get("cap")->error("needs plastic_drift, the way from yielding to it");
  if (!view.has("plastic_drift")) {
    view.refuse({"softening_drift"}, "goes with plastic_drift, which is not given");
  }
  // The drift at yielding of each storey, as far as that is known.
  const auto of = [](const std::vector<double>& list, std::size_t j) { return list[list.size() == 1 ? 0 : j]; };
  for (std::size_t j = 0; j < std::min(storeys, stick.stiffnesses.size()); ++j) {
    if (side.yield.empty() || side.ultimate.empty() || (side.yield.size() > 1 && j >= side.yield.size()) ||
        (side.ultimate.size() > 1 && j >= side.ultimate.size())) {
      break;
    }
    const double at_yield = of(side.yield, j) / stick.stiffnesses[j];
    if (std::isinf(at_yield) || of(side.ultimate, j) > at_yield) continue;
    view.get("ultimate_drift")
        ->error(fmt::format("must be beyond yielding: storey {} yields at {:.4g}", j + 1, at_yield));
    break;
  }
  return side;
}

}  // namespace

void read_backbone(const TableView& stick_view, std::size_t storeys, Stick& stick) {
  const auto given = stick_view.table("backbone");
  if (!given) return;
  const TableView& view = *given;
  std::vector<std::string> others = {"yield_forces", "hardening", "hysteresis"};
  for (const std::string& name : stick_view.keys().names()) {
    if (!stick_view.keys().owners(name, "hysteresis").empty()) others.push_back(name);
  }
  stick_view.refuse(others, "does not go with backbone, which says how storeys yield");
  StoreyBackbones backbone;
  backbone.positive = read_backbone_side(view, storeys, stick);
  const auto negative = view.table("negative");
  if (negative) backbone.negative = read_backbone_side(*negative, storeys, stick);
  const auto word = view.word("hysteresis");
  for (const Reloading one : {Reloading::peak_oriented, Reloading::pinching}) {
    if (word == word_of(one)) backbone.reloading = one;
  }
  if (backbone.reloading == Reloading::pinching) {
    backbone.pinching_force = view.number("pinching_force").value_or(1);
    backbone.pinching_deformation = view.number("pinching_drift").value_or(0);
  }
  Deterioration& wear = backbone.deterioration;
  for (const auto& [key, gamma] :
       {std::pair{"strength_wear", &wear.strength}, std::pair{"cap_wear", &wear.cap},
        std::pair{"reloading_wear", &wear.reloading}, std::pair{"unloading_wear", &wear.unloading}}) {
    *gamma = view.number(key).value_or(Deterioration::none);
  }
  if (backbone.reloading == Reloading::bilinear) {
    view.refuse({"reloading_wear"}, "is not for hysteresis = \"bilinear\", which heads for no peak");
  }
  wear.exponent = view.number("wear_exponent").value_or(1);
  if (!(wear.exponent >= 1 && wear.exponent <= 2)) view.get("wear_exponent")->error_value("must be in [1, 2]");
  if (backbone.negative) {
    const auto elastic = [storeys](const std::vector<double>& yield, std::size_t j) {
      return !yield.empty() && (yield.size() == 1 || yield.size() == storeys) &&
             std::isinf(yield[yield.size() == 1 ? 0 : j]);
    };
    bool agree = true;
    for (std::size_t j = 0; j < storeys; ++j) {
      agree = agree && elastic(backbone.positive.yield, j) == elastic(backbone.negative->yield, j);
    }
    if (!agree && negative->has("yield")) {
      negative->get("yield")->error_value("must be inf where the other side is, and there alone");
    }
  }
  if (!backbone.positive.yield.empty()) stick.backbone = std::move(backbone);
}

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
  read_backbone(view, storeys, stick);
  read_storey_columns(view, storeys, building.spec);
  building.modes = stick.storey_heights.size();
  building.elevations = floor_elevations(stick.storey_heights);
  building.spec.structure = std::move(stick);
}

}  // namespace bentur
