#pragma once

#include <optional>
#include <vector>

#include "bentur/pounding/pounding.h"
#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"

namespace bentur {

/// One impact sampled so densely that its course can be seen, with half its duration before and after it.
struct CloseUp {
  int impact = 0;               ///< index into Response::impacts
  std::vector<double> time;     ///< [s]
  std::vector<double> opening;  ///< g of its contact point [length], negative in contact
  std::vector<double> force;    ///< F of its contact point [force]
};

/// The hardest impact, of a gap or of all, that has a duration and a force, by solving the problem once more up to its
/// end with samples 1/200 of the impact apart. Nothing when there is no such impact, or when it is so short and so late
/// that fewer than 40 samples of it would fit `budget` numbers in memory.
[[nodiscard]] std::optional<CloseUp> close_up(const Problem& problem, const Response& response, const Solver& solver,
                                              double budget = 2e7, std::optional<Eigen::Index> gap = {});

}  // namespace bentur
