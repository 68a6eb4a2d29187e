#include "bentur/study/exchange/demands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "bentur/core/number_text.h"
#include "bentur/core/units.h"
#include "bentur/io/output/result_kind.h"
#include "bentur/io/toml/toml_view.h"
#include "bentur/study/study_variables.h"

namespace bentur {
namespace {

/// A variable of the runs, all its values.
struct DemandColumn {
  std::vector<double> values;
  std::size_t each = 1;  ///< values of a run
};

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
    if (intensity != nullptr && intensity->dimensions.size() == 1 && places_left(intensity->dimensions[0]) > 1) {
      file_.fail(fmt::format("has several levels of intensity, which are no sample: give --only intensity=X, one of {}",
                             fmt::join(file_.numbers("intensity"), ", ")));
    }
    number_ = number_of(request.building);
  }

  Demands take() {
    Demands demands;
    const DemandColumn status = column("status"), ground = column("peak_ground_acceleration");
    const DemandColumn collapsed = optional("collapsed");
    const DemandColumn floors = column("peak_acceleration" + number_), drifts = column("peak_drift_ratio" + number_);
    const DemandColumn residual = optional("residual_drift_ratio" + number_);
    const double of_floors = metres_per_second_squared("peak_acceleration" + number_);
    const double of_ground = metres_per_second_squared("peak_ground_acceleration");
    std::string head(demands_mark), units = "Units,mps2";
    head += "PFA-0-1";
    const auto add = [&](const char* type, const char* unit, const DemandColumn& of) {
      for (std::size_t j = 1; j <= (of.values.empty() ? 0 : of.each); ++j) {
        head += fmt::format(",1-{}-{}-1", type, j);
        units += std::string(",") + unit;
      }
    };
    add("PFA", "mps2", floors);
    add("PID", "unitless", drifts);
    add("RID", "unitless", residual);
    demands.csv = head + ",1-ERROR\n" + units + ",unitless\n";
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
      put(ground, run, of_ground, demands.csv);
      put(floors, run, of_floors, demands.csv);
      put(drifts, run, 1, demands.csv);
      put(residual, run, 1, demands.csv);
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
      double wanted = std::nan("");
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
  [[nodiscard]] std::string number_of(const std::string& building) const {
    for (const StoredVariable& variable : file_.variables()) {
      if (without_number(variable.name) != "peak_displacement_x") continue;
      file_.fail("is of buildings in plan, whose demands go along two axes: they are not exported yet");
    }
    std::vector<std::string> names;
    std::string number;
    for (std::size_t b = 1; number.empty(); ++b) {
      const StoredVariable* const variable = file_.find(fmt::format("peak_drift_ratio_{}", b));
      if (variable == nullptr) {
        if (file_.find(fmt::format("peak_drift_ratio_{}", b + 1)) != nullptr) continue;  // a wall has none
        break;
      }
      const std::string name = file_.attribute(variable->name, "building");
      if (name == building) number = fmt::format("_{}", b);
      names.push_back(name);
    }
    if (number.empty()) {
      file_.fail(fmt::format("has no building {}; there are {}", in_quotes(building), fmt::join(names, ", ")));
    }
    return number;
  }

  [[nodiscard]] DemandColumn column(const std::string& name) const {
    if (!file_.has(name)) file_.fail(fmt::format("has no {}, which demands need", name));
    return optional(name);
  }

  [[nodiscard]] DemandColumn optional(const std::string& name) const {
    const StoredVariable* const variable = file_.find(name);
    if (variable == nullptr) return {};
    DemandColumn column{file_.numbers(name)};
    for (std::size_t i = runs_.size(); i < variable->shape.size(); ++i) column.each *= variable->shape[i];
    return column;
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

  static void put(const DemandColumn& column, std::size_t run, double factor, std::string& csv) {
    for (std::size_t j = 0; j < (column.values.empty() ? 0 : column.each); ++j) {
      const double value = std::abs(column.values[run * column.each + j]) * factor;
      csv += std::isfinite(value) ? fmt::format(",{}", value) : ",";
    }
  }

  const ResultSource& file_;
  std::vector<std::string> runs_;  // dimensions
  std::vector<std::size_t> sizes_;
  std::vector<std::vector<char>> allowed_;  // per dimension and place
  std::string number_;
};

}  // namespace

Demands demand_sample(const ResultSource& file, const DemandRequest& request) {
  return DemandReader(file, request).take();
}

}  // namespace bentur
