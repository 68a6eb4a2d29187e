#include "bentur/report/figures/internal/text_width.h"

#include <unordered_map>

#include "bentur/report/utf8.h"

namespace bentur {
namespace {

constexpr double letter_size = 8 * 2.54 / 72;  // [cm]

// Advance widths by code in thousandths of the font's size, written as tools/font_metrics.py says.
constexpr std::int32_t dejavu_sans[] = {
#include "bentur/report/figures/internal/dejavu_sans.inc"
};

/// Width over size of each character of the font.
const std::unordered_map<std::int32_t, double>& widths() {
  static const auto known = [] {
    std::unordered_map<std::int32_t, double> all;
    std::int32_t code = 0;
    for (const std::int32_t number : dejavu_sans) {
      if (number < 0) {
        code = -number;
      } else {
        all[code++] = number * 1e-3;
      }
    }
    return all;
  }();
  return known;
}

double letter_width(std::int32_t code) {
  if (const auto small = small_letter(code)) return small_size * text_width(small->common);
  const auto known = widths().find(code);
  return (known == widths().end() ? 1 : known->second) * letter_size;
}

}  // namespace

bool is_in_font(std::int32_t code) { return widths().count(code) > 0; }

std::optional<SmallLetter> small_letter(std::int32_t code) {
  constexpr std::int32_t raised_0 = 0x2070, raised_minus = 0x207B, lowered_0 = 0x2080;
  constexpr std::string_view digits = "0123456789";
  const auto small = [&](std::int32_t digit, bool is_raised) {
    return SmallLetter{digits.substr(static_cast<std::size_t>(digit), 1), is_raised};
  };
  if (code >= lowered_0 && code <= lowered_0 + 9) return small(code - lowered_0, false);
  if (code == raised_0 || (code >= raised_0 + 4 && code <= raised_0 + 9)) return small(code - raised_0, true);
  if (code == 0xB9) return small(1, true);
  if (code == 0xB2 || code == 0xB3) return small(code - 0xB0, true);
  if (code == raised_minus) return SmallLetter{"−", true};
  return {};
}

double text_width(std::string_view text) {
  double width = 0;
  for (const Utf8Character& one : characters(text)) width += letter_width(one.code);
  return width;
}

std::string cut_to(const std::string& text, double width) {
  if (text_width(text) <= width) return text;
  std::string kept;
  double taken = letter_width(0x2026);  // the ellipsis
  for (const Utf8Character& one : characters(text)) {
    taken += letter_width(one.code);
    if (taken > width) break;
    kept += one.bytes;
  }
  return kept + "…";
}

}  // namespace bentur
