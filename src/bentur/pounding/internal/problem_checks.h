#pragma once

#include <fmt/format.h>
#include <Eigen/Core>

#include <string>
#include <vector>

#include "bentur/core/errors.h"

// What problems of rows and of plans are checked for alike.
namespace bentur {

/// A time of which the whole analysis has so many has no phase left in a double [-].
constexpr double most_times = 1e15;

template <class Value>
void require(bool ok, const std::string& parameter, const Value& value, const std::string& rule) {
  if (!ok) throw InvalidParameter(parameter, fmt::format("{}", value), rule);
}

/// Initial displacements or velocities, none or one list per building. @param dofs of each building
/// @throws InvalidParameter unless they are finite and one per degree of freedom.
void check_initial(const std::vector<Eigen::VectorXd>& values, const std::vector<Eigen::Index>& dofs,
                   const std::string& name);

/// @throws InvalidParameter unless there are none, or one that is finite and ≥ 0 per building.
void check_delays(const std::vector<double>& delays, std::size_t buildings);

}  // namespace bentur
