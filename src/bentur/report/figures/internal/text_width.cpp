#include "bentur/report/figures/internal/text_width.h"

#include <cstddef>

#include "bentur/report/utf8.h"

namespace bentur {
namespace {

// Advance dejavu_widths of DejaVu Sans, thousandths of its size, from the space on.
constexpr int dejavu_widths[] = {318,  401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337,
                                 636,  636, 636, 636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531,
                                 1000, 684, 686, 698, 770, 632, 575, 775, 752, 295, 295, 656, 557, 863, 748, 787,
                                 603,  787, 695, 635, 611, 732, 684, 989, 685, 611, 685, 390, 337, 390, 838, 500,
                                 500,  613, 635, 550, 635, 615, 352, 635, 634, 278, 278, 579, 278, 974, 634, 612,
                                 635,  635, 411, 521, 392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838};
constexpr double letter_size = 8 * 2.54 / 72;  // [cm]

double letter_width(const Utf8Character& one) {
  constexpr int first = 0x20, count = sizeof dejavu_widths / sizeof *dejavu_widths;
  if (one.code >= first && one.code < first + count) return dejavu_widths[one.code - first] * 1e-3 * letter_size;
  const bool raised =
      (one.code >= 0x2070 && one.code <= 0x209C) || one.code == 0xB2 || one.code == 0xB3 || one.code == 0xB9;
  if (raised) return 0.53 * letter_size;
  if (one.code == 0x2026) return letter_size;  // the ellipsis
  if (one.code == 0xB7) return 0.318 * letter_size;
  return static_cast<double>(display_width(one.bytes)) * (one.code >= 0x2100 ? 0.84 : 0.69) * letter_size;
}

}  // namespace

double text_width(std::string_view text) {
  double width = 0;
  for (const Utf8Character& one : characters(text)) width += letter_width(one);
  return width;
}

std::string cut_to(const std::string& text, double width) {
  if (text_width(text) <= width) return text;
  std::string kept;
  double taken = letter_size;  // of the ellipsis
  for (const Utf8Character& one : characters(text)) {
    taken += letter_width(one);
    if (taken > width) break;
    kept += one.bytes;
  }
  return kept + "…";
}

}  // namespace bentur
