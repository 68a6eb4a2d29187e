#include "bentur/report/kinds/internal/history_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/figures/internal/text.h"

namespace bentur {
namespace {

/// Of a window: an impact that is shorter is less than a hair's breadth of a panel.
constexpr double seen = 1.0 / 600;

/// Appends an impact whose course is not known, and too short to be seen: when it starts, its peak, and when it ends.
void append_short(const Impact& impact, Curve& force) {
  const auto add = [&](double x, double y) {
    force.x.push_back(std::max(x, force.x.empty() ? x : force.x.back()));
    force.y.push_back(y);
  };
  add(impact.start, 0);
  add(impact.peak_force_time, impact.peak_force);
  add(impact.end, 0);
}

bool is_within(const HistoryPlace& place, const TimeWindow& window, const Impact& impact) {
  return impact.point == place.point && impact.peak_force > 0 && impact.end >= window.from && impact.start <= window.to;
}

}  // namespace

const Impact* hardest_impact(const HistoryPlace& place) {
  const Impact* found = nullptr;
  for (const Impact& impact : *place.impacts) {
    const bool here = impact.point == place.point;
    if (here && (found == nullptr || is_harder(impact, *found))) found = &impact;
  }
  return found;
}

std::vector<double> row_of(const Eigen::MatrixXd& table, Eigen::Index row) {
  const auto values = table.row(row);
  return {values.begin(), values.end()};
}

TimeWindow asked_window(const HistoryPlace& place, const FigureOptions& options) {
  const auto [begin, end] = place.whole;
  const TimeWindow asked{options.from.value_or(begin), options.to.value_or(end)};
  if (!(asked.from < asked.to) || asked.from > place.samples.to || asked.to < place.samples.from) {
    throw NoFigure(fmt::format("the histories run from {} s to {} s, and --from must lie before --to",
                               number(place.samples.from), number(place.samples.to)));
  }
  // Ten digits are left to tell two numbers of the axis apart.
  if (!(asked.to - asked.from > 1e-6 * std::max(std::abs(asked.from), std::abs(asked.to)))) {
    throw NoFigure("--from and --to lie too near to one another for an axis");
  }
  return {std::max(asked.from, begin), std::min(asked.to, end)};
}

TimeWindow around_the_hardest(const HistoryPlace& place) {
  const double unit = std::max(place.period, 1e-6 * place.samples.to);
  double centre = place.closest, length = 8 * unit;
  if (const Impact* impact = hardest_impact(place)) {
    centre = (impact->start + impact->end) / 2;
    const double course = 4 * (impact->end - impact->start);
    length = place.of_force && course > 0 ? course : std::max(2.5 * unit, course);
  }
  // Ends on tenths of its length, so that the axis has round numbers.
  const double grid = std::pow(10.0, std::floor(std::log10(length)) - 1);
  const auto on_grid = [&](double count) { return grid < 1 ? count / std::round(1 / grid) : count * grid; };
  const double first = std::round((centre - 0.45 * length) / grid);
  TimeWindow near{on_grid(first), 0};
  near.from = std::max(near.from, place.samples.from);
  near.to = std::min(on_grid(first + std::ceil(length / grid)), place.samples.to);
  return near;
}

bool has_two_windows(const HistoryPlace& place, const FigureOptions& options) {
  const TimeWindow near = around_the_hardest(place);
  return !options.from && !options.to && near.to - near.from < 0.5 * (place.whole.to - place.whole.from);
}

Curve within(const Curve& whole, const TimeWindow& window) {
  Curve part = whole;
  const auto first = std::lower_bound(whole.x.begin(), whole.x.end(), window.from);
  const auto last = std::upper_bound(whole.x.begin(), whole.x.end(), window.to);
  const auto begin = first == whole.x.begin() ? 0 : first - whole.x.begin() - 1;
  const auto end = last == whole.x.end() ? last - whole.x.begin() : last - whole.x.begin() + 1;
  part.x.assign(whole.x.begin() + begin, whole.x.begin() + end);
  part.y.assign(whole.y.begin() + begin, whole.y.begin() + end);
  return part;
}

Curve sparse(Curve path, double distance) {
  std::size_t kept = 0;
  for (std::size_t i = 1; i < path.x.size(); ++i) {
    if (std::hypot(path.x[i] - path.x[kept], path.y[i] - path.y[kept]) < distance) continue;
    ++kept;
    path.x[kept] = path.x[i];
    path.y[kept] = path.y[i];
  }
  path.x.resize(kept + 1);
  path.y.resize(kept + 1);
  return path;
}

Events contacts_within(const HistoryPlace& place, const TimeWindow& window, const FigureOptions& options) {
  constexpr std::size_t most = 100;
  std::vector<double> all, apart;
  for (const Impact& impact : *place.impacts) {
    if (impact.point != place.point || impact.start < window.from || impact.start > window.to) continue;
    all.push_back(impact.start);
    if (apart.empty() || impact.start - apart.back() >= (window.to - window.from) / most) apart.push_back(all.back());
  }
  Events events{word(options, "contact"), all.size() > most ? apart : all};
  return events;
}

Curve force_curve(const HistoryPlace& place, const std::vector<double>& time, const std::vector<double>& force,
                  const TimeWindow& window) {
  Curve curve{.x = {window.from}, .y = {0}, .complete = true};
  for (const Impact& impact : *place.impacts) {
    if (!is_within(place, window, impact)) continue;
    const double length = impact.end - impact.start;
    if (time.empty() || length == 0) {
      append_short(impact, curve);
      continue;
    }
    const double slack = 1e-9 * length;
    const auto first = std::lower_bound(time.begin(), time.end(), impact.start - slack);
    const auto last = std::upper_bound(first, time.end(), impact.end + slack);
    curve.x.push_back(impact.start);
    curve.y.push_back(0);
    bool has_peak = false;  // which stands between two places of the course, or at one but for round-off
    for (auto at = first; at != last; ++at) {
      if (!has_peak && *at >= impact.peak_force_time) {
        curve.x.push_back(impact.peak_force_time);
        curve.y.push_back(impact.peak_force);
        has_peak = true;
      }
      curve.x.push_back(std::clamp(*at, impact.start, impact.end));
      curve.y.push_back(force[at - time.begin()]);
    }
    curve.x.push_back(impact.end);
    curve.y.push_back(impact.open_ended ? curve.y.back() : 0);
  }
  curve.x.push_back(std::max(window.to, curve.x.back()));
  curve.y.push_back(0);
  return curve;
}

std::optional<Curve> force_peaks(const HistoryPlace& place, const TimeWindow& window, bool has_course) {
  constexpr std::size_t most = 130;  // two pixels each in a journal's column
  Curve peaks{.line = Line::none, .mark = Mark::disc, .complete = true};
  bool lacks = false;
  for (const Impact& impact : *place.impacts) {
    if (!is_within(place, window, impact)) continue;
    lacks = lacks || (!has_course && impact.end - impact.start >= seen * (window.to - window.from));
    if (impact.peak_force_time < window.from || impact.peak_force_time > window.to) continue;
    peaks.x.push_back(impact.peak_force_time);
    peaks.y.push_back(impact.peak_force);
  }
  const bool alone = !peaks.x.empty() && (lacks || peaks.x.size() > most);
  return alone ? std::optional(std::move(peaks)) : std::nullopt;
}

std::pair<double, double> range_of(const std::vector<Curve>& curves, const TimeWindow& window) {
  std::pair<double, double> range{0, 0};
  for (const Curve& curve : curves) {
    const Curve part = within(curve, window);
    const auto [least, most] = std::minmax_element(part.y.begin(), part.y.end());
    range = {std::min(range.first, *least), std::max(range.second, *most)};
  }
  range.second += events_height * (range.second - range.first);
  return range;
}

Figure history_figure(const HistoryPlace& place, const FigureOptions& options, const std::vector<Curve>& curves,
                      const HistoryPanels& with) {
  constexpr double height = 3.4;
  constexpr double height_of_part = 2;
  Figure figure{.width = options.width, .shared_legend = true};
  const TimeWindow asked = asked_window(place, options);
  const TimeWindow near = around_the_hardest(place);
  const bool two = has_two_windows(place, options), in_parts = two && !with.label_of_parts.empty();
  const auto add = [&](const std::string& title, const TimeWindow& window, const std::vector<Curve>& shown) -> Panel& {
    Panel panel{.title = title,
                .x = {.from = window.from, .to = window.to},
                .y = {.label = with.label},
                .height = height,
                .rules = with.rules};
    for (const Curve& curve : shown) panel.curves.push_back(within(curve, window));
    if (with.mark_contacts) panel.events = contacts_within(place, window, options);
    return figure.panels.emplace_back(std::move(panel));
  };
  if (in_parts) {
    for (const Curve& curve : curves) {  // many vibrations of one would hide those of the other
      Panel& part = add((figure.panels.empty() ? place.title + ": " : "") + curve.label, asked, {curve});
      part.height = height_of_part;
      part.y.label = with.label_of_parts;
      part.curves.front().line = Line::solid;  // alone; the legend has the line that tells it from the other
      part.curves.front().in_legend = false;
      part.y.least = range_of(curves, asked);
      part.x.numbers = &curve == &curves.back();
      if (figure.panels.size() > 1) part.events = {};
    }
  } else {
    add(place.title, asked, curves);
  }
  if (two) {
    for (Panel& panel : figure.panels) {
      for (Curve& curve : panel.curves) curve.width = width_over_time;
    }
    const bool hit = hardest_impact(place) != nullptr;
    add(word(options, hit ? "around the hardest impact" : "where they come closest"), near, curves);
  }
  figure.panels.back().x.label = word(options, "Time t [s]");
  return figure;
}

Figure force_history_figure(const HistoryPlace& place, const FigureOptions& options, const std::vector<double>& time,
                            const std::vector<double>& force, const std::string& label, double factor) {
  HistoryPlace of_force = place;
  of_force.of_force = true;
  Figure figure = history_figure(of_force, options, {Curve{}}, {.label = label});
  for (Panel& panel : figure.panels) {
    const TimeWindow shown{*panel.x.from, *panel.x.to};
    const std::optional<Curve> peaks = force_peaks(place, shown, !time.empty());
    panel.curves = {peaks ? *peaks : force_curve(place, time, force, shown)};
    if (peaks) panel.curves.front().label = word(options, "peak of each impact");
    std::vector<double>& forces = panel.curves.front().y;
    for (double& one : forces) one *= factor;
    const auto [least, most] = std::minmax_element(forces.begin(), forces.end());
    if (*least >= -round_off * *most) panel.y.from = 0;
    const double above = 1 / (1 - 0.5 / panel.height);  // room for the number at the peak
    panel.y.least = {0, above * *most};
    constexpr std::size_t most_stems = 12;
    if (const Curve marks = panel.curves.front(); peaks && marks.x.size() <= most_stems) {
      Curve stems{.label = word(options, "peak of each impact"), .complete = true, .in_legend = false};
      for (std::size_t i = 0; i < marks.x.size(); ++i) {
        stems.x.insert(stems.x.end(), {marks.x[i], marks.x[i], not_known});
        stems.y.insert(stems.y.end(), {0, marks.y[i], not_known});
        if (marks.y[i] < *most)
          panel.texts.push_back({marks.x[i], marks.y[i], number(marks.y[i]), PlaceText::Side::above});
      }
      panel.curves.push_back(std::move(stems));
    }
  }
  const auto shows_one_mark = [](const Panel& panel) {
    const Curve& curve = panel.curves.front();
    return curve.line == Line::none && curve.x.size() == 1;
  };
  if (figure.panels.size() > 1 && shows_one_mark(figure.panels.back())) {  // which the first has as well
    figure.panels.front().x.label = figure.panels.back().x.label;
    figure.panels.pop_back();
  }
  return figure;
}

void name_value(std::vector<Panel>& panels, double x, double y, const std::string& text) {
  const auto shows = [&](const Panel& panel) { return x >= *panel.x.from && x <= *panel.x.to; };
  const auto found = std::find_if(panels.rbegin(), panels.rend(), shows);
  if (found == panels.rend()) return;
  constexpr double edge = 0.15;  // of the panel, where a value in the middle has no room
  const double part = (x - *found->x.from) / (*found->x.to - *found->x.from);
  found->texts.push_back({x, y, signed_text(text),
                          part < edge       ? PlaceText::Side::right
                          : part > 1 - edge ? PlaceText::Side::left
                                            : PlaceText::Side::above});
}

void add_peak(Curve& samples, double peak) {
  const auto& [x, y] = std::tie(samples.x, samples.y);
  const auto size = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto largest = std::max_element(y.begin(), y.end(), size);
  if (largest == y.end() || !(peak > std::abs(*largest))) return;
  double furthest = 0, instant = 0;
  std::size_t place = 0;  // of the sample before it
  for (std::size_t i = 1; i + 1 < y.size(); ++i) {
    const double sign = y[i] < 0 ? -1 : 1, before = sign * y[i - 1], at = sign * y[i], after = sign * y[i + 1];
    const double bend = 2 * at - before - after;
    if (at < before || at < after || !(bend > 0)) continue;
    const double part = (after - before) / (2 * bend);  // of a step, from −1/2 to 1/2
    const double vertex = at + (after - before) * part / 4;
    if (vertex <= furthest) continue;
    furthest = vertex;
    instant = x[i] + part * (part < 0 ? x[i] - x[i - 1] : x[i + 1] - x[i]);
    place = part < 0 ? i - 1 : i;
  }
  if (furthest == 0) return;
  const double signed_peak = y[place] + y[place + 1] < 0 ? -peak : peak;
  const auto behind = static_cast<std::ptrdiff_t>(place) + 1;
  samples.x.insert(samples.x.begin() + behind, instant);
  samples.y.insert(samples.y.begin() + behind, signed_peak);
}

Curve finer(const Curve& samples, const std::vector<double>& rates, const TimeWindow& window) {
  if (rates.size() != samples.x.size()) return samples;
  constexpr double points = 400;  // over the window
  const double most = (window.to - window.from) / points;
  Curve fine = samples;
  fine.x.clear();
  fine.y.clear();
  for (std::size_t i = 0; i < samples.x.size(); ++i) {
    fine.x.push_back(samples.x[i]);
    fine.y.push_back(samples.y[i]);
    if (i + 1 == samples.x.size() || samples.x[i + 1] < window.from || samples.x[i] > window.to) continue;
    const double from = samples.y[i], to = samples.y[i + 1], step = samples.x[i + 1] - samples.x[i];
    const double first = step * rates[i], last = step * rates[i + 1], parts = std::ceil(step / most);
    for (double k = 1; k < parts; ++k) {
      const double s = k / parts, left = 1 - s;
      fine.x.push_back(samples.x[i] + s * step);
      fine.y.push_back(left * left * ((1 + 2 * s) * from + s * first) + s * s * ((3 - 2 * s) * to - left * last));
    }
  }
  return fine;
}

namespace {

constexpr double wide_value = 0.26;  // of a panel
constexpr double tall_value = 0.57;  // [cm] also where the panel becomes lower, beside others

/// Where a value is written: above or below this place.
struct ValuePlace {
  double x = 0, y = 0;
};

/// Beyond all curves about a place along x, as far as a value is wide, and not before `y`.
ValuePlace beyond_curves(const Panel& panel, double x, double y, double half) {
  const double sign = y > 0 ? 1 : -1;
  ValuePlace place{std::clamp(x, *panel.x.from + half, *panel.x.to - half), sign * y};
  for (const Curve& one : panel.curves) {
    for (std::size_t i = 0; i < one.x.size(); ++i) {
      if (std::abs(one.x[i] - place.x) < half) place.y = std::max(place.y, sign * one.y[i]);
    }
  }
  place.y *= sign;
  return place;
}

/// Beyond a peak and all that goes further near it, beside values that stand there, within the frame.
ValuePlace place_beyond(const Panel& panel, double x, double y) {
  const double half = wide_value / 2 * (*panel.x.to - *panel.x.from);
  ValuePlace place = beyond_curves(panel, x, y, half);
  for (const PlaceText& one : panel.texts) {
    if (one.y * y < 0 || std::abs(one.x - place.x) >= 2 * half) continue;
    const bool has_room = one.x + 3 * half <= *panel.x.to;
    place = beyond_curves(panel, one.x + (has_room ? 2 : -2) * half, y, half);
  }
  return place;
}

}  // namespace

void name_peaks(const std::vector<Panel*>& panels, const std::vector<Curve>& curves,
                const std::function<std::string(double)>& text) {
  for (Panel* const panel : panels) {
    if (!panel->y.least) panel->y.least = range_of(panel->curves, {*panel->x.from, *panel->x.to});
  }
  for (const Curve& curve : curves) {
    const auto size = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto most = std::max_element(curve.y.begin(), curve.y.end(), size);
    if (most == curve.y.end() || *most == 0) continue;
    const double x = curve.x[static_cast<std::size_t>(most - curve.y.begin())], y = *most;
    const auto shows = [&](const Panel* panel) {
      const auto same = [&](const Curve& one) { return one.label == curve.label; };
      return x >= *panel->x.from && x <= *panel->x.to && std::any_of(panel->curves.begin(), panel->curves.end(), same);
    };
    const auto is_free = [&](const Panel* panel) {
      if (!shows(panel)) return false;
      const ValuePlace place = place_beyond(*panel, x, y);
      return place.y == y && std::abs(place.x - x) <= wide_value / 2 * (*panel->x.to - *panel->x.from);
    };
    auto found = std::find_if(panels.rbegin(), panels.rend(), is_free);
    if (found == panels.rend()) found = std::find_if(panels.rbegin(), panels.rend(), shows);
    if (found == panels.rend()) continue;
    Panel& panel = **found;
    const ValuePlace place = place_beyond(panel, x, y);
    const double half = wide_value / 2 * (*panel.x.to - *panel.x.from);
    if (place.y != y || std::abs(place.x - x) > half) {  // led to its peak across what goes further
      panel.curves.push_back({.x = {x, std::clamp(x, place.x - 0.8 * half, place.x + 0.8 * half)},
                              .y = {y, place.y},
                              .tone = curve.tone,
                              .width = 0.7,
                              .complete = true});
    }
    panel.texts.push_back(
        {place.x, place.y, signed_text(text(y)), y > 0 ? PlaceText::Side::above : PlaceText::Side::below});
    auto [low, high] = *panel.y.least;
    const double part = tall_value / panel.height;
    if (y > 0) high = std::max(high, (place.y - part * low) / (1 - part));
    if (y < 0) low = std::min(low, (place.y - part * high) / (1 - part));
    for (Panel* other : panels) {  // at one scale with those of the same time
      if (other->x.from == panel.x.from && other->x.to == panel.x.to) other->y.least = {low, high};
    }
  }
}

Figure energy_history_figure(const EnergyHistories& energy, const TimeWindow& asked, const FigureOptions& options,
                             double factor, const std::string& unit) {
  const auto part = [&](const Eigen::VectorXd& sum, Curve curve) {
    curve.x = energy.time;
    for (const double value : sum) curve.y.push_back(factor * value);
    return within(curve, asked);
  };
  Panel panel{
      .x = {.label = word(options, "Time t [s]"), .from = asked.from, .to = asked.to},
      .y = {.label = with_unit(word(options, "Energy E"), unit)},
      .height = 5,
      .curves = {part(energy.input, {.label = word(options, "input"), .width = 1.2}),
                 part(energy.kinetic + energy.strain, {.label = word(options, "kinetic + strain"), .tone = Tone::teal}),
                 part(energy.damping,
                      {.label = word(options, "damping"), .tone = Tone::grey, .line = Line::dashed, .width = 1.4})},
      .names_at_ends = true};
  const double most = energy.input.cwiseAbs().maxCoeff();
  constexpr double seen_part = 0.01, round_off = 1e-9;  // of the energy that came in
  const bool loses = energy.contact_lost.cwiseAbs().maxCoeff() > round_off * most;
  const bool touches = loses || energy.contact_stored.cwiseAbs().maxCoeff() > seen_part * most;
  if (touches) {
    panel.curves.push_back(
        part(energy.contact_stored + energy.contact_lost,
             {.label = word(options, "contact"), .tone = Tone::red, .line = Line::dash_dot, .width = 1.2}));
  }
  const bool yields = energy.hysteretic.size() > 0 && energy.hysteretic.maxCoeff() > 0;
  if (yields) {
    panel.curves.push_back(
        part(energy.hysteretic,
             {.label = word(options, "yielding"), .tone = Tone::teal, .line = Line::dotted, .width = 1.2}));
  }
  const auto at_end = [&](const Eigen::VectorXd& sum) {
    const double last = sum.size() > 0 ? sum(sum.size() - 1) : 0;
    const bool is_there = std::abs(last) > round_off * most;
    return number(is_there ? factor * last : 0) + " " + unit;
  };
  return {.title = "Where the energy is, of all buildings together",
          .finding = word(options, "at the end {} have come in, damping has taken {}, contact {}", at_end(energy.input),
                          at_end(energy.damping), at_end(energy.contact_stored + energy.contact_lost)) +
                     (yields ? ", " + word(options, "yielding {}", at_end(energy.hysteretic)) : ""),
          .lacks = touches ? "" : "contact",
          .panels = {panel},
          .width = options.width};
}

}  // namespace bentur
