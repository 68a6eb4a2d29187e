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

/// All three of some instants, one a column.
struct AllForces {
  MatrixXd moments, shears, axial;

  AllForces(const MemberForces& of, const MatrixXd& sways, const MatrixXd& turned)
      : moments(of.moments(sways, turned)), shears(of.shears(sways, turned)), axial(of.axial_forces(sways, turned)) {}
};

/// Raises extremes, the least ones with sign −1, to those of more instants.
void raise(FrameForces::Forces& extremes, const AllForces& more, double sign) {
  const auto take = [&](const MatrixXd& all, Eigen::VectorXd& so_far) {
    Eigen::VectorXd here = sign * (sign * all).rowwise().maxCoeff();
    so_far = so_far.size() == 0 ? here : Eigen::VectorXd(sign * (sign * so_far).cwiseMax(sign * here));
  };
  Eigen::VectorXd moments = extremes.moments.reshaped();
  take(more.moments, moments);
  extremes.moments = by_member(moments);
  take(more.shears, extremes.shears);
  take(more.axial, extremes.axial);
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
  constexpr Index block = 1000;  // instants in memory at a time
  for (Index from = 0; from < sways.cols(); from += block) {
    const Index count = std::min(block, sways.cols() - from);
    const AllForces all(forces, sways.middleCols(from, count), turned.middleCols(from, count));
    raise(touches ? found.most : found.most_without_contact, all, 1);
    raise(touches ? found.least : found.least_without_contact, all, -1);
  }
}

void take_instant(const MemberForces& forces, const MatrixXd& sways, const MatrixXd& turned,
                  const std::vector<double>& time, Index column, FrameForces& found) {
  const AllForces then(forces, sways.col(column), turned.col(column));
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
