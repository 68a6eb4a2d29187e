#pragma once

#include <vector>

#include "bentur/structure/building.h"
#include "bentur/structure/frame/column_node.h"

namespace bentur {

/// Columns on either side of a building whose floors sway without turning, known by little or as a stick: what a
/// neighbour's floor strikes between floors. Their stiffness and mass are part of those of storeys and floors.
struct StoreyColumns {
  double elastic_modulus = 0;          ///< E [force/length²]
  std::vector<double> inertia;         ///< I of one [length⁴], one for all storeys or one per storey
  std::vector<double> mass;            ///< of one from floor to floor [mass], one for all or one per storey
  int number = 1;                      ///< of those that a floor strikes, side by side
  std::vector<ColumnNode> nodes = {};  ///< any order; their sways are dofs after the floors', in this order
};

/// Puts the nodes into a model of floors alone (docs/theory/structure.md, "Columns that are struck"): K gains what the
/// pieces of the columns, fixed to both floors, take beyond the whole columns, which are in K already, so that nothing
/// changes where nothing is struck; half the mass of the pieces goes from floors to nodes. Forces of column_forces are
/// those of all columns side by side. The model's floor_masses stay.
/// @throws InvalidParameter when a value is outside its range, columns are stiffer than their storey or heavier than a
/// floor, or a node is less than 1 % of the storey height from a floor or from another on its side.
void add_columns(StructuralModel& model, const StoreyColumns& columns);

}  // namespace bentur
