#pragma once

#include "bentur/elements/law.h"

namespace bentur {

/// Rules of the family of contact laws (docs/theory/contact.md):
///   δ [length] penetration = −opening.   δ̇ [length/s] closing speed, > 0 while closing.
///   F [force] pushes the left building to the left and the right one to the right (3-2).
///   F = 0 while not touching; F ≥ 0, but for a law that says that it can pull. δ is measured from the gap surface.
///   An isolated impact never gains energy. No law sees a time step.
/// Branch 0 is apart: F = 0, guarded by −δ ≥ 0.
class ContactLaw : public Law {
 public:
  static constexpr int apart = 0;  ///< LawState::branch

  /// As most contact laws have it: a contact begins in branch 1, ends by guard 0, and changes between branches 1 and 2
  /// by any other guard.
  [[nodiscard]] LawState next(const LawState& state, std::size_t guard, double time, double penetration,
                              double closing_speed) const noexcept override;
};

}  // namespace bentur
