#include <algorithm>
#include <cmath>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/core/not_known.h"
#include "bentur/model/gap/codes/internal/rule_parts.h"

// Formulas: code_rules.h.
namespace bentur::codes {
namespace {

CodeSeparation gb50011(const CodePair& pair, const CodeRuleSpec& spec) {  // (6)
  const double intensity = factor(spec, "intensity");
  if (!(intensity >= 6 && intensity <= 9) || intensity != std::floor(intensity)) {
    throw InvalidParameter("intensity", std::to_string(intensity), "must be 6, 7, 8 or 9");
  }
  const double each = 11 - intensity;  // [m]: 5, 4, 3, 2
  const double frame = 0.100 + 0.020 * std::max(0.0, lower_height(pair) - 15) / each;
  double width = 0.100;
  for (const std::size_t building : {pair.left_building, pair.right_building}) {
    const std::string& system = word(spec, "system", building);
    const bool steel = word_or(spec, "material", "concrete", building) == "steel";
    const double part = steel ? 1.5 : (system == "wall" ? 0.5 : (system == "frame-wall" ? 0.7 : 1.0));
    width = std::max(width, part * frame);
  }
  return {spec.rule, width * pair.metre, {}, {}};
}

std::optional<HeightSeparation> gb50011_by_height(const CodePair& pair, const CodeRuleSpec& spec) {
  return HeightSeparation{gb50011(pair, spec)};
}

/// h of (8), (9) [length], not below the base.
double height_at(const CodePair& pair) { return std::max({0.0, pair.left.level, pair.right.level}); }

double ground_of(const CodeRuleSpec& spec) {  // a_g S/g
  return factor(spec, "ground_acceleration") * factor(spec, "soil_factor");
}

CodeSeparation ntc2018(const CodePair& pair, const CodeRuleSpec& spec) {  // (8)
  const double least = height_at(pair) / 100 * std::min(2 * ground_of(spec), 1.0);
  const double left = pair.left.displacement, right = pair.right.displacement;
  return {spec.rule, std::max(left + right, least), {}, {}};
}

std::optional<HeightSeparation> ntc2018_estimated(const CodePair& pair, const CodeRuleSpec& spec) {  // (8)
  CodePair estimated = pair;
  bool may_be = true;
  for (CodeSide* side : {&estimated.left, &estimated.right}) {
    side->displacement = side->height / 100 * ground_of(spec);
    may_be = may_be && !side->is_isolated;
  }
  return may_be ? HeightSeparation{ntc2018(estimated, spec)} : at_rest<ntc2018>(pair, spec);
}

CodeSeparation peruvian(const CodePair& pair, const CodeRuleSpec& spec, double slope) {  // (9)
  const double left = 2.0 / 3 * pair.left.displacement, right = 2.0 / 3 * pair.right.displacement;
  const double s = std::max({left + right, slope * height_at(pair), 0.030 * pair.metre});
  const double to_left = std::max(left, s / 2), to_right = std::max(right, s / 2);
  return {spec.rule, pair.is_of_one_owner() ? s : to_left + to_right, to_left, to_right};
}

CodeSeparation e030_2018(const CodePair& pair, const CodeRuleSpec& spec) { return peruvian(pair, spec, 0.006); }

CodeSeparation e030_2026(const CodePair& pair, const CodeRuleSpec& spec) {
  return peruvian(pair, spec, 0.02 * factor(spec, "zone_factor") * factor(spec, "soil_factor"));
}

CodeSeparation nsr10(const CodePair& pair, const CodeRuleSpec& spec) {  // (10)
  const std::string& neighbour = word(spec, "neighbour");
  const auto to_line = [&](const CodeSide& side) {
    const bool coincides = neighbour == "coincides";
    double slope = 0;
    if (side.storeys == 3) slope = coincides ? 0 : 0.01;
    if (side.storeys > 3) slope = coincides ? 0.02 : (neighbour == "differs" ? 0.03 : 0.01);
    return slope * std::max(0.0, side.level);
  };
  const double left = to_line(pair.left), right = to_line(pair.right);
  const double across = neighbour == "none" ? left + right : std::max(left, right);
  const double sum = pair.left.displacement + pair.right.displacement;
  return {spec.rule, pair.is_of_one_owner() ? sum : across, left, right};
}

std::optional<HeightSeparation> nsr10_by_height(const CodePair& pair, const CodeRuleSpec& spec) {
  if (pair.is_of_one_owner()) return std::nullopt;
  return HeightSeparation{nsr10(pair, spec)};
}

CodeSeparation rpa(const CodePair& pair, const CodeRuleSpec& spec) {  // (11)
  return {spec.rule, std::max(std::hypot(pair.left.displacement, pair.right.displacement), 0.040 * pair.metre), {}, {}};
}

CodeSeparation nec(const CodePair& pair, const CodeRuleSpec& spec) {  // (12)
  const double left = pair.left.displacement, right = pair.right.displacement;
  const double gap = pair.floors_aligned ? std::max(left, right) / 2 : (left + right) / 2;
  return {spec.rule, pair.is_of_one_owner() ? gap : not_known, {}, {}};
}

CodeSeparation nch2369(const CodePair& pair, const CodeRuleSpec& spec) {  // (16)
  const bool is_critical = word(spec, "importance") == "critical", together = is_set(spec, "both_in_one_model");
  const double kappa = together ? (is_critical ? 1.2 : 1.0) : (is_critical ? 1.5 : 1.2);
  return {spec.rule, kappa * std::hypot(pair.left.displacement, pair.right.displacement), {}, {}};
}

}  // namespace

std::vector<CodeRule> expecting_rules() {
  constexpr auto takes = CodeRule::Takes::expected;
  constexpr const char* design = "design earthquake";
  return {
      {.name = "gb-50011-2010",
       .title = "GB 50011-2010",
       .clause = "6.1.4",
       .wording = "read; steel second hand, to check",
       .assumes = "no displacement: the height alone",
       .motion = "none: of the intensity of the site",
       .takes = CodeRule::Takes::height,
       .keys = {Key::whole("intensity", 6, 9, {"Intensity", "Intensitas"}, "of the site"),
                Key::choice("system", {"frame", "frame-wall", "wall"}, {"System", "Sistem"}, "of a building")
                    .for_each("one per building"),
                Key::choice("material", {"concrete", "steel"}, {"Material", "Bahan"}, "of a building")
                    .for_each("one per building")
                    .optional("concrete")},
       .separation = gb50011,
       .by_height = gb50011_by_height},
      {.name = "ntc-2018",
       .title = "NTC 2018 (Italy)",
       .clause = "7.2.1",
       .wording = "read",
       .assumes =
           "displacement expected at the life-safety limit state, nothing reduced; without it a hundredth of the "
           "height of the building times a_g S/g, not of an isolated one",
       .motion = "life-safety limit state",
       .takes = takes,
       .keys = {Key::quantity("ground_acceleration", dimension::acceleration,
                              {"Ground acceleration", "Percepatan tanah"}, "a_g on rock; a bare number is in g")
                    .counted_in("g"),
                soil_factor()},
       .separation = ntc2018,
       .by_height = ntc2018_estimated},
      {.name = "e-030-2018",
       .title = "E.030-2018 (Peru)",
       .clause = "art. 33",
       .wording = "read",
       .assumes = "displacement expected, that is already times 0.75 R or 0.85 R where it was reduced",
       .motion = design,
       .takes = takes,
       .keys = {},
       .separation = e030_2018,
       .by_height = at_rest<e030_2018>,
       .owner = CodeRule::Owner::decides},
      {.name = "e-030-2026",
       .title = "E.030-2026 (Peru), draft",
       .clause = "art. 52",
       .wording = "second hand, to check",
       .assumes = "displacement expected, nothing reduced",
       .motion = design,
       .takes = takes,
       .keys = {Key::number("zone_factor", dimension::none, Range::positive, {"Zone factor", "Faktor zona"}, "Z"),
                soil_factor()},
       .separation = e030_2026,
       .by_height = at_rest<e030_2026>,
       .owner = CodeRule::Owner::decides},
      {.name = "nsr-10",
       .title = "NSR-10 (Colombia)",
       .clause = "A.6.5",
       .wording = "read",
       .assumes = "of one construction the displacement expected, torsion and P-Δ included, nothing reduced; to a "
                  "property line "
                  "the height alone",
       .motion = design,
       .takes = takes,
       .keys = {Key::choice("neighbour", {"coincides", "differs", "none"}, {"Neighbour", "Tetangga"},
                            "whether floors of one that leaves no separation coincide or differ; \"none\": there is "
                            "none, or it leaves its own")},
       .separation = nsr10,
       .by_height = nsr10_by_height,
       .owner = CodeRule::Owner::decides},
      {.name = "rpa-2024",
       .title = "RPA 2024 (Algeria)",
       .clause = "5.8",
       .wording = "read",
       .assumes = "displacement expected, torsion and rotation of the foundation included, nothing reduced",
       .motion = design,
       .takes = takes,
       .keys = {},
       .separation = rpa,
       .by_height = at_rest<rpa>},
      {.name = "nec-se-ds",
       .title = "NEC-SE-DS (Ecuador)",
       .clause = "5.2.1",
       .wording = "read in paraphrase",
       .assumes =
           "inelastic displacement expected, that is already times 0.75 R where it was reduced; buildings of one "
           "construction",
       .motion = design,
       .takes = takes,
       .keys = {},
       .separation = nec,
       .owner = CodeRule::Owner::decides},
      {.name = "nch-2369",
       .title = "NCh 2369 (Chile, industry)",
       .clause = "6.2",
       .wording = "second hand, to check",
       .assumes = "displacement under the elastic reference spectrum, corrected for damping and times I, never reduced "
                  "by R",
       .motion = "reference spectrum, times I",
       .takes = takes,
       .keys = {Key::choice("importance", {"ordinary", "critical"}, {"Importance", "Keutamaan"}, "of the plant"),
                Key::of("both_in_one_model", Key::Kind::flag, {"Both in one model", "Keduanya dalam satu model"},
                        "whether displacements are those of time histories of both structures in one model")
                    .by_default(0)},
       .separation = nch2369},
  };
}

}  // namespace bentur::codes
