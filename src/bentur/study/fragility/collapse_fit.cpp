#include "bentur/study/fragility/collapse_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/core/not_known.h"
#include "bentur/core/require.h"
#include "bentur/study/fragility/fragility.h"

namespace bentur {
namespace {

using CollapseKind = CollapseFit::Kind;

/// ln(1 + e^z), however large z is.
double softplus(double z) { return z > 0 ? z + std::log1p(std::exp(-z)) : std::log1p(std::exp(z)); }

/// Of a standardised intensity: u = (ln x − mean)/spread, and the parts of all runs that collapse and stand there.
struct LogisticPoint {
  double u = 0, collapsed = 0, standing = 0;
};

/// The logarithm of the likelihood of z = a + b u, and its derivatives.
struct LogisticLikelihood {
  double value = 0;
  double da = 0, db = 0;             // gradient
  double haa = 0, hab = 0, hbb = 0;  // negative Hessian, positive definite

  LogisticLikelihood(const std::vector<LogisticPoint>& points, double a, double b) {
    for (const LogisticPoint& one : points) {
      const double z = a + b * one.u, p = 1 / (1 + std::exp(-z)), all = one.collapsed + one.standing;
      value -= one.collapsed * softplus(-z) + one.standing * softplus(z);
      const double slope = one.collapsed - all * p, bend = all * p / (1 + std::exp(z));
      da += slope;
      db += slope * one.u;
      haa += bend;
      hab += bend * one.u;
      hbb += bend * one.u * one.u;
    }
  }
};

/// What can be said without fitting; `fitted` where there is a maximum still to be found.
CollapseFit classified_collapse(const std::vector<IntensityCount>& counts) {
  CollapseFit fit;
  fit.intercept = fit.slope = not_known;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double first_collapse = infinity, last_collapse = 0, first_standing = infinity, last_standing = 0;
  for (const IntensityCount& one : counts) {
    require_positive("intensity", one.intensity);
    if (one.events < 0 || one.runs < one.events) {
      throw InvalidParameter("events", std::to_string(one.events),
                             "must be from 0 to the number of runs, " + std::to_string(one.runs));
    }
    fit.runs += one.runs;
    fit.collapsed += one.events;
    if (one.events > 0) {
      first_collapse = std::min(first_collapse, one.intensity);
      last_collapse = std::max(last_collapse, one.intensity);
    }
    if (one.events < one.runs) {
      first_standing = std::min(first_standing, one.intensity);
      last_standing = std::max(last_standing, one.intensity);
    }
  }
  fit.lower = last_standing;
  fit.upper = first_collapse;
  const double lowest = std::min(first_collapse, first_standing), highest = std::max(last_collapse, last_standing);
  if (fit.collapsed == 0) {
    fit.kind = CollapseKind::none;
  } else if (fit.collapsed == fit.runs) {
    fit.kind = CollapseKind::all;
  } else if (lowest == highest) {
    fit.kind = CollapseKind::falling;
  } else if (first_collapse >= last_standing || first_standing >= last_collapse) {
    fit.kind = CollapseKind::separated;
  } else {
    fit.kind = CollapseKind::fitted;
  }
  return fit;
}

}  // namespace

double CollapseFit::probability(double intensity) const {
  require_positive("intensity", intensity);
  if (kind == Kind::none) return 0;
  if (kind == Kind::all) return 1;
  return 1 / (1 + std::exp(-(intercept + slope * std::log(intensity))));
}

double CollapseFit::intensity_of(double p) const {
  if (!(p > 0 && p < 1)) throw InvalidParameter("p", std::to_string(p), "must be in (0, 1)");
  return std::exp((std::log(p / (1 - p)) - intercept) / slope);
}

CollapseFit fit_collapse(const std::vector<IntensityCount>& counts) {
  CollapseFit fit = classified_collapse(counts);
  if (fit.kind != CollapseKind::fitted) return fit;

  const auto runs = static_cast<double>(fit.runs);
  double mean = 0, spread = 0;
  for (const IntensityCount& one : counts) mean += static_cast<double>(one.runs) / runs * std::log(one.intensity);
  for (const IntensityCount& one : counts) {
    spread += static_cast<double>(one.runs) / runs * std::pow(std::log(one.intensity) - mean, 2);
  }
  spread = std::sqrt(spread);
  std::vector<LogisticPoint> points;
  for (const IntensityCount& one : counts) {
    points.push_back({(std::log(one.intensity) - mean) / spread, static_cast<double>(one.events) / runs,
                      static_cast<double>(one.runs - one.events) / runs});
  }
  const double share = static_cast<double>(fit.collapsed) / runs;
  double a = std::log(share / (1 - share)), b = 0;
  LogisticLikelihood at(points, a, b);
  // Newton's method takes about 6 steps; the last of them change the likelihood by no more than its round-off.
  constexpr int most_steps = 50;
  constexpr double round_off = 1e-15;
  for (int i = 0; i < most_steps; ++i) {
    const double determinant = at.haa * at.hbb - at.hab * at.hab;
    double step_a = (at.hbb * at.da - at.hab * at.db) / determinant;
    double step_b = (at.haa * at.db - at.hab * at.da) / determinant;
    if (!std::isfinite(step_a + step_b)) break;
    LogisticLikelihood next(points, a + step_a, b + step_b);
    const double enough = at.value - round_off * std::abs(at.value);
    while (!(next.value >= enough) && std::hypot(step_a, step_b) > 1e-15 * std::hypot(a, b)) {
      step_a /= 2;
      step_b /= 2;
      next = LogisticLikelihood(points, a + step_a, b + step_b);
    }
    if (!(next.value >= enough)) break;
    a += step_a;
    b += step_b;
    at = next;
    if (std::hypot(step_a, step_b) <= 1e-13 * std::hypot(a, b)) break;
  }
  if (!(b > 0)) {
    fit.kind = CollapseKind::falling;
    return fit;
  }
  fit.slope = b / spread;
  fit.intercept = a - fit.slope * mean;
  return fit;
}

}  // namespace bentur
