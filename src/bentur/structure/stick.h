#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bentur/elements/law_entry.h"
#include "bentur/structure/building.h"

namespace bentur {

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
};

/// One sway per floor: M diagonal, K tridiagonal, load = the masses. `base_elevation` as assemble_plane_frame().
/// @throws InvalidParameter when list lengths disagree, or a value is not finite and > 0 (`base_elevation`: not
/// finite).
[[nodiscard]] StructuralModel stick_model(const Stick& stick, double base_elevation = 0.0);

/// The law of each storey's drift, null where it stays elastic; empty where all do. `model` is made of the stick; where
/// its stiffness has been scaled since (calibrate_period()), so is that of every law, and V_y stays as it is given.
/// @throws InvalidParameter unless there is such a law, yield forces and hardening are one for all or one per storey
/// and every value is in its range.
[[nodiscard]] std::vector<std::shared_ptr<const HystereticLaw>> storey_laws(const Stick& stick,
                                                                            const StructuralModel& model);

}  // namespace bentur
