#include "bentur/report/html/internal/animation.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "bentur/model/plan/plan_places.h"
#include "bentur/report/figures/internal/colours.h"
#include "bentur/report/html/internal/motion_data.h"
#include "bentur/report/kinds/internal/plan_figures.h"
#include "bentur/report/scene/names.h"
#include "bentur/report/scene/plan_scene.h"
#include "bentur/report/scene/tones.h"

namespace bentur::html {
namespace {

using Eigen::Index;

/// As plan.js reads it.
Json point_json(const PlanScene& scene, const PlanPoint& at) {
  const PlanPoint spread = scene.spread(at);
  return {at.x(), at.y(), spread.x(), spread.y()};
}

/// Elevations at which floors meet, from the top down.
std::vector<double> levels_of(const PlanProblem& problem) {
  std::vector<double> levels;
  for (const PlanGap& gap : problem.gaps) {
    for (const PlanContact& contact : gap.contacts) levels.push_back(contact.elevation);
  }
  std::sort(levels.begin(), levels.end(), std::greater<>());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

Index number_of(const std::vector<double>& levels, double elevation) {
  return std::find(levels.begin(), levels.end(), elevation) - levels.begin();
}

/// A length by which a rotation is as large as the displacements beside it [length].
double arm_of(const PlanProblem& problem) {
  double longest = 0;
  for (const PlanBuilding& building : problem.buildings) {
    longest = std::max(longest, building.model.footprint.size.maxCoeff());
  }
  return longest / 2;
}

/// Of contacts and seams: which of them touch only while others of their meeting are closed.
void add_meeting(Json& place, Index gap, double elevation, Index pair, Index family) {
  place["meeting"] = {gap, elevation, pair};
  place["family"] = family;
}

/// Two floors and where they face each other.
Json facing_json(const PlanGap& gap, Index left_floor, Index right_floor, const StretchCorner& at,
                 const PlanScene& scene) {
  return {{"left", gap.left},
          {"right", gap.right},
          {"leftFloor", left_floor},
          {"rightFloor", right_floor},
          {"normal", {at.normal.x(), at.normal.y()}},
          {"width", gap.stretch.width + at.beyond},
          {"faces", {point_json(scene, at.left), point_json(scene, at.right)}}};
}

/// Where nothing acts, but contacts of the same meeting hang on whether it is closed.
Json seams_json(const PlanRun& run, const PlanScene& scene) {
  Json seams = Json::array();
  for (std::size_t g = 0; g < run.problem.gaps.size(); ++g) {
    const PlanGap& gap = run.problem.gaps[g];
    for (const PlanSeam& seam : gap.seams) {
      Json& one = seams.emplace_back(facing_json(gap, seam.left_floor, seam.right_floor, seam.at, scene));
      add_meeting(one, static_cast<Index>(g), seam.elevation, seam.pair, seam.family);
    }
  }
  return seams;
}

/// Where the name of each building stands: both ends of a row within its outline.
Json name_rows_json(const PlanRun& run, const PlanScene& scene) {
  Json rows = Json::array();
  const double height = (scene.upper() - scene.lower()).maxCoeff();
  for (const PlanBuilding& building : run.problem.buildings) {
    const PlanRings rings = scene.outlines(building.model.footprint);
    NameRows within{.parts = {0.8, 0.2, 0.5}, .half_height = 0.02 * height};
    PlaceText at = place_of_name(building.name, rings, within);
    if (!(at.room > 0)) {  // of a narrow one
      within.half_height = 0;
      at = place_of_name(building.name, rings, within);
    }
    rows.push_back({point_json(scene, {at.x - at.room / 2, at.y}), point_json(scene, {at.x + at.room / 2, at.y})});
  }
  return rows;
}

Json scene_json(const PlanRun& run, const PlanScene& scene, const std::vector<double>& levels, Index shown) {
  Json outlines = Json::array(), further = Json::array(), centres = Json::array(), marks = Json::array(),
       told = Json::array();
  Json gaps = Json::array(), links = Json::array();
  for (const PlanBuilding& building : run.problem.buildings) {
    const PlanModel& model = building.model;
    std::vector<Json> rings;
    for (const std::vector<PlanPoint>& ring : scene.outlines(model.footprint)) {
      Json& line = rings.emplace_back(Json::array());
      for (const PlanPoint& at : ring) line.push_back(point_json(scene, at));
    }
    outlines.push_back(rings.front());
    further.push_back(Json(std::vector<Json>(rings.begin() + 1, rings.end())));
    Json& about = centres.emplace_back(Json::array());
    for (const PlanPoint& centre : model.centres) {
      const PlanPoint at = model.footprint.corner + centre;
      about.push_back({at.x(), at.y()});
    }
  }
  for (const PlanCentre& centre : centres_of(run)) {
    marks.push_back({{"building", centre.building},
                     {"floor", centre.floor},
                     {"at", point_json(scene, centre.at)},
                     {"cross", centre.of_rigidity}});
  }
  for (const PlanGap& gap : run.problem.gaps) {
    for (const StretchCorner& corner : merged_corners(run.problem, gap)) {
      for (const auto& [building, at] : {std::pair(gap.left, corner.left), {gap.right, corner.right}}) {
        marks.push_back({{"building", building}, {"at", point_json(scene, at)}, {"merged", true}});
      }
    }
  }
  for (const double level : levels) {
    Json floors = Json::array(), lower = Json::array();  // buildings that end below the level
    for (const PlanBuilding& building : run.problem.buildings) {
      const PlanModel& model = building.model;
      floors.push_back(nearest_floor(model, level));
      lower.push_back(model.elevations.back() < level - model.storey_heights.back() / 2);
    }
    told.push_back({{"elevation", level}, {"floors", floors}, {"lower", lower}});
  }
  for (const PlanGap& gap : run.problem.gaps) gaps.push_back(gap.stretch.width);
  for (const PlanLink& link : run.problem.links) {
    const Stretch& stretch = link.stretch;
    const auto floor = [&](Index b) { return nearest_floor(run.problem.buildings[b].model, link.link.elevation); };
    links.push_back(
        {{"left", link.link.left},
         {"right", link.link.right},
         {"leftFloor", floor(link.link.left)},
         {"rightFloor", floor(link.link.right)},
         {"faces",
          {point_json(scene, stretch.on_edge(0, link.along)), point_json(scene, stretch.on_edge(1, link.along))}}});
  }
  return {{"outlines", outlines},
          {"names", name_rows_json(run, scene)},
          {"rings", further},
          {"centres", centres},
          {"arm", arm_of(run.problem)},
          {"marks", marks},
          {"links", links},
          {"levels", told},
          {"level", shown},
          {"gaps", gaps},
          {"seams", seams_json(run, scene)},
          {"largest", scene.largest()},
          {"magnification", scene.magnification()}};
}

/// What the marks of the picture mean, in lines.
Json key_of(const PlanRun& run, const Words& say) {
  const auto entry = [&](const char* tone, const char* mark, const char* text) -> Json {
    return {{"tone", tone}, {"mark", mark}, {"text", say("figure.text." + std::string(text))}};
  };
  Json key = Json::array();
  if (!centres_of(run).empty()) {
    key.push_back({entry("ink", "●", "centre_of_mass"), entry("ink", "×", "centre_of_rigidity")});
  }
  if (!run.problem.links.empty()) key.push_back({entry("ink", "━", "link")});
  Json contacts = {entry("grey", "○", "contact_point"), entry("red", "○", "contact_point_struck")};
  const auto merges = [&](const PlanGap& gap) { return !merged_corners(run.problem, gap).empty(); };
  if (std::any_of(run.problem.gaps.begin(), run.problem.gaps.end(), merges)) {
    contacts.push_back(entry("grey", "△", "merged_corner"));
  }
  key.push_back(std::move(contacts));
  return key;
}

/// Of a building that moves three rows for each floor; of a wall none.
Eigen::MatrixXd rows_of(const PlanRun& run, const PlanHistories& histories, std::size_t b, double arm) {
  const PlanBuilding& building = run.problem.buildings[b];
  if (building.is_rigid()) return {};
  Eigen::MatrixXd rows(3 * building.model.floors(), std::ssize(histories.time));
  for (Index floor = 0; floor < building.model.floors(); ++floor) {
    rows.row(3 * floor) = histories.x[b].row(floor);
    rows.row(3 * floor + 1) = histories.y[b].row(floor);
    rows.row(3 * floor + 2) = arm * histories.rotation[b].row(floor);
  }
  return rows;
}

Json points_json(const PlanRun& run, const PlanScene& scene, const std::vector<double>& levels) {
  Json points = Json::array();
  for (Index i = 0; i < std::ssize(run.response.points); ++i) {
    const PlanContactPlace place = contact_at(run.problem, i);
    const PlanGap& gap = run.problem.gaps[place.gap];
    const PlanContact& contact = *place.contact;
    Json& one = points.emplace_back(facing_json(gap, floor_at(run.problem, gap, contact, 0),
                                                floor_at(run.problem, gap, contact, 1), gap.at(contact), scene));
    one.update({{"gap", place.gap},
                {"elevation", contact.elevation},
                {"level", number_of(levels, contact.elevation)},
                {"along", along_text(run, i)},
                {"struck", run.response.points[i].impacts > 0}});
    if (contact.family >= 0) add_meeting(one, place.gap, contact.elevation, contact.pair, contact.family);
  }
  return points;
}

}  // namespace

std::string animation_json(const PlanRun& run, const std::vector<Index>& listed, const Words& say) {
  const PlanHistories& samples = run.response.histories;
  const PlanHistories& course = run.response.course.time.empty() ? samples : run.response.course;
  std::vector<Index> all_points(run.response.points.size());
  std::iota(all_points.begin(), all_points.end(), Index{0});
  const PlanInstant instant = telling_instant(run.response, all_points);
  const PlanContactPlace hardest = contact_at(run.problem, instant.point.value());
  const int across = run.problem.gaps[hardest.gap].stretch.across;
  Index moving = 0;
  for (const PlanBuilding& building : run.problem.buildings)
    moving += building.is_rigid() ? 0 : 3 * building.model.floors();
  const MotionSampling sampling = motion_sampling(samples.time, motion_step(run.problem.duration, moving));
  const std::vector<Index> keys = key_columns(course.time, run.response.impacts, listed, instant.time);
  const double arm = arm_of(run.problem);
  const std::vector<Tone> tones = tones_of(run.problem, run.response);
  Json buildings = Json::array();
  for (std::size_t b = 0; b < run.problem.buildings.size(); ++b) {
    const PlanBuilding& building = run.problem.buildings[b];
    const Eigen::MatrixXd rows = rows_of(run, samples, b, arm);
    Eigen::MatrixXd exact;
    if (rows.size() > 0) exact = rows_of(run, course, b, arm)(Eigen::all, keys);
    Json one = {
        {"name", building.name}, {"tone", colour(tones[b]).name}, {"roof", 3 * (building.model.floors() - 1) + across}};
    one.update(samples_json(rows, sampling, exact));
    buildings.push_back(one);
  }
  const PlanScene scene(run);
  const std::vector<double> levels = levels_of(run.problem);
  const ShownUnits units = shown_units(run);
  Json all = {{"units", {{"length", run.c.units.length}, {"force", units.units.force}}},
              {"duration", run.problem.duration},
              {"points", points_json(run, scene, levels)},
              {"shown", instant.time},
              {"scene", scene_json(run, scene, levels, number_of(levels, hardest.contact->elevation))},
              {"names", names_json(building_names(run.problem))},
              {"buildings", buildings}};
  all["scene"]["key"] = key_of(run, say);
  all.update(played_json(sampling, course.time, keys, run.response.impacts, listed, units.force, say));
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace bentur::html
