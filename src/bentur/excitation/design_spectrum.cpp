#include "bentur/excitation/design_spectrum.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"

namespace bentur {
namespace {

double ordinate(const TwoPeriodSpectrum& shape, double period) {  // (1)
  const double end = shape.one_second / shape.short_period;
  const double start = 0.2 * end;
  if (period < start) return shape.short_period * (0.4 + 0.6 * period / start);
  if (period <= end) return shape.short_period;
  if (period <= shape.long_period) return shape.one_second / period;
  return shape.one_second * shape.long_period / (period * period);
}

double ordinate(const EurocodeSpectrum& shape, double period, double eta) {  // (2)
  const double ground = shape.ground_acceleration * shape.soil_factor;
  if (period < shape.corner_b) return ground * (1 + period / shape.corner_b * (2.5 * eta - 1));
  const double plateau = 2.5 * ground * eta;
  if (period <= shape.corner_c) return plateau;
  if (period <= shape.corner_d) return plateau * shape.corner_c / period;
  return plateau * shape.corner_c * shape.corner_d / (period * period);
}

double ordinate(const TableSpectrum& shape, double period) {
  const auto above = std::lower_bound(shape.periods.begin(), shape.periods.end(), period);
  if (above == shape.periods.end()) {
    throw InvalidParameter("period", std::to_string(period),
                           "is beyond the last of the spectrum, " + std::to_string(shape.periods.back()) + " s");
  }
  const auto i = above - shape.periods.begin();
  if (i == 0) return shape.accelerations.front();
  const double part = (period - *(above - 1)) / (*above - *(above - 1));
  return shape.accelerations[i - 1] + part * (shape.accelerations[i] - shape.accelerations[i - 1]);
}

void check(const TwoPeriodSpectrum& shape) {
  require_positive("short_period", shape.short_period);
  require_positive("one_second", shape.one_second);
  require_positive("long_period", shape.long_period);
  if (!(shape.long_period > shape.one_second / shape.short_period)) {
    throw InvalidParameter("long_period", std::to_string(shape.long_period), "must be beyond S_D1/S_DS");
  }
}

void check(const EurocodeSpectrum& shape) {
  require_positive("ground_acceleration", shape.ground_acceleration);
  require_positive("soil_factor", shape.soil_factor);
  require_positive("corner_b", shape.corner_b);
  if (!(shape.corner_b < shape.corner_c && shape.corner_c < shape.corner_d && std::isfinite(shape.corner_d))) {
    throw InvalidParameter("corner_c", std::to_string(shape.corner_c), "must be between T_B and T_D");
  }
}

void check(const TableSpectrum& shape) {
  if (shape.periods.empty()) throw InvalidParameter("periods", "an empty list", "must have at least one entry");
  require_size("accelerations", shape.accelerations.size(), shape.periods.size());
  for (std::size_t i = 0; i < shape.periods.size(); ++i) {
    require_not_negative(indexed("periods", i), shape.periods[i]);
    require_not_negative(indexed("accelerations", i), shape.accelerations[i]);
    if (i > 0 && !(shape.periods[i] > shape.periods[i - 1])) {
      throw InvalidParameter(indexed("periods", i), std::to_string(shape.periods[i]), "must ascend");
    }
  }
}

}  // namespace

EurocodeSpectrum eurocode_spectrum(int type, char ground_type, double ground_acceleration) {
  struct Row {
    double soil_factor, b, c, d;
  };
  static const std::map<std::pair<int, char>, Row> rows = {
      {{1, 'A'}, {1.0, 0.15, 0.4, 2.0}},   {{1, 'B'}, {1.2, 0.15, 0.5, 2.0}}, {{1, 'C'}, {1.15, 0.2, 0.6, 2.0}},
      {{1, 'D'}, {1.35, 0.2, 0.8, 2.0}},   {{1, 'E'}, {1.4, 0.15, 0.5, 2.0}}, {{2, 'A'}, {1.0, 0.05, 0.25, 1.2}},
      {{2, 'B'}, {1.35, 0.05, 0.25, 1.2}}, {{2, 'C'}, {1.5, 0.1, 0.25, 1.2}}, {{2, 'D'}, {1.8, 0.1, 0.3, 1.2}},
      {{2, 'E'}, {1.6, 0.05, 0.25, 1.2}},
  };
  const auto found = rows.find({type, ground_type});
  if (found == rows.end()) {
    throw InvalidParameter("ground_type", std::string(1, ground_type) + " of spectrum type " + std::to_string(type),
                           "must be A to E of type 1 or 2");
  }
  const Row& row = found->second;
  return {ground_acceleration, row.soil_factor, row.b, row.c, row.d};
}

double damping_correction(double damping_ratio) {
  require_not_negative("damping_ratio", damping_ratio);
  return std::max(0.55, std::sqrt(0.10 / (0.05 + damping_ratio)));
}

double spectral_acceleration(const DesignSpectrum& spectrum, double period, double damping_ratio) {
  require_positive("period", period);
  const double eta =
      spectrum.corrects_damping ? damping_correction(damping_ratio) / damping_correction(spectrum.damping_ratio) : 1.0;
  struct At {
    double period, eta;
    double operator()(const TwoPeriodSpectrum& shape) const { return eta * ordinate(shape, period); }
    double operator()(const EurocodeSpectrum& shape) const { return ordinate(shape, period, eta); }
    double operator()(const TableSpectrum& shape) const { return eta * ordinate(shape, period); }
  };
  return std::visit(At{period, eta}, spectrum.shape);
}

double spectral_displacement(const DesignSpectrum& spectrum, double period, double damping_ratio) {
  const double omega = 2 * std::numbers::pi / period;
  return spectral_acceleration(spectrum, period, damping_ratio) / (omega * omega);
}

double largest_ordinate(const DesignSpectrum& spectrum) {
  struct Of {
    double operator()(const TwoPeriodSpectrum& shape) const { return shape.short_period; }
    double operator()(const EurocodeSpectrum& shape) const { return ordinate(shape, shape.corner_b, 1); }
    double operator()(const TableSpectrum& shape) const {
      return *std::max_element(shape.accelerations.begin(), shape.accelerations.end());
    }
  };
  return std::visit(Of{}, spectrum.shape);
}

void validate(const DesignSpectrum& spectrum) {
  std::visit([](const auto& shape) { check(shape); }, spectrum.shape);
  if (!(spectrum.damping_ratio >= 0 && spectrum.damping_ratio < 1)) {
    throw InvalidParameter("damping_ratio", std::to_string(spectrum.damping_ratio), "must be in [0, 1)");
  }
}

}  // namespace bentur
