#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bentur/report/html/internal/markup.h"
#include "bentur/report/words.h"

namespace bentur::html {

/// What a page shows of each of several things, under its name. Of many it is an appendix: folded away, each by itself;
/// on paper, unless it is open, tables of all of them stand for it.
class EachOf {
 public:
  static constexpr std::size_t most_open = 6;

  /// @param are_given parts of the case: on paper what is alike in all is said once, and no column is left out
  explicit EachOf(bool are_given = false) : are_given_(are_given) {}

  /// @param printed what stands for it on paper; of each thing as many tables
  /// @param of its name there; empty: the same
  void add(const std::string& name, Html content, const std::vector<HtmlTable>& printed = {},
           const std::string& of = {});
  /// @param what key of the text that counts them, "89 gaps, each by itself"; its ".printed", where there is one,
  /// heads what is on paper, its ".paper" says what paper lacks
  [[nodiscard]] Html markup(const Words& say, std::string_view what) const;
  /// The same of what others say in short: of few each is folded away, too, but for paper.
  [[nodiscard]] Html folded(const Words& say, std::string_view what) const;

 private:
  bool are_given_;
  std::vector<std::pair<std::string, Html>> all_;
  std::vector<HtmlTable> printed_;  ///< of all
};

/// The text that counts the parts of a case under a key, for EachOf.
[[nodiscard]] std::string entries_key(const Words& say, std::string_view key);

}  // namespace bentur::html
