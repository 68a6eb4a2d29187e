#include <algorithm>
#include <cmath>
#include <string>

#include "bentur/model/gap/codes/internal/rule_parts.h"

// Formulas: code_rules.h.
namespace bentur::codes {
namespace {

constexpr const char* by_deflection =
    "elastic displacement under design forces reduced by R/I_e, at the edge, torsion included; C_d/I_e makes it the "
    "inelastic one";

CodeSeparation asce(const CodePair& pair, const CodeRuleSpec& spec) {  // (1)
  const Amplified d = amplified(pair, spec, "deflection_amplification", "importance_factor");
  return {spec.rule, pair.is_of_one_owner() ? d.srss() : d.sum(), d.left, d.right};
}

CodeSeparation eurocode(const CodePair& pair, const CodeRuleSpec& spec) {  // (2)
  const Amplified d = amplified(pair, spec, "behaviour_factor");
  const double alignment = pair.floors_aligned ? 0.7 : 1;
  const double gap = pair.is_of_one_owner() ? d.srss() : d.sum();
  return {spec.rule, alignment * gap, alignment * d.left, alignment * d.right};
}

CodeSeparation is1893(const CodePair& pair, const CodeRuleSpec& spec) {  // (3)
  if (pair.floors_aligned) {
    return {spec.rule, (is_set(spec, "halved") ? 0.5 : 1) * amplified(pair, spec, "response_reduction").sum(), {}, {}};
  }
  const double larger = std::max(factor(spec, "response_reduction", pair.left_building),
                                 factor(spec, "response_reduction", pair.right_building));
  return {spec.rule, larger * (pair.left.displacement + pair.right.displacement), {}, {}};
}

CodeSeparation nbcc(const CodePair& pair, const CodeRuleSpec& spec) {  // (4)
  Amplified d = amplified(pair, spec, "ductility_factor", "importance_factor");
  d.left *= factor(spec, "overstrength_factor", pair.left_building);
  d.right *= factor(spec, "overstrength_factor", pair.right_building);
  return {spec.rule, d.srss(), {}, {}};
}

CodeSeparation tbdy(const CodePair& pair, const CodeRuleSpec& spec) {  // (5)
  const Amplified d = amplified(pair, spec, "response_reduction", "importance_factor");
  const double least = (0.030 + 0.010 * begun_steps(lower_height(pair), 6, 3)) * pair.metre;
  return {spec.rule, std::max(least, (pair.floors_aligned ? 0.25 : 0.5) * d.srss()), {}, {}};
}

bool is_simplified(const CodeRuleSpec& spec) { return word_or(spec, "method", "analysis") == "simplified"; }

CodeSeparation ntc2004(const CodePair& pair, const CodeRuleSpec& spec) {  // (7)
  const bool simplified = is_simplified(spec);
  const Amplified d = simplified ? Amplified{} : amplified(pair, spec, "behaviour_factor");
  const double slope = by_zone(spec, simplified ? std::array{0.007, 0.009, 0.012} : std::array{0.001, 0.003, 0.006});
  const double left = std::max(0.050 * pair.metre, d.left + slope * pair.left.level);
  const double right = std::max(0.050 * pair.metre, d.right + slope * pair.right.level);
  const double taller = std::max(pair.left.height, pair.right.height);
  const bool one_height = std::abs(pair.left.height - pair.right.height) <= 1e-6 * taller;
  const bool half = pair.floors_aligned && one_height && is_set(spec, "structures_alike");
  return {spec.rule, (half ? 0.5 : 1) * (left + right), left, right};
}

std::optional<HeightSeparation> ntc2004_by_height(const CodePair& pair, const CodeRuleSpec& spec) {
  return is_simplified(spec) ? HeightSeparation{ntc2004(pair, spec)} : at_rest<ntc2004>(pair, spec);
}

CodeSeparation ubc97(const CodePair& pair, const CodeRuleSpec& spec) {  // (13)
  const auto moved = [&](const CodeSide& side, std::size_t building) {
    return std::max(1.0, 0.7 * factor(spec, "response_reduction", building)) * side.displacement;
  };
  const Amplified d{moved(pair.left, pair.left_building), moved(pair.right, pair.right_building)};
  return {spec.rule, pair.is_of_one_owner() ? d.srss() : d.sum(), d.left, d.right};
}

CodeSeparation ntc2020(const CodePair& pair, const CodeRuleSpec& spec) {  // (14)
  const Amplified d = amplified(pair, spec, "behaviour_factor");
  const double slope = is_set(spec, "base_modelled") ? 0 : by_zone(spec, {0, 0.003, 0.006});
  const auto to_line = [&](double moved, const CodeSide& side, std::size_t building) {
    const double expected = factor(spec, "overstrength_factor", building) * moved + slope * std::max(0.0, side.level);
    return std::max(0.050 * pair.metre, expected);
  };
  const double left = to_line(d.left, pair.left, pair.left_building);
  const double right = to_line(d.right, pair.right, pair.right_building);
  return {spec.rule, left + right, left, right};
}

CodeSeparation nch433(const CodePair& pair, const CodeRuleSpec& spec) {  // (15)
  const auto to_line = [&](const CodeSide& side, std::size_t building) {
    const double moved = std::max(1.0, 2.0 / 3 * factor(spec, "response_reduction", building)) * side.displacement;
    return std::max({moved, 0.002 * side.level, 0.015 * pair.metre});
  };
  const double left = to_line(pair.left, pair.left_building), right = to_line(pair.right, pair.right_building);
  return {spec.rule, left + right, left, right};
}

CodeSeparation inpres(const CodePair& pair, const CodeRuleSpec& spec) {  // (17)
  const Amplified d = amplified(pair, spec, "deflection_amplification", "importance_factor");
  const auto to_line = [&](double moved, const CodeSide& side, std::size_t building) {
    const bool is_known = word_or(spec, "displacements", "calculated", building) == "calculated";
    return std::max(is_known ? 1.05 * moved : 0.025 * side.level, 0.025 * pair.metre);
  };
  const double left = to_line(d.left, pair.left, pair.left_building);
  const double right = to_line(d.right, pair.right, pair.right_building);
  return {spec.rule, left + right, left, right};
}

/// Whether its height alone decides.
bool is_low_in_iran(const CodeSide& side, const CodeRuleSpec& spec, std::size_t building) {
  return side.storeys <= 8 && word(spec, "importance", building) == "ordinary";
}

CodeSeparation iran2800(const CodePair& pair, const CodeRuleSpec& spec) {  // (18)
  const Amplified d = amplified(pair, spec, "deflection_amplification");
  const bool left_low = is_low_in_iran(pair.left, spec, pair.left_building);
  const bool right_low = is_low_in_iran(pair.right, spec, pair.right_building);
  const double left = left_low ? 0.005 * std::max(0.0, pair.left.level) : d.left;
  const double right = right_low ? 0.005 * std::max(0.0, pair.right.level) : d.right;
  const bool combines = pair.is_of_one_owner() && !left_low && !right_low;
  return {spec.rule, combines ? d.srss() : left + right, left, right};
}

std::optional<HeightSeparation> iran2800_by_height(const CodePair& pair, const CodeRuleSpec& spec) {
  const bool alone =
      is_low_in_iran(pair.left, spec, pair.left_building) && is_low_in_iran(pair.right, spec, pair.right_building);
  return alone ? HeightSeparation{iran2800(pair, spec)} : at_rest<iran2800>(pair, spec);
}

CodeSeparation ufc(const CodePair& pair, const CodeRuleSpec& spec) {  // (19)
  const double inch = 0.0254 * pair.metre, feet = 12 * inch;
  const double level = std::max({0.0, pair.left.level, pair.right.level});
  const double alone = (1 + 0.5 * begun_steps(level, 20 * feet, 10 * feet)) * inch;
  return {spec.rule, std::max(alone, pair.left.displacement + pair.right.displacement), {}, {}};
}

}  // namespace

std::vector<CodeRule> amplifying_rules() {
  constexpr auto takes = CodeRule::Takes::reduced;
  constexpr const char* design = "design earthquake";
  return {
      {.name = "asce-7-16",
       .title = "ASCE 7-16, IBC",
       .clause = "12.12.3",
       .wording = "read in the 2010 edition",
       .assumes = by_deflection,
       .motion = design,
       .takes = takes,
       .keys = {deflection_amplification(), importance_factor()},
       .separation = asce,
       .owner = CodeRule::Owner::not_at_public_way,
       .quotation = "Smaller separations or property line setbacks shall be permitted when justified by rational "
                    "analyses based on maximum expected ground motions.",
       .quoted_from = "International Building Code, building separations, exception"},
      {.name = "sni-1726-2019",
       .title = "SNI 1726:2019",
       .clause = "7.12.3",
       .wording = "by memory, to check",
       .assumes = by_deflection,
       .motion = design,
       .takes = takes,
       .keys = {deflection_amplification(), importance_factor()},
       .separation = asce,
       .owner = CodeRule::Owner::not_at_public_way},
      {.name = "ubc-97",
       .title = "UBC-97, NSCP 2015",
       .clause = "1633.2.11, 208.5.3.6",
       .wording = "second hand, to check",
       .assumes = "elastic displacement under design forces reduced by R; 0.7 R makes it the inelastic one",
       .motion = design,
       .takes = takes,
       .keys = {response_reduction()},
       .separation = ubc97,
       .owner = CodeRule::Owner::not_at_public_way},
      {.name = "en-1998-1",
       .title = "EN 1998-1:2004",
       .clause = "4.4.2.7",
       .wording = "second hand, to check",
       .assumes = "elastic displacement under the design spectrum, reduced by q; q makes it the inelastic one",
       .motion = design,
       .takes = takes,
       .keys = {behaviour_factor()},
       .separation = eurocode,
       .owner = CodeRule::Owner::decides},
      {.name = "is-1893-1",
       .title = "IS 1893-1:2016",
       .clause = "7.11.3",
       .wording = "by memory, to check",
       .assumes = "elastic displacement under design forces reduced by R; R makes it the inelastic one",
       .motion = design,
       .takes = takes,
       .keys = {response_reduction(), Key::of("halved", Key::Kind::flag, {"Halved", "Dibagi dua"},
                                              "half of the sum where floors are aligned, as the 2002 edition has it")
                                          .by_default(0)},
       .separation = is1893},
      {.name = "nbcc",
       .title = "NBCC",
       .clause = "4.1.8.14",
       .wording = "read",
       .assumes = "elastic displacement under forces reduced by R_d R_o/I_E; R_d R_o/I_E makes it the inelastic one",
       .motion = design,
       .takes = takes,
       .keys = {factor_key("ductility_factor", {"Ductility factor", "Faktor daktilitas"}, "R_d"),
                overstrength_factor("R_o"), importance_factor()},
       .separation = nbcc},
      {.name = "tbdy-2018",
       .title = "TBDY 2018",
       .clause = "4.9.3",
       .wording = "second hand, to check",
       .assumes =
           "elastic displacement under design forces reduced by R/I; a quarter of R/I (floors aligned) or a half "
           "makes it the gap's",
       .motion = design,
       .takes = takes,
       .keys = {response_reduction(), importance_factor()},
       .separation = tbdy,
       .by_height = at_rest<tbdy>},
      {.name = "ntc-2004",
       .title = "NTC 2004 (Mexico)",
       .clause = "1.10",
       .wording = "read; Q to check",
       .assumes = "elastic displacement under the design spectrum, reduced by Q; Q makes it the inelastic one",
       .motion = design,
       .takes = takes,
       .keys = {behaviour_factor().when("method", {"analysis"}), mexican_zone(),
                Key::of("structures_alike", Key::Kind::flag, {"Structures alike", "Struktur serupa"},
                        "whether both structures are alike; half the sum wants equal heights besides")
                    .by_default(0),
                Key::choice("method", {"analysis", "simplified"}, {"Method", "Metode"},
                            "by which the buildings are designed; the simplified one takes no displacement")
                    .optional("analysis")},
       .separation = ntc2004,
       .by_height = ntc2004_by_height},
      {.name = "ntc-2020",
       .title = "NTC-Sismo 2020 (Mexico)",
       .clause = "1.9, 1.8",
       .wording = "second hand, to check",
       .assumes = "elastic displacement under design forces reduced by Q′ R; Q R, not Q′ R, makes it the inelastic one",
       .motion = "collapse prevention",
       .takes = takes,
       .keys = {behaviour_factor(), overstrength_factor("R"), mexican_zone(),
                Key::of("base_modelled", Key::Kind::flag, {"Base modelled", "Dasar dimodelkan"},
                        "whether u has the rotation and the shift of the base in it; else a share of the height is "
                        "added in zones II and III")
                    .by_default(0)},
       .separation = ntc2020,
       .by_height = at_rest<ntc2020>},
      {.name = "inpres-cirsoc-103",
       .title = "INPRES-CIRSOC 103-I",
       .clause = "8.4.5.3",
       .wording = "read",
       .assumes = "elastic displacement under design forces at the edge of the floor, torsion included; C_d/γ_r makes "
                  "it the inelastic one",
       .motion = design,
       .takes = takes,
       .keys = {deflection_amplification(), importance_factor(),
                Key::choice("displacements", {"calculated", "unknown"}, {"Displacements", "Perpindahan"},
                            "of a building; `\"unknown\"`: an existing one that is not computed, for which 0.025 h "
                            "stands in their place")
                    .for_each("one per building")
                    .optional("calculated")},
       .separation = inpres,
       .by_height = at_rest<inpres>},
      {.name = "nch-433",
       .title = "NCh 433 (Chile)",
       .clause = "5.10",
       .wording = "second hand, to check",
       .assumes = "elastic displacement under design forces reduced by R*; 2R*/3 makes it the one expected",
       .motion = design,
       .takes = takes,
       .keys = {response_reduction()},
       .separation = nch433,
       .by_height = at_rest<nch433>},
      {.name = "iran-2800",
       .title = "2800 (Iran), 4th edition",
       .clause = "part 1",
       .wording = "second hand, to check",
       .assumes = "up to 8 storeys of ordinary importance the height alone; else elastic displacement under reduced "
                  "design forces, P-Δ included, which C_d makes the inelastic one",
       .motion = design,
       .takes = takes,
       .keys = {deflection_amplification(), Key::choice("importance", {"ordinary", "high"}, {"Importance", "Keutamaan"},
                                                        "of a building; `\"high\"`: high or very high")
                                                .for_each("one per building")},
       .separation = iran2800,
       .by_height = iran2800_by_height,
       .owner = CodeRule::Owner::not_at_public_way},
      {.name = "ufc-3-310-03a",
       .title = "UFC 3-310-03A",
       .clause = "Separation",
       .wording = "second hand, to check",
       .assumes =
           "the height alone of low and rigid buildings; of others the sum of displacements under the prescribed "
           "forces, rotation of the base included, if that is more",
       .motion = design,
       .takes = takes,
       .keys = {},
       .separation = ufc,
       .by_height = at_rest<ufc>},
  };
}

}  // namespace bentur::codes
