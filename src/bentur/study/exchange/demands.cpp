#include "bentur/study/exchange/demands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string_view>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/core/units.h"
#include "bentur/io/output/result_kind.h"
#include "bentur/io/toml/toml_view.h"
#include "bentur/study/study_variables.h"

namespace bentur {
namespace {

/// Numbers of all runs, one run after the other.
struct RunNumbers {
  std::vector<double> values;
  std::size_t each = 1;  ///< of a run
};

/// A column of a sample, of all runs.
struct DemandColumn {
  std::string name;  ///< but for the event, "PFA-0-1"
  std::string_view unit;
  std::vector<double> of_runs;
};

/// The largest size of each of several lists of one length; NaN where none is known.
std::vector<double> largest_sizes(const std::vector<std::vector<double>>& lists) {
  std::vector<double> largest(lists.front().size(), not_known);
  for (const std::vector<double>& list : lists) {
    for (std::size_t i = 0; i < list.size(); ++i) largest[i] = std::fmax(largest[i], std::abs(list[i]));
  }
  return largest;
}

/// Whether a line at an angle [degree] with x is mostly along x, axis 0, or along y; at 45 degrees it is along both.
bool is_along(double angle, std::size_t axis) {
  constexpr double round_off = 1e-9;
  const double x = std::abs(std::cos(angle * std::numbers::pi / 180)),
               y = std::abs(std::sin(angle * std::numbers::pi / 180));
  return axis == 0 ? x >= y - round_off : y >= x - round_off;
}

constexpr std::array<char, 2> axis_names = {'x', 'y'};

class DemandReader {
 public:
  DemandReader(const ResultSource& file, const DemandRequest& request) : file_(file) {
    const StoredVariable* const status = file_.find("status");
    if (status == nullptr || file_.find("message") == nullptr) {
      file_.fail("does not hold the results of bentur sweep or bentur ida");
    }
    runs_ = status->dimensions;
    sizes_ = status->shape;
    allowed_.resize(sizes_.size());
    for (std::size_t i = 0; i < sizes_.size(); ++i) allowed_[i].assign(sizes_[i], true);
    for (const auto& [name, value] : request.only) choose(name, value);
    const StoredVariable* const intensity = file_.find("intensity");
    const bool has_levels = intensity != nullptr && intensity->dimensions == std::vector<std::string>{"intensity"};
    if (has_levels && places_left(intensity->dimensions[0]) > 1) {
      file_.fail(fmt::format("has several levels of intensity, which are no sample: give --only intensity=X, one of {}",
                             fmt::join(file_.numbers("intensity"), ", ")));
    }
    in_plan_ = file_.has("peak_acceleration_x_1");
    building_ = request.building;
    number_ = number_of_building();
    if (in_plan_) {
      take_plan();
    } else {
      take_row();
    }
  }

  Demands take() {
    Demands demands;
    const RunNumbers status = needed("status"), collapsed = optional("collapsed");
    std::string units = "Units";
    for (const DemandColumn& one : columns_) {
      demands.csv += (demands.csv.empty() ? std::string(demands_mark) : ",1-") + one.name;
      units += fmt::format(",{}", one.unit);
    }
    demands.csv += ",1-ERROR\n" + units + ",unitless\n";
    for (std::size_t run = 0; run < status.values.size(); ++run) {
      if (!is_chosen(run)) continue;
      constexpr double numbers_failed = 1, no_case = 2;
      if (status.values[run] == no_case) {
        ++demands.left_out;
        continue;
      }
      const bool error =
          status.values[run] == numbers_failed || (!collapsed.values.empty() && collapsed.values[run] > 0);
      demands.csv += fmt::format("{}", demands.runs);
      for (const DemandColumn& one : columns_) {
        const double value = one.of_runs[run];
        demands.csv += std::isfinite(value) ? fmt::format(",{}", value) : ",";
      }
      demands.csv += error ? ",1\n" : ",0\n";
      ++demands.runs;
      demands.errors += error ? 1 : 0;
    }
    if (demands.runs == 0) file_.fail("has no run of these values");
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const auto left = static_cast<std::size_t>(std::count(allowed_[i].begin(), allowed_[i].end(), true));
      if (left > 1) demands.over.emplace_back(runs_[i], left);
    }
    return demands;
  }

 private:
  [[nodiscard]] std::size_t places_left(const std::string& dimension) const {
    const auto found = std::find(runs_.begin(), runs_.end(), dimension);
    if (found == runs_.end()) return 0;
    const auto& allowed = allowed_[static_cast<std::size_t>(found - runs_.begin())];
    return static_cast<std::size_t>(std::count(allowed.begin(), allowed.end(), true));
  }

  void choose(const std::string& name, const std::string& value) {
    const StoredVariable* const variable = file_.find(name);
    const auto dimension = variable == nullptr || variable->dimensions.size() != 1
                               ? runs_.end()
                               : std::find(runs_.begin(), runs_.end(), variable->dimensions[0]);
    if (dimension == runs_.end()) {
      std::set<std::string> known;
      for (const StoredVariable& one : file_.variables()) {
        if (one.dimensions.size() == 1 && std::count(runs_.begin(), runs_.end(), one.dimensions[0]) > 0) {
          known.insert(one.name);
        }
      }
      file_.fail(fmt::format("nothing named {} varies; there are {}", in_quotes(name), fmt::join(known, ", ")));
    }
    auto& allowed = allowed_[static_cast<std::size_t>(dimension - runs_.begin())];
    std::vector<std::string> texts;
    bool any = false;
    if (variable->text) {
      texts = file_.texts(name);
      for (std::size_t k = 0; k < texts.size(); ++k) {
        const bool is = texts[k] == value;
        if (!is) allowed[k] = 0;
        any = any || is;
      }
    } else {
      double wanted = not_known;
      const char* const end = value.data() + value.size();
      const auto read = from_chars(value.data(), end, wanted);
      const bool is_number = read.ec == std::errc() && read.ptr == end;
      const std::vector<double> numbers = file_.numbers(name);
      for (std::size_t k = 0; k < numbers.size(); ++k) {
        const bool is = is_number && std::abs(numbers[k] - wanted) <= 1e-9 * std::abs(wanted);
        if (!is) allowed[k] = 0;
        any = any || is;
        texts.push_back(fmt::format("{}", numbers[k]));
      }
    }
    if (!any) file_.fail(fmt::format("no {} is {}; there are {}", name, value, fmt::join(texts, ", ")));
  }

  /// "_2" of the second building.
  [[nodiscard]] std::string number_of_building() const {
    std::vector<std::string> names;
    const auto variable = [&](std::size_t b) {
      return fmt::format("{}_{}", in_plan_ ? "peak_acceleration_x" : "peak_drift_ratio", b);
    };
    std::string number;
    for (std::size_t b = 1; number.empty() && (file_.has(variable(b)) || file_.has(variable(b + 1))); ++b) {
      if (!file_.has(variable(b))) continue;  // a wall has none
      names.push_back(file_.attribute(variable(b), "building"));
      if (names.back() == building_) number = fmt::format("_{}", b);
    }
    if (number.empty()) {
      file_.fail(fmt::format("has no building {}; there are {}", in_quotes(building_), fmt::join(names, ", ")));
    }
    return number;
  }

  void take_row() {
    take_accelerations("peak_ground_acceleration", 0, 1);
    take_accelerations("peak_acceleration" + number_, 1, 1);
    take_drifts("PID", needed("peak_drift_ratio" + number_), 1);
    take_drifts("RID", optional("residual_drift_ratio" + number_), 1);
  }

  void take_plan() {
    for (const std::size_t axis : {0, 1}) {
      const char name = axis_names[axis];
      take_accelerations(fmt::format("peak_ground_acceleration_{}", name), 0, axis + 1);
      take_accelerations(fmt::format("peak_acceleration_{}{}", name, number_), 1, axis + 1);
    }
    for (const std::size_t axis : {0, 1}) take_drifts("PID", drifts_along(axis), axis + 1);
    const std::string residual = "plane_residual_drift_ratio" + number_;
    for (const std::size_t axis : {0, 1}) {
      if (file_.has(residual)) take_drifts("RID", of_planes(residual, axis), axis + 1);
    }
  }

  /// Of planes along an axis; of a building without any of the two edges that are parallel to it.
  [[nodiscard]] RunNumbers drifts_along(std::size_t axis) const {
    const std::string planes = fmt::format("{}{}", plane_drift, number_);
    if (file_.has(planes)) return of_planes(planes, axis);
    const auto edge = [&](const char* name) { return optional(fmt::format("peak_drift_ratio_{}{}", name, number_)); };
    const RunNumbers one = edge(axis == 0 ? "south" : "west"), other = edge(axis == 0 ? "north" : "east");
    if (one.values.empty() || other.values.empty()) {
      file_.fail(fmt::format("has no drifts of building {}: it moves with the ground", in_quotes(building_)));
    }
    return {largest_sizes({one.values, other.values}), one.each};
  }

  /// Of the planes whose lines are mostly along an axis the largest, storey by storey.
  [[nodiscard]] RunNumbers of_planes(const std::string& name, std::size_t axis) const {
    const std::string told = "plane_angle" + number_;
    if (!file_.has(told)) {
      file_.fail(fmt::format(
          "has no {}, which tells planes along x from those along y: they turn between runs, or an earlier version "
          "wrote it",
          told));
    }
    const std::vector<double> angles = file_.numbers(told);
    const RunNumbers all = optional(name);
    const std::size_t storeys = all.each / angles.size();
    std::vector<std::vector<double>> along;
    for (std::size_t plane = 0; plane < angles.size(); ++plane) {
      if (!is_along(angles[plane], axis)) continue;
      std::vector<double>& one = along.emplace_back();
      for (std::size_t first = plane * storeys; first < all.values.size(); first += all.each) {
        for (std::size_t j = 0; j < storeys; ++j) one.push_back(all.values[first + j]);
      }
    }
    if (along.empty()) {
      file_.fail(fmt::format(
          "has no drifts along {} of building {}: none of its planes is along it. Give the case one, or hold the "
          "building by rigidity alone, whose edges tell their drifts",
          axis_names[axis], in_quotes(building_)));
    }
    return {largest_sizes(along), storeys};
  }

  void take_accelerations(const std::string& name, std::size_t first, std::size_t direction) {
    RunNumbers of = needed(name);
    const double factor = metres_per_second_squared(name);
    for (double& value : of.values) value *= factor;
    take_columns("PFA", "mps2", of, first, direction);
  }

  /// Of what no run has, as of the bearings below a slab, there is no column.
  void take_drifts(const char* type, const RunNumbers& of, std::size_t direction) {
    take_columns(type, "unitless", of, 1, direction);
    std::erase_if(columns_, [&](const DemandColumn& one) {
      return one.name.starts_with(type) &&
             std::none_of(one.of_runs.begin(), one.of_runs.end(), [](double value) { return std::isfinite(value); });
    });
  }

  /// @param first number of the lowest place
  void take_columns(const char* type, const char* unit, const RunNumbers& of, std::size_t first,
                    std::size_t direction) {
    for (std::size_t j = 0; j < of.each && !of.values.empty(); ++j) {
      DemandColumn& column = columns_.emplace_back(
          DemandColumn{.name = fmt::format("{}-{}-{}", type, first + j, direction), .unit = unit, .of_runs = {}});
      for (std::size_t at = j; at < of.values.size(); at += of.each) column.of_runs.push_back(std::abs(of.values[at]));
    }
  }

  [[nodiscard]] RunNumbers needed(const std::string& name) const {
    if (!file_.has(name)) file_.fail(fmt::format("has no {}, which demands need", name));
    return optional(name);
  }

  [[nodiscard]] RunNumbers optional(const std::string& name) const {
    const StoredVariable* const variable = file_.find(name);
    if (variable == nullptr) return {};
    RunNumbers found{file_.numbers(name)};
    for (std::size_t i = runs_.size(); i < variable->shape.size(); ++i) found.each *= variable->shape[i];
    return found;
  }

  /// What a unit of a variable, "cm s-2", is in m/s².
  [[nodiscard]] double metres_per_second_squared(const std::string& name) const {
    const std::string& units = file_.find(name)->units;
    const std::string seconds = " s-2";
    if (!units.ends_with(seconds)) file_.fail(fmt::format("has {} in {}, which is no acceleration", name, units));
    return metres(units.substr(0, units.size() - seconds.size()));
  }

  [[nodiscard]] bool is_chosen(std::size_t run) const {
    for (std::size_t i = runs_.size(); i-- > 0;) {
      if (!allowed_[i][run % sizes_[i]]) return false;
      run /= sizes_[i];
    }
    return true;
  }

  const ResultSource& file_;
  std::vector<std::string> runs_;  // dimensions
  std::vector<std::size_t> sizes_;
  std::vector<std::vector<char>> allowed_;  // per dimension and place
  bool in_plan_ = false;
  std::string building_, number_;
  std::vector<DemandColumn> columns_;
};

}  // namespace

Demands demand_sample(const ResultSource& file, const DemandRequest& request) {
  return DemandReader(file, request).take();
}

}  // namespace bentur
