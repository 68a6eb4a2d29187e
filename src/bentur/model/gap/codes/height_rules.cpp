#include "bentur/model/gap/codes/height_rules.h"

#include <algorithm>
#include <limits>

#include "bentur/model/gap/gap_outcome.h"

namespace bentur {

std::vector<HeightFinding> height_findings(const Problem& problem, Eigen::Index gap, const CodeSpec& code,
                                           const Units& units) {
  using Silence = RuleFinding::Silence;
  using Verdict = HeightFinding::Verdict;
  const std::vector<FacingLevel> levels = facing_levels(problem, gap);
  std::vector<HeightFinding> findings;
  for (const CodeRuleSpec& rule : code.rules) {
    HeightFinding found{.rule = rule.rule};
    double most = -std::numeric_limits<double>::infinity();
    bool all = true, least = false;
    for (const FacingLevel& level : levels) {
      found.needs.push_back({level, height_separation(code_pair(problem, level, code, units), rule)});
      const auto& asked = found.needs.back().asked;
      all = all && asked;
      if (!asked) continue;
      least = least || asked->is_least;
      const double lacks = asked->asked.gap - level.width;
      if (!(lacks >= most)) continue;  // of levels that are alike the highest
      most = lacks;
      found.at = found.needs.size() - 1;
    }
    if (found.at && is_below_target(levels[*found.at].width, found.needs[*found.at].asked->asked.gap, 0)) {
      found.verdict = Verdict::too_small;
    } else if (levels.empty() || !all) {
      const bool at_way = code.boundary_at(static_cast<std::size_t>(gap)) == Boundary::public_way &&
                          find_code_rule(rule.rule)->owner == CodeRule::Owner::not_at_public_way;
      found.silence = levels.empty() ? Silence::no_level : at_way ? Silence::public_way : Silence::displacements;
      found.at.reset();
    } else {
      found.verdict = least ? Verdict::least : Verdict::enough;
    }
    findings.push_back(std::move(found));
  }
  return findings;
}

}  // namespace bentur
