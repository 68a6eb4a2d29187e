#include "bentur/model/suite/suite.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/solve/spectrum/response_spectrum.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

using Kind = SuiteFault::Kind;

constexpr double suite_damping = 0.05;          // [-]
constexpr double mean_over_target = 0.9;        // (3) [-]
constexpr double band_from = 0.2, band_to = 2;  // of T₁ [-]
constexpr double step_of_periods = 1.01;        // [-]
constexpr double as_good_as_zero = 1e-9;        // [s]
constexpr double shortest_of_a_step = 1e-3;     // as oscillator_peaks() [-]

double target_at(const DesignSpectrum& spectrum, double period) {
  return spectral_acceleration(spectrum, period, suite_damping);
}

/// The periods of the band and the target there. @return the fault that keeps it from being known.
std::optional<SuiteFault> settle_target(SuiteSpec& suite) {
  double least = INFINITY, most = 0;
  for (const SuitePeriods& periods : suite.buildings) {
    least = std::min(least, periods.first);
    most = std::max(most, periods.first);
  }
  if (suite.buildings.empty()) return SuiteFault{.kind = Kind::no_period};
  const double from = band_from * least, to = band_to * most;
  SuiteTarget& target = suite.target;
  if (const auto* table = std::get_if<TableSpectrum>(&target.spectrum.shape); table && table->periods.back() < to) {
    return SuiteFault{.kind = Kind::beyond_table, .value = to};
  }
  const double steps = std::ceil(std::log(to / from) / std::log(step_of_periods));
  target.periods = logarithmic_periods(from, to, static_cast<int>(steps) + 1);
  for (const double period : target.periods) {
    target.ordinates.push_back(target_at(target.spectrum, period));
    if (!(target.ordinates.back() > 0)) return SuiteFault{.kind = Kind::no_target, .value = period};
  }
  target.at_zero = target_at(target.spectrum, as_good_as_zero);
  return std::nullopt;
}

/// S_a of a record as read, of a pair as it is measured [length/s²].
double acceleration_of(const SuiteRecord& record, PairMeasure measure, double period) {
  const auto along = [&](const SampledMotion& motion) {
    return oscillator_peaks(motion, period, suite_damping).pseudo_acceleration;
  };
  if (!record.along_y) return along(record.motion);
  if (measure == PairMeasure::geometric_mean) return std::sqrt(along(record.motion) * along(record.along_y->motion));
  return maximum_direction(record.motion, record.along_y->motion, period, suite_damping);
}

/// Its peak ground acceleration, of a pair the geometric mean [length/s²].
double peak_of(const SuiteRecord& record) {
  const double along_x = peak_acceleration(record.motion);
  return record.along_y ? std::sqrt(along_x * peak_acceleration(record.along_y->motion)) : along_x;
}

/// Spectra as read, factors before the common one, and misfits by (1) and (2).
std::optional<SuiteFault> fit_record(SuiteSpec& suite, std::size_t number) {
  SuiteRecord& record = suite.records[number];
  const std::vector<double>& periods = suite.target.periods;
  const SuiteRequest& request = suite.request;
  const auto is_short = [&](double period) { return period < shortest_of_a_step * record.motion.time_step; };
  const double shortest = std::min(periods.front(), request.period.value_or(periods.front()));
  if (is_short(shortest)) return SuiteFault{.kind = Kind::too_short, .record = number, .value = shortest};
  const PairMeasure measure = pair_measure(request);
  for (const double period : periods) {
    record.spectrum.push_back(acceleration_of(record, measure, period));
    if (!(record.spectrum.back() > 0)) return SuiteFault{.kind = Kind::no_amplitude, .record = number};
  }
  const auto count = static_cast<double>(periods.size());
  double mean = 0, square = 0;
  std::vector<double> ratios;
  for (std::size_t i = 0; i < periods.size(); ++i) {
    ratios.push_back(std::log(suite.target.ordinates[i] / record.spectrum[i]));
    mean += ratios.back() / count;
  }
  for (const double ratio : ratios) square += (ratio - mean) * (ratio - mean) / count;
  record.misfit = std::sqrt(square);
  if (request.scale == "factors") {
    record.factor = request.factors[record.file];
  } else if (request.scale == "period") {
    const double own = acceleration_of(record, measure, *request.period);
    if (!(own > 0)) return SuiteFault{.kind = Kind::no_amplitude, .record = number};
    record.factor = target_at(suite.target.spectrum, *request.period) / own;
  } else {
    record.factor = std::exp(mean);
  }
  return std::nullopt;
}

/// The choice among records that are fitted.
class SuiteChoice {
 public:
  explicit SuiteChoice(SuiteSpec& suite) : suite_(suite), request_(suite.request) {}

  std::optional<SuiteFault> make() {
    std::vector<std::size_t> order(suite_.records.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return suite_.records[a].misfit < suite_.records[b].misfit; });
    if (const double limit = request_.largest_misfit.value_or(INFINITY); suite_.records[order.front()].misfit > limit) {
      return SuiteFault{.kind = Kind::misfit, .record = order.front(), .value = suite_.records[order.front()].misfit};
    }
    std::vector<bool> is_out(order.size(), false);
    std::vector<double> beyond;  // factors of those that the bounds leave out
    while (true) {
      SuiteFault::Beyond left{.factor = beyond.size()};
      std::vector<std::size_t> taken;
      std::map<std::string, std::size_t> of_event;
      for (const std::size_t i : order) {
        if (is_out[i] || (request_.select && taken.size() == *request_.select)) continue;
        const SuiteRecord& record = suite_.records[i];
        if (record.misfit > request_.largest_misfit.value_or(INFINITY)) {
          ++left.misfit;
        } else if (request_.per_event && !record.event.empty() && of_event[record.event] == *request_.per_event) {
          ++left.event;
        } else {
          if (!record.event.empty()) ++of_event[record.event];
          taken.push_back(i);
        }
      }
      if (taken.empty() || taken.size() < request_.select.value_or(0)) {
        return SuiteFault{.kind = Kind::too_few,
                          .count = taken.size(),
                          .value = beyond.empty() ? 0 : nearest(beyond),
                          .beyond = left};
      }
      const double common = common_factor(taken);
      const auto worst = std::max_element(taken.begin(), taken.end(), [&](std::size_t a, std::size_t b) {
        return distance(common * suite_.records[a].factor) < distance(common * suite_.records[b].factor);
      });
      const double factor = common * suite_.records[*worst].factor;
      if (distance(factor) > 0) {
        if (!request_.select) {
          return SuiteFault{.kind = Kind::factor, .record = *worst, .value = factor, .common = common};
        }
        is_out[*worst] = true;
        beyond.push_back(factor);
        continue;
      }
      keep(std::move(taken), common);
      return std::nullopt;
    }
  }

 private:
  /// How far a factor is outside the bounds, as a logarithm; 0 within.
  [[nodiscard]] double distance(double factor) const {
    if (!request_.factor_bounds) return 0;
    const auto [least, most] = *request_.factor_bounds;
    return std::max({0.0, std::log(least / factor), std::log(factor / most)});
  }

  [[nodiscard]] double nearest(const std::vector<double>& factors) const {
    return *std::min_element(factors.begin(), factors.end(),
                             [&](double a, double b) { return distance(a) < distance(b); });
  }

  /// c of (3).
  [[nodiscard]] double common_factor(const std::vector<std::size_t>& taken) const {
    if (!request_.is_of_code()) return 1;
    const auto count = static_cast<double>(taken.size());
    const SuiteTarget& target = suite_.target;
    double common = 1, zero = 0;
    for (std::size_t i = 0; i < target.periods.size(); ++i) {
      double mean = 0;
      for (const std::size_t n : taken) mean += suite_.records[n].factor * suite_.records[n].spectrum[i] / count;
      common = std::max(common, mean_over_target * target.ordinates[i] / mean);
    }
    for (const std::size_t n : taken) {
      zero += suite_.records[n].factor * peak_of(suite_.records[n]) / count;
    }
    return request_.scale == "en-1998-1" ? std::max(common, target.at_zero / zero) : common;
  }

  void keep(std::vector<std::size_t> taken, double common) {
    std::sort(taken.begin(), taken.end());
    std::vector<SuiteRecord> kept;
    const auto count = static_cast<double>(taken.size());
    suite_.common_factor = common;
    suite_.mean.assign(suite_.target.periods.size(), 0.0);
    for (const std::size_t n : taken) {
      SuiteRecord& record = suite_.records[n];
      record.factor *= common;
      for (std::size_t i = 0; i < suite_.mean.size(); ++i) {
        record.spectrum[i] *= record.factor;
        suite_.mean[i] += record.spectrum[i] / count;
      }
      record.echo.pga = record.factor * peak_acceleration(record.motion);
      if (record.along_y) record.along_y->echo.pga = record.factor * peak_acceleration(record.along_y->motion);
      suite_.mean_at_zero += record.factor * peak_of(record) / count;
      kept.push_back(std::move(record));
    }
    suite_.records = std::move(kept);
  }

  SuiteSpec& suite_;
  const SuiteRequest& request_;
};

}  // namespace

std::vector<std::string> SuiteSpec::paths() const {
  std::vector<std::string> all = {target.path};
  for (const SuiteRecord& record : records) {
    all.push_back(record.echo.path);
    if (record.along_y) all.push_back(record.along_y->echo.path);
  }
  return all;
}

PairMeasure pair_measure(const SuiteRequest& request) {
  return request.scale == "asce-7-16" ? PairMeasure::maximum_direction : PairMeasure::geometric_mean;
}

std::vector<SuitePeriods> suite_periods(const std::vector<const Building*>& buildings) {
  std::vector<SuitePeriods> all;
  for (const Building* building : buildings) {
    if (!(building->first_omega() > 0)) continue;
    const auto period = [&](Eigen::Index mode) { return 2 * std::numbers::pi / building->modes.omega(mode); };
    all.push_back({.name = building->name, .first = period(0)});
    if (building->modes.omega.size() > 1) all.back().second = period(1);
  }
  return all;
}

std::vector<SuitePeriods> suite_periods(const std::vector<PlanBuilding>& buildings) {
  std::vector<SuitePeriods> all;
  for (const PlanBuilding& building : buildings) {
    if (building.is_rigid()) continue;
    for (const int axis : {0, 1}) {
      const ModalProperties modes = modal_properties(building.modes, building.model.load.col(axis));
      Eigen::Index first = 0;
      modes.effective_mass_fraction.maxCoeff(&first);
      all.push_back({.name = building.name + (axis == 0 ? ", x" : ", y"), .first = modes.periods(first)});
    }
  }
  return all;
}

std::vector<SuiteFault> settle(SuiteSpec& suite, std::vector<SuitePeriods> buildings,
                               const std::function<void(double)>& progress) {
  suite.files = suite.records.size();
  suite.buildings = std::move(buildings);
  if (suite.request.select.value_or(0) > suite.files) {
    return {SuiteFault{.kind = Kind::too_few, .count = suite.files}};
  }
  if (const auto fault = settle_target(suite)) return {*fault};
  std::vector<SuiteFault> faults;
  for (std::size_t i = 0; i < suite.records.size(); ++i) {
    if (const auto fault = fit_record(suite, i)) faults.push_back(*fault);
    if (progress) progress(static_cast<double>(i + 1) / static_cast<double>(suite.records.size()));
  }
  if (!faults.empty()) return faults;
  if (const auto fault = SuiteChoice(suite).make()) return {*fault};
  return {};
}

void name_records(std::vector<SuiteRecord>& records) {
  const auto stem = [](const RecordEcho& echo) {
    const std::string file = echo.file.substr(echo.file.find_last_of('/') + 1);
    return file.substr(0, file.find_last_of('.'));
  };
  std::set<std::string> names;
  for (SuiteRecord& record : records) {
    record.called = stem(record.echo) + (record.along_y ? " + " + stem(record.along_y->echo) : "");
    names.insert(record.called);
  }
  if (names.size() == records.size()) return;
  for (SuiteRecord& record : records) record.called = record.files();
}

double SuiteSpec::least_share() const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mean.size(); ++i) least = std::min(least, mean[i] / target.ordinates[i]);
  return least;
}

Case case_of_record(const Case& c, std::size_t number) {
  if (!c.excitation.suite) throw InvalidParameter("excitation.kind", "no suite", "must be \"suite\"");
  const SuiteSpec& suite = *c.excitation.suite;
  if (number >= suite.records.size()) {
    throw InvalidParameter("record", std::to_string(number + 1),
                           "must be 1 to " + std::to_string(suite.records.size()));
  }
  const SuiteRecord& record = suite.records[number];
  Case one = c;
  double longest = record.echo.duration;
  const auto apply = [&](const RecordEcho& echo, const SampledMotion& motion, ExcitationSpec& excitation) {
    SampledMotion scaled = motion;
    for (double& value : scaled.acceleration) value *= record.factor;
    excitation.motion = std::move(scaled);
    excitation.record = echo;
    longest = std::max(longest, echo.duration);
  };
  one.excitation.suite = nullptr;
  apply(record.echo, record.motion, one.excitation);
  if (record.along_y) apply(record.along_y->echo, record.along_y->motion, one.excitation_y);
  one.analysis.duration = suite.duration.value_or(longest);
  one.analysis.goes_on = !suite.duration;
  return one;
}

SuiteMeasure suite_measure(const SuiteSpec& suite) {
  using Measure = SuiteMeasure::Kind;
  constexpr std::size_t mean_of_en = 7, least_of_en = 3, mean_of_asce = 11;
  const std::size_t count = suite.records.size();
  if (suite.request.scale == "en-1998-1") {
    return {.kind = count >= mean_of_en    ? Measure::mean
                    : count >= least_of_en ? Measure::largest
                                           : Measure::too_few,
            .code = "EN 1998-1",
            .clause = "4.3.3.4.3(3)",
            .fewest = least_of_en};
  }
  if (suite.request.scale == "asce-7-16") {
    return {.kind = count >= mean_of_asce ? Measure::mean : Measure::too_few,
            .code = "ASCE 7-16",
            .clause = "16.4",
            .fewest = mean_of_asce};
  }
  return {};
}

}  // namespace bentur
