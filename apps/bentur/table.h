#pragma once

#include <string>
#include <vector>

namespace bentur::cli {

/// A number for people: four significant digits, no exponent between 1e-4 and 1e7.
[[nodiscard]] std::string number(double value);

/// Numbers of one column with equally many decimals, as many as leave the largest at most four significant digits.
/// A value that does not exist (NaN) becomes a dash.
[[nodiscard]] std::vector<std::string> column(const std::vector<double>& values);

/// Characters a UTF-8 text takes on a terminal.
[[nodiscard]] std::size_t width(const std::string& text);

/// A table under two header rows, names and (where there are any) units, everything aligned to the right.
class Table {
 public:
  /// `unit` empty: none. `cells` from top to bottom; all columns of one length.
  void add(std::string name, std::string unit, std::vector<std::string> cells);
  void add(std::string name, std::string unit, const std::vector<double>& values);

  /// Lines indented by two characters, with a rule under the header.
  [[nodiscard]] std::string text() const;

 private:
  struct Column {
    std::string name, unit;
    std::vector<std::string> cells;
  };
  std::vector<Column> columns_;
};

}  // namespace bentur::cli
