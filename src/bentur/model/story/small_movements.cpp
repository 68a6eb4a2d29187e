#include "bentur/model/story/internal/small_movements.h"

#include <algorithm>
#include <cmath>

#include "bentur/model/plan/plan_pairs.h"
#include "bentur/model/story/internal/story_parts.h"

namespace bentur::story {

using Eigen::Index;

void tell_rotations(const PlanRun& run, std::vector<Statement>& statements) {
  constexpr double share = 0.1;  // of the largest penetration
  double penetration = 0;
  for (const PointSummary& point : run.response.points) penetration = std::max(penetration, point.peak_penetration);
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const PlanModel& model = run.problem.buildings[b].model;
    double left_out = 0;
    for (Index f = 0; f < model.floors(); ++f) {
      const PlanPoint centre = model.footprint.corner + model.centres[f];
      double arm = 0;
      for (const PlanPoint& corner : model.footprint.corners()) arm = std::max(arm, (corner - centre).norm());
      const double theta = run.response.buildings[b].rotation(f);
      left_out = std::max(left_out, 0.5 * theta * theta * arm);
    }
    if (penetration == 0 || left_out <= share * penetration) continue;
    Statement statement{.kind = "remark.small_rotations", .severity = Severity::remark, .buildings = {b}};
    statement.values = {value_in("value", left_out, run.c.units.length),
                        value_in("penetration", penetration, run.c.units.length)};
    statement.subject = run.problem.buildings[b].name;
    statements.push_back(std::move(statement));
  }
}

void tell_ends_of_edges(const PlanRun& run, std::vector<Statement>& statements) {
  Index point = 0;  // of all gaps
  for (std::size_t g = 0; g < run.problem.gaps.size(); ++g) {
    const PlanGap& gap = run.problem.gaps[g];
    double reach = 0, room = 0;
    for (const PlanContact& contact : gap.contacts) {
      if (run.response.points[point++].impacts == 0) continue;
      const StretchCorner place = gap.at(contact);
      if (contact.family >= 0) continue;  // whose end is looked at
      const double there = gap.stretch.is_parallel() ? gap.stretch.to - gap.stretch.from : place.room;
      const PlanPoint t(-place.normal.y(), place.normal.x());
      const double moved =
          reach_of(run.response.buildings[gap.left], t) + reach_of(run.response.buildings[gap.right], t);
      if (moved <= there || moved - there <= reach - room) continue;
      reach = moved;
      room = there;
    }
    if (reach == 0) continue;
    const auto [first, second] = std::minmax(gap.left, gap.right);
    Statement statement{.kind = "remark.end_of_edge",
                        .severity = Severity::remark,
                        .gap = static_cast<Index>(g),
                        .buildings = {first, second}};
    statement.values = {value_in("room", room, run.c.units.length), value_in("reach", reach, run.c.units.length)};
    statement.subject = gap_name(run.problem, gap);
    statements.push_back(std::move(statement));
  }
}

}  // namespace bentur::story
