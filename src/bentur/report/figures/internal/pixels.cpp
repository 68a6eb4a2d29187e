#include "bentur/report/figures/internal/pixels.h"

#include <cmath>
#include <cstdlib>
#include <iterator>

namespace bentur {

// By whole numbers: most of the time of a figure goes into these, in WebAssembly even more so.
void add_length(std::string& text, double pixels) {
  constexpr double far = 1e5;
  const long hundredths = std::lrint(100 * std::fmin(std::fmax(pixels, -far), far));
  long rest = std::labs(hundredths);
  char digits[16];  // from the last one on
  char* first = std::end(digits);
  const auto take = [&] {
    *--first = static_cast<char>('0' + rest % 10);
    rest /= 10;
  };
  const bool is_whole = rest % 100 == 0;
  const int decimals = is_whole ? 0 : rest % 10 == 0 ? 1 : 2;
  for (int skipped = decimals; skipped < 2; ++skipped) rest /= 10;
  for (int k = 0; k < decimals; ++k) take();
  if (!is_whole) *--first = '.';
  do take();
  while (rest > 0);
  if (hundredths < 0) *--first = '-';
  text.append(first, std::end(digits));
}

std::string length(double pixels) {
  std::string text;
  add_length(text, pixels);
  return text;
}

}  // namespace bentur
