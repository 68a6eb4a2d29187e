#include "bentur/elements/law_entry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bentur/core/errors.h"

namespace bentur {

std::optional<double> LawInput::optional_number(std::string_view key) const {
  const auto found = numbers.find(key);
  return found == numbers.end() ? std::nullopt : std::optional<double>(found->second);
}

double LawInput::number(std::string_view key) const {
  if (const auto given = optional_number(key)) return *given;
  throw InvalidParameter(std::string(key), "nothing", "must be given");
}

std::string_view LawInput::word(const Key& choice) const {
  const auto found = words.find(choice.name);
  if (found == words.end()) return choice.words.front();
  const auto& known = choice.words;
  if (std::find(known.begin(), known.end(), found->second) != known.end()) return found->second;
  throw InvalidParameter(std::string(choice.name), fmt::format("\"{}\"", found->second),
                         fmt::format("must be one of {}", fmt::join(known, ", ")));
}

}  // namespace bentur
