#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_data.h"

namespace bentur {
namespace {

/// One impact in close-up.
struct Course {
  std::size_t point = 0;
  double start = 0;                             ///< of the impact [s]
  std::vector<double> time, shortening, force;  ///< since the start [ms], δ [length], F [force]
};

Course read_course(const RunData& run) {
  if (run.results.find("close_up_time") == nullptr) {
    throw NoFigure(run.impacts.empty() ? "nothing was hit in this run"
                                       : "the file has no impact in close-up: \"bentur run --figures\" adds it");
  }
  const auto number = static_cast<std::size_t>(run.results.numbers("close_up_impact").at(0));
  const RunData::Impact& impact = run.impacts.at(number);
  Course course;
  course.point = impact.point;
  course.start = impact.start;
  course.force = run.results.numbers("close_up_force");
  for (const double t : run.results.numbers("close_up_time")) course.time.push_back(1e3 * (t - impact.start));
  for (const double g : run.results.numbers("close_up_opening")) course.shortening.push_back(std::max(0.0, -g));
  return course;
}

std::string title(const RunData& run, const Course& course) {
  return fmt::format("One impact, {}, from t = {:.4f} s", run.point_name(course.point), course.start);
}

}  // namespace

Figure impact_figure(const RunData& run, const FigureOptions& options) {
  const Course course = read_course(run);
  const auto panel = [&](const std::string& label, const std::vector<double>& values) {
    Panel one;
    one.y.label = label;
    one.x.from = course.time.front();
    one.x.to = course.time.back();
    one.height = 3;
    Curve curve;
    curve.x = course.time;
    curve.y = values;
    one.curves = {curve};
    return one;
  };
  Figure figure;
  figure.title = title(run, course);
  figure.width = options.width;
  figure.panels = {panel(with_unit("Shortening δ", run.length), course.shortening),
                   panel(with_unit("Force F", run.force), course.force)};
  figure.panels.back().x.label = fmt::format("Time since the contact began at {:.4f} s [ms]", course.start);
  return figure;
}

Figure loop_figure(const RunData& run, const FigureOptions& options) {
  const Course course = read_course(run);
  const auto deepest = static_cast<std::size_t>(std::max_element(course.shortening.begin(), course.shortening.end()) -
                                                course.shortening.begin());
  Curve closing;
  closing.label = "closing";
  Curve opening;
  opening.label = "opening";
  opening.tone = Tone::orange;
  opening.line = Line::dashed;
  opening.width = 1.3;
  for (std::size_t i = 0; i < course.time.size(); ++i) {
    if (course.shortening[i] == 0 && course.force[i] == 0) continue;
    if (i <= deepest) {
      closing.x.push_back(course.shortening[i]);
      closing.y.push_back(course.force[i]);
    }
    if (i >= deepest) {
      opening.x.push_back(course.shortening[i]);
      opening.y.push_back(course.force[i]);
    }
  }
  Panel panel;
  panel.x.label = with_unit("Shortening of the contact zone δ", run.length);
  panel.x.from = 0;
  panel.y.label = with_unit("Contact force F", run.force);
  panel.height = 5;
  panel.curves = {closing, opening};
  Figure figure;
  figure.title = title(run, course);
  figure.width = options.width;
  figure.panels = {panel};
  return figure;
}

}  // namespace bentur
