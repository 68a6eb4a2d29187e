#include <algorithm>

#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/words.h"

namespace bentur {

namespace {

constexpr double share_of_target = 0.9;  // that codes ask of the mean [-]

}  // namespace

Figure suite_figure(const SuiteSpec& suite, const Units& units, const FigureOptions& options) {
  const auto in_g = [&](std::vector<double> values) {
    for (double& value : values) value /= standard_gravity(units.length);
    return values;
  };
  const std::vector<double>& periods = suite.target.periods;
  const auto [first, last] = suite.target.band();
  Panel panel{.x = {.label = word(options, "Period T [s]"), .from = first, .to = last, .logarithmic = true},
              .y = {.label = with_unit("Sa", "g"), .from = 0},
              .height = 5.5,
              .names_at_ends = true};
  for (const SuiteRecord& record : suite.records) {
    panel.curves.push_back({.label = panel.curves.empty() ? word(options, "each record") : "",
                            .x = periods,
                            .y = in_g(record.spectrum),
                            .tone = Tone::grey,
                            .width = 0.6,
                            .of_several = true});
  }
  const std::vector<double> target = in_g(suite.target.ordinates), mean = in_g(suite.mean);
  panel.curves.push_back({.label = word(options, "target"),
                          .x = periods,
                          .y = target,
                          .tone = Tone::teal,
                          .line = Line::dashed,
                          .width = 1.6});
  if (suite.request.is_of_code()) {
    std::vector<double> least = target;
    for (double& value : least) value *= share_of_target;
    panel.curves.push_back({.label = word(options, "0.9 of the target"),
                            .x = periods,
                            .y = least,
                            .tone = Tone::teal,
                            .line = Line::dotted});
  }
  panel.curves.push_back({.label = word(options, "mean"), .x = periods, .y = mean, .width = 1.8});
  for (const SuitePeriods& one : suite.buildings) {
    panel.rules.push_back({.at = one.first, .vertical = true, .line = Line::dotted});
  }
  double least_ratio = mean.front() / target.front();
  for (std::size_t i = 0; i < mean.size(); ++i) least_ratio = std::min(least_ratio, mean[i] / target[i]);
  Figure figure{.title = figure_title(options.language, "figure.suite",
                                      "Spectra of the records as scaled, their mean, and the target, damping ratio "
                                      "0.05"),
                .finding = word(options, "mean at least {} of the target", number(least_ratio)),
                .panels = {panel},
                .width = options.width,
                .shared_legend = true};
  return figure;
}

}  // namespace bentur
