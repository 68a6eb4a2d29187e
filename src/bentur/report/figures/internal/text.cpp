#include "bentur/report/figures/internal/text.h"

#include <fmt/format.h>

#include <sstream>

namespace bentur {

std::string plain_text(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool control = byte < 0x20 || byte == 0x7F;
    // U+0080 … U+009F, line and paragraph separators, U+FFFE and U+FFFF
    const std::string_view three = text.substr(i, 3);
    if (byte == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0) {
      result += ' ';
      i += 1;
    } else if (three == "\xE2\x80\xA8" || three == "\xE2\x80\xA9" || three == "\xEF\xBF\xBE" ||
               three == "\xEF\xBF\xBF") {
      result += ' ';
      i += 2;
    } else {
      result += control ? ' ' : text[i];
    }
  }
  for (std::size_t at = 0; (at = result.find("]]>", at)) != std::string::npos;) result.insert(at + 2, " ");
  return result;
}

std::string gnuplot_string(std::string_view text) {
  std::string result = "'";
  for (const char c : plain_text(text)) {
    if (c == '\'') {
      result += R"('."\047".')";
    } else {
      result += c;
    }
  }
  return result + "'";
}

std::size_t length_of(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) count += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
  return count;
}

std::string cut(const std::string& text, std::size_t most) {
  if (length_of(text) <= most) return text;
  std::size_t end = 0;
  for (std::size_t count = 0; end < text.size(); ++end) {
    if ((static_cast<unsigned char>(text[end]) & 0xC0U) != 0x80U && count++ == most - 1) break;
  }
  return text.substr(0, end) + "…";
}

std::string unit_text(const std::string& udunits) {
  std::istringstream words(udunits == "1" ? "–" : udunits);
  std::string above, below;
  for (std::string word; words >> word;) {
    if (word == "1000") {
      words >> word;
      if (word == "kgf") {
        word = "tf";
      } else {
        word.insert(0, "1000 ");
      }
    }
    if (word == "gravity") word = "g";
    const std::size_t minus = word.find('-');
    if (minus == std::string::npos) {
      above += (above.empty() ? "" : "·") + word;
    } else {
      const std::string power = word.substr(minus + 1);
      below += (below.empty() ? "" : "·") + word.substr(0, minus) + (power == "2" ? "²" : power == "3" ? "³" : "");
    }
  }
  if (below.empty()) return above;
  return (above.empty() ? "1" : above) + "/" + below;
}

std::string with_unit(const std::string& label, const std::string& unit) { return label + " [" + unit + "]"; }

std::string number_text(double value) { return fmt::format("{:.4g}", value); }

}  // namespace bentur
