#include "bentur/study/fragility/collapse_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/core/not_known.h"
#include "bentur/core/require.h"
#include "bentur/study/fragility/fragility.h"
#include "bentur/study/fragility/internal/concave_maximum.h"

namespace bentur {
namespace {

using CollapseKind = CollapseFit::Kind;

/// ln(1 + e^z), however large z is.
double softplus(double z) { return z > 0 ? z + std::log1p(std::exp(-z)) : std::log1p(std::exp(z)); }

/// The logarithm of the likelihood of z = a + b u, and its derivatives.
struct LogisticLikelihood {
  double value = 0;
  double da = 0, db = 0;             // gradient
  double haa = 0, hab = 0, hbb = 0;  // negative Hessian, positive definite

  LogisticLikelihood(const std::vector<StandardLevel>& levels, double a, double b) {
    for (const StandardLevel& one : levels) {
      const double z = a + b * one.u, p = 1 / (1 + std::exp(-z)), all = one.events + one.others;
      value -= one.events * softplus(-z) + one.others * softplus(z);
      const double slope = one.events - all * p, bend = all * p / (1 + std::exp(z));
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

  const StandardLevels data(counts);
  const double share = data.events / data.runs;
  double a = std::log(share / (1 - share)), b = 0;
  constexpr double round_off = 1e-15;  // of the likelihood, which the last steps change by no more
  (void)maximised<LogisticLikelihood>(data.levels, a, b, round_off);
  if (!(b > 0)) {
    fit.kind = CollapseKind::falling;
    return fit;
  }
  fit.slope = b / data.spread;
  fit.intercept = a - fit.slope * data.mean;
  return fit;
}

}  // namespace bentur
