#pragma once

#include <string>
#include <string_view>

#include "bentur/model/plan/plan_run.h"
#include "bentur/model/run_results.h"

namespace bentur {

/// `histories.nc` as bytes: run_file() as NetCDF-4, CF conventions, opens in xarray. The same histories give the same
/// bytes. @throws std::runtime_error with the library's reason.
[[nodiscard]] std::string histories_netcdf(const RunResults& results, std::string_view version);
/// The same of buildings in plan.
[[nodiscard]] std::string histories_netcdf(const PlanRun& run, std::string_view version);

}  // namespace bentur
