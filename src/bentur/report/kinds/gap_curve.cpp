#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/words.h"

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
  const auto hardest = std::max_element(curve.forces.begin(), curve.forces.end());
  const ShownUnits shown = shown_units({.force = curve.force_unit}, hardest == curve.forces.end() ? 0 : *hardest);
  std::vector<double> forces = curve.forces;
  for (double& one : forces) one *= shown.force;
  Panel force = panel(with_unit(word(options, "Peak contact force F"), shown.units.force), forces);
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
  Figure figure{.title = figure_title(options.language, "figure.gap-curve",
                                      "Peak force and largest amplification against the gap"),
                .panels = {force, amplification},
                .width = options.width,
                .shared_legend = true};
  if (hardest != curve.forces.end() && *hardest > 0) {
    const double width = curve.widths[static_cast<std::size_t>(hardest - curve.forces.begin())];
    figure.finding = fmt::format("{} {} {}, {}", word(options, "Peak contact force F"), number(shown.force * *hardest),
                                 shown.units.force, word(options, "gap {}", number(width) + " " + curve.length));
  }
  return figure;
}

}  // namespace bentur
