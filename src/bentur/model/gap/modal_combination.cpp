#include "bentur/model/gap/modal_combination.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bentur/core/require.h"
#include "bentur/model/gap/separation_rules.h"

namespace bentur {

double combined_peak(const Eigen::VectorXd& peaks, const Eigen::VectorXd& omega, const Eigen::VectorXd& damping,
                     ModalCombination combination) {
  require_size("omega", static_cast<std::size_t>(omega.size()), static_cast<std::size_t>(peaks.size()));
  require_size("damping", static_cast<std::size_t>(damping.size()), static_cast<std::size_t>(peaks.size()));
  if (combination == ModalCombination::srss) return peaks.norm();
  const auto mode = [&](Eigen::Index n) {
    return SeparationInput{.period = 2 * std::numbers::pi / omega(n), .damping_ratio = damping(n)};
  };
  double square = peaks.squaredNorm();
  for (Eigen::Index n = 0; n < peaks.size(); ++n) {
    for (Eigen::Index m = 0; m < n; ++m) square += 2 * ddc_correlation(mode(n), mode(m)) * peaks(n) * peaks(m);
  }
  return std::sqrt(std::max(0.0, square));  // of round-off, where modes cancel
}

}  // namespace bentur
