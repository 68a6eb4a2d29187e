#pragma once

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "bentur/model/gap/code_rules.h"

// What the rules of codes are made of; the rules stand beside this folder.
namespace bentur::codes {

[[nodiscard]] Key factor_key(std::string_view name, Label label, std::string_view doc);
[[nodiscard]] Key deflection_amplification();
[[nodiscard]] Key importance_factor();
[[nodiscard]] Key behaviour_factor();
[[nodiscard]] Key response_reduction();
[[nodiscard]] Key overstrength_factor(std::string_view doc);
[[nodiscard]] Key soil_factor();
[[nodiscard]] Key mexican_zone();

/// A factor of one building. @throws InvalidParameter, naming the key, unless it is there and > 0
[[nodiscard]] double factor(const CodeRuleSpec& spec, std::string_view key, std::size_t building = 0);
/// The word for one building. @throws InvalidParameter unless it is there
[[nodiscard]] const std::string& word(const CodeRuleSpec& spec, std::string_view key, std::size_t building = 0);
/// The same, or where none is given what there is without it.
[[nodiscard]] std::string word_or(const CodeRuleSpec& spec, std::string_view key, std::string_view otherwise,
                                  std::size_t building = 0);
[[nodiscard]] bool is_set(const CodeRuleSpec& spec, std::string_view flag);
/// One of three, for zone I, II, III of the Valley of Mexico.
[[nodiscard]] double by_zone(const CodeRuleSpec& spec, const std::array<double, 3>& values);

/// Displacements of both buildings [length], amplified.
struct Amplified {
  double left = 0, right = 0;
  [[nodiscard]] double sum() const { return left + right; }
  [[nodiscard]] double srss() const { return std::hypot(left, right); }
};
/// Displacements times the first key over the second, where there is one.
[[nodiscard]] Amplified amplified(const CodePair& pair, const CodeRuleSpec& spec, std::string_view times,
                                  std::string_view over = {});

/// How many steps of `each` there are above `from`, a begun one as one; a hundredth of a step is none, as lengths are
/// round in other units. All [length].
[[nodiscard]] double begun_steps(double height, double from, double each);
/// Of the lower building [m].
[[nodiscard]] double lower_height(const CodePair& pair);

/// What a rule asks whatever the displacements are: of none at all.
template <CodeSeparation (*Rule)(const CodePair&, const CodeRuleSpec&)>
std::optional<HeightSeparation> at_rest(const CodePair& pair, const CodeRuleSpec& spec) {
  CodePair still = pair;
  still.left.displacement = still.right.displacement = 0;
  return HeightSeparation{Rule(still, spec), true};
}

/// Rules whose factors amplify displacements under a code's reduced forces.
[[nodiscard]] std::vector<CodeRule> amplifying_rules();
/// Rules that take displacements as they are expected, or heights alone.
[[nodiscard]] std::vector<CodeRule> expecting_rules();

}  // namespace bentur::codes
