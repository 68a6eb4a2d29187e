#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bentur/core/number_text.h"
#include "bentur/model/story/worst_hinges.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/hinge_marks.h"
#include "bentur/report/kinds/internal/scene_panel.h"

namespace bentur {
namespace {

constexpr double milli = 1e3;
constexpr std::array<const char*, 3> level_names{"IO", "LS", "CP"};
constexpr double pixels = 96 / 2.54;  // to a centimetre

/// Those of a building that have yielded, the one that turned furthest first; of one floor where the options name it.
std::vector<Eigen::Index> turned_most(const RunResults& run, Eigen::Index b, const FigureOptions& options) {
  const StructuralModel& model = run.problem.buildings[b].model;
  std::vector<Eigen::Index> found;
  for (const Eigen::Index h : worst_hinges(run.response.buildings[b])) {
    const Eigen::Index floor = model.hinges.places.at(h).level - 1 + model.first_storey();
    if (is_at(options, model.elevations.at(floor))) found.push_back(h);
  }
  return found;
}

/// "12 of 20 hinges form, first the bottom of …, at 1.02 s".
std::string formed_text(const RunResults& run, Eigen::Index b, const FigureOptions& options) {
  const BuildingPeaks& peaks = run.response.buildings[b];
  const std::vector<std::vector<Eigen::Index>> order = hinge_order(peaks, run.problem.duration);
  std::size_t formed = 0;
  for (const std::vector<Eigen::Index>& group : order) formed += group.size();
  std::string text = run.problem.buildings[b].name + ": " +
                     word(options, "{} of {} hinges form", std::to_string(formed), std::to_string(peaks.hinges.size()));
  if (order.empty()) return text;
  const Eigen::Index first = order.front().front();
  text += ", " + word(options, "the first at {}: {}", seconds_text(*peaks.hinges[first].first_yield),
                      hinge_name(options.say, run.problem.buildings[b].model.hinges.places[first]));
  return text;
}

}  // namespace

std::string hinge_name(const FigureWords& say, const HingePlace& place) {
  constexpr const char* texts[] = {
      "bottom of the column of line {}, storey {}", "struck place of the column of line {}, storey {}",
      "top of the column of line {}, storey {}", "left end of the beam of bay {}, floor {}",
      "right end of the beam of bay {}, floor {}"};  // in the order of HingePlace::End
  return word(say, texts[static_cast<std::size_t>(place.end)], std::to_string(place.number),
              std::to_string(place.level));
}

std::string hinge_level_text(const FigureWords& say, const HingeBounds& bounds, int level) {
  if (level <= 1) return word(say, "has yielded");
  const auto bound = static_cast<std::size_t>(level) - 2;
  if (bounds.are_limits) return word(say, "beyond {}", level_names.at(bound));
  constexpr std::array<const char*, 3> parts{"1/4", "1/2", "3/4"};
  return word(say, "over {} mrad, {} of the largest", number(milli * HingeBounds::parts.at(bound) * bounds.largest),
              parts.at(bound));
}

void add_hinge_marks(Panel& panel, const RunResults& run, const Scene& scene, const ScenePlaces& places,
                     const HingeMarks& wanted, const FigureOptions& options) {
  constexpr double of_mark = 1.6;  // radius of a mark of size 1 [px]
  const double radius = std::clamp(0.1 * wanted.storey * pixels, 1.4, 3.4);
  for (int level = wanted.with_those_at_rest ? 0 : 1; level <= SceneHinge::levels; ++level) {
    Curve marks{.line = Line::none, .mark = hinge_mark(level), .complete = true};
    marks.tone = level == 0 ? Tone::grey : hinge_tone(scene.bounds, level);
    marks.mark_size = radius / of_mark * (level == 0 ? 0.6 : 0.85 + 0.15 * level);  // they grow with the level
    if (level > 0) marks.mark_size = std::max(marks.mark_size, 1.5);                // with an edge
    for (const SceneHinge& hinge : scene.hinges) {
      if ((wanted.of && hinge.building != *wanted.of) || hinge.level(wanted.time) != level) continue;
      const auto [x, y] = places(hinge.at);
      marks.x.push_back(x);
      marks.y.push_back(y);
      if (!wanted.numbered || hinge.order == 0) continue;
      // Around a joint each in a quarter of its own.
      using Side = PlaceText::Side;
      constexpr Side sides[] = {Side::left, Side::right, Side::right, Side::above, Side::below};
      const HingePlace& place = run.problem.buildings[hinge.building].model.hinges.places[hinge.hinge];
      const Side side = sides[static_cast<std::size_t>(place.end)];
      panel.texts.push_back({.x = x, .y = y, .text = std::to_string(hinge.order), .side = side});
    }
    if (marks.x.empty()) continue;
    marks.label = level == 0 ? word(options, "has not yielded") : hinge_level_text(options.say, scene.bounds, level);
    panel.curves.push_back(std::move(marks));
  }
  Curve broken{.label = word(options, "broken in shear"),
               .tone = Tone::red,
               .line = Line::none,
               .mark = Mark::cross,
               .complete = true};
  broken.mark_size = 1.5 * radius / of_mark;
  for (const SceneBreak& one : scene.breaks) {
    if ((wanted.of && one.building != *wanted.of) || one.time > wanted.time) continue;
    const auto [x, y] = places(one.at);
    broken.x.push_back(x);
    broken.y.push_back(y);
  }
  if (!broken.x.empty()) panel.curves.push_back(std::move(broken));
}

Figure hinges_figure(const RunResults& run, const FigureOptions& options) {
  std::vector<Eigen::Index> shown = shown_buildings(run, options);
  std::erase_if(shown, [&](Eigen::Index b) { return run.response.buildings[b].hinges.empty(); });
  if (shown.empty()) throw NoFigure("no building shown can form hinges: moment_capacity of sections lets it");
  const bool is_broad = shown.size() > 1 && !options.narrow;
  Figure figure{.title = "Hinges by how far they turned, numbered in the order in which they formed",
                .columns = is_broad ? 2 : 1,
                .width = is_broad ? broad(options.width) : options.width,
                .shared_legend = true};
  const double room = figure.width / figure.columns - 0.7;  // of a frame [cm]
  const Scene scene = scene_of(run.problem, run.response);
  const SceneMotion rest = at_rest(run.response.histories);
  const ScenePlaces places(scene, 1, rest);
  for (const Eigen::Index b : shown) {
    const StructuralModel& model = run.problem.buildings[b].model;
    const double foot = base_of(run.problem.buildings[b]), tall = model.elevations.back() - foot;
    const double height = 0.95 * options.width;  // [cm]
    const double scale = std::min(height / (1.12 * tall), room / (scene.breadths[b] + 0.24 * tall));
    Panel panel{.title = run.problem.buildings[b].name,
                .x = {.numbers = false},
                .y = {.from = foot - 0.04 * tall, .to = foot + 1.08 * tall, .numbers = false},
                .height = height,
                .to_scale = true,
                .unit = run.c.units.length};
    double narrowest = model.storey_heights.back();
    for (Eigen::Index storey = model.first_storey(); storey < model.floors(); ++storey) {
      narrowest = std::min(narrowest, model.storey_heights[storey]);
    }
    for (const SceneShape& shape : scene.shapes) {
      if (shape.role < SceneRole::wall || shape.item != b) continue;
      Curve curve = curve_of(shape, places);
      curve.width = shape.role == SceneRole::slab ? 1.6 : 1.2;
      panel.curves.push_back(std::move(curve));
    }
    const double left = places({foot, {{.building = b}}})[0], beside = 0.12 * tall;
    panel.x.from = left - beside;
    panel.x.to = left + scene.breadths[b] + beside;
    constexpr double least = 0.85;  // storey in which there is room for numbers [cm]
    if (scale * narrowest >= least) panel.title += ", " + word(options, "numbered as they form");
    add_hinge_marks(panel, run, scene, places,
                    {.time = std::numeric_limits<double>::max(),
                     .storey = scale * narrowest,
                     .of = b,
                     .with_those_at_rest = true,
                     .numbered = scale * narrowest >= least},
                    options);
    figure.finding += (figure.finding.empty() ? "" : "; ") + formed_text(run, b, options);
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

Figure hinge_loop_figure(const RunResults& run, const FigureOptions& options) {
  Figure figure{.title = "Moment over rotation of the hinge of each building that turned furthest",
                .width = options.width};
  for (const Eigen::Index b : shown_buildings(run, options)) {
    const Histories& histories = histories_with(run, &Histories::hinge_rotation, b);
    const std::vector<Eigen::Index> turned = turned_most(run, b, options);
    if (turned.empty() || std::ssize(histories.hinge_rotation) <= b || histories.hinge_rotation[b].size() == 0)
      continue;
    const Eigen::Index h = turned.front();
    const Building& building = run.problem.buildings[b];
    const BuildingPeaks::Hinge& hinge = run.response.buildings[b].hinges[h];
    const auto moment = histories.hinge_moment[b].row(h);
    Curve curve;
    for (const double rotation : histories.hinge_rotation[b].row(h)) curve.x.push_back(milli * rotation);
    curve.y = shown_values(run, {moment.begin(), moment.end()}, "F L");
    Panel panel{.title = building.name + ", " + hinge_name(options.say, building.model.hinges.places[h]),
                .x = {.label = word(options, "Rotation θ [mrad]")},
                .y = {.label = with_unit(word(options, "Moment M"), shown_unit(run, "F L"))},
                .height = 5,
                .curves = {curve}};
    const Eigen::MatrixXd& limits = building.model.hinges.rotation_limits;
    constexpr Line lines[] = {Line::dotted, Line::dashed, Line::dash_dot};
    for (Eigen::Index level = 0; level < 3 && h < limits.rows(); ++level) {  // those it comes near
      if (!(limits(h, level) < 1.1 * hinge.peak_rotation)) continue;
      const double at = milli * limits(h, level);
      panel.rules.push_back({.at = at,
                             .vertical = true,
                             .label = word(options, "limit {}", level_names.at(level)),
                             .line = lines[level]});
      panel.rules.push_back({.at = -at, .vertical = true, .line = lines[level]});
    }
    figure.finding +=
        (figure.finding.empty() ? "" : "; ") + panel.title + ": " +
        word(options, "turns by up to {} mrad, {} mrad at the end; {} dissipated", number(milli * hinge.peak_rotation),
             number(milli * hinge.residual_rotation), shown_value(run, hinge.dissipated_energy, "F L"));
    figure.panels.push_back(std::move(panel));
  }
  if (figure.panels.empty()) throw NoFigure("no hinge has formed there: moment_capacity of sections lets hinges form");
  return figure;
}

}  // namespace bentur
