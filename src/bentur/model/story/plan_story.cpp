#include "bentur/model/story/plan_story.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/plan/plan_frames.h"
#include "bentur/model/plan/plan_pair.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/plan/plan_screening.h"
#include "bentur/model/story/internal/small_movements.h"
#include "bentur/model/story/internal/story_parts.h"

namespace bentur {
namespace {

using Eigen::Index;
using story::count_of;
using story::percent;
using story::text_of;
using story::value_in;
using story::word_of;

/// The word for the corner of a footprint that a place is at; nullptr where it is none.
const char* corner_word(const Footprint& footprint, const PlanPoint& at) {
  const auto side = [&](int i) {
    return at[i] == footprint.corner[i] ? 0 : at[i] == footprint.far_corner()[i] ? 1 : -1;
  };
  if (!footprint.polygon.empty()) return nullptr;
  constexpr const char* words[2][2] = {{"story.corner.lower_left", "story.corner.upper_left"},
                                       {"story.corner.lower_right", "story.corner.upper_right"}};
  return side(0) < 0 || side(1) < 0 ? nullptr : words[side(0)][side(1)];
}

/// The hardest impact of a contact; nullptr where it has none.
const Impact* hardest_of(const PlanRun& run, Index contact) {
  const Impact* hardest = nullptr;
  for (const Impact& one : run.response.impacts) {
    if (one.point == contact && (hardest == nullptr || is_harder(one, *hardest))) hardest = &one;
  }
  return hardest;
}

/// Completes what is said of buildings that collide.
void tell_hit(const PlanRun& run, std::size_t g, Statement statement, std::vector<Statement>& statements) {
  const Index first = first_contact(run.problem, g), count = std::ssize(run.problem.gaps[g].contacts);
  long impacts = 0, touched = 0;
  Index hit = first;
  const Impact* hardest = nullptr;
  for (Index i = first; i < first + count; ++i) {
    const PointSummary& point = run.response.points[i];
    impacts += point.impacts + point.settling;
    touched += point.impacts + point.settling > 0 ? 1 : 0;
    const Impact* const one = hardest_of(run, i);
    if (one == nullptr || (hardest != nullptr && !is_harder(*one, *hardest))) continue;
    hardest = one;
    hit = i;
  }
  statement.severity = Severity::warning;
  statement.level = contact_at(run.problem, hit).contact->elevation;
  statement.values.push_back(count_of("times", impacts));
  statement.values.push_back(count_of("touched", touched));
  statement.values.push_back(count_of("n", count));
  statement.values.push_back(word_of("points", "story.count.contact_points.many"));
  story::add_place(run.problem, run.problem.gaps[g], true, hit - first, run.c.units.length, statement.values);
  story::tell_blow(run.response.points[hit], hardest, shown_units(run), statement);
  statements.push_back(std::move(statement));
}

void tell_block(const PlanRun& run, const std::vector<JudgedGap>& judged, Story& told) {
  std::vector<story::GapLine> lines;
  for (std::size_t g = 0; g < judged.size(); ++g) {
    story::GapLine line{.name = gap_name(run.problem, run.problem.gaps[g]),
                        .facts = &judged[g].facts,
                        .judged = judged[g].judgement.value};
    for (const LevelFacts& level : judged[g].facts.levels) {
      line.impacts += level.given.impacts;
      line.peak_force = std::max(line.peak_force, level.given.peak_force);
    }
    lines.push_back(std::move(line));
  }
  story::tell_gaps(lines, shown_units(run), run.c.units.length, told);
}

/// What is told of the gaps of rows too, as of a gap in plan.
class PairStory {
 public:
  PairStory(const PlanRun& run, std::size_t g, JudgedGap judged)
      : run_(run), g_(g), pair_(pair_of(run, g)), view_(story::judged_view_of(run, g, pair_, std::move(judged))) {}

  /// Contact, the need, the rules.
  void tell(std::vector<Statement>& to) const {
    const auto hit = [&](Statement one) { tell_hit(run_, g_, std::move(one), to); };
    const std::size_t before = to.size();
    story::tell_unmodelled(view_, 0, to);
    story::tell_judgement(view_, 0, hit, to);
    story::tell_need(view_, 0, to);
    story::tell_rules(view_, 0, to);
    const auto [first, second] = std::minmax(run_.problem.gaps[g_].left, run_.problem.gaps[g_].right);
    for (std::size_t i = before; i < to.size(); ++i) {
      to[i].gap = static_cast<Index>(g_);
      to[i].buildings = {first, second};
      for (StoryValue& value : to[i].values) {
        if (value.name == "left") value.value = run_.problem.buildings[first].name;
        if (value.name == "right") value.value = run_.problem.buildings[second].name;
      }
    }
  }

  void put_tables(std::vector<StoryTable>& to) const {
    for (StoryTable& table : story::gap_tables(view_, 0)) {
      table.gap = static_cast<Index>(g_);
      to.push_back(std::move(table));
    }
  }

 private:
  const PlanRun& run_;
  std::size_t g_;
  RunResults pair_;
  story::GapView view_;
};

/// Whether two buildings could meet by how far both move: along every direction in which they are apart.
bool could_meet(const PlanRun& run, Index left, Index right, const Stretch& joint) {
  const auto reaches = [&](const PlanPoint& n, double width) {
    return story::reach_of(run.response.buildings[left], n) + story::reach_of(run.response.buildings[right], n) >=
           width;
  };
  if (!reaches(joint.n, joint.width)) return false;
  const std::vector<FamilyBeside> apart = families_beside(run.problem.buildings[left].model.footprint,
                                                          run.problem.buildings[right].model.footprint, joint, 0);
  return std::all_of(apart.begin(), apart.end(), [&](const FamilyBeside& one) {
    return reaches(one.places.front().normal, joint.width + one.places.front().beyond);
  });
}

/// Buildings that have no contact, and could meet by how far both move.
void tell_pairs_without_contact(const PlanRun& run, std::vector<Statement>& statements) {
  const std::vector<PlanBuilding>& buildings = run.problem.buildings;
  for (Index a = 0; a < std::ssize(buildings); ++a) {
    for (Index b = a + 1; b < std::ssize(buildings); ++b) {
      const auto stretch = joint_between(buildings[a].model.footprint, buildings[b].model.footprint);
      const bool is_modelled = std::any_of(run.problem.gaps.begin(), run.problem.gaps.end(), [&](const PlanGap& gap) {
        return std::min(gap.left, gap.right) == a && std::max(gap.left, gap.right) == b;
      });
      if (!stretch || is_modelled || (buildings[a].is_rigid() && buildings[b].is_rigid())) continue;
      const double reach = story::reach_of(run.response.buildings[a], stretch->n) +
                           story::reach_of(run.response.buildings[b], stretch->n);
      if (!(stretch->swapped ? could_meet(run, b, a, *stretch) : could_meet(run, a, b, *stretch))) continue;
      const std::string& length = run.c.units.length;
      statements.push_back({.kind = "pair_without_contact",
                            .severity = Severity::danger,
                            .buildings = {a, b},
                            .values = {text_of("left", buildings[a].name), text_of("right", buildings[b].name),
                                       value_in("width", stretch->width, length), value_in("reach", reach, length)}});
    }
  }
}

/// A quantity of floors where it is largest over all buildings; NaN where none has one.
struct Largest {
  double value = std::numeric_limits<double>::quiet_NaN();
  QuantityPlace at = {};
  const char* axis = "";
};
Largest largest(const PlanRun& run, std::initializer_list<std::pair<const char*, const char*>> keys) {
  Largest most;
  for (const auto& [key, axis] : keys) {
    const Quantity& quantity = quantity_named(key, Owner::floor, true);
    for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
      for (const QuantityPlace& at : floors_of(run.problem, b)) {
        const double value = value_of(quantity, run, at);
        if (std::isnan(value) || value <= most.value) continue;
        most = {value, at, axis};
      }
    }
  }
  return most;
}

/// {building} and {level}, with the axis where there is one.
Statement of_floor(const PlanRun& run, const Largest& found, std::string kind) {
  const PlanBuilding& building = run.problem.buildings[found.at.item];
  const double level = building.model.elevations[found.at.floor];
  Statement statement{.kind = std::move(kind),
                      .buildings = {found.at.item},
                      .level = level,
                      .values = {text_of("building", building.name)}};
  const bool has_axis = *found.axis != '\0';
  statement.values.push_back(value_in(has_axis ? "elevation" : "level", level, run.c.units.length));
  if (!has_axis) return statement;
  statement.values.push_back(text_of("axis", found.axis));
  statement.values.push_back(word_of("level", "story.level_along"));
  return statement;
}

/// The floor that contact turns the most of those that do not turn alone; false where there is none.
bool tell_turns_anew(const PlanRun& run, std::vector<Statement>& statements) {
  constexpr double round_off = 1e-9;
  Largest most;
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const PlanPeaks &with = run.response.buildings[b], &alone = run.response.buildings_no_contact[b];
    const double side = run.problem.buildings[b].model.footprint.size.maxCoeff();
    for (const QuantityPlace& at : floors_of(run.problem, b)) {
      const double moves = round_off * std::max(with.x(at.floor), with.y(at.floor));
      const double value = with.rotation(at.floor);
      if (side * alone.rotation(at.floor) > moves || !(side * value > moves) || value <= most.value) continue;
      most = {value, at, ""};
    }
  }
  if (std::isnan(most.value)) return false;
  statements.push_back(of_floor(run, most, "turned_by_contact"));
  statements.back().values.push_back(value_in("with", 1e3 * most.value, "mrad"));
  return true;
}

void tell_amplification(const PlanRun& run, std::vector<Statement>& statements) {
  if (run.response.impacts.empty()) return;
  const Largest moves = largest(run, {{"amplification_x", "x"}, {"amplification_y", "y"}});
  const Largest turns = largest(run, {{"amplification_rotation", ""}});
  const auto tell = [&](const Largest& found, const char* kind, Eigen::VectorXd PlanPeaks::*list, double factor,
                        const std::string& unit) {
    Statement statement = of_floor(run, found, kind);
    statement.values.push_back(value_in("factor", found.value));
    const auto value = [&](const std::vector<PlanPeaks>& of) {
      return factor * (of[found.at.item].*list)(found.at.floor);
    };
    statement.values.push_back(value_in("with", value(run.response.buildings), unit));
    statement.values.push_back(value_in("without", value(run.response.buildings_no_contact), unit));
    statements.push_back(std::move(statement));
  };
  constexpr double more = 1 + 1e-9;
  if (moves.value > more) {
    tell(moves, "amplified", *moves.axis == 'x' ? &PlanPeaks::x : &PlanPeaks::y, 1, run.c.units.length);
  }
  if (turns.value > more) tell(turns, "turned", &PlanPeaks::rotation, 1e3, "mrad");
  const bool starts = tell_turns_anew(run, statements);
  const bool any = moves.value > more || turns.value > more || starts;
  if (!any && !std::isnan(moves.value)) statements.push_back({.kind = "not_amplified"});
}

void tell_acceleration(const PlanRun& run, std::vector<Statement>& statements) {
  const Largest most = largest(run, {{"peak_acceleration_x", "x"}, {"peak_acceleration_y", "y"}});
  if (std::isnan(most.value)) return;
  Statement statement = of_floor(run, most, "acceleration");
  statement.values.push_back(value_in("acceleration", most.value, run.c.units.length + "/s²"));
  statement.values.push_back(value_in("in_g", most.value / run.c.units.gravity, "g"));
  statements.push_back(std::move(statement));
}

void tell_collapse(const PlanRun& run, std::vector<Statement>& statements) {
  story::tell_collapse(
      run.response.collapse, run.response.collapse_no_contact, run.problem.collapse_drift,
      [&](const Collapse& one) {
        const PlanBuilding& building = run.problem.buildings[one.building];
        return std::pair(building.name, building.model.storey_number(one.storey));
      },
      statements);
}

void tell_motion(const PlanRun& run, std::vector<Statement>& statements) {
  for (const std::size_t i : {0U, 1U}) {
    const double pga = applied_pga(run, i);
    if (!(pga > 0)) continue;
    Statement statement{
        .kind = run.c.angle == 0 ? "pga_along" : "pga_along_turned",
        .values = {text_of("axis", i == 0 ? "x" : "y"), value_in("angle", run.c.angle),
                   value_in("pga", pga, run.c.units.length + "/s²"), value_in("in_g", pga / run.c.units.gravity, "g")}};
    statements.push_back(std::move(statement));
  }
}

}  // namespace

std::optional<GoverningLevel> governing_level(const PlanRun& run, std::size_t gap) {
  const RunResults pair = pair_of(run, gap);
  if (pair.problem.points.empty() && pair.problem.watched.empty()) return std::nullopt;
  GoverningLevel level = governing_level(pair.problem, pair.response, 0);
  if (!run.c.analysis.both_ways) level.gap_needed_reversed.reset();
  return level;
}

std::vector<std::string> gap_names(const PlanProblem& problem) {
  std::vector<std::string> names;
  for (const PlanGap& gap : problem.gaps) names.push_back(gap_name(problem, gap));
  return names;
}

namespace story {

GapView judged_view_of(const PlanRun& run, std::size_t gap, const RunResults& pair, JudgedGap judged) {
  GapView view = view_of(pair);
  view.in_plan = &run.problem.gaps[gap];
  view.plan = &run.problem;
  view.screened = {plan_screening(run.c, run.problem, gap)};
  view.facts.push_back(std::move(judged.facts));
  view.judged.push_back(std::move(judged.judgement));
  return view;
}

void add_place(const PlanProblem& problem, const PlanGap& gap, bool is_point, Index index, const std::string& length,
               std::vector<StoryValue>& values) {
  const StretchCorner place = is_point ? gap.at(gap.contacts[index]) : gap.stretch.at(gap.watched[index].along);
  const double elevation = is_point ? gap.contacts[index].elevation : gap.watched[index].elevation;
  const char* corner = nullptr;
  for (const int side : {0, 1}) {
    const PlanBuilding& building = problem.buildings[side == 0 ? gap.left : gap.right];
    if (corner != nullptr) break;
    corner = corner_word(building.model.footprint, side == 0 ? place.left : place.right);
    if (corner == nullptr) continue;
    values.push_back(text_of("corner_of", building.name));
    values.push_back(word_of("corner", corner));
  }
  const PlanPoint at = 0.5 * (place.left + place.right);
  values.push_back(value_in("elevation", elevation, length));
  values.push_back(value_in("x", at.x(), length));
  values.push_back(value_in("y", at.y(), length));
  values.push_back(word_of("level", corner != nullptr ? "story.place_at_corner" : "story.place"));
}

Statement model_statement(const PlanRun& run) {
  bool yields = false;
  std::size_t counted = 0, loaded = 0,
              moved = 0;  // buildings that move, those with gravity loads, those on soil or bearings
  for (const PlanBuilding& building : run.problem.buildings) {
    counted += building.is_rigid() ? 0 : 1;
    loaded += building.has_gravity_loads() ? 1 : 0;
    moved += building.model.soil || building.model.slab ? 1 : 0;
  }
  const bool by_axes = std::any_of(run.problem.buildings.begin(), run.problem.buildings.end(), [](const auto& one) {
    const auto& bearings = one.model.bearings;
    return std::any_of(bearings.begin(), bearings.end(), [](const auto& bearing) { return bearing.elements() > 0; });
  });
  std::vector<std::vector<StoryValue>> left_out = gravity_left_out(loaded, counted);
  if (by_axes) left_out.push_back({word_of("what", "remarks.bearings_by_axes")});
  if (moved < counted) left_out.push_back({word_of("what", moved == 0 ? "remarks.no_soil" : "remarks.soil_of")});
  for (const PlanPeaks& peaks : run.response.buildings) {
    for (const PlanPeaks::Plane& plane : peaks.planes) yields = yields || plane.yielding.ductility.size() > 0;
  }
  yields = yields || !frames_that_yield(run.problem).empty();
  return {.kind = "model_plan",
          .severity = Severity::remark,
          .values = {word_of("planes", yields ? "remarks.planes_yield" : "remarks.planes_elastic")},
          .items = std::move(left_out)};
}

}  // namespace story

Story plan_story(const PlanRun& run) {
  Story told;
  tell_collapse(run, told.statements);
  story::tell_drifts(run, told.statements);
  std::vector<JudgedGap> judged = judged_gaps(run);
  tell_block(run, judged, told);
  for (std::size_t g = 0; g < judged.size(); ++g) PairStory(run, g, std::move(judged[g])).tell(told.statements);
  tell_pairs_without_contact(run, told.statements);
  story::tell_yielding(run, told);
  tell_amplification(run, told.statements);
  tell_acceleration(run, told.statements);
  story::tell_links(run.problem, run.response.links, shown_units(run), run.c.units.length, told.statements);
  tell_motion(run, told.statements);
  sort_by_severity(told.statements);
  story::tell_quotations(run.c.code, told.statements);
  put_remarks(run.remarks, told.statements);
  story::tell_rotations(run, told.statements);
  story::tell_ends_of_edges(run, told.statements);
  told.statements.push_back(story::model_statement(run));
  return told;
}

Story plan_gap_story(const PlanRun& run) {
  Story told;
  tell_collapse(run, told.statements);
  story::tell_drifts(run, told.statements);
  std::vector<JudgedGap> judged = judged_gaps(run);
  for (std::size_t g = 0; g < judged.size(); ++g) {
    const PairStory pair(run, g, std::move(judged[g]));
    pair.tell(told.statements);
    pair.put_tables(told.tables);
  }
  tell_pairs_without_contact(run, told.statements);
  tell_motion(run, told.statements);
  sort_by_severity(told.statements);
  story::tell_quotations(run.c.code, told.statements);
  put_remarks(run.remarks, told.statements);
  told.statements.push_back(story::model_statement(run));
  return told;
}

Story plan_height_rules_story(const PlanCase& c, const PlanProblem& problem) {
  Story all;
  for (std::size_t g = 0; g < problem.gaps.size(); ++g) {
    const RunResults pair = pair_of(c, problem, g);
    Story told;
    story::tell_heights(pair.c, pair.problem, 0, told);
    const auto [first, second] = std::minmax(problem.gaps[g].left, problem.gaps[g].right);
    for (Statement& statement : told.statements) {
      statement.gap = static_cast<Index>(g);
      statement.buildings = {first, second};
      all.statements.push_back(std::move(statement));
    }
    for (StoryTable& table : told.tables) {
      table.gap = static_cast<Index>(g);
      all.tables.push_back(std::move(table));
    }
  }
  sort_by_severity(all.statements);
  story::tell_quotations(c.code, all.statements);
  return all;
}

}  // namespace bentur
