#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bentur/elements/bearing_laws.h"
#include "bentur/structure/building.h"
#include "bentur/structure/damping.h"

namespace bentur {

/// Gravity loads of each floor [force] ≥ 0, bottom to top, which soften the storeys below (P-Δ): storey j gets −P_j/h_j
/// on x_j − x_{j−1}, P_j the loads of floors ≥ j; x_0 is the base, or the sway of the slab or the foundation.
struct GravityLoads {
  std::vector<double> loads;
};

/// Bearings below a slab: one more floor, at the base, the first of all lists.
struct Isolation {
  double mass = 0;         ///< of the slab [mass] > 0
  Bearings bearings = {};  ///< with a stiffness > 0
  double damping = 0;      ///< of a dashpot beside them [force·s/length] ≥ 0
};
/// All that moves above the bearings, slab included [mass].
[[nodiscard]] double mass_above_bearings(const StructuralModel& model, double slab_mass);

/// Sway and rocking of a foundation on springs and dashpots (L-3).
struct Soil {
  Impedance sway, rocking;
  double mass = 0;     ///< of the foundation [mass] > 0
  double inertia = 0;  ///< of the foundation [mass·length²] > 0
};

/// A rigid disc on the surface of a half-space.
struct HalfSpace {
  double shear_wave_velocity = 0;  ///< v_s [length/s] > 0
  double density = 0;              ///< ρ [mass/length³] > 0
  double poisson = 0;              ///< ν [-], 0 ≤ ν ≤ 0.5
  double radius = 0;               ///< r [length] > 0
};
/// G = ρ v_s², k_h = 8 G r/(2 − ν), c_h = 4.6 ρ v_s r²/(2 − ν), k_r = 8 G r³/(3(1 − ν)), c_r = 0.8 r⁴ √(ρ G)/((1 − ν)(1
/// + B_r)), B_r = 3(1 − ν) I_f/(8 ρ r⁵) [RichartHallWoods1970]. @throws InvalidParameter when a value is outside its
/// range.
[[nodiscard]] Soil soil_of(const HalfSpace& half_space, double mass, double inertia);

/// What a building stands on and carries.
struct Support {
  std::optional<GravityLoads> gravity = {};
  std::optional<Isolation> isolation = {};  ///< not together with soil
  std::optional<Soil> soil = {};
};

/// The building on its support. `model` and `damping` are those of the structure on a fixed base; damping acts on what
/// moves relative to the slab or the foundation. With soil two degrees of freedom come last, the foundation's sway u
/// and rocking θ (clockwise), and floors move by x = y + u + h θ. `storey_laws` of the structure, or empty; the slab's
/// comes first.
/// @throws InvalidParameter when a value is outside its range, or gravity loads leave K − K_g not positive definite: it
/// names the storey with the least margin.
[[nodiscard]] Building make_building(std::string name, StructuralModel model, const Damping& damping,
                                     const Support& support,
                                     std::vector<std::shared_ptr<const HystereticLaw>> storey_laws = {});

/// What moves with the ground: a moat wall. Floors at these elevations [length], ascending; no modes.
[[nodiscard]] Building rigid_building(std::string name, const std::vector<double>& elevations);

}  // namespace bentur
