// The characters of a text without utf8proc, which is there for the machine alone: by Boost's headers. Widths of
// columns are of figures and terminals, which a page has none of.
#include "bentur/report/utf8.h"

#include <boost/locale/utf.hpp>

namespace bentur {

std::vector<Utf8Character> characters(std::string_view text) {
  using Utf8 = boost::locale::utf::utf_traits<char>;
  std::vector<Utf8Character> list;
  while (!text.empty()) {
    const char* at = text.data();
    const boost::locale::utf::code_point code = Utf8::decode(at, text.data() + text.size());
    const bool known = boost::locale::utf::is_valid_codepoint(code);
    Utf8Character one;
    one.code = known ? static_cast<decltype(one.code)>(code) : -1;
    one.bytes = text.substr(0, known ? static_cast<std::size_t>(at - text.data()) : 1);
    text.remove_prefix(one.bytes.size());
    list.push_back(one);
  }
  return list;
}

}  // namespace bentur
