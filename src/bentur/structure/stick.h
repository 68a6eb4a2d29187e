#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bentur/elements/law_entry.h"
#include "bentur/elements/softening/backbone_law.h"
#include "bentur/structure/building.h"

namespace bentur {

/// How the storeys of a stick lose their strength (L-5), (L-6). Of each number one for all storeys or one per storey.
struct StoreyBackbones {
  /// One side; what is empty has the default of Backbone.
  struct Side {
    std::vector<double> yield;  ///< [force], not empty; infinite: the storey stays elastic
    std::vector<double> cap, plastic, softening, residual, ultimate;
  };
  Side positive;
  std::optional<Side> negative = {};  ///< nothing: as the other
  Deterioration deterioration = {};
  Reloading reloading = Reloading::bilinear;
  double pinching_force = 1, pinching_deformation = 0;  ///< κ_F, κ_D
};

/// A shear building: one mass and one lateral spring per storey.
struct Stick {
  std::vector<double> storey_heights;     ///< [length], bottom to top
  std::vector<double> masses;             ///< [mass]
  std::vector<double> stiffnesses;        ///< [force/length] of each storey
  std::vector<double> yield_forces = {};  ///< V_y [force], one for all or one per storey; infinite: it stays elastic;
                                          ///< empty: all do
  std::vector<double> hardening = {};     ///< r [-], one for all or one per storey; empty: 0
  std::string hysteresis = "bilinear";    ///< how a storey that has yielded unloads and loads again: a name of
                                          ///< hysteretic_laws()
  std::map<std::string, double, std::less<>> law_numbers = {};     ///< what that law has beside these; defaults else
  std::shared_ptr<const LawEntryOf<HystereticLaw>> own = nullptr;  ///< a law that is not listed, in place of that
  std::optional<StoreyBackbones> backbone = {};  ///< in place of all that has to do with yielding above
};

/// One sway per floor: M diagonal, K tridiagonal, load = the masses. `base_elevation` as assemble_plane_frame().
/// @throws InvalidParameter when list lengths disagree, or a value is not finite and > 0 (`base_elevation`: not
/// finite).
[[nodiscard]] StructuralModel stick_model(const Stick& stick, double base_elevation = 0.0);

/// The law of storey `storey` (0 the lowest) where its stiffness is this [force/length], > 0; null: it stays elastic.
/// @throws InvalidParameter as storey_laws().
[[nodiscard]] std::shared_ptr<const HystereticLaw> storey_law(const Stick& stick, std::size_t storey, double stiffness);

/// The law of each storey's drift, null where it stays elastic; empty where all do. `model` is made of the stick; where
/// its stiffness has been scaled since (calibrate_period()), so is that of every law, and V_y stays as it is given.
/// @throws InvalidParameter unless there is such a law, yield forces and hardening are one for all or one per storey
/// and every value is in its range.
[[nodiscard]] std::vector<std::shared_ptr<const HystereticLaw>> storey_laws(const Stick& stick,
                                                                            const StructuralModel& model);

}  // namespace bentur
