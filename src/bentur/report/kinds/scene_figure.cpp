#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

#include "bentur/core/not_known.h"
#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/burst.h"
#include "bentur/report/kinds/internal/hinge_marks.h"
#include "bentur/report/kinds/internal/scene_panel.h"
#include "bentur/report/scene/names.h"

namespace bentur {
namespace {

bool is_of_building(const SceneShape& shape) { return shape.role >= SceneRole::wall; }

/// "impact 12: peak 5300 kN, level 300 cm", in a row of more than two buildings with theirs.
std::string impact_text(const RunResults& run, Eigen::Index index, const FigureOptions& options) {
  const Impact& impact = run.response.impacts[index];
  const Units& units = run.c.units;
  const double level = run.problem.points[impact.point].elevation;
  const bool are_many = run.problem.buildings.size() > 2;
  const std::string pair = are_many ? gap_name(run.problem, run.problem.points[impact.point].left) + ", " : "";
  return fmt::format("{}: {}, {}{}", word(options, "impact {}", std::to_string(index + 1)),
                     strength_text(run, impact, options), pair,
                     word(options, "level {}", number(level) + " " + units.length));
}

/// "t = 3.5722 s", what lies between, and what happens then.
std::string instant_text(const RunResults& run, const SceneInstant& instant, const FigureOptions& options,
                         const std::string& between = ", ") {
  return fmt::format("t = {:.4f} s{}{}", instant.time, between,
                     instant.impact ? impact_text(run, *instant.impact, options)
                     : instant.nearest != nullptr && instant.nearest->closes
                         ? inside_text(run, *instant.nearest, options)
                         : word(options, "closest, without contact"));
}

/// A floor that is inside what it faces at an instant, where no contact is modelled.
struct Inside {
  const WatchedFloor* floor = nullptr;
  double depth = 0;  ///< [length]
};

/// All of them, the deepest first.
std::vector<Inside> inside_at(const RunResults& run, const SceneInstant& instant) {
  std::vector<double> depths = depths_inside(run.problem, *instant.histories, instant.column);
  if (instant.nearest != nullptr) depths.at(instant.nearest->watched) = -instant.nearest->least_opening;
  std::vector<Inside> inside;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (run.response.watched[i].closes && depths[i] > 0) inside.push_back({&run.problem.watched[i], depths[i]});
  }
  std::stable_sort(inside.begin(), inside.end(), [](const Inside& a, const Inside& b) { return a.depth > b.depth; });
  return inside;
}

std::string text_of(const RunResults& run, const Inside& inside, const FigureOptions& options) {
  return inside_words(run.problem, *inside.floor, shown_value(run, inside.depth, "L"), run.c.units.length, options.say);
}

/// A band of hatches where a floor is inside what it faces.
Curve hatches(const Scene& scene, const ScenePlaces& places, const Inside& inside) {
  const WatchedFloor& floor = *inside.floor;
  const bool of_left = floor.floor_of == floor.left;
  const double offset = of_left ? scene.breadths[floor.floor_of] : 0;
  const auto [end, z] = places({floor.elevation, {{.building = floor.floor_of, .row = floor.floor, .offset = offset}}});
  const double depth = scene.magnification * inside.depth, tall = 0.22 * scene.storey;
  const double left = of_left ? end - depth : end;
  Curve curve{.tone = Tone::red, .width = 0.9, .complete = true};
  constexpr int lines = 7;
  for (int line = 0; line < lines; ++line) {
    const double x = left + depth * line / (lines - 1), lean = std::min(0.25 * depth, 0.5 * tall);
    for (const double side : {-1.0, 1.0}) {
      curve.x.push_back(x + side * lean);
      curve.y.push_back(z + side * tall);
    }
    curve.x.push_back(not_known);
    curve.y.push_back(not_known);
  }
  return curve;
}

}  // namespace

std::string inside_words(const Problem& problem, const WatchedFloor& floor, const std::string& depth,
                         const std::string& length, const FigureWords& say) {
  const Building& building = problem.buildings[floor.floor_of];
  const std::string& faced = problem.buildings[floor.faced()].name;
  if (floor.floor + 1 == building.model.floors()) {
    return word(say, "roof of {} {} inside {}, contact not modelled", building.name, depth, faced);
  }
  return word(say, "floor of {} at level {} {} inside {}, contact not modelled", building.name,
              number(floor.elevation) + " " + length, depth, faced);
}

Curve burst(double x, double y, double size) {
  constexpr int rays = 10;
  Curve curve{.tone = Tone::red, .width = 1.6, .complete = true};
  for (int ray = 0; ray < rays; ++ray) {
    const double angle = 2 * std::numbers::pi * (ray + 0.5) / rays;
    for (const double radius : {0.35 * size, size}) {
      curve.x.push_back(x + radius * std::cos(angle));
      curve.y.push_back(y + radius * std::sin(angle));
    }
    curve.x.push_back(not_known);
    curve.y.push_back(not_known);
  }
  return curve;
}

Curve curve_of(const SceneShape& shape, const ScenePlaces& places) {
  Curve curve{.tone = shape.tone, .width = 0.9, .complete = true};
  for (const auto& line : shape.lines) {
    if (!curve.x.empty()) {
      curve.x.push_back(not_known);
      curve.y.push_back(not_known);
    }
    for (const ScenePoint& point : line) {
      const auto [x, y] = places(point);
      curve.x.push_back(x);
      curve.y.push_back(y);
    }
  }
  return curve;
}

SceneInstant chosen_instant(const RunResults& run, const FigureOptions& options) {
  const NearestFloor* nearest = asked_nearest(run, options);
  const bool asked = (options.gap || options.elevation) && !(nearest != nullptr && run.problem.points.empty());
  return telling_instant(run.response, asked ? std::optional(chosen_point(run, options)) : std::nullopt, nearest);
}

const NearestFloor* asked_nearest(const RunResults& run, const FigureOptions& options) {
  const std::optional<NearestFloor>& nearest = run.figures.nearest;
  if (!nearest || options.elevation) return nullptr;
  return !options.gap || static_cast<Eigen::Index>(*options.gap) == nearest->gap ? &*nearest : nullptr;
}

const NearestFloor* asked_inside(const RunResults& run, const FigureOptions& options) {
  const NearestFloor* nearest = asked_nearest(run, options);
  if (nearest == nullptr || !nearest->closes || nearest->time.empty()) return nullptr;
  const auto counts = [&](const Impact& impact) {
    return !options.gap || run.problem.points[impact.point].gap == nearest->gap;
  };
  const std::vector<Impact>& impacts = run.response.impacts;
  return std::any_of(impacts.begin(), impacts.end(), counts) ? nullptr : nearest;
}

std::string inside_text(const RunResults& run, const NearestFloor& nearest, const FigureOptions& options) {
  return text_of(run, {&run.problem.watched[nearest.watched], -nearest.least_opening}, options);
}

std::string inside_besides(const RunResults& run, const FigureOptions& options) {
  const std::optional<NearestFloor>& nearest = run.figures.nearest;
  if (!nearest || !nearest->closes) return {};
  const SceneInstant instant = chosen_instant(run, options);
  const bool is_of_it = instant.nearest != nullptr;
  const std::vector<Inside> now = inside_at(run, instant);
  std::string text;
  if (now.size() > (is_of_it ? 1U : 0U)) {
    text = word(options, "Floors inside at this instant, hatched: {}; the deepest: {}", std::to_string(now.size()),
                text_of(run, now.front(), options));
  }
  if (is_of_it) return text;
  const std::string deepest =
      word(options, "{}, deepest at {}", inside_text(run, *nearest, options), seconds_text(nearest->least_time));
  return text + (text.empty() ? "" : ". ") + word(options, "At another instant: {}", deepest);
}

Panel scene_panel(const RunResults& run, const SceneInstant& instant, const FigureOptions& options, double height) {
  const Scene scene = scene_of(run.problem, run.response);
  const SceneMotion rest = at_rest(*instant.histories), now = motion_at(*instant.histories, instant.column);
  const ScenePlaces still(scene, scene.magnification, rest), places(scene, scene.magnification, now);
  const double tall = scene.top - scene.bottom, wide = places(scene.shapes.front().lines.front().back())[0];
  const double size = std::min(0.05 * std::max(tall, 0.7 * wide), 0.55 * scene.storey);  // of a burst
  const std::string factor = word(options, "magnified {} times", number(scene.magnification));
  Panel panel{.title = instant_text(run, instant, options, ", " + factor + "; "),
              .x = {.numbers = false},
              .y = {.from = scene.bottom - 0.02 * tall, .to = scene.top + 1.1 * size, .numbers = false},
              .height = height,
              .to_scale = true,
              .unit = run.c.units.length};
  std::vector<std::pair<double, double>> ends(run.problem.buildings.size(), {INFINITY, -INFINITY});
  for (const SceneShape& shape : scene.shapes) {  // as at rest
    if (!is_of_building(shape)) continue;
    Curve ghost = curve_of(shape, still);
    auto& [left, right] = ends[shape.item];
    for (const double x : ghost.x) {
      left = std::isnan(x) ? left : std::min(left, x);
      right = std::isnan(x) ? right : std::max(right, x);
    }
    ghost.tone = Tone::grey;
    ghost.line = Line::dotted;
    ghost.width = 0.7;
    panel.curves.push_back(std::move(ghost));
  }
  for (std::size_t b = 0; b < ends.size(); ++b) {
    panel.x.names.push_back(run.problem.buildings[b].name);
    panel.x.places.push_back((ends[b].first + ends[b].second) / 2);
  }
  const std::vector<std::string> in_short = short_names(panel.x.names);
  if (are_parts_of(in_short, panel.x.names)) panel.x.short_names = in_short;
  constexpr double points = 72 / 2.54 / 0.75;  // widths to a centimetre
  const double storey = scene.storey / tall * height * points;
  for (const SceneShape& shape : scene.shapes) {
    Curve curve = curve_of(shape, places);
    if (shape.role == SceneRole::ground) curve.width = 1.8;
    if (shape.role == SceneRole::column || shape.role == SceneRole::wall) {
      curve.label = run.problem.buildings[shape.item].name;
      curve.in_legend = false;
      curve.width = 1.5;
      if (shape.role == SceneRole::column && shape.item > 0) {
        curve.line = line_beside(shape.tone, tone_of(run, options, shape.item - 1));
      }
    }
    if (shape.role == SceneRole::slab) curve.width = std::min(2.6, 0.35 * storey);
    panel.curves.push_back(std::move(curve));
  }
  add_hinge_marks(panel, run, scene, places, {.time = instant.time, .storey = scene.storey / tall * height}, options);
  if (instant.point && !instant.impact) {
    const auto [x, y] = places(scene.contacts[*instant.point]);
    panel.curves.push_back({.x = {x}, .y = {y}, .tone = Tone::red, .line = Line::none, .mark = Mark::circle});
  }
  for (const Inside& one : inside_at(run, instant)) panel.curves.push_back(hatches(scene, places, one));
  std::set<Eigen::Index> strike;
  for (const Impact& impact : run.response.impacts) {
    if (instant.impact && lasts_at(impact, instant.time)) strike.insert(impact.point);
  }
  Curve struck{.label = word(options, "struck point"),
               .tone = Tone::red,
               .line = Line::none,
               .mark = Mark::disc,
               .complete = true,
               .mark_size = 1.5};  // with an edge, on lines of all tones
  Curve striking = struck;
  striking.label = word(options, "strikes now");
  striking.mark_size = 2.2;
  for (Eigen::Index i = 0; i < std::ssize(run.problem.points); ++i) {
    const auto [x, y] = places(scene.contacts[i]);
    if (strike.count(i) > 0) {
      panel.curves.push_back(burst(x, y, size));
      striking.x.push_back(x);
      striking.y.push_back(y);
    } else if (run.response.points[i].impacts > 0) {
      struck.x.push_back(x);
      struck.y.push_back(y);
    }
  }
  for (Curve* const marks : {&struck, &striking}) {
    if (!marks->x.empty()) panel.curves.push_back(std::move(*marks));
  }
  return panel;
}

Figure scene_figure(const RunResults& run, const FigureOptions& options) {
  const SceneInstant instant = chosen_instant(run, options);
  return {.title = "The buildings at one instant: " + instant_text(run, instant, options),
          .finding = instant_text(run, instant, options),
          .panels = {scene_panel(run, instant, options, 0.75 * options.width)},
          .width = options.width};
}

}  // namespace bentur
