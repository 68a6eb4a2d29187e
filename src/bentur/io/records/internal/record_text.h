#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/core/text.h"
#include "bentur/io/records/file_unit.h"
#include "bentur/io/records/record_files.h"

// What the readers of the single formats share.
namespace bentur::records {

/// A word of a text file and where it stands.
struct Token {
  std::string_view text;
  int line = 0;    ///< from 1
  int column = 0;  ///< from 1, in bytes
};

struct Line {
  std::string_view text;
  int number = 0;  ///< from 1

  /// Whether `words`, in capitals, occur in the line in any spelling.
  [[nodiscard]] bool says(std::string_view words) const;
};

/// Errors of one record file, of which only the first ten are kept: a file of another format is all errors.
class RecordErrors {
 public:
  RecordErrors(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}
  /// Each returns nothing, for a reader to return in turn.
  std::nullopt_t error(int line, int column, const std::string& message);
  std::nullopt_t error(const Token& token, const std::string& message) {
    return error(token.line, token.column, message);
  }
  std::nullopt_t error(const Line& line, const std::string& message) { return error(line.number, 1, message); }
  std::nullopt_t error(const std::string& message) { return error(0, 0, message); }  ///< about the file as a whole
  [[nodiscard]] bool ok() const { return count_ == 0; }
  [[nodiscard]] bool full() const { return count_ >= 10; }

 private:
  std::string file_;
  Diagnostics& diagnostics_;
  int count_ = 0;
};

/// The bytes of a file as text of one byte a character: UTF-16 is known by its mark or its zero bytes, what it holds
/// beyond ASCII becomes the letter without its accent, or '?'; a mark of UTF-8 is left out.
[[nodiscard]] std::string decoded(std::string bytes);

/// A file with more or longer lines is no record.
inline constexpr std::size_t most_lines = 5000000, longest_line = std::size_t{4} << 20;

/// Lines ending in LF, CR LF or CR, up to one more than most_lines; a trailing empty line and an end-of-file mark of
/// DOS are left out.
[[nodiscard]] std::vector<Line> lines_of(std::string_view text);

/// The words of a line between any of `separators`; runs of separators count as one.
[[nodiscard]] std::vector<Token> words_of(const Line& line, std::string_view separators = " \t");

/// The cells of a line of fixed width, as Fortran writes them: they may touch. Blank ones at the end are left out.
[[nodiscard]] std::vector<Token> fields_of(const Line& line, std::size_t width);

/// The width of the fields by a Fortran format in the text, such as 10 of "(8F10.3)" or "(8(1PE10.3))"; 0 without one.
[[nodiscard]] std::size_t field_width(std::string_view text);

/// A number in C or Fortran spelling (.5E-02, +1., 1.0D-03). Infinity and NaN are returned as such.
[[nodiscard]] std::optional<double> number_of(std::string_view text, bool decimal_comma = false);

/// Whether a number can be that of a file's values: whole, from 1 to 10⁹.
[[nodiscard]] bool is_count(std::optional<double> count);

/// The first number behind `key` in the text, past blanks and any of ":=,"; both as they are spelled.
[[nodiscard]] std::optional<double> number_after(std::string_view text, std::string_view key);

/// `number_of`, or an error that the token is not a finite number.
[[nodiscard]] std::optional<double> finite_number(const Token& token, bool decimal_comma, RecordErrors& errors);

/// The numbers of all lines, in fields of `width` characters, or where it is 0 between blanks, where fields may touch.
/// Commas are decimal where there are no points. Reading stops once `errors` are full.
[[nodiscard]] std::vector<double> read_numbers(std::span<const Line> lines, std::size_t width, RecordErrors& errors);

/// A token as a message shows it.
[[nodiscard]] std::string shown(std::string_view text);

[[nodiscard]] std::string upper(std::string_view text);
/// The words of a text with one blank between them, but for one, here in capitals.
[[nodiscard]] std::string single_spaced(std::string_view text, std::string_view without = {});

/// NPTS and DT of a header line, in any of the spellings of PEER files; nothing where the line does not say both.
struct CountAndStep {
  long count = 0;        ///< number of values
  double time_step = 0;  ///< [s]
};
[[nodiscard]] std::optional<CountAndStep> count_and_step(const Line& line);

/// True when the file has the marks of a format, whether or not it can then be read.
[[nodiscard]] bool looks_like_peer(const std::vector<Line>& lines);  ///< AT2, but also VT2 and DT2, then refused
[[nodiscard]] bool looks_like_cosmos(const std::vector<Line>& lines);
[[nodiscard]] bool looks_like_csmip(const std::vector<Line>& lines);
[[nodiscard]] bool looks_like_smc(const std::vector<Line>& lines);
[[nodiscard]] bool looks_like_knet(const std::vector<Line>& lines);
[[nodiscard]] bool looks_like_esm(const std::vector<Line>& lines);
[[nodiscard]] bool looks_like_geonet(const std::vector<Line>& lines);
[[nodiscard]] bool looks_like_bhrc(const std::vector<Line>& lines);
[[nodiscard]] bool looks_like_knet_csv(const std::vector<Line>& lines);
[[nodiscard]] bool looks_like_afad(const std::vector<Line>& lines);
[[nodiscard]] bool looks_like_asa(const std::vector<Line>& lines);

/// Reads all but the name of the format; what it returns counts only while there is no error.
using RecordReader = std::optional<StrongMotionRecord>(const std::vector<Line>& lines, const RecordOptions& options,
                                                       RecordErrors& errors);
RecordReader read_peer, read_cosmos, read_csmip, read_bhrc, read_geonet, read_smc, read_knet, read_knet_csv, read_esm,
    read_afad, read_asa;
/// one-column, two-column, values, csv, or whichever of them fits where the format is "auto"; names the format, too.
RecordReader read_columns;

}  // namespace bentur::records
