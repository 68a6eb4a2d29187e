#include "bentur/io/records/internal/record_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <system_error>

#include "bentur/core/number_text.h"
#include "bentur/io/records/internal/heading_words.h"
#include "bentur/io/records/internal/number_cells.h"

namespace bentur::records {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Where the zero bytes of ASCII in UTF-16 stand: 0 in the first byte of each pair (big end first), 1 in the second;
/// nothing where the text is of another kind.
std::optional<int> zero_bytes(const std::string& bytes) {
  if (bytes.compare(0, 2, "\xFE\xFF") == 0) return 0;
  if (bytes.compare(0, 2, "\xFF\xFE") == 0) return 1;
  const std::size_t looked_at = std::min(bytes.size(), std::size_t{4096}) / 2 * 2;
  std::size_t zeros[2] = {0, 0};
  for (std::size_t i = 0; i < looked_at; ++i) zeros[i % 2] += bytes[i] == '\0' ? 1 : 0;
  for (const int place : {0, 1}) {
    if (looked_at >= 4 && zeros[place] * 10 > looked_at * 4 && zeros[1 - place] == 0) return place;
  }
  return std::nullopt;
}

}  // namespace

bool Line::says(std::string_view words) const {
  const auto same = [](char c, char capital) { return std::toupper(static_cast<unsigned char>(c)) == capital; };
  return std::search(text.begin(), text.end(), words.begin(), words.end(), same) != text.end();
}

std::nullopt_t RecordErrors::error(int line, int column, const std::string& message) {
  if (!full()) diagnostics_.error({file_, line, column}, message);
  ++count_;
  return std::nullopt;
}

std::string decoded(std::string bytes) {
  if (bytes.compare(0, 3, "\xEF\xBB\xBF") == 0) bytes.erase(0, 3);
  const auto zeros = zero_bytes(bytes);
  if (!zeros) return bytes;
  std::string text;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const auto high = static_cast<unsigned char>(bytes[i + static_cast<std::size_t>(*zeros)]);
    const auto low = static_cast<unsigned char>(bytes[i + static_cast<std::size_t>(1 - *zeros)]);
    if (i == 0 && high == 0xFE && low == 0xFF) continue;  // the mark
    const char letter = base_letter(static_cast<char32_t>(high << 8 | low));
    text += high == 0 && low < 0x80 ? static_cast<char>(low) : letter == '\0' ? '?' : letter;
  }
  return text;
}

std::vector<Line> lines_of(std::string_view text) {
  while (!text.empty() && (text.back() == '\x1A' || text.back() == '\0')) text.remove_suffix(1);
  std::vector<Line> lines;
  int number = 1;
  while (!text.empty() && lines.size() <= most_lines) {
    const std::size_t end = text.find_first_of("\r\n");
    lines.push_back({text.substr(0, end), number++});
    if (end == std::string_view::npos) break;
    text.remove_prefix(text.compare(end, 2, "\r\n") == 0 ? end + 2 : end + 1);
  }
  return lines;
}

std::vector<Token> words_of(const Line& line, std::string_view separators) {
  std::vector<Token> words;
  std::size_t at = 0;
  while ((at = line.text.find_first_not_of(separators, at)) != std::string_view::npos) {
    const std::size_t end = std::min(line.text.find_first_of(separators, at), line.text.size());
    words.push_back({line.text.substr(at, end - at), line.number, static_cast<int>(at) + 1});
    at = end;
  }
  return words;
}

std::vector<Token> fields_of(const Line& line, std::size_t width) {
  std::vector<Token> fields;
  const std::size_t end = line.text.find_last_not_of(" \t") + 1;  // 0 for a blank line
  for (std::size_t at = 0; at < end; at += width) {
    const std::string_view field = line.text.substr(at, std::min(width, end - at));
    const std::size_t blanks = std::min(field.find_first_not_of(' '), field.size());
    fields.push_back({trimmed(field), line.number, static_cast<int>(at + blanks) + 1});
  }
  return fields;
}

std::size_t field_width(std::string_view text) {
  const std::string letters = upper(text);
  for (std::size_t i = letters.rfind(')'); i != std::string::npos && i > 0; --i) {
    if (letters[i] == '(') break;
    if (std::string_view("FEGID").find(letters[i]) == std::string_view::npos || !is_digit(letters[i + 1])) continue;
    std::size_t width = 0;
    std::from_chars(letters.data() + i + 1, letters.data() + letters.size(), width);
    return width <= 80 ? width : 0;
  }
  return 0;
}

bool is_count(std::optional<double> count) {
  return count && *count >= 1 && *count <= 1e9 && *count == std::floor(*count);
}

std::optional<double> number_of(std::string_view text, bool decimal_comma) {
  std::string number(text.substr(0, 64));
  if (text.size() > 64 || number.empty()) return std::nullopt;
  if (number.front() == '+') {
    number.erase(0, 1);
    if (number.empty() || number.front() == '-') return std::nullopt;
  }
  for (char& c : number) {
    if (c == 'd' || c == 'D') c = 'E';
    if (c == ',' && decimal_comma) c = '.';
  }
  double value = 0;
  const auto [end, failure] = from_chars(number.data(), number.data() + number.size(), value);
  if (end != number.data() + number.size()) return std::nullopt;
  if (failure == std::errc::result_out_of_range) {  // 1e-400 is zero, 1e400 is beyond any double
    const std::size_t exponent = number.find_first_of("eE");
    const bool tiny = exponent != std::string::npos && number.find('-', exponent) != std::string::npos;
    return tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  if (failure != std::errc()) return std::nullopt;
  return value;
}

std::optional<double> number_after(std::string_view text, std::string_view key) {
  const std::size_t at = text.find(key);
  if (at == std::string_view::npos) return std::nullopt;
  text.remove_prefix(at + key.size());
  const std::size_t first = text.find_first_not_of(" \t:=,");
  if (first == std::string_view::npos) return std::nullopt;
  text.remove_prefix(first);
  std::size_t size = std::min(text.find_first_not_of("+-.0123456789eEdD"), text.size());
  while (size > 0) {  // "30SEC" is 30, "0.5e" a half
    if (const auto value = number_of(text.substr(0, size))) return value;
    --size;
  }
  return std::nullopt;
}

std::string shown(std::string_view text) {
  std::string result = "\"";
  for (const char c : text.substr(0, 30)) result += c >= 0x20 && c < 0x7F ? c : '?';
  return result + (text.size() > 30 ? "...\"" : "\"");
}

std::optional<double> finite_number(const Token& token, bool decimal_comma, RecordErrors& errors) {
  const auto value = number_of(token.text, decimal_comma);
  if (!value) return errors.error(token, shown(token.text) + " is not a number");
  if (!std::isfinite(*value)) return errors.error(token, shown(token.text) + " is not a finite number");
  return value;
}

std::vector<double> read_numbers(std::span<const Line> lines, std::size_t width, RecordErrors& errors) {
  const auto has = [&](char mark) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const Line& line) { return line.text.find(mark) != std::string_view::npos; });
  };
  const bool decimal_comma = has(',') && !has('.');
  std::vector<double> values;
  const auto add = [&](const Token& cell) {
    if (const auto value = finite_number(cell, decimal_comma, errors)) values.push_back(*value);
  };
  for (const Line& line : lines) {
    if (errors.full()) break;
    for (const Token& cell : width > 0 ? fields_of(line, width) : words_of(line)) {
      const auto pieces = width > 0 ? std::vector<Token>() : touching_numbers(cell);
      if (pieces.empty()) add(cell);
      for (const Token& piece : pieces) add(piece);
    }
  }
  return values;
}

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

std::string single_spaced(std::string_view text, std::string_view without) {
  std::string result;
  for (const Token& word : words_of({text, 0})) {
    if (upper(word.text) != without) result += (result.empty() ? "" : " ") + std::string(word.text);
  }
  return result;
}

std::optional<FileUnit> file_unit(std::string_view spelling) {
  std::string plain;
  for (const char c : folded(spelling)) {
    if (c != ' ' && c != '.' && c != '^' && c != '*') plain += c;
  }
  static const std::map<std::string, FileUnit> known = [] {
    std::map<std::string, FileUnit> all = {{"G", {"g"}},        {"GS", {"g"}},        {"G'S", {"g"}},
                                           {"GAL", {"cm/s2"}},  {"GALS", {"cm/s2"}},  {"GALES", {"cm/s2"}},
                                           {"MG", {"g", 1e-3}}, {"G/10", {"g", 0.1}}, {"%G", {"g", 0.01}}};
    for (const auto& [length, unit] : {std::pair("M", "m/s2"), std::pair("CM", "cm/s2"), std::pair("CMS", "cm/s2"),
                                       std::pair("MM", "mm/s2"), std::pair("IN", "in/s2"), std::pair("FT", "ft/s2")}) {
      for (const char* const time :
           {"/S2", "/S/S", "/SEC2", "/SEC/SEC", "/SN2", "/SN/SN", "/SEG2", "/SEG/SEG", "S-2", "S2"}) {
        all[std::string(length) + time] = {unit};
      }
    }
    return all;
  }();
  const auto found = known.find(plain);
  return found == known.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace bentur::records
