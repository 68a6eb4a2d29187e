#include "bentur/model/judgement/judged_gaps.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/gap/minimum_gap.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/pounding/plan/masses_elsewhere.h"

namespace bentur {
namespace {

using Eigen::Index;

/// @param buildings of a row or in plan
template <class Buildings>
std::optional<Fall> fall_of(const std::optional<Collapse>& collapse, const Buildings& buildings) {
  if (!collapse) return std::nullopt;
  const auto& building = buildings.at(static_cast<std::size_t>(collapse->building));
  return Fall{building.name, building.model.storey_number(collapse->storey), collapse->time};
}

/// Drifts beyond collapse of those buildings in which nothing looks for it.
/// @param drifts largest one of each building
template <class Buildings>
std::vector<Beyond> beyond(const std::vector<LargestDrift>& drifts, const Buildings& buildings, double limit) {
  std::vector<Beyond> found;
  for (std::size_t b = 0; b < buildings.size() && b < drifts.size(); ++b) {
    if (!drifts_beyond_collapse(drifts[b].ratio, has_gravity(buildings[b]), limit)) continue;
    found.push_back({buildings[b].name, buildings[b].model.storey_number(drifts[b].storey), drifts[b].ratio});
  }
  return found;
}

/// Whether the ground moves, so that it can move the other way; results that are read back have it in their
/// excitation, and of a record that there is one.
bool moves(const GroundMotion& motion, const ExcitationSpec& excitation) {
  const auto is_motion = [](const GroundMotion& one) { return !std::holds_alternative<NoMotion>(one); };
  return is_motion(motion) || is_motion(excitation.motion) || excitation.record;
}

/// What rows and plans tell alike.
template <class Run>
RunFacts common_facts(const Run& run, bool has_other_way) {
  RunFacts facts;
  facts.given = {.looked_at = true,
                 .fall = fall_of(run.response.collapse_no_contact, run.problem.buildings),
                 .fall_with_contact = fall_of(run.response.collapse, run.problem.buildings),
                 .drifts = beyond(drifts_no_contact(run.response), run.problem.buildings, run.problem.collapse_drift)};
  facts.has_other_way = has_other_way;
  if (const auto& other = run.response.reversed) {
    facts.reversed = {.looked_at = true,
                      .fall = fall_of(other->collapse_no_contact, run.problem.buildings),
                      .fall_with_contact = fall_of(other->collapse, run.problem.buildings),
                      .drifts = beyond(other->drifts, run.problem.buildings, run.problem.collapse_drift)};
  }
  facts.doubts = doubts_of(run.remarks);
  for (const auto& building : run.problem.buildings) facts.names.push_back(building.name);
  return facts;
}

/// @param row the run, or row_of() it
RunFacts with_gaps(RunFacts facts, const RunResults& row) {
  for (Index gap = 0; gap < gap_count(row.problem); ++gap) {
    facts.names.push_back(gap_name(row.problem, gap));
    facts.closes.push_back(closes_either_way(row.problem, row.response, gap));
  }
  return facts;
}

/// @param row likewise
std::vector<JudgedGap> judged(const RunResults& row, const RunFacts& run, bool in_plan) {
  const auto all = separations(row.problem, row.response, row.c.code, row.c.units);
  const bool falls = falls_without_contact(row.problem, row.response);
  std::vector<JudgedGap> made;
  for (Index gap = 0; gap < gap_count(row.problem); ++gap) {
    const std::vector<LevelSeparation> levels = of_gap(all, gap);
    const double scale = displacement_scale(row.problem, row.response, gap);
    std::vector<RuleFinding> rules = rule_findings(row.problem, levels, row.c.code, scale, falls, in_plan);
    const bool others_close = run.others_close(static_cast<std::size_t>(gap));
    GapFacts facts = gap_facts(row.problem, row.response, gap, levels, std::move(rules), run, others_close);
    Judgement judgement = judge(facts);
    made.push_back({std::move(facts), std::move(judgement)});
  }
  return made;
}

}  // namespace

bool acts_reversed(const Case& c) {
  const auto is_reversed = [](const ExcitationSpec& one) {
    const auto* const harmonic = std::get_if<HarmonicMotion>(&one.motion);
    return one.record ? one.record->reversed : harmonic != nullptr && harmonic->is_reversed();
  };
  return is_reversed(c.excitation) || is_reversed(c.excitation_y);
}

RunFacts run_facts(const RunResults& run) {
  RunFacts facts = with_gaps(common_facts(run, moves(run.problem.motion, run.c.excitation)), run);
  facts.lacks_rules = !run.c.code.is_known;
  return facts;
}

RunFacts run_facts(const PlanRun& run) {
  bool either = false;
  for (const std::size_t i : {0U, 1U}) either = either || moves(run.problem.motions[i], *run.c.excitations()[i]);
  RunFacts facts = with_gaps(common_facts(run, either), *row_of(run));
  facts.masses_elsewhere = !mass_choices(run.problem).empty();
  return facts;
}

std::vector<JudgedGap> judged_gaps(const RunResults& run) { return judged(run, run_facts(run), false); }

std::vector<JudgedGap> judged_gaps(const PlanRun& run) { return judged(*row_of(run), run_facts(run), true); }

std::vector<JudgedGap> judged_gaps(const Case& c, const Problem& problem, const SpectralGaps& spectral) {
  RunFacts facts;
  facts.given.looked_at = true;
  facts.has_other_way = false;
  facts.doubts = doubts_of(spectral.plan ? remarks(c, *spectral.plan) : remarks(c, problem));
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Building& building = problem.buildings[b];
    facts.names.push_back(building.name);
    const CapacityDemand& most = spectral.demands.at(b);
    if (most.ratio > 1)
      facts.given.capacities.push_back({building.name, building.model.storey_number(most.storey), most.ratio});
    const LargestDrift& drift = spectral.drifts.at(b);
    if (drifts_beyond_collapse(drift.ratio, false, problem.collapse_drift))
      facts.given.drifts.push_back({building.name, building.model.storey_number(drift.storey), drift.ratio});
  }
  for (Index gap = 0; gap < gap_count(problem); ++gap) facts.names.push_back(gap_name(problem, gap));
  std::vector<JudgedGap> all;
  for (Index gap = 0; gap < gap_count(problem); ++gap) {
    const std::vector<LevelSeparation> levels = of_gap(spectral.levels, gap);
    all.push_back(
        {.facts = gap_facts(problem, gap, levels,
                            rule_findings(problem, levels, c.code, 0, false, spectral.plan != nullptr), facts),
         .judgement = {}});
    all.back().judgement = judge(all.back().facts);
  }
  return all;
}

}  // namespace bentur
