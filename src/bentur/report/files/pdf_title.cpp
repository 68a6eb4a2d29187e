#include "bentur/report/files/pdf_title.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdlib>

#include "bentur/report/utf8.h"

namespace bentur {
namespace {

/// A text as a string of a PDF: UTF-16 with its mark, in hexadecimal digits.
std::string text_string(std::string_view text) {
  constexpr std::int32_t beyond = 0x10000, replacement = 0xFFFD;
  std::string digits = "<FEFF";
  for (const Utf8Character& one : characters(text)) {
    const std::int32_t code = one.code < 0 ? replacement : one.code;
    if (code < beyond) {
      digits += fmt::format("{:04X}", code);
    } else {
      digits += fmt::format("{:04X}{:04X}", 0xD800 + ((code - beyond) >> 10), 0xDC00 + ((code - beyond) & 0x3FF));
    }
  }
  return digits + ">";
}

/// The number behind a key from `from` on; −1: there is none.
long number_after(const std::string& pdf, const std::string& key, std::size_t from) {
  const std::size_t at = pdf.find(key, from);
  return at == std::string::npos ? -1 : std::strtol(pdf.c_str() + at + key.size(), nullptr, 10);
}

}  // namespace

std::string with_title(std::string pdf, std::string_view title) {
  const std::size_t trailer = pdf.rfind("\ntrailer");
  if (title.empty() || trailer == std::string::npos) return pdf;
  const long size = number_after(pdf, "/Size ", trailer), root = number_after(pdf, "/Root ", trailer);
  const long info = number_after(pdf, "/Info ", trailer), table = number_after(pdf, "startxref", trailer);
  if (size < 0 || root < 0 || info < 0 || table < 0) return pdf;
  const std::string name = fmt::format("{} 0 obj\n", info);
  const std::size_t begin = pdf.find("\n" + name + "<<"), end = pdf.find("\nendobj", begin);
  if (begin == std::string::npos || end == std::string::npos) return pdf;
  const std::size_t inside = begin + 1 + name.size() + 2;
  const std::string others = pdf.substr(inside, end - inside);
  if (!pdf.ends_with('\n')) pdf += '\n';
  const std::size_t object = pdf.size();
  pdf += fmt::format("{}<< /Title {}\n  {}\nendobj\n", name, text_string(title), others);
  const std::size_t update = pdf.size();
  pdf += fmt::format(
      "xref\n{} 1\n{:010} 00000 n \ntrailer\n<< /Size {}\n   /Root {} 0 R\n   /Info {} 0 R\n   /Prev {}\n>>\n"
      "startxref\n{}\n%%EOF\n",
      info, object, size, root, info, table, update);
  return pdf;
}

}  // namespace bentur
