#include "bentur/study/risk/annual_rate.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/study/design/distribution.h"

namespace bentur {
namespace {

/// ln(Φ(b) − Φ(a)) for a < b, without cancellation in either tail.
double log_difference(double a, double b) {
  if (a + b > 0) return log_difference(-b, -a);
  const double upper = log_normal_probability(b);
  return upper + std::log(-std::expm1(log_normal_probability(a) - upper));
}

struct HazardSegment {
  double a, b, rate_a, rate_b, slope;
};

HazardSegment segment_at(const HazardCurve& hazard, std::size_t i) {
  return {hazard.intensity[i], hazard.intensity[i + 1], hazard.rate[i], hazard.rate[i + 1], hazard.slope(i)};
}

/// (2)
double lognormal_part(const HazardSegment& s, double median, double dispersion) {
  const double za = std::log(s.a / median) / dispersion, zb = std::log(s.b / median) / dispersion;
  const double shift = s.slope * dispersion;
  const double factor = std::log(s.rate_a) + s.slope * std::log(s.a / median) + 0.5 * shift * shift;
  const double moved = std::exp(factor + log_difference(za + shift, zb + shift));
  return std::max(0.0, s.rate_a * normal_probability(za) - s.rate_b * normal_probability(zb) + moved);
}

/// (3) from P = p at a to q at b.
double straight_part(const HazardSegment& s, double p, double q) {
  const double rise = (q - p) / std::log(s.b / s.a);
  const double mean = s.slope > 1e-9 ? (s.rate_a - s.rate_b) / s.slope : s.rate_a * std::log(s.b / s.a);
  return s.rate_a * p - s.rate_b * q + rise * mean;
}

/// P straight in x from `p` at a to `q` at b, where p/a = q/b.
double proportional_part(const HazardSegment& s, double p, double q) {
  const double exponent = 1 - s.slope, width = std::log(s.b / s.a);
  const double grown = std::abs(exponent * width) > 1e-9 ? std::expm1(exponent * width) / exponent : width;
  return s.rate_a * p - s.rate_b * q + p / s.a * s.rate_a * s.a * grown;
}

/// Collapses among runs that would not have the event otherwise: Q = P_C (1 − Φ(z)).
class CollapseCurve {
 public:
  CollapseCurve(double median, double dispersion, const CollapseFit& collapse)
      : median_(median),
        dispersion_(dispersion),
        collapse_(collapse),
        widest_(0.5 * std::min(dispersion, 1 / collapse.slope)) {}

  [[nodiscard]] double at(double x) const {
    return collapse_.probability(x) * normal_probability(-std::log(x / median_) / dispersion_);
  }

  /// ∫ Q |dλ| over a segment.
  [[nodiscard]] double part(const HazardSegment& s) const {
    const double width = std::log(s.b / s.a), pieces = std::max(1.0, std::ceil(width / widest_));
    double sum = 0;
    for (double piece = 0; piece < pieces; ++piece) {
      sum += boost::math::quadrature::gauss<double, 15>::integrate(
          [&](double r) { return at(s.a * std::exp(r)) * s.slope * s.rate_a * std::exp(-s.slope * r); },
          width * piece / pieces, width * (piece + 1) / pieces);
    }
    return sum;
  }

  /// What a hazard of slope k, λ at x, would add from there down to 0.
  [[nodiscard]] double below(double x, double rate, double k) const {
    if (!(k > 0)) return 0;
    if (collapse_.slope <= k) return std::numeric_limits<double>::infinity();
    // So far down that Q is e^{α₀} x^{α₁} to round-off.
    constexpr double deviations = 9, exponent = -37;
    const double low = std::min({x, median_ * std::exp(-deviations * dispersion_),
                                 std::exp((exponent - collapse_.intercept) / collapse_.slope)});
    const double rate_low = rate * std::pow(low / x, -k);
    const double rest = at(low) * rate_low * k / (collapse_.slope - k);
    return rest + (low < x ? part({low, x, rate_low, rate, k}) : 0.0);
  }

 private:
  double median_, dispersion_;
  const CollapseFit& collapse_;
  double widest_;
};

void sum_up(AnnualRate& result) { result.rate = std::accumulate(result.parts.begin(), result.parts.end(), 0.0); }

/// P of observed shares: in which piece x lies is for the caller to know.
class ObservedCurve {
 public:
  explicit ObservedCurve(const std::vector<ObservedShare>& shares) : shares_(shares) {}

  /// ∫ P |dλ| over a part of a segment between two neighbouring breaks.
  [[nodiscard]] double part(const HazardSegment& s) const {
    const double middle = std::sqrt(s.a * s.b);
    if (middle >= shares_.back().intensity) return s.rate_a - s.rate_b;
    if (middle <= shares_.front().intensity) {
      const double slope = shares_.front().probability / shares_.front().intensity;
      return proportional_part(s, slope * s.a, slope * s.b);
    }
    return straight_part(s, at(s.a), at(s.b));
  }

  /// Between the levels.
  [[nodiscard]] double at(double x) const {
    if (x >= shares_.back().intensity) return shares_.back().probability;
    const auto after = std::upper_bound(shares_.begin(), shares_.end(), x,
                                        [](double value, const ObservedShare& one) { return value < one.intensity; });
    if (after == shares_.begin()) return shares_.front().probability;
    const ObservedShare &low = *(after - 1), &high = *after;
    const double place = std::log(x / low.intensity) / std::log(high.intensity / low.intensity);
    return low.probability + place * (high.probability - low.probability);
  }

 private:
  const std::vector<ObservedShare>& shares_;
};

}  // namespace

AnnualRate annual_rate(const HazardCurve& hazard, double median, double dispersion) {
  require_positive("median", median);
  if (!(dispersion >= 0)) throw InvalidParameter("dispersion", std::to_string(dispersion), "must be >= 0");
  AnnualRate result;
  const double first = hazard.intensity.front(), last = hazard.intensity.back();
  for (std::size_t i = 0; i < hazard.segments(); ++i) {
    const HazardSegment s = segment_at(hazard, i);
    if (dispersion > 0) {
      result.parts.push_back(lognormal_part(s, median, dispersion));
    } else {
      const double from = std::clamp(median, s.a, s.b);
      result.parts.push_back((from == s.a ? s.rate_a : hazard.rate_at(from)) - s.rate_b);
      if (from == s.b) result.parts.back() = 0;
    }
  }
  const double unsure =
      dispersion > 0 ? normal_probability(-std::log(last / median) / dispersion) : (median > last ? 1.0 : 0.0);
  result.beyond = hazard.rate.back() * unsure;
  result.parts.push_back(hazard.rate.back());
  sum_up(result);
  const double k = hazard.slope(0);
  if (dispersion > 0) {
    const double z = std::log(first / median) / dispersion, shift = k * dispersion;
    const double whole = std::log(hazard.rate.front()) + k * std::log(first / median) + 0.5 * shift * shift +
                         log_normal_probability(z + shift);
    result.below = std::max(0.0, std::exp(whole) - hazard.rate.front() * normal_probability(z));
  } else if (median < first) {
    result.below = hazard.rate_at(median) - hazard.rate.front();
  }
  return result;
}

AnnualRate annual_rate(const HazardCurve& hazard, double median, double dispersion, const CollapseFit& collapse) {
  require_positive("dispersion", dispersion);
  if (collapse.kind != CollapseFit::Kind::fitted) throw InvalidParameter("collapse", "not fitted", "must be fitted");
  AnnualRate result = annual_rate(hazard, median, dispersion);
  const CollapseCurve gone(median, dispersion, collapse);
  for (std::size_t i = 0; i < hazard.segments(); ++i) result.parts[i] += gone.part(segment_at(hazard, i));
  sum_up(result);
  result.beyond -= hazard.rate.back() * gone.at(hazard.intensity.back());
  result.below += gone.below(hazard.intensity.front(), hazard.rate.front(), hazard.slope(0));
  return result;
}

AnnualRate annual_rate(const HazardCurve& hazard, const std::vector<ObservedShare>& shares) {
  if (shares.empty()) throw InvalidParameter("shares", "none", "must be one or more");
  for (std::size_t i = 0; i < shares.size(); ++i) {
    require_positive("intensity", shares[i].intensity);
    if (i > 0 && !(shares[i].intensity > shares[i - 1].intensity)) {
      throw InvalidParameter("intensity", std::to_string(shares[i].intensity), "must ascend");
    }
  }
  const ObservedCurve observed(shares);
  AnnualRate result;
  for (std::size_t i = 0; i < hazard.segments(); ++i) {
    const HazardSegment s = segment_at(hazard, i);
    std::vector<double> breaks = {s.a};
    for (const ObservedShare& one : shares) {
      if (one.intensity > s.a && one.intensity < s.b) breaks.push_back(one.intensity);
    }
    breaks.push_back(s.b);
    double part = 0;
    for (std::size_t j = 1; j < breaks.size(); ++j) {
      const double from = j == 1 ? s.rate_a : hazard.rate_at(breaks[j - 1]);
      const double to = j + 1 == breaks.size() ? s.rate_b : hazard.rate_at(breaks[j]);
      part += observed.part({breaks[j - 1], breaks[j], from, to, s.slope});
    }
    result.parts.push_back(part);
  }
  result.parts.push_back(hazard.rate.back());
  sum_up(result);
  const double highest = shares.back().intensity, last = hazard.intensity.back();
  const double known = highest < last ? shares.back().probability : observed.at(last);
  result.beyond = (highest < last && highest > hazard.intensity.front() ? hazard.rate_at(highest)
                   : highest < last                                     ? hazard.rate.front()
                                                                        : hazard.rate.back()) *
                  (1 - known);
  const double lowest = shares.front().intensity, k = hazard.slope(0), first = hazard.intensity.front();
  const double p = observed.at(first) * std::min(1.0, first / lowest);
  // ∫ from 0 of P = p x/first; it has an end where k < 1.
  if (p > 0) result.below = k < 1 ? p * hazard.rate.front() * k / (1 - k) : std::numeric_limits<double>::infinity();
  return result;
}

std::vector<ObservedShare> rising_shares(const std::vector<IntensityCount>& counts) {
  struct Pool {
    double events = 0, runs = 0;
    std::size_t size = 0;  // intensities in it
    [[nodiscard]] double share() const { return events / runs; }
  };
  std::vector<ObservedShare> result;
  std::vector<Pool> pools;
  for (const IntensityCount& one : counts) {
    if (one.runs == 0) continue;
    result.push_back({one.intensity, 0});
    Pool next{static_cast<double>(one.events), static_cast<double>(one.runs), 1};
    while (!pools.empty() && pools.back().share() >= next.share()) {
      next = {next.events + pools.back().events, next.runs + pools.back().runs, next.size + pools.back().size};
      pools.pop_back();
    }
    pools.push_back(next);
  }
  std::size_t place = 0;
  for (const Pool& pool : pools) {
    for (std::size_t i = 0; i < pool.size; ++i) result[place++].probability = pool.share();
  }
  return result;
}

double closed_form_rate(const HazardCurve& hazard, double median, double dispersion) {
  const double shift = hazard.slope(hazard.segment_of(median)) * dispersion;
  return hazard.rate_at(median) * std::exp(0.5 * shift * shift);
}

double probability_in(double years, double rate) { return -std::expm1(-rate * years); }

double rate_of_probability(double years, double probability) { return -std::log1p(-probability) / years; }

}  // namespace bentur
