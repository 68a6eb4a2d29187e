#include <algorithm>
#include <cmath>

#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/report/kinds/internal/gap_panel.h"
#include "bentur/report/kinds/internal/scene_panel.h"
#include "bentur/report/story_text.h"

namespace bentur {
namespace {

/// The first sentence of the verdict.
std::string first_finding(const RunResults& run, const FigureOptions& options) {
  const std::vector<SaidStatement> all = said(run_story(run).statements, Words(options.language));
  const SaidStatement& first = all.front();
  const bool is_row = run.problem.buildings.size() > 2;
  return (is_row && first.gap ? gap_name(run.problem, *first.gap) + ": " : "") + first.text;
}

/// Whose opening is drawn: a contact point's, or that of a floor inside what it faces.
struct OpeningPlace {
  std::optional<Eigen::Index> point = {};
  const NearestFloor* inside = nullptr;
};

/// Where the instant is of, but the level of the bars where the opening is known there, so that both are of one level.
OpeningPlace opening_place(const RunResults& run, const SceneInstant& instant, const std::vector<JudgedGap>& judged,
                           const FigureOptions& options) {
  const NearestFloor* const nearest = run.figures.nearest ? &*run.figures.nearest : nullptr;
  const bool is_inside = nearest != nullptr && nearest->closes && !nearest->time.empty();
  if (instant.point && !options.elevation) {
    const Eigen::Index gap = run.problem.points[*instant.point].gap;
    const FacingLevel at = governing_need(judged[gap].facts).value_or(GoverningNeed{}).at;
    if (at.is_point) return {.point = at.index};
    if (is_inside && nearest->watched == at.index) return {.inside = nearest};
  }
  return {instant.point, instant.nearest != nullptr && is_inside ? nearest : nullptr};
}

double opening_at(const SceneInstant& instant, const OpeningPlace& place) {
  if (place.point) return instant.histories->opening(*place.point, instant.column);
  const NearestFloor& inside = *place.inside;
  if (instant.nearest != nullptr) return inside.least_opening;
  const auto behind = std::lower_bound(inside.time.begin(), inside.time.end(), instant.time);
  return inside.opening[std::min<std::size_t>(behind - inside.time.begin(), inside.time.size() - 1)];
}

/// The opening of that place over the run, with the instant that the scene shows.
Panel opening_panel(const RunResults& run, const SceneInstant& instant, const OpeningPlace& place,
                    const FigureOptions& options) {
  FigureOptions there = options;
  if (place.point) {
    const ContactPoint& point = run.problem.points[*place.point];
    there.gap = static_cast<std::size_t>(point.gap);
    there.elevation = point.elevation;
  }
  Panel panel = (place.point ? opening_figure(run, there) : inside_opening(run, *place.inside, there)).panels.front();
  panel.events = {};
  panel.curves.resize(1);
  panel.curves.front().in_legend = false;  // the axis says it
  panel.rules.front().label = word(options, "closed at 0");
  panel.rules.front().line = Line::dash_dot;  // the curve is solid
  panel.rules.push_back({.at = instant.histories->time[instant.column],
                         .vertical = true,
                         .label = word(options, !instant.point   ? "deepest inside"
                                                : instant.impact ? "hardest impact"
                                                                 : "where they come closest"),
                         .tone = Tone::red,
                         .line = Line::dotted});
  panel.x.label = word(options, "Time t [s]");
  panel.height = 3.2;
  panel.curves.push_back({.x = {instant.time},
                          .y = {opening_at(instant, place)},
                          .tone = Tone::red,
                          .line = Line::none,
                          .mark = Mark::disc});
  return panel;
}

/// The opening of the worst gap, where that has one over time, below that of the gap which is hit hardest.
void add_opening_of_worst(const RunResults& run, Figure& figure, const FigureOptions& of_worst) {
  try {
    const SceneInstant instant = chosen_instant(run, of_worst);
    figure.panels.push_back(opening_panel(run, instant, {.point = instant.point}, of_worst));
  } catch (const NoFigure&) {
    return;
  }
  for (const std::size_t one : {1, 2}) figure.panels[one].height = 2.4;
}

/// Width over height of what a picture shows.
double aspect_of(const Panel& panel) {
  double left = INFINITY, right = -left;
  for (const Curve& curve : panel.curves) {
    for (const double x : curve.x) {
      left = std::min(left, std::isnan(x) ? left : x);
      right = std::max(right, std::isnan(x) ? right : x);
    }
  }
  return (right - left) / (*panel.y.to - *panel.y.from);
}

}  // namespace

Figure overview_figure(const RunResults& run, const FigureOptions& options) {
  const SceneInstant instant = chosen_instant(run, options);
  constexpr double wide = 12;  // [cm]
  const bool is_wide = options.width >= wide;
  Figure figure{.title = "The buildings where they meet, the opening of the gap, and the gap that is needed",
                .finding = first_finding(run, options),
                .columns = is_wide ? 2 : 1,
                .width = options.width};
  figure.panels.push_back(scene_panel(run, instant, options, is_wide ? 6 : 0.65 * options.width));
  constexpr double longish = 2;  // width over height
  const double aspect = aspect_of(figure.panels.front());
  const std::vector<JudgedGap> judged = judged_gaps(run);
  if (const OpeningPlace place = opening_place(run, instant, judged, options); place.point || place.inside != nullptr)
    figure.panels.push_back(opening_panel(run, instant, place, options));
  if (instant.point && !options.gap && !options.elevation) {
    const auto gap = static_cast<std::size_t>(run.problem.points[*instant.point].gap);
    if (const std::optional<std::size_t> worst = worst_besides(judged, gap))
      add_opening_of_worst(run, figure, options_of_worst(judged[*worst], *worst, options));
  }
  const bool has_both = figure.panels.size() + 1 > overview_panels;
  figure.panels.push_back(gap_panel(judged, run.c, options));
  if (is_wide && aspect > longish && figure.panels.size() > 2) {  // as broad as the page, the others below it
    figure.panels.front().across = 2;
    figure.panels.front().height = 3.2;
    for (std::size_t below : {1, 2}) figure.panels[below].height = 2.2;
    if (has_both) figure.panels.back().across = 2;
  } else if (is_wide) {
    constexpr double height = 6, frames = 12.5;  // about [cm]
    const double left = std::clamp(height * aspect, 4.5, 8.0);
    figure.panels.front().rows = static_cast<int>(figure.panels.size()) - 1;
    figure.shares = {left, frames - left};
  }
  for (std::size_t i = 1; i + 1 < figure.panels.size(); ++i) name_rules_at_ends(figure.panels[i]);
  return figure;
}

}  // namespace bentur
