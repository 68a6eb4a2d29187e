#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/contact/laws.h"

namespace bentur {

/// Contact of one gap: a law of contact/laws.h and what the case says of it, key by key.
struct ContactSpec {
  std::string law = "linear";
  bool axial = false;  ///< stiffness = "axial", by (3-4)
  /// One value for all contact points or one each.
  std::map<std::string, std::vector<double>, std::less<>> numbers = {};
  std::map<std::string, std::string, std::less<>> words = {};  ///< choices made; the others have their defaults
  std::shared_ptr<const LawEntry> own = nullptr;               ///< a law that is not listed, in place of `law`

  /// What is given for contact point `point` of the gap (0 the lowest); nothing where the key is not given.
  /// @throws InvalidParameter when a list has no such entry.
  [[nodiscard]] std::optional<double> number(std::string_view key, std::size_t point) const;
  /// The choices that apply, made or by default: release; calibration where restitution is given.
  [[nodiscard]] std::map<std::string, std::string, std::less<>> choices() const;
};

/// m_e [mass] of two floors, of which one may be infinite.
[[nodiscard]] double effective_mass(double one, double other);

/// What contact point `point` of the gap gives its law. Of a point that carries a share σ of the whole contact all
/// stiffness has that share, and the effective mass, by which damping follows from it (P-9).
/// @throws InvalidParameter where there is no such law, or a list no such entry.
[[nodiscard]] LawInput contact_input(const ContactSpec& contact, std::size_t point, double effective_mass,
                                     double share = 1);
/// @throws InvalidParameter, naming the key at fault, when the law's values do not go together.
[[nodiscard]] std::shared_ptr<const ContactLaw> make_contact_law(const ContactSpec& contact, const LawInput& input);

}  // namespace bentur
