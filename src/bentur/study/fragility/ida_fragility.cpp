#include "bentur/study/fragility/ida_fragility.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/core/not_known.h"
#include "bentur/core/require.h"
#include "bentur/study/quantiles.h"

namespace bentur {
namespace {

using FragilityKind = Fragility::Kind;

Fragility without_collapse(Fragility fit) {
  fit.collapse.reset();
  return fit;
}

/// Of the runs that stand, by a fit alone.
std::optional<double> standing_probability(const Fragility& fit, double intensity) {
  switch (fit.kind) {
    case FragilityKind::fitted:
    case FragilityKind::no_event:
    case FragilityKind::all_events:
      return without_collapse(fit).probability(intensity);
    case FragilityKind::separated:
      return intensity < fit.lower || (intensity == fit.lower && fit.lower < fit.upper) ? 0.0 : 1.0;
    case FragilityKind::one_intensity:
    case FragilityKind::falling:
    case FragilityKind::no_data:
      break;
  }
  return std::nullopt;
}

/// By a fit alone; see CaseFragility::probability.
std::optional<double> probability_of(const Fragility& fit, double intensity) {
  const std::optional<double> beyond = standing_probability(fit, intensity);
  if (!beyond || !fit.collapse) return beyond;
  if (!fit.collapse->is_known()) return std::nullopt;
  const double gone = fit.collapse->probability(intensity);
  return gone + (1 - gone) * *beyond;
}

/// The fit of resample `i`: of a case without bounds that of all data where every resample gives the same one.
const Fragility* resampled_fit(const CaseFragility& fragility, std::size_t i) {
  if (fragility.bounds) return &fragility.bounds->fits[i];
  const bool same = fragility.fit.kind == FragilityKind::no_event || fragility.fit.kind == FragilityKind::all_events;
  return same ? &fragility.fit : nullptr;
}

std::optional<Interval> gap_bounds(const std::vector<double>& widths, const std::vector<const CaseFragility*>& all,
                                   double intensity, double p, double confidence) {
  std::size_t resamples = 0;
  for (const CaseFragility* one : all) {
    if (one->bounds) resamples = one->bounds->fits.size();
  }
  std::vector<double> gaps;
  for (std::size_t i = 0; i < resamples; ++i) {
    std::vector<double> probabilities;
    for (const CaseFragility* one : all) {
      const Fragility* fit = resampled_fit(*one, i);
      if (fit == nullptr) return std::nullopt;
      if (const auto probability = probability_of(*fit, intensity)) probabilities.push_back(*probability);
    }
    if (probabilities.size() < all.size()) continue;
    const GapForProbability gap = gap_for_probability(widths, probabilities, p);
    gaps.push_back(gap.kind == GapForProbability::Kind::beyond ? std::numeric_limits<double>::infinity() : gap.width);
  }
  if (gaps.empty()) return std::nullopt;
  return percentile_interval(std::move(gaps), confidence);
}

/// Runs and events by intensity.
class Counts {
 public:
  explicit Counts(const OutcomeTable& table) {
    for (const double x : table.intensities()) counts_[x] = {x, 0, 0};
  }
  void add(double intensity, bool has_event) {
    IntensityCount& one = counts_.at(intensity);
    ++one.runs;
    one.events += has_event ? 1 : 0;
  }
  [[nodiscard]] std::vector<IntensityCount> take() const {
    std::vector<IntensityCount> result;
    for (const auto& [intensity, one] : counts_) result.push_back(one);
    return result;
  }

 private:
  std::map<double, IntensityCount> counts_;
};

/// Calls back with intensity, run number and record of every run of a case that makes a case.
template <class Tell>
void for_each_run(const OutcomeTable& table, std::size_t c, const Tell& tell) {
  for (std::size_t record = 0; record < table.records; ++record) {
    for (std::size_t level = 0; level < table.levels.size(); ++level) {
      const std::size_t run = (c * table.records + record) * table.levels.size() + level;
      if (table.outcomes[run] != Outcome::failed) tell(table.intensity(record, level), run, record);
    }
  }
}

/// Nothing where no run collapses, or no event but collapses.
std::optional<CaseFragility::Split> split_off(const OutcomeTable& table, std::size_t c) {
  require_size("collapsed", table.collapsed.size(), table.outcomes.size());
  CaseFragility::Split split;
  Counts all(table), standing(table);
  long collapses = 0, standing_events = 0;
  for_each_run(table, c, [&](double intensity, std::size_t run, std::size_t) {
    const bool collapsed = table.collapsed[run] != 0, has_event = table.outcomes[run] == Outcome::event;
    all.add(intensity, collapsed);
    collapses += collapsed ? 1 : 0;
    if (collapsed) return;
    standing.add(intensity, has_event);
    standing_events += has_event ? 1 : 0;
  });
  if (collapses == 0 || standing_events == 0) return std::nullopt;
  split.collapse_counts = all.take();
  split.standing_counts = standing.take();
  split.collapse = fit_fragility(split.collapse_counts);
  split.standing = fit_fragility(split.standing_counts);
  return split;
}

Fragility fit_of_demands(const std::vector<RunDemand>& demands, double threshold, FragilityMethod method) {
  if (method == FragilityMethod::stripes) return stripe_fragility(stripes_of(demands), threshold);
  std::vector<IntensityCount> collapses;
  for (const RunDemand& one : demands) collapses.push_back({one.intensity, 1, one.collapsed ? 1 : 0});
  const CollapseFit collapse = fit_collapse(collapses);
  if (collapse.kind == CollapseFit::Kind::all) return fit_fragility(collapses);  // each has the event, whatever it is
  Fragility fit;
  fit.median = fit.dispersion = not_known;
  if (const auto cloud = fit_cloud(demands)) fit = cloud_fragility(*cloud, threshold);
  if (collapse.kind != CollapseFit::Kind::none) fit.collapse = collapse;
  return fit;
}

/// Bounds too, from two records on: whole records are resampled, each with all its demands.
void fit_demands(const OutcomeTable& table, std::size_t c, const BootstrapOptions& options, FragilityMethod method,
                 CaseFragility& result) {
  require_size("demands", table.demands.size(), table.outcomes.size());
  require_positive("threshold", table.threshold.value_or(0));
  std::vector<std::vector<RunDemand>> units(table.records / table.together);
  for_each_run(table, c, [&](double intensity, std::size_t run, std::size_t record) {
    units[record / table.together].push_back({intensity, table.demands[run], table.collapsed.at(run) != 0});
  });
  std::vector<RunDemand> all;
  for (const std::vector<RunDemand>& unit : units) all.insert(all.end(), unit.begin(), unit.end());
  result.fit = fit_of_demands(all, *table.threshold, method);
  if (method == FragilityMethod::stripes) result.stripes = stripes_of(all);
  if (method == FragilityMethod::cloud) result.cloud = fit_cloud(all);
  const bool is_known = result.fit.kind == FragilityKind::fitted || result.fit.kind == FragilityKind::separated ||
                        result.fit.kind == FragilityKind::falling;
  if (units.size() < 2 || !is_known) return;
  std::vector<RunDemand> sample;
  result.bounds = bootstrap_fragility(units.size(), options, [&](std::span<const std::size_t> drawn) {
    sample.clear();
    for (const std::size_t unit : drawn) sample.insert(sample.end(), units[unit].begin(), units[unit].end());
    return fit_of_demands(sample, *table.threshold, method);
  });
}

}  // namespace

std::optional<double> CaseFragility::probability(double intensity) const {
  if (fit.kind == FragilityKind::one_intensity) return static_cast<double>(events) / static_cast<double>(runs);
  return probability_of(fit, intensity);
}

std::optional<double> CaseFragility::distance() const {
  const bool is_known = fit.kind == FragilityKind::fitted;
  if (is_unscaled) return cloud && is_known ? std::optional(cloud->distance) : std::nullopt;
  const bool of_standing = cloud && split && !is_of_all();
  return fit_distance(of_standing ? split->standing_counts : counts, of_standing ? without_collapse(fit) : fit);
}

bool CaseFragility::is_misfit() const {
  if (is_unscaled) return distance() && *distance() > fit_distance_limit(cloud->runs);
  const bool of_standing = cloud && split && !is_of_all();
  return bentur::is_misfit(of_standing ? split->standing_counts : counts, of_standing ? without_collapse(fit) : fit);
}

std::optional<CaseFragility::OfAll> CaseFragility::of_all() const {
  if (!fit.collapse || !is_of_all() || fit.kind != FragilityKind::fitted) return std::nullopt;
  const auto from_to = [](const Fragility& one) {
    constexpr double below = 0.15865525393145705, above = 1 - below;  // Φ(−1), Φ(1)
    return std::pair(one.intensity_of(0.5), 0.5 * std::log(one.intensity_of(above) / one.intensity_of(below)));
  };
  OfAll result;
  std::tie(result.median, result.dispersion) = from_to(fit);
  if (!bounds) return result;
  std::vector<double> medians, dispersions;
  for (const Fragility& one : bounds->fits) {
    if (one.kind != FragilityKind::fitted || (one.collapse && !one.collapse->is_known())) continue;
    const auto [median, dispersion] = from_to(one);
    medians.push_back(median);
    dispersions.push_back(dispersion);
  }
  result.usable = static_cast<int>(medians.size());
  result.median_bounds = percentile_interval(std::move(medians), bounds->confidence);
  result.dispersion_bounds = percentile_interval(std::move(dispersions), bounds->confidence);
  return result;
}

const std::vector<std::string>& fragility_methods() {
  static const std::vector<std::string> names = {"likelihood", "cloud", "stripes"};
  return names;
}

FragilityMethod fragility_method(const std::string& name) {
  const std::vector<std::string>& names = fragility_methods();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw InvalidParameter("method", name, "must be likelihood, cloud or stripes");
  return static_cast<FragilityMethod>(found - names.begin());
}

const std::string& name_of(FragilityMethod method) { return fragility_methods().at(static_cast<std::size_t>(method)); }

std::vector<double> OutcomeTable::intensities() const {
  std::set<double> all;
  for (const double x : is_cloud() ? own : levels) {
    if (!std::isnan(x)) all.insert(x);
  }
  return {all.begin(), all.end()};
}

CaseFragility fit_case(const OutcomeTable& table, std::size_t c, const BootstrapOptions& options,
                       FragilityMethod method) {
  require_size("outcomes", table.outcomes.size(), table.cases * table.records * table.levels.size());
  require_size("records", table.records, table.records / table.together * table.together);
  if (table.is_cloud()) {
    require_size("own", table.own.size(), table.records);
    require_size("levels", table.levels.size(), 1);
  }
  CaseFragility result;
  std::vector<std::vector<IntensityCount>> units(table.records / table.together);
  result.is_unscaled = table.is_cloud();
  Counts counts(table);
  for (std::size_t record = 0; record < table.records; ++record) {
    for (std::size_t level = 0; level < table.levels.size(); ++level) {
      const Outcome outcome = table.at(c, record, level);
      if (outcome == Outcome::failed) {
        ++result.failed;
        continue;
      }
      const long events = outcome == Outcome::event ? 1 : 0;
      units[record / table.together].push_back({table.intensity(record, level), 1, events});
      counts.add(table.intensity(record, level), events > 0);
      ++result.runs;
      result.events += events;
    }
  }
  result.counts = counts.take();
  result.fit = fit_fragility(result.counts);
  if (!table.collapsed.empty()) result.split = split_off(table, c);
  if (method != FragilityMethod::likelihood) {
    fit_demands(table, c, options, method, result);
    return result;
  }
  const FragilityKind kind = result.fit.kind;
  if (units.size() > 1 &&
      (kind == FragilityKind::fitted || kind == FragilityKind::separated || kind == FragilityKind::falling)) {
    result.bounds = bootstrap_fragility(units, options);
  }
  return result;
}

std::optional<Interval> probability_bounds(const CaseFragility& fragility, double intensity, double confidence) {
  std::vector<double> values;
  if (fragility.bounds) {
    for (const Fragility& one : fragility.bounds->fits) {
      const double p = one.probability(intensity);
      if (!std::isnan(p)) values.push_back(p);
    }
  }
  if (values.empty()) return std::nullopt;
  const double tail = 0.5 * (1 - confidence);
  return Interval{quantile_of(values, tail), quantile_of(values, 1 - tail)};
}

GapEstimate gap_estimate(const std::vector<double>& widths, const std::vector<const CaseFragility*>& fragilities,
                         double intensity, double p, double confidence) {
  GapEstimate result;
  std::vector<double> probabilities;
  for (const CaseFragility* one : fragilities) {
    if (const auto probability = one->probability(intensity)) probabilities.push_back(*probability);
  }
  if (probabilities.size() < fragilities.size()) return result;
  result.gap = gap_for_probability(widths, probabilities, p);
  result.bounds = gap_bounds(widths, fragilities, intensity, p, confidence);
  return result;
}

}  // namespace bentur
