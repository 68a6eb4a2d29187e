#include "bentur/report/utf8.h"

#include <boost/locale/utf.hpp>
#include <map>

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

std::string markup_text(std::string_view text) {
  static const std::map<std::int32_t, std::string_view> references = {{'&', "&amp;"},  {'<', "&lt;"},   {'>', "&gt;"},
                                                                      {'"', "&quot;"}, {'\'', "&#39;"}, {'`', "&#96;"}};
  constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD
  std::string markup;
  for (const auto& [bytes, code] : characters(text)) {
    const auto reference = references.find(code);
    const bool is_control = (code < 0x20 && code != '\n' && code != '\t') || code == 0x7F;
    markup += reference != references.end() ? reference->second : is_control ? replacement : bytes;
  }
  return markup;
}

}  // namespace bentur
