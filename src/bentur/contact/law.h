#pragma once

#include <string_view>

namespace bentur {

/// Rules of the family of contact laws (docs/theory/contact.md):
///   δ [length] penetration = −opening; contact while δ > 0.   δ̇ [length/s] closing speed, > 0 while closing.
///   F [force] pushes the left building to the left and the right one to the right (3-2).
///   F = 0 for δ ≤ 0, F ≥ 0. No law sees the time step; δ is measured from the gap surface.
///   An isolated impact never gains energy. Laws are immutable; one may serve many points.
class ContactLaw {
 public:
  virtual ~ContactLaw() = default;

  /// The name a case gives it by, e.g. "linear".
  [[nodiscard]] virtual std::string_view name() const noexcept = 0;

  /// F [force] at penetration δ [length] and closing speed δ̇ [length/s]. Pure; NaN in gives NaN out.
  [[nodiscard]] virtual double force(double penetration, double closing_speed) const noexcept = 0;

  /// Slope ∂F/∂δ [force/length] of a law that is linear while it pushes; the exact solver's free flight needs no more.
  [[nodiscard]] virtual double stiffness() const noexcept = 0;
};

}  // namespace bentur
