#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/model/close_up.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"

namespace bentur {
namespace {

/// One impact in close-up; where the force jumps there are two instants at one time. What was pressed may still come
/// back when the contact has ended.
struct Course {
  Eigen::Index point = 0;
  double start = 0;                                   ///< of the impact [s]
  double length = 0;                                  ///< of the impact [ms]
  std::size_t end = 0;                                ///< number of instants up to its end
  std::vector<double> time{}, shortening{}, force{};  ///< since the start [ms], δ [length], F [force] as shown

  void add(double at, double depth, double pressed) {
    time.push_back(at);
    shortening.push_back(depth);
    force.push_back(pressed);
  }
};

/// The force at an end of an impact from two samples near it, the nearer one first.
double force_at_end(double end, double t0, double f0, double t1, double f1) {
  const double force = f0 + (end - t0) / (t1 - t0) * (f1 - f0);
  return force * f0 > 0 ? force : 0;
}

/// Of the gap that is asked for, else of the hardest impact of all: that of the run, or made anew where its case is
/// known.
CloseUp near_of(const RunResults& run, const FigureOptions& options) {
  const auto is_asked = [&](const Impact& one) {
    return !options.gap || run.problem.points[one.point].gap == static_cast<Eigen::Index>(*options.gap);
  };
  const std::vector<Impact>& impacts = run.response.impacts;
  if (std::none_of(impacts.begin(), impacts.end(), is_asked)) {
    throw NoFigure(impacts.empty() ? "nothing was hit in this run" : "nothing was hit across this gap");
  }
  if (!run.figures.close_up) {
    throw NoFigure("the file has no impact in close-up: \"bentur run --figures\" adds it");
  }
  if (is_asked(impacts.at(run.figures.close_up->impact))) return *run.figures.close_up;
  if (run.c.buildings.empty()) throw NoFigure("the file has the hardest impact of the run alone in close-up");
  constexpr double budget = 2e7;  // numbers in memory
  const auto made = close_up(run.problem, run.response, run.c.analysis.solver, budget, *options.gap);
  if (!made) throw NoFigure("the impacts across this gap are too short for a close-up");
  return *made;
}

Course read_course(const RunResults& run, const CloseUp& near) {
  const Impact& impact = run.response.impacts.at(near.impact);
  Course course{.point = impact.point, .start = impact.start, .length = 1e3 * (impact.end - impact.start)};
  const std::vector<double> force = shown_values(run, near.force, "F");
  const auto first = std::upper_bound(near.time.begin(), near.time.end(), impact.start) - near.time.begin();
  const auto last = std::lower_bound(near.time.begin(), near.time.end(), impact.end) - near.time.begin();
  const auto at_end = [&](double end, std::ptrdiff_t i, std::ptrdiff_t next) {
    return last - first < 2 ? 0.0 : force_at_end(end, near.time[i], force[i], near.time[next], force[next]);
  };
  course.add(0, 0, 0);
  course.add(0, 0, at_end(impact.start, first, first + 1));
  const auto depth = [&](std::ptrdiff_t i) { return std::max(0.0, -near.opening[i]); };
  for (std::ptrdiff_t i = first; i < last; ++i) course.add(1e3 * (near.time[i] - impact.start), depth(i), force[i]);
  course.end = course.time.size();
  if (impact.open_ended) return course;
  double left = 0;  // of the penetration
  if (last > first && last < std::ssize(near.time)) {
    const double part = (impact.end - near.time[last - 1]) / (near.time[last] - near.time[last - 1]);
    left = depth(last - 1) + part * (depth(last) - depth(last - 1));
  }
  course.add(course.length, left, at_end(impact.end, last - 1, last - 2));
  course.add(course.length, left, 0);
  course.end = course.time.size();
  for (std::ptrdiff_t i = last; i < std::ssize(near.time); ++i) {
    course.add(1e3 * (near.time[i] - impact.start), depth(i), 0);
  }
  return course;
}

constexpr double seen_loss = 1e-3;

/// The part of the work done while closing that parting does not give back [-].
double loss_in(const Course& course) {
  double taken = 0;
  double lost = 0;
  for (std::size_t i = 1; i < course.end; ++i) {
    const double work = (course.shortening[i] - course.shortening[i - 1]) * (course.force[i] + course.force[i - 1]) / 2;
    taken += std::max(work, 0.0);
    lost += work;
  }
  return taken > 0 ? std::max(lost / taken, 0.0) : 0;
}

/// Whether the force is some stiffness times the penetration throughout, so that each tells the other.
bool is_proportional(const Course& course) {
  constexpr double seen = 0.01;  // of the peak
  const auto end = static_cast<std::ptrdiff_t>(course.end);
  const double deepest = *std::max_element(course.shortening.begin(), course.shortening.begin() + end);
  const double peak = *std::max_element(course.force.begin(), course.force.begin() + end);
  if (!(deepest > 0) || !(peak > 0)) return false;
  for (std::size_t i = 0; i < course.end; ++i) {
    if (std::abs(course.force[i] / peak - course.shortening[i] / deepest) > seen) return false;
  }
  return true;
}

std::string title(const RunResults& run, const Course& course, const FigureOptions& options) {
  return fmt::format("One impact, {}, from t = {:.4f} s", point_text(run, course.point, options), course.start);
}

/// Writes the peak above its place, with room for it.
void name_peak(Panel& panel, const RunResults& run, const Impact& impact) {
  const Curve& curve = panel.curves.front();
  const auto most = std::max_element(curve.y.begin(), curve.y.end());
  constexpr double above = 1.15;
  panel.y.least = {0, above * *most};
  panel.texts.push_back({.x = curve.x[static_cast<std::size_t>(most - curve.y.begin())],
                         .y = *most,
                         .text = fmt::format("{}, δ = {}", shown_value(run, impact.peak_force, "F"),
                                             shown_value(run, impact.peak_penetration, "L")),
                         .side = PlaceText::Side::above});
}

}  // namespace

bool is_lossless(const RunResults& run) { return loss_in(read_course(run, *run.figures.close_up)) < seen_loss; }

Figure impact_figure(const RunResults& run, const FigureOptions& options) {
  const CloseUp near = near_of(run, options);
  const Course course = read_course(run, near);
  constexpr double around = 0.08;  // of the impact, before it and after it
  const auto panel = [&](const std::string& label, const std::vector<double>& values) {
    Panel one{.x = {.from = -around * course.length, .to = (1 + around) * course.length},
              .y = {.label = label},
              .height = 3,
              .curves = {{.x = {*one.x.from}, .y = {0}, .complete = true}}};
    Curve& curve = one.curves.front();
    curve.x.insert(curve.x.end(), course.time.begin(), course.time.end());
    curve.y.insert(curve.y.end(), values.begin(), values.end());
    return one;
  };
  Panel depth = panel(with_unit(word(options, "Penetration δ"), run.c.units.length), course.shortening);
  depth.title = point_text(run, course.point, options);
  Panel force = panel(with_unit(word(options, "Contact force F"), shown_unit(run, "F")), course.force);
  force.x.label = word(options, "Time since the contact began at {} s [ms]", fmt::format("{:.4f}", course.start));
  const Impact& impact = run.response.impacts.at(near.impact);
  Figure figure{
      .title = title(run, course, options),
      .finding = word(options, "lasts {}, force up to {}, penetration up to {}", number(course.length) + " ms",
                      shown_value(run, impact.peak_force, "F"), shown_value(run, impact.peak_penetration, "L")),
      .panels = {depth, force},
      .width = options.width};
  if (!is_proportional(course)) return figure;
  force.title = depth.title;  // the course of the penetration would be the same once more
  force.height = 4.2;
  force.curves.front().label = word(options, "the penetration has this course too");
  name_peak(force, run, impact);
  figure.panels = {force};
  figure.lacks = "penetration";
  return figure;
}

Figure loop_figure(const RunResults& run, const FigureOptions& options) {
  const CloseUp near = near_of(run, options);
  const Course course = read_course(run, near);
  const auto end = course.shortening.begin() + static_cast<std::ptrdiff_t>(course.end);
  const auto deepest =
      static_cast<std::size_t>(std::max_element(course.shortening.begin(), end) - course.shortening.begin());
  const auto part = [&](std::size_t first, std::size_t last, Curve curve) {
    const auto from = static_cast<std::ptrdiff_t>(first), to = static_cast<std::ptrdiff_t>(last);
    curve.x.assign(course.shortening.begin() + from, course.shortening.begin() + to);
    curve.y.assign(course.force.begin() + from, course.force.begin() + to);
    curve.complete = true;
    return curve;
  };
  const Impact& impact = run.response.impacts.at(near.impact);
  const std::optional<double> restitution = impact.restitution();
  const std::string lost = word(options, "{} % of the work lost", number(std::round(1e3 * loss_in(course)) / 10));
  std::string found = lost;  // the speeds are not of the contact alone, which the picture shows
  if (restitution) {
    found +=
        "; " + word(options,
                    "speed of parting over that of closing, which the buildings' own stiffness changes too, e = {}",
                    fmt::format("{:.3f}", *restitution));
  }
  Curve closing = part(0, deepest + 1, {.label = word(options, "closing")});
  Curve parting =
      part(deepest, course.end,
           {.label = word(options, "parting") + ": " + lost, .tone = Tone::grey, .line = Line::dashed, .width = 1.3});
  const bool is_elastic = loss_in(course) < seen_loss;  // one lies on the other
  if (is_elastic) closing.label = word(options, "elastic: closing and parting on one line");
  if (!impact.open_ended) {  // what is left comes back without force
    parting.x.push_back(0);
    parting.y.push_back(0);
  }
  Panel panel{.title = point_text(run, course.point, options),
              .x = {.label = with_unit(word(options, "Penetration δ"), run.c.units.length), .from = 0},
              .y = {.label = with_unit(word(options, "Contact force F"), shown_unit(run, "F"))},
              .height = 5,
              .curves = {std::move(closing)}};
  if (is_elastic) {
    name_peak(panel, run, impact);
  } else {
    panel.curves.push_back(std::move(parting));
  }
  return {.title = title(run, course, options),
          .finding = word(options, "peak {} at a penetration of {}", shown_value(run, impact.peak_force, "F"),
                          shown_value(run, impact.peak_penetration, "L")) +
                     "; " + found,
          .panels = {panel},
          .width = options.width};
}

}  // namespace bentur
