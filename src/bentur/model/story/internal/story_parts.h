#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bentur/core/number_text.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/model/story/judgement_story.h"
#include "bentur/model/story/story.h"
#include "bentur/pounding/plan/masses_elsewhere.h"

namespace bentur::story {

inline constexpr double percent = 100;

/// What the story of gaps is made from, of a run or by a spectrum.
struct GapView {
  const Case& c;
  const Problem& problem;
  const Response* response = nullptr;                        ///< nothing: by a spectrum
  std::vector<LevelSeparation> levels;                       ///< of all gaps
  bool falls = false;                                        ///< falls_without_contact()
  bool is_cut = false;                                       ///< the ground motion goes on after the end of the run
  std::vector<std::vector<ScreeningFinding>> screened = {};  ///< per gap; empty: how they stand is not known
  const PlanProblem* plan = nullptr;                         ///< of row_of() buildings in plan: where its levels are
  std::vector<MassPlaces> masses = {};                       ///< mass_choices() of `plan`
  std::vector<double> mass_parts = {};                       ///< in plan Plan::eccentricity_both_ways of each building
  std::vector<JudgedGap> gaps = {};                          ///< empty: nothing is judged
  std::shared_ptr<const RunResults> row = {};                ///< row_of() a run in plan, which `problem` is of
  [[nodiscard]] double scale(Eigen::Index gap) const;        ///< displacement_scale() [length]; 0 by a spectrum
};

[[nodiscard]] inline StoryValue value_in(std::string name, double value, std::string unit = {}) {
  return {std::move(name), value, std::move(unit)};
}
[[nodiscard]] inline StoryValue count_of(std::string name, long value) { return {std::move(name), value}; }
[[nodiscard]] inline StoryValue text_of(std::string name, std::string value) {
  return {std::move(name), std::move(value)};
}
[[nodiscard]] inline StoryValue word_of(std::string name, std::string key) {
  return {std::move(name), std::move(key), {}, true};
}

/// A statement with more values.
template <class... Values>
[[nodiscard]] Statement with(Statement statement, Values... values) {
  (statement.values.push_back(std::move(values)), ...);
  return statement;
}

[[nodiscard]] const Judgement& judged_of(const GapView& facts, Eigen::Index gap);
/// The word for what moves the buildings; of a run that ends before it does {end} fills it.
[[nodiscard]] const char* motion_word(const GroundMotion& motion, const ExcitationSpec& excitation, bool cut);
/// The gap needed and given where it falls short the most, in this motion and the reversed one, or by the spectrum.
void tell_need(const GapView& facts, Eigen::Index gap, std::vector<Statement>& statements);
/// Whether a need is known only as no more than what is given: in plan where edges never all close at once, (P-6).
[[nodiscard]] bool is_bound(const GapView& facts, const FacingLevel& level, const std::optional<double>& need);
/// What such needs are, once for all gaps.
void tell_bounds(const GapView& facts, std::vector<Statement>& statements);
/// What is said first of a gap: that its buildings collide, that it is too small, that this is not known and why, or
/// that they stay apart. @param hit tells of contact in the run; it is called where there is some
void tell_judgement(const GapView& view, Eigen::Index gap, const std::function<void(Statement)>& hit,
                    std::vector<Statement>& statements);
/// A reason as an item of a statement: the word {why} and what fills it.
[[nodiscard]] std::vector<StoryValue> reason_item(const GapView& view, Eigen::Index gap, const Reason& reason);

/// judgement_word() of a gap or a level of it, and of what is not known in short why, for a table.
[[nodiscard]] const char* judged_word(Sufficiency value, const Judgement& judged, bool is_cut);

/// What the rules ask, which of them ask for more than is given, which understate, which say nothing and why.
void tell_rules(const GapView& facts, Eigen::Index gap, std::vector<Statement>& statements);
/// Whether those rules of [code] that depend on it are taken across a property line and for floors that are aligned,
/// and what of it is not given. @param gap its number
void tell_assumed(const CodeSpec& code, std::optional<std::size_t> gap, std::vector<Statement>& statements);
/// The screening of a gap, where there is any.
void put_screening(const GapView& facts, Eigen::Index gap, std::vector<StoryTable>& tables);
/// Every level with what it needs and what ABS, SRSS and DDC say; every rule; the screening.
[[nodiscard]] std::vector<StoryTable> gap_tables(const GapView& facts, Eigen::Index gap);

/// The word for why a rule says nothing, or "enough" where it does.
[[nodiscard]] const char* silence_word(RuleFinding::Silence silence);
/// Of items {rule}, {gap}, {level}: the level of all where it is one, else each item's own.
void tell_levels_once(Statement& statement);
/// What has to be read of a code's text with the number of its rule.
void tell_quotations(const CodeSpec& code, std::vector<Statement>& statements);

/// Of frames with hinges: a mechanism, how many have formed and which turned furthest, limits passed, with a table.
void tell_hinges(const RunResults& run, Story& told);
/// The same of the frames of buildings in plan, and of their columns as tell_breaking().
void tell_hinges(const PlanRun& run, Story& told);

/// Of frames with infill: where a strut pushes hardest on a column, and where infill failed first or lost most.
void tell_infill(const RunResults& run, std::vector<Statement>& statements);

/// Of frames whose columns can break in shear: how many have and which first, with a table of them in order of time.
void tell_breaking(const RunResults& run, Story& told);

/// screening() of every gap of a row; nothing where its buildings are not known, as of results that are read back.
[[nodiscard]] std::vector<std::vector<ScreeningFinding>> screened(const Case& c, const Problem& problem);
[[nodiscard]] std::vector<std::vector<ScreeningFinding>> screened(const Case& c, const PlanProblem& problem);
/// What rules ask of a gap.
[[nodiscard]] std::vector<RuleFinding> findings_of(const GapView& view, const std::vector<LevelSeparation>& levels,
                                                   Eigen::Index gap);
/// The gaps of a run, which must outlive it; nothing is judged yet.
[[nodiscard]] GapView view_of(const RunResults& run);
/// The same of a row, judged.
[[nodiscard]] GapView judged_view_of(const RunResults& run);
/// Of gaps by a spectrum.
[[nodiscard]] GapView judged_view_of(const Case& c, const Problem& problem, const SpectralGaps& spectral);
/// The same of buildings in plan.
[[nodiscard]] GapView judged_view_of(const PlanRun& run);
/// Of more than one gap: how many are too small, of how many that is not known, and a table; of many gaps of the worst.
/// @return the worst gap, nothing where there is one alone
std::optional<Eigen::Index> tell_gaps(const GapView& view, const ShownUnits& shown, Story& told);
/// What links carry and by how much they stroke, which they are bought by: of every two buildings the most of all.
/// @param problem of a row or of buildings in plan @param found likewise, one per link
template <class AnyProblem>
void tell_links(const AnyProblem& problem, const std::vector<LinkSummary>& found, const ShownUnits& shown,
                const std::string& length, std::vector<Statement>& statements) {
  const auto link_at = [&](std::size_t i) -> const Link& {
    if constexpr (requires { problem.links[i].link; }) {
      return problem.links[i].link;
    } else {
      return problem.links[i];
    }
  };
  struct Pair {
    std::size_t left, right, hardest;
    double force = 0, stroke = 0;
    long count = 0;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto left = static_cast<std::size_t>(link_at(i).left);
    const auto right = static_cast<std::size_t>(link_at(i).right);
    auto pair = std::find_if(pairs.begin(), pairs.end(),
                             [&](const Pair& one) { return one.left == left && one.right == right; });
    if (pair == pairs.end()) pair = pairs.insert(pairs.end(), {left, right, i});
    const double most = std::max(found[i].peak_compression, found[i].peak_tension);
    pair->stroke = std::max({pair->stroke, found[i].peak_closing, found[i].peak_opening});
    ++pair->count;
    if (!(most > pair->force)) continue;
    pair->force = most;
    pair->hardest = i;
  }
  const auto is_between = [](const auto& gap, Eigen::Index left, Eigen::Index right) {
    return (gap.left == left && gap.right == right) || (gap.left == right && gap.right == left);
  };
  const auto gap_of = [&](Eigen::Index left, Eigen::Index right) -> std::optional<Eigen::Index> {
    if constexpr (requires { problem.gaps; }) {
      for (std::size_t g = 0; g < problem.gaps.size(); ++g) {
        if (is_between(problem.gaps[g], left, right)) return static_cast<Eigen::Index>(g);
      }
    } else {
      for (Eigen::Index g = 0; g < gap_count(problem); ++g) {
        if (is_between(sides_of(problem, g), left, right)) return g;
      }
    }
    return std::nullopt;
  };
  for (const Pair& pair : pairs) {
    const double level = link_at(pair.hardest).elevation;
    statements.push_back(
        {.kind = "links",
         .gap = gap_of(static_cast<Eigen::Index>(pair.left), static_cast<Eigen::Index>(pair.right)),
         .buildings = {static_cast<Eigen::Index>(pair.left), static_cast<Eigen::Index>(pair.right)},
         .level = level,
         .values = {text_of("left", problem.buildings[pair.left].name),
                    text_of("right", problem.buildings[pair.right].name),
                    value_in("force", shown.force * pair.force, shown.units.force), value_in("level", level, length),
                    value_in("stroke", pair.stroke, length), count_of("links", pair.count)}});
  }
}

/// What the model of a row or of buildings in plan is, and what it leaves out.
template <class AnyRun>
[[nodiscard]] Statement model_statement(const AnyRun& run);

/// {level} of a contact point (else of what is watched) of a gap in plan: its elevation, its place, and whose corner is
/// there.
void add_place(const PlanProblem& problem, const PlanGap& gap, bool is_point, Eigen::Index index,
               const std::string& length, std::vector<StoryValue>& values);
/// {level}: of a row the elevation.
void add_level(const GapView& facts, bool is_point, Eigen::Index index, double elevation,
               std::vector<StoryValue>& values);
/// Floors that met what they face where no contact is modelled, and how to model it.
void tell_unmodelled(const GapView& facts, Eigen::Index gap, std::vector<Statement>& statements);
/// What rules ask of a gap by heights, and the table of it.
void tell_heights(const Case& c, const Problem& problem, Eigen::Index gap, Story& told);

/// The building that a watched floor faces.
[[nodiscard]] const std::string& faced_name(const Problem& problem, const WatchedFloor& floor);
/// {building}, {faced_building} and the word {faced}.
void add_faces(const Problem& problem, const WatchedFloor& floor, bool in_plan, std::vector<StoryValue>& values);

/// Of a row or block that is run under the motion reversed too what contact does there, where that is more than under
/// the motion as given: it closes another gap, or strikes harder.
void tell_reversed_contact(const GapView& view, const ShownUnits& shown, std::vector<Statement>& statements);

}  // namespace bentur::story
