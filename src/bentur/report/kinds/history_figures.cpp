#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_data.h"

namespace bentur {
namespace {

constexpr const char* time_label = "Time t [s]";

struct Window {
  double from = 0, to = 0;
};

/// What the user asks for, within the histories.
Window window(const RunData& run, const FigureOptions& options) {
  const Window asked{options.from.value_or(run.time.front()), options.to.value_or(run.time.back())};
  if (!(asked.from < asked.to) || asked.from > run.time.back() || asked.to < run.time.front()) {
    throw NoFigure(fmt::format("the histories run from {} s to {} s, and --from must lie before --to",
                               number_text(run.time.front()), number_text(run.time.back())));
  }
  // Ten digits are left to tell two numbers of the axis apart.
  if (!(asked.to - asked.from > 1e-6 * std::max(std::abs(asked.from), std::abs(asked.to)))) {
    throw NoFigure("--from and --to lie too near to one another for an axis");
  }
  return asked;
}

/// Some vibrations around the hardest impact of the point, or the moment it is nearest to one.
Window around_the_hardest(const RunData& run, std::size_t point) {
  const auto period = [&](std::size_t b) { return run.buildings[b].periods.empty() ? 0 : run.buildings[b].periods[0]; };
  const std::size_t left = run.points[point].left;
  const double unit = std::max({period(left), period(left + 1), 1e-6 * run.time.back()});
  double centre = 0;
  if (const RunData::Impact* impact = run.hardest(point)) {
    centre = impact->peak_force > 0 ? impact->peak_force_time : impact->start;
  } else {
    const std::vector<double> opening = run.history("opening", point);
    const auto closest = std::min_element(opening.begin(), opening.end());
    centre = run.time[static_cast<std::size_t>(closest - opening.begin())];
  }
  // Ends on tenths of its length, so that the axis has round numbers.
  const double length = 8 * unit;
  const double grid = std::pow(10.0, std::floor(std::log10(length)) - 1);
  Window near{grid * std::round((centre - 3 * unit) / grid), 0};
  near.from = std::max(near.from, run.time.front());
  near.to = std::min(near.from + grid * std::ceil(length / grid), run.time.back());
  return near;
}

/// The part of a curve within a window, with one point more at either side.
Curve within(const Curve& whole, const Window& window) {
  Curve part = whole;
  const auto first = std::lower_bound(whole.x.begin(), whole.x.end(), window.from);
  const auto last = std::upper_bound(whole.x.begin(), whole.x.end(), window.to);
  const auto begin = first == whole.x.begin() ? 0 : first - whole.x.begin() - 1;
  const auto end = last == whole.x.end() ? last - whole.x.begin() : last - whole.x.begin() + 1;
  part.x.assign(whole.x.begin() + begin, whole.x.begin() + end);
  part.y.assign(whole.y.begin() + begin, whole.y.begin() + end);
  return part;
}

Events contacts(const RunData& run, std::size_t point, const Window& window) {
  Events events{"contact", {}};
  for (const RunData::Impact& impact : run.impacts) {
    if (impact.point == point && impact.start >= window.from && impact.start <= window.to) {
      events.x.push_back(impact.start);
    }
  }
  return events;
}

/// A panel over the whole run and, where that is long, another over its hardest moments; or one over the window asked
/// for.
Figure histories(const RunData& run, const FigureOptions& options, std::size_t point, const std::string& label,
                 const std::vector<Curve>& curves, const std::vector<Rule>& rules, bool mark_contacts) {
  Figure figure{.width = options.width, .shared_legend = true};
  const auto add = [&](const std::string& title, const Window& window, bool last) {
    Panel panel{.title = title,
                .x = {.label = last ? time_label : "", .from = window.from, .to = window.to},
                .y = {.label = label},
                .height = 3.4,
                .rules = rules};
    for (const Curve& curve : curves) panel.curves.push_back(within(curve, window));
    if (mark_contacts) panel.events = contacts(run, point, window);
    figure.panels.push_back(std::move(panel));
  };
  const Window asked = window(run, options);
  const Window near = around_the_hardest(run, point);
  const bool two = !options.from && !options.to && near.to - near.from < 0.5 * (asked.to - asked.from);
  add("", asked, !two);
  if (two) add(run.hardest(point) != nullptr ? "around the hardest impact" : "where they come closest", near, true);
  return figure;
}

}  // namespace

Figure displacement_figure(const RunData& run, const FigureOptions& options) {
  const std::size_t i = run.point(options);
  const RunData::Point& point = run.points[i];
  const auto curve = [&](std::size_t building, std::size_t floor) {
    return Curve{.label = run.buildings[building].name,
                 .x = run.time,
                 .y = run.history(fmt::format("displacement_{}", building + 1), floor)};
  };
  Curve right = curve(point.left + 1, point.right_floor);
  right.tone = Tone::orange;
  Figure figure = histories(run, options, i, with_unit("Displacement x", run.length),
                            {curve(point.left, point.left_floor), right}, {}, true);
  figure.title = "Displacements relative to the bases, " + run.point_name(i);
  return figure;
}

Figure opening_figure(const RunData& run, const FigureOptions& options) {
  const std::size_t i = run.point(options);
  const Curve opening{.label = "opening", .x = run.time, .y = run.history("opening", i)};
  const Rule closed{.at = 0, .tone = Tone::grey};
  const Rule rest{.at = run.points[i].width, .label = "at rest", .tone = Tone::grey, .line = Line::dashed};
  Figure figure = histories(run, options, i, with_unit("Opening g", run.length), {opening}, {closed, rest}, true);
  figure.title = "Opening of the gap, " + run.point_name(i);
  return figure;
}

Figure force_figure(const RunData& run, const FigureOptions& options) {
  const std::size_t i = run.point(options);
  if (const RunData::Impact* hardest = run.hardest(i); hardest == nullptr || !(hardest->peak_force > 0)) {
    throw NoFigure("no contact force at " + run.point_name(i));
  }
  // Impacts are far shorter than a sample: each is drawn through its start, its peak and its end.
  Curve force{.x = {run.time.front()}, .y = {0}};
  for (const RunData::Impact& impact : run.impacts) {
    if (impact.point != i) continue;
    for (const auto& [x, y] : {std::pair{impact.start, 0.0}, std::pair{impact.peak_force_time, impact.peak_force},
                               std::pair{impact.end, 0.0}}) {
      force.x.push_back(std::max(x, force.x.back()));
      force.y.push_back(y);
    }
  }
  force.x.push_back(run.time.back());
  force.y.push_back(0);
  Figure figure = histories(run, options, i, with_unit("Contact force F", run.force), {force}, {}, false);
  for (Panel& panel : figure.panels) panel.y.from = 0;
  figure.title = "Contact force, impacts by start, peak and end, " + run.point_name(i);
  return figure;
}

Figure energy_figure(const RunData& run, const FigureOptions& options) {
  if (run.results.find("energy_input") == nullptr) {
    throw NoFigure("the run kept no energies: analysis.energy_audit = true in its case does");
  }
  const Window asked = window(run, options);
  const auto curve = [&](std::initializer_list<const char*> parts, Curve sum) {
    sum.x = run.time;
    sum.y.assign(run.time.size(), 0.0);
    for (const char* part : parts) {
      const std::vector<double> values = run.results.numbers(std::string("energy_") + part);
      std::transform(values.begin(), values.end(), sum.y.begin(), sum.y.begin(), std::plus<>());
    }
    return within(sum, asked);
  };
  const Panel panel{
      .x = {.label = time_label, .from = asked.from, .to = asked.to},
      .y = {.label = with_unit("Energy E", unit_text(run.results.at("energy_input").units))},
      .height = 5,
      .curves = {curve({"input"}, {.label = "input", .width = 1.2}),
                 curve({"kinetic", "strain"}, {.label = "kinetic + strain", .tone = Tone::orange}),
                 curve({"damping"}, {.label = "damping", .tone = Tone::grey, .line = Line::dashed, .width = 1.4}),
                 curve({"contact_stored", "contact_lost"},
                       {.label = "contact", .tone = Tone::blue, .line = Line::dash_dot, .width = 1.2})}};
  return {.title = "Where the energy is, of all buildings together", .panels = {panel}, .width = options.width};
}

}  // namespace bentur
