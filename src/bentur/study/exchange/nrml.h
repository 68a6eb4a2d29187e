#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bentur/study/fragility/ida_results.h"

namespace bentur {

/// Mean and standard deviation of the intensity itself at which a lognormal fragility has its event:
///
///   mean = θ e^{β²/2},   stddev = mean √(e^{β²} − 1)                                                      (1)
///
/// θ > 0 the median [any unit], β > 0 the dispersion [-].
struct LognormalMoments {
  double mean = 0, stddev = 0;
};
/// @throws InvalidParameter unless θ > 0, β > 0, both finite.
[[nodiscard]] LognormalMoments lognormal_moments(double median, double dispersion);

/// A fragility of one limit state, as OpenQuake takes it.
struct NrmlCurve {
  std::string limit_state;
  double median = 0;      ///< θ [g]
  double dispersion = 0;  ///< β [-]
  /// θ is beyond the levels analysed: a comment says so.
  bool extrapolated = false;
  /// The runs do not follow the curve, is_misfit(): a comment says so.
  bool misfit = false;
};

struct NrmlFunction {
  std::string id;  ///< taxonomy of the asset
  std::vector<NrmlCurve> curves = {};
};

struct NrmlModel {
  std::string id = {}, description = {};
  std::optional<double> period = {};  ///< of spectral acceleration [s]; nothing: peak ground acceleration
  double lowest = 0, highest = 0;     ///< levels analysed [g]: OpenQuake extrapolates nothing beyond
  std::vector<NrmlFunction> functions = {};
};

/// A fragility model in NRML 0.5 (format="continuous", shape="logncdf"), moments by (1), numbers with all their digits.
/// Source: OpenQuake engine manual, "Fragility models".
/// @throws InvalidParameter where there is no function, limit states differ between functions, or a number is out of
/// range.
[[nodiscard]] std::string nrml_fragility(const NrmlModel& model, std::string_view version);

/// The model of the results of an incremental dynamic analysis, a limit state an event, a function a combination of
/// whatever else varies. Cases without θ and β for every event are left out, and those with a curve that their runs do
/// not follow, unless they are asked for.
struct NrmlResults {
  NrmlModel model;
  std::vector<std::string> left_out = {};      ///< ids of the cases without, each with the event at fault
  std::vector<std::string> extrapolated = {};  ///< the same of medians beyond the levels analysed
  std::vector<std::string> misfits = {};       ///< the same of curves that runs do not follow, left out or not
  double damping = 0.05;                       ///< of the spectral acceleration [-]
};
/// @param events as read, one IdaResults each, of one file @param id taxonomy of the asset, distinguished by what
/// varies
/// @param misfits whether curves that their runs do not follow are taken
/// @return nothing where no case is left; `error` says why.
[[nodiscard]] std::optional<NrmlResults> nrml_of(const std::vector<std::pair<std::string, IdaResults>>& events,
                                                 const std::string& id, bool misfits, std::string& error);

}  // namespace bentur
