#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "bentur/solve/solver.h"

namespace bentur {

/// A number that a system depends on, by the systems with a little less and a little more of it.
struct Variation {
  double step = 0;  ///< what is taken away and added [the number's unit] > 0
  System below, above;
};

/// Something that was found, and its derivatives.
struct Derivative {
  double value = 0;    ///< as the tangent run has it
  double time = 0;     ///< when it is reached [s]
  Eigen::VectorXd by;  ///< per variation [its unit / that of the number]; empty: not known
  /// Of all events up to then the smallest |ġ| over what it usually is [-]: where a contact sets in by grazing, it is
  /// near zero and no derivative holds for long.
  double grazing = 1;
  bool is_equalled = false;      ///< another peak is as large, to 10⁻⁶
  bool is_simultaneous = false;  ///< two events at one instant came before: only of their order is this the derivative
};

/// The derivatives of what is found by every number, through the events (docs/theory/sensitivity.md).
struct Tangents {
  std::vector<Derivative> needed, peak_force;  ///< per contact; value 0 and no derivatives where there is none
  std::vector<std::vector<Derivative>> displacement, displacement_free;  ///< per body, of its first Outputs
};

/// Why a system's derivatives cannot be found: its bodies yield, a law's force is curved, contacts rub or meet.
[[nodiscard]] std::optional<std::string> why_no_tangents(const System& system);
/// Why they cannot be found by a number; nothing: they can.
[[nodiscard]] std::optional<std::string> why_no_tangents(const System& system, const Variation& by);

/// Follows the exact solution event by event: no event is searched for again.
/// @param found with changes (RunOptions), of the contacts of the system
/// @throws InvalidParameter where why_no_tangents() says so, or a contact rests or several part at once without time
[[nodiscard]] Tangents tangents(const FreeSolution& free, const Solution& found,
                                const std::vector<Variation>& variations);

}  // namespace bentur
