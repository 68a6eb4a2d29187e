#include "bentur/pounding/internal/problem_checks.h"

#include <cmath>

namespace bentur {

void check_initial(const std::vector<Eigen::VectorXd>& values, const std::vector<Eigen::Index>& dofs,
                   const std::string& name) {
  if (values.empty()) return;
  require(values.size() == dofs.size(), name, fmt::format("{} entries", values.size()),
          "must be empty or have one entry per building");
  for (std::size_t b = 0; b < values.size(); ++b) {
    require(values[b].size() == dofs[b] && values[b].allFinite(), fmt::format("{}[{}]", name, b),
            fmt::format("{} entries", values[b].size()), "must have one finite entry per degree of freedom");
  }
}

void check_delays(const std::vector<double>& delays, std::size_t buildings) {
  require(delays.empty() || delays.size() == buildings, "delays", fmt::format("{} entries", delays.size()),
          "must be empty or have one entry per building");
  for (const double delay : delays) {
    require(std::isfinite(delay) && delay >= 0.0, "delays", delay, "must be finite and ≥ 0");
  }
}

}  // namespace bentur
