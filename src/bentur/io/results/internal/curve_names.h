#pragma once

#include <array>

#include "bentur/pounding/response.h"

namespace bentur {

/// Of the forces at the ends of a struck column, in the order of StructuralModel::column_forces.
struct ColumnEnd {
  const char *name, *long_name;
  bool is_moment = false;
};
inline constexpr std::array<ColumnEnd, 6> column_ends = {{
    {"node_shear_below", "shear of struck columns below the node", false},
    {"node_shear_above", "shear of struck columns above the node", false},
    {"node_moment_bottom", "moment at the bottom of struck columns", true},
    {"node_moment_below", "moment of struck columns at the node, of the piece below it", true},
    {"node_moment_above", "moment of struck columns at the node, of the piece above it", true},
    {"node_moment_top", "moment at the top of struck columns", true},
}};

struct EnergyCurve {
  const char* name;
  Eigen::VectorXd EnergyHistories::*values;
  const char* long_name;
};
inline constexpr std::array<EnergyCurve, 7> energy_curves = {{
    {"input", &EnergyHistories::input, "energy at the start and work of the ground motion so far"},
    {"kinetic", &EnergyHistories::kinetic, "kinetic energy of the buildings, relative to their bases"},
    {"strain", &EnergyHistories::strain, "strain energy of the buildings and links"},
    {"damping", &EnergyHistories::damping, "energy lost to the damping of the buildings and links so far"},
    {"hysteretic", &EnergyHistories::hysteretic, "energy lost to yielding of storeys and links so far"},
    {"contact_stored", &EnergyHistories::contact_stored, "energy stored in contacts, to be given back"},
    {"contact_lost", &EnergyHistories::contact_lost, "energy lost in contacts so far"},
}};

}  // namespace bentur
