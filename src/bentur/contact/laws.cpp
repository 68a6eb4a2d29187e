#include "bentur/contact/laws.h"

#include <fmt/format.h>

#include <algorithm>

#include "bentur/contact/laws/bilinear.h"
#include "bentur/contact/laws/darmawan.h"
#include "bentur/contact/laws/hertz.h"
#include "bentur/contact/laws/hertz_damp.h"
#include "bentur/contact/laws/jankowski.h"
#include "bentur/contact/laws/kelvin_voigt.h"
#include "bentur/contact/laws/kelvin_voigt_approach.h"
#include "bentur/contact/laws/linear.h"
#include "bentur/contact/laws/restitution.h"
#include "bentur/core/errors.h"

namespace bentur {

const LawChoice& exact_or_published() {
  static const LawChoice choice = {"calibration", {"exact", "published"}, "restitution"};
  return choice;
}

const std::vector<LawEntry>& contact_laws() {
  static const std::vector<LawEntry> laws = {
      Linear::entry(),    KelvinVoigt::entry(), KelvinVoigtApproach::entry(),
      Darmawan::entry(),  Hertz::entry(),       HertzDamp::entry(),
      Jankowski::entry(), Bilinear::entry(),    Restitution::entry(),
  };
  return laws;
}

const LawEntry* find_law(std::string_view name) {
  const auto& laws = contact_laws();
  const auto found = std::find_if(laws.begin(), laws.end(), [&](const LawEntry& law) { return law.name == name; });
  return found == laws.end() ? nullptr : &*found;
}

std::optional<double> LawInput::optional_number(std::string_view key) const {
  const auto found = numbers.find(key);
  return found == numbers.end() ? std::nullopt : std::optional<double>(found->second);
}

double LawInput::number(std::string_view key) const {
  if (const auto given = optional_number(key)) return *given;
  throw InvalidParameter(std::string(key), "nothing", "must be given");
}

std::string_view LawInput::word(const LawChoice& choice) const {
  const auto found = words.find(choice.name);
  if (found == words.end()) return choice.words.front();
  const auto& known = choice.words;
  if (std::find(known.begin(), known.end(), found->second) != known.end()) return found->second;
  throw InvalidParameter(std::string(choice.name), fmt::format("\"{}\"", found->second),
                         fmt::format("must be one of {}", fmt::join(known, ", ")));
}

}  // namespace bentur
