#include "bentur/io/records/internal/number_cells.h"

#include <algorithm>

namespace bentur::records {
namespace {

constexpr std::size_t least_decimals = 3;  // of fields without signs that touch

bool decimal_digit(char c) { return c >= '0' && c <= '9'; }
bool is_point(char c) { return c == '.' || c == ','; }

std::size_t points_in(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), is_point));
}

/// Adds a piece of a cell, or the pieces it is made of by their decimals; false where it is no number.
bool add_pieces(const Token& cell, std::string_view piece, std::vector<Token>& pieces) {
  const auto add = [&](std::string_view text) {
    pieces.push_back({text, cell.line, cell.column + static_cast<int>(text.data() - cell.text.data())});
    return number_of(text, true).has_value();
  };
  const std::size_t points = points_in(piece);
  if (points == 0) return false;
  if (points == 1) return add(piece);
  const std::size_t decimals = piece.size() - 1 - piece.find_last_of(".,");
  if (decimals < least_decimals || piece.find_first_of("eEdD") != std::string_view::npos) return false;
  while (!piece.empty()) {
    const std::size_t point = piece.find_first_of(".,");
    const std::size_t size = point + 1 + decimals;
    if (point == std::string_view::npos || size > piece.size() || points_in(piece.substr(0, size)) != 1) return false;
    if (!add(piece.substr(0, size))) return false;
    piece.remove_prefix(size);
  }
  return true;
}

/// Two digits, as a number below `end`; -1 where they are none.
int two_digits_at(std::string_view text, std::size_t at, int end) {
  if (at + 2 > text.size() || !decimal_digit(text[at]) || !decimal_digit(text[at + 1])) return -1;
  const int value = 10 * (text[at] - '0') + (text[at + 1] - '0');
  return value < end ? value : -1;
}

/// Days from 1 March of the year 0, by the Gregorian calendar.
long day_number(int year, int month, int day) {
  const int shifted = month > 2 ? year : year - 1;
  const int months = (month + 9) % 12;  // from March
  return 365L * shifted + shifted / 4 - shifted / 100 + shifted / 400 + (153 * months + 2) / 5 + day - 1;
}

}  // namespace

std::vector<Token> touching_numbers(const Token& cell) {
  const std::string_view text = cell.text;
  std::vector<Token> pieces;
  std::size_t from = 0;
  for (std::size_t at = 1; at <= text.size(); ++at) {
    const bool begins = at < text.size() && (text[at] == '-' || text[at] == '+') &&
                        (decimal_digit(text[at - 1]) || is_point(text[at - 1]));
    if (!begins && at < text.size()) continue;
    if (!add_pieces(cell, text.substr(from, at - from), pieces)) return {};
    from = at;
  }
  return pieces.size() < 2 ? std::vector<Token>() : pieces;
}

std::optional<TimeStamp> time_stamp(std::string_view text) {
  TimeStamp stamp;
  std::size_t at = 0;
  if (text.size() >= 10 && (text[4] == '-' || text[4] == '/') && text[7] == text[4]) {
    const int century = two_digits_at(text, 0, 100), years = two_digits_at(text, 2, 100);
    const int month = two_digits_at(text, 5, 13), day = two_digits_at(text, 8, 32);
    if (century < 0 || years < 0 || month < 1 || day < 1) return std::nullopt;
    stamp.day = day_number(100 * century + years, month, day);
    at = text.find_first_not_of(" \tT", 10);
    if (at == std::string_view::npos || at == 10) return std::nullopt;
  }
  const int hour = two_digits_at(text, at, 24), minute = two_digits_at(text, at + 3, 60);
  if (hour < 0 || minute < 0 || text[at + 2] != ':' || at + 5 >= text.size() || text[at + 5] != ':')
    return std::nullopt;
  std::string_view seconds = text.substr(at + 6);
  // The zone is the same in all rows.
  seconds = trimmed(seconds.substr(0, seconds.find_first_of("Z+-")));
  const auto value = number_of(seconds, true);
  if (!value || seconds.empty() || !decimal_digit(seconds[0]) || !(*value < 61)) return std::nullopt;
  stamp.seconds = 3600.0 * hour + 60.0 * minute + *value;
  return stamp;
}

}  // namespace bentur::records
