#include "bentur/files/result_netcdf.h"

#include "bentur/files/netcdf.h"
#include "bentur/io/results/plan/plan_variables.h"
#include "bentur/io/results/run_variables.h"

namespace bentur {
namespace {

std::string bytes_of(const ResultFile& file) {
  NetcdfWriter writer("histories.nc", NetcdfWriter::Place::memory);
  for (const ResultAttribute& attribute : file.attributes) writer.attribute(attribute);
  writer.add(file.variables);
  return writer.finish();
}

}  // namespace

std::string histories_netcdf(const RunResults& results, std::string_view version) {
  return bytes_of(run_file(results, version));
}

std::string histories_netcdf(const PlanRun& run, std::string_view version) { return bytes_of(plan_file(run, version)); }

}  // namespace bentur
