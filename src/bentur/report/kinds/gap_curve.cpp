#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"

namespace bentur {

Figure gap_curve_figure(const GapCurve& curve, const FigureOptions& options) {
  const auto panel = [&](const std::string& label, const std::vector<double>& values) {
    Panel one{.y = {.label = label, .from = 0}};
    one.curves.push_back({.x = curve.widths, .y = values, .mark = Mark::disc, .width = 0.7, .complete = true});
    if (curve.needed) {
      one.rules.push_back({.at = *curve.needed, .vertical = true, .label = word(options, "gap needed")});
    }
    one.rules.push_back(
        {.at = curve.given, .vertical = true, .label = word(options, "gap as it is"), .line = Line::dashed});
    return one;
  };
  Panel force = panel(with_unit(word(options, "Peak contact force F"), curve.force_unit), curve.forces);
  force.title = curve.name;
  force.x.numbers = false;
  Panel amplification = panel(word(options, "Largest amplification"), curve.amplifications);
  amplification.y.from.reset();
  amplification.rules.push_back({.at = 1, .line = Line::dotted});
  amplification.x.label = with_unit(word(options, "Gap w"), curve.length);
  // Both panels end where the wider of them does.
  double most = curve.needed ? std::max(curve.given, *curve.needed) : curve.given;
  for (const double width : curve.widths) most = std::max(most, width);
  for (Panel* one : {&force, &amplification}) one->x.from = 0, one->x.to = most, one->height = 3;
  const auto hardest = std::max_element(curve.forces.begin(), curve.forces.end());
  Figure figure{.title = "Peak force and largest amplification against the gap",
                .panels = {force, amplification},
                .width = options.width,
                .shared_legend = true};
  if (hardest != curve.forces.end() && *hardest > 0) {
    const double width = curve.widths[static_cast<std::size_t>(hardest - curve.forces.begin())];
    figure.finding = fmt::format("{} {} {}, {}", word(options, "Peak contact force F"), number_text(*hardest),
                                 curve.force_unit, word(options, "gap {}", number_text(width) + " " + curve.length));
  }
  return figure;
}

}  // namespace bentur
