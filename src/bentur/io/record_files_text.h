#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/io/record_files.h"

// What the readers of the single formats share.
namespace bentur {

/// A word of a text file and where it stands.
struct Token {
  std::string_view text;
  int line = 0;    ///< from 1
  int column = 0;  ///< from 1, in bytes
};

struct Line {
  std::string_view text;
  int number = 0;  ///< from 1
};

/// Errors of one record file, of which only the first ten are kept: a file of another format is all errors.
class RecordErrors {
 public:
  RecordErrors(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}
  void error(int line, int column, const std::string& message);
  void error(const Token& token, const std::string& message) { error(token.line, token.column, message); }
  [[nodiscard]] bool ok() const { return count_ == 0; }
  [[nodiscard]] bool full() const { return count_ >= 10; }

 private:
  std::string file_;
  Diagnostics& diagnostics_;
  int count_ = 0;
};

/// Lines ending in LF, CR LF or CR; a trailing empty line and an end-of-file mark of DOS are left out.
[[nodiscard]] std::vector<Line> lines_of(std::string_view text);

/// The words of a line between any of `separators`; runs of separators count as one.
[[nodiscard]] std::vector<Token> words_of(const Line& line, std::string_view separators);

/// A number in C or Fortran spelling (.5E-02, +1., 1.0D-03). Infinity and NaN are returned as such.
[[nodiscard]] std::optional<double> number_of(std::string_view text, bool decimal_comma = false);

/// `number_of`, or an error that the token is not a finite number.
[[nodiscard]] std::optional<double> finite_number(const Token& token, bool decimal_comma, RecordErrors& errors);

/// A token as a message shows it.
[[nodiscard]] std::string shown(std::string_view text);

/// True when the file has the header of a PEER file (AT2, but also VT2 and DT2, which the reader then refuses).
[[nodiscard]] bool looks_like_peer(const std::vector<Line>& lines);
[[nodiscard]] std::optional<Record> read_peer(const std::vector<Line>& lines, const RecordOptions& options,
                                              RecordErrors& errors);
/// one-column and two-column, or whichever of them fits where the format is "auto".
[[nodiscard]] std::optional<Record> read_columns(const std::vector<Line>& lines, const RecordOptions& options,
                                                 RecordErrors& errors);

}  // namespace bentur
