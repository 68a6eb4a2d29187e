#pragma once

#include <optional>
#include <vector>

#include "bentur/model/case.h"
#include "bentur/model/close_up.h"
#include "bentur/model/closer/dense_run.h"
#include "bentur/model/closer/nearest_floor.h"
#include "bentur/model/quantities.h"
#include "bentur/model/story/remarks.h"
#include "bentur/solve/spectrum/response_spectrum.h"

namespace bentur {

/// What figures show beyond the histories; kept with them so that the figures can be drawn again.
struct FigureData {
  std::optional<CloseUp> close_up = {};
  double spectrum_damping = 0.05;              ///< ζ [-]
  std::vector<double> spectrum_periods = {};   ///< T [s]; empty: no spectrum
  std::vector<OscillatorPeaks> spectrum = {};  ///< one per period
  std::optional<NearestFloor> nearest = {};    ///< where a gap has watched floors
  FloorSpectra floor_spectra = {};             ///< without floors: none
  std::vector<FrameForces> frames = {};        ///< of the buildings that are frames whose members are known
};

/// The mode shapes at the floors, floors × modes, each with its largest sway 1 [-].
[[nodiscard]] Eigen::MatrixXd sway_shapes(const Building& building);

/// A run, just solved or read again from its results: what everything that is reported of it is made from.
struct RunResults {
  Case c;
  Problem problem;
  Response response;
  std::vector<Remark> remarks;
  FigureData figures = {};

  [[nodiscard]] RunView view() const {
    RunView view(problem, response, c.units);
    view.remarks = &remarks;
    return view;
  }
};

/// The hardest impact in close-up, the 5 % spectrum of a recorded ground motion and those of floors, and what members
/// of frames carry.
[[nodiscard]] FigureData figure_data(const RunResults& run);
/// The same where `known` is that of a run before: of the same motion it has the spectrum already.
[[nodiscard]] FigureData figure_data(const RunResults& run, const GroundMotion& of_known, FigureData known);
/// Finds what figures show beyond the histories, for the run to keep.
inline void find_figures(RunResults& run) { run.figures = figure_data(run); }

/// Whether some building has storeys that can yield, by the problem or, where its laws are not known, by the response.
[[nodiscard]] bool some_building_yields(const Problem& problem, const Response& response);

/// Largest |a_g| as applied [length/s²]; of results read back the record says it, whose values they do not hold.
[[nodiscard]] double applied_pga(const Case& c);

/// Those of a run that has been solved, of the data for figures the nearest floor alone; the problem has the duration
/// that the run came to.
[[nodiscard]] RunResults run_results(Case c, Problem problem, Response response);

/// What one compares first. A building's weight is that of its floors' lumped masses: half of a frame's lowest columns
/// stands on the ground.
struct Proportions {
  double weight = 0;                             ///< [force]; 0 where masses are not known
  double period_per_storey = 0;                  ///< first period over the number of storeys [s]
  std::optional<double> base_shear_coefficient;  ///< peak shear of the first storey over the weight [-]
};
[[nodiscard]] Proportions proportions(const Building& building, const Units& units, const BuildingPeaks* peaks);

}  // namespace bentur
