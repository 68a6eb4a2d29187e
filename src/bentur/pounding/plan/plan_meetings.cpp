#include "bentur/pounding/plan/plan_meetings.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace bentur {
namespace {

using Eigen::Index;

/// The contacts of a level and a pair of parts, counted over all gaps, where they touch only while others are closed.
struct MeetingOfLevel {
  struct Point {
    Index at = 0, family = 0;
    double width = 0;
  };
  std::vector<Point> points;
};

std::vector<MeetingOfLevel> meetings_of(const PlanProblem& problem) {
  std::vector<MeetingOfLevel> all;
  Index point = 0;
  for (const PlanGap& gap : problem.gaps) {
    std::map<std::pair<double, Index>, std::size_t> known;  // by level and pair of parts
    for (const PlanContact& contact : gap.contacts) {
      const Index at = point++;
      if (contact.family < 0) continue;
      const auto [meeting, is_new] = known.try_emplace({contact.elevation, contact.pair}, all.size());
      if (is_new) all.emplace_back();
      all[meeting->second].points.push_back({at, contact.family, gap.width_at(contact)});
    }
  }
  return all;
}

/// Whether all families of a meeting close at some time, by what a point needs.
template <class Need>
bool all_close(const MeetingOfLevel& meeting, const Need& need) {
  std::map<Index, bool> closes;
  for (const auto& point : meeting.points) {
    bool& one = closes[point.family];
    one = one || need(point.at) > point.width;
  }
  return std::all_of(closes.begin(), closes.end(), [](const auto& one) { return one.second; });
}

/// Of each contact of all gaps its number in the system.
std::vector<std::size_t> numbers_in_system(const PlanProblem& problem) {
  const std::vector<Index> places = places_of(problem);
  std::vector<std::size_t> numbers(places.size());
  for (std::size_t n = 0; n < places.size(); ++n) {
    if (places[n] >= 0) numbers[static_cast<std::size_t>(places[n])] = n;
  }
  return numbers;
}

}  // namespace

bool has_meetings(const PlanProblem& problem) {
  return std::any_of(problem.gaps.begin(), problem.gaps.end(), [](const PlanGap& gap) {
    return std::any_of(gap.contacts.begin(), gap.contacts.end(),
                       [](const PlanContact& contact) { return contact.family >= 0; });
  });
}

void take_meetings(const PlanProblem& problem, FreeTouches& given, const std::function<FreeTouches&()>& reversed,
                   std::vector<PointSummary>& points) {
  if (!has_meetings(problem)) return;
  constexpr double unknown = std::numeric_limits<double>::infinity();
  const std::vector<std::size_t> numbers = numbers_in_system(problem);
  const auto touches = [&](const MeetingOfLevel& meeting, FreeTouches& free) {
    return std::any_of(meeting.points.begin(), meeting.points.end(), [&](const MeetingOfLevel::Point& point) {
      return free.found()[numbers[static_cast<std::size_t>(point.at)]] != 0;
    });
  };
  for (const MeetingOfLevel& meeting : meetings_of(problem)) {
    const auto point_at = [&](Index at) -> PointSummary& { return points[static_cast<std::size_t>(at)]; };
    const auto given_at = [](const MeetingOfLevel::Point& point) { return std::max(point.width, 0.0); };
    const auto closes = [&](std::optional<double> PointSummary::*member) {
      return all_close(meeting, [&](Index at) { return (point_at(at).*member).value_or(unknown); });
    };
    const auto lower = [&](std::optional<double> PointSummary::*member) {
      for (const MeetingOfLevel::Point& point : meeting.points) {
        std::optional<double>& value = point_at(point.at).*member;
        if (value) value = std::min(*value, given_at(point));
      }
    };
    const bool some_need = all_close(meeting, [&](Index at) { return point_at(at).gap_needed; });
    if (!some_need || !touches(meeting, given)) {
      for (const MeetingOfLevel::Point& point : meeting.points) {
        double& need = point_at(point.at).gap_needed;
        need = std::min(need, given_at(point));
      }
    }
    const bool is_asked = point_at(meeting.points.front().at).gap_needed_reversed.has_value();
    if (!closes(&PointSummary::gap_needed_reversed) || (is_asked && !touches(meeting, reversed()))) {
      lower(&PointSummary::gap_needed_reversed);
    }
    for (const auto member : {&PointSummary::to_come, &PointSummary::to_come_reversed, &PointSummary::to_come_struck}) {
      if (!closes(member)) lower(member);
    }
  }
}

}  // namespace bentur
