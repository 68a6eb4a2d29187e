#include "bentur/report/studies/sweep_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "bentur/core/number_text.h"
#include "bentur/model/run_results.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/study/fragility/ida_results.h"

namespace bentur {
namespace {

/// "width" of "gap[0].width[1]".
std::string last_key(const std::string& parameter) {
  const std::string last = parameter.substr(parameter.find_last_of('.') + 1);  // npos + 1 is 0
  return last.substr(0, last.find('['));
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

/// "spectral acceleration, period 1.2 s, damping 5 %" as "Sa (1.2 s, 5 %)"; other measures as they are.
std::string intensity_label(const std::string& measure) {
  const std::string period = "spectral acceleration, period ";
  const std::string damping = ", damping ";
  const std::size_t end = measure.find(damping);
  if (measure.rfind(period, 0) != 0 || end == std::string::npos) return measure;
  return fmt::format("Sa ({}, {})", measure.substr(period.size(), end - period.size()),
                     measure.substr(end + damping.size()));
}

bool equal(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b)); }

/// "gap[0].width" as "Gap width w", in the language of the words.
std::string parameter_label(const std::string& parameter, const std::string& name, const FigureWords& say) {
  const std::string key = last_key(parameter);
  const bool of_gap = parameter.find("gap[") != std::string::npos;
  if (of_gap && key == "width") return word(say, "Gap width w");
  if (key == "restitution") return word(say, "Restitution e");
  if (key == "pga") return word(say, "Peak ground acceleration");
  if (of_gap && key == "stiffness") return word(say, "Contact stiffness k");
  if (key == "delays") return word(say, "Delay τ");
  if (key == "calibrate_period") {
    const std::size_t first = parameter.find("[\"");
    const std::size_t last = parameter.find("\"]");
    const bool named = first < last && last != std::string::npos;
    return named ? word(say, "First period T of {}", parameter.substr(first + 2, last - first - 2))
                 : word(say, "First period T");
  }
  if (key == "period") return word(say, "Period T");
  std::string words = name.empty() ? key : name;
  std::replace(words.begin(), words.end(), '_', ' ');
  return word(say, capitalised(words));
}

}  // namespace

std::string SweepDimension::value(std::size_t i) const { return is_text() ? texts[i] : number(numbers[i]); }

std::string SweepDimension::choice(std::size_t i) const {
  return is_text() ? texts[i] : short_name + " " + value(i) + (unit.empty() || unit == "–" ? "" : " " + unit);
}

std::vector<std::string> names_of(const std::vector<SweepDimension>& dimensions) {
  std::vector<std::string> names;
  for (const SweepDimension& one : dimensions) names.push_back(one.name);
  return names;
}

SweepDimension SweepData::coordinate(const StoredVariable& variable) const {
  SweepDimension one;
  one.name = variable.name;
  one.short_name = variable.name;
  std::replace(one.short_name.begin(), one.short_name.end(), '_', ' ');
  const std::string key = last_key(variable.long_name);
  if (variable.long_name.find("gap[") != std::string::npos && key == "width") one.short_name = "gap";
  if (key == "calibrate_period") one.short_name = "T₁";
  if (variable.name == "intensity") one.short_name = intensity_label(variable.long_name);
  one.short_name = word(say_, one.short_name);
  one.size = variable.shape.empty() ? 1 : variable.shape[0];
  if (variable.text) {
    one.texts = results_.texts(variable.name);
    one.label = parameter_label(variable.long_name, variable.name, say_);
    return one;
  }
  one.numbers = results_.numbers(variable.name);
  one.unit = unit_text(variable.units);
  const bool factor = variable.long_name.rfind("factor of ", 0) == 0;
  const std::string label = factor ? word(say_, "Factor of {}", variable.name)
                            : variable.name == "intensity"
                                ? word(say_, capitalised(intensity_label(variable.long_name)))
                                : parameter_label(variable.long_name, variable.name, say_);
  one.label = one.unit.empty() ? label : with_unit(label, one.unit);
  return one;
}

SweepDimension SweepData::intensities() const {
  const StoredVariable* const variable = results_.find("intensity");
  if (variable == nullptr) throw NoFigure(results_.name() + ": has no intensities");
  SweepDimension one = coordinate(*variable);
  one.size = one.numbers.size();
  return one;
}

SweepData::SweepData(const NetcdfReader& results, FigureWords say) : results_(results), say_(std::move(say)) {
  const StoredVariable& status = results.at("status");
  const StoredVariable* of_records = results.find("record_intensity");
  for (std::size_t d = 0; d < status.dimensions.size(); ++d) {
    const std::string& name = status.dimensions[d];
    const StoredVariable* variable = results.find(name);
    if (variable != nullptr && variable->long_name == index_title) variable = nullptr;
    for (std::size_t i = 0; variable == nullptr && i < status.coordinates.size() && name != "sample"; ++i) {
      const StoredVariable* other = results.find(status.coordinates[i]);  // of several that move together
      if (other != nullptr && other->dimensions == std::vector<std::string>{name}) variable = other;
    }
    SweepDimension one;
    if (variable != nullptr) {
      one = coordinate(*variable);
      const std::string key = last_key(variable->long_name);
      one.is_of_records = variable->text && (key == "excitation" || variable->long_name == "excitation.file");
    }
    if (of_records != nullptr) {
      const std::vector<std::string>& names = of_records->dimensions;
      one.is_of_records = std::find(names.begin(), names.end(), name) != names.end();
    }
    one.name = name;
    one.size = status.shape[d];
    dimensions_.push_back(std::move(one));
  }
  double largest = 0;
  for (const std::string force : {"peak_force", "peak_storey_shear"}) {
    for (const SweepVariable& one : variables_of(results, force)) {
      if (results.at(one.name).units != "N") continue;
      for (const double value : results.numbers(one.name)) largest = std::fmax(largest, value);
    }
  }
  force_ = shown_units({.force = "N"}, largest).units.force;
}

bool SweepData::shows_in_kilonewtons(const std::string& quantity) const {
  const std::string& units = results_.at(quantity).units;
  return force_ == "kN" && (units == "N" || units.starts_with("N "));
}

std::string SweepData::unit(const std::string& quantity) const {
  return unit_text((shows_in_kilonewtons(quantity) ? "k" : "") + results_.at(quantity).units);
}

std::size_t SweepData::index(const std::string& name) const {
  const auto found =
      std::find_if(dimensions_.begin(), dimensions_.end(), [&](const SweepDimension& one) { return one.name == name; });
  return static_cast<std::size_t>(found - dimensions_.begin());
}

std::size_t SweepData::owners(const std::string& quantity) const {
  const StoredVariable& variable = results_.at(quantity);
  return variable.shape.size() > dimensions_.size() ? variable.shape.back() : 1;
}

const std::vector<double>& SweepData::all(const std::string& quantity) const {
  const auto [known, is_new] = held_.try_emplace(quantity);
  std::vector<double>& held = known->second;
  if (is_new) {
    held = results_.numbers(quantity);
    if (is_compared_by_size(results_, quantity)) {
      for (double& value : held) value = std::abs(value);
    }
    if (shows_in_kilonewtons(quantity)) {
      for (double& value : held) value *= newtons("N") / newtons("kN");
    }
  }
  return held;
}

std::vector<double> SweepData::values(const std::string& quantity, const std::vector<std::size_t>& at) const {
  const std::vector<double>& held = all(quantity);
  std::size_t run = 0;
  for (std::size_t d = 0; d < dimensions_.size(); ++d) run = run * dimensions_[d].size + at[d];
  const std::size_t count = owners(quantity);
  const auto first = held.begin() + static_cast<std::ptrdiff_t>(run * count);
  return {first, first + static_cast<std::ptrdiff_t>(count)};
}

double SweepData::joined(const std::string& quantity, const std::vector<std::size_t>& at, bool sum) const {
  double result = NAN;
  for (const double value : values(quantity, at)) {
    if (std::isnan(value)) continue;
    result = std::isnan(result) ? value : sum ? result + value : std::max(result, value);
  }
  return result;
}

bool SweepData::is_cut_short(const std::vector<std::size_t>& at) const {
  constexpr double numbers_failed = 1;
  if (values("status", at).front() == numbers_failed) return true;
  return results_.find("collapsed") != nullptr && values("collapsed", at).front() > 0;
}

std::vector<std::vector<std::size_t>> SweepData::combinations(std::vector<std::size_t> from,
                                                              const std::vector<std::size_t>& dimensions) const {
  std::vector<std::vector<std::size_t>> list = {std::move(from)};
  for (const std::size_t d : dimensions) {
    if (list[0][d] != dimensions_[d].size) continue;  // chosen
    std::vector<std::vector<std::size_t>> longer;
    for (const std::vector<std::size_t>& one : list) {
      for (std::size_t i = 0; i < dimensions_[d].size; ++i) {
        longer.push_back(one);
        longer.back()[d] = i;
      }
    }
    list = std::move(longer);
  }
  return list;
}

std::vector<std::string> SweepData::owner_names(const std::string& quantity) const {
  const StoredVariable& variable = results_.at(quantity);
  const std::size_t count = owners(quantity);
  if (variable.shape.size() == dimensions_.size()) return {""};
  const std::string& dimension = variable.dimensions.back();
  const StoredVariable* elevations =
      results_.find(dimension == "point" || dimension == "link" ? dimension + "_elevation" : dimension);
  std::vector<std::string> names;
  if (elevations != nullptr && !elevations->text && elevations->shape == std::vector<std::size_t>{count}) {
    const std::string unit = elevations->units == "1" ? "" : " " + unit_text(elevations->units);
    for (const double z : results_.numbers(elevations->name)) {
      names.push_back(unit.empty() ? word(say_, "floor {}", number(z)) : "z = " + number(z) + unit);
    }
    return names;
  }
  for (std::size_t i = 0; i < count; ++i) names.push_back(word(say_, dimension + " {}", std::to_string(i + 1)));
  return names;
}

std::vector<std::size_t> SweepData::chosen(const std::vector<std::pair<std::string, std::string>>& at) const {
  std::vector<std::size_t> result;
  for (const SweepDimension& one : dimensions_) result.push_back(one.size == 1 ? 0 : one.size);
  for (const auto& [name, text] : at) {
    const std::size_t d = index(name);
    if (d == dimensions_.size()) {
      throw NoFigure(fmt::format("--at {}={}: nothing of that name varies; there are {}", name, text,
                                 fmt::join(names_of(dimensions_), ", ")));
    }
    double number = NAN;
    std::from_chars(text.data(), text.data() + text.size(), number);
    std::vector<std::string> known;
    const SweepDimension& one = dimensions_[d];
    if (one.texts.empty() && one.numbers.empty()) throw NoFigure("--at: samples cannot be chosen from");
    result[d] = one.size;
    for (std::size_t i = 0; i < one.size; ++i) {
      if (one.is_text() ? one.texts[i] == text : equal(one.numbers[i], number)) result[d] = i;
      if (i < 12) known.push_back(one.value(i));
    }
    if (result[d] == one.size) {
      throw NoFigure(fmt::format("--at {}={}: no such value; there are {}{}", name, text, fmt::join(known, ", "),
                                 one.size > 12 ? ", ..." : ""));
    }
  }
  return result;
}

std::vector<SweepDimension> SweepData::sample_coordinates() const {
  std::vector<SweepDimension> list;
  for (const std::string& name : results_.at("status").coordinates) {
    const StoredVariable* variable = results_.find(name);
    if (variable != nullptr && variable->dimensions == std::vector<std::string>{"sample"}) {
      list.push_back(coordinate(*variable));
    }
  }
  return list;
}

std::vector<SweepVariable> variables_of(const NetcdfReader& results, const std::string& quantity) {
  if (results.find(quantity) != nullptr) return {{quantity}};
  std::vector<SweepVariable> found;
  for (std::size_t b = 1; results.find(fmt::format("elevation_{}", b)) != nullptr; ++b) {
    std::string name = fmt::format("{}_{}", quantity, b);
    if (results.find(name) != nullptr) found.push_back({std::move(name), b});
  }
  return found;
}

const std::vector<SweepKind>& sweep_kinds() {
  static const std::vector<SweepKind> kinds = {
      {"peak-force", "peak_force", "Peak contact force F", false, true},
      {"amplification", "amplification", "Amplification of max |x|"},
      {"contact-duration", "contact_duration", "Time in contact", true, true},
      {"impacts", "impacts", "Impacts", true, true},
      {"penetration", "peak_penetration", "Peak penetration δ", false, true},
      {"impulse", "impulse", "Impulse of all impacts", true, true},
      {"displacement", "peak_displacement", "Displacement max |x|"},
      {"acceleration", "peak_acceleration", "Peak floor acceleration"},
      {"acceleration-ratio", "acceleration_ratio", "Floor acceleration, ratio"},
      {"shear", "peak_storey_shear", "Peak storey shear V"},
      {"shear-ratio", "storey_shear_ratio", "Storey shear, ratio"},
      {"drift", "peak_drift_ratio", "Peak storey drift Δ/h"},
  };
  return kinds;
}

}  // namespace bentur
