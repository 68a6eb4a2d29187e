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
    Eigen::Vector2d along = Eigen::Vector2d::Zero();  ///< of one in plan: its direction, of length 1; of a row zero
    std::vector<double> with_contact = {}, without_contact = {};  ///< S_a [length/s²], one per period
  };
  std::vector<Floor> floors = {};  ///< building by building, the highest first
};

/// Those that are of interest: of both buildings at the hardest impact the floor that is hit, or that the struck column
/// is below, and the roof; without an impact the roofs of at most six buildings. None that moves with the ground.
[[nodiscard]] std::vector<FloorSpectra::Floor> spectrum_floors(const Problem& problem, const Response& response);

/// Periods [s] so near to one another that the peak of 5 % damping is met within 1 %, those of the floors' buildings
/// among them. @param omegas theirs [rad/s], building by building
[[nodiscard]] std::vector<double> spectrum_periods(const std::vector<Eigen::VectorXd>& omegas, double shortest,
                                                   double longest);

/// What the ground gains in speed from the motion's start on, at these times less a delay. [length/s]
[[nodiscard]] Eigen::VectorXd ground_speed(const GroundMotion& motion, const std::vector<double>& time, double delay);

/// The speed of a floor, absolute but for what the ground had at the start. [length/s]
[[nodiscard]] Eigen::VectorXd floor_speed(const Histories& histories, const Problem& problem, Eigen::Index building,
                                          Eigen::Index floor);

/// The mean acceleration over each so many samples of a speed that are `step` apart: an impact counts by its impulse,
/// however short it is. [length/s²]
[[nodiscard]] SampledMotion mean_acceleration(double step, const Eigen::VectorXd& speed, Eigen::Index samples);

/// The spectrum of that: of each period by the longest means that leave 60 or more to it, by which S_a falls
/// some 0.3 % short at most, half of it by the means and half by what lies between samples. Periods are 60 samples long
/// or more.
[[nodiscard]] std::vector<double> floor_spectrum(double step, const Eigen::VectorXd& speed,
                                                 const std::vector<double>& periods, double damping);

}  // namespace bentur
