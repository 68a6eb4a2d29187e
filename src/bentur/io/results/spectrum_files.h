#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bentur/core/units.h"
#include "bentur/model/case.h"
#include "bentur/solve/spectrum/response_spectrum.h"

namespace bentur {

/// The response spectrum of one record.
struct RecordSpectrum {
  RecordEcho record;                   ///< its pga in the units of the peaks
  Units units;                         ///< of the peaks
  double damping_ratio = 0;            ///< ζ [-]
  std::vector<double> periods;         ///< T [s]
  std::vector<OscillatorPeaks> peaks;  ///< one per period
};

/// One row per period, a header row with units, numbers to the last digit (RFC 4180, LF); the pseudo-acceleration also
/// in g.
[[nodiscard]] std::string spectrum_csv(const RecordSpectrum& spectrum);

/// The same as lists.
[[nodiscard]] std::string spectrum_json(const RecordSpectrum& spectrum, std::string_view version);

}  // namespace bentur
