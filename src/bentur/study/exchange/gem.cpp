#include "bentur/study/exchange/gem.h"

#include <fmt/format.h>

#include <variant>

namespace bentur {
namespace {

/// Its lateral system, with the stroke behind it; empty where the case does not say.
std::string system_of_building(const BuildingSpec& spec) {
  if (std::holds_alternative<PlaneFrame>(spec.structure)) return "LFM/";
  const auto* const generic = std::get_if<GenericBuilding>(&spec.structure);
  if (generic == nullptr) return "";
  // As `system` has them: wall 1, dual 4, frame 12; between them the nearer one.
  return generic->stiffness_ratio < 2 ? "LWAL/" : (generic->stiffness_ratio < 7 ? "LDUAL/" : "LFM/");
}

}  // namespace

std::string gem_taxonomy(const Case& c, const Problem& problem, Eigen::Index building, bool pounds) {
  const Eigen::Index last = std::ssize(problem.buildings) - 1;
  const int neighbours = (building > 0 ? 1 : 0) + (building < last ? 1 : 0);
  const std::string place = neighbours == 0 ? "BPD" : fmt::format("BP{}", neighbours);
  return system_of_building(c.buildings[static_cast<std::size_t>(building)]) +
         fmt::format("HEX:{}/{}", problem.buildings[building].model.storey_heights.size(), place) +
         (pounds ? "/IRIR+IRVP:POP" : "");
}

}  // namespace bentur
