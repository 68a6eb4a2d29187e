#include "bentur/structure/known/displacements.h"

#include <utility>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/structure/support.h"

namespace bentur {

Building known_by_displacements(std::string name, const DisplacementsSpec& given, double base_elevation) {
  require_size("displacements", given.displacements.size(), given.elevations.size());
  for (const double u : given.displacements) require_not_negative("displacements", u);
  require_positive("amplification", given.amplification);
  require_not_negative("damping_ratio", given.damping_ratio);
  if (given.period) require_positive("period", *given.period);
  std::vector<double> elevations = given.elevations;
  for (double& elevation : elevations) elevation += base_elevation;
  Building building = rigid_building(std::move(name), elevations);
  require_positive("elevations", given.elevations.front());
  building.model.storey_heights.front() = given.elevations.front();
  building.given = {Eigen::Map<const Eigen::VectorXd>(given.displacements.data(), std::ssize(given.displacements)),
                    given.amplification, given.period, given.damping_ratio};
  return building;
}

}  // namespace bentur
