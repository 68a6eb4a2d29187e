#include "bentur/model/contact/contact_spec.h"

#include <cmath>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

/// Of the keys that exclude one another exactly one; a key that is required and missing the law itself reports.
void check_one_of(const LawEntry& law, const LawInput& input) {
  std::string names;
  int given = 0;
  for (const Key& key : law.keys) {
    if (key.need == Need::one_of) {
      names += (names.empty() ? "" : ", ") + std::string(key.name);
      given += input.numbers.find(key.name) == input.numbers.end() ? 0 : 1;
    }
  }
  if (!names.empty() && given != 1) {
    throw InvalidParameter("contact", std::to_string(given) + " of " + names, "needs exactly one of them");
  }
}

const LawEntry& entry_of(const ContactSpec& contact) {
  const LawEntry* const entry = find_entry(contact_laws(), contact.law, contact.own);
  if (entry == nullptr) throw InvalidParameter("law", contact.law, "there is no such law");
  return *entry;
}

}  // namespace

std::optional<double> ContactSpec::number(std::string_view key, std::size_t point) const {
  const auto found = numbers.find(key);
  if (found == numbers.end()) {
    return std::nullopt;
  }
  const std::vector<double>& values = found->second;
  if (values.size() != 1 && point >= values.size()) {
    throw InvalidParameter(found->first, std::to_string(values.size()) + " values",
                           "must be one value or one per contact point");
  }
  return values.size() == 1 ? values.front() : values[point];
}

std::map<std::string, std::string, std::less<>> ContactSpec::choices() const {
  std::map<std::string, std::string, std::less<>> result;
  const LawEntry* const entry = find_law(law);
  if (entry == nullptr) {
    return result;
  }
  for (const Key& choice : entry->choices) {
    if (choice.with.empty() || numbers.find(choice.with) != numbers.end()) {
      const auto made = words.find(choice.name);
      result.emplace(choice.name, made == words.end() ? choice.words.front() : std::string_view(made->second));
    }
  }
  return result;
}

double effective_mass(double one, double other) {
  return std::isinf(one) ? other : std::isinf(other) ? one : one * other / (one + other);
}

LawInput contact_input(const ContactSpec& contact, std::size_t point, double effective_mass, double share) {
  const LawEntry& entry = entry_of(contact);
  LawInput input;
  for (const auto& [key, values] : contact.numbers) input.numbers[key] = *contact.number(key, point);
  for (const Key& key : entry.keys) {
    const auto found = input.numbers.find(key.name);
    if (found != input.numbers.end() && key.dimension.force != 0) found->second *= share;
  }
  input.words = contact.words;
  input.effective_mass = share * effective_mass;
  return input;
}

std::shared_ptr<const ContactLaw> make_contact_law(const ContactSpec& contact, const LawInput& input) {
  const LawEntry& entry = entry_of(contact);
  check_one_of(entry, input);
  return entry.make(input);
}

}  // namespace bentur
