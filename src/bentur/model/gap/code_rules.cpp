#include "bentur/model/gap/code_rules.h"

#include <algorithm>
#include <iterator>

#include "bentur/core/errors.h"
#include "bentur/core/not_known.h"
#include "bentur/core/require.h"
#include "bentur/model/gap/codes/internal/rule_parts.h"

namespace bentur {

const std::vector<CodeRule>& code_rules() {
  static const std::vector<CodeRule> rules = [] {
    std::vector<CodeRule> all = codes::amplifying_rules(), others = codes::expecting_rules();
    std::move(others.begin(), others.end(), std::back_inserter(all));
    return all;
  }();
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

/// Whether it asks nothing where there is a public way between the buildings, and there is.
bool is_let_off(const CodeRule& rule, const CodePair& pair) {
  return rule.owner == CodeRule::Owner::not_at_public_way && pair.boundary == Boundary::public_way;
}

}  // namespace

bool depends_on_owner(const CodeRuleSpec& spec) {
  const CodeRule* const rule = find_code_rule(spec.rule);
  return rule != nullptr && rule->owner != CodeRule::Owner::no_matter;
}

bool depends_on_alignment(const CodeRuleSpec& spec) {
  return spec.rule == "en-1998-1" || spec.rule == "tbdy-2018" || spec.rule == "nec-se-ds" || spec.rule == "is-1893-1" ||
         (spec.rule == "ntc-2004" && codes::is_set(spec, "structures_alike"));
}

CodeSeparation code_separation(const CodePair& pair, const CodeRuleSpec& spec) {
  const CodeRule& rule = checked_rule(pair, spec, true);
  CodeSeparation asked = rule.separation(pair, spec);
  if (!is_let_off(rule, pair)) return asked;
  return {spec.rule, not_known, {}, {}};
}

std::optional<HeightSeparation> height_separation(const CodePair& pair, const CodeRuleSpec& spec) {
  const CodeRule& rule = checked_rule(pair, spec, false);
  return rule.by_height == nullptr || is_let_off(rule, pair) ? std::nullopt : rule.by_height(pair, spec);
}

}  // namespace bentur
