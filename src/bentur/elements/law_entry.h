#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/core/key.h"
#include "bentur/elements/law.h"

namespace bentur {

/// What a case did say of a law, for one point.
struct LawInput {
  std::map<std::string, double, std::less<>> numbers;
  std::map<std::string, std::string, std::less<>> words = {};  ///< choices; the default where one is not given
  double effective_mass = 0;  ///< of a contact m_e = m₁m₂/(m₁ + m₂) of the two floors [mass] > 0
  double weight = 0;          ///< of bearings: all that they carry [force] > 0

  /// @throws InvalidParameter, naming the key, when it is not given.
  [[nodiscard]] double number(std::string_view key) const;
  /// Nothing when the key is not given.
  [[nodiscard]] std::optional<double> optional_number(std::string_view key) const;
  /// The word chosen, or the default. @throws InvalidParameter, naming the choice and its words, for any other word.
  [[nodiscard]] std::string_view word(const Key& choice) const;
};

/// A law as a case knows it: all that readers, documents, editors and Python need of it.
template <class Made>
struct LawEntryOf {
  std::string_view name;     ///< as in a case
  std::string_view doc;      ///< its force, as documents say it
  std::vector<Key> keys;     ///< its numbers
  std::vector<Key> choices;  ///< by word; the first word is the default
  /// Whoever reads a case sees to it that `input` has these keys and choices and no others.
  /// @throws InvalidParameter, naming the key at fault, when a value is missing, out of range, or does not go with
  /// another.
  std::function<std::shared_ptr<const Made>(const LawInput& input)> make = {};
  Label label = {};  ///< empty: its name will do
};

/// The law of that name; null when there is none.
template <class Made>
[[nodiscard]] const LawEntryOf<Made>* find_entry(const std::vector<LawEntryOf<Made>>& laws, std::string_view name) {
  const auto found = std::find_if(laws.begin(), laws.end(), [&](const auto& law) { return law.name == name; });
  return found == laws.end() ? nullptr : &*found;
}

/// The same, but `own`, which the caller has brought along, where there is one.
template <class Made>
[[nodiscard]] const LawEntryOf<Made>* find_entry(const std::vector<LawEntryOf<Made>>& laws, std::string_view name,
                                                 const std::shared_ptr<const LawEntryOf<Made>>& own) {
  return own ? own.get() : find_entry(laws, name);
}

/// Adds to the keys of a table those of all laws that `by` chooses from, and that choice itself before them.
template <class Made>
void add_laws(const std::vector<LawEntryOf<Made>>& laws, Key by, std::vector<Key>& keys) {
  for (const auto& law : laws) {
    by.words.push_back(law.name);
    by.word_docs.push_back(law.doc);
    by.word_labels.push_back(law.label);
  }
  keys.push_back(by);
  for (const auto& law : laws) {
    for (const auto* own : {&law.keys, &law.choices}) {
      for (Key key : *own) keys.push_back(key.when(by.name, {law.name}));
    }
  }
}

}  // namespace bentur
