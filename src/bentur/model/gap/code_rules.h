#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/core/key.h"

namespace bentur {

/// What a case gives for one code's rule, key by key.
struct CodeRuleSpec {
  std::string rule;  ///< a name of code_rules()
  /// One value for all buildings or one each, left to right; of keys of the whole site one.
  std::map<std::string, std::vector<double>, std::less<>> numbers = {};
  std::map<std::string, std::vector<std::string>, std::less<>> words = {};
  std::map<std::string, bool, std::less<>> flags = {};  ///< those given; the others are false
};

/// What stands in a gap, as the clauses have it.
enum class Boundary {
  property_line,
  one_owner,  ///< no line
  public_way  ///< a line in common with one, as a street or an alley
};

/// [code] of a case: the rules it gives numbers for, and how the buildings of each gap stand to one another.
struct CodeSpec {
  std::vector<CodeRuleSpec> rules;  ///< in the order of code_rules()
  /// Per gap; nothing: not given, and no rule asks for less because of it.
  std::optional<std::vector<bool>> floors_aligned = {};
  std::optional<std::vector<Boundary>> boundaries = {};  ///< likewise: a property line stands in the gap
  bool is_known = true;  ///< not of results read back without their case, which may have rules

  [[nodiscard]] bool is_aligned(std::size_t gap) const { return floors_aligned && floors_aligned->at(gap); }
  [[nodiscard]] Boundary boundary_at(std::size_t gap) const {
    return boundaries ? boundaries->at(gap) : Boundary::property_line;
  }
};

/// One building at a contact level.
struct CodeSide {
  double displacement = 0;   ///< u [length] ≥ 0, peak at the level: what it is of CodeRule::takes says
  double level = 0;          ///< h [length] of the level above the building's base
  double height = 0;         ///< H [length] of the building above its base
  int storeys = 0;           ///< of the building
  bool is_isolated = false;  ///< it stands on bearings
};

struct CodePair {
  CodeSide left, right;
  std::size_t left_building = 0;                   ///< its place among the buildings
  std::size_t right_building = left_building + 1;  ///< likewise
  bool floors_aligned =
      false;  ///< up to the lower roof every floor of either has a floor of the other at its elevation
  Boundary boundary = Boundary::property_line;
  double metre = 1;  ///< [length], the case's units in one metre

  [[nodiscard]] bool is_of_one_owner() const { return boundary == Boundary::one_owner; }
};

struct CodeSeparation {
  std::string rule;
  double gap = 0;                           ///< between the two buildings [length]; NaN: the rule does not say
  std::optional<double> to_left, to_right;  ///< from the left, right building to a property line [length]
};

/// What a rule asks from heights alone, before anything is computed.
struct HeightSeparation {
  CodeSeparation asked;
  bool is_least = false;  ///< displacements may ask for more
};

/// Separation rules of building codes. With u_A, u_B the peaks at the level:
///
///   asce-7-16, sni-1726-2019   δ_M = C_d u/I_e; √(δ_MA² + δ_MB²), across a property line δ_MA + δ_MB         (1)
///   en-1998-1                  d_s = q u; √(d_sA² + d_sB²), across a property line d_sA + d_sB;
///                              times 0.7 where floors are aligned                                           (2)
///   is-1893-1                  R_A u_A + R_B u_B where floors are aligned, half of it where that is asked for; else
///                              max(R_A, R_B) (u_A + u_B)                                                      (3)
///   nbcc                       δ = R_d R_o u/I_E; √(δ_A² + δ_B²)                                             (4)
///   tbdy-2018                  √((α_A u_A)² + (α_B u_B)²), α = 0.25 R/I where floors are aligned, else 0.5 R/I;
///                              at least 30 mm, and 10 mm more for each begun 3 m above 6 m of the lower one  (5)
///   gb-50011-2010              100 mm, and above 15 m of the lower building 20 mm for each 5, 4, 3, 2 m at
///                              intensity 6, 7, 8, 9; times 0.7 for frame-wall, 0.5 for wall structures, at least
///                              100 mm; of steel 1.5 times the concrete frame's (the one of the two that needs more
///                              decides). Needs no displacement.                                               (6)
///   ntc-2004                   s = max(50 mm, Q u + c h), c = 0.001, 0.003, 0.006 in zone I, II, III; by the
///                              simplified method max(50 mm, c h), c = 0.007, 0.009, 0.012; s_A + s_B, half of it for
///                              alike structures of one height whose floors are aligned                       (7)
///   ntc-2018                   max(u_A + u_B, h/100 · min(2 a_g S/g, 1)); without a calculation, of buildings that are
///                              not isolated, u = H/100 · a_g S/g                                              (8)
///   e-030-2018, e-030-2026     s = max(⅔(u_A + u_B), c h, 30 mm), c = 0.006 or 0.02 Z S; from a property line
///                              max(⅔ u, s/2), and across it the sum of both                                  (9)
///   nsr-10                     u_A + u_B; from a property line c h by storeys: up to 2: c = 0; 3: 0 where floors
///                              coincide, else 0.01; more: 0.02 where they do, 0.03 where not, 0.01 where there is no
///                              neighbour or one that leaves its own. Across the line the larger one; the sum where
///                              both leave their own                                                          (10)
///   rpa-2024                   max(√(u_A² + u_B²), 40 mm)                                                    (11)
///   nec-se-ds                  of one construction (u_A + u_B)/2, where floors are aligned max(u_A, u_B)/2; across a
///                              property line it does not say                                                 (12)
///   ubc-97                     Δ_M = max(0.7 R, 1) u; as (1)                                                  (13)
///   ntc-2020                   s = max(50 mm, Q R u + c h), c = 0, 0.003, 0.006 in zone I, II, III, 0 where u has the
///                              rotation and the shift of the base in it; s_A + s_B                           (14)
///   nch-433                    s = max(max(2R*/3, 1) u, 0.002 h, 15 mm); s_A + s_B                            (15)
///   nch-2369                   κ √(u_A² + u_B²), κ = 1.2, of critical plants 1.5; 1.0 and 1.2 where u are those of
///                              time histories of both in one model                                           (16)
///   inpres-cirsoc-103          s = max(1.05 C_d u/γ_r, 25 mm), of a building that is not computed max(0.025 h, 25 mm);
///                              s_A + s_B                                                                      (17)
///   iran-2800                  s = 0.005 h up to 8 storeys of ordinary importance, else C_d u; s_A + s_B, of one owner
///                              √(s_A² + s_B²) where both are of the second kind                              (18)
///   ufc-3-310-03a              1 in, and ½ in more for each begun 10 ft of h above 20 ft; at least u_A + u_B (19)
///
/// C_d deflection amplification, I_e, I_E, I importance factor, γ_r that of Argentina, q, Q behaviour factor, R, R*
/// response reduction, R_d ductility and R_o, R of (14) overstrength factor, a_g/g, S, Z ground acceleration, soil and
/// zone factor, all [-]; h [length] the level above the base, in (8), (9) and (19) above that of the two from which it
/// is more; H [length] the height of the building. Increments of (6) are in proportion. The amplifiers of (1) to (5),
/// (7), (13) to (15), (17), (18) belong to displacements under a code's reduced design forces: where the ground motion
/// is not reduced they are 1. (8) to (12), (16) take the displacements expected as they are. (1), (13), (18) ask
/// nothing at a line in common with a public way. Clauses, sources and what of their wording was read:
/// docs/separation-rules.md. Invariants (each has a test): a rule gives the same gap in every unit of length; it does
/// not depend on which building stands left; it does not shrink when a displacement or an amplifier grows; what heights
/// alone ask is no more than the rule asks of any displacements, unless the code has a way of its own without them.
struct CodeRule {
  enum class Takes {
    reduced,   ///< u under the design forces, which the rule amplifies
    expected,  ///< u expected in the design earthquake
    height     ///< none
  };
  /// Whether it asks for another gap where a property line stands in it.
  enum class Owner {
    no_matter,
    decides,
    not_at_public_way  ///< it does, and at a line in common with a public way asks nothing
  };
  std::string_view name, title, clause;
  /// How it is known: "read", the clause itself or a whole transcription of it; "second hand", as public texts repeat
  /// it; "by memory". All that was not read says "to check".
  std::string_view wording;
  std::string_view assumes;  ///< which displacement u is, and what the factors make of it
  std::string_view motion;   ///< the level of ground motion that u is of
  Takes takes;
  std::vector<Key> keys;  ///< what it needs to be given; those of buildings: one for all or one each
  CodeSeparation (*separation)(const CodePair&, const CodeRuleSpec&);
  std::optional<HeightSeparation> (*by_height)(const CodePair&, const CodeRuleSpec&) = nullptr;  ///< null: nothing
  Owner owner = Owner::no_matter;
  std::string_view quotation = {}, quoted_from = {};  ///< of its text, where that has to be read with the number
};

[[nodiscard]] const std::vector<CodeRule>& code_rules();
[[nodiscard]] const CodeRule* find_code_rule(std::string_view name);  ///< nullptr: there is none

/// Whether a rule asks for another gap where a property line stands in it, or where floors are aligned.
[[nodiscard]] bool depends_on_owner(const CodeRuleSpec& spec);
[[nodiscard]] bool depends_on_alignment(const CodeRuleSpec& spec);

/// The gap by one rule. @throws InvalidParameter, naming the key, when something that it needs is missing or out of
/// range.
[[nodiscard]] CodeSeparation code_separation(const CodePair& pair, const CodeRuleSpec& spec);
/// What it asks whatever the displacements are, or by its own way without them; nothing where it asks nothing so.
/// @throws InvalidParameter likewise.
[[nodiscard]] std::optional<HeightSeparation> height_separation(const CodePair& pair, const CodeRuleSpec& spec);

}  // namespace bentur
