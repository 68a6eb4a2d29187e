#pragma once

#include "bentur/core/require.h"
#include "bentur/structure/building.h"

namespace bentur {

/// A water tower by Housner's two masses: one that moves with the tank, one that sloshes in it on a spring.
struct Tank {
  double height = 0;              ///< of the tank above the ground datum [length]
  double impulsive_mass = 0;      ///< tank, tower and the water that moves with them [mass]
  double convective_mass = 0;     ///< water that sloshes [mass]
  double tower_stiffness = 0;     ///< [force/length]
  double sloshing_stiffness = 0;  ///< [force/length]
};

/// One floor, the tank, and after it a degree of freedom that is no floor, the water's sway.
/// @throws InvalidParameter unless all of it is finite and > 0.
[[nodiscard]] inline StructuralModel tank_model(const Tank& tank) {
  require_positive("height", tank.height);
  require_positive("impulsive_mass", tank.impulsive_mass);
  require_positive("convective_mass", tank.convective_mass);
  require_positive("tower_stiffness", tank.tower_stiffness);
  require_positive("sloshing_stiffness", tank.sloshing_stiffness);
  const double tower = tank.tower_stiffness, water = tank.sloshing_stiffness;
  StructuralModel model;
  model.elevations = model.storey_heights = {tank.height};
  model.load = Eigen::Vector2d(tank.impulsive_mass, tank.convective_mass);
  model.mass = model.load.asDiagonal();
  model.stiffness = (Eigen::Matrix2d() << tower + water, -water, -water, water).finished();
  model.floor_masses = {tank.impulsive_mass};
  model.drifts = Eigen::RowVector2d(1, 0);
  model.shears = Eigen::RowVector2d(tower, 0);  // of the tower: K's row has the water's spring too
  return model;
}

}  // namespace bentur
