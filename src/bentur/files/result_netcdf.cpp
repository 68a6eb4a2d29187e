#include "bentur/files/result_netcdf.h"

#include "bentur/files/netcdf.h"
#include "bentur/io/results/run_variables.h"

namespace bentur {

std::string histories_netcdf(const RunResults& results, std::string_view version) {
  const ResultFile file = run_file(results, version);
  NetcdfWriter writer("histories.nc", NetcdfWriter::Place::memory);
  for (const ResultAttribute& attribute : file.attributes) writer.attribute(attribute);
  for (const ResultVariable& variable : file.variables) writer.add(variable);
  return writer.finish();
}

}  // namespace bentur
