#include "bentur/model/judgement/open_needs.h"

#include <optional>

#include "bentur/model/gap/facing_levels.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/judgement/compare.h"

namespace bentur {
namespace {

/// Whether more may come at some level than is given there, which has been enough so far; where nothing bounds it, it
/// may whatever is given.
bool more_may_come_in(const Problem& problem, const Response& response) {
  for (Eigen::Index gap = 0; gap < gap_count(problem); ++gap) {
    const double scale = displacement_scale(problem, response, gap);
    const auto is_more = [&](const auto& summary, double width) {
      const bool is_enough_so_far = !is_below_target(width, summary.gap_needed, scale);
      return comes_without_bound(summary.to_come) || (is_enough_so_far && more_may_come(summary.to_come, width, scale));
    };
    for (const FacingLevel& level : facing_levels(problem, gap)) {
      const auto index = static_cast<std::size_t>(level.index);
      const bool more = level.is_point ? is_more(response.points.at(index), level.width)
                                       : is_more(response.watched.at(index), level.width);
      if (more) return true;
    }
  }
  return false;
}

}  // namespace

const std::vector<std::string_view>& open_need_keys() {
  static const std::vector<std::string_view> keys = {"collapse", "drift_beyond_collapse", "doubt", "motion_left"};
  return keys;
}

std::uint64_t open_needs(const Problem& problem, const Response& response, const std::vector<Remark>& remarks) {
  std::uint64_t bits = 0;
  const auto set = [&](OpenNeed one, bool is_so) { bits |= is_so ? static_cast<unsigned>(one) : 0U; };
  const bool collapses = response.collapse_no_contact.has_value();
  set(OpenNeed::collapse, collapses);
  set(OpenNeed::drift, !collapses && falls_without_contact(problem, response));
  set(OpenNeed::doubt, count_of_doubts(remarks) > 0);
  set(OpenNeed::motion_left, !collapses && more_may_come_in(problem, response));
  return bits;
}

}  // namespace bentur
