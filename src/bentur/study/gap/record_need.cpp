#include "bentur/study/gap/record_need.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "bentur/model/gap/facing_levels.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/judgement/open_needs.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/pounding/pounding.h"

namespace bentur {
namespace {

void reverse(GroundMotion& motion) {
  if (auto* const sampled = std::get_if<SampledMotion>(&motion)) {
    for (double& value : sampled->acceleration) value = -value;
  }
}
Problem mirrored(Problem problem) {
  reverse(problem.motion);
  return problem;
}
PlanProblem mirrored(PlanProblem problem) {
  for (GroundMotion& motion : problem.motions) reverse(motion);
  return problem;
}

/// What may still come at each facing level [length]; 0: nothing.
/// @param both_ways of the motion reversed too, where that is known
std::vector<double> all_to_come(const Problem& problem, const Response& response, bool both_ways) {
  std::vector<double> all;
  const auto take = [&](const auto& summary) {
    const double given = summary.to_come.value_or(0);
    all.push_back(both_ways ? std::max(given, summary.to_come_reversed.value_or(0)) : given);
  };
  for (const FacingLevel& level : facing_levels(problem)) {
    const auto index = static_cast<std::size_t>(level.index);
    if (level.is_point) {
      take(response.points.at(index));
    } else {
      take(response.watched.at(index));
    }
  }
  return all;
}

/// @param problem a row, or row_of() buildings in plan
RecordNeed record_need_of(const std::string& record, const Problem& problem, const Response& response, const Case& c,
                          const std::vector<Remark>& found, bool both_ways) {
  return {.record = record,
          .falls = falls_without_contact(problem, response),
          .open = open_needs(problem, response, found),
          .separations = separations(problem, response, c.code, c.units),
          .to_come = all_to_come(problem, response, both_ways),
          .gaps = {}};
}

void refuse_failed(const std::string& record, Status status, const std::string& message) {
  if (status != Status::done && status != Status::collapsed) throw std::runtime_error(record + ": " + message);
}

RecordNeed need_without_contact(const std::string& record, const ReadCase& read, const Problem& problem,
                                bool both_ways) {
  const FreeResponse free(problem, read.c.analysis.solver, {}, run_limits(read.c.analysis), true);
  const Response& response = free.response();
  refuse_failed(record, response.status, response.message);
  return record_need_of(record, problem, response, read.c, remarks(read.c, problem, &response), both_ways);
}

RecordNeed need_without_contact(const std::string& record, const ReadCase& read, const PlanProblem& problem,
                                bool both_ways) {
  const PlanFreeResponse free(problem, read.c.analysis.solver, {}, run_limits(read.c.analysis), true);
  const PlanRun run = run_results(read.c, problem, free.response());
  refuse_failed(record, run.response.status, run.response.message);
  const auto row = row_of(run);
  return record_need_of(record, row->problem, row->response, row->c, run.remarks, both_ways);
}

void take_larger(double& value, double other) { value = std::isnan(other) ? other : std::max(value, other); }

/// Makes each number of a record the larger one of both ways round. @param reversed_need what the reversed record
/// needs, asked for where the record itself does not say
void take_other_way(RecordNeed& need, const std::function<RecordNeed()>& reversed_need) {
  std::vector<LevelSeparation>& levels = need.separations;
  const bool is_known = std::all_of(levels.begin(), levels.end(),
                                    [](const LevelSeparation& one) { return one.gap_needed_reversed.has_value(); });
  std::vector<LevelSeparation> reversed = levels;
  if (!is_known && !levels.empty()) {
    RecordNeed other = reversed_need();
    need.falls = need.falls || other.falls;
    need.open |= other.open;
    for (std::size_t i = 0; i < levels.size(); ++i) take_larger(need.to_come.at(i), other.to_come.at(i));
    reversed = std::move(other.separations);
    for (LevelSeparation& one : reversed) one.gap_needed_reversed = one.gap_needed;
  }
  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels[i].gap_needed_reversed = reversed[i].gap_needed_reversed;
    take_larger(levels[i].gap_needed, *reversed[i].gap_needed_reversed);
    take_larger(levels[i].abs, reversed[i].abs);
    take_larger(levels[i].srss, reversed[i].srss);
    take_larger(levels[i].ddc, reversed[i].ddc);
    for (std::size_t rule = 0; rule < levels[i].codes.size(); ++rule) {
      take_larger(levels[i].codes[rule].gap, reversed[i].codes[rule].gap);
    }
  }
}

template <class AnyProblem>
RecordNeed need_either_way(const std::string& record, const ReadCase& read, const AnyProblem& problem, bool both_ways) {
  RecordNeed result = need_without_contact(record, read, problem, both_ways);
  if (both_ways) {
    take_other_way(result, [&] { return need_without_contact(record + ", reversed", read, mirrored(problem), false); });
  }
  return result;
}

}  // namespace

RecordNeed need_of_record(const std::string& record, const ReadCase& read, bool both_ways) {
  return read.plan ? need_either_way(record, read, *read.plan, both_ways)
                   : need_either_way(record, read, read.problem(), both_ways);
}

}  // namespace bentur
