#pragma once

#include <string>
#include <vector>

#include "bentur/report/html/internal/markup.h"
#include "bentur/report/html/internal/words.h"
#include "bentur/report/html/report.h"

namespace bentur::html {

/// A whole page with the style of reports and, where asked for, their script. Its Content-Security-Policy
/// lets it fetch nothing and run no other script.
[[nodiscard]] std::string page(const Words& say, const std::string& title, const Html& body, bool with_script);

/// The figures, or why there are none.
[[nodiscard]] Html figures_section(const Words& say, const std::vector<ReportFigure>& figures);

}  // namespace bentur::html
