#pragma once

#include <string>
#include <vector>

#include "bentur/core/number_text.h"

namespace bentur::cli {

/// Words in lines of at most 100 characters, those after the first indented by two.
[[nodiscard]] std::string wrapped(const std::string& text);

/// A table under a header of names, divided into two lines where the table would be wider than 100 characters, and
/// (where there are any) units, everything aligned to the right.
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
