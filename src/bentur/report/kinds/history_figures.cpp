#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/history_panels.h"
#include "bentur/report/kinds/internal/scene_panel.h"

namespace bentur {
namespace {

/// The exact course where it was kept, else samples.
const Histories& course_of(const RunResults& run) {
  return run.response.course.time.empty() ? run.response.histories : run.response.course;
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

/// What panels of histories are of.
HistoryPlace place_of(const RunResults& run, Eigen::Index point, const FigureOptions& options) {
  const std::vector<double>& samples = run.response.histories.time;
  const Eigen::Index left = run.problem.points[point].left;
  const auto period = [&](Eigen::Index b) { return first_period(run.problem.buildings[b]).value_or(0); };
  return {.title = point_text(run, point, options),
          .impacts = &run.response.impacts,
          .point = point,
          .samples = {samples.front(), samples.back()},
          .whole = {samples.front(), std::max(samples.back(), course_of(run).time.back())},
          .period = std::max(period(left), period(left + 1)),
          .closest = closest_approach(run, point).time};
}

Figure histories(const RunResults& run, const FigureOptions& options, Eigen::Index point,
                 const std::vector<Curve>& curves, const HistoryPanels& with) {
  return history_figure(place_of(run, point, options), options, curves, with);
}

/// The value of a curve that is largest in size.
Moment largest_of(const Curve& curve) {
  Moment most;
  for (std::size_t i = 0; i < curve.y.size(); ++i) {
    if (i == 0 || std::abs(curve.y[i]) > std::abs(most.value)) most = {curve.x[i], curve.y[i]};
  }
  return most;
}

/// "closest approach 0.012 m at 3.57 s, 0.05 m at rest".
std::string closest_text(const RunResults& run, const Moment& closest, Eigen::Index point,
                         const FigureOptions& options) {
  return word(options, "closest approach: {} apart at {}, {} at rest", shown_value(run, closest.value, "L"),
              seconds_text(closest.time), shown_value(run, run.problem.points[point].width, "L"));
}

/// What panels are of where a floor goes inside what it faces.
HistoryPlace place_of(const RunResults& run, const NearestFloor& inside, const FigureOptions& options) {
  const std::vector<double>& samples = run.response.histories.time;
  const auto period = [&](Eigen::Index b) { return first_period(run.problem.buildings[b]).value_or(0); };
  return {.title = gap_name(run.problem, inside.gap) + ", " +
                   word(options, "level {}", number(inside.elevation) + " " + run.c.units.length),
          .impacts = &run.response.impacts,
          .point = -1,
          .samples = {samples.front(), samples.back()},
          .whole = {samples.front(), std::max(samples.back(), inside.time.back())},
          .period = std::max(period(inside.left), period(inside.right)),
          .closest = inside.least_time};
}

Figure inside_history(const RunResults& run, const NearestFloor& inside, const FigureOptions& options,
                      const std::vector<Curve>& curves, const HistoryPanels& with) {
  const HistoryPlace place = place_of(run, inside, options);
  Figure figure = history_figure(place, options, curves, with);
  figure.finding =
      word(options, "{}, deepest at {}", inside_text(run, inside, options), seconds_text(inside.least_time));
  figure.title = place.title + ": " + figure.finding;
  if (figure.panels.size() > 1) figure.panels.back().title = word(options, "around the deepest");
  return figure;
}

/// Of three neighbours in a row each has its own, in all frames the same.
Line line_of(Eigen::Index building) {
  constexpr Line lines[] = {Line::solid, Line::dashed, Line::dash_dot};
  return lines[building % 3];
}

/// The displacements of that floor and of what it faces at its level, which the opening gives.
Figure inside_displacement(const RunResults& run, const NearestFloor& inside, const FigureOptions& options) {
  const std::vector<double> own = row_of(course_of(run).displacement[inside.floor_of], inside.floor);
  const bool of_left = inside.floor_of == inside.left;
  std::vector<Curve> curves;
  for (const Eigen::Index b : {inside.left, inside.right}) {
    Curve curve{.label = run.problem.buildings[b].name,
                .x = inside.time,
                .y = own,
                .tone = tone_of(run, options, b),
                .line = line_of(b)};
    for (std::size_t i = 0; b != inside.floor_of && i < own.size(); ++i) {
      curve.y[i] -= (of_left ? 1 : -1) * (inside.width - inside.opening[i]);
    }
    curves.push_back(std::move(curve));
  }
  const RuleLine deepest{
      .at = inside.least_time, .vertical = true, .label = word(options, "deepest inside"), .line = Line::dotted};
  return inside_history(run, inside, options, curves,
                        {.label = with_unit(word(options, "Displacement x"), run.c.units.length),
                         .label_of_parts = with_unit("x", run.c.units.length),
                         .rules = {deepest}});
}

}  // namespace

Figure inside_opening(const RunResults& run, const NearestFloor& inside, const FigureOptions& options) {
  const Curve opening{.label = word(options, "opening"), .x = inside.time, .y = inside.opening};
  const RuleLine closed{.at = 0, .tone = Tone::grey};
  const RuleLine rest{.at = inside.width, .label = word(options, "at rest"), .tone = Tone::grey, .line = Line::dashed};
  Figure figure =
      inside_history(run, inside, options, {opening},
                     {.label = with_unit(word(options, "Opening g"), run.c.units.length), .rules = {closed, rest}});
  for (Panel& panel : figure.panels) {
    if (inside.least_time < *panel.x.from || inside.least_time > *panel.x.to) continue;
    panel.curves.push_back({.label = word(options, "deepest inside"),
                            .x = {inside.least_time},
                            .y = {inside.least_opening},
                            .tone = Tone::red,
                            .line = Line::none,
                            .mark = Mark::circle});
  }
  return figure;
}

Figure displacement_figure(const RunResults& run, const FigureOptions& options) {
  if (const NearestFloor* inside = asked_inside(run, options)) return inside_displacement(run, *inside, options);
  const Eigen::Index i = chosen_point(run, options);
  const ContactPoint& point = run.problem.points[i];
  const HistoryPlace place = place_of(run, i, options);
  const TimeWindow shown = has_two_windows(place, options) ? around_the_hardest(place) : asked_window(place, options);
  const auto curve = [&](Eigen::Index b, Eigen::Index node) {
    const Eigen::Index floor = run.problem.buildings[b].model.floor_at_or_above(node);
    Curve one{.label = run.problem.buildings[b].name,
              .x = course_of(run).time,
              .y = row_of(course_of(run).displacement[b], floor),
              .tone = tone_of(run, options, b),
              .line = line_of(b)};
    if (run.response.course.time.empty()) {
      const std::vector<Eigen::MatrixXd>& rates = run.response.histories.velocity;
      if (!rates.empty()) one = finer(one, row_of(rates[b], floor), shown);
      add_peak(one, run.response.buildings[b].displacement(floor));
    }
    return one;
  };
  const std::vector<Building>& buildings = run.problem.buildings;
  const bool of_two_that_move = !buildings[point.left].is_rigid() && !buildings[point.right].is_rigid();
  const std::vector<Curve> curves = {curve(point.left, point.left_floor), curve(point.right, point.right_floor)};
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
  std::vector<Panel*> panels;
  for (Panel& panel : figure.panels) panels.push_back(&panel);
  name_peaks(panels, curves, [&](double value) { return shown_value(run, value, "L"); });
  figure.title = "Displacements relative to the bases, " + point_text(run, i, options);
  figure.finding = finding;
  return figure;
}

Figure opening_figure(const RunResults& run, const FigureOptions& options) {
  if (const NearestFloor* inside = asked_inside(run, options)) return inside_opening(run, *inside, options);
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
  const Histories& course = run.response.course;
  const std::vector<double> force = course.time.empty() ? std::vector<double>() : row_of(course.force, i);
  Figure figure =
      force_history_figure(place_of(run, i, options), options, course.time, force,
                           with_unit(word(options, "Contact force F"), shown_unit(run, "F")), shown_factor(run, "F"));
  figure.title = "Contact force, " + point_text(run, i, options);
  const PointSummary& point = run.response.points[i];
  const std::string peak = shown_value(run, point.peak_force, "F");
  const double when = point.peak_force_time.value_or(0);
  figure.finding = word(options, "peak {} at {}", peak, seconds_text(when));
  name_value(figure.panels, when, shown_factor(run, "F") * point.peak_force, peak);
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
                       .tone = Tone::red,
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
  return column_figure(run, options, i,
                       {.label = word(options, "Shear V"),
                        .symbol = "V",
                        .form = "F",
                        .rows = {{0, {.label = word(options, "below")}},
                                 {1, {.label = word(options, "above"), .tone = Tone::teal, .line = Line::dashed}}},
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
                                 {5, {.label = word(options, "top"), .tone = Tone::teal, .line = Line::dash_dot}}},
                        .largest = run.response.points[i].column->moment,
                        .capacity = run.problem.points[i].column_moment_capacity});
}

Figure energy_figure(const RunResults& run, const FigureOptions& options) {
  if (!run.response.energy || run.response.energy->histories.input.size() == 0) {
    throw NoFigure("the run kept no energies: analysis.energy_audit = true in its case does");
  }
  const std::vector<double>& samples = run.response.histories.time;
  const double end = std::max(samples.back(), course_of(run).time.back());
  const HistoryPlace whole{.samples = {samples.front(), samples.back()}, .whole = {samples.front(), end}};
  return energy_history_figure(run.response.energy->histories, asked_window(whole, options), options,
                               shown_factor(run, "F L"), shown_unit(run, "F L"));
}

}  // namespace bentur
