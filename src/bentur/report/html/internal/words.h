#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace bentur {

/// Languages a report can be in, by their tags of BCP 47: "en", "id". The first is the default.
[[nodiscard]] std::span<const std::string_view> report_languages();

namespace html {

/// One row of the catalogue: a key, and its text in each of report_languages(). Another language is another column.
struct Entry {
  std::string_view key;
  std::string_view texts[2];
};

/// Every text a report has, the script's included.
[[nodiscard]] std::span<const Entry> catalogue();

/// The catalogue in one language. Texts are plain: whoever puts them into a page escapes them.
class Words {
 public:
  /// @throws InvalidParameter unless there is such a language.
  explicit Words(std::string_view language);

  [[nodiscard]] std::string_view language() const { return report_languages()[column_]; }

  /// @throws InvalidParameter when there is no such key.
  [[nodiscard]] std::string operator()(std::string_view key) const;

  /// The text with each {name} replaced by its value; values are taken as they are, braces included.
  [[nodiscard]] std::string operator()(std::string_view key,
                                       std::initializer_list<std::pair<std::string_view, std::string>> values) const;

  /// key.one for 1, else key.many, with {n}.
  [[nodiscard]] std::string count(std::string_view key, long n) const;

 private:
  std::size_t column_ = 0;
};

}  // namespace html
}  // namespace bentur
