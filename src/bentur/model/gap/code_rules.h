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

/// [code] of a case: the rules it gives numbers for, and how the buildings of each gap stand to one another.
struct CodeSpec {
  std::vector<CodeRuleSpec> rules;  ///< in the order of code_rules()
  /// Per gap; nothing: not given, and no rule asks for less because of it.
  std::optional<std::vector<bool>> floors_aligned = {};
  std::optional<std::vector<bool>> same_owner = {};  ///< likewise: a property line stands in the gap

  [[nodiscard]] bool is_aligned(std::size_t gap) const { return is_true(floors_aligned, gap); }
  [[nodiscard]] bool is_of_one_owner(std::size_t gap) const { return is_true(same_owner, gap); }

 private:
  static bool is_true(const std::optional<std::vector<bool>>& flags, std::size_t gap) {
    return flags && flags->at(gap);
  }
};

/// One building at a contact level.
struct CodeSide {
  double displacement = 0;  ///< u [length] ≥ 0, peak at the level: what it is of CodeRule::takes says
  double level = 0;         ///< h [length] of the level above the building's base
  double height = 0;        ///< H [length] of the building above its base
  int storeys = 0;          ///< of the building
};

struct CodePair {
  CodeSide left, right;
  std::size_t left_building = 0;  ///< its place in the row; the right one is the next
  bool floors_aligned =
      false;                ///< up to the lower roof every floor of either has a floor of the other at its elevation
  bool same_owner = false;  ///< no property line between them
  double metre = 1;         ///< [length], the case's units in one metre
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
///   is-1893-1                  R_A u_A + R_B u_B, half of it where that is asked for and floors are aligned   (3)
///   nbcc                       δ = R_d R_o u/I_E; √(δ_A² + δ_B²)                                             (4)
///   tbdy-2018                  √((α_A u_A)² + (α_B u_B)²), α = 0.25 R/I where floors are aligned, else 0.5 R/I;
///                              at least 30 mm, and 10 mm more for each 3 m above 6 m of the lower building   (5)
///   gb-50011-2010              100 mm, and above 15 m of the lower building 20 mm for each 5, 4, 3, 2 m at
///                              intensity 6, 7, 8, 9; times 0.7 for frame-wall, 0.5 for wall structures, at least
///                              100 mm; of steel 1.5 times the concrete frame's (the one of the two that needs more
///                              decides). Needs no displacement.                                               (6)
///   ntc-2004                   s = max(50 mm, Q u + c h), c = 0.001, 0.003, 0.006 in zone I, II, III; by the
///                              simplified method max(50 mm, c h), c = 0.007, 0.009, 0.012; s_A + s_B, half of it for
///                              alike structures of one height whose floors are aligned                       (7)
///   ntc-2018                   max(u_A + u_B, h/100 · min(2 a_g S/g, 1)); without a calculation
///                              u = h/100 · a_g S/g                                                            (8)
///   e-030-2018, e-030-2026     s = max(⅔(u_A + u_B), c h, 30 mm), c = 0.006 or 0.02 Z S; from a property line
///                              max(⅔ u, s/2), and across it the sum of both                                  (9)
///   nsr-10                     u_A + u_B; from a property line c h by storeys: up to 2: c = 0; 3: 0 where floors
///                              coincide, else 0.01; more: 0.02 where they do, 0.03 where not, 0.01 where there is no
///                              neighbour or one that leaves its own. Across the line the larger one; the sum where
///                              both leave their own                                                          (10)
///   rpa-2024                   max(√(u_A² + u_B²), 40 mm)                                                    (11)
///   nec-se-ds                  of one construction (u_A + u_B)/2, where floors are aligned max(u_A, u_B)/2; across a
///                              property line it does not say                                                 (12)
///
/// C_d deflection amplification, I_e, I_E, I importance factor, q, Q behaviour factor, R response reduction, R_d
/// ductility and R_o overstrength factor, a_g/g, S, Z ground acceleration, soil and zone factor, all [-]; h [length]
/// the level above the base, in (8) and (9) above that of the two from which it is more. Increments of (5), (6) are in
/// proportion. The amplifiers of (1) to (5) and (7) belong to displacements under a code's reduced design forces: where
/// the ground motion is not reduced they are 1. (8) to (12) take the displacements expected as they are. Clauses,
/// sources and what of their wording was checked: docs/separation-rules.md. Invariants (each has a test): a rule gives
/// the same gap in every unit of length; it does not depend on which building stands left; it does not shrink when a
/// displacement or an amplifier grows; what heights alone ask is no more than the rule asks of any displacements,
/// unless the code has a way of its own without them.
struct CodeRule {
  enum class Takes {
    reduced,   ///< u under the design forces, which the rule amplifies
    expected,  ///< u expected in the design earthquake
    height     ///< none
  };
  std::string_view name, title, clause;
  std::string_view wording;  ///< "checked", "to check", or which part of it
  std::string_view assumes;  ///< which displacement u is, and what the factors make of it
  Takes takes;
  std::vector<Key> keys;  ///< what it needs to be given; those of buildings: one for all or one each
  CodeSeparation (*separation)(const CodePair&, const CodeRuleSpec&);
  std::optional<HeightSeparation> (*by_height)(const CodePair&, const CodeRuleSpec&) = nullptr;  ///< null: nothing
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
