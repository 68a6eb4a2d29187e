#pragma once

#include <algorithm>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "bentur/contact/laws.h"

namespace bentur::test {

/// A law asked for a restitution.
struct Asked {
  std::string label;
  const LawEntry* law = nullptr;
  std::map<std::string, std::string, std::less<>> words;
};

inline void PrintTo(const Asked& asked, std::ostream* out) { *out << asked.label; }

/// Every law that is given a restitution, in every way that it can be told to let go.
inline std::vector<Asked> laws_with_a_restitution() {
  std::vector<Asked> list;
  for (const LawEntry& law : contact_laws()) {
    const auto is_restitution = [](const Key& key) { return key.name == "restitution"; };
    if (std::none_of(law.keys.begin(), law.keys.end(), is_restitution)) continue;
    std::vector<Asked> of_law = {{std::string(law.name), &law, {}}};
    for (const Key& choice : law.choices) {
      if (choice.with == "restitution") continue;
      of_law.clear();
      for (const auto word : choice.words) {
        const std::string text(word);
        of_law.push_back({std::string(law.name) + "_" + text, &law, {{std::string(choice.name), text}}});
      }
    }
    list.insert(list.end(), of_law.begin(), of_law.end());
  }
  for (Asked& asked : list) std::replace(asked.label.begin(), asked.label.end(), '-', '_');
  return list;
}

}  // namespace bentur::test
