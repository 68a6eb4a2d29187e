#include "bentur/report/html/internal/animation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "bentur/report/figures/internal/colours.h"
#include "bentur/report/html/report.h"
#include "bentur/report/kinds/internal/hinge_marks.h"
#include "bentur/report/scene/scene.h"

namespace bentur::html {
namespace {

using Json = nlohmann::ordered_json;

/// One sample in `stride`, floors of one instant side by side.
Json samples(const Eigen::MatrixXd& displacement, Eigen::Index stride, double scale) {
  std::string bytes;
  for (Eigen::Index frame = 0; frame < displacement.cols(); frame += stride) {
    for (Eigen::Index floor = 0; floor < displacement.rows(); ++floor) {
      const auto whole = static_cast<std::uint16_t>(std::lround(displacement(floor, frame) / scale));
      bytes += static_cast<char>(whole & 0xFFU);
      bytes += static_cast<char>(whole >> 8U);
    }
  }
  return base64(bytes);
}

/// Columns of the course at the start, the peak and the end of each impact shown and at what is shown first, by time;
/// none where it was not kept.
std::vector<Eigen::Index> key_columns(const Report& report, const std::vector<Eigen::Index>& shown) {
  const std::vector<double>& time = report.response.course.time;
  std::vector<Eigen::Index> columns;
  if (time.empty()) return columns;
  const auto add = [&](double at) {
    const auto next = std::lower_bound(time.begin(), time.end(), at);
    auto found = next == time.end() ? std::prev(next) : next;
    if (found != time.begin() && at - *std::prev(found) < *found - at) --found;
    columns.push_back(found - time.begin());
  };
  for (const Eigen::Index k : shown) {
    const Impact& impact = report.response.impacts[k];
    add(impact.start);
    if (impact.peak_force > 0) add(impact.peak_force_time);
    add(impact.end);
  }
  add(telling_instant(report.response).time);
  std::sort(columns.begin(), columns.end());
  const auto same_time = [&](Eigen::Index a, Eigen::Index b) { return time[a] == time[b]; };
  columns.erase(std::unique(columns.begin(), columns.end(), same_time), columns.end());
  return columns;
}

/// As motion.js reads it.
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
    levels.push_back({{"tone", colour(hinge_tone(level)).name}, {"text", hinge_level_text(say, scene.bounds, level)}});
  }
  return {{"dots", dots}, {"levels", levels}};
}

Json building_json(const Report& report, std::size_t b, Eigen::Index stride, const std::vector<Eigen::Index>& keys) {
  const Building& building = report.problem.buildings[b];
  const Eigen::MatrixXd displacement = scene_rows(report.response.histories, b);
  Eigen::MatrixXd exact;
  if (!keys.empty()) exact = scene_rows(report.response.course, b)(Eigen::all, keys);
  double largest = displacement.size() == 0 ? 0 : displacement.cwiseAbs().maxCoeff();
  if (exact.size() > 0) largest = std::max(largest, exact.cwiseAbs().maxCoeff());
  const double scale = largest > 0 ? largest / 32767 : 1;
  return {{"name", building.name},
          {"tone", colour(building_tone(b)).name},
          {"rows", displacement.rows()},
          {"roof", building.model.floors() - 1},
          {"scale", scale},
          {"samples", samples(displacement, stride, scale)},
          {"keys", samples(exact, 1, scale)}};
}

}  // namespace

std::string base64(const std::string& bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[group >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

std::string animation_json(const Report& report, const std::vector<Eigen::Index>& listed) {
  const Histories& histories = report.response.histories;
  const double wanted = report_output_step(report.problem);
  const double step = histories.time.size() > 1 ? histories.time[1] - histories.time[0] : report.problem.duration;
  const auto stride = std::max<Eigen::Index>(1, static_cast<Eigen::Index>(std::floor(wanted / step * (1 + 1e-9))));
  const std::vector<Eigen::Index> keys = key_columns(report, listed);
  Json key_times = Json::array();
  for (const Eigen::Index column : keys) key_times.push_back(report.response.course.time[column]);
  Json buildings = Json::array();
  for (std::size_t b = 0; b < report.problem.buildings.size(); ++b) {
    buildings.push_back(building_json(report, b, stride, keys));
  }
  Json points = Json::array();
  for (const ContactPoint& point : report.problem.points) {
    points.push_back({{"left", point.left},
                      {"leftFloor", point.left_floor},
                      {"rightFloor", point.right_floor},
                      {"elevation", point.elevation},
                      {"width", point.width}});
  }
  std::vector<Eigen::Index> by_start = listed;
  std::sort(by_start.begin(), by_start.end());
  Json impacts = Json::array();
  const ShownUnits& units = report.run.shown;
  for (const std::size_t k : by_start) {
    const Impact& impact = report.response.impacts[k];
    impacts.push_back({impact.point, impact.start, impact.end, units.force * impact.peak_force, impact.peak_force_time,
                       impact.closing_speed, k + 1});
  }
  Json words;
  for (const char* const word : {"play", "pause", "impact", "level", "show_impact"}) {
    words[word] = report.say("script." + std::string(word));
  }
  words["magnified"] = report.say("figure.text.magnified");
  const Scene scene = scene_of(report.problem, report.response);
  const Json all = {{"words", words},
                    {"units", {{"length", report.c.units.length}, {"force", units.units.force}}},
                    {"duration", report.problem.duration},
                    {"step", step * static_cast<double>(stride)},
                    {"keys", key_times},
                    {"points", points},
                    {"shown", telling_instant(report.response).time},
                    {"scene", scene_json(scene)},
                    {"hinges", hinges_json(report, scene)},
                    {"breaks", breaks_json(report, scene)},
                    {"impacts", impacts},
                    {"buildings", buildings}};
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace bentur::html
