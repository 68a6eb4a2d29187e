#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/model/story/story.h"

namespace bentur {

/// What is judged of a gap, in words.
struct ToldJudgement {
  Eigen::Index left = 0, right = 0;  ///< its buildings
  double width = 0;                  ///< given where it is narrowest [length]; NaN where no floors face one another
  Judgement judgement;
  std::vector<std::vector<StoryValue>> reasons = {};  ///< of each of them: the word {why} and what fills it
  std::vector<double> elevations = {};                ///< of each: of the level that it is of [length]; NaN: of none

  [[nodiscard]] bool is_facing() const { return width == width; }
};

/// One per gap.
[[nodiscard]] std::vector<ToldJudgement> told_judgements(const RunResults& run);
[[nodiscard]] std::vector<ToldJudgement> told_judgements(const PlanRun& run);
[[nodiscard]] std::vector<ToldJudgement> told_judgements(const Case& c, const Problem& problem,
                                                         const SpectralGaps& spectral);

/// The places of the gaps, the worst first: as they are judged, by how much they fall short, by the hardest impact.
[[nodiscard]] std::vector<std::size_t> worst_first(const std::vector<JudgedGap>& gaps);
constexpr std::size_t worst_gaps_shown = 10;
/// A table of gaps without its columns: of many it has the worst alone, worst_gaps_shown, and says how many it leaves
/// out.
/// @param order the places of the gaps, the worst first; then of those in the table, a line each
/// @param judged what a gap is judged to be
[[nodiscard]] StoryTable begun_table(std::vector<std::size_t>& order,
                                     const std::function<Sufficiency(std::size_t)>& judged);

/// The word for what a gap, or a level of it, is judged to be.
[[nodiscard]] const char* judgement_word(Sufficiency value);

/// How many of the gaps of a row or a block are too small, and of how many it is not known whether they are enough.
/// @param none what is said where all are enough
/// @param cut_at when the run ends though the motion goes on, which is why it is not known [s]
[[nodiscard]] Statement counted_gaps(long count, long small, long unknown, std::string none = "row_none",
                                     std::optional<double> cut_at = {});

/// Of a gap under many records: too small under so many and why, not known under so many and why, or enough under all.
struct ManyToTell {
  std::vector<std::string> names;         ///< of the records
  std::vector<ToldJudgement> of_records;  ///< likewise, of this gap
  JudgementOfMany many;
  std::string left, right;  ///< its buildings
  std::string length;       ///< its unit
};
[[nodiscard]] std::vector<Statement> judgement_of_many(const ManyToTell& told, Eigen::Index gap);

}  // namespace bentur
