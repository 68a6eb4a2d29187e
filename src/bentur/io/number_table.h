#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/io/input_file.h"

namespace bentur {

inline constexpr InputKind table_input{"table", std::uintmax_t{16} << 20};

/// Rows of numbers from a text file, all of one width.
struct NumberTable {
  std::vector<std::vector<double>> rows;
  std::vector<int> lines;  ///< of the file, from 1, one per row

  [[nodiscard]] std::size_t columns() const { return rows.empty() ? 0 : rows.front().size(); }
};

/// Cells stand between semicolons, else commas, else blanks; between semicolons a comma may be decimal. Lines before
/// the first row that begin with a word are a heading; blank lines and what follows # are left out. What is wrong goes
/// to `diagnostics` with line and column; then nothing is returned.
[[nodiscard]] std::optional<NumberTable> read_number_table(const std::filesystem::path& file, Diagnostics& diagnostics);

/// The same of a text that is already in memory.
/// @param names where it is given, rows may begin with a word: of each row that one; empty where none does
[[nodiscard]] std::optional<NumberTable> number_table(const std::string& text, const std::string& file,
                                                      Diagnostics& diagnostics,
                                                      std::vector<std::string>* names = nullptr);

}  // namespace bentur
