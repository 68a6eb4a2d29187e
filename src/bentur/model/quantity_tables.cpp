// Quantities as columns of tables for people, and the places that these are of.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>
#include <utility>
#include <variant>

#include "bentur/core/number_text.h"
#include "bentur/model/internal/quantity_column.h"
#include "bentur/structure/frame/infill.h"

namespace bentur {

namespace {

std::vector<TableColumn> columns_of(Owner owner, bool (*is_wanted)(const Quantity&), const RunView& r,
                                    const std::vector<QuantityPlace>& places, std::size_t language) {
  std::vector<TableColumn> columns;
  for (const Quantity* quantity : quantities_of(owner)) {
    if (quantity->label[language].empty() || !is_wanted(*quantity)) continue;
    if (!is_told_at_any(*quantity, r, places)) continue;
    std::vector<double> values;
    for (const QuantityPlace& at : places) values.push_back(value_of(*quantity, r, at));
    columns.push_back(column_of(*quantity, std::move(values), r.shown, language));
  }
  return columns;
}

}  // namespace

TableColumn column_of(const Quantity& quantity, std::vector<double> values, const ShownUnits& shown,
                      std::size_t language) {
  for (double& value : values) value *= quantity.shown_factor * shown.factor(quantity.units);
  std::vector<std::string> cells = column(values);
  if (quantity.decimals) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      cells[i] = std::isnan(values[i]) ? "–" : fmt::format("{:.{}f}", values[i], *quantity.decimals);
    }
  }
  const std::string_view unit = quantity.shown_unit;
  return {std::string(quantity.label[language]),
          unit.empty() ? unit_text(quantity.units, shown.units) : std::string(unit), std::move(cells)};
}

std::vector<TableColumn> table_columns(Owner owner, const RunView& r, const std::vector<QuantityPlace>& places,
                                       std::size_t language) {
  const auto is_wanted = [](const Quantity& one) {
    return !is_of_yielding(one) && !is_of_infill(one) && !is_of_forces(one) && !is_of_columns(one);
  };
  return columns_of(owner, is_wanted, r, places, language);
}

std::vector<TableColumn> yielding_columns(const RunView& r, const std::vector<QuantityPlace>& floors,
                                          std::size_t language) {
  const auto is_wanted = [](const Quantity& one) { return is_of_yielding(one) || is_of_infill(one); };
  return columns_of(Owner::floor, is_wanted, r, floors, language);
}

std::vector<TableColumn> force_columns(const RunView& r, const std::vector<QuantityPlace>& floors,
                                       std::size_t language) {
  return columns_of(Owner::floor, is_of_forces, r, floors, language);
}

std::vector<TableColumn> struck_column_columns(const RunView& r, const std::vector<QuantityPlace>& points,
                                               std::size_t language) {
  return columns_of(Owner::point, is_of_columns, r, points, language);
}

bool is_of_yielding(const Quantity& quantity) { return std::holds_alternative<YieldingSource>(quantity.source); }

bool is_of_infill(const Quantity& quantity) { return std::holds_alternative<InfillSource>(quantity.source); }

bool is_of_infill(const Quantity& quantity, const Building& building) {
  const auto* source = std::get_if<InfillSource>(&quantity.source);
  if (source == nullptr || building.model.infills.empty()) return false;
  return source->list != &BuildingPeaks::Infill::column_demand || !struts_on_columns(building.model).empty();
}

bool is_of_foundation(const Quantity& quantity) { return std::holds_alternative<FoundationSource>(quantity.source); }

bool is_of_yielding(const Quantity& quantity, const Building& building) {
  const auto* source = std::get_if<YieldingSource>(&quantity.source);
  if (source == nullptr) return false;
  const bool residual = source->list == &BuildingPeaks::Yielding::residual_drift_ratio;
  for (const auto list : {&BuildingPeaks::Yielding::strength_left, &BuildingPeaks::Yielding::capped_time,
                          &BuildingPeaks::Yielding::residual_time, &BuildingPeaks::Yielding::failed_time}) {
    if (source->list == list) return building.can_lose_strength();
  }
  return building.storeys_yield() || (residual && building.model.hinges.size() > 0);
}

bool is_of_hinges(const Quantity& quantity) { return quantity.owner == Owner::hinge || quantity.key == "hinge_energy"; }

bool is_of_weakening(const Quantity& quantity) {
  const auto* source = std::get_if<std::optional<double> BuildingPeaks::Hinge::*>(&quantity.source);
  return source != nullptr && *source != &BuildingPeaks::Hinge::first_yield;
}

bool is_of_breaking(const Quantity& quantity) { return quantity.owner == Owner::column; }

bool is_of_forces(const Quantity& quantity) {
  return quantity.owner == Owner::floor && (quantity.key.find("acceleration") != std::string_view::npos ||
                                            quantity.key.find("storey_shear") != std::string_view::npos);
}

bool is_of_columns(const Quantity& quantity) { return std::holds_alternative<ColumnSource>(quantity.source); }

std::string file_name(const Quantity& quantity) {
  const std::string_view prefix = quantity.owner == Owner::link      ? "link_"
                                  : quantity.owner == Owner::impact  ? "impact_"
                                  : quantity.owner == Owner::hinge   ? "hinge_"
                                  : quantity.owner == Owner::column  ? "breaking_column_"
                                  : quantity.owner == Owner::bearing ? "bearing_"
                                                                     : "";
  return std::string(prefix) + std::string(quantity.key);
}

bool is_told_at_any(const Quantity& quantity, const RunView& r, const std::vector<QuantityPlace>& places) {
  return places.empty() || std::any_of(places.begin(), places.end(),
                                       [&](const QuantityPlace& at) { return is_told(quantity, r, at.item); });
}

std::vector<QuantityPlace> floors_of(const Problem& problem, Eigen::Index b) {
  std::vector<QuantityPlace> places;
  for (Eigen::Index i = 0; i < problem.buildings[b].model.floors(); ++i) places.push_back({b, i});
  return places;
}

std::vector<QuantityPlace> hinges_of(const Problem& problem, Eigen::Index b) {
  std::vector<QuantityPlace> places;
  for (Eigen::Index h = 0; h < std::ssize(problem.buildings[b].model.hinges.places); ++h) places.push_back({b, h});
  return places;
}

std::vector<QuantityPlace> breaking_columns_of(const Problem& problem, Eigen::Index b) {
  std::vector<QuantityPlace> places;
  for (Eigen::Index n = 0; n < std::ssize(problem.buildings[b].model.hinges.columns); ++n) places.push_back({b, n});
  return places;
}

std::vector<QuantityPlace> floors_from_top(const Problem& problem, Eigen::Index b) {
  std::vector<QuantityPlace> places = floors_of(problem, b);
  std::reverse(places.begin(), places.end());
  return places;
}

std::vector<QuantityPlace> first_places(Eigen::Index count) {
  std::vector<QuantityPlace> places;
  for (Eigen::Index i = 0; i < count; ++i) places.push_back({i, 0});
  return places;
}

std::vector<QuantityPlace> places_of(const std::vector<Eigen::Index>& items) {
  std::vector<QuantityPlace> places;
  for (const Eigen::Index item : items) places.push_back({item, 0});
  return places;
}

// tf would be unknown to UDUNITS, since its ton_force is the short one.
std::string udunit(const std::string& unit) { return unit == "tf" ? "1000 kgf" : unit; }

std::string udunits(std::string_view form, const Units& units) {
  std::string text;
  for (const char c : form) {
    text += c == 'L' ? udunit(units.length) : c == 'F' ? udunit(units.force) : std::string(1, c);
  }
  return text;
}

namespace {

/// "s²" of "s" and "2".
std::string raised(const std::string& unit, const std::string& power) {
  return unit + (power == "2" ? "²" : power == "3" ? "³" : power == "4" ? "⁴" : "");
}

}  // namespace

std::string unit_text(const std::string& udunits) {
  std::istringstream words(udunits == "1" ? "–" : udunits);
  std::string above, below;
  for (std::string word; words >> word;) {
    if (word == "1000") {
      words >> word;
      if (word == "kgf") {
        word = "tf";
      } else {
        word.insert(0, "1000 ");
      }
    }
    if (word == "gravity") word = "g";
    const std::size_t minus = word.find('-');
    if (minus == std::string::npos) {
      const std::size_t digit = word.find_first_of("234", 1);
      const std::string unit = word.substr(0, digit), power = digit == std::string::npos ? "" : word.substr(digit);
      above += (above.empty() ? "" : "·") + raised(unit, power);
    } else {
      below += (below.empty() ? "" : "·") + raised(word.substr(0, minus), word.substr(minus + 1));
    }
  }
  if (below.empty()) return above;
  return (above.empty() ? "1" : above) + "/" + below;
}

std::string unit_text(std::string_view form, const Units& units) {
  return form == "1" ? "" : unit_text(udunits(form, units));
}

}  // namespace bentur
