#include "bentur/study/remedy/objective_slopes.h"

#include <algorithm>
#include <cmath>

#include "bentur/core/errors.h"
#include "bentur/model/case.h"
#include "bentur/pounding/tangent/problem_tangents.h"
#include "bentur/study/remedy/remedy.h"
#include "bentur/study/study_variables.h"

namespace bentur {
namespace {

using Places = std::vector<double>;

constexpr double step = 1e-6;        // of u: its square is below what assembly keeps
constexpr double slow_start = 1e-3;  // of the usual speed of contact: no derivative holds for long
constexpr double counts = 0.5;       // of the largest: peaks further below are not soon the largest
constexpr double as_large = 1e-6;    // of a peak: two that are as large are named by either

/// The peaks that a part of a row is of; nothing: it is none of these.
std::optional<std::vector<const Derivative*>> peaks_of(const RowPart& part, const Tangents* found) {
  std::vector<const Derivative*> peaks;
  const auto all = [&](const std::vector<Derivative>& of) {
    for (const Derivative& one : of) peaks.push_back(&one);
  };
  const std::string name = without_number(part.name);
  const auto building = static_cast<std::size_t>(part.building);
  if (name == "gap_needed" || name == "point_gap_needed") {
    if (found != nullptr) all(found->needed);
  } else if (name == "peak_force") {
    if (found != nullptr) all(found->peak_force);
  } else if (name == "peak_displacement") {
    if (found != nullptr) all(found->displacement[building]);
  } else if (name == "peak_displacement_no_contact") {
    if (found != nullptr) all(found->displacement_free[building]);
  } else {
    return std::nullopt;
  }
  return peaks;
}

}  // namespace

bool ObjectiveSlopes::may_be() const {
  return std::all_of(of_.begin(), of_.end(), [](const RowPart& part) { return peaks_of(part, nullptr).has_value(); });
}

RunValues ObjectiveSlopes::at(const Places& places) const {
  return [this, places](const std::vector<Choice>& choices, const std::function<bool()>& go_on) {
    return values_at(places, choices, go_on);
  };
}

std::vector<FunctionPart> ObjectiveSlopes::parts(const std::vector<double>& values) const {
  std::vector<FunctionPart> parts;
  const auto size = static_cast<std::ptrdiff_t>(1 + axes_.size());
  for (auto i = values.begin(); i != values.end(); i += size) parts.push_back({*i, Places(i + 1, i + size)});
  return parts;
}

std::optional<ReadCase> ObjectiveSlopes::read_at(const Places& places, const std::vector<Choice>& choices) const {
  const Study one = chosen_study(study_, places);
  Diagnostics found;
  ReadCase read = read_chosen(one, chosen_case(one, choices), *memo_, found);
  if (!found.ok()) return std::nullopt;
  return read;
}

std::optional<std::vector<double>> ObjectiveSlopes::values_at(const Places& places, const std::vector<Choice>& choices,
                                                              const std::function<bool()>& go_on) const {
  const std::vector<double> none;
  try {
    const std::optional<ReadCase> here = read_at(places, choices);
    if (!here || !std::holds_alternative<ExactSolver>(here->c.analysis.solver)) return none;
    std::vector<ProblemVariation> variations;
    for (std::size_t i = 0; i < places.size(); ++i) {
      Places low = places, high = places;
      low[i] = std::max(0.0, places[i] - step);
      high[i] = std::min(1.0, places[i] + step);
      const std::optional<ReadCase> below = read_at(low, choices), above = read_at(high, choices);
      if (!below || !above) return none;
      variations.push_back({(high[i] - low[i]) / 2, below->problem(), above->problem()});
    }
    const ProblemTangents all =
        tangents(here->problem(), variations, run_limits(here->c.analysis), [&](double) { return go_on(); });
    if (all.status == Status::stopped) return std::nullopt;
    const auto is_left_out = [](const std::optional<std::string>& why) { return why.has_value(); };
    if (all.refused || all.status != Status::done ||
        std::any_of(all.left_out.begin(), all.left_out.end(), is_left_out)) {
      return none;
    }
    std::vector<const Derivative*> peaks;
    for (const RowPart& part : of_) {
      const std::vector<const Derivative*> more = *peaks_of(part, &all.found);
      peaks.insert(peaks.end(), more.begin(), more.end());
    }
    double most = 0;
    for (const Derivative* const peak : peaks) most = std::max(most, peak->value);
    std::vector<double> values;
    for (const Derivative* const peak : peaks) {
      if (peak->value < counts * most || peak->value <= 0) continue;
      const bool holds = peak->by.size() > 0 && peak->by.allFinite() && peak->grazing >= slow_start;
      if (!holds && peak->value > (1 - as_large) * most) return none;
      if (!holds) continue;
      values.push_back(peak->value);
      values.insert(values.end(), peak->by.begin(), peak->by.end());
    }
    return values;
  } catch (const InvalidParameter&) {  // no case, or no derivatives
    return none;
  }
}

}  // namespace bentur
