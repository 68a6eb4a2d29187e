#include "bentur/model/gap/code_rules.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"

namespace bentur {
namespace {

Key factor_key(std::string_view name, Label label, std::string_view doc) {
  return Key::number(name, dimension::none, Range::positive, label, doc).for_each("one per building");
}

Key deflection_amplification() {
  return factor_key("deflection_amplification", {"Deflection amplification", "Pembesaran defleksi"}, "C_d");
}

Key importance_factor() { return factor_key("importance_factor", {"Importance factor", "Faktor keutamaan"}, "I"); }

Key behaviour_factor() { return factor_key("behaviour_factor", {"Behaviour factor", "Faktor perilaku"}, "q, Q"); }

Key response_reduction() { return factor_key("response_reduction", {"Response reduction", "Reduksi respons"}, "R"); }

/// The value for one building of a list with one for all or one each.
template <class Value>
const Value& value_of(const std::map<std::string, std::vector<Value>, std::less<>>& values, std::string_view key,
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

double factor(const CodeRuleSpec& spec, std::string_view key, std::size_t building) {
  const double value = value_of(spec.numbers, key, building);
  require_positive(std::string(key), value);
  return value;
}

/// Own displacements, amplified.
struct Amplified {
  double left = 0, right = 0;
  [[nodiscard]] double sum() const { return left + right; }
  [[nodiscard]] double srss() const { return std::hypot(left, right); }
};

/// Displacements times the first key over the second, where there is one.
Amplified amplified(const CodePair& pair, const CodeRuleSpec& spec, std::string_view times,
                    std::string_view over = {}) {
  const auto own = [&](const CodeSide& side, std::size_t building) {
    return side.displacement * factor(spec, times, building) / (over.empty() ? 1 : factor(spec, over, building));
  };
  return {own(pair.left, pair.left_building), own(pair.right, pair.left_building + 1)};
}

CodeSeparation asce(const CodePair& pair, const CodeRuleSpec& spec) {  // (1)
  const Amplified d = amplified(pair, spec, "deflection_amplification", "importance_factor");
  return {spec.rule, pair.same_owner ? d.srss() : d.sum(), d.left, d.right};
}

CodeSeparation eurocode(const CodePair& pair, const CodeRuleSpec& spec) {  // (2)
  const Amplified d = amplified(pair, spec, "behaviour_factor");
  const double alignment = pair.floors_aligned ? 0.7 : 1;
  return {spec.rule, alignment * (pair.same_owner ? d.srss() : d.sum()), alignment * d.left, alignment * d.right};
}

CodeSeparation is1893(const CodePair& pair, const CodeRuleSpec& spec) {  // (3)
  const Amplified d = amplified(pair, spec, "response_reduction");
  return {spec.rule, (pair.floors_aligned ? 0.5 : 1) * d.sum(), {}, {}};
}

CodeSeparation nbcc(const CodePair& pair, const CodeRuleSpec& spec) {  // (4)
  Amplified d = amplified(pair, spec, "ductility_factor", "importance_factor");
  d.left *= factor(spec, "overstrength_factor", pair.left_building);
  d.right *= factor(spec, "overstrength_factor", pair.left_building + 1);
  return {spec.rule, d.srss(), {}, {}};
}

CodeSeparation tbdy(const CodePair& pair, const CodeRuleSpec& spec) {  // (5)
  const Amplified d = amplified(pair, spec, "response_reduction", "importance_factor");
  const double height = std::min(pair.left.height, pair.right.height) / pair.metre;  // [m]
  const double least = (0.030 + 0.010 * std::max(0.0, height - 6) / 3) * pair.metre;
  return {spec.rule, std::max(least, (pair.floors_aligned ? 0.25 : 0.5) * d.srss()), {}, {}};
}

CodeSeparation gb50011(const CodePair& pair, const CodeRuleSpec& spec) {  // (6)
  const double intensity = value_of(spec.numbers, "intensity", 0);
  if (!(intensity >= 6 && intensity <= 9) || intensity != std::floor(intensity)) {
    throw InvalidParameter("intensity", std::to_string(intensity), "must be 6, 7, 8 or 9");
  }
  const double each = 11 - intensity;  // [m]: 5, 4, 3, 2
  double part = 0;
  for (const std::size_t building : {pair.left_building, pair.left_building + 1}) {
    const std::string& system = value_of(spec.words, "system", building);
    part = std::max(part, system == "wall" ? 0.5 : (system == "frame-wall" ? 0.7 : 1.0));
  }
  const double height = std::min(pair.left.height, pair.right.height) / pair.metre;  // [m]
  const double width = part * (0.100 + 0.020 * std::max(0.0, height - 15) / each);
  return {spec.rule, std::max(0.100, width) * pair.metre, {}, {}};
}

CodeSeparation ntc(const CodePair& pair, const CodeRuleSpec& spec) {  // (7)
  const Amplified d = amplified(pair, spec, "behaviour_factor");
  const std::string& zone = value_of(spec.words, "zone", 0);
  const double slope = zone == "I" ? 0.001 : (zone == "II" ? 0.003 : 0.006);
  const double left = std::max(0.050 * pair.metre, d.left + slope * pair.left.level);
  const double right = std::max(0.050 * pair.metre, d.right + slope * pair.right.level);
  const auto alike = spec.flags.find("structures_alike");
  const bool half = pair.floors_aligned && alike != spec.flags.end() && alike->second;
  return {spec.rule, (half ? 0.5 : 1) * (left + right), left, right};
}

}  // namespace

const std::vector<CodeRule>& code_rules() {
  static const std::vector<CodeRule> rules = {
      {"asce-7-16",
       "ASCE 7-16, IBC",
       "12.12.3",
       "checked, C_d/I_e to check",
       "elastic displacement under design forces reduced by R/I_e; C_d/I_e makes it the inelastic one",
       {deflection_amplification(), importance_factor()},
       asce},
      {"sni-1726-2019",
       "SNI 1726:2019",
       "7.12.3",
       "to check",
       "elastic displacement under design forces reduced by R/I_e; C_d/I_e makes it the inelastic one",
       {deflection_amplification(), importance_factor()},
       asce},
      {"en-1998-1",
       "EN 1998-1:2004",
       "4.4.2.7",
       "to check",
       "elastic displacement under the design spectrum, reduced by q; q makes it the inelastic one",
       {behaviour_factor()},
       eurocode},
      {"is-1893-1",
       "IS 1893-1:2016",
       "7.11.3",
       "to check",
       "elastic displacement under design forces reduced by R; R makes it the inelastic one",
       {response_reduction()},
       is1893},
      {"nbcc",
       "NBCC",
       "4.1.8.14",
       "checked",
       "elastic displacement under forces reduced by R_d R_o/I_E; R_d R_o/I_E makes it the inelastic one",
       {factor_key("ductility_factor", {"Ductility factor", "Faktor daktilitas"}, "R_d"),
        factor_key("overstrength_factor", {"Overstrength factor", "Faktor kuat lebih"}, "R_o"), importance_factor()},
       nbcc},
      {"tbdy-2018",
       "TBDY 2018",
       "4.9.3",
       "to check",
       "elastic displacement under design forces reduced by R/I; a quarter of R/I (floors aligned) or a half makes it "
       "the gap's",
       {response_reduction(), importance_factor()},
       tbdy},
      {"gb-50011-2010",
       "GB 50011-2010",
       "6.1.4",
       "checked",
       "no displacement: the height alone",
       {Key::whole("intensity", 6, 9, {"Intensity", "Intensitas"}, "of the site"),
        Key::choice("system", {"frame", "frame-wall", "wall"}, {"System", "Sistem"}, "of a building")
            .for_each("one per building")},
       gb50011},
      {"ntc-2004",
       "NTC 2004 (Mexico)",
       "1.10",
       "checked, Q to check",
       "elastic displacement under the design spectrum, reduced by Q; Q makes it the inelastic one",
       {behaviour_factor(), Key::choice("zone", {"I", "II", "III"}, {"Zone", "Zona"}, "of the site"),
        Key::of("structures_alike", Key::Kind::flag, {"Structures alike", "Struktur serupa"},
                "whether both structures are alike")
            .by_default(0)},
       ntc},
  };
  return rules;
}

const CodeRule* find_code_rule(std::string_view name) {
  const auto& rules = code_rules();
  const auto found = std::find_if(rules.begin(), rules.end(), [&](const CodeRule& rule) { return rule.name == name; });
  return found == rules.end() ? nullptr : &*found;
}

CodeSeparation code_separation(const CodePair& pair, const CodeRuleSpec& spec) {
  const CodeRule* const rule = find_code_rule(spec.rule);
  if (rule == nullptr) throw InvalidParameter("rule", spec.rule, "there is no such rule");
  require_positive("metre", pair.metre);
  for (const CodeSide* side : {&pair.left, &pair.right}) {
    require_not_negative("displacement", side->displacement);
    require_not_negative("height", side->height);
    require_finite("level", side->level);
  }
  return rule->separation(pair, spec);
}

}  // namespace bentur
