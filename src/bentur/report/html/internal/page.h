#pragma once

#include <string>
#include <vector>

#include "bentur/report/html/internal/markup.h"
#include "bentur/report/html/internal/page_figures.h"
#include "bentur/report/html/report.h"
#include "bentur/report/words.h"

namespace bentur::html {

/// What stands on a page: its header, its sections under a list of them, and what comes after.
struct PageBody {
  Html header;
  std::vector<PageSection> sections;
  Html footer = {};
  std::string running_head = {};  ///< of printed pages; empty: the title. One to hand in has numbers and contents too
};

/// A whole page with the style of reports and, where asked for, their script. Its Content-Security-Policy
/// lets it fetch nothing and have no script and no style but these, which it names by their hashes.
[[nodiscard]] std::string page(const Words& say, const std::string& title, const PageBody& body, bool with_script);

/// The figures, or why there are none.
[[nodiscard]] PageSection figures_section(const Words& say, const std::vector<PageFigure>& figures);

}  // namespace bentur::html
