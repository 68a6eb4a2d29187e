#include "bentur/report/kinds/internal/run_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bentur/report/figures/internal/text.h"

namespace bentur {
namespace {

std::size_t nearest_floor(const std::vector<double>& elevations, double elevation) {
  const auto nearer = [&](double a, double b) { return std::abs(a - elevation) < std::abs(b - elevation); };
  return static_cast<std::size_t>(std::min_element(elevations.begin(), elevations.end(), nearer) - elevations.begin());
}

}  // namespace

RunData::RunData(const NetcdfReader& from) : results(from) {
  length = unit_text(results.at("displacement_1").units);
  time = results.numbers("time");
  const std::vector<std::string> names = results.texts("building_name");
  for (std::size_t b = 0; b < names.size(); ++b) {
    const auto numbers = [&](const char* what) { return results.numbers(fmt::format("{}_{}", what, b + 1)); };
    Building building{names[b],
                      numbers("base_elevation").at(0),
                      numbers("elevation"),
                      numbers("peak_displacement"),
                      numbers("peak_displacement_no_contact"),
                      numbers("period"),
                      numbers("shape")};
    buildings.push_back(std::move(building));
  }
  if (results.find("opening") == nullptr) return;  // no contact is modelled
  force = unit_text(results.at("force").units);
  const std::vector<std::string> left = results.texts("point_left");
  const std::vector<double> elevations = results.numbers("point_elevation");
  const std::vector<double> widths = results.numbers("point_width");
  for (std::size_t i = 0; i < left.size(); ++i) {
    Point one;
    one.left = static_cast<std::size_t>(std::find(names.begin(), names.end(), left[i]) - names.begin());
    if (one.left + 1 >= names.size()) throw NoFigure(results.name() + ": its contact points name no building of it");
    one.elevation = elevations[i];
    one.width = widths[i];
    one.left_floor = nearest_floor(buildings[one.left].elevations, one.elevation);
    one.right_floor = nearest_floor(buildings[one.left + 1].elevations, one.elevation);
    points.push_back(one);
  }
  if (results.find("impact_point") == nullptr) return;
  const std::vector<double> at = results.numbers("impact_point");
  const std::vector<double> starts = results.numbers("impact_start");
  const std::vector<double> ends = results.numbers("impact_end");
  const std::vector<double> forces = results.numbers("impact_peak_force");
  const std::vector<double> times = results.numbers("impact_peak_force_time");
  for (std::size_t i = 0; i < at.size(); ++i) {
    impacts.push_back({static_cast<std::size_t>(at[i]), starts[i], ends[i], forces[i], times[i]});
  }
}

std::vector<double> RunData::history(const std::string& variable, std::size_t column) const {
  const std::vector<double> table = results.numbers(variable);
  const std::size_t columns = results.at(variable).shape.back();
  std::vector<double> values;
  for (std::size_t i = column; i < table.size(); i += columns) values.push_back(table[i]);
  return values;
}

const RunData::Impact* RunData::hardest(std::size_t point) const {
  const Impact* found = nullptr;
  for (const Impact& impact : impacts) {
    if (impact.point == point && (found == nullptr || impact.peak_force > found->peak_force)) found = &impact;
  }
  return found;
}

std::size_t RunData::point(const FigureOptions& options) const {
  std::vector<std::size_t> candidates;
  std::string known;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (options.gap && points[i].left != *options.gap) continue;
    known += (known.empty() ? "" : ", ") + number_text(points[i].elevation);
    const double tolerance = 1e-6 * std::max(1.0, std::abs(points[i].elevation));
    if (options.elevation && std::abs(points[i].elevation - *options.elevation) > tolerance) continue;
    candidates.push_back(i);
  }
  if (points.empty()) throw NoFigure("no contact is modelled in this run");
  if (known.empty() && *options.gap + 1 < buildings.size()) {
    throw NoFigure(fmt::format("no contact is modelled in gap {}", *options.gap));
  }
  if (known.empty()) {
    throw NoFigure(
        fmt::format("there is no gap {}: gaps are counted from 0 to {}", *options.gap, buildings.size() - 2));
  }
  if (candidates.empty()) {
    throw NoFigure(fmt::format("no contact point at elevation {} {}: there are {}", number_text(*options.elevation),
                               length, known));
  }
  std::size_t best = candidates.front();
  const Impact* hard = nullptr;
  for (const std::size_t i : candidates) {
    const Impact* one = hardest(i);
    if (one != nullptr && (hard == nullptr || one->peak_force > hard->peak_force)) {
      hard = one;
      best = i;
    }
  }
  if (hard != nullptr) return best;
  double closest = INFINITY;
  for (const std::size_t i : candidates) {
    const std::vector<double> opening = history("opening", i);
    const double smallest = *std::min_element(opening.begin(), opening.end());
    if (smallest < closest) {
      closest = smallest;
      best = i;
    }
  }
  return best;
}

std::vector<std::size_t> RunData::shown(const FigureOptions& options) const {
  constexpr std::size_t most = 6;
  if (buildings.size() > most) {
    const std::size_t left = points.empty() ? options.gap.value_or(0) : points[point(options)].left;
    return {left, left + 1};
  }
  std::vector<std::size_t> all(buildings.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::string RunData::place(std::size_t point) const { return number_text(points[point].elevation) + " " + length; }

std::string RunData::point_name(std::size_t point) const {
  const std::size_t left = points[point].left;
  return fmt::format("{} | {}, elevation {}", buildings[left].name, buildings[left + 1].name, place(point));
}

Mark mark_of(std::size_t index) {
  constexpr Mark marks[] = {Mark::disc, Mark::circle, Mark::square, Mark::triangle, Mark::diamond, Mark::cross};
  return marks[index % 6];
}

void tell_apart(Curve& curve, std::size_t index) {
  constexpr Tone tones[] = {Tone::black, Tone::orange, Tone::blue, Tone::grey};
  constexpr Line lines[] = {Line::solid, Line::dashed, Line::dash_dot, Line::dotted};
  curve.tone = tones[index % 4];
  curve.line = lines[(index + index / 4) % 4];
  constexpr std::size_t most_marks = 25;
  curve.mark = curve.x.size() <= most_marks ? mark_of(index) : Mark::none;
}

}  // namespace bentur
