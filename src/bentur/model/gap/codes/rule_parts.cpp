#include "bentur/model/gap/codes/internal/rule_parts.h"

#include <algorithm>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"

namespace bentur::codes {
namespace {

/// The value for one building of a list with one for all or one each.
template <class Value>
const Value& value_for(const std::map<std::string, std::vector<Value>, std::less<>>& values, std::string_view key,
                       std::size_t building) {
  const auto found = values.find(key);
  if (found == values.end() || found->second.empty()) {
    throw InvalidParameter(std::string(key), "nothing", "is needed by this rule");
  }
  if (found->second.size() != 1 && building >= found->second.size()) {
    throw InvalidParameter(found->first, std::to_string(found->second.size()) + " values",
                           "must be one value or one per building");
  }
  return found->second.size() == 1 ? found->second.front() : found->second[building];
}

}  // namespace

Key factor_key(std::string_view name, Label label, std::string_view doc) {
  return Key::number(name, dimension::none, Range::positive, label, doc).for_each("one per building");
}

Key deflection_amplification() {
  return factor_key("deflection_amplification", {"Deflection amplification", "Pembesaran defleksi"}, "C_d");
}

Key importance_factor() { return factor_key("importance_factor", {"Importance factor", "Faktor keutamaan"}, "I"); }

Key behaviour_factor() { return factor_key("behaviour_factor", {"Behaviour factor", "Faktor perilaku"}, "q, Q"); }

Key response_reduction() { return factor_key("response_reduction", {"Response reduction", "Reduksi respons"}, "R"); }

Key overstrength_factor(std::string_view doc) {
  return factor_key("overstrength_factor", {"Overstrength factor", "Faktor kuat lebih"}, doc);
}

Key soil_factor() {
  return Key::number("soil_factor", dimension::none, Range::positive, {"Soil factor", "Faktor tanah"}, "S");
}

Key mexican_zone() { return Key::choice("zone", {"I", "II", "III"}, {"Zone", "Zona"}, "of the site"); }

double factor(const CodeRuleSpec& spec, std::string_view key, std::size_t building) {
  const double value = value_for(spec.numbers, key, building);
  require_positive(std::string(key), value);
  return value;
}

const std::string& word(const CodeRuleSpec& spec, std::string_view key, std::size_t building) {
  return value_for(spec.words, key, building);
}

std::string word_or(const CodeRuleSpec& spec, std::string_view key, std::string_view otherwise, std::size_t building) {
  const auto found = spec.words.find(key);
  return found == spec.words.end() || found->second.empty() ? std::string(otherwise) : word(spec, key, building);
}

bool is_set(const CodeRuleSpec& spec, std::string_view flag) {
  const auto found = spec.flags.find(flag);
  return found != spec.flags.end() && found->second;
}

double by_zone(const CodeRuleSpec& spec, const std::array<double, 3>& values) {
  const std::string& zone = word(spec, "zone");
  return values[zone == "I" ? 0 : (zone == "II" ? 1 : 2)];
}

Amplified amplified(const CodePair& pair, const CodeRuleSpec& spec, std::string_view times, std::string_view over) {
  const auto own = [&](const CodeSide& side, std::size_t building) {
    return side.displacement * factor(spec, times, building) / (over.empty() ? 1 : factor(spec, over, building));
  };
  return {own(pair.left, pair.left_building), own(pair.right, pair.right_building)};
}

double begun_steps(double height, double from, double each) {
  constexpr double none = 0.01;
  return std::max(0.0, std::ceil((height - from) / each - none));
}

double lower_height(const CodePair& pair) { return std::min(pair.left.height, pair.right.height) / pair.metre; }

}  // namespace bentur::codes
