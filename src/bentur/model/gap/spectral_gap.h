#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bentur/model/case.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/gap/minimum_gap.h"
#include "bentur/pounding/plan/plan_problem.h"
#include "bentur/pounding/response.h"

namespace bentur {

/// The modes of a building under a spectrum: each at its own peak.
struct SpectralModes {
  Eigen::VectorXd omega;         ///< [rad/s]; of a rigid building none
  Eigen::VectorXd damping;       ///< ζ_n [-], the diagonal of the modal damping
  Eigen::VectorXd displacement;  ///< S_d(T_n, ζ_n) [length]
  /// φ_n Γ_n S_d(T_n, ζ_n) of each direction in which the ground moves, one or, in plan, along x and along y: dofs ×
  /// modes [length, rad]
  std::vector<Eigen::MatrixXd> motions;
};
/// @throws InvalidParameter where a period is beyond the last of a table.
[[nodiscard]] SpectralModes spectral_modes(const Building& building, const DesignSpectrum& spectrum);
[[nodiscard]] SpectralModes spectral_modes(const PlanBuilding& building, const DesignSpectrum& spectrum);

/// Peak displacements of the floors [length], by both combinations; in plan of their centres of mass, along x and y.
struct SpectralPeaks {
  Eigen::VectorXd srss, cqc;
  Eigen::VectorXd srss_y = {}, cqc_y = {};  ///< empty of a row
};
[[nodiscard]] SpectralPeaks spectral_peaks(const Building& building, const SpectralModes& modes);
[[nodiscard]] SpectralPeaks spectral_peaks(const PlanBuilding& building, const SpectralModes& modes);

/// What an elastic building is loaded to by a spectrum, over what it can bear, where that is the most.
struct CapacityDemand {
  double ratio = 0;         ///< [-] of the yield force of a storey or the capacity of a hinge; 0: none is given
  Eigen::Index storey = 0;  ///< from 0, a slab's bearings included
};
/// By the larger of the elastic deformations of storeys over those at which they yield, and of elastic moments and
/// shears, with those of gravity loads, over capacities of hinges and of columns that break.
[[nodiscard]] CapacityDemand capacity_demand(const Building& building, const SpectralModes& modes,
                                             ModalCombination combination);
/// Of its planes.
[[nodiscard]] CapacityDemand capacity_demand(const PlanBuilding& building, const SpectralModes& modes,
                                             ModalCombination combination);

/// The storey with the largest peak drift over its height, of a building in plan along its edges and planes; 0 of a
/// rigid building.
[[nodiscard]] LargestDrift spectral_drift(const Building& building, const SpectralModes& modes,
                                          ModalCombination combination);
[[nodiscard]] LargestDrift spectral_drift(const PlanBuilding& building, const SpectralModes& modes,
                                          ModalCombination combination);

/// The gaps needed under a spectrum.
struct SpectralGaps {
  std::vector<SpectralModes> modes;     ///< per building
  std::vector<SpectralPeaks> peaks;     ///< per building
  std::vector<CapacityDemand> demands;  ///< per building
  std::vector<LargestDrift> drifts;     ///< per building
  /// Per facing level; `gap_needed` is the spectral difference: the peak of x_left − x_right by the case's combination
  /// over the modes of both buildings (with one mode each and CQC it is DDC); of buildings known by their peaks the sum
  /// of both. ABS, SRSS and DDC combine the peaks of both faces. Rules of codes take these peaks divided by `reduction`
  /// of their buildings, or by the `amplification` of peaks that are given.
  std::vector<LevelSeparation> levels;
  /// Of buildings in plan, whose gaps are reported as those of row_of() it; null: a row.
  std::shared_ptr<const PlanProblem> plan = {};
};
/// Buildings are elastic, with their initial stiffness; delays and kinematics play no part.
/// @throws InvalidParameter where the spectrum does not pass validate(), a period is beyond the last of a table, or a
/// code rule lacks something.
[[nodiscard]] SpectralGaps spectral_gaps(const Problem& problem, const SpectrumSpec& spectrum,
                                         const CodeSpec& code = {}, const Units& units = {});
/// The same in plan: one spectrum along x and along y, and of both the root of the sum of squares, which is the same in
/// whatever direction they act (C. Menun and A. Der Kiureghian, A replacement for the 30 %, 40 % and SRSS rules for
/// multicomponent seismic analysis, Earthquake Spectra 14 (1998) 153-163). Peaks are those across the gap.
[[nodiscard]] SpectralGaps spectral_gaps(const PlanProblem& problem, const SpectrumSpec& spectrum,
                                         const CodeSpec& code = {}, const Units& units = {});

/// "S_DS 0.8 g, S_D1 0.55 g, T_L 12 s", in every language the same.
[[nodiscard]] std::string spectrum_parameters(const SpectrumSpec& spectrum, const Units& units);

/// What keeps a case from having its gaps by a spectrum, in words; empty where nothing does: links couple the buildings
/// (their modes are not those of each alone), bearings that yield have no stiffness of their own.
struct SpectralObstacle {
  std::optional<std::size_t> building;  ///< at fault; nothing: the links
  std::string what;
};
[[nodiscard]] std::optional<SpectralObstacle> spectral_obstacle(const Case& c);

}  // namespace bentur
