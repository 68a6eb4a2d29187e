// Quantities as columns of tables for people, and the places that these are of.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>
#include <utility>

#include "bentur/core/number_text.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/model/quantities.h"
#include "bentur/model/run_results.h"

namespace bentur {

namespace {

/// What a run has of these units at most, of its lengths, accelerations and forces; turning at the longest side.
double size_of(const PlanRun& run, std::string_view units) {
  double displacement = 0, acceleration = 0, force = 0, side = 0;
  for (const PlanBuilding& one : run.problem.buildings) side = std::max(side, one.model.footprint.size.maxCoeff());
  const auto most = [](double& of, std::initializer_list<const Eigen::VectorXd*> lists) {
    for (const Eigen::VectorXd* const list : lists) {
      for (const double value : *list) of = std::max(of, value);
    }
  };
  for (const PlanPeaks& peaks : run.response.buildings) {
    most(displacement, {&peaks.x, &peaks.y});
    most(acceleration, {&peaks.acceleration_x, &peaks.acceleration_y});
    most(force, {&peaks.shear_x, &peaks.shear_y});
  }
  for (const PointSummary& one : run.response.points) force = std::max(force, one.peak_force);
  if (units == "L") return displacement;
  if (units == "rad") return displacement / side;
  if (units == "L s-2") return acceleration;
  if (units == "rad s-2") return acceleration / side;
  if (units == "F") return force;
  return units == "F L" ? force * displacement : 0;
}

bool is_nothing(double value) { return std::isnan(value); }

/// Those of an owner that have a label and are of a table.
std::vector<const Quantity*> with_label(Owner owner, QuantityTable table, bool in_plan, std::size_t language) {
  std::vector<const Quantity*> found = quantities_of(owner, in_plan);
  std::erase_if(found, [&](const Quantity* one) { return one->label[language].empty() || one->source.table != table; });
  return found;
}

/// The column of a quantity; values in the case's units, NaN: there is none.
TableColumn column_of(const Quantity& quantity, std::vector<double> values, const ShownUnits& shown,
                      std::size_t language) {
  for (double& value : values) value *= quantity.shown_factor * shown.factor(quantity.units);
  std::vector<std::string> cells = column(values);
  if (quantity.decimals) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      cells[i] = std::isnan(values[i]) ? "–" : fmt::format("{:.{}f}", values[i], *quantity.decimals);
    }
    values.clear();
  }
  const std::string_view unit = quantity.shown_unit;
  return {std::string(quantity.label[language]),
          unit.empty() ? unit_text(quantity.units, shown.units) : std::string(unit), std::move(cells),
          std::move(values)};
}

}  // namespace

std::vector<TableColumn> table_columns(Owner owner, const RunView& r, const std::vector<QuantityPlace>& places,
                                       std::size_t language, QuantityTable table) {
  std::vector<TableColumn> columns;
  for (const Quantity* const quantity : with_label(owner, table, false, language)) {
    if (!is_told_at_any(*quantity, r, places)) continue;
    std::vector<double> values;
    for (const QuantityPlace& at : places) values.push_back(value_of(*quantity, r, at));
    columns.push_back(column_of(*quantity, std::move(values), r.shown, language));
  }
  return columns;
}

std::vector<TableColumn> table_columns(Owner owner, const PlanRun& run, const std::vector<QuantityPlace>& places,
                                       std::size_t language, QuantityTable table) {
  const ShownUnits shown = shown_units(run);
  std::vector<TableColumn> columns;
  for (const Quantity* const quantity : with_label(owner, table, true, language)) {
    std::vector<double> values = values_at(*quantity, run, places);
    if (std::all_of(values.begin(), values.end(), is_nothing)) continue;
    const double least = 1e-12 * size_of(run, quantity->units);
    for (double& value : values) value = std::abs(value) < least ? 0 : value;
    columns.push_back(column_of(*quantity, std::move(values), shown, language));
  }
  return columns;
}

std::vector<double> values_at(const Quantity& quantity, const PlanRun& run, const std::vector<QuantityPlace>& places) {
  std::vector<double> values;
  const When when = quantity.source.when;
  if (places.empty() || (when == When::moves && run.problem.buildings[places.front().item].is_rigid())) return values;
  for (const QuantityPlace& at : places) values.push_back(value_of(quantity, run, at));
  const bool of_frames = quantity.owner == Owner::hinge ? when == When::hinges : quantity.owner == Owner::column;
  const bool always = when == When::always || when == When::moves || of_frames;
  if (!always && std::all_of(values.begin(), values.end(), is_nothing)) values.clear();
  return values;
}

bool is_told_at_any(const Quantity& quantity, const RunView& r, const std::vector<QuantityPlace>& places) {
  const auto& is_told = quantity.source.row.is_told;
  return !is_told || places.empty() ||
         std::any_of(places.begin(), places.end(), [&](const QuantityPlace& at) { return is_told(r, at.item); });
}

ShownUnits shown_units(const Units& units, const Response& response) {
  double largest = 0;
  for (const PointSummary& point : response.points) {
    largest = std::max({largest, point.peak_force, point.peak_tension});
  }
  for (const BuildingPeaks& peaks : response.buildings) {
    for (const double shear : peaks.storey_shear) largest = std::fmax(largest, shear);
  }
  return shown_units(units, largest);
}

ShownUnits shown_units(const RunResults& run) { return shown_units(run.c.units, run.response); }

ShownUnits shown_units(const PlanRun& run) {
  double largest = 0;
  for (const PointSummary& one : run.response.points) largest = std::max({largest, one.peak_force, one.peak_tension});
  for (const PlanPeaks& peaks : run.response.buildings) {
    for (const Eigen::VectorXd* const list : {&peaks.shear_x, &peaks.shear_y}) {
      for (const double shear : *list) largest = std::max(largest, shear);
    }
  }
  return shown_units(run.c.units, largest);
}

std::string file_name(const Quantity& quantity) {
  const std::string_view prefix = quantity.owner == Owner::link      ? "link_"
                                  : quantity.owner == Owner::impact  ? "impact_"
                                  : quantity.owner == Owner::hinge   ? "hinge_"
                                  : quantity.owner == Owner::plane   ? "plane_"
                                  : quantity.owner == Owner::column  ? "breaking_column_"
                                  : quantity.owner == Owner::bearing ? "bearing_"
                                                                     : "";
  return std::string(prefix) + std::string(quantity.key);
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

std::vector<QuantityPlace> places_in(const Problem& problem, Owner owner, Eigen::Index building) {
  if (owner == Owner::building) return {{.item = building}};
  if (owner == Owner::floor) return floors_of(problem, building);
  if (owner == Owner::hinge) return hinges_of(problem, building);
  if (owner == Owner::column) return breaking_columns_of(problem, building);
  return {};
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
