#include "bentur/model/closer/dense_parts.h"

#include <algorithm>
#include <numbers>

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double finest = 1.0 / 2000, coarsest = 1.0 / 200;  // [s]
constexpr double most_samples = 2e5;                         // of which spectra take a second a floor

/// Moments of one instant, or extremes of them, as stations × members.
MatrixXd by_member(const Eigen::VectorXd& moments) {
  constexpr Index stations = std::size(MemberForces::stations);
  return Eigen::Map<const MatrixXd>(moments.data(), stations, moments.size() / stations);
}

/// Raises the most and lowers the least of each row to those of more instants, a column each.
void take(const MatrixXd& more, Eigen::VectorXd& most, Eigen::VectorXd& least) {
  if (most.size() == 0) most = least = more.col(0);
  for (const auto instant : more.colwise()) {
    most = most.cwiseMax(instant);
    least = least.cwiseMin(instant);
  }
}

void take(const MemberForces::Forces& more, FrameForces::Forces& most, FrameForces::Forces& least) {
  Eigen::VectorXd highest = most.moments.reshaped(), lowest = least.moments.reshaped();
  take(more.moments, highest, lowest);
  most.moments = by_member(highest);
  least.moments = by_member(lowest);
  take(more.shears, most.shears, least.shears);
  take(more.axial, most.axial, least.axial);
}

}  // namespace

double dense_step(double duration, double numbers, double budget) {
  return std::max({finest, duration / most_samples, duration * numbers / budget});
}

bool is_dense(double step) { return step <= coarsest; }

Index column_at(const std::vector<double>& time, double at) {
  const auto next = std::lower_bound(time.begin(), time.end(), at);
  if (next == time.end()) return std::ssize(time) - 1;
  const bool is_before = next != time.begin() && at - *(next - 1) < *next - at;
  return next - time.begin() - (is_before ? 1 : 0);
}

void take_extremes(const MemberForces& forces, const MatrixXd& sways, const MatrixXd& turned, bool touches,
                   FrameForces& found) {
  constexpr Index block = 100;  // instants at a time, so few that a processor has them at hand
  for (Index from = 0; from < sways.cols(); from += block) {
    const Index count = std::min(block, sways.cols() - from);
    const MemberForces::Forces all = forces.forces(sways.middleCols(from, count), turned.middleCols(from, count));
    take(all, touches ? found.most : found.most_without_contact, touches ? found.least : found.least_without_contact);
  }
}

void take_instant(const MemberForces& forces, const MatrixXd& sways, const MatrixXd& turned,
                  const std::vector<double>& time, Index column, FrameForces& found) {
  const MemberForces::Forces then = forces.forces(sways.col(column), turned.col(column));
  found.members = forces.members();
  found.time = time[static_cast<std::size_t>(column)];
  found.instant = {by_member(then.moments), then.shears, then.axial};
}

std::vector<double> dense_periods(const std::vector<Eigen::VectorXd>& omegas, double step) {
  double longest = 2;  // or of a building, with room to be seen [s]
  for (const Eigen::VectorXd& of_one : omegas) {
    if (of_one.size() > 0 && of_one(0) > 0) longest = std::max(longest, 4 * std::numbers::pi / of_one(0));
  }
  return spectrum_periods(omegas, 60 * step, longest);
}

}  // namespace bentur
