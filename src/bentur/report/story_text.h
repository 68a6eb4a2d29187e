#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bentur/model/story/story.h"
#include "bentur/report/words.h"

namespace bentur {

/// A statement in words. A number and its unit are kept together by a no-break space.
struct SaidStatement {
  std::string kind;
  Severity severity = Severity::finding;
  std::optional<Eigen::Index> gap = {};
  std::optional<long> rank = {};  ///< of the gap, Statement::rank
  std::string badge = {};         ///< the verdict in two or three words; empty where the statement is none
  bool is_open = false;           ///< it says that something is not known, which is no danger yet
  std::string text = {};
  std::size_t lead = 0;  ///< bytes of the text that are in bold: its first sentence, of what heads a verdict; else 0
  Shown shown = Shown::sentence;
  std::vector<std::vector<std::string>> rows = {};  ///< of a table of what else is known: what, how much, where, more
  std::vector<double> amounts = {};  ///< per row, how much before it is rounded; NaN where that is no number
};

/// The statements of a story, each in the words of a language. @throws InvalidParameter where the catalogue lacks one.
[[nodiscard]] std::vector<SaidStatement> said(const std::vector<Statement>& statements, const Words& say);

/// What the frame of a verdict says of all of it: "pounds" where something is too small or fails, "open" where that is
/// not known alone, else "clear". What else is known, in rows of its table, has a badge where it counts.
[[nodiscard]] const char* verdict_tone(const std::vector<SaidStatement>& all);

/// A table with headings and cells in words.
struct SaidTable {
  std::string heading;
  std::vector<TableColumn> columns;
  std::vector<bool> are_numbers = {};    ///< per column
  std::vector<std::size_t> marked = {};  ///< rows that stand out
  bool is_list = false;                  ///< its words are to be read from the left
  std::string note = {};                 ///< below it; empty: none
};
[[nodiscard]] SaidTable said(const StoryTable& table, const Words& say);

/// What else is known: the rows of statements that a first screen shows in a table. Nothing where there are none.
/// @param gaps the names of all gaps, which stand with the place where there are several
[[nodiscard]] std::optional<SaidTable> known_table(const std::vector<std::string>& gaps,
                                                   const std::vector<SaidStatement>& all, const Words& say);

/// Rows as lines: "what: how much, where, more".
[[nodiscard]] std::vector<std::string> rows_in_words(const SaidTable& table);

/// With ordinary spaces, as a terminal is searched.
[[nodiscard]] std::string with_spaces(std::string text);

/// A badge in capitals, as terminals have it.
[[nodiscard]] std::string upper_case(std::string text);

/// The same statement behind the name of its gap, as of_gap() has its text. @param shown the name in short
[[nodiscard]] SaidStatement behind_gap(SaidStatement statement, const std::string& gap, const std::string& shown = {});

/// A sentence behind the name of its gap, unless it names both buildings. @param shown the name in short
[[nodiscard]] std::string of_gap(const std::string& text, const std::string& gap, std::string shown = {});

/// Which statements of a story: of its outcome those that a first screen has as sentences.
enum class Told { outcome, remarks, all };
/// A line a statement, the gravest first: "BADGE: text", behind the gap's name in a row of several gaps; remarks as
/// "remark: text".
/// @param gaps the names of all gaps, in the order in which statements count them
[[nodiscard]] std::vector<std::string> story_lines(const std::vector<std::string>& gaps,
                                                   const std::vector<SaidStatement>& all, const Words& say, Told told);

}  // namespace bentur
