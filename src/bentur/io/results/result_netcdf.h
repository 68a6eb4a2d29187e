#pragma once

#include <string>
#include <string_view>

#include "bentur/solve/problem.h"
#include "bentur/solve/response.h"
#include "bentur/study/case.h"

namespace bentur {

/// `histories.nc` as bytes: NetCDF-4, CF conventions, opens in xarray. Dimensions `time`, `elevation_N` for building N
/// (1 the leftmost) with the floors' elevations as coordinate, `point` for the contact points. Variables
/// `displacement_N`, `velocity_N`, `acceleration_N` (absolute), `opening`, `force`, `ground_acceleration`, each with
/// units and long_name. The same histories give the same bytes.
/// @throws std::runtime_error with the library's reason.
[[nodiscard]] std::string histories_netcdf(const Case& c, const Problem& problem, const Histories& histories,
                                           std::string_view version);

}  // namespace bentur
