#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bentur/contact/laws/rubbing.h"
#include "bentur/core/number_text.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/plan_figures.h"
#include "bentur/report/scene/tones.h"

namespace bentur {
namespace {

using Eigen::Index;

constexpr double to_mrad = 1e3;

const PlanGap& gap_at(const PlanRun& run, Index point) { return run.problem.gaps[contact_at(run.problem, point).gap]; }

/// A building at a contact, L (0) or R (1), and its floor there.
struct Side {
  Index building = 0, floor = 0;
};
Side side_at(const PlanRun& run, Index point, int side) {
  const PlanContact& contact = *contact_at(run.problem, point).contact;
  const PlanGap& gap = gap_at(run, point);
  return {side == 0 ? gap.left : gap.right, floor_at(run.problem, gap, contact, side)};
}

std::vector<double> times(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

/// The instants of a curve that are within a window, and the curve there.
Curve cut(const Curve& curve, const std::vector<double>& time, const TimeWindow& window) {
  Curve part = curve;
  part.x.clear();
  part.y.clear();
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (time[i] < window.from || time[i] > window.to) continue;
    part.x.push_back(curve.x[i]);
    part.y.push_back(curve.y[i]);
  }
  return part;
}

/// The contacts of the level that a contact is at, along the stretch; of one beside the joint itself.
std::vector<Index> points_beside(const PlanRun& run, Index point) {
  const PlanContactPlace place = contact_at(run.problem, point);
  if (!place.contact->is_of_joint()) return {point};
  const Index first = first_contact(run.problem, place.gap);
  std::vector<Index> points;
  for (Index i = first; i < first + std::ssize(run.problem.gaps[place.gap].contacts); ++i) {
    const PlanContact& one = *contact_at(run.problem, i).contact;
    if (one.is_of_joint() && one.elevation == place.contact->elevation) points.push_back(i);
  }
  return points;
}

/// The exact course, or samples where it is not kept.
const PlanHistories& course_of(const PlanRun& run) {
  return run.response.course.time.empty() ? run.response.histories : run.response.course;
}

bool is_hit(const PlanRun& run, Index point) { return run.response.points[point].impacts > 0; }

}  // namespace

std::string shown_unit(const PlanRun& run, std::string_view form) { return unit_text(form, shown_units(run).units); }
double shown_factor(const PlanRun& run, std::string_view form) { return shown_units(run).factor(form); }
std::string shown_value(const PlanRun& run, double value, std::string_view form) {
  return number(value * shown_factor(run, form)) + " " + shown_unit(run, form);
}

std::vector<Index> asked_points(const PlanRun& run, const FigureOptions& options) {
  const std::size_t gaps = run.problem.gaps.size();
  if (options.gap && *options.gap >= gaps) {
    throw NoFigure(gaps == 0
                       ? std::string("no contact is modelled in this run")
                       : fmt::format("there is no gap {}: gaps are counted from 0 to {}", *options.gap, gaps - 1));
  }
  std::vector<Index> points;
  std::string known;
  for (Index i = 0; i < std::ssize(run.response.points); ++i) {
    const PlanContactPlace place = contact_at(run.problem, i);
    if (options.gap && place.gap != *options.gap) continue;
    const std::string level = number(place.contact->elevation);
    if (known != level && !known.ends_with(" " + level)) known += (known.empty() ? "" : ", ") + level;
    if (is_at(options, place.contact->elevation)) points.push_back(i);
  }
  if (known.empty()) throw NoFigure("no contact is modelled in this run");
  if (points.empty()) {
    throw NoFigure(fmt::format("no contact point at level {} {}: there are {}", number(*options.elevation),
                               run.c.units.length, known));
  }
  return points;
}

Index chosen_point(const PlanRun& run, const FigureOptions& options) {
  return *telling_instant(run.response, asked_points(run, options)).point;
}

std::string level_text(const PlanRun& run, Index point, const FigureOptions& options) {
  return word(options, "level {}",
              number(contact_at(run.problem, point).contact->elevation) + " " + run.c.units.length);
}

std::string point_text(const PlanRun& run, Index point, const FigureOptions& options) {
  return fmt::format("{}, {}, {}", gap_name(run.problem, gap_at(run, point)), level_text(run, point, options),
                     along_text(run, point));
}

HistoryPlace place_of(const PlanRun& run, Index point, const FigureOptions& options) {
  const std::vector<double>& time = run.response.histories.time;
  HistoryPlace place{.title = point_text(run, point, options),
                     .impacts = &run.response.impacts,
                     .point = point,
                     .samples = {time.front(), time.back()},
                     .whole = {time.front(), time.back()}};
  for (const int side : {0, 1}) {
    const Eigen::VectorXd& omega = run.problem.buildings[side_at(run, point, side).building].modes.omega;
    if (omega.size() > 0) place.period = std::max(place.period, 2 * std::numbers::pi / omega(0));
  }
  Index nearest = 0;
  (void)course_of(run).opening.row(point).minCoeff(&nearest);
  place.closest = course_of(run).time[nearest];
  return place;
}

Figure displacement_figure(const PlanRun& run, const FigureOptions& options) {
  const Index point = chosen_point(run, options);
  HistoryPlace place = place_of(run, point, options);
  place.title = gap_name(run.problem, gap_at(run, point)) + ", " + level_text(run, point, options);
  const TimeWindow asked = asked_window(place, options), near = around_the_hardest(place);
  const bool two = has_two_windows(place, options);
  Figure figure{.title = "Displacements of the centres of mass relative to the bases and rotations, " + place.title,
                .columns = two ? 2 : 1,
                .width = two ? broad(options.width) : options.width,
                .shared_legend = true};
  const std::string& length = run.c.units.length;
  const PlanHistories& histories = course_of(run);
  struct Quantity {
    std::string label;
    const std::vector<Eigen::MatrixXd>& list;
    Eigen::VectorXd PlanPeaks::*peaks;
    double factor;
    std::string unit;
  };
  const Quantity quantities[] = {
      {with_unit(word(options, "Displacement x"), length), histories.x, &PlanPeaks::x, 1, length},
      {with_unit(word(options, "Displacement y"), length), histories.y, &PlanPeaks::y, 1, length},
      {word(options, "Rotation θ [mrad]"), histories.rotation, &PlanPeaks::rotation, to_mrad, "mrad"}};
  const std::vector<Tone> tones = tones_of(run.problem, run.response);
  const auto moves = [&](const Quantity& quantity) {
    const auto is_moved = [&](int side) {
      const auto [b, floor] = side_at(run, point, side);
      return !quantity.list[b].row(floor).isZero(0);
    };
    return is_moved(0) || is_moved(1);
  };
  std::vector<const Quantity*> shown;  // nothing to see of what stays where it is
  for (const Quantity& one : quantities) {
    if (moves(one) || (&one == &quantities[0] && !moves(quantities[1]) && !moves(quantities[2]))) shown.push_back(&one);
  }
  for (const Quantity* const each : shown) {
    const Quantity& quantity = *each;
    const bool is_first = each == shown.front(), is_last = each == shown.back();
    std::vector<Curve> curves;
    for (const int side : {0, 1}) {
      const auto [b, floor] = side_at(run, point, side);
      if (run.problem.buildings[b].is_rigid()) continue;
      curves.push_back({.label = run.problem.buildings[b].name,
                        .x = histories.time,
                        .y = times(row_of(quantity.list[b], floor), quantity.factor),
                        .tone = tones[b],
                        .line = curves.empty() ? Line::solid : Line::dashed});
      if (run.response.course.time.empty()) {
        add_peak(curves.back(), quantity.factor * (run.response.buildings[b].*quantity.peaks)(floor));
      }
      const auto most = std::max_element(curves.back().y.begin(), curves.back().y.end(),
                                         [](double a, double c) { return std::abs(a) < std::abs(c); });
      if (*most == 0) continue;
      figure.finding += (figure.finding.empty() ? "" : "; ") + run.problem.buildings[b].name + ", " + quantity.label +
                        ": " + number(std::abs(*most));
    }
    const auto range = range_of(curves, asked);
    const std::size_t before = figure.panels.size();
    for (const TimeWindow& window : two ? std::vector{asked, near} : std::vector{asked}) {
      const bool is_near = two && window.from == near.from && window.to == near.to;
      Panel panel{.x = {.from = window.from, .to = window.to, .numbers = is_last},
                  .y = {.label = quantity.label, .least = range},
                  .height = 2.2};
      if (is_first) {
        panel.title = !is_near ? place.title
                               : word(options, hardest_impact(place) != nullptr ? "around the hardest impact"
                                                                                : "where they come closest");
        panel.events = contacts_within(place, window, options);
      }
      if (is_last) panel.x.label = word(options, "Time t [s]");
      if (is_near) leave_to_neighbour(panel.y);
      for (const Curve& curve : curves) {
        panel.curves.push_back(within(curve, window));
        if (two && !is_near) panel.curves.back().width = width_over_time;
      }
      figure.panels.push_back(std::move(panel));
    }
    std::vector<Panel*> panels;
    for (std::size_t i = before; i < figure.panels.size(); ++i) panels.push_back(&figure.panels[i]);
    name_peaks(panels, curves, [&](double value) { return number(value) + " " + quantity.unit; });
    auto least = *panels.front()->y.least;  // one scale side by side, with room for the values of both
    for (const Panel* panel : panels) {
      least = {std::min(least.first, panel->y.least->first), std::max(least.second, panel->y.least->second)};
    }
    for (Panel* panel : panels) panel->y.least = least;
  }
  return figure;
}

Figure opening_figure(const PlanRun& run, const FigureOptions& options) {
  const Index point = chosen_point(run, options);
  const double width = gap_at(run, point).width_at(*contact_at(run.problem, point).contact);
  std::vector<Curve> curves;
  const std::vector<Index> beside = points_beside(run, point);
  std::vector<Index> told = {beside.front()};  // in between it is a straight line
  if (beside.size() > 1) told.push_back(beside.back());
  const bool is_straight = gap_at(run, point).stretch.is_parallel();
  if (!is_straight && point != told.front() && point != told.back()) told.insert(told.begin() + 1, point);
  for (const Index i : told) {
    curves.push_back({.label = along_text(run, i),
                      .x = course_of(run).time,
                      .y = row_of(course_of(run).opening, i),
                      .tone = i == told.front()  ? Tone::black
                              : i == told.back() ? Tone::teal
                                                 : Tone::red,
                      .line = i == told.back() ? Line::dashed : Line::solid});
  }
  HistoryPlace place = place_of(run, point, options);
  place.title = gap_name(run.problem, gap_at(run, point)) + ", " + level_text(run, point, options);
  const std::string label = with_unit(word(options, "Opening g"), run.c.units.length);
  Figure figure = history_figure(
      place, options, curves,
      {.label = label,
       .rules = {{.at = 0, .tone = Tone::grey},
                 {.at = width, .label = word(options, "at rest"), .tone = Tone::grey, .line = Line::dash_dot}},
       .mark_contacts = true});
  figure.title = "Opening of the gap at both ends of the stretch, " + place.title;
  const PointSummary& found = run.response.points[point];
  if (const Impact* const hardest = hardest_impact(place)) {
    figure.finding =
        word(options, "impacts: {}; the hardest from {} on, penetration up to {}", std::to_string(found.impacts),
             seconds_text(hardest->start), shown_value(run, found.peak_penetration, "L"));
  } else {
    figure.finding = word(options, "closest approach: {} apart at {}, {} at rest",
                          shown_value(run, course_of(run).opening.row(point).minCoeff(), "L"),
                          seconds_text(place.closest), shown_value(run, width, "L"));
  }
  return figure;
}

/// The peak of each impact at some places, in one panel: what is known where courses are not.
Figure peaks_figure(const PlanRun& run, const FigureOptions& options, const std::vector<Index>& points) {
  const Index hardest = points.front();
  const HistoryPlace place = place_of(run, hardest, options);
  const TimeWindow shown = asked_window(place, options);
  const double factor = shown_factor(run, "F");
  Panel panel{.title = gap_name(run.problem, gap_at(run, hardest)) + ", " + level_text(run, hardest, options),
              .x = {.label = word(options, "Time t [s]"), .from = shown.from, .to = shown.to},
              .y = {.label = with_unit(word(options, "Peak force of each impact"), shown_unit(run, "F")), .from = 0},
              .height = 3.4};
  double most = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Curve peaks{.label = along_text(run, points[i]),
                .tone = i == 0 ? Tone::black : Tone::teal,
                .line = Line::none,
                .mark = mark_of(i),
                .complete = true};
    for (const Impact& impact : run.response.impacts) {
      const double when = impact.peak_force_time;
      if (impact.point != points[i] || when < shown.from || when > shown.to) continue;
      peaks.x.push_back(when);
      peaks.y.push_back(factor * impact.peak_force);
      most = std::max(most, peaks.y.back());
    }
    if (!peaks.x.empty()) panel.curves.push_back(std::move(peaks));
  }
  if (panel.curves.empty()) throw NoFigure("no contact force between --from and --to");
  constexpr double above = 1.2;  // room for the number at the peak
  panel.y.least = {0, above * most};
  Figure figure{.panels = {std::move(panel)}, .width = options.width};
  const PointSummary& found = run.response.points[hardest];
  name_value(figure.panels, found.peak_force_time.value_or(0), factor * found.peak_force,
             shown_value(run, found.peak_force, "F"));
  return figure;
}

Figure force_figure(const PlanRun& run, const FigureOptions& options) {
  const Index hardest = chosen_point(run, options);
  if (!(run.response.points[hardest].peak_force > 0)) {
    throw NoFigure("no contact force at " + point_text(run, hardest, options));
  }
  std::vector<Index> points = points_beside(run, hardest);
  std::erase_if(points, [&](Index i) { return !(run.response.points[i].peak_force > 0); });
  std::stable_sort(points.begin(), points.end(), [&](Index a, Index b) {
    return run.response.points[a].peak_force > run.response.points[b].peak_force;
  });
  constexpr std::size_t most = 2;
  points.resize(std::min(points.size(), most));
  const PlanHistories& course = run.response.course;
  Figure figure{.width = options.width};
  if (course.time.empty()) {
    figure = peaks_figure(run, options, points);
    points.clear();
  }
  for (const Index point : points) {
    Figure one =
        force_history_figure(place_of(run, point, options), options, course.time, row_of(course.force, point),
                             with_unit(word(options, "Contact force F"), shown_unit(run, "F")), shown_factor(run, "F"));
    const PointSummary& found = run.response.points[point];
    name_value(one.panels, found.peak_force_time.value_or(0), shown_factor(run, "F") * found.peak_force,
               shown_value(run, found.peak_force, "F"));
    if (point != points.back()) one.panels.back().x.label = "";
    for (Panel& panel : one.panels) {
      panel.height = 2.6;
      figure.panels.push_back(std::move(panel));
    }
  }
  const PointSummary& found = run.response.points[hardest];
  figure.title = "Contact forces, " + point_text(run, hardest, options);
  figure.finding = word(options, "peak {} at {}", shown_value(run, found.peak_force, "F"),
                        seconds_text(found.peak_force_time.value_or(0)));
  return figure;
}

Figure orbit_figure(const PlanRun& run, const FigureOptions& options) {
  const Index point = chosen_point(run, options);
  const PlanGap& gap = gap_at(run, point);
  HistoryPlace place = place_of(run, point, options);
  const bool two = has_two_windows(place, options);
  const TimeWindow shown = two ? around_the_hardest(place) : asked_window(place, options);
  const std::vector<double>& time = course_of(run).time;
  const std::vector<Tone> tones = tones_of(run.problem, run.response);
  const std::vector<Index> beside = points_beside(run, point);
  const Index other = point == beside.front() ? beside.back() : beside.front();
  const std::string& length = run.c.units.length;
  Figure figure{.title = "Orbits of the edges at both ends of the stretch, seen from above",
                .columns = options.narrow ? 1 : 2,
                .width = options.narrow ? options.width : broad(options.width)};
  PlanPoint reach = PlanPoint::Zero();
  reach[gap.stretch.across] = 1.05 * gap.stretch.width;
  constexpr double seen = 1.0 / 400;  // of what is drawn
  for (const int side : {0, 1}) {
    const auto [b, floor] = side_at(run, point, side);
    const PlanBuilding& building = run.problem.buildings[b];
    if (building.is_rigid()) continue;
    Panel panel{.title = fmt::format("{}, {}", building.name, level_text(run, point, options)),
                .x = {.label = with_unit(word(options, "Displacement x"), length)},
                .y = {.label = with_unit(word(options, "Displacement y"), length)},
                .height = 6};
    for (const Index end : {other, point}) {
      const StretchCorner there = gap.at(*contact_at(run.problem, end).contact);
      const PlanPoint& at = side == 0 ? there.left : there.right;
      Curve curve{.label = along_text(run, end),
                  .tone = end == point ? tones[b] : Tone::grey,
                  .line = end == point ? Line::solid : Line::dashed,
                  .width = end == point ? 1.0 : 0.8,
                  .complete = true};
      for (const double t : time) {
        const PlanPoint moved = movement_of(building.model, floor, at, floor_motion(course_of(run), b, floor, t));
        curve.x.push_back(moved.x());
        curve.y.push_back(moved.y());
      }
      const Curve near = cut(curve, time, shown);
      const Curve& widest = two && end == point ? curve : near;
      for (const double value : widest.x) reach.x() = std::max(reach.x(), 1.05 * std::abs(value));
      for (const double value : widest.y) reach.y() = std::max(reach.y(), 1.05 * std::abs(value));
      panel.curves.push_back(near);
      if (!two || end != point) continue;
      curve.label = word(options, "rest of the run");
      curve.tone = Tone::pale;
      panel.curves.insert(panel.curves.begin(), sparse(std::move(curve), seen * reach.norm()));
    }
    if (const Impact* const hardest = hardest_impact(place)) {
      const double when = hardest->peak_force > 0 ? hardest->peak_force_time : hardest->start;
      if (when >= shown.from && when <= shown.to) {
        const StretchCorner there = gap.at(*contact_at(run.problem, point).contact);
        const PlanPoint& at = side == 0 ? there.left : there.right;
        const PlanPoint moved = movement_of(building.model, floor, at, floor_motion(course_of(run), b, floor, when));
        panel.curves.push_back({.label = word(options, "hardest impact"),
                                .x = {moved.x()},
                                .y = {moved.y()},
                                .tone = Tone::red,
                                .line = Line::none,
                                .mark = Mark::disc,
                                .mark_size = 1.5});
      }
    }
    if (!gap.stretch.is_oblique()) {
      panel.rules.push_back({.at = side == 0 ? gap.stretch.width : -gap.stretch.width,
                             .vertical = gap.stretch.across == 0,
                             .label = word(options, "neighbour at rest"),
                             .tone = Tone::black,
                             .line = Line::dotted});
    }
    figure.panels.push_back(std::move(panel));
  }
  if (figure.panels.size() == 1) {
    figure.columns = 1;
    figure.width = options.width;
  }
  reach.x() = std::max(reach.x(), 0.9 * reach.y());  // so that no frame is too slender
  reach.y() = std::max(reach.y(), 0.4 * reach.x());
  for (Panel& panel : figure.panels) {
    panel.x.from = -(panel.x.to = reach.x()).value();
    panel.y.from = -(panel.y.to = reach.y()).value();
  }
  if (options.narrow) {
    figure.panels.front().x.label = "";
  } else {
    for (std::size_t i = 1; i < figure.panels.size(); ++i) leave_to_neighbour(figure.panels[i].y);
  }
  // Lengths alike both ways.
  const PanelPlace frame = placed_figure(figure, "").panels.front();
  for (Panel& panel : figure.panels) panel.height *= frame.width / frame.height * reach.y() / reach.x();
  figure.finding =
      fmt::format("{}, {} s – {} s", point_text(run, point, options), number(shown.from), number(shown.to));
  const std::string from = seconds_text(shown.from), to = seconds_text(shown.to);
  if (two) {
    add_part(figure, hardest_impact(place) != nullptr
                         ? word(options, "Dark from {} to {}, around the hardest impact; pale the rest", from, to)
                         : word(options, "Dark from {} to {}, where they come closest; pale the rest", from, to));
  } else if (options.from || options.to) {
    add_part(figure, word(options, "From {} to {}", from, to));
  }
  return figure;
}

Figure friction_figure(const PlanRun& run, const FigureOptions& options) {
  std::vector<Index> points = asked_points(run, options);
  std::erase_if(points, [&](Index i) { return !contact_at(run.problem, i).contact->rubbing || !is_hit(run, i); });
  if (points.empty()) {
    throw NoFigure("nothing rubs there: contact.friction in the case lets floors that touch do so");
  }
  const Index point = *telling_instant(run.response, points).point;
  const double mu = contact_at(run.problem, point).contact->rubbing->friction();
  const PlanHistories& histories = run.response.histories;
  const double factor = shown_factor(run, "F");
  const PointSummary& found = run.response.points[point];
  // Marks alone: between two samples the force goes ways that they do not know.
  Curve path{.line = Line::none, .mark = Mark::disc, .complete = true, .mark_size = 0.7};
  const double step = run.c.analysis.output_step;  // a report has samples in between: one figure from all doors
  for (Index k = 0; k < std::ssize(histories.time); ++k) {
    const double across = histories.force(point, k), steps = step > 0 ? histories.time[k] / step : 0;
    if (!(across > 0) || std::abs(steps - std::round(steps)) > 1e-6) continue;
    path.x.push_back(factor * across);
    path.y.push_back(factor * histories.force_along(point, k));
  }
  if (path.x.empty()) throw NoFigure("the contact is too short for the samples of these histories");
  const double most = factor * found.peak_force;
  Panel panel{.title = point_text(run, point, options),
              .x = {.label = with_unit(word(options, "Contact force F"), shown_unit(run, "F")), .from = 0},
              .y = {.label = with_unit(word(options, "Force along the joint"), shown_unit(run, "F"))},
              .height = 5};
  for (const double sign : {1.0, -1.0}) {
    panel.curves.push_back({.label = sign > 0 ? "±μF, μ = " + number(mu) : "",
                            .x = {0, most},
                            .y = {0, sign * mu * most},
                            .tone = Tone::red,
                            .line = Line::dashed});
  }
  path.label = word(options, "samples in contact");
  panel.curves.push_back(std::move(path));
  const PlanFriction& rubbed = run.response.friction[point];
  return {.title = "Force along the joint over contact force",
          .finding = word(options, "up to {} along the joint; slides {}, friction takes {}",
                          shown_value(run, rubbed.peak_tangential_force, "F"), shown_value(run, rubbed.sliding, "L"),
                          shown_value(run, rubbed.friction_loss, "F L")),
          .panels = {panel},
          .width = options.width};
}

Figure energy_figure(const PlanRun& run, const FigureOptions& options) {
  if (!run.response.energy || run.response.energy->histories.input.size() == 0) {
    throw NoFigure("the run kept no energies: analysis.energy_audit = true in its case does");
  }
  const std::vector<double>& time = run.response.histories.time;
  const HistoryPlace whole{.samples = {time.front(), time.back()}, .whole = {time.front(), time.back()}};
  return energy_history_figure(run.response.energy->histories, asked_window(whole, options), options,
                               shown_factor(run, "F L"), shown_unit(run, "F L"));
}

}  // namespace bentur
