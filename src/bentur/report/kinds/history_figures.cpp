#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"

namespace bentur {
namespace {

struct Window {
  double from = 0, to = 0;
};

/// A row of a table of histories.
std::vector<double> row_of(const Eigen::MatrixXd& table, Eigen::Index row) {
  const auto values = table.row(row);
  return {values.begin(), values.end()};
}

/// The exact course where it was kept, else samples.
const Histories& course_of(const RunResults& run) {
  return run.response.course.time.empty() ? run.response.histories : run.response.course;
}

/// What the user asks for, within the histories.
Window window(const RunResults& run, const FigureOptions& options) {
  const double begin = run.response.histories.time.front();
  const double end = std::max(run.response.histories.time.back(), course_of(run).time.back());
  const Window asked{options.from.value_or(begin), options.to.value_or(end)};
  if (!(asked.from < asked.to) || asked.from > run.response.histories.time.back() ||
      asked.to < run.response.histories.time.front()) {
    throw NoFigure(fmt::format("the histories run from {} s to {} s, and --from must lie before --to",
                               number(run.response.histories.time.front()),
                               number(run.response.histories.time.back())));
  }
  // Ten digits are left to tell two numbers of the axis apart.
  if (!(asked.to - asked.from > 1e-6 * std::max(std::abs(asked.from), std::abs(asked.to)))) {
    throw NoFigure("--from and --to lie too near to one another for an axis");
  }
  return {std::max(asked.from, begin), std::min(asked.to, end)};
}

struct Moment {
  double time = 0, value = 0;
};

/// Where the faces of a point come nearest to one another; negative where they press.
Moment closest_approach(const RunResults& run, Eigen::Index point) {
  Eigen::Index closest = 0;
  const double opening = course_of(run).opening.row(point).minCoeff(&closest);
  return {course_of(run).time[closest], opening};
}

/// The value of a curve that is largest in size.
Moment largest_of(const Curve& curve) {
  Moment most;
  for (std::size_t i = 0; i < curve.y.size(); ++i) {
    if (i == 0 || std::abs(curve.y[i]) > std::abs(most.value)) most = {curve.x[i], curve.y[i]};
  }
  return most;
}

/// Some vibrations around the hardest impact of the point, or the moment it is nearest to one.
Window around_the_hardest(const RunResults& run, Eigen::Index point) {
  const auto period = [&](Eigen::Index b) { return first_period(run.problem.buildings[b]).value_or(0); };
  const Eigen::Index left = run.problem.points[point].left;
  const double unit = std::max({period(left), period(left + 1), 1e-6 * run.response.histories.time.back()});
  double centre = 0;
  if (const Impact* impact = hardest_impact(run, point)) {
    centre = impact->peak_force > 0 ? impact->peak_force_time : impact->start;
  } else {
    centre = closest_approach(run, point).time;
  }
  // Ends on tenths of its length, so that the axis has round numbers.
  const double length = 8 * unit;
  const double grid = std::pow(10.0, std::floor(std::log10(length)) - 1);
  Window near{grid * std::round((centre - 3 * unit) / grid), 0};
  near.from = std::max(near.from, run.response.histories.time.front());
  near.to = std::min(near.from + grid * std::ceil(length / grid), run.response.histories.time.back());
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

/// The starts of the contacts at a point; of very many those that can be told apart.
Events contacts(const RunResults& run, Eigen::Index point, const Window& window, const FigureOptions& options) {
  constexpr std::size_t most = 100;
  std::vector<double> all, apart;
  for (const Impact& impact : run.response.impacts) {
    if (impact.point != point || impact.start < window.from || impact.start > window.to) continue;
    all.push_back(impact.start);
    if (apart.empty() || impact.start - apart.back() >= (window.to - window.from) / most) apart.push_back(all.back());
  }
  Events events{word(options, "contact"), all.size() > most ? apart : all};
  return events;
}

/// Appends an impact that is too short for its course to be seen: it starts and ends when the impact does, reaches the
/// peak when it does, and the area below is the impulse.
void append_short(const Impact& impact, Curve& force) {
  const auto add = [&](double x, double y) {
    force.x.push_back(std::max(x, force.x.empty() ? x : force.x.back()));
    force.y.push_back(y);
  };
  const double length = impact.end - impact.start;
  const double edge = length > 0 ? 2 * impact.impulse / length - impact.peak_force : 0;          // height at both ends
  const double part = edge >= 0 || !(impact.peak_force > 0) ? 1 : 1 + edge / impact.peak_force;  // of a slender peak
  add(impact.start, 0);
  if (edge > 0) add(impact.start, edge);
  if (edge < 0) add(impact.peak_force_time - part * (impact.peak_force_time - impact.start), 0);
  add(impact.peak_force_time, impact.peak_force);
  if (edge < 0) add(impact.peak_force_time + part * (impact.end - impact.peak_force_time), 0);
  if (edge > 0) add(impact.end, edge);
  add(impact.end, 0);
}

/// The contact force of a point over a window: the course of each impact that is long enough to be seen.
Curve force_curve(const RunResults& run, Eigen::Index point, const Window& window) {
  constexpr double seen = 1.0 / 600;  // of the window: less than a hair's breadth of a panel
  const Histories& course = run.response.course;
  Curve force{.x = {window.from}, .y = {0}, .complete = true};
  for (const Impact& impact : run.response.impacts) {
    if (impact.point != point || !(impact.peak_force > 0)) continue;
    if (impact.end < window.from || impact.start > window.to) continue;
    const double length = impact.end - impact.start;
    if (course.time.empty() || length < seen * (window.to - window.from)) {
      append_short(impact, force);
      continue;
    }
    const double slack = 1e-9 * length;
    const auto first = std::lower_bound(course.time.begin(), course.time.end(), impact.start - slack);
    const auto last = std::upper_bound(first, course.time.end(), impact.end + slack);
    force.x.push_back(impact.start);
    force.y.push_back(0);
    for (auto at = first; at != last; ++at) {
      force.x.push_back(std::clamp(*at, impact.start, impact.end));
      force.y.push_back(course.force(point, at - course.time.begin()));
    }
    force.x.push_back(impact.end);
    force.y.push_back(impact.open_ended ? force.y.back() : 0);
  }
  force.x.push_back(std::max(window.to, force.x.back()));
  force.y.push_back(0);
  return force;
}

/// The peak of each impact, where there are so many that their courses would fill the frame.
std::optional<Curve> force_peaks(const RunResults& run, Eigen::Index point, const Window& window) {
  constexpr std::size_t most = 130;  // two pixels each in a journal's column
  Curve peaks{.line = Line::none, .mark = Mark::disc, .complete = true};
  for (const Impact& impact : run.response.impacts) {
    if (impact.point != point || !(impact.peak_force > 0)) continue;
    if (impact.peak_force_time < window.from || impact.peak_force_time > window.to) continue;
    peaks.x.push_back(impact.peak_force_time);
    peaks.y.push_back(impact.peak_force);
  }
  return peaks.x.size() > most ? std::optional(std::move(peaks)) : std::nullopt;
}

/// What a figure of histories shows besides its curves.
struct HistoryPanels {
  std::string label;             ///< of the y axis
  std::string label_of_parts{};  ///< the same in short; empty: the curves of the whole run stand in one panel
  std::vector<RuleLine> rules{};
  bool mark_contacts = false;
};

/// Room for all curves within a window and for marks above them, so that panels can be compared.
std::pair<double, double> range_of(const std::vector<Curve>& curves, const Window& window) {
  std::pair<double, double> range{0, 0};
  for (const Curve& curve : curves) {
    const Curve part = within(curve, window);
    const auto [least, most] = std::minmax_element(part.y.begin(), part.y.end());
    range = {std::min(range.first, *least), std::max(range.second, *most)};
  }
  range.second += events_height * (range.second - range.first);
  return range;
}

/// A panel over the whole run, or one for each curve, and, where that is long, another over its hardest moments; or one
/// over the window asked for.
Figure histories(const RunResults& run, const FigureOptions& options, Eigen::Index point,
                 const std::vector<Curve>& curves, const HistoryPanels& with) {
  constexpr double height = 3.4;
  constexpr double height_of_part = 2;
  Figure figure{.width = options.width, .shared_legend = true};
  const auto add = [&](const std::string& title, const Window& window, const std::vector<Curve>& shown) -> Panel& {
    Panel panel{.title = title,
                .x = {.from = window.from, .to = window.to},
                .y = {.label = with.label},
                .height = height,
                .rules = with.rules};
    for (const Curve& curve : shown) panel.curves.push_back(within(curve, window));
    if (with.mark_contacts) panel.events = contacts(run, point, window, options);
    return figure.panels.emplace_back(std::move(panel));
  };
  const Window asked = window(run, options);
  const Window near = around_the_hardest(run, point);
  const bool two = !options.from && !options.to && near.to - near.from < 0.5 * (asked.to - asked.from);
  if (two && !with.label_of_parts.empty()) {
    for (const Curve& curve : curves) {  // many vibrations of one would hide those of the other
      Panel& part = add(figure.panels.empty() ? point_text(run, point, options) : "", asked, {curve});
      part.height = height_of_part;
      part.y.label = with.label_of_parts;
      part.y.least = range_of(curves, asked);
      part.x.numbers = &curve == &curves.back();
      if (figure.panels.size() > 1) part.events = {};
    }
  } else {
    add(point_text(run, point, options), asked, curves);
  }
  if (two) {
    for (Panel& panel : figure.panels) {
      // Many vibrations side by side; the more, the thinner.
      const double vibrations = (asked.to - asked.from) / (near.to - near.from);
      for (Curve& curve : panel.curves) curve.width = vibrations > 10 ? 0.35 : 0.7;
    }
    const bool hit = hardest_impact(run, point) != nullptr;
    add(word(options, hit ? "around the hardest impact" : "where they come closest"), near, curves);
  }
  figure.panels.back().x.label = word(options, "Time t [s]");
  return figure;
}

/// "closest approach 0.012 m at 3.57 s, 0.05 m at rest".
std::string closest_text(const RunResults& run, const Moment& closest, Eigen::Index point,
                         const FigureOptions& options) {
  return word(options, "closest approach: {} apart at {}, {} at rest", shown_value(run, closest.value, "L"),
              seconds_text(closest.time), shown_value(run, run.problem.points[point].width, "L"));
}

}  // namespace

Figure displacement_figure(const RunResults& run, const FigureOptions& options) {
  const Eigen::Index i = chosen_point(run, options);
  const ContactPoint& point = run.problem.points[i];
  const auto curve = [&](Eigen::Index b, Eigen::Index floor) {
    return Curve{.label = run.problem.buildings[b].name,
                 .x = course_of(run).time,
                 .y = row_of(course_of(run).displacement[b], run.problem.buildings[b].model.floor_at_or_above(floor)),
                 .tone = building_tone(b)};
  };
  const std::vector<Building>& buildings = run.problem.buildings;
  const bool of_two_that_move = !buildings[point.left].is_rigid() && !buildings[point.left + 1].is_rigid();
  const std::vector<Curve> curves = {curve(point.left, point.left_floor), curve(point.left + 1, point.right_floor)};
  HistoryPanels with{.label = with_unit(word(options, "Displacement x"), run.c.units.length),
                     .label_of_parts = of_two_that_move ? with_unit("x", run.c.units.length) : "",
                     .mark_contacts = true};
  std::string finding;
  for (const Curve& one : curves) {
    const Moment most = largest_of(one);
    if (most.value == 0) continue;
    finding +=
        (finding.empty() ? "" : "; ") + word(options, "{} moves by up to {}, at {}", one.label,
                                             shown_value(run, std::abs(most.value), "L"), seconds_text(most.time));
  }
  if (hardest_impact(run, i) == nullptr) {
    const Moment closest = closest_approach(run, i);
    with.rules.push_back(
        {.at = closest.time, .vertical = true, .label = word(options, "closest"), .line = Line::dotted});
    finding += "; " + closest_text(run, closest, i, options);
  }
  Figure figure = histories(run, options, i, curves, with);
  figure.title = "Displacements relative to the bases, " + point_text(run, i, options);
  figure.finding = finding;
  return figure;
}

Figure opening_figure(const RunResults& run, const FigureOptions& options) {
  const Eigen::Index i = chosen_point(run, options);
  const Curve opening{
      .label = word(options, "opening"), .x = course_of(run).time, .y = row_of(course_of(run).opening, i)};
  const RuleLine closed{.at = 0, .tone = Tone::grey};
  const RuleLine rest{
      .at = run.problem.points[i].width, .label = word(options, "at rest"), .tone = Tone::grey, .line = Line::dashed};
  Figure figure = histories(run, options, i, {opening},
                            {.label = with_unit(word(options, "Opening g"), run.c.units.length),
                             .rules = {closed, rest},
                             .mark_contacts = true});
  const double room = 0.05 * displacement_scale(run.problem, run.response, run.problem.points[i].left);
  for (Panel& panel : figure.panels) panel.y.least = {-room, room};
  figure.title = "Opening of the gap, " + point_text(run, i, options);
  const PointSummary& point = run.response.points[i];
  if (const Impact* hardest = hardest_impact(run, i)) {
    figure.finding =
        word(options, "impacts: {}; the hardest from {} on, penetration up to {}", std::to_string(point.impacts),
             seconds_text(hardest->start), shown_value(run, point.peak_penetration, "L"));
    return figure;
  }
  const Moment closest = closest_approach(run, i);
  figure.finding = closest_text(run, closest, i, options);
  for (Panel& panel : figure.panels) {
    if (closest.time < *panel.x.from || closest.time > *panel.x.to) continue;
    panel.curves.push_back({.label = word(options, "closest"),
                            .x = {closest.time},
                            .y = {closest.value},
                            .line = Line::none,
                            .mark = Mark::circle});
  }
  return figure;
}

Figure force_figure(const RunResults& run, const FigureOptions& options) {
  const Eigen::Index i = chosen_point(run, options);
  if (const Impact* hardest = hardest_impact(run, i); hardest == nullptr || !(hardest->peak_force > 0)) {
    throw NoFigure("no contact force at " + point_text(run, i, options));
  }
  Figure figure = histories(run, options, i, {Curve{}},
                            {.label = with_unit(word(options, "Contact force F"), shown_unit(run, "F"))});
  for (Panel& panel : figure.panels) {
    const Window shown{*panel.x.from, *panel.x.to};
    const std::optional<Curve> peaks = force_peaks(run, i, shown);
    panel.curves = {peaks ? *peaks : force_curve(run, i, shown)};
    if (peaks) panel.curves.front().label = word(options, "peak of each impact");
    std::vector<double>& forces = panel.curves.front().y;
    forces = shown_values(run, std::move(forces), "F");
    const auto [least, most] = std::minmax_element(forces.begin(), forces.end());
    if (*least >= -round_off * *most) panel.y.from = 0;
  }
  figure.title = "Contact force, " + point_text(run, i, options);
  const PointSummary& point = run.response.points[i];
  figure.finding = word(options, "peak {} at {}", shown_value(run, point.peak_force, "F"),
                        seconds_text(point.peak_force_time.value_or(0)));
  return figure;
}

namespace {

/// What is drawn of a struck column: rows of StructuralModel::column_forces over time, in a panel each.
struct ColumnCurves {
  std::string label;      ///< of the axis, without unit
  std::string symbol;     ///< the same in short
  const char* form = "";  ///< of the unit
  std::vector<std::pair<Eigen::Index, Curve>> rows;
  double largest = 0, capacity = 0;  ///< capacity 0: not given
};

Figure column_figure(const RunResults& run, const FigureOptions& options, Eigen::Index point, const ColumnCurves& of) {
  const StruckColumn struck = struck_column(run.problem, run.problem.points[point]).value();
  const Histories& finest = histories_with(run, &Histories::column_forces, struck.building);
  const Eigen::MatrixXd& forces = finest.column_forces.at(struck.building);
  std::vector<Curve> curves;
  for (const auto& [row, style] : of.rows) {
    curves.push_back(style);
    curves.back().x = finest.time;
    curves.back().y = shown_values(run, row_of(forces, 6 * struck.node + row), of.form);
    // What acts on the foot of a piece has the other sign than on its head: drawn is the same sign for the same
    // bending.
    if (row == 1 || row == 2 || row == 4) {
      for (double& y : curves.back().y) y = -y;
    }
  }
  // Impacts are shorter than samples: the largest is told as it was.
  const double factor = shown_factor(run, of.form);
  std::vector<RuleLine> rules;
  for (const double sign : {1.0, -1.0}) {
    rules.push_back(
        {.at = sign * factor * of.largest, .label = sign > 0 ? word(options, "largest") : "", .line = Line::dotted});
    if (of.capacity > 0) {
      rules.push_back({.at = sign * factor * of.capacity,
                       .label = sign > 0 ? word(options, "capacity") : "",
                       .line = Line::dashed});
    }
  }
  const std::string unit = shown_unit(run, of.form);
  Figure figure = histories(run, options, point, curves,
                            {.label = with_unit(of.label, unit),
                             .label_of_parts = with_unit(of.symbol, unit),
                             .rules = rules,
                             .mark_contacts = true});
  figure.finding = word(options, "largest {}", shown_value(run, of.largest, of.form));
  if (of.capacity > 0) {
    figure.finding += "; " + word(options, "capacity {}, demand over capacity {}",
                                  shown_value(run, of.capacity, of.form), number(of.largest / of.capacity));
  }
  figure.title = fmt::format("Column of {} struck at level {} {}", run.problem.buildings[struck.building].name,
                             number(run.problem.points[point].elevation), run.c.units.length);
  return figure;
}

}  // namespace

Figure column_shear_figure(const RunResults& run, const FigureOptions& options) {
  const Eigen::Index i = chosen_struck_point(run, options);
  return column_figure(
      run, options, i,
      {.label = word(options, "Shear V"),
       .symbol = "V",
       .form = "F",
       .rows = {{0, {.label = word(options, "below")}}, {1, {.label = word(options, "above"), .tone = Tone::teal}}},
       .largest = run.response.points[i].column->shear,
       .capacity = run.problem.points[i].column_shear_capacity});
}

Figure column_moment_figure(const RunResults& run, const FigureOptions& options) {
  const Eigen::Index i = chosen_struck_point(run, options);
  return column_figure(run, options, i,
                       {.label = word(options, "Moment M"),
                        .symbol = "M",
                        .form = "F L",
                        .rows = {{2, {.label = word(options, "bottom"), .tone = Tone::grey, .line = Line::dashed}},
                                 {3, {.label = word(options, "where struck")}},
                                 {5, {.label = word(options, "top"), .tone = Tone::teal}}},
                        .largest = run.response.points[i].column->moment,
                        .capacity = run.problem.points[i].column_moment_capacity});
}

Figure energy_figure(const RunResults& run, const FigureOptions& options) {
  if (!run.response.energy || run.response.energy->histories.input.size() == 0) {
    throw NoFigure("the run kept no energies: analysis.energy_audit = true in its case does");
  }
  const EnergyHistories& energy = run.response.energy->histories;
  const Window asked = window(run, options);
  const auto part = [&](const Eigen::VectorXd& sum, Curve curve) {
    curve.x = energy.time;
    curve.y = shown_values(run, {sum.begin(), sum.end()}, "F L");
    return within(curve, asked);
  };
  Panel panel{
      .x = {.label = word(options, "Time t [s]"), .from = asked.from, .to = asked.to},
      .y = {.label = with_unit(word(options, "Energy E"), shown_unit(run, "F L"))},
      .height = 5,
      .curves = {part(energy.input, {.label = word(options, "input"), .width = 1.2}),
                 part(energy.kinetic + energy.strain, {.label = word(options, "kinetic + strain"), .tone = Tone::teal}),
                 part(energy.damping,
                      {.label = word(options, "damping"), .tone = Tone::grey, .line = Line::dashed, .width = 1.4}),
                 part(energy.contact_stored + energy.contact_lost,
                      {.label = word(options, "contact"), .tone = Tone::red, .line = Line::dash_dot, .width = 1.2})}};
  if (energy.hysteretic.size() > 0 && energy.hysteretic.maxCoeff() > 0) {
    panel.curves.push_back(
        part(energy.hysteretic, {.label = word(options, "yielding"), .tone = Tone::teal, .line = Line::dashed}));
  }
  constexpr double round_off = 1e-9;  // of the energy that came in
  const auto at_end = [&](const Eigen::VectorXd& sum) {
    const double last = sum.size() > 0 ? sum(sum.size() - 1) : 0;
    return shown_value(run, std::abs(last) > round_off * energy.input.cwiseAbs().maxCoeff() ? last : 0, "F L");
  };
  return {.title = "Where the energy is, of all buildings together",
          .finding = word(options, "at the end {} have come in, damping has taken {}, contact {}", at_end(energy.input),
                          at_end(energy.damping), at_end(energy.contact_stored + energy.contact_lost)),
          .panels = {panel},
          .width = options.width};
}

}  // namespace bentur
