#include "bentur/report/html/internal/animation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "bentur/report/figures/internal/colours.h"
#include "bentur/report/html/internal/motion_data.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/report/html/report.h"
#include "bentur/report/kinds/internal/hinge_marks.h"
#include "bentur/report/kinds/internal/scene_panel.h"
#include "bentur/report/scene/scene.h"
#include "bentur/report/scene/tones.h"

namespace bentur::html {
namespace {

/// As row.js reads it.
Json point_json(const ScenePoint& point) {
  Json json = {point.height};
  for (const SceneMover& mover : point.movers) {
    json.insert(json.end(), {mover.building, mover.row.value_or(-1), mover.weight, mover.offset, mover.apart});
  }
  return json;
}

Json scene_json(const Scene& scene) {
  Json shapes = Json::array(), contacts = Json::array();
  for (const SceneShape& shape : scene.shapes) {
    Json lines = Json::array();
    for (const auto& line : shape.lines) {
      Json& points = lines.emplace_back(Json::array());
      for (const ScenePoint& point : line) points.push_back(point_json(point));
    }
    shapes.push_back({{"role", role_name(shape.role)}, {"tone", colour(shape.tone).name}, {"lines", lines}});
  }
  for (const ScenePoint& point : scene.contacts) contacts.push_back(point_json(point));
  return {{"breadths", scene.breadths},
          {"gaps", scene.gaps},
          {"bottom", scene.bottom},
          {"top", scene.top},
          {"storey", scene.storey},
          {"largest", scene.largest},
          {"magnification", scene.magnification},
          {"shapes", shapes},
          {"contacts", contacts}};
}

/// Columns that break: where and when, and what the crosses mean.
Json breaks_json(const Report& report, const Scene& scene) {
  Json all = Json::array();
  for (const SceneBreak& one : scene.breaks) all.push_back({{"at", point_json(one.at)}, {"time", one.time}});
  return {{"crosses", all}, {"text", report.say("figure.text.broken")}};
}

/// Hinges that form: where, when they come to each level (null: never), and their names; and what each level means.
Json hinges_json(const Report& report, const Scene& scene) {
  const FigureWords say = figure_words(report.say.language());
  Json dots = Json::array(), levels = Json::array();
  int worst = 0;
  for (const SceneHinge& hinge : scene.hinges) {
    if (hinge.order == 0) continue;
    Json reached = Json::array();
    for (const double at : hinge.reached) reached.push_back(std::isfinite(at) ? Json(at) : Json());
    const HingePlace& place = report.problem.buildings[hinge.building].model.hinges.places[hinge.hinge];
    dots.push_back({{"at", point_json(hinge.at)}, {"reached", reached}, {"name", hinge_name(say, place)}});
    worst = std::max(worst, hinge.level(report.problem.duration));
  }
  for (int level = 1; level <= worst; ++level) {
    constexpr const char* signs[] = {"\u25cb", "\u25cf", "\u25a0", "\u25c6"};  // as hinge_mark() says
    levels.push_back({{"tone", colour(hinge_tone(scene.bounds, level)).name},
                      {"mark", signs[level - 1]},
                      {"text", hinge_level_text(say, scene.bounds, level)}});
  }
  return {{"dots", dots}, {"levels", levels}};
}

/// How the opening of a watched floor hangs on the rows of the scene: [building, row, weight] of each that it does;
/// nothing where it hangs on what is no row of it.
std::optional<Json> opening_json(const Report& report, const WatchedFloor& floor) {
  if (report.problem.kinematics == Kinematics::absolute) return std::nullopt;  // the ground's displacement counts
  Json all = Json::array();
  for (const auto& [building, row, sign] :
       {std::tuple(floor.left, &floor.left_row, -1.0), {floor.right, &floor.right_row, 1.0}}) {
    if (row->size() == 0) return std::nullopt;  // of results read back without their case
    const Eigen::Index known = scene_rows(report.response.histories, static_cast<std::size_t>(building)).rows();
    for (Eigen::Index i = 0; i < row->size(); ++i) {
      if ((*row)(i) == 0) continue;
      if (i >= known) return std::nullopt;
      all.push_back({building, i, sign * (*row)(i)});
    }
  }
  return all;
}

/// Floors that go inside what they face in the run, where no contact is modelled.
Json watched_json(const Report& report, const Scene& scene) {
  Json all = Json::array();
  const FigureWords say = figure_words(report.say.language());
  for (std::size_t i = 0; i < report.problem.watched.size(); ++i) {
    const WatchedFloor& floor = report.problem.watched[i];
    if (i >= report.response.watched.size() || !report.response.watched[i].closes) continue;
    const std::optional<Json> opening = opening_json(report, floor);
    if (!opening) continue;
    const bool of_left = floor.floor_of == floor.left;
    const ScenePoint edge{
        floor.elevation,
        {{.building = floor.floor_of, .row = floor.floor, .offset = of_left ? scene.breadths[floor.floor_of] : 0}}};
    all.push_back({{"left", floor.left},
                   {"elevation", floor.elevation},
                   {"width", floor.width},
                   {"opening", *opening},
                   {"edge", point_json(edge)},
                   {"inwards", of_left ? -1 : 1},
                   {"text", inside_words(report.problem, floor, "{}", report.c.units.length, say)}});
  }
  return all;
}

}  // namespace

std::string animation_json(const RunResults& run, const std::vector<Eigen::Index>& listed, const Words& say) {
  const Report report{run.view(), run.c, run.problem, run.response, say};
  const Histories& histories = report.response.histories;
  const MotionSampling sampling = motion_sampling(histories.time, report_output_step(report.problem));
  const std::optional<NearestFloor> nearest = nearest_floor(report.problem, report.response);
  const double instant = telling_instant(report.response, {}, nearest ? &*nearest : nullptr).time;
  const std::vector<double>& course = report.response.course.time;
  const std::vector<Eigen::Index> keys = key_columns(course, report.response.impacts, listed, instant);
  const std::vector<Tone> tones = tones_of(report.problem, report.response);
  Json buildings = Json::array();
  std::vector<std::string> names;
  for (std::size_t b = 0; b < report.problem.buildings.size(); ++b) {
    const Building& building = report.problem.buildings[b];
    names.push_back(building.name);
    Eigen::MatrixXd exact;
    if (!keys.empty()) exact = scene_rows(report.response.course, b)(Eigen::all, keys);
    Json one = {{"name", building.name}, {"tone", colour(tones[b]).name}, {"roof", building.model.floors() - 1}};
    one.update(samples_json(scene_rows(histories, b), sampling, exact));
    buildings.push_back(one);
  }
  Json points = Json::array();
  for (const ContactPoint& point : report.problem.points) {
    points.push_back({{"left", point.left},
                      {"leftFloor", point.left_floor},
                      {"rightFloor", point.right_floor},
                      {"elevation", point.elevation},
                      {"width", point.width}});
  }
  const Scene scene = scene_of(report.problem, report.response);
  Json all = {{"units", {{"length", report.c.units.length}, {"force", report.run.shown.units.force}}},
              {"duration", report.problem.duration},
              {"points", points},
              {"shown", instant},
              {"scene", scene_json(scene)},
              {"watched", watched_json(report, scene)},
              {"hinges", hinges_json(report, scene)},
              {"breaks", breaks_json(report, scene)},
              {"names", names_json(names)},
              {"buildings", buildings}};
  all.update(played_json(sampling, course, keys, report.response.impacts, listed, report.run.shown.force, report.say));
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace bentur::html
