#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bentur/report/html/internal/markup.h"
#include "bentur/report/words.h"

namespace bentur::html {

/// What a page shows of each of several things, under its name. Of many it is an appendix: folded away, each by itself,
/// and on paper only where it is open.
class EachOf {
 public:
  static constexpr std::size_t most_open = 6;

  void add(std::string name, Html content) { all_.emplace_back(std::move(name), std::move(content)); }
  /// @param what key of the text that counts them: "89 gaps, each by itself"
  [[nodiscard]] Html markup(const Words& say, std::string_view what) const;
  /// The same of what others say in short: of few each is folded away, too, but for paper.
  [[nodiscard]] Html folded(const Words& say, std::string_view what) const;

 private:
  std::vector<std::pair<std::string, Html>> all_;
};

}  // namespace bentur::html
