#include "bentur/files/netcdf_kind.h"

#include "bentur/files/netcdf.h"

namespace bentur {

bool is_netcdf_result(const std::filesystem::path& file, ResultKind kind) {
  try {
    return ask_netcdf(file, [&](const NetcdfNames& results) {
      if (!results.attribute("history").starts_with(result_history)) return false;
      if (kind == ResultKind::histories) return results.has("displacement_1") || results.has("displacement_x_1");
      return results.has("status") && results.has("intensity") == (kind == ResultKind::ida);
    });
  } catch (const NetcdfError&) {
    return false;
  }
}

}  // namespace bentur
