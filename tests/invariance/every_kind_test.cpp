// Buildings and links of every kind: what is asked for beside the answer does not change it, to the bit, nor do floors
// that are only watched; and it is what `adaptive` finds, which takes none of the shortcuts of `exact`.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "bentur/core/errors.h"
#include "bentur/solve/solver.h"
#include "tests/invariance/every_kind.h"
#include "tests/support/same_response.h"

namespace bentur {
namespace {

using namespace bentur::test;

/// BENTUR_EVERY_KIND=FIRST:COUNT runs others than those that the test always runs.
std::pair<unsigned, unsigned> chosen() {
#ifdef __SANITIZE_ADDRESS__
  std::pair<unsigned, unsigned> range = {1, 40};
#else
  std::pair<unsigned, unsigned> range = {1, 600};
#endif
  if (const char* text = std::getenv("BENTUR_EVERY_KIND")) {
    unsigned first = 1, count = 0;
    if (std::sscanf(text, "%u:%u", &first, &count) == 2) range = {first, count};
  }
  return range;
}

TEST(EveryKind, IsNotChangedByWhatIsAskedForBesideIt) {
  const auto [first, count] = chosen();
  long impacts = 0, still = 0, unmade = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE(seed);
    Problem problem;
    try {
      problem = make_problem(EveryKindGenerator(seed).make());
    } catch (const InvalidParameter& error) {  // gravity loads that a weak building does not bear
      ++unmade;
      continue;
    }
    const Response plain = solve(problem);
    ASSERT_TRUE(plain.status == Status::done || plain.status == Status::collapsed) << plain.message;
    SolveOptions all;
    all.output_step = 0.0137;
    all.energy_audit = true;
    const Response looked = solve(problem, ExactSolver{}, all);
    ASSERT_EQ(looked.status, plain.status) << looked.message;
    expect_same(plain, looked);
    Problem unwatched = problem;
    unwatched.watched.clear();
    expect_same(plain, solve(unwatched));
    const Response other = solve(problem, AdaptiveSolver{1e-10});
    ASSERT_TRUE(other.status == Status::done || other.status == Status::collapsed) << other.message;
    EXPECT_EQ(plain.impacts.empty(), other.impacts.empty());
    // When those begin that touch from the start is a matter of round-off.
    const bool apart = std::none_of(problem.points.begin(), problem.points.end(),
                                    [](const ContactPoint& point) { return point.width == 0; });
    if (apart && !plain.impacts.empty() && !other.impacts.empty()) {
      EXPECT_NEAR(plain.impacts[0].start, other.impacts[0].start, 1e-5 * problem.duration);
    }
    impacts += static_cast<long>(plain.impacts.size());
    still += plain.impacts.empty() ? 1 : 0;
  }
  fmt::print("{} cases, {} impacts, {} cases without, {} that cannot be\n", count, impacts, still, unmade);
  EXPECT_GT(impacts, 2 * static_cast<long>(count));
  EXPECT_GT(still, 0);
  EXPECT_LT(unmade, count / 5 + 1);
}

}  // namespace
}  // namespace bentur
