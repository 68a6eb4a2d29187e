#include "bentur/files/result_netcdf.h"

#include "bentur/files/image/netcdf_image.h"
#include "bentur/io/results/plan/plan_variables.h"
#include "bentur/io/results/run_variables.h"

namespace bentur {
std::string histories_netcdf(const RunResults& results, std::string_view version) {
  return netcdf_image(run_file(results, version));
}

std::string histories_netcdf(const PlanRun& run, std::string_view version) {
  return netcdf_image(run_file(run, version));
}

}  // namespace bentur
