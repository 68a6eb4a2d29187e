#include <algorithm>
#include <optional>
#include <utility>

#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/story/story.h"
#include "bentur/report/kinds/internal/gap_panel.h"
#include "bentur/report/kinds/internal/plan_figures.h"
#include "bentur/report/story_text.h"
#include "bentur/report/words.h"

namespace bentur {
namespace {

/// What the verdict says first of the gap that is shown, behind its name where there are several.
std::string finding_of(const PlanRun& run, std::size_t gap, const FigureOptions& options) {
  const std::vector<std::string> names = gap_names(run.problem);
  for (const SaidStatement& one : said(run_story(run).statements, Words(options.language))) {
    if (one.gap != static_cast<Eigen::Index>(gap)) continue;
    return (names.size() > 1 ? names[gap] + ": " : "") + one.text;
  }
  return {};
}

/// The opening over the run, with the instant that the picture shows.
Panel opening_over_run(const PlanRun& run, const FigureOptions& options) {
  const PlanInstant instant = telling_instant(run.response, asked_points(run, options));
  Panel panel = opening_figure(run, options).panels.front();
  panel.events = {};
  panel.rules.push_back({.at = instant.time,
                         .vertical = true,
                         .label = word(options, instant.impact ? "hardest impact" : "where they come closest"),
                         .tone = Tone::red,
                         .line = Line::dotted});
  panel.x.label = word(options, "Time t [s]");
  panel.x.numbers = true;
  return panel;
}

}  // namespace

Figure overview_figure(const PlanRun& run, const FigureOptions& options) {
  constexpr double wide = 12, height = 6.6, around = 1.4;  // [cm], of titles and axes
  const bool is_wide = options.width >= wide;
  Figure figure = scene_figure(run, options);
  figure.title = "The buildings from above where they meet, the opening of the gap, and the gap that is needed";
  figure.finding = finding_of(run, contact_at(run.problem, chosen_point(run, options)).gap, options);
  const std::vector<JudgedGap> judged = judged_gaps(run);
  Panel gaps = gap_panel(judged, run.c, options);
  std::vector<Panel> openings = {opening_over_run(run, options)};
  const std::optional<std::size_t> worst =
      options.gap || options.elevation ? std::nullopt
                                       : worst_besides(judged, contact_at(run.problem, chosen_point(run, options)).gap);
  if (worst) {
    try {
      openings.push_back(opening_over_run(run, options_of_worst(judged[*worst], *worst, options)));
    } catch (const NoFigure&) {  // no contact is modelled there
    }
  }
  const double count = static_cast<double>(openings.size());
  for (Panel& opening : openings) {
    opening.height = is_wide ? std::max(1.8, (height - gaps.height - around) / count - around * (count - 1)) : 2.4;
    name_rules_at_ends(opening);
  }
  if (is_wide) {
    figure.columns = 2;
    figure.shares = {1.2, 1};
    figure.panels.front().rows = static_cast<int>(openings.size()) + 1;
    figure.panels.front().height = height;
  }
  for (Panel& opening : openings) figure.panels.push_back(std::move(opening));
  figure.panels.push_back(std::move(gaps));
  return figure;
}

}  // namespace bentur
