#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "bentur/core/number_text.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/story/judgement_story.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/figures/internal/text_width.h"
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

/// The opening of a contact point over the run, with the instant that the scene shows.
Panel opening_panel(const RunResults& run, const SceneInstant& instant, const FigureOptions& options) {
  FigureOptions there = options;
  if (instant.point) {
    const ContactPoint& point = run.problem.points[*instant.point];
    there.gap = static_cast<std::size_t>(point.gap);
    there.elevation = point.elevation;
  }
  Panel panel = opening_figure(run, there).panels.front();
  panel.events = {};
  panel.curves.resize(1);
  if (instant.point) {
    panel.rules.front().label = word(options, "closed at 0");
    panel.rules.front().line = Line::dash_dot;  // the curve is solid
  }
  panel.rules.push_back({.at = instant.histories->time[instant.column],
                         .vertical = true,
                         .label = word(options, !instant.point   ? "deepest inside"
                                                : instant.impact ? "hardest impact"
                                                                 : "where they come closest"),
                         .tone = Tone::red,
                         .line = Line::dotted});
  panel.x.label = word(options, "Time t [s]");
  panel.height = 3.6;
  panel.curves.push_back({.x = {instant.time},
                          .y = {instant.point ? instant.histories->opening(*instant.point, instant.column)
                                              : instant.nearest->least_opening},
                          .tone = Tone::red,
                          .line = Line::none,
                          .mark = Mark::disc});
  return panel;
}

/// A gap that is given or needed [length]; NaN: not known.
struct GapBar {
  const char* name;
  double value = 0;
  Tone tone = Tone::grey;
  bool is_hollow = false;
};

/// Where it falls short the most: given, needed, and, where that is known of some gap, needed the other way round.
std::vector<GapBar> bars_of(const GapFacts& facts) {
  const GoverningNeed found = governing_need(facts).value_or(GoverningNeed{});
  const auto needed = [](const char* name, const GoverningNeed::OneWay& one, bool is_hollow) {
    return GapBar{name, one.needed.value_or(NAN), one.is_short ? Tone::red : Tone::black, is_hollow};
  };
  return {{"given", found.at.width}, needed("needed", found.given, false), needed("reversed", found.reversed, true)};
}

/// From 0 on, `thick` in places of the axis of names; nothing of what is not known.
void add_bar(Panel& panel, const GapBar& of, double place, double thick) {
  if (std::isnan(of.value)) return;
  panel.curves.push_back(of.is_hollow ? hollow_bar(0, of.value, place, thick, of.tone)
                                      : bar(0, of.value, place, thick, of.tone));
}

/// Each bar by its name and value, the given gap uppermost.
void add_one_gap(Panel& panel, const RunResults& run, const FigureOptions& options) {
  const GapFacts facts = judged_gaps(run).front().facts;
  const std::vector<GapBar> bars = bars_of(facts);
  std::vector<double> values;
  for (const GapBar& one : bars) values.push_back(one.value);
  const std::vector<std::string> numbers = column(values);  // with digits alike
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const std::size_t at = bars.size() - 1 - k;
    const GapBar& one = bars[at];
    const std::string value =
        std::isnan(one.value) ? word(options, "not known") : numbers[at] + " " + run.c.units.length;
    panel.y.names.push_back(word(options, one.name) + ": " + value);
    add_bar(panel, one, static_cast<double>(k), 0.6);
  }
  const std::optional<GoverningNeed> found = governing_need(facts);
  if (found && (found->given.needed || found->reversed.needed)) {
    panel.title = word(options, "needed at level {}", shown_value(run, found->at.elevation, "L"));
  }
  panel.height = 1.8;
}

/// Gaps by the names of their buildings, the leftmost uppermost; of many those that the verdict names first.
void add_gaps(Panel& panel, const RunResults& run, const FigureOptions& options) {
  constexpr std::size_t most = 5;
  const std::vector<JudgedGap> judged = judged_gaps(run);
  std::vector<std::size_t> gaps = worst_first(judged);
  gaps.resize(std::min(judged.size(), most));
  std::sort(gaps.begin(), gaps.end(), std::greater<>());
  std::vector<std::string> told;  // what of the three is known of some gap
  for (std::size_t place = 0; place < gaps.size(); ++place) {
    const std::vector<GapBar> bars = bars_of(judged[gaps[place]].facts);
    const std::string unknown = std::isnan(bars[1].value) ? ": " + word(options, "not known") : "";
    constexpr double longest = 1.5;  // of a name [cm]
    const auto name = [&](std::size_t b) { return cut_to(run.problem.buildings[b].name, longest); };
    panel.y.names.push_back(name(gaps[place]) + " | " + name(gaps[place] + 1) + unknown);
    told.resize(bars.size());
    for (std::size_t k = 0; k < bars.size(); ++k) {
      add_bar(panel, bars[k], static_cast<double>(place) + 0.27 * (1 - static_cast<double>(k)), 0.22);
      if (!std::isnan(bars[k].value)) told[k] = word(options, bars[k].name);
    }
  }
  std::erase(told, "");
  panel.title = word(options, "from above: {}", fmt::format("{}", fmt::join(told, ", ")));
  if (judged.size() > most)
    panel.title += "; " + word(options, "the most critical of {} gaps", std::to_string(judged.size()));
  panel.height = 0.3 + 0.6 * static_cast<double>(gaps.size());
}

/// Given against needed gaps.
Panel gap_panel(const RunResults& run, const FigureOptions& options) {
  Panel panel{.x = {.label = with_unit(word(options, "Gap w"), run.c.units.length), .from = 0}};
  run.problem.buildings.size() == 2 ? add_one_gap(panel, run, options) : add_gaps(panel, run, options);
  return panel;
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
  figure.panels.push_back(scene_panel(run, instant, options, is_wide ? 7 : 0.65 * options.width));
  constexpr double longish = 2;  // width over height
  const double aspect = aspect_of(figure.panels.front());
  if (instant.point || asked_inside(run, options) != nullptr)
    figure.panels.push_back(opening_panel(run, instant, options));
  figure.panels.push_back(gap_panel(run, options));
  if (is_wide && aspect > longish && figure.panels.size() > 2) {  // as broad as the page, the others below it
    figure.panels.front().across = 2;
    figure.panels.front().height = 3.4;
    for (std::size_t below : {1, 2}) figure.panels[below].height = 2;
  } else if (is_wide) {
    constexpr double height = 7, frames = 12.5;  // about [cm]
    const double left = std::clamp(height * aspect, 4.5, 8.0);
    figure.panels.front().rows = static_cast<int>(figure.panels.size()) - 1;
    figure.shares = {left, frames - left};
  }
  return figure;
}

}  // namespace bentur
