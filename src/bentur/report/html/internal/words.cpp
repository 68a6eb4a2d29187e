#include "bentur/report/html/internal/words.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

constexpr std::array<std::string_view, 2> languages = {"en", "id"};

}  // namespace

std::span<const std::string_view> report_languages() { return languages; }

namespace html {

Words::Words(std::string_view language) {
  const auto* const found = std::find(languages.begin(), languages.end(), language);
  if (found == languages.end()) throw InvalidParameter("lang", std::string(language), "must be en or id");
  column_ = static_cast<std::size_t>(found - languages.begin());
}

std::string Words::operator()(std::string_view key) const {
  const auto entries = catalogue();
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.key == key; });
  if (found == entries.end()) throw InvalidParameter("key", std::string(key), "is not in the catalogue");
  return std::string(found->texts[column_]);
}

std::string Words::operator()(std::string_view key,
                              std::initializer_list<std::pair<std::string_view, std::string>> values) const {
  const std::string text = (*this)(key);
  std::string filled;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = text.find('{', at);
    const std::size_t close = text.find('}', std::min(open, text.size()));
    filled += text.substr(at, open - at);
    if (open == std::string::npos || close == std::string::npos) break;
    const std::string name = text.substr(open + 1, close - open - 1);
    const auto* const value =
        std::find_if(values.begin(), values.end(), [&](const auto& given) { return given.first == name; });
    if (value == values.end()) throw InvalidParameter(std::string(key), name, "has no value");
    filled += value->second;
    at = close + 1;
  }
  return filled;
}

std::string Words::count(std::string_view key, long n) const {
  return (*this)(std::string(key) + (n == 1 ? ".one" : ".many"), {{"n", std::to_string(n)}});
}

}  // namespace html
}  // namespace bentur
