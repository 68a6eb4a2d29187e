#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/contact/law.h"

namespace bentur {

/// What a case may say of a law: a number, in the case's units.
struct LawKey {
  enum class Range {
    positive,      ///< > 0
    not_negative,  ///< ≥ 0
    restitution    ///< (0, 1]
  };
  enum class Need {
    required,
    one_of  ///< exactly one of all keys so marked
  };
  std::string_view name;  ///< as in a case, e.g. "stiffness"
  Range range = Range::positive;
  Need need = Need::required;
  bool axial = false;  ///< a stiffness [force/length], which stiffness = "axial" takes from the floor beams (3-4)
};

/// A choice by word, e.g. release = "zero-force". The first word is the default.
struct LawChoice {
  std::string_view name;
  std::vector<std::string_view> words;
  std::string_view with;  ///< the key it goes with, e.g. calibration with restitution; empty: always allowed
};

/// calibration = "exact" or "published", for laws that take a restitution.
[[nodiscard]] const LawChoice& exact_or_published();

/// What a case did say, for one contact point.
struct LawInput {
  std::map<std::string, double, std::less<>> numbers;
  std::map<std::string, std::string, std::less<>> words;  ///< choices; the default where one is not given
  double effective_mass = 0;                              ///< m_e = m₁m₂/(m₁ + m₂) of the two floors [mass] > 0

  /// @throws InvalidParameter, naming the key, when it is not given.
  [[nodiscard]] double number(std::string_view key) const;
  /// Nothing when the key is not given.
  [[nodiscard]] std::optional<double> optional_number(std::string_view key) const;
  /// The word chosen, or the default. @throws InvalidParameter, naming the choice and its words, for any other word.
  [[nodiscard]] std::string_view word(const LawChoice& choice) const;
};

/// A law as a case knows it.
struct LawEntry {
  std::string_view name;
  std::vector<LawKey> keys;
  std::vector<LawChoice> choices;
  /// Whoever reads a case sees to it that `input` has these keys and choices and no others.
  /// @throws InvalidParameter, naming the key at fault, when a value is missing, out of range, or does not go with
  /// another.
  std::shared_ptr<const ContactLaw> (*make)(const LawInput& input) = nullptr;
};

/// Every law, in the order of the documentation.
[[nodiscard]] const std::vector<LawEntry>& contact_laws();

/// The law of that name; null when there is none.
[[nodiscard]] const LawEntry* find_law(std::string_view name);

}  // namespace bentur
