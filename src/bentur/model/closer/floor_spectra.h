#pragma once

#include <vector>

#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"

namespace bentur {

/// Response spectra of the motion of floors (in-structure spectra): S_a = ω² max |z| of what stands on a floor,
///   z̈ + 2ζω ż + ω² z = −(ẍ + a_g).
struct FloorSpectra {
  double damping = 0.05;             ///< ζ [-]
  std::vector<double> periods = {};  ///< T [s]
  struct Floor {
    Eigen::Index building = 0, floor = 0;
    std::vector<double> with_contact = {}, without_contact = {};  ///< S_a [length/s²], one per period
  };
  std::vector<Floor> floors = {};  ///< building by building, the highest first
};

/// Those that are of interest: of both buildings at the hardest impact the floor that is hit, or that the struck column
/// is below, and the roof; without an impact the roofs of at most six buildings. None that moves with the ground.
[[nodiscard]] std::vector<FloorSpectra::Floor> spectrum_floors(const Problem& problem, const Response& response);

/// Periods [s] so near to one another that the peak of 5 % damping is met within 1 %, those of the floors' buildings
/// among them.
[[nodiscard]] std::vector<double> spectrum_periods(const Problem& problem,
                                                   const std::vector<FloorSpectra::Floor>& floors, double shortest,
                                                   double longest);

/// The mean acceleration of a floor, absolute, over each so many samples: what it gains in speed and the ground with
/// it, so that an impact counts by its impulse, however short it is. [length/s²]
[[nodiscard]] SampledMotion floor_motion(const Histories& histories, const Problem& problem, Eigen::Index building,
                                         Eigen::Index floor, Eigen::Index samples);

/// The spectrum of that: of each period by the longest means that leave 60 or more to it, by which S_a falls 0.14 %
/// short at most. Periods are 60 samples long or more.
[[nodiscard]] std::vector<double> floor_spectrum(const Histories& histories, const Problem& problem,
                                                 Eigen::Index building, Eigen::Index floor,
                                                 const std::vector<double>& periods, double damping);

}  // namespace bentur
