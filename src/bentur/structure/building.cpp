#include "bentur/structure/building.h"

#include <algorithm>

#include <utility>

#include "bentur/structure/damping.h"
#include "bentur/structure/modes.h"

namespace bentur {

Building make_building(std::string name, StructuralModel model, const Damping& damping) {
  Modes free_modes = modes(model.mass, model.stiffness);
  Eigen::MatrixXd c = modal_damping(damping, free_modes);
  return {std::move(name), std::move(model), std::move(free_modes), std::move(c)};
}

bool Building::can_yield() const {
  return std::any_of(storey_laws.begin(), storey_laws.end(), [](const auto& law) { return law != nullptr; });
}

}  // namespace bentur
