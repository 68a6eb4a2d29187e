#include "bentur/model/gap/gap_outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/model/case.h"

namespace bentur {
namespace {

constexpr double near_part = 0.25;  // of the smallest storey at two floors: further apart they do not meet as floors

/// The neighbour that a watched floor faces.
const Building& faced_building(const Problem& problem, const WatchedFloor& floor) {
  return problem.buildings[floor.faced()];
}

/// A tolerance of two digits that lets floors so far apart meet [length].
double rounded_up(double apart) {
  const double unit = std::pow(10.0, std::floor(std::log10(apart)) - 1);
  return std::ceil(apart / unit * (1 + 1e-9)) * unit;
}

}  // namespace

bool GoverningLevel::is_short() const { return is_below_target(width, gap_needed, scale); }

double displacement_scale(const Problem& problem, const Response& response, Eigen::Index gap) {
  double scale = 0;
  for (const Eigen::Index b : buildings_of(problem, gap)) {
    const Eigen::VectorXd& free = response.buildings.at(static_cast<std::size_t>(b)).displacement_no_contact;
    if (free.size() > 0) scale += free.maxCoeff();
  }
  return scale;
}

std::optional<GoverningLevel> governing_level(const std::vector<LevelSeparation>& levels, double scale) {
  std::optional<GoverningLevel> worst;
  for (const bool points : {true, false}) {
    for (auto one = levels.rbegin(); one != levels.rend(); ++one) {
      const FacingLevel& level = one->level;
      if (level.is_point != points) continue;
      if (worst && one->gap_needed - level.width <= worst->gap_needed - worst->width) continue;
      worst = {points ? std::nullopt : std::optional(level.index),
               points ? level.index : 0,
               level.elevation,
               level.of_gap(level.width),
               level.of_gap(one->gap_needed),
               {},
               scale};
      worst->width_here = level.beside ? level.width : worst->width;
      worst->needed_here = level.beside ? one->gap_needed : worst->gap_needed;
      if (one->gap_needed_reversed) worst->gap_needed_reversed = level.of_gap(*one->gap_needed_reversed);
    }
  }
  const auto without_little = [&](double& needed) {
    if (!is_below_target(0, needed, scale)) needed = 0;  // round-off
  };
  if (worst) {
    without_little(worst->gap_needed);
    without_little(worst->needed_here);
  }
  return worst;
}

namespace {

/// What is needed at each level of a gap, without the rules.
std::vector<LevelSeparation> needs_of(const Problem& problem, const Response& response, Eigen::Index gap) {
  std::vector<LevelSeparation> needs;
  for (const FacingLevel& level : facing_levels(problem, gap)) {
    const auto take = [&](const auto& summary) {
      needs.push_back({level, summary.gap_needed, summary.gap_needed_reversed});
    };
    if (level.is_point) {
      take(response.points.at(level.index));
    } else {
      take(response.watched.at(level.index));
    }
  }
  return needs;
}

}  // namespace

GoverningLevel governing_level(const Problem& problem, const Response& response, Eigen::Index number) {
  const double scale = displacement_scale(problem, response, number);
  return governing_level(needs_of(problem, response, number), scale).value_or(GoverningLevel{});
}

namespace {

/// @param drifts largest one of each building, without contact
bool drifts_beyond(const Problem& problem, const std::vector<LargestDrift>& drifts) {
  for (std::size_t b = 0; b < std::min(problem.buildings.size(), drifts.size()); ++b) {
    if (drifts_beyond_collapse(drifts[b].ratio, problem.buildings[b].has_gravity_loads, problem.collapse_drift))
      return true;
  }
  return false;
}

}  // namespace

bool falls_without_contact(const Problem& problem, const Response& response) {
  return response.collapse_no_contact || drifts_beyond(problem, drifts_no_contact(response));
}

bool falls_without_contact_reversed(const Problem& problem, const Response& response) {
  const std::optional<ReversedRun>& other = response.reversed;
  return other && (other->collapse_no_contact || drifts_beyond(problem, other->drifts));
}

double gap_needed(const Problem& problem, const Response& response, Eigen::Index number) {
  if (response.collapse_no_contact) return not_known;
  return largest_of(needs_of(problem, response, number)).gap_needed;
}

std::optional<double> gap_needed_reversed(const Problem& problem, const Response& response, Eigen::Index number) {
  if (response.reversed && response.reversed->collapse_no_contact) return std::nullopt;
  return largest_of(needs_of(problem, response, number)).gap_needed_reversed;
}

std::vector<Eigen::Index> unmodelled_contacts(const Problem& problem, const std::vector<WatchedSummary>& watched,
                                              Eigen::Index gap) {
  std::vector<Eigen::Index> floors = gap_at(problem, gap).watched;
  std::erase_if(floors, [&](Eigen::Index i) { return !watched.at(i).closes; });
  std::stable_sort(floors.begin(), floors.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return watched[a].least_opening < watched[b].least_opening; });
  return floors;
}

bool is_harder(const Impact& a, const Impact& b) {
  return a.peak_force != b.peak_force ? a.peak_force > b.peak_force : a.closing_speed > b.closing_speed;
}

const Impact* hardest_impact(const std::vector<Impact>& impacts, std::optional<Eigen::Index> point) {
  const Impact* hardest = nullptr;
  for (const Impact& impact : impacts) {
    if (impact.point == point.value_or(impact.point) && (hardest == nullptr || is_harder(impact, *hardest)))
      hardest = &impact;
  }
  return hardest;
}

Hit hit_of(const std::vector<PointSummary>& points, const std::vector<Impact>& impacts,
           const std::vector<Eigen::Index>& of_gap) {
  Hit hit{.point = of_gap.front()};
  long settling = 0;
  const auto hardness = [&](Eigen::Index i) { return std::pair(points[i].peak_force, points[i].peak_closing_speed); };
  for (const Eigen::Index i : of_gap) {
    hit.impacts += points[i].impacts;
    settling += points[i].settling;
    hit.touched += points[i].impacts + points[i].settling > 0 ? 1 : 0;
    if (hardness(i) > hardness(hit.point)) hit.point = i;
  }
  if (hit.impacts == 0) hit.impacts = settling;
  hit.hardest = hardest_impact(impacts, hit.point);
  return hit;
}

GapOutcome gap_outcome(const Problem& problem, const Response& response, Eigen::Index gap) {
  GapOutcome outcome{.gap = gap_at(problem, gap),
                     .governing = governing_level(problem, response, gap),
                     .unmodelled = unmodelled_contacts(problem, response.watched, gap)};
  if (outcome.gap.points.empty()) return outcome;
  const Hit hit = hit_of(response.points, response.impacts, {outcome.gap.points.rbegin(), outcome.gap.points.rend()});
  outcome.impacts = static_cast<int>(hit.impacts);
  outcome.touched = static_cast<int>(hit.touched);
  outcome.hardest = hit.point;
  return outcome;
}

bool faces_base(const Problem& problem, const WatchedFloor& floor) {
  constexpr double round_off = 1e-9;
  const FloorLevels other = levels_of(faced_building(problem, floor).model);
  return !floor.facing_floor && std::abs(floor.elevation - other.base) <= round_off * (1 + std::abs(other.base));
}

Remedy remedy_for(const Problem& problem, const WatchedFloor& floor, bool in_plan) {
  if (floor.facing_floor) return {Remedy::Kind::name_elevation, floor.elevation, 0};
  const bool of_left = floor.floor_of == floor.left;
  const FloorLevels own = levels_of(problem.buildings[static_cast<Eigen::Index>(floor.floor_of)].model);
  const FloorLevels other = levels_of(faced_building(problem, floor).model);
  double tolerance = 0;
  for (int i = 0; i < static_cast<int>(other.elevations.size()); ++i) {
    const double storey =
        std::min(smallest_storey_at(own, static_cast<int>(floor.floor)), smallest_storey_at(other, i));
    const double apart = std::abs(other.elevations[static_cast<Eigen::Index>(i)] - floor.elevation);
    if (apart > near_part * storey) continue;
    tolerance = rounded_up(apart);
    for (const LevelPair& pair : of_left ? level_floors(own, other, tolerance) : level_floors(other, own, tolerance)) {
      if ((of_left ? pair.left_floor : pair.right_floor) == floor.floor) {
        return {Remedy::Kind::raise_tolerance, other.elevations[static_cast<Eigen::Index>(i)], tolerance};
      }
    }
  }
  if (faces_base(problem, floor)) return {Remedy::Kind::give_wall, floor.elevation, 0};
  if (in_plan) return {Remedy::Kind::give_floor, floor.elevation, 0};
  const bool is_frame = faced_building(problem, floor).model.left_joints.size() > 0;
  return {is_frame ? Remedy::Kind::strike_column : Remedy::Kind::give_columns, floor.elevation, 0};
}

std::string remedy_text(const Problem& problem, const WatchedFloor& floor, const std::string& length, bool in_plan) {
  const Remedy remedy = remedy_for(problem, floor, in_plan);
  const std::string& other = faced_building(problem, floor).name;
  switch (remedy.kind) {
    case Remedy::Kind::name_elevation:
      return fmt::format("name {} in gap.elevations, or leave elevations out", written(remedy.level));
    case Remedy::Kind::raise_tolerance:
      return fmt::format("gap.level_tolerance = {} lets it meet the floor of {} at level {} {}",
                         written(remedy.tolerance), other, written(remedy.level), length);
    case Remedy::Kind::strike_column:
      return fmt::format(
          "gap.strikes_columns = true with {} among gap.elevations lets it strike the column of {} there",
          written(remedy.level), other);
    case Remedy::Kind::give_floor:
      return fmt::format(
          "gap.strikes_columns = true with {0} among gap.elevations lets it strike columns of {1} there, where its "
          "frames run across the joint; else a rough model gives it a floor at level {0} {2}",
          written(remedy.level), other, length);
    case Remedy::Kind::give_wall:
      return fmt::format("a base cannot be struck: a case with a wall (rigid = true) in place of {} shows what it does",
                         other);
    case Remedy::Kind::give_columns:
      break;
  }
  return fmt::format(
      "give {} as building.frame, whose column it can strike with gap.strikes_columns = true and {} among "
      "gap.elevations, or as building.matrices with a floor at level {} {}",
      other, written(remedy.level), written(remedy.level), length);
}

std::string floor_text(const Problem& problem, const WatchedFloor& floor) {
  return "the floor of " + problem.buildings[static_cast<Eigen::Index>(floor.floor_of)].name;
}

std::string faced_text(const Problem& problem, const WatchedFloor& floor) {
  const char* const part = floor.facing_floor ? "floor" : faces_base(problem, floor) ? "base" : "column";
  return fmt::format("the {} of {}", part, faced_building(problem, floor).name);
}

}  // namespace bentur
