#include "text/display_width.h"

#include <utf8proc.h>

#include "bentur/report/utf8.h"

namespace bentur::cli {

std::size_t display_width(std::string_view text) {
  std::size_t width = 0;
  for (const Utf8Character& one : characters(text)) {
    width += one.code < 0 ? 1 : static_cast<std::size_t>(utf8proc_charwidth(one.code));
  }
  return width;
}

}  // namespace bentur::cli
