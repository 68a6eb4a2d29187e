#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bentur/model/gap/spectral_gap.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/model/run_results.h"

namespace bentur {

/// How much a statement matters; what matters most comes first.
enum class Severity {
  danger,   ///< something fails, or the run does not tell what happens
  warning,  ///< buildings collide, or what is given is not enough
  finding,  ///< any other outcome
  remark,   ///< a number that is unusual, or what the model leaves out
};
/// "danger", "warning", "finding", "remark".
[[nodiscard]] std::string_view severity_name(Severity severity);
/// Whether a verdict with such a statement is a warning.
[[nodiscard]] inline bool is_grave(Severity severity) { return severity <= Severity::warning; }
/// Whether a statement of this kind says that something is not known, which is no danger yet.
[[nodiscard]] inline bool is_open(std::string_view kind) { return kind.ends_with("not_known") || kind == "asked_more"; }

/// What fills a {name} in the text of a statement.
struct StoryValue {
  std::string name;
  std::variant<double, long, std::string> value;  ///< a number, a count, a name
  std::string unit = {};                          ///< of a number: of the case, s, g, %, ms or none
  bool is_word = false;  ///< the value is the key of a text of its own, filled with the same values
};

/// Where a first screen shows a statement.
enum class Shown {
  sentence,  ///< among the few sentences that come first
  row,       ///< in the table of what else is known, by the text ".row"
  table,     ///< in a table of the story, that of its gaps, levels or rules
};
/// "sentence", "row", "table".
[[nodiscard]] std::string_view shown_name(Shown shown);

/// One sentence or two of what is to be said, without words: the catalogue has a text "story." + kind in each language,
/// where the statement is the head of a verdict a short one, ".badge", and where it may be a row of a table one with a
/// bar between its cells, ".row". Every door renders them all, in order.
struct Statement {
  std::string kind;
  Severity severity = Severity::finding;
  std::optional<Eigen::Index> gap = {};  ///< that it is of
  std::optional<long> rank = {};  ///< of that gap among all of the run, from 1, the worst first; of one gap alone none
  std::vector<Eigen::Index> buildings = {};
  std::optional<double> level = {};  ///< [length]
  std::vector<StoryValue> values = {};
  std::vector<std::vector<StoryValue>> items = {};  ///< a list, each by the text ".item"; joined they fill {items}
  std::string subject = {};  ///< of a remark whose number it is, of a study what varies; shown before it
  double beyond = 0;         ///< of a remark beyond_usual() of the farthest of its numbers [-]; else 0
  /// Of many runs: how many of them say so, and which one says the worst, whose statement this is.
  struct OfMany {
    long count = 0, runs = 0;
    std::string worst;
  };
  std::optional<OfMany> many = {};
  Shown shown = Shown::sentence;
};

/// A column of a table: numbers, names, or words of the catalogue.
struct StoryColumn {
  std::string label;                      ///< key of its heading, or where the catalogue has none the heading itself
  std::string unit = {};                  ///< empty: none
  std::vector<double> numbers = {};       ///< NaN: there is none
  std::vector<std::string> texts = {};    ///< in place of numbers
  bool are_words = false;                 ///< the texts are keys of the catalogue, or empty
  bool are_counts = false;                ///< the texts are counts and shares, set as numbers are
  int digits = 4;                         ///< of the largest number
  std::vector<std::size_t> at_most = {};  ///< rows of which the number is an upper bound, shown with ≤
};

struct StoryTable {
  std::string
      kind;  ///< "row", "levels", "rules", "height_rules", "screening", "records"; its heading is "story.table." + kind
  std::optional<Eigen::Index> gap = {};
  std::vector<StoryValue> values = {};  ///< that fill the heading
  std::vector<StoryColumn> columns = {};
  std::vector<std::size_t> marked = {};  ///< rows that stand out
};

/// What is to be said of a run, of gaps or of a spectrum: statements from the gravest on, and tables.
struct Story {
  std::vector<Statement> statements;
  std::vector<StoryTable> tables = {};
};

/// Puts what is gravest first; what is alike stays in order.
void sort_by_severity(std::vector<Statement>& statements);

/// The statement of a gap whose impact is the hardest: by force, of contacts without one by speed; null: none.
[[nodiscard]] const Statement* hardest_impact_of(const std::vector<Statement>& statements);

/// What is said of one of many runs.
struct SaidOfRun {
  std::string name;  ///< such as that of its record
  std::vector<Statement> statements;
};
/// What many runs say: every kind of statement once, as the run says it that says the worst, with how many say it too;
/// what is gravest first, remarks last. What single runs need, what rules ask of them and how each is judged is left
/// out, but for rules that say nothing under any: over many runs that is reported of all of them. Of one run it is what
/// that run says.
[[nodiscard]] std::vector<Statement> union_of(const std::vector<SaidOfRun>& runs);

/// Of a run, of a row or of buildings in plan: what fails, who collides where and how hard, the gap needed in both
/// directions, the rules at every level, what contact does to the buildings, the ground motion as applied, what the
/// model leaves out, remarks. Of more than one gap there is a table. Gaps of statements are those of the problem.
[[nodiscard]] Story run_story(const RunResults& run);
[[nodiscard]] Story run_story(const PlanRun& run);

/// Of the gaps of a run: what is needed and what rules ask, with a table of levels, of rules and of the screening for
/// each.
[[nodiscard]] Story gap_story(const RunResults& run);
[[nodiscard]] Story gap_story(const PlanRun& run);

/// Its tables alone.
[[nodiscard]] std::vector<StoryTable> gap_tables_of(const RunResults& run);
[[nodiscard]] std::vector<StoryTable> gap_tables_of(const PlanRun& run);

/// The screening of every gap, where there is any. @param row of the case, in plan row_of() `plan`, else null
[[nodiscard]] std::vector<StoryTable> screening_tables(const Case& c, const Problem& row, const PlanProblem* plan);

/// The same by a spectrum.
[[nodiscard]] Story spectral_story(const Case& c, const Problem& problem, const SpectralGaps& spectral);

/// What rules of [code] ask of the gaps from heights alone, before anything is computed.
[[nodiscard]] Story height_rules_story(const Case& c, const Problem& problem);
[[nodiscard]] Story height_rules_story(const Case& c, const PlanProblem& problem);

/// Remarks as statements; those that differ in subject and number alone become one. A doubt is a danger.
[[nodiscard]] std::vector<Statement> remark_statements(const std::vector<Remark>& remarks);

/// Puts them with what is said: doubts first, the others last.
void put_remarks(const std::vector<Remark>& remarks, std::vector<Statement>& statements);

}  // namespace bentur
