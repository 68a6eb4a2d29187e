#include "bentur/report/studies/remedy_figure.h"

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"

namespace bentur {
namespace {

std::string shown_unit(const std::string& unit) { return unit == "1" ? "–" : unit; }

}  // namespace

Figure remedy_figure(const RemedySearch& search, const FigureOptions& options) {
  constexpr double percent = 100;
  const bool is_single = search.parameters.size() == 1;
  std::vector<std::pair<double, double>> tried;  // size or number, objective
  for (const RemedyTrial& one : search.trials) {
    if (std::isfinite(one.objective))
      tried.emplace_back(is_single ? one.values.front() : percent * one.size, one.objective);
  }
  if (tried.empty()) throw NoFigure("no choice that was tried has a number");
  std::sort(tried.begin(), tried.end());
  Curve choices{
      .label = word(options, "each choice tried"), .tone = Tone::grey, .line = Line::none, .mark = Mark::disc};
  Curve front{.label = word(options, "least of those no larger"), .tone = Tone::teal, .width = 1.6, .complete = true};
  for (const auto& [x, objective] : tried) {
    choices.x.push_back(x);
    choices.y.push_back(objective);
    if (!front.y.empty() && !is_single) {
      front.x.push_back(x);
      front.y.push_back(front.y.back());
    }
    front.x.push_back(x);
    front.y.push_back(is_single || front.y.empty() ? objective : std::min(objective, front.y.back()));
  }
  if (is_single) front.label = "";
  const RemedyParameter& first = search.parameters.front();
  Panel panel{.x = {.label = is_single ? with_unit(first.name, shown_unit(first.unit))
                                       : with_unit(word(options, "Size of the remedy, part of its ranges"), "%")},
              .y = {.label = with_unit(search.spec().objective, shown_unit(search.unit)), .from = 0},
              .height = 5.5};
  if (is_single) panel.x.logarithmic = first.range.log;
  panel.curves = {std::move(choices), std::move(front)};
  if (search.spec().limit) {
    panel.rules.push_back(
        {.at = *search.spec().limit, .label = word(options, "limit"), .tone = Tone::red, .line = Line::dashed});
  }
  return {.title = "What a remedy gives for its size",
          .finding = word(options, "least {} of {} choices", number(search.best()->objective),
                          std::to_string(search.trials.size())),
          .panels = {std::move(panel)},
          .width = options.width};
}

}  // namespace bentur
