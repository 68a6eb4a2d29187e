#pragma once

#include <string>
#include <string_view>

#include "bentur/solve/problem.h"
#include "bentur/solve/response.h"
#include "bentur/study/case.h"

namespace bentur {

/// `histories.nc` as bytes: NetCDF-4, CF conventions, opens in xarray. Dimensions `time`, `elevation_N` for building N
/// (1 the leftmost) with the floors' elevations as coordinate, `point` for the contact points. Variables
/// `displacement_N`, `velocity_N`, `acceleration_N` (absolute), `opening`, `force`, `ground_acceleration`, with an
/// energy audit also `energy_input`, `energy_kinetic`, `energy_strain`, `energy_damping`, `energy_contact_stored`,
/// `energy_contact_lost`; each with units and long_name. The same histories give the same bytes.
/// @throws std::runtime_error with the library's reason.
[[nodiscard]] std::string histories_netcdf(const Case& c, const Problem& problem, const Response& response,
                                           std::string_view version);

}  // namespace bentur
