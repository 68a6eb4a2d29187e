#include "bentur/report/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "bentur/model/gap/gap_outcome.h"
#include "bentur/report/scene/internal/hinges.h"
#include "bentur/report/scene/internal/symbols.h"
#include "bentur/report/scene/tones.h"

namespace bentur {
namespace {

using Eigen::Index;

constexpr double pit = 0.07;        // depth of what stands below a base, of the height of all
constexpr double footing = 0.02;    // its thickness
constexpr double widest_gap = 1e3;  // that a picture holds: beyond it there is no number for it in SVG sooner or later

double base_level(const Building& building) {
  return building.model.elevations.front() - building.model.storey_heights.front();
}

/// Puts a scene together from the sizes of things.
class SceneBuilder {
 public:
  SceneBuilder(const Problem& problem, const Response& response)
      : problem_(problem), response_(response), buildings_(problem.buildings), tones_(tones_of(problem, response)) {
    measure(response);
  }

  Scene build() {
    add_ground();
    for (Index b = 0; b < std::ssize(buildings_); ++b) add_support(b);
    add_links();
    for (Index b = 0; b < std::ssize(buildings_); ++b) add_building(b);
    for (const ContactPoint& point : problem_.points) {
      scene_.contacts.push_back(at(point.left, point.left_floor, scene_.breadths[point.left], point.elevation));
    }
    scene_.bounds = scene::hinge_bounds(problem_, response_);
    for (Index b = 0; b < std::ssize(buildings_); ++b) {
      add_hinges(b);
      add_breaks(b);
    }
    return std::move(scene_);
  }

 private:
  void measure(const Response& response) {
    double foot = std::numeric_limits<double>::infinity();
    scene_.top = -foot;
    scene_.storey = foot;
    for (const Building& building : buildings_) {
      foot = std::min(foot, base_level(building));
      scene_.top = std::max(scene_.top, building.model.elevations.back());
      for (const double storey : building.model.storey_heights) {
        if (!building.is_rigid() && storey > 0) scene_.storey = std::min(scene_.storey, storey);  // a slab has none
      }
    }
    height_ = scene_.top > foot ? scene_.top - foot : 1;
    if (!std::isfinite(scene_.storey)) scene_.storey = height_;
    for (std::size_t b = 0; b < buildings_.size(); ++b) {
      bays_.push_back(bays_of(b));
      scene_.breadths.push_back(std::accumulate(bays_.back().begin(), bays_.back().end(), 0.0));
    }
    scene_.bottom = foot;
    for (Index b = 0; b < std::ssize(buildings_); ++b) {
      ground_.push_back(base_level(buildings_[b]) - (has_pit(b) ? pit * height_ : 0));
      scene_.bottom = std::min(scene_.bottom, ground_.back());
    }
    if (!(scene_.top > scene_.bottom)) scene_.bottom = scene_.top - height_;
    for (Index b = 0; b < std::ssize(buildings_); ++b) {
      if (buildings_[b].is_rigid()) ground_[b] = scene_.bottom;
    }
    measure_gaps();
    measure_motion(response);
  }

  void measure_gaps() {
    scene_.gaps.assign(buildings_.size() - 1, widest_gap * height_);
    const auto narrow = [&](const auto& one) { scene_.gaps[one.left] = std::min(scene_.gaps[one.left], one.width); };
    std::for_each(problem_.points.begin(), problem_.points.end(), narrow);
    std::for_each(problem_.watched.begin(), problem_.watched.end(), narrow);
  }

  void measure_motion(const Response& response) {
    for (const Histories* histories : {&response.histories, &response.course}) {
      for (const auto* list : {&histories->displacement, &histories->node_displacement}) {
        for (const Eigen::MatrixXd& one : *list) {
          if (one.size() > 0) scene_.largest = std::max(scene_.largest, one.cwiseAbs().maxCoeff());
        }
      }
    }
    constexpr double sway = 0.09, spread = 0.5;  // of the height, and of the breadth of all
    const auto sum = [](const std::vector<double>& list) { return std::accumulate(list.begin(), list.end(), 0.0); };
    double fits = 1e9;
    if (scene_.largest > 0) fits = sway * (scene_.top - scene_.bottom) / scene_.largest;
    if (const double gaps = sum(scene_.gaps); gaps > 0) fits = std::min(fits, spread * sum(scene_.breadths) / gaps);
    scene_.magnification = round_125(std::max(fits, 1e-6));
  }

  /// Bays a building is drawn with: where its width is not known one of a third of its height, of a wall one of a
  /// twentieth of all.
  [[nodiscard]] std::vector<double> bays_of(std::size_t b) const {
    if (buildings_[b].is_rigid()) return {height_ / 20};
    if (!buildings_[b].bays.empty()) return buildings_[b].bays;
    const std::vector<double>& storeys = buildings_[b].model.storey_heights;
    return {std::accumulate(storeys.begin(), storeys.end(), 0.0) / 3};
  }

  [[nodiscard]] bool has_pit(Index b) const {
    const StructuralModel& model = buildings_[b].model;
    return model.slab || model.foundation;
  }

  [[nodiscard]] static ScenePoint at(Index b, std::optional<Index> row, double offset, double height,
                                     double apart = 0) {
    return {height, {{.building = b, .row = row, .offset = offset, .apart = apart}}};
  }

  /// What the left face of a floor or node stands back by: the difference of its gap to the narrowest one of its joint.
  [[nodiscard]] double stands_back(Index b, Index row) const {
    const auto faces = [&](const ContactPoint& point) { return point.left == b - 1 && point.right_floor == row; };
    const auto point = std::find_if(problem_.points.begin(), problem_.points.end(), faces);
    return point == problem_.points.end() ? 0 : std::min(point->width, widest_gap * height_) - scene_.gaps[b - 1];
  }

  /// Level of the ground beside the row: the edge of a moat is as high as its wall.
  [[nodiscard]] double outside(Index b, Index neighbour) const {
    const double top = buildings_[b].model.elevations.back();
    const bool is_edge = buildings_[b].is_rigid() && top <= base_level(buildings_[neighbour]) + 1e-9 * height_;
    return is_edge ? top : ground_[b];
  }

  void add_ground() {
    const Index last = std::ssize(buildings_) - 1;
    const auto breadth = std::accumulate(scene_.breadths.begin(), scene_.breadths.end(), 0.0);
    const double margin = std::max((scene_.top - scene_.bottom) / 11, breadth / 21);
    std::vector<ScenePoint> line;
    line.push_back(at(0, {}, -margin, outside(0, 1), -scene_.largest));
    line.push_back(at(0, {}, 0, outside(0, 1)));
    line.push_back(at(0, {}, 0, ground_[0]));
    for (Index b = 0; b < last; ++b) {
      const double middle = scene_.gaps[b] / 2;
      line.push_back(at(b, {}, scene_.breadths[b], ground_[b], middle));
      line.push_back(at(b, {}, scene_.breadths[b], ground_[b + 1], middle));
    }
    const double end = scene_.breadths[last];
    line.push_back(at(last, {}, end, ground_[last]));
    line.push_back(at(last, {}, end, outside(last, last - 1)));
    line.push_back(at(last, {}, end + margin, outside(last, last - 1), scene_.largest));
    scene_.shapes.push_back({.role = SceneRole::ground, .lines = {line}});
  }

  void add_support(Index b) {
    if (buildings_[b].model.slab) add_bearings(b);
    if (buildings_[b].model.foundation) add_soil(b);
  }

  /// Below each column a block of layers, which leans with the slab.
  void add_bearings(Index b) {
    SceneShape shape{.role = SceneRole::bearing, .item = b};
    const double slab = buildings_[b].model.elevations.front();
    const double narrowest = *std::min_element(bays_[b].begin(), bays_[b].end());
    const double half = std::min(0.02 * height_, 0.2 * narrowest);
    double offset = 0;
    for (std::size_t bay = 0; bay <= bays_[b].size(); ++bay) {
      const auto corner = [&](double side, double share) {
        return scene::between(at(b, {}, offset + side, ground_[b]), at(b, 0, offset + side, slab), share);
      };
      shape.lines.push_back({corner(-half, 0), corner(-half, 1), corner(half, 1), corner(half, 0), corner(-half, 0)});
      for (const double share : {1.0 / 3, 2.0 / 3}) shape.lines.push_back({corner(-half, share), corner(half, share)});
      if (bay < bays_[b].size()) offset += bays_[b][bay];
    }
    scene_.shapes.push_back(std::move(shape));
  }

  /// The row of a building's foundation; nothing where it has none.
  [[nodiscard]] std::optional<Index> foundation_row(Index b) const {
    const Histories& histories = response_.histories;
    if (histories.foundation.at(b).rows() == 0) return {};
    return histories.displacement.at(b).rows() + histories.node_displacement.at(b).rows();
  }

  /// A footing on upright springs, which let it rock, and one that lets it sway. It is drawn swaying; its rocking shows
  /// in the floors alone.
  void add_soil(Index b) {
    const double breadth = scene_.breadths[b], base = base_level(buildings_[b]);
    const double top = base - footing * height_, middle = (top + ground_[b]) / 2;
    const double size = 0.15 * (top - ground_[b]);
    const auto still = [&](double share, double height) { return at(b, {}, share * breadth, height); };
    const auto moved = [&](double share, double height) { return at(b, foundation_row(b), share * breadth, height); };
    SceneShape shape{.role = SceneRole::soil, .item = b};
    shape.lines = {{moved(0, base), moved(1, base), moved(1, top), moved(0, top), moved(0, base)},
                   {moved(0.35, top), moved(0.35, middle)},
                   {still(0.65, middle), still(0.65, ground_[b])}};
    for (const double share : {0.12, 0.88}) {
      shape.lines.push_back(scene::upright_spring(moved(share, top), still(share, ground_[b]), size));
    }
    for (auto& line : scene::spring(moved(0.35, middle), still(0.65, middle), size)) {
      shape.lines.push_back(std::move(line));
    }
    scene_.shapes.push_back(std::move(shape));
  }

  void add_links() {
    for (Index number = 0; number < std::ssize(problem_.links); ++number) {
      const std::string& kind = problem_.links[number].kind;
      if (kind.starts_with("spring")) hang(number, SceneRole::spring, scene::spring);
      if (kind.ends_with("dashpot")) hang(number, SceneRole::damper, scene::damper);
      if (kind.starts_with("spring") || kind.ends_with("dashpot")) continue;
      if (kind == "yielding") {
        hang(number, SceneRole::yielding, scene::plates);
      } else if (kind == "cable") {
        hang(number, SceneRole::cable, scene::cable);
      } else {
        hang(number, SceneRole::link, scene::bar);
      }
    }
  }

  /// A symbol below the two floors that a link joins, and below those that hang there already, so that the places where
  /// floors meet stay in sight.
  void hang(Index number, SceneRole role, scene::Symbol* symbol) {
    const Link& link = problem_.links[number];
    const auto same = [&](const SceneShape& one) {
      if (one.role < SceneRole::spring || one.role > SceneRole::link) return false;
      const Link& other = problem_.links[one.item];
      return other.left == link.left && other.right == link.right && other.left_floor == link.left_floor;
    };
    const auto before = std::count_if(scene_.shapes.begin(), scene_.shapes.end(), same);
    const double room = std::min(scene_.storey, 0.12 * height_);
    const double drop = (0.24 + 0.3 * static_cast<double>(before)) * room;
    const auto reach = [&](Index b) { return std::min(0.09 * height_, 0.3 * scene_.breadths[b]); };
    const ScenePoint left = at(link.left, link.left_floor, scene_.breadths[link.left] - reach(link.left),
                               buildings_[link.left].model.elevations[link.left_floor]);
    const ScenePoint right =
        at(link.right, link.right_floor, reach(link.right), buildings_[link.right].model.elevations[link.right_floor]);
    ScenePoint from = left, to = right;
    from.height -= drop;
    to.height -= drop;
    SceneShape shape{.role = role, .item = number, .lines = {{left, from}, {right, to}}};
    for (auto& line : symbol(from, to, 0.12 * room)) shape.lines.push_back(std::move(line));
    scene_.shapes.push_back(std::move(shape));
  }

  void add_building(Index b) {
    const Building& building = buildings_[b];
    const double breadth = scene_.breadths[b];
    if (building.is_rigid()) {  // from the ground up
      const double top = building.model.elevations.back();
      scene_.shapes.push_back({.role = SceneRole::wall,
                               .item = b,
                               .tone = tones_[b],
                               .lines = {{at(b, {}, 0, ground_[b]), at(b, {}, 0, top), at(b, {}, breadth, top),
                                          at(b, {}, breadth, ground_[b]), at(b, {}, 0, ground_[b])}}});
      return;
    }
    add_columns(b);
    SceneShape slabs{.role = SceneRole::slab, .item = b, .tone = tones_[b]};
    for (Index floor = 0; floor < building.model.floors(); ++floor) slabs.lines.push_back(slab_line(b, floor));
    scene_.shapes.push_back(std::move(slabs));
  }

  /// Of a column line from the left face.
  [[nodiscard]] double offset_of(Index b, std::size_t line) const {
    return std::accumulate(bays_[b].begin(), bays_[b].begin() + static_cast<std::ptrdiff_t>(line), 0.0);
  }

  /// They bend where they are struck between floors: those in the outer line that faces the gap.
  [[nodiscard]] scene::SceneLine column_line(Index b, std::size_t line) const {
    const StructuralModel& model = buildings_[b].model;
    const double offset = offset_of(b, line);
    scene::SceneLine points;
    if (!model.slab) points.push_back(at(b, foundation_row(b), offset, base_level(buildings_[b])));
    for (Index floor = 0; floor < model.floors(); ++floor) {
      points.push_back(at(b, floor, offset, model.elevations[floor]));
    }
    for (const ContactPoint& point : problem_.points) {
      const std::optional<StruckColumn> struck = struck_column(problem_, point);
      const std::size_t facing = point.left == b ? bays_[b].size() : 0;
      if (!struck || struck->building != b || line != facing) continue;
      const Index row = model.floors() + struck->node;
      points.push_back(at(b, row, offset, model.node_elevations[struck->node], line == 0 ? stands_back(b, row) : 0));
    }
    std::stable_sort(points.begin(), points.end(),
                     [](const ScenePoint& low, const ScenePoint& high) { return low.height < high.height; });
    return points;
  }

  void add_columns(Index b) {
    SceneShape columns{.role = SceneRole::column, .item = b, .tone = tones_[b]};
    for (std::size_t line = 0; line <= bays_[b].size(); ++line) columns.lines.push_back(column_line(b, line));
    scene_.shapes.push_back(std::move(columns));
  }

  [[nodiscard]] scene::SceneLine slab_line(Index b, Index floor) const {
    const double height = buildings_[b].model.elevations[floor];
    return {at(b, floor, 0, height, stands_back(b, floor)), at(b, floor, scene_.breadths[b], height)};
  }

  /// Of a storey as people count; of a beam's level the floor itself.
  [[nodiscard]] Index floor_above(Index b, Index storey) const {
    const StructuralModel& model = buildings_[b].model;
    return std::clamp<Index>(storey - 1 + model.first_storey(), 0, model.floors() - 1);
  }

  /// A column line from 1, and the levels below and above a storey.
  struct StoreyColumn {
    scene::SceneLine line;
    double below, above;
  };
  [[nodiscard]] StoreyColumn storey_column(Index b, Index storey, Index line) const {
    const StructuralModel& model = buildings_[b].model;
    const Index floor = floor_above(b, storey);
    const auto number = static_cast<std::size_t>(std::clamp<Index>(line - 1, 0, std::ssize(bays_[b])));
    const double above = model.elevations[floor];
    return {column_line(b, number), above - model.storey_heights[floor], above};
  }

  void add_hinges(Index b) {
    const StructuralModel& model = buildings_[b].model;
    for (SceneHinge& hinge : scene::hinges_of(problem_, response_, b, scene_.bounds)) {
      const HingePlace& place = model.hinges.places[hinge.hinge];
      if (place.of_beam) {
        const Index floor = floor_above(b, place.level);
        const auto bay = static_cast<std::size_t>(std::clamp<Index>(place.number - 1, 0, std::ssize(bays_[b]) - 1));
        const scene::SceneLine slab = slab_line(b, floor);
        hinge.at =
            scene::on_beam(slab, place.end, offset_of(b, bay) / scene_.breadths[b],
                           offset_of(b, bay + 1) / scene_.breadths[b], scene_.breadths[b], model.storey_heights[floor]);
      } else {
        const StoreyColumn column = storey_column(b, place.level, place.number);
        hinge.at = scene::on_column(column.line, place.end, column.below, column.above,
                                    scene::nodes_before(model.hinges.places, hinge.hinge));
      }
      scene_.hinges.push_back(std::move(hinge));
    }
  }

  void add_breaks(Index b) {
    for (SceneBreak& one : scene::breaks_of(problem_, response_, b)) {
      const BreakingColumn& broken = buildings_[b].model.hinges.columns[one.column];
      const StoreyColumn column = storey_column(b, broken.storey, broken.line);
      one.at = scene::amid_column(column.line, broken.piece, column.below, column.above);
      scene_.breaks.push_back(std::move(one));
    }
  }

  const Problem& problem_;
  const Response& response_;
  const std::vector<Building>& buildings_;
  const std::vector<Tone> tones_;
  double height_ = 1;                      // above the lowest base
  std::vector<std::vector<double>> bays_;  // per building
  std::vector<double> ground_;             // level below each building
  Scene scene_;
};

/// The column of a time that is nearest to it.
Index nearest_column(const std::vector<double>& time, double at) {
  const auto next = std::lower_bound(time.begin(), time.end(), at);
  if (next == time.begin()) return 0;
  const auto before = std::prev(next);
  return (next == time.end() || at - *before < *next - at ? before : next) - time.begin();
}

}  // namespace

double round_125(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double digit = value / power;
  return power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
}

double at_most_125(double value) {
  constexpr double round_off = 1 + 1e-9;
  const double power = std::pow(10.0, std::floor(std::log10(value * round_off)));
  const double digit = value * round_off / power;
  return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

const char* role_name(SceneRole role) {
  constexpr const char* names[] = {"ground", "soil", "bearing", "spring", "damper", "yielding",
                                   "cable",  "link", "wall",    "column", "slab"};
  return names[static_cast<std::size_t>(role)];
}

Scene scene_of(const Problem& problem, const Response& response) { return SceneBuilder(problem, response).build(); }

Eigen::MatrixXd scene_rows(const Histories& histories, std::size_t building) {
  const Eigen::MatrixXd& floors = histories.displacement.at(building);
  const Eigen::MatrixXd& nodes = histories.node_displacement.at(building);
  const Eigen::MatrixXd& foundation = histories.foundation.at(building);
  const Index sway = std::min<Index>(foundation.rows(), 1);
  Eigen::MatrixXd all(floors.rows() + nodes.rows() + sway, floors.cols());
  all << floors, nodes, foundation.topRows(sway);
  return all;
}

SceneMotion motion_at(const Histories& histories, Index column) {
  SceneMotion motion;
  for (std::size_t b = 0; b < histories.displacement.size(); ++b) {
    motion.emplace_back(scene_rows(histories, b).col(column));
  }
  return motion;
}

SceneMotion at_rest(const Histories& histories) {
  SceneMotion motion = motion_at(histories, 0);
  for (Eigen::VectorXd& one : motion) one.setZero();
  return motion;
}

ScenePlaces::ScenePlaces(const Scene& scene, double magnification, const SceneMotion& motion)
    : faces_{0}, magnification_(magnification), motion_(&motion) {
  for (std::size_t gap = 0; gap < scene.gaps.size(); ++gap) {
    faces_.push_back(faces_.back() + scene.breadths[gap] + magnification * scene.gaps[gap]);
  }
}

std::array<double, 2> ScenePlaces::operator()(const ScenePoint& point) const {
  double x = 0;
  for (const SceneMover& mover : point.movers) {
    const double moved = mover.row ? (*motion_)[mover.building](*mover.row) : 0;
    x += mover.weight * (faces_[mover.building] + mover.offset + magnification_ * (mover.apart + moved));
  }
  return {x, point.height};
}

SceneInstant telling_instant(const Response& response, std::optional<Index> point, const NearestFloor* nearest) {
  SceneInstant instant;
  for (Index k = 0; k < std::ssize(response.impacts); ++k) {
    const Impact& impact = response.impacts[k];
    if (point && impact.point != *point) continue;
    if (!instant.impact || is_harder(impact, response.impacts[*instant.impact])) instant.impact = k;
  }
  const Histories& course = response.course.time.empty() ? response.histories : response.course;
  if (instant.impact) {
    const Impact& impact = response.impacts[*instant.impact];
    instant.point = impact.point;
    instant.time = impact.peak_force > 0 ? impact.peak_force_time : impact.start;
  } else {
    double least = std::numeric_limits<double>::infinity();
    for (Index i = 0; i < course.opening.rows(); ++i) {
      if (point && i != *point) continue;
      Index closest = 0;
      const double opening = course.opening.row(i).minCoeff(&closest);
      if (!(opening < least)) continue;
      least = opening;
      instant.point = i;
      instant.time = course.time[closest];
    }
    if (nearest != nullptr && nearest->least_opening < least) {
      instant.point.reset();
      instant.time = nearest->least_time;
      instant.nearest = nearest;
    }
  }
  instant.histories = &course;
  instant.column = nearest_column(course.time, instant.time);
  return instant;
}

}  // namespace bentur
