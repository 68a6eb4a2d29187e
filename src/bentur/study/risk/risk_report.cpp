#include "bentur/study/risk/risk_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/core/units.h"

namespace bentur {
namespace {

double in_metres(const std::string& unit) { return acceleration_factor(unit, {.length = "m"}); }

/// "SA(0.5)" and "SA(0.50)" are one, and "SA" may be either.
bool is_same_measure(const std::string& a, const std::string& b) {
  if (a == "SA") return b.starts_with("SA(");
  const auto period = [](const std::string& text) -> std::optional<double> {
    if (!text.starts_with("SA(") || !text.ends_with(")")) return std::nullopt;
    return parse_number(std::string_view(text).substr(3, text.size() - 4));
  };
  const auto of_a = period(a), of_b = period(b);
  return of_a && of_b ? std::abs(*of_a - *of_b) <= 1e-9 * *of_a : a == b;
}

/// Whether each run of a case has the event, as 0 and 1; those that make no case are left out.
struct ShareOfEvents {
  std::vector<ObservedShare> shares;              // of all records
  std::vector<std::vector<ObservedShare>> units;  // of each record, both ways together
};

ShareOfEvents shares_of(const OutcomeTable& table, std::size_t c) {
  ShareOfEvents result;
  std::vector<std::size_t> order(table.levels.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return table.levels[a] < table.levels[b]; });
  const std::size_t units = table.records / table.together;
  result.units.resize(units);
  for (const std::size_t level : order) {
    double events = 0, runs = 0;
    for (std::size_t unit = 0; unit < units; ++unit) {
      double own = 0, count = 0;
      for (std::size_t i = 0; i < table.together; ++i) {
        const Outcome outcome = table.at(c, unit * table.together + i, level);
        if (outcome == Outcome::failed) continue;
        own += outcome == Outcome::event ? 1 : 0;
        ++count;
      }
      events += own;
      runs += count;
      if (count > 0) result.units[unit].push_back({table.levels[level], own / count});
    }
    if (runs > 0) result.shares.push_back({table.levels[level], events / runs});
  }
  return result;
}

std::optional<AnnualRate> fitted_rate(const HazardCurve& hazard, const Fragility& fit) {
  if (fit.kind != Fragility::Kind::fitted) return std::nullopt;
  if (!fit.collapse) return annual_rate(hazard, fit.median, fit.dispersion);
  if (fit.collapse->kind != CollapseFit::Kind::fitted) return std::nullopt;
  return annual_rate(hazard, fit.median, fit.dispersion, *fit.collapse);
}

/// Of a resample: where there is no fit what its kind says, a step at θ, nothing or all of the hazard.
double resampled_rate(const HazardCurve& hazard, const Fragility& fit) {
  if (const auto fitted = fitted_rate(hazard, fit)) return fitted->rate;
  if (fit.collapse) return not_known;
  switch (fit.kind) {
    case Fragility::Kind::separated:
      return annual_rate(hazard, fit.median, 0).rate;
    case Fragility::Kind::no_event:
      return hazard.rate.back();
    case Fragility::Kind::all_events:
      return hazard.rate.front();
    default:
      return not_known;
  }
}

CaseRisk case_risk(const OutcomeTable& table, std::size_t c, const HazardCurve& hazard, const RiskRequest& request) {
  CaseRisk risk;
  risk.c = c;
  risk.fragility = fit_case(table, c, request.bootstrap, request.method);
  const Fragility& fit = risk.fragility.fit;
  risk.lognormal = fitted_rate(hazard, fit);
  if (risk.lognormal && !fit.collapse) risk.closed_form = closed_form_rate(hazard, fit.median, fit.dispersion);
  if (risk.lognormal && risk.fragility.bounds) {
    std::vector<double> rates;
    for (const Fragility& one : risk.fragility.bounds->fits) {
      const double rate = resampled_rate(hazard, one);
      if (!std::isnan(rate)) rates.push_back(rate);
    }
    risk.bounds = percentile_interval(std::move(rates), request.bootstrap.confidence);
  }
  if (table.is_cloud()) {
    const std::vector<ObservedShare> shares = rising_shares(risk.fragility.counts);
    if (!shares.empty()) risk.observed = annual_rate(hazard, shares);
    return risk;
  }
  const ShareOfEvents events = shares_of(table, c);
  if (!events.shares.empty()) risk.observed = annual_rate(hazard, events.shares);
  for (const std::vector<ObservedShare>& unit : events.units) {
    const double rate = unit.empty() ? 0 : annual_rate(hazard, unit).rate;
    risk.of_records.push_back(rate / static_cast<double>(events.units.size()));
  }
  return risk;
}

/// The rate at which more than `width` is needed: of the lognormal where the runs follow it, else of their shares.
double rate_beyond(const OutcomeTable& needed, std::size_t c, double width, const HazardCurve& hazard,
                   FragilityMethod method) {
  OutcomeTable table = needed;
  table.threshold = width;
  for (std::size_t run = 0; run < table.outcomes.size(); ++run) {
    if (table.outcomes[run] == Outcome::failed) continue;
    const bool is_more = table.collapsed[run] != 0 || !(table.demands[run] <= width);
    table.outcomes[run] = is_more ? Outcome::event : Outcome::no_event;
  }
  RiskRequest request{.method = width > 0 ? method : FragilityMethod::likelihood};
  request.bootstrap.resamples = 1;
  return case_risk(table, c, hazard, request).told().rate;
}

/// The smallest gap, of those that some run needs, from which on the rate is no more than the target.
TargetGap target_gap(const OutcomeTable& needed, std::size_t c, const HazardCurve& hazard, double target,
                     FragilityMethod method) {
  const std::size_t runs = needed.records * needed.levels.size();
  std::vector<double> widths = {0.0};
  for (std::size_t run = c * runs; run < (c + 1) * runs; ++run) {
    const double demand = needed.demands[run];
    if (needed.outcomes[run] != Outcome::failed && needed.collapsed[run] == 0 && demand > 0) widths.push_back(demand);
  }
  std::sort(widths.begin(), widths.end());
  widths.erase(std::unique(widths.begin(), widths.end()), widths.end());
  TargetGap result;
  result.c = c;
  // A fitted rate may rise a little where it should fall: then the gap that is found is one of those that do.
  std::size_t low = 0, high = widths.size();  // the rate at `high` is small enough, or there is no such gap
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (rate_beyond(needed, c, widths[middle], hazard, method) <= target) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  if (high == widths.size()) {
    result.rate = rate_beyond(needed, c, widths.back(), hazard, method);
    return result;
  }
  result.width = widths[high];
  result.rate = rate_beyond(needed, c, widths[high], hazard, method);
  return result;
}

/// Whether what is needed without contact changes along each axis: not along gap widths, whatever they are called, and
/// not along stiffnesses of contact.
std::vector<bool> axes_of_needs(const IdaResults& needed) {
  const OutcomeTable& table = needed.table;
  const std::size_t runs = table.records * table.levels.size();
  const auto is_alike = [&](std::size_t a, std::size_t b) {
    for (std::size_t run = 0; run < runs; ++run) {
      const std::size_t of_a = a * runs + run, of_b = b * runs + run;
      const bool has_failed = table.outcomes[of_a] == Outcome::failed;
      if (has_failed != (table.outcomes[of_b] == Outcome::failed)) return false;
      if (!has_failed && !(table.demands[of_a] == table.demands[of_b])) return false;
      if (table.collapsed[of_a] != table.collapsed[of_b]) return false;
    }
    return true;
  };
  std::vector<bool> matters;
  std::size_t stride = table.cases;
  for (const ResultAxis& axis : needed.axes) {
    stride /= axis.size;
    const auto& of = axis.coordinates;
    bool differs = of.empty() || !std::all_of(of.begin(), of.end(), [](const auto& one) { return one.is_gap_width(); });
    if (differs) {
      differs = false;
      for (std::size_t c = 0; c < table.cases && !differs; ++c) {
        const std::size_t place = c / stride % axis.size;
        differs = place > 0 && !is_alike(c, c - place * stride);
      }
    }
    matters.push_back(differs);
  }
  return matters;
}

}  // namespace

std::optional<RiskReport> risk_report(IdaResults results, const std::optional<IdaResults>& needed, HazardCurve hazard,
                                      const RiskRequest& request, std::string& error) {
  RiskReport report;
  const std::optional<double> period = results.period();
  report.measure = period ? fmt::format("SA({})", *period) : "PGA";
  if (!hazard.measure.empty() && !is_same_measure(hazard.measure, report.measure)) {
    error = fmt::format("is of {}, but the runs are by levels of {}", hazard.measure, report.measure);
    return std::nullopt;
  }
  error = method_fault(results, request.method);
  if (!error.empty()) return std::nullopt;
  if (!hazard.unit.empty() && hazard.unit != results.study_unit) {
    const double factor = in_metres(hazard.unit) / in_metres(results.study_unit);
    for (double& x : hazard.intensity) x *= factor;
  }
  report.unit_is_taken = hazard.unit.empty();
  hazard.unit = results.study_unit;
  report.results = std::move(results);
  report.hazard = std::move(hazard);
  for (std::size_t c = 0; c < report.results.table.cases; ++c) {
    report.cases.push_back(case_risk(report.results.table, c, report.hazard, request));
  }
  if (!request.target || !needed) return report;
  report.gap_units = needed->quantity_units;
  const double target = rate_of_probability(request.years, *request.target);
  report.gaps_vary_along = axes_of_needs(*needed);
  for (std::size_t c = 0; c < needed->table.cases; ++c) {
    const std::vector<std::size_t> places = needed->places(c);
    bool is_first = true;  // of those that need the same
    for (std::size_t axis = 0; axis < places.size(); ++axis) {
      is_first = is_first && (report.gaps_vary_along[axis] || places[axis] == 0);
    }
    if (!is_first) continue;
    TargetGap gap = target_gap(needed->table, c, report.hazard, target, request.method);
    const auto runs = static_cast<std::ptrdiff_t>(needed->table.records * needed->table.levels.size());
    const auto first = needed->table.outcomes.begin() + static_cast<std::ptrdiff_t>(c) * runs;
    gap.failed = std::count(first, first + runs, Outcome::failed);
    gap.runs = runs - gap.failed;
    gap.open = report.results.open.runs;
    report.gaps.push_back(gap);
  }
  return report;
}

}  // namespace bentur
