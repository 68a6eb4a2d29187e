#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bentur/core/number_text.h"
#include "bentur/report/story_text.h"

namespace bentur::cli {

/// How many characters a line may have: COLUMNS, else the width of the terminal; nothing where there is neither.
[[nodiscard]] std::optional<std::size_t> asked_width();
/// That, else 100.
[[nodiscard]] std::size_t line_width();

/// Words in lines of at most line_width() and 100 characters, those after the first indented by two.
[[nodiscard]] std::string wrapped(const std::string& text);

/// A text with ordinary spaces, as a terminal is searched, whose lines that go beyond asked_width() are wrapped().
[[nodiscard]] std::string fitted(const std::string& given);

/// A table under a header of names, divided into two lines where the table would be wider than line_width(), and
/// (where there are any) units, aligned to the right but for columns of words that are to be read. Columns that go
/// beyond asked_width() all the same stand in a second table below, behind the first column; a last one without a name,
/// which marks rows, becomes a mark before them that is explained below.
class Table {
 public:
  /// `unit` empty: none. `cells` from top to bottom; all columns of one length.
  void add(std::string name, std::string unit, std::vector<std::string> cells, bool is_left = false);
  void add(std::string name, std::string unit, const std::vector<double>& values);

  /// Lines indented by two characters, with a rule under the header.
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] std::string with_marks_first() const;
  [[nodiscard]] std::size_t least_width_needed() const;
  [[nodiscard]] std::string in_one(std::size_t widest_line) const;
  struct Column {
    std::string name, unit;
    std::vector<std::string> cells;
    bool is_left = false;
  };
  std::vector<Column> columns_;
  std::vector<bool> marked_;  ///< rows with a mark before them; empty: none
};

/// A table of a story under its heading.
[[nodiscard]] std::string table_text(const SaidTable& table);

}  // namespace bentur::cli
