// What is said of gaps of random rows and of the plans that stand for them: never that one is enough where buildings
// meet, in the run, in that of the motion reversed, or under a little less motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "bentur/core/errors.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/story/story.h"
#include "bentur/pounding/pounding.h"
#include "tests/invariance/every_kind.h"
#include "tests/invariance/plan_twin.h"
#include "tests/invariance/random_case.h"
#include "tests/support/random_numbers.h"

namespace bentur {
namespace {

using namespace bentur::test;

/// BENTUR_JUDGEMENTS=FIRST:COUNT runs others than those that the test always runs.
std::pair<unsigned, unsigned> chosen_judgements() { return test::seeds_of("BENTUR_JUDGEMENTS", {1, 1000}, {1, 100}); }

constexpr unsigned parts_of_judgements = 2;  // run at the same time

SolveOptions judged_options() { return {.limits = {.events = 20000}, .levels = true, .both_ways = true}; }

class Draws : public Chance {
 public:
  using Chance::among;
  using Chance::chance;
  using Chance::Chance;
  using Chance::uniform;
};

Case drawn(unsigned seed) {
  Case c = seed % 2 == 0 ? EveryKindGenerator(seed).make() : CaseGenerator(seed).make().c;
  c.units = {.length = "m", .force = "N"};
  c.analysis.duration = std::min(c.analysis.duration, 1.5);
  c.analysis.goes_on = seed % 5 != 0;
  return c;
}

bool is_elastic(const Problem& problem) {
  return std::none_of(problem.buildings.begin(), problem.buildings.end(),
                      [](const Building& one) { return one.can_yield() || one.has_gravity_loads; });
}

/// Of a run with contact, whether bodies of a gap meet.
bool meets(const Problem& problem, const Response& response, Eigen::Index gap) {
  const Gap between = gap_at(problem, gap);
  return std::any_of(between.points.begin(), between.points.end(),
                     [&](Eigen::Index i) { return response.points[i].impacts + response.points[i].settling > 0; }) ||
         std::any_of(between.watched.begin(), between.watched.end(),
                     [&](Eigen::Index i) { return response.watched[i].closes; });
}

GroundMotion scaled(GroundMotion motion, double factor) {
  if (auto* sampled = std::get_if<SampledMotion>(&motion)) {
    for (double& value : sampled->acceleration) value *= factor;
  }
  if (auto* harmonic = std::get_if<HarmonicMotion>(&motion)) harmonic->displacement_amplitude *= factor;
  return motion;
}

struct Judged {
  long cases = 0, gaps = 0, enough = 0, small = 0, unknown = 0, twins = 0, at_need = 0, asked_more = 0,
       reversed_contact = 0;
};

/// Whether a run of the same with another motion meets somewhere; of one that does not end in its time nothing is said.
bool meets_under(Problem problem, double factor, Eigen::Index gap) {
  problem.motion = scaled(problem.motion, factor);
  const Response found = solve(problem, ExactSolver{}, {.limits = {.events = 20000}});
  return found.status == Status::done && meets(problem, found, gap);
}

/// What is said of a gap of a row, held against runs.
void examine_gap(const RunResults& run, Eigen::Index gap, const JudgedGap& one, Judged& tally) {
  ++tally.gaps;
  tally.enough += one.judgement.is_enough() ? 1 : 0;
  tally.small += one.judgement.value == Sufficiency::too_small ? 1 : 0;
  tally.unknown += one.judgement.value == Sufficiency::unknown ? 1 : 0;
  const bool struck = meets(run.problem, run.response, gap);
  EXPECT_TRUE(!struck || one.judgement.value == Sufficiency::too_small);
  EXPECT_EQ(one.judgement.reasons.empty(), one.judgement.is_enough());
  if (!one.judgement.is_enough()) return;
  EXPECT_FALSE(struck);
  for (const Sufficiency level : one.judgement.levels) EXPECT_EQ(level, Sufficiency::enough);
  EXPECT_FALSE(one.facts.has_other_way && meets_under(run.problem, -1, gap)) << "the motion reversed";
  // A building that yields, or falls, may go further under less.
  if (one.facts.has_other_way && is_elastic(run.problem)) {
    EXPECT_FALSE(meets_under(run.problem, 0.999, gap)) << "0.999 of the motion";
  }
}

/// Kinds of statements, each with its gap, in order of the alphabet. Not compared: remarks; rules, as the
/// double-difference rule needs a period of each building, which floors that turn have not.
std::set<std::string> said(const Story& story) {
  std::set<std::string> kinds;
  for (Statement one : story.statements) {
    if (one.severity == Severity::remark || one.kind.starts_with("rules") || one.kind == "asked_more") continue;
    if (one.kind == "pga_along") one.kind = "pga";
    kinds.insert(one.gap ? fmt::format("{} of gap {}", one.kind, *one.gap) : one.kind);
  }
  return kinds;
}

/// The same in plan, where it stands for the row: each gap is judged alike, for the same reasons, in the same words.
void examine_twin(const Case& c, const RunResults& given, const std::vector<JudgedGap>& row, Judged& tally) {
  const std::optional<Case> twin = twin_of(c, 2, Eigen::Matrix2d::Identity());
  if (!twin) return;
  PlanProblem problem = make_plan_problem(*twin);
  PlanResponse response = solve(problem, ExactSolver{}, judged_options());
  if (response.status != Status::done && response.status != Status::collapsed) return;
  const PlanRun run = run_results(*twin, std::move(problem), std::move(response));
  const std::vector<JudgedGap> plan = judged_gaps(run);
  ASSERT_EQ(plan.size(), row.size());
  ++tally.twins;
  bool motion_left = false;
  for (std::size_t g = 0; g < row.size(); ++g) {
    std::vector<std::string> of_plan, of_row;
    // A plan has more modes, whose bound on what may still come is wider.
    const auto counts = [&](const Reason& one) {
      motion_left = motion_left || one.kind == Reason::Kind::motion_left;
      return one.kind != Reason::Kind::motion_left;
    };
    for (const Reason& one : plan[g].judgement.reasons) {
      if (counts(one)) of_plan.push_back(word_of(one));
    }
    for (const Reason& one : row[g].judgement.reasons) {
      if (counts(one)) of_row.push_back(word_of(one));
    }
    EXPECT_EQ(of_plan, of_row) << "gap " << g << " in plan";
  }
  if (motion_left) return;
  EXPECT_EQ(said(run_story(run)), said(run_story(given)));
}

/// Where rules of thumb ask for more than a gap that is not found too small otherwise, a sentence says so.
void examine_rules(const Story& story, const std::vector<JudgedGap>& judged, Judged& tally) {
  const auto says = [&](const char* kind, std::size_t g) {
    return std::any_of(story.statements.begin(), story.statements.end(), [&](const Statement& one) {
      return one.kind == kind && one.gap == static_cast<Eigen::Index>(g);
    });
  };
  for (std::size_t g = 0; g < judged.size(); ++g) {
    const bool more = judged[g].judgement.value != Sufficiency::too_small && says("rules_short", g);
    tally.asked_more += more ? 1 : 0;
    EXPECT_EQ(says("asked_more", g), more) << "gap " << g;
  }
}

/// Contact of the motion reversed that is harder, or in a gap that the motion as given leaves open, is said of rows.
void examine_reversed_contact(const Story& story, const std::vector<JudgedGap>& judged, Judged& tally) {
  double given = 0, reversed = 0;
  bool closes_more = false;
  for (const JudgedGap& one : judged) {
    given = std::max(given, one.facts.peak_force());
    reversed = std::max(reversed, one.facts.peak_force(Way::reversed));
    closes_more = closes_more || (one.facts.touch(Way::reversed) && !one.facts.touch());
  }
  const bool is_said = std::any_of(story.statements.begin(), story.statements.end(),
                                   [](const Statement& one) { return one.kind.starts_with("row_reversed"); });
  EXPECT_EQ(is_said, judged.size() > 1 && (closes_more || reversed > (1 + 1e-6) * given));
  tally.reversed_contact += is_said ? 1 : 0;
}

void examine_judgements(unsigned seed, Judged& tally) {
  SCOPED_TRACE(fmt::format("case {}", seed));
  Draws draw(seed + 7);
  Case c = drawn(seed);
  Problem problem;
  try {
    problem = make_problem(c);
  } catch (const InvalidParameter&) {
    return;  // a column that one gap strikes has been moved for the other
  }
  Response response = solve(problem, ExactSolver{}, judged_options());
  if (response.status != Status::done && response.status != Status::collapsed) return;
  ++tally.cases;
  // A gap of its own for each, about as wide as what it needs.
  constexpr double factors[] = {0.7, 0.999, 1.001, 1.05, 2.0};
  const double common = factors[draw.among(0, 4)];
  bool all_wide = true;
  for (std::size_t g = 0; g < c.gaps.size(); ++g) {
    const auto needed = [&](bool reversed) {
      double most = 0;
      for (const LevelSeparation& one : of_gap(separations(problem, response), static_cast<Eigen::Index>(g))) {
        most = std::max(most, reversed ? one.gap_needed_reversed.value_or(0) : one.gap_needed);
      }
      return most;
    };
    const double factor = draw.chance(0.7) ? common : factors[draw.among(0, 4)];
    const double need = std::max(needed(false), needed(true));
    all_wide = all_wide && factor > 1 && need > 1e-9;
    c.gaps[g].widths.assign(c.gaps[g].widths.size(), std::max(need, 1e-6) * factor);
  }
  problem = make_problem(c);
  response = solve(problem, ExactSolver{}, judged_options());
  if (response.status != Status::done && response.status != Status::collapsed) return;
  const RunResults run = run_results(c, std::move(problem), std::move(response));
  const std::vector<JudgedGap> judged = judged_gaps(run);
  for (std::size_t g = 0; g < judged.size(); ++g) {
    examine_gap(run, static_cast<Eigen::Index>(g), judged[g], tally);
    // With what they need, and a thousandth more, nobody meets anybody.
    if (!all_wide || run.response.collapse_no_contact || run.response.collapse) continue;
    ++tally.at_need;
    for (const Reason& one : judged[g].judgement.reasons) {
      EXPECT_FALSE(one.kind == Reason::Kind::contact || one.kind == Reason::Kind::unmodelled) << word_of(one);
    }
  }
  const Story story = run_story(run);
  examine_rules(story, judged, tally);
  examine_reversed_contact(story, judged, tally);
  if (seed % 2 == 1)
    examine_twin(c, run, judged, tally);  // rows of every kind have struck columns, which plans have not
}

class RandomJudgements : public testing::TestWithParam<unsigned> {};

TEST_P(RandomJudgements, NeverSayEnoughWhereBuildingsMeet) {
  const auto [all_first, all] = chosen_judgements();
  const unsigned first = all_first + all * GetParam() / parts_of_judgements;
  const unsigned count = all_first + all * (GetParam() + 1) / parts_of_judgements - first;
  if (count == 0) GTEST_SKIP() << "fewer cases than parts";
  Judged tally;
  for (unsigned seed = first; seed < first + count; ++seed) examine_judgements(seed, tally);
  fmt::print("{} cases, {} gaps: {} enough, {} too small, {} not known; {} with what they need, {} in plan too\n",
             tally.cases, tally.gaps, tally.enough, tally.small, tally.unknown, tally.at_need, tally.twins);
  EXPECT_GT(tally.cases, 0.8 * count);
  EXPECT_GT(tally.enough, 0.1 * count);
  EXPECT_GT(tally.small, 0.2 * count);
  EXPECT_GT(tally.twins, 0.02 * count);
  EXPECT_GT(tally.asked_more, 0.1 * count);
  EXPECT_GT(tally.reversed_contact, 0.02 * count);
}

INSTANTIATE_TEST_SUITE_P(Parts, RandomJudgements, testing::Range(0U, parts_of_judgements));

}  // namespace
}  // namespace bentur
