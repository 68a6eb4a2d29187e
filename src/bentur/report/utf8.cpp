#include "bentur/report/utf8.h"

#include <utf8proc.h>

namespace bentur {

std::vector<Utf8Character> characters(std::string_view text) {
  std::vector<Utf8Character> list;
  while (!text.empty()) {
    Utf8Character one;
    const auto* const bytes = reinterpret_cast<const utf8proc_uint8_t*>(text.data());
    const utf8proc_ssize_t length = utf8proc_iterate(bytes, static_cast<utf8proc_ssize_t>(text.size()), &one.code);
    one.bytes = text.substr(0, length > 0 ? static_cast<std::size_t>(length) : 1);
    text.remove_prefix(one.bytes.size());
    list.push_back(one);
  }
  return list;
}

std::size_t display_width(std::string_view text) {
  std::size_t width = 0;
  for (const Utf8Character& one : characters(text)) {
    width += one.code < 0 ? 1 : static_cast<std::size_t>(utf8proc_charwidth(one.code));
  }
  return width;
}

}  // namespace bentur
