#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <string>

#include "bentur/io/internal/text_cursor.h"
#include "bentur/io/toml/toml_value.h"

namespace bentur {
namespace {

constexpr int max_depth = 32;  // of brackets, and of the parts of one dotted key

enum class Place { outside, comment, basic, literal, basic_lines, literal_lines };

bool in_lines(Place place) { return place == Place::basic_lines || place == Place::literal_lines; }

}  // namespace

bool check_toml_text(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  TextCursor cursor(text);
  Place place = Place::outside;
  int brackets = 0;
  int dots = 0;
  bool escaped = false;     // the character before was a backslash that counts
  bool after_fold = false;  // a backslash and blanks only came before, in a multi-line basic string
  int skip = 0;             // characters of a delimiter still to pass
  const auto refuse = [&](const std::string& message) {
    diagnostics.error({file, cursor.line(), cursor.column()}, message);
    return false;
  };
  for (bool first = true; !cursor.done(); first = false, cursor.next()) {
    const std::optional<char32_t> character = cursor.character();
    if (!character) return refuse("not valid UTF-8 (save the file as UTF-8)");
    const char32_t c = *character;
    if (first && c == 0xFEFF) continue;  // a byte order mark
    if (skip > 0) {
      --skip;
      continue;
    }
    const bool ascii = c < 0x80;
    const bool blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    switch (place) {
      case Place::comment:
        if (c == '\n') place = Place::outside;
        break;
      case Place::outside:
        if (!ascii)
          return refuse(
              fmt::format("character U+{:04X} may stand only in a string or a comment", static_cast<unsigned>(c)));
        if (c == '#') {
          place = Place::comment;
        } else if (cursor.starts("\"\"\"") || cursor.starts("'''")) {
          place = c == '"' ? Place::basic_lines : Place::literal_lines;
          skip = 2;
        } else if (c == '"' || c == '\'') {
          place = c == '"' ? Place::basic : Place::literal;
        } else if (c == '[' || c == '{') {
          if (++brackets > max_depth) return refuse(fmt::format("nested deeper than {} levels", max_depth));
        } else if (c == ']' || c == '}') {
          --brackets;
        } else if (c == '.' && ++dots > max_depth) {
          return refuse(fmt::format("a key of more than {} parts", max_depth));
        }
        if (c == '\n' || c == ',' || c == '=' || c == '[' || c == '{') dots = 0;
        escaped = after_fold = false;
        break;
      default:  // inside a string
        if (!ascii && (escaped || after_fold)) {
          return refuse(fmt::format("character U+{:04X} may not follow a backslash", static_cast<unsigned>(c)));
        }
        if (c == '\n' && !in_lines(place)) {
          place = Place::outside;  // an unfinished string: the parser says so
        } else if (escaped) {
          escaped = false;
          after_fold = place == Place::basic_lines && blank;
        } else if (after_fold && blank) {
          break;
        } else {
          after_fold = false;
          if (c == '\\' && (place == Place::basic || place == Place::basic_lines)) {
            escaped = true;
          } else if ((place == Place::basic && c == '"') || (place == Place::literal && c == '\'')) {
            place = Place::outside;
          } else if ((place == Place::basic_lines && cursor.starts("\"\"\"")) ||
                     (place == Place::literal_lines && cursor.starts("'''"))) {
            // Up to two more quotes belong to the string: """ text""""" ends at the last three.
            const std::string quotes(5, static_cast<char>(c));
            skip = cursor.starts(quotes.c_str()) ? 4 : cursor.starts(quotes.c_str() + 1) ? 3 : 2;
            place = Place::outside;
          }
        }
    }
  }
  return true;
}

}  // namespace bentur
