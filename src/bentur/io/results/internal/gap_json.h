#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bentur/io/results/internal/asked_json.h"
#include "bentur/model/gap/minimum_gap.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/model/story/judgement_story.h"

// What results tell of a gap, of a row or of row_of() buildings in plan, `plan`; null: of a row.
namespace bentur {

[[nodiscard]] Json between_json(const Problem& problem, Eigen::Index gap);

/// Every watched floor of a gap, and what it does in the run.
[[nodiscard]] Json watched_list(const Problem& problem, const Response& response, const Gap& gap,
                                const PlanProblem* plan = nullptr);

/// Those that met what they face, the deepest first.
[[nodiscard]] Json unmodelled_list(const Problem& problem, const Response& response, Eigen::Index gap,
                                   const std::string& length, const PlanProblem* plan = nullptr);

/// What one gap needs: the largest over its levels, what each rule asks, every level, how the buildings stand.
[[nodiscard]] Json gap_json_of(const Case& c, const Problem& problem, const std::vector<LevelSeparation>& levels,
                               const std::vector<RuleFinding>& findings, Eigen::Index gap,
                               const std::vector<ScreeningFinding>& screened, const PlanProblem* plan = nullptr);

/// Of a response without contact that ends in collapse nothing is known of what is needed.
void forget_needs(std::vector<LevelSeparation>& levels);

/// Puts what is judged of each gap into its object of a list: "judgement".
void put_judgements(const std::vector<ToldJudgement>& told, Json& gaps);

}  // namespace bentur
