#include "bentur/study/fragility/demand_fits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "bentur/core/not_known.h"
#include "bentur/core/require.h"
#include "bentur/study/design/distribution.h"

namespace bentur {
namespace {

/// The largest distance of the shares of values up to each of them from those of a normal distribution about 0.
double distance_from_normal(std::vector<double> values, double sigma) {
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  double largest = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double expected = normal_probability(values[i] / sigma);
    const auto below = static_cast<double>(i);
    largest = std::max({largest, expected - below / n, (below + 1) / n - expected});
  }
  return largest;
}

}  // namespace

std::optional<CloudFit> fit_cloud(const std::vector<RunDemand>& demands) {
  double n = 0, x = 0, y = 0;
  const auto counts = [](const RunDemand& one) { return !one.collapsed && one.value > 0 && std::isfinite(one.value); };
  for (const RunDemand& one : demands) {
    require_positive("intensity", one.intensity);
    if (!counts(one)) continue;
    n += 1;
    x += std::log(one.intensity);
    y += std::log(one.value);
  }
  if (n < 3) return std::nullopt;
  x /= n;
  y /= n;
  double xx = 0, xy = 0, yy = 0;
  for (const RunDemand& one : demands) {
    if (!counts(one)) continue;
    const double dx = std::log(one.intensity) - x, dy = std::log(one.value) - y;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  constexpr double round_off = 1e-24;  // of squares of logarithms
  if (!(xx > round_off * n)) return std::nullopt;
  CloudFit fit{.b = xy / xx, .runs = static_cast<long>(n)};
  fit.a = y - fit.b * x;
  std::vector<double> residuals;
  double rest = 0;
  for (const RunDemand& one : demands) {
    if (!counts(one)) continue;
    residuals.push_back(std::log(one.value) - fit.a - fit.b * std::log(one.intensity));
    rest += residuals.back() * residuals.back();
  }
  fit.sigma = rest > round_off * n ? std::sqrt(rest / (n - 2)) : 0;
  if (fit.sigma > 0) fit.distance = distance_from_normal(std::move(residuals), fit.sigma);
  fit.determination = yy > 0 ? 1 - rest / yy : 1;
  return fit;
}

Fragility cloud_fragility(const CloudFit& cloud, double threshold) {
  require_positive("threshold", threshold);
  Fragility fit;
  if (!(cloud.b > 0)) {
    fit.kind = Fragility::Kind::falling;
    fit.median = fit.dispersion = not_known;
    return fit;
  }
  fit.median = std::exp((std::log(threshold) - cloud.a) / cloud.b);
  fit.dispersion = cloud.sigma / cloud.b;
  fit.kind = cloud.sigma > 0 ? Fragility::Kind::fitted : Fragility::Kind::separated;
  fit.lower = fit.upper = fit.median;
  return fit;
}

double Stripe::probability(double threshold) const {
  require_positive("threshold", threshold);
  const double gone = static_cast<double>(collapsed) / static_cast<double>(runs);
  if (collapsed == runs || !(median > 0)) return gone;
  const double beyond =
      dispersion > 0 ? normal_probability(std::log(median / threshold) / dispersion) : (median > threshold ? 1.0 : 0.0);
  return gone + (1 - gone) * share * beyond;
}

std::vector<Stripe> stripes_of(const std::vector<RunDemand>& demands) {
  struct Sum {
    Stripe stripe;
    std::vector<double> logarithms;
    long standing = 0;
  };
  std::map<double, Sum> sums;
  for (const RunDemand& one : demands) {
    require_positive("intensity", one.intensity);
    Sum& sum = sums[one.intensity];
    sum.stripe.intensity = one.intensity;
    ++sum.stripe.runs;
    if (one.collapsed) {
      ++sum.stripe.collapsed;
      continue;
    }
    ++sum.standing;
    if (one.value > 0 && std::isfinite(one.value)) sum.logarithms.push_back(std::log(one.value));
  }
  std::vector<Stripe> stripes;
  for (auto& [intensity, sum] : sums) {
    const double n = static_cast<double>(sum.logarithms.size());
    double mean = 0, square = 0;
    for (const double one : sum.logarithms) mean += one / n;
    for (const double one : sum.logarithms) square += (one - mean) * (one - mean);
    sum.stripe.median = n > 0 ? std::exp(mean) : (sum.standing > 0 ? 0 : not_known);
    sum.stripe.dispersion = n > 1 ? std::sqrt(square / (n - 1)) : 0;
    sum.stripe.share = sum.standing > 0 ? n / static_cast<double>(sum.standing) : 0;
    stripes.push_back(sum.stripe);
  }
  return stripes;
}

Fragility stripe_fragility(const std::vector<Stripe>& stripes, double threshold) {
  // Shares of runs as counts of many more: the maximum stays where it is.
  constexpr double many = 1e6;
  std::vector<IntensityCount> counts;
  for (const Stripe& one : stripes) {
    const double runs = static_cast<double>(one.runs) * many;
    counts.push_back({one.intensity, std::lround(runs), std::lround(runs * one.probability(threshold))});
  }
  return fit_fragility(counts);
}

}  // namespace bentur
