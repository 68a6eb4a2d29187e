#pragma once

#include <vector>

#include "bentur/model/closer/floor_spectra.h"
#include "bentur/model/closer/frame_forces.h"

// What dense runs of rows and of plans have in common.
namespace bentur {

/// How far apart samples of a dense run may be [s], one run being in memory at a time. @param numbers of one sample
/// @param budget numbers in memory
[[nodiscard]] double dense_step(double duration, double numbers, double budget);
/// Whether samples so far apart tell spectra and extremes.
[[nodiscard]] bool is_dense(double step);

/// The sample nearest to an instant.
[[nodiscard]] Eigen::Index column_at(const std::vector<double>& time, double at);

/// Raises the extremes of a frame, with contact or without, to those of its movements, an instant a column.
/// @param sways, turned as MemberForces takes them
void take_extremes(const MemberForces& forces, const Eigen::MatrixXd& sways, const Eigen::MatrixXd& turned,
                   bool touches, FrameForces& found);
/// Gives it its members and what they carry at the instant that is shown.
void take_instant(const MemberForces& forces, const Eigen::MatrixXd& sways, const Eigen::MatrixXd& turned,
                  const std::vector<double>& time, Eigen::Index column, FrameForces& found);

/// The periods of spectra of floors of buildings with these circular frequencies, from 60 steps on.
[[nodiscard]] std::vector<double> dense_periods(const std::vector<Eigen::VectorXd>& omegas, double step);

}  // namespace bentur
