#include "bentur/report/html/internal/animation.h"

#include <algorithm>
#include <cmath>

#include "bentur/report/figures/internal/colours.h"
#include "bentur/report/html/internal/motion_data.h"
#include "bentur/report/html/report.h"
#include "bentur/report/kinds/internal/hinge_marks.h"
#include "bentur/report/scene/scene.h"

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

}  // namespace

std::string animation_json(const Report& report, const std::vector<Eigen::Index>& listed) {
  const Histories& histories = report.response.histories;
  const MotionSampling sampling = motion_sampling(histories.time, report_output_step(report.problem));
  const std::optional<NearestFloor> nearest = nearest_floor(report.problem, report.response);
  const double instant = telling_instant(report.response, {}, nearest ? &*nearest : nullptr).time;
  const std::vector<double>& course = report.response.course.time;
  const std::vector<Eigen::Index> keys = key_columns(course, report.response.impacts, listed, instant);
  Json buildings = Json::array();
  std::vector<std::string> names;
  for (std::size_t b = 0; b < report.problem.buildings.size(); ++b) {
    const Building& building = report.problem.buildings[b];
    names.push_back(building.name);
    Eigen::MatrixXd exact;
    if (!keys.empty()) exact = scene_rows(report.response.course, b)(Eigen::all, keys);
    Json one = {
        {"name", building.name}, {"tone", colour(building_tone(b)).name}, {"roof", building.model.floors() - 1}};
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
              {"hinges", hinges_json(report, scene)},
              {"breaks", breaks_json(report, scene)},
              {"names", names_json(names)},
              {"buildings", buildings}};
  all.update(played_json(sampling, course, keys, report.response.impacts, listed, report.run.shown.force, report.say));
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace bentur::html
