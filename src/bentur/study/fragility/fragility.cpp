#include "bentur/study/fragility/fragility.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/core/not_known.h"
#include "bentur/core/require.h"
#include "bentur/study/design/distribution.h"
#include "bentur/study/fragility/internal/concave_maximum.h"

namespace bentur {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// φ(z)/Φ(z) and ln Φ(z), also where Φ is not a number of the machine any more.
struct Tail {
  double ratio = 0, logarithm = 0;

  explicit Tail(double z) : logarithm(log_normal_probability(z)) {
    const double log_density = -0.5 * z * z - 0.5 * std::log(2 * std::numbers::pi);
    ratio = std::exp(log_density - logarithm);
  }
};

/// Sum (2) and its derivatives by a and b of z = a + b u.
struct Likelihood {
  double value = 0;
  double da = 0, db = 0;             ///< gradient
  double haa = 0, hab = 0, hbb = 0;  ///< negative Hessian, positive definite

  Likelihood(const std::vector<StandardLevel>& levels, double a, double b) {
    for (const StandardLevel& level : levels) {
      const double z = a + b * level.u;
      const Tail event(z), other(-z);
      value += weighted(level.events, event.logarithm) + weighted(level.others, other.logarithm);
      const double slope = level.events * event.ratio - level.others * other.ratio;
      const double bend =
          level.events * event.ratio * (event.ratio + z) + level.others * other.ratio * (other.ratio - z);
      da += slope;
      db += slope * level.u;
      haa += bend;
      hab += bend * level.u;
      hbb += bend * level.u * level.u;
    }
  }

 private:
  static double weighted(double count, double logarithm) { return count > 0 ? count * logarithm : 0; }
};

/// Runs per intensity, ascending.
std::vector<IntensityCount> joined(const std::vector<IntensityCount>& counts) {
  std::map<double, IntensityCount> levels;
  for (const IntensityCount& one : counts) {
    require_positive("intensity", one.intensity);
    if (one.events < 0 || one.runs < one.events) {
      throw InvalidParameter("events", std::to_string(one.events),
                             "must be from 0 to the number of runs, " + std::to_string(one.runs));
    }
    if (one.runs == 0) continue;
    IntensityCount& level = levels[one.intensity];
    level.intensity = one.intensity;
    level.runs += one.runs;
    level.events += one.events;
  }
  std::vector<IntensityCount> result;
  result.reserve(levels.size());
  for (const auto& [intensity, level] : levels) result.push_back(level);
  return result;
}

/// ln L where P jumps from 0 to 1 at an intensity: only runs at that very intensity count, with P = k/n.
double step_likelihood(const std::vector<IntensityCount>& levels) {
  double sum = 0;
  for (const IntensityCount& level : levels) {
    const auto k = static_cast<double>(level.events), n = static_cast<double>(level.runs);
    if (level.events > 0 && level.events < level.runs) sum += k * std::log(k / n) + (n - k) * std::log1p(-k / n);
  }
  return sum;
}

/// What can be said without fitting; `fitted` where (2) has a maximum, θ and β still to be found.
Fragility classified(const std::vector<IntensityCount>& levels) {
  using Kind = Fragility::Kind;
  if (levels.empty()) return {Kind::no_data, not_known, not_known, 0, not_known, not_known};
  double first_event = infinity, last_event = 0, first_none = infinity, last_none = 0;
  for (const IntensityCount& level : levels) {
    if (level.events > 0) {
      first_event = std::min(first_event, level.intensity);
      last_event = level.intensity;
    }
    if (level.events < level.runs) {
      first_none = std::min(first_none, level.intensity);
      last_none = level.intensity;
    }
  }
  Fragility result{Kind::fitted, not_known, not_known, 0, last_none, first_event};
  if (last_event == 0) {
    result.kind = Kind::no_event;
    result.median = infinity;
    result.dispersion = 0;
  } else if (last_none == 0) {
    result.kind = Kind::all_events;
    result.median = 0;
    result.dispersion = 0;
  } else if (levels.size() == 1) {
    result.kind = Kind::one_intensity;
    result.log_likelihood = step_likelihood(levels);
  } else if (first_event >= last_none) {
    result.kind = Kind::separated;
    result.median = std::sqrt(last_none) * std::sqrt(first_event);
    result.dispersion = 0;
    result.log_likelihood = step_likelihood(levels);
  } else if (last_event <= first_none) {
    result.kind = Kind::falling;
  }
  return result;
}

/// Of what was observed at an intensity from the curve; 0 without runs.
double distance_at(const IntensityCount& one, const Fragility& fit) {
  if (one.runs == 0) return 0.0;
  return std::abs(static_cast<double>(one.events) / static_cast<double>(one.runs) - fit.probability(one.intensity));
}

}  // namespace

double Fragility::probability(double intensity) const {
  require_positive("intensity", intensity);
  if (kind == Kind::no_event) return 0;
  if (kind == Kind::all_events) return 1;
  const double beyond = kind == Kind::separated ? (intensity < median ? 0 : (intensity > median ? 1 : 0.5))
                                                : normal_probability(std::log(intensity / median) / dispersion);
  if (!collapse) return beyond;
  const double gone = collapse->probability(intensity);
  return gone + (1 - gone) * beyond;
}

double Fragility::intensity_of(double p) const {
  if (!(p > 0 && p < 1)) throw InvalidParameter("p", std::to_string(p), "must be in (0, 1)");
  const auto of_standing = [&](double q) {
    return dispersion == 0 ? median : median * std::exp(dispersion * normal_quantile(q));
  };
  if (!collapse) return of_standing(p);
  if (collapse->kind != CollapseFit::Kind::fitted) return not_known;
  // Each part alone reaches p later than both; where neither has reached half of p, both have not reached p.
  double low = std::log(std::min(of_standing(p / 2), collapse->intensity_of(p / 2)));
  double high = std::log(std::min(of_standing(p), collapse->intensity_of(p)));
  constexpr int halvings = 60;  // of logarithms, to round-off
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (probability(std::exp(middle)) < p ? low : high) = middle;
  }
  return std::exp(0.5 * (low + high));
}

double log_likelihood(const std::vector<IntensityCount>& counts, double median, double dispersion) {
  require_positive("median", median);
  require_positive("dispersion", dispersion);
  std::vector<StandardLevel> levels;
  for (const IntensityCount& one : joined(counts)) {
    levels.push_back({std::log(one.intensity / median), static_cast<double>(one.events),
                      static_cast<double>(one.runs - one.events)});
  }
  return Likelihood(levels, 0, 1 / dispersion).value;
}

Fragility fit_fragility(const std::vector<IntensityCount>& counts) {
  const std::vector<IntensityCount> joined_counts = joined(counts);
  Fragility result = classified(joined_counts);
  if (result.kind != Fragility::Kind::fitted) return result;

  const StandardLevels data(joined_counts);
  double a = normal_quantile(data.events / data.runs), b = 0;  // no dependence on intensity: any point does
  const auto at = maximised<Likelihood>(data.levels, a, b);
  result.log_likelihood = at.value * data.runs;
  const double log_median = data.mean - a / b * data.spread;
  if (!(b > 0) || !(std::abs(log_median) < 700)) {  // as good as level: θ is no number of the machine
    result.kind = Fragility::Kind::falling;
    return result;
  }
  result.dispersion = data.spread / b;
  result.median = std::exp(log_median);
  return result;
}

std::optional<double> fit_distance(const std::vector<IntensityCount>& counts, const Fragility& fit) {
  if (fit.kind != Fragility::Kind::fitted || (fit.collapse && !fit.collapse->is_known())) return std::nullopt;
  double largest = 0;
  for (const IntensityCount& one : counts) largest = std::max(largest, distance_at(one, fit));
  return largest;
}

double fit_distance_limit(long runs) {
  const double root = std::sqrt(static_cast<double>(runs));
  return 0.895 / (root - 0.01 + 0.85 / root);
}

bool is_misfit(const std::vector<IntensityCount>& counts, const Fragility& fit) {
  return fit.kind == Fragility::Kind::fitted && std::any_of(counts.begin(), counts.end(), [&](const auto& one) {
           return one.runs > 0 && distance_at(one, fit) > fit_distance_limit(one.runs);
         });
}

bool is_extrapolated(const std::vector<IntensityCount>& counts, const Fragility& fit) {
  if (fit.kind != Fragility::Kind::fitted) return false;
  bool below = true, above = true;  // all intensities are
  for (const IntensityCount& one : counts) {
    if (one.runs == 0) continue;
    below = below && one.intensity < fit.median;
    above = above && one.intensity > fit.median;
  }
  return below || above;
}

Interval percentile_interval(std::vector<double> values, double confidence) {
  if (values.empty()) return {not_known, not_known};
  std::sort(values.begin(), values.end());
  const double tail = 0.5 * (1 - confidence) * static_cast<double>(values.size());
  const auto rank = std::min(static_cast<std::size_t>(tail), (values.size() - 1) / 2);
  return {values[rank], values[values.size() - 1 - rank]};
}

FragilityBounds bootstrap_fragility(std::size_t units, const BootstrapOptions& options,
                                    const std::function<Fragility(std::span<const std::size_t>)>& fit_of) {
  if (units == 0) throw InvalidParameter("units", "0", "needs one at least");
  if (options.resamples < 1) {
    throw InvalidParameter("resamples", std::to_string(options.resamples), "must be >= 1");
  }
  if (!(options.confidence > 0 && options.confidence < 1)) {
    throw InvalidParameter("confidence", std::to_string(options.confidence), "must be in (0, 1)");
  }
  std::mt19937_64 generator(options.seed);
  const std::uint64_t count = units;
  // The standard fixes the generator but not how its distributions use it: so take the remainder, whose bias is
  // count/2⁶⁴.
  FragilityBounds bounds;
  bounds.confidence = options.confidence;
  std::vector<double> medians, dispersions;
  std::vector<std::size_t> sample(units);
  for (int i = 0; i < options.resamples; ++i) {
    for (std::size_t& drawn : sample) drawn = static_cast<std::size_t>(generator() % count);
    const Fragility fit = fit_of(sample);
    bounds.fits.push_back(fit);
    if (std::isnan(fit.median)) continue;
    medians.push_back(fit.median);
    dispersions.push_back(fit.dispersion);
  }
  bounds.usable = static_cast<int>(medians.size());
  bounds.median = percentile_interval(std::move(medians), options.confidence);
  bounds.dispersion = percentile_interval(std::move(dispersions), options.confidence);
  return bounds;
}

FragilityBounds bootstrap_fragility(const std::vector<std::vector<IntensityCount>>& units,
                                    const BootstrapOptions& options) {
  std::vector<IntensityCount> sample;
  return bootstrap_fragility(units.size(), options, [&](std::span<const std::size_t> drawn) {
    sample.clear();
    for (const std::size_t unit : drawn) sample.insert(sample.end(), units[unit].begin(), units[unit].end());
    return fit_fragility(sample);
  });
}

GapForProbability gap_for_probability(const std::vector<double>& widths, const std::vector<double>& probabilities,
                                      double p) {
  require_size("probabilities", probabilities.size(), widths.size());
  if (widths.empty()) throw InvalidParameter("widths", "0 values", "needs one at least");
  if (!(p > 0 && p < 1)) throw InvalidParameter("p", std::to_string(p), "must be in (0, 1)");
  for (std::size_t i = 0; i < widths.size(); ++i) {
    require_not_negative(indexed("widths", i), widths[i]);
    if (i > 0 && !(widths[i] > widths[i - 1])) {
      throw InvalidParameter(indexed("widths", i), std::to_string(widths[i]), "must ascend");
    }
    if (!(probabilities[i] >= 0 && probabilities[i] <= 1)) {
      throw InvalidParameter(indexed("probabilities", i), std::to_string(probabilities[i]), "must be in [0, 1]");
    }
  }
  std::size_t next = widths.size();  // the first width from which on all are good
  while (next > 0 && probabilities[next - 1] <= p) --next;
  if (next == widths.size()) return {GapForProbability::Kind::beyond, widths.back()};
  if (next == 0) return {GapForProbability::Kind::smallest, widths.front()};
  const double above = probabilities[next - 1], below = probabilities[next];
  double part = 1;
  if (above < 1 && below > 0) {
    const double z = normal_quantile(above);
    part = (z - normal_quantile(p)) / (z - normal_quantile(below));
  }
  return {GapForProbability::Kind::between, widths[next - 1] + part * (widths[next] - widths[next - 1])};
}

}  // namespace bentur
