#include "bentur/report/studies/sweep_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

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

std::string SweepDimension::value(std::size_t i) const { return is_text() ? texts[i] : number_text(numbers[i]); }

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

SweepData::SweepData(const NetcdfReader& results, FigureWords say) : results_(results), say_(std::move(say)) {
  const StoredVariable& status = results.at("status");
  for (std::size_t d = 0; d < status.dimensions.size(); ++d) {
    const std::string& name = status.dimensions[d];
    const StoredVariable* variable = results.find(name);
    if (variable != nullptr && variable->long_name == index_title) variable = nullptr;
    for (std::size_t i = 0; variable == nullptr && i < status.coordinates.size() && name != "sample"; ++i) {
      const StoredVariable* other = results.find(status.coordinates[i]);  // of several that move together
      if (other != nullptr && other->dimensions == std::vector<std::string>{name}) variable = other;
    }
    SweepDimension one;
    if (variable != nullptr) one = coordinate(*variable);
    one.name = name;
    one.size = status.shape[d];
    dimensions_.push_back(std::move(one));
  }
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

std::vector<double> SweepData::values(const std::string& quantity, const std::vector<std::size_t>& at) const {
  const auto [known, is_new] = held_.try_emplace(quantity);
  std::vector<double>& held = known->second;
  if (is_new) {
    held = results_.numbers(quantity);
    if (is_compared_by_size(results_, quantity)) {
      for (double& value : held) value = std::abs(value);
    }
  }
  std::size_t run = 0;
  for (std::size_t d = 0; d < dimensions_.size(); ++d) run = run * dimensions_[d].size + at[d];
  const std::size_t count = owners(quantity);
  const auto first = held.begin() + static_cast<std::ptrdiff_t>(run * count);
  return {first, first + static_cast<std::ptrdiff_t>(count)};
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
      names.push_back(unit.empty() ? word(say_, "floor {}", number_text(z)) : "z = " + number_text(z) + unit);
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

}  // namespace bentur
