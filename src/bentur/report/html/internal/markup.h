#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bentur::html {

/// Names with their values.
using Rows = std::vector<std::pair<std::string, std::string>>;

/// Markup that may stand in a page as it is. What comes from a case becomes markup by text() alone, so that no title or
/// name can bring in a tag, an attribute or a script; markup() is for what stands in the program's sources.
class Html {
 public:
  Html() = default;
  [[nodiscard]] static Html markup(std::string_view trusted) { return Html(std::string(trusted)); }
  /// Any text, for use between tags and in quoted attributes: & < > " ' ` become references, control characters that
  /// HTML does not allow and bytes that are not UTF-8 the replacement character.
  [[nodiscard]] static Html text(std::string_view any);

  Html& operator+=(const Html& other) {
    markup_ += other.markup_;
    return *this;
  }
  [[nodiscard]] friend Html operator+(Html a, const Html& b) { return a += b; }
  [[nodiscard]] const std::string& str() const { return markup_; }

 private:
  explicit Html(std::string markup) : markup_(std::move(markup)) {}
  std::string markup_;
};

/// <name attributes>content</name>; `name` and `attributes` stand in the sources. A text as content is escaped.
[[nodiscard]] Html element(std::string_view name, const Html& content, std::string_view attributes = "");
[[nodiscard]] Html element(std::string_view name, std::string_view text, std::string_view attributes = "");

/// JSON text as it may stand inside <script>: no "<", so that neither </script> nor <!-- can end or open anything.
[[nodiscard]] Html json_markup(std::string_view json);

/// JSON that a page's script reads.
[[nodiscard]] Html json_script(std::string_view id, std::string_view json);

/// A table under one header row; units stand below the names. Columns of numbers are aligned to the right.
class HtmlTable {
 public:
  struct Column {
    std::string name, unit;
    std::vector<std::string> cells;
    bool numeric = true;
    std::vector<double> values = {};  ///< per cell, NaN: another text; empty: such are all
  };
  /// `unit` empty: none. All columns of one length.
  void add(const std::string& name, const std::string& unit, const std::vector<double>& values);
  /// @param values of the cells, where column() makes them
  void add(const std::string& name, const std::string& unit, std::vector<std::string> cells, bool numeric = true,
           std::vector<double> values = {});
  /// The columns of another one, as long as these.
  void add(const HtmlTable& other);
  /// Those of them alone that no name here says already, as "Contact: Stiffness" says "Stiffness".
  void add_new(const HtmlTable& other);
  /// What a pointer over the cells of the first column shows.
  void explain(std::vector<std::string> titles) { titles_ = std::move(titles); }
  /// Makes a row stand out, e.g. the level that governs.
  void mark(std::size_t row) { marked_.push_back(row); }
  /// Keeps a row in sight on a telephone, where the script folds the others of a long list away.
  void keep_in_sight(std::size_t row) { in_sight_.push_back(row); }
  /// Adds the rows of another one, each with the name of what it is of in the first column; cells without a column
  /// there stay empty.
  void join(const std::string& name, const HtmlTable& other);
  /// Takes out the columns, but the first, that say the same in all rows, and gives what they say: "Damping 0.05";
  /// of one row none.
  [[nodiscard]] std::vector<std::string> take_alike();
  /// In tables of a page's width at most, each with the first column.
  [[nodiscard]] std::vector<HtmlTable> in_page_widths() const;
  /// The same with a title, which on paper stands above it on each page.
  [[nodiscard]] HtmlTable called(std::string_view title) const;
  [[nodiscard]] const std::string& title() const { return title_; }
  /// What joined tables are of, above their names.
  void call_first(const std::string& name) { columns_.front().name = name; }
  /// Without what stands behind so many columns.
  void cut_columns(std::size_t most) { columns_.resize(std::min(columns_.size(), most)); }
  /// What columns are of, from one on, counted from 0; each once.
  [[nodiscard]] std::vector<std::string> names_from(std::size_t first) const;
  [[nodiscard]] std::size_t columns() const { return columns_.size(); }
  [[nodiscard]] std::size_t rows() const { return columns_.empty() ? 0 : columns_.front().cells.size(); }
  /// What it is on a telephone: a table, or where that is broader than the telephone cards, one for each row, in which
  /// each cell has its heading; or one of the forms of report.css with these names.
  enum class OnTelephone { as_fits, gaps, checks, said };
  /// In a box of its own; nothing of none.
  [[nodiscard]] Html markup(std::string_view attributes = "", OnTelephone form = OnTelephone::as_fits) const;
  /// The same for paper alone, numbers of joined tables with equally many decimals. @param most rows
  [[nodiscard]] Html printed(std::size_t most) const;

  /// What it has been given.
  [[nodiscard]] const std::vector<Column>& all() const { return columns_; }

 private:
  enum class Heads { above, in_cells };
  /// Has a line of its own in a card.
  [[nodiscard]] static bool is_long(const Column& column);
  /// How many of the first columns it takes to tell rows apart as far as can be: these are the title of a card.
  [[nodiscard]] std::size_t telling() const;
  /// The class of cards whose cells stand three to a line, or four where that leaves less of the last one empty.
  [[nodiscard]] const char* cards() const;
  static void make_alike(Column& column);
  [[nodiscard]] static std::size_t letters(const Column& column);  ///< of the broadest line that is not divided
  [[nodiscard]] bool is_broad() const;
  [[nodiscard]] Html written(std::string_view attributes, Heads heads, std::size_t most) const;

  std::string title_;
  std::vector<Column> columns_;
  std::vector<std::size_t> marked_, in_sight_;
  std::vector<std::string> titles_;
};

/// A table under a heading that says what it is of, which on paper is the table's title; nothing of none.
[[nodiscard]] Html under(std::string_view level, std::string_view heading, const HtmlTable& table);

/// Content under a heading, which the page's script folds away on a telephone. @param level of the heading, "h3"
[[nodiscard]] Html fold(std::string_view level, std::string_view heading, const Html& content);

/// A part of a page, with its place in the list of contents; without content it is not there.
struct PageSection {
  std::string id, heading;  ///< the id stands in the sources
  Html content;
  Html behind = {};  ///< what stands behind all that is added to the content
};

/// Names and their values: a table of two columns without a header; with `sources` a third one, of where each is from.
[[nodiscard]] Html facts(const std::vector<std::pair<std::string, std::string>>& rows,
                         const std::vector<std::string>& sources = {});

}  // namespace bentur::html
