#pragma once

#include <string_view>
#include <vector>

#include "bentur/contact/law.h"
#include "bentur/elements/law_entry.h"

namespace bentur {

using LawEntry = LawEntryOf<ContactLaw>;

// Keys that several laws have.
[[nodiscard]] Key spring_stiffness();     ///< k > 0 [force/length], or "axial": of the floor beams (3-4)
[[nodiscard]] Key hertz_law_stiffness();  ///< β > 0 [force/length^1.5]
/// Of those that exclude one another: e, ξ.
[[nodiscard]] Key asked_restitution();
[[nodiscard]] Key asked_damping_ratio();

/// calibration = "exact" or "published", for laws that take a restitution.
[[nodiscard]] const Key& exact_or_published();

/// Every law, in the order of the documentation.
[[nodiscard]] const std::vector<LawEntry>& contact_laws();

/// The law of that name; null when there is none.
[[nodiscard]] const LawEntry* find_law(std::string_view name);

}  // namespace bentur
