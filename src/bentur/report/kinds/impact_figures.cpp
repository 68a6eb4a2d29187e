#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"

namespace bentur {
namespace {

/// One impact in close-up.
struct Course {
  Eigen::Index point = 0;
  double start = 0;                             ///< of the impact [s]
  std::vector<double> time, shortening, force;  ///< since the start [ms], δ [length], F [force]
  double length = 0;                            ///< of the impact [ms]

  [[nodiscard]] bool is_in_contact(std::size_t i) const {
    return time[i] >= -1e-9 * length && time[i] <= (1 + 1e-9) * length;
  }
};

Course read_course(const RunResults& run) {
  if (!run.figures.close_up) {
    throw NoFigure(run.response.impacts.empty()
                       ? "nothing was hit in this run"
                       : "the file has no impact in close-up: \"bentur run --figures\" adds it");
  }
  const CloseUp& near = *run.figures.close_up;
  const Impact& impact = run.response.impacts.at(near.impact);
  Course course;
  course.point = impact.point;
  course.start = impact.start;
  course.length = 1e3 * (impact.end - impact.start);
  course.force = near.force;
  for (const double t : near.time) course.time.push_back(1e3 * (t - impact.start));
  for (const double g : near.opening) course.shortening.push_back(std::max(0.0, -g));
  return course;
}

/// The part of the work done while closing that parting does not give back [-].
double loss_in(const Course& course) {
  double taken = 0;
  double lost = 0;
  for (std::size_t i = 1; i < course.time.size(); ++i) {
    if (!course.is_in_contact(i) || !course.is_in_contact(i - 1)) continue;
    const double work = (course.shortening[i] - course.shortening[i - 1]) * (course.force[i] + course.force[i - 1]) / 2;
    taken += std::max(work, 0.0);
    lost += work;
  }
  return taken > 0 ? std::max(lost / taken, 0.0) : 0;
}

std::string title(const RunResults& run, const Course& course, const FigureOptions& options) {
  return fmt::format("One impact, {}, from t = {:.4f} s", point_text(run, course.point, options), course.start);
}

}  // namespace

bool is_lossless(const RunResults& run) {
  constexpr double seen = 1e-3;
  return loss_in(read_course(run)) < seen;
}

Figure impact_figure(const RunResults& run, const FigureOptions& options) {
  const Course course = read_course(run);
  const auto panel = [&](const std::string& label, const std::vector<double>& values) {
    return Panel{.x = {.from = course.time.front(), .to = course.time.back()},
                 .y = {.label = label},
                 .height = 3,
                 .curves = {{.x = course.time, .y = values}}};
  };
  Panel depth = panel(with_unit(word(options, "Penetration δ"), run.c.units.length), course.shortening);
  depth.title = point_text(run, course.point, options);
  Panel force = panel(with_unit(word(options, "Contact force F"), run.c.units.force), course.force);
  force.x.label = word(options, "Time since the contact began at {} s [ms]", fmt::format("{:.4f}", course.start));
  return {.title = title(run, course, options), .panels = {depth, force}, .width = options.width};
}

Figure loop_figure(const RunResults& run, const FigureOptions& options) {
  const Course course = read_course(run);
  const auto deepest = static_cast<std::size_t>(std::max_element(course.shortening.begin(), course.shortening.end()) -
                                                course.shortening.begin());
  const auto part = [&](std::size_t first, std::size_t last, Curve curve) {
    for (std::size_t i = first; i <= last; ++i) {
      if (!course.is_in_contact(i)) continue;
      curve.x.push_back(course.shortening[i]);
      curve.y.push_back(course.force[i]);
    }
    return curve;
  };
  const std::optional<double> restitution = run.response.impacts.at(run.figures.close_up->impact).restitution();
  const std::string obtained = restitution ? fmt::format("e = {:.3f}, ", *restitution) : "";
  const std::string lost = word(options, "{} % lost", number_text(std::round(1e3 * loss_in(course)) / 10));
  const Panel panel{.title = point_text(run, course.point, options),
                    .x = {.label = with_unit(word(options, "Penetration δ"), run.c.units.length), .from = 0},
                    .y = {.label = with_unit(word(options, "Contact force F"), run.c.units.force)},
                    .height = 5,
                    .curves = {part(0, deepest, {.label = word(options, "closing")}),
                               part(deepest, course.time.size() - 1,
                                    {.label = word(options, "parting") + ": " + obtained + lost,
                                     .tone = Tone::orange,
                                     .line = Line::dashed,
                                     .width = 1.3})}};
  return {.title = title(run, course, options), .panels = {panel}, .width = options.width};
}

}  // namespace bentur
