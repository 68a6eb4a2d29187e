#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bentur/report/figures/figure.h"

namespace bentur {

/// Languages a report can be in, by their tags of BCP 47: "en", "id". The first is the default.
[[nodiscard]] const std::vector<std::string>& report_languages();

/// A text for people in each language, by its tag.
using Texts = std::map<std::string, std::string>;

/// What texts.toml has under a key; null where it has none. Each is read when it is first asked for, as a run needs few
/// of them and reading all takes longer than a short run. May serve many threads.
[[nodiscard]] const Texts* catalogue_entry(std::string_view key);
/// The keys of all texts that begin so, in their order.
[[nodiscard]] std::vector<std::string> text_keys(std::string_view prefix = "");

/// The catalogue in one language. Texts are plain: whoever puts them into a page escapes them.
class Words {
 public:
  /// @throws InvalidParameter unless there is such a language.
  explicit Words(std::string_view language);

  [[nodiscard]] const std::string& language() const { return language_; }
  /// Its place among report_languages(), as tables of quantities count languages.
  [[nodiscard]] std::size_t number() const;

  [[nodiscard]] bool has(std::string_view key) const;

  /// @throws InvalidParameter when there is no such key.
  [[nodiscard]] std::string operator()(std::string_view key) const;

  /// The text with each {name} replaced by its value, and each {name:has|have} by the first of the two where the value
  /// is 1, else by the second; values are taken as they are, braces included.
  /// @throws InvalidParameter also when a value is missing.
  [[nodiscard]] std::string operator()(std::string_view key,
                                       std::initializer_list<std::pair<const char*, std::string>> values) const;
  [[nodiscard]] std::string operator()(std::string_view key,
                                       const std::vector<std::pair<std::string, std::string>>& values) const;

  /// key.one for 1, else key.many, with {n}.
  [[nodiscard]] std::string count(std::string_view key, long n) const;

 private:
  std::string language_;
};

/// The key of the text below a figure of a kind, of buildings in plan or of a row.
[[nodiscard]] std::string caption_key(const std::string& kind, bool in_plan);
/// The title of a figure in that language, which is the first sentence of the text of its key where there is one; in
/// English its own, which says more.
[[nodiscard]] std::string figure_title(const std::string& language, const std::string& key, std::string english);

/// The texts of figures in that language, given the English ones; what is not in the catalogue, such as a name, as it
/// is.
[[nodiscard]] FigureWords figure_words(const std::string& language);

}  // namespace bentur
