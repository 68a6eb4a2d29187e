#include "bentur/study/remedy/objective_slopes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/model/case.h"
#include "bentur/pounding/tangent/problem_tangents.h"
#include "bentur/study/problem_as.h"
#include "bentur/study/remedy/remedy.h"
#include "bentur/study/study_variables.h"

namespace bentur {
namespace {

using Places = std::vector<double>;

constexpr double step = 1e-6;        // of u: its square is below what assembly keeps
constexpr double slow_start = 1e-3;  // of the usual speed of contact: no derivative holds for long
constexpr double counts = 0.5;       // of the largest: peaks further below are not soon the largest
constexpr double as_large = 1e-6;    // of a peak: two that are as large are named by either

/// Of buildings in plan displacements stand in a list kind after kind: of centres of mass along x and y, of edges.
constexpr std::array<std::string_view, 6> kinds_in_plan = {"_x", "_y", "_south", "_north", "_west", "_east"};

/// What is asked of displacements of floors: of a row all, of a plan one of its kinds; nothing: another quantity.
struct OfFloors {
  bool without_contact = false;
  std::optional<std::size_t> kind = {};
};
std::optional<OfFloors> displacement_of(const RowPart& part) {
  constexpr std::string_view first = "peak_displacement", last = "_no_contact";
  const std::string number_left_out = without_number(part.name);
  std::string_view name = number_left_out;
  if (part.owner != Owner::floor || !name.starts_with(first)) return std::nullopt;
  name.remove_prefix(first.size());
  OfFloors asked{.without_contact = name.ends_with(last)};
  if (asked.without_contact) name.remove_suffix(last.size());
  if (name.empty()) return asked;
  const auto kind = std::find(kinds_in_plan.begin(), kinds_in_plan.end(), name);
  if (kind == kinds_in_plan.end()) return std::nullopt;
  asked.kind = static_cast<std::size_t>(kind - kinds_in_plan.begin());
  return asked;
}

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
  } else if (const auto asked = displacement_of(part)) {
    if (found == nullptr) return peaks;
    all((asked->without_contact ? found->displacement_free : found->displacement)[building]);
    if (asked->kind) {
      const std::size_t floors = peaks.size() / kinds_in_plan.size();
      peaks.erase(peaks.begin() + static_cast<std::ptrdiff_t>((*asked->kind + 1) * floors), peaks.end());
      peaks.erase(peaks.begin(), peaks.end() - static_cast<std::ptrdiff_t>(floors));
    }
  } else {
    return std::nullopt;
  }
  return peaks;
}

/// What of a run and of those with a little more and a little less of each choice follows.
template <class AnyProblem>
ProblemTangents tangents_by(const ReadCase& here, const std::vector<std::pair<ReadCase, ReadCase>>& varied,
                            const std::vector<double>& steps, const std::function<bool()>& go_on) {
  std::vector<VariationOf<AnyProblem>> variations;
  for (std::size_t i = 0; i < varied.size(); ++i) {
    const auto& [below, above] = varied[i];
    variations.push_back({steps[i], problem_as<AnyProblem>(below), problem_as<AnyProblem>(above)});
  }
  return tangents(problem_as<AnyProblem>(here), variations, run_limits(here.c.analysis),
                  [&](double) { return go_on(); });
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
    std::vector<std::pair<ReadCase, ReadCase>> varied;
    std::vector<double> steps;
    for (std::size_t i = 0; i < places.size(); ++i) {
      Places low = places, high = places;
      low[i] = std::max(0.0, places[i] - step);
      high[i] = std::min(1.0, places[i] + step);
      std::optional<ReadCase> below = read_at(low, choices), above = read_at(high, choices);
      if (!below || !above) return none;
      varied.emplace_back(*std::move(below), *std::move(above));
      steps.push_back((high[i] - low[i]) / 2);
    }
    const ProblemTangents all = here->plan ? tangents_by<PlanProblem>(*here, varied, steps, go_on)
                                           : tangents_by<Problem>(*here, varied, steps, go_on);
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
