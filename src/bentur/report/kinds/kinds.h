#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bentur/files/netcdf.h"
#include "bentur/report/figures/figure.h"
#include "bentur/solve/spectrum/response_spectrum.h"

namespace bentur {

/// What a user may say of a figure beside its kind.
struct FigureOptions {
  std::optional<double> from, to;   ///< of histories and energies [s]
  std::optional<std::size_t> gap;   ///< counted from 0; default: the one with the hardest impact
  std::optional<double> elevation;  ///< of the contact point [length]; default: that of the hardest impact
  std::vector<std::pair<std::string, std::string>> at;  ///< of a sweep: name and value of what stays fixed
  std::string against;                                  ///< of a sweep: what stands along the x axis
  std::string event = "impacts > 0";                    ///< of a fragility: EventRule
  double width = 8.8;                                   ///< [cm]
};

/// A figure that these results cannot give, or not so; the message says what they can.
class NoFigure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct FigureKind {
  std::string name, shows;
};

/// The kinds of figure that these results can give: those of a run, of a sweep, or of an incremental dynamic analysis.
/// @throws NoFigure when they are none of these.
[[nodiscard]] std::vector<FigureKind> figure_kinds(const NetcdfReader& results);

/// All kinds of a run, whether or not one has them.
[[nodiscard]] std::vector<std::string> run_figure_names();

/// @throws NoFigure when there is no such kind, or what the options ask for is not there.
[[nodiscard]] Figure make_figure(const NetcdfReader& results, const std::string& kind,
                                 const FigureOptions& options = {});

/// Spectral acceleration and displacement over period.
struct SpectrumCurves {
  std::vector<double> periods;                             ///< T [s]
  std::vector<double> acceleration;                        ///< S_a [unit]
  std::vector<double> displacement;                        ///< S_d [length]
  std::string acceleration_unit, length;                   ///< as they are to be read
  double damping = 0.05;                                   ///< ζ [-]
  std::vector<std::pair<std::string, double>> marks = {};  ///< periods to be marked, with names
};
[[nodiscard]] Figure spectrum_figure(const SpectrumCurves& curves, double width = 8.8);

}  // namespace bentur
