#include "bentur/model/gap/code_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

Key soil_factor() {
  return Key::number("soil_factor", dimension::none, Range::positive, {"Soil factor", "Faktor tanah"}, "S");
}

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

/// The word for one building, or where none is given the first that there is.
std::string word_or(const CodeRuleSpec& spec, std::string_view key, std::string_view otherwise,
                    std::size_t building = 0) {
  const auto found = spec.words.find(key);
  return found == spec.words.end() || found->second.empty() ? std::string(otherwise)
                                                            : value_of(spec.words, key, building);
}

double factor(const CodeRuleSpec& spec, std::string_view key, std::size_t building) {
  const double value = value_of(spec.numbers, key, building);
  require_positive(std::string(key), value);
  return value;
}

bool is_set(const CodeRuleSpec& spec, std::string_view flag) {
  const auto found = spec.flags.find(flag);
  return found != spec.flags.end() && found->second;
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
  return {spec.rule, (pair.floors_aligned && is_set(spec, "halved") ? 0.5 : 1) * d.sum(), {}, {}};
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
  const double each = 11 - intensity;                                                // [m]: 5, 4, 3, 2
  const double height = std::min(pair.left.height, pair.right.height) / pair.metre;  // [m]
  const double frame = 0.100 + 0.020 * std::max(0.0, height - 15) / each;
  double width = 0.100;
  for (const std::size_t building : {pair.left_building, pair.left_building + 1}) {
    const std::string& system = value_of(spec.words, "system", building);
    const bool steel = word_or(spec, "material", "concrete", building) == "steel";
    const double part = steel ? 1.5 : (system == "wall" ? 0.5 : (system == "frame-wall" ? 0.7 : 1.0));
    width = std::max(width, part * frame);
  }
  return {spec.rule, width * pair.metre, {}, {}};
}

bool is_simplified(const CodeRuleSpec& spec) { return word_or(spec, "method", "analysis") == "simplified"; }

CodeSeparation ntc2004(const CodePair& pair, const CodeRuleSpec& spec) {  // (7)
  const bool simplified = is_simplified(spec);
  const Amplified d = simplified ? Amplified{} : amplified(pair, spec, "behaviour_factor");
  const std::string& zone = value_of(spec.words, "zone", 0);
  const std::size_t place = zone == "I" ? 0 : (zone == "II" ? 1 : 2);
  const double slope = (simplified ? std::array{0.007, 0.009, 0.012} : std::array{0.001, 0.003, 0.006})[place];
  const double left = std::max(0.050 * pair.metre, d.left + slope * pair.left.level);
  const double right = std::max(0.050 * pair.metre, d.right + slope * pair.right.level);
  const double taller = std::max(pair.left.height, pair.right.height);
  const bool one_height = std::abs(pair.left.height - pair.right.height) <= 1e-6 * taller;
  const bool half = pair.floors_aligned && one_height && is_set(spec, "structures_alike");
  return {spec.rule, (half ? 0.5 : 1) * (left + right), left, right};
}

/// h of (8), (9) [length], not below the base.
double height_at(const CodePair& pair) { return std::max({0.0, pair.left.level, pair.right.level}); }

double ground_of(const CodeRuleSpec& spec) {  // a_g S/g
  return factor(spec, "ground_acceleration", 0) * factor(spec, "soil_factor", 0);
}

CodeSeparation ntc2018(const CodePair& pair, const CodeRuleSpec& spec) {  // (8)
  const double least = height_at(pair) / 100 * std::min(2 * ground_of(spec), 1.0);
  const double left = pair.left.displacement, right = pair.right.displacement;
  return {spec.rule, std::max(left + right, least), {}, {}};
}

std::optional<HeightSeparation> ntc2018_estimated(const CodePair& pair, const CodeRuleSpec& spec) {  // (8)
  CodePair estimated = pair;
  for (CodeSide* side : {&estimated.left, &estimated.right}) {
    side->displacement = std::max(0.0, side->level) / 100 * ground_of(spec);
  }
  return HeightSeparation{ntc2018(estimated, spec)};
}

CodeSeparation peruvian(const CodePair& pair, const CodeRuleSpec& spec, double slope) {  // (9)
  const double left = 2.0 / 3 * pair.left.displacement, right = 2.0 / 3 * pair.right.displacement;
  const double s = std::max({left + right, slope * height_at(pair), 0.030 * pair.metre});
  const double to_left = std::max(left, s / 2), to_right = std::max(right, s / 2);
  return {spec.rule, pair.same_owner ? s : to_left + to_right, to_left, to_right};
}

CodeSeparation e030_2018(const CodePair& pair, const CodeRuleSpec& spec) { return peruvian(pair, spec, 0.006); }

CodeSeparation e030_2026(const CodePair& pair, const CodeRuleSpec& spec) {
  return peruvian(pair, spec, 0.02 * factor(spec, "zone_factor", 0) * factor(spec, "soil_factor", 0));
}

CodeSeparation nsr10(const CodePair& pair, const CodeRuleSpec& spec) {  // (10)
  const std::string& neighbour = value_of(spec.words, "neighbour", 0);
  const auto to_line = [&](const CodeSide& side) {
    const bool coincides = neighbour == "coincides";
    double slope = 0;
    if (side.storeys == 3) slope = coincides ? 0 : 0.01;
    if (side.storeys > 3) slope = coincides ? 0.02 : (neighbour == "differs" ? 0.03 : 0.01);
    return slope * std::max(0.0, side.level);
  };
  const double left = to_line(pair.left), right = to_line(pair.right);
  const double across = neighbour == "none" ? left + right : std::max(left, right);
  return {spec.rule, pair.same_owner ? pair.left.displacement + pair.right.displacement : across, left, right};
}

std::optional<HeightSeparation> nsr10_by_height(const CodePair& pair, const CodeRuleSpec& spec) {
  if (pair.same_owner) return std::nullopt;
  return HeightSeparation{nsr10(pair, spec)};
}

CodeSeparation rpa(const CodePair& pair, const CodeRuleSpec& spec) {  // (11)
  return {spec.rule, std::max(std::hypot(pair.left.displacement, pair.right.displacement), 0.040 * pair.metre), {}, {}};
}

CodeSeparation nec(const CodePair& pair, const CodeRuleSpec& spec) {  // (12)
  const double left = pair.left.displacement, right = pair.right.displacement;
  const double gap = pair.floors_aligned ? std::max(left, right) / 2 : (left + right) / 2;
  return {spec.rule, pair.same_owner ? gap : std::numeric_limits<double>::quiet_NaN(), {}, {}};
}

/// What a rule asks whatever the displacements are: of none at all.
template <CodeSeparation (*Rule)(const CodePair&, const CodeRuleSpec&)>
std::optional<HeightSeparation> at_rest(const CodePair& pair, const CodeRuleSpec& spec) {
  CodePair still = pair;
  still.left.displacement = still.right.displacement = 0;
  return HeightSeparation{Rule(still, spec), true};
}

std::optional<HeightSeparation> gb50011_by_height(const CodePair& pair, const CodeRuleSpec& spec) {
  return HeightSeparation{gb50011(pair, spec)};
}

std::optional<HeightSeparation> ntc2004_by_height(const CodePair& pair, const CodeRuleSpec& spec) {
  return is_simplified(spec) ? HeightSeparation{ntc2004(pair, spec)} : at_rest<ntc2004>(pair, spec);
}

}  // namespace

const std::vector<CodeRule>& code_rules() {
  using Takes = CodeRule::Takes;
  static const std::vector<CodeRule> rules = {
      {"asce-7-16",
       "ASCE 7-16, IBC",
       "12.12.3",
       "checked, C_d/I_e to check",
       "elastic displacement under design forces reduced by R/I_e; C_d/I_e makes it the inelastic one",
       Takes::reduced,
       {deflection_amplification(), importance_factor()},
       asce,
       nullptr,
       "Smaller separations or property line setbacks shall be permitted when justified by rational analyses based on "
       "maximum expected ground motions.",
       "International Building Code, building separations, exception"},
      {"sni-1726-2019",
       "SNI 1726:2019",
       "7.12.3",
       "to check",
       "elastic displacement under design forces reduced by R/I_e; C_d/I_e makes it the inelastic one",
       Takes::reduced,
       {deflection_amplification(), importance_factor()},
       asce},
      {"en-1998-1",
       "EN 1998-1:2004",
       "4.4.2.7",
       "to check",
       "elastic displacement under the design spectrum, reduced by q; q makes it the inelastic one",
       Takes::reduced,
       {behaviour_factor()},
       eurocode},
      {"is-1893-1",
       "IS 1893-1:2016",
       "7.11.3",
       "to check",
       "elastic displacement under design forces reduced by R; R makes it the inelastic one",
       Takes::reduced,
       {response_reduction(), Key::of("halved", Key::Kind::flag, {"Halved", "Dibagi dua"},
                                      "half of the sum where floors are aligned, as editions before 2016 have it")
                                  .by_default(0)},
       is1893},
      {"nbcc",
       "NBCC",
       "4.1.8.14",
       "checked",
       "elastic displacement under forces reduced by R_d R_o/I_E; R_d R_o/I_E makes it the inelastic one",
       Takes::reduced,
       {factor_key("ductility_factor", {"Ductility factor", "Faktor daktilitas"}, "R_d"),
        factor_key("overstrength_factor", {"Overstrength factor", "Faktor kuat lebih"}, "R_o"), importance_factor()},
       nbcc},
      {"tbdy-2018",
       "TBDY 2018",
       "4.9.3",
       "to check",
       "elastic displacement under design forces reduced by R/I; a quarter of R/I (floors aligned) or a half makes it "
       "the gap's",
       Takes::reduced,
       {response_reduction(), importance_factor()},
       tbdy,
       at_rest<tbdy>},
      {"gb-50011-2010",
       "GB 50011-2010",
       "6.1.4",
       "checked; steel, 8.1.4, to check",
       "no displacement: the height alone",
       Takes::height,
       {Key::whole("intensity", 6, 9, {"Intensity", "Intensitas"}, "of the site"),
        Key::choice("system", {"frame", "frame-wall", "wall"}, {"System", "Sistem"}, "of a building")
            .for_each("one per building"),
        Key::choice("material", {"concrete", "steel"}, {"Material", "Bahan"}, "of a building")
            .for_each("one per building")
            .optional("concrete")},
       gb50011,
       gb50011_by_height},
      {"ntc-2004",
       "NTC 2004 (Mexico)",
       "1.10",
       "checked, Q to check",
       "elastic displacement under the design spectrum, reduced by Q; Q makes it the inelastic one",
       Takes::reduced,
       {behaviour_factor().when("method", {"analysis"}),
        Key::choice("zone", {"I", "II", "III"}, {"Zone", "Zona"}, "of the site"),
        Key::of("structures_alike", Key::Kind::flag, {"Structures alike", "Struktur serupa"},
                "whether both structures are alike; half the sum wants equal heights besides")
            .by_default(0),
        Key::choice("method", {"analysis", "simplified"}, {"Method", "Metode"},
                    "by which the buildings are designed; the simplified one takes no displacement")
            .optional("analysis")},
       ntc2004,
       ntc2004_by_height},
      {"ntc-2018",
       "NTC 2018 (Italy)",
       "7.2.1",
       "checked",
       "displacement expected at the life-safety limit state, nothing reduced; without it a hundredth of the height "
       "times a_g S/g",
       Takes::expected,
       {Key::quantity("ground_acceleration", dimension::acceleration, {"Ground acceleration", "Percepatan tanah"},
                      "a_g on rock; a bare number is in g")
            .counted_in("g"),
        soil_factor()},
       ntc2018,
       ntc2018_estimated},
      {"e-030-2018",
       "E.030-2018 (Peru)",
       "art. 33",
       "checked",
       "displacement expected, that is already times 0.75 R or 0.85 R where it was reduced",
       Takes::expected,
       {},
       e030_2018,
       at_rest<e030_2018>},
      {"e-030-2026",
       "E.030-2026 (Peru), draft",
       "art. 52",
       "to check",
       "displacement expected, nothing reduced",
       Takes::expected,
       {Key::number("zone_factor", dimension::none, Range::positive, {"Zone factor", "Faktor zona"}, "Z"),
        soil_factor()},
       e030_2026,
       at_rest<e030_2026>},
      {"nsr-10",
       "NSR-10 (Colombia)",
       "A.6.5",
       "checked",
       "of one construction the displacement expected, nothing reduced; to a property line the height alone",
       Takes::expected,
       {Key::choice(
           "neighbour", {"coincides", "differs", "none"}, {"Neighbour", "Tetangga"},
           "whether floors of one that leaves no separation coincide or differ; \"none\": there is none, or it "
           "leaves its own")},
       nsr10,
       nsr10_by_height},
      {"rpa-2024",
       "RPA 2024 (Algeria)",
       "5.8",
       "checked, number of the clause to check",
       "displacement expected, torsion and rotation of the foundation included, nothing reduced",
       Takes::expected,
       {},
       rpa,
       at_rest<rpa>},
      {"nec-se-ds",
       "NEC-SE-DS (Ecuador)",
       "5.2.1",
       "checked in part",
       "inelastic displacement expected, nothing reduced; buildings of one construction",
       Takes::expected,
       {},
       nec},
  };
  return rules;
}

const CodeRule* find_code_rule(std::string_view name) {
  const auto& rules = code_rules();
  const auto found = std::find_if(rules.begin(), rules.end(), [&](const CodeRule& rule) { return rule.name == name; });
  return found == rules.end() ? nullptr : &*found;
}

namespace {

const CodeRule& checked_rule(const CodePair& pair, const CodeRuleSpec& spec, bool with_displacements) {
  const CodeRule* const rule = find_code_rule(spec.rule);
  if (rule == nullptr) throw InvalidParameter("rule", spec.rule, "there is no such rule");
  require_positive("metre", pair.metre);
  for (const CodeSide* side : {&pair.left, &pair.right}) {
    if (with_displacements) require_not_negative("displacement", side->displacement);
    require_not_negative("height", side->height);
    require_finite("level", side->level);
  }
  return *rule;
}

}  // namespace

bool depends_on_owner(const CodeRuleSpec& spec) {
  constexpr std::string_view rules[] = {"asce-7-16",  "sni-1726-2019", "en-1998-1", "e-030-2018",
                                        "e-030-2026", "nsr-10",        "nec-se-ds"};
  return std::find(std::begin(rules), std::end(rules), spec.rule) != std::end(rules);
}

bool depends_on_alignment(const CodeRuleSpec& spec) {
  return spec.rule == "en-1998-1" || spec.rule == "tbdy-2018" || spec.rule == "nec-se-ds" ||
         (spec.rule == "is-1893-1" && is_set(spec, "halved")) ||
         (spec.rule == "ntc-2004" && is_set(spec, "structures_alike"));
}

CodeSeparation code_separation(const CodePair& pair, const CodeRuleSpec& spec) {
  return checked_rule(pair, spec, true).separation(pair, spec);
}

std::optional<HeightSeparation> height_separation(const CodePair& pair, const CodeRuleSpec& spec) {
  const CodeRule& rule = checked_rule(pair, spec, false);
  return rule.by_height == nullptr ? std::nullopt : rule.by_height(pair, spec);
}

}  // namespace bentur
