#include "bentur/report/studies/remedy_figure.h"

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/studies/sweep_data.h"
#include "bentur/report/words.h"

namespace bentur {
namespace {

/// What is sought, in words where the catalogue has some.
std::string objective_text(const std::string& quantity, const FigureOptions& options) {
  if (quantity == "gap_needed") return word(options, "Gap needed");
  for (const SweepKind& kind : sweep_kinds()) {
    if (kind.quantity == quantity) return word(options, kind.label);
  }
  std::string text = quantity;
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

/// "damping", "damping, stiffness": what is chosen, without identifiers.
std::string parameter_text(const std::string& name) {
  std::string text = name;
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

/// One choice, marked: what was found.
Curve found_mark(const RemedyTrial& trial, bool is_single, std::string label, Mark mark) {
  return {.label = std::move(label),
          .x = {is_single ? trial.values.front() : 100 * trial.size},
          .y = {trial.objective},
          .tone = Tone::teal,
          .line = Line::none,
          .mark = mark,
          .complete = true,
          .mark_size = 2.2};
}

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
  Panel panel{
      .x = {.label = is_single ? with_unit(parameter_text(first.name), unit_text(first.unit))
                               : with_unit(word(options, "Size of the remedy, part of its ranges"), "%")},
      .y = {.label = with_unit(objective_text(search.spec().objective, options), unit_text(search.unit)), .from = 0},
      .height = 5.5};
  if (is_single) panel.x.logarithmic = first.range.log;
  panel.curves = {std::move(choices), std::move(front)};
  const RemedyTrial *const best = search.best(), *const smallest = search.smallest();
  if (smallest != nullptr) {
    panel.curves.push_back(
        found_mark(*smallest, is_single, word(options, "smallest that keeps the limit"), Mark::diamond));
  }
  if (best != nullptr && best != smallest) {
    panel.curves.push_back(found_mark(*best, is_single, word(options, "least of all"), Mark::circle));
  }
  if (search.spec().limit) {
    panel.rules.push_back(
        {.at = *search.spec().limit, .label = word(options, "limit"), .tone = Tone::red, .line = Line::dashed});
  }
  return {.title = figure_title(options.language, "figure.remedy", "What a remedy gives for its size"),
          .finding = word(options, "least {} of {} choices", number(search.best()->objective),
                          std::to_string(search.trials.size())),
          .panels = {std::move(panel)},
          .width = options.width};
}

}  // namespace bentur
