#include "bentur/study/design/record_intensity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

#include "bentur/model/quantities.h"
#include "bentur/solve/spectrum/response_spectrum.h"

namespace bentur {
namespace {

bool decides_record(const ParameterPath& path) {
  if (path.empty() || path.front() != PathStep("excitation")) return false;
  const std::size_t at = path.size() > 1 && path[1] == PathStep("y") ? 2 : 1;  // of the key
  const std::vector<std::string> keys = {"kind",   "file",    "values",    "format",     "time_step", "unit",
                                         "column", "channel", "component", "skip_lines", "polarity"};
  return path.size() == at || std::find(keys.begin(), keys.end(), std::get<std::string>(path[at])) != keys.end();
}

}  // namespace

bool AxisSubset::has(std::size_t axis) const { return std::find(axes.begin(), axes.end(), axis) != axes.end(); }

std::size_t AxisSubset::combinations() const {
  return std::accumulate(sizes.begin(), sizes.end(), std::size_t{1}, std::multiplies<>());
}

std::size_t AxisSubset::place(const std::vector<Choice>& choices) const {
  std::size_t result = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) result = result * sizes[i] + choices[axes[i]].level;
  return result;
}

void AxisSubset::choose(std::size_t place, std::vector<Choice>& choices) const {
  for (std::size_t i = axes.size(); i-- > 0; place /= sizes[i]) choices[axes[i]].level = place % sizes[i];
}

AxisSubset record_axes(const Study& study, bool with_polarity) {
  std::map<std::size_t, std::size_t> sizes;
  for (const Vary& vary : study.varies) {
    const bool is_way =
        std::holds_alternative<std::string>(vary.path.back()) && std::get<std::string>(vary.path.back()) == "polarity";
    if (decides_record(vary.path) && (with_polarity || !is_way)) sizes[vary.axis] = vary.values.size();
  }
  AxisSubset result;
  for (const auto& [axis, size] : sizes) {
    result.axes.push_back(axis);
    result.sizes.push_back(size);
  }
  return result;
}

double intensity_of(const IdaSpec& ida, const SampledMotion& motion, const Units& units) {
  const double acceleration =
      ida.spectral ? oscillator_peaks(motion, ida.period, ida.damping).pseudo_acceleration : peak_acceleration(motion);
  return ida.unit.empty() ? acceleration : acceleration / acceleration_factor(ida.unit, units);
}

double intensity_of_both(IntensityOf what, double x, double y) {
  switch (what) {
    case IntensityOf::geometric_mean:
      return std::sqrt(x * y);
    case IntensityOf::larger:
      return std::max(x, y);
    case IntensityOf::x:
      return x;
    case IntensityOf::y:
      return y;
  }
  return 0;
}

double record_factor(const RecordIntensities& intensities, std::size_t place, double level) {
  if (intensities.normalisation.empty()) return level / intensities.values[place];
  return level * intensities.normalisation[place] / intensities.median;
}

void put_intensity(const RecordIntensities& intensities, const std::vector<Choice>& choices, double level,
                   TomlValue& root) {
  const double factor = record_factor(intensities, intensities.place(choices), level);
  put_value(root, {"excitation", "scale"}, toml_number(factor));
  if (moves_along_y(root)) put_value(root, {"excitation", "y", "scale"}, toml_number(factor));
}

std::string intensity_units(const IdaSpec& ida, const Units& units) {
  if (ida.unit.empty()) return udunit(units.length) + " s-2";
  if (ida.unit != "g") return ida.unit.substr(0, ida.unit.find('/')) + " s-2";
  return units.gravity == standard_gravity(units.length)
             ? "gravity"
             : fmt::format("{} {} s-2", units.gravity, udunit(units.length));
}

std::string intensity_name(const IdaSpec& ida) {
  std::string measure = ida.spectral ? fmt::format("spectral acceleration, period {:.6g} s, damping {:.6g} %",
                                                   ida.period, 100 * ida.damping)
                                     : "peak ground acceleration";
  if (ida.component) {
    switch (*ida.component) {
      case IntensityOf::geometric_mean:
        measure += ", geometric mean of both components";
        break;
      case IntensityOf::larger:
        measure += ", larger of both components";
        break;
      case IntensityOf::x:
        measure += " of [excitation]";
        break;
      case IntensityOf::y:
        measure += " of [excitation.y]";
        break;
    }
  }
  return ida.normalised ? measure + ", median of the normalised records" : measure;
}

}  // namespace bentur
