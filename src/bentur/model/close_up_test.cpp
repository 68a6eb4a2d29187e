#include "bentur/model/close_up.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bentur/contact/laws/linear.h"
#include "tests/support/free_masses.h"

namespace bentur {
namespace {

/// Half a sine of duration π√(m_e/k) and peak v √(k m_e), long after the start of the run.
TEST(CloseUp, ShowsTheImpactFromTouchingToParting) {
  const double k = 4e6;
  const double speed = 0.5;
  const double effective = 2.0 * 3.0 / 5.0;
  const auto problem = test::free_masses(2, 3, 0.5, speed, std::make_shared<Linear>(k), 4);
  const Response response = solve(problem);
  ASSERT_EQ(response.impacts.size(), 1U);
  const auto found = close_up(problem, response, ExactSolver{});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->impact, 0);
  const double duration = std::numbers::pi * std::sqrt(effective / k);
  const double step = duration / 200;
  EXPECT_NEAR(found->time.front(), response.impacts[0].start - duration / 2, 1.01 * step);
  EXPECT_NEAR(found->time.back(), response.impacts[0].end + duration / 2, 1.01 * step);
  const double peak = speed * std::sqrt(k * effective);
  for (std::size_t i = 0; i < found->time.size(); ++i) {
    const double phase = std::numbers::pi * (found->time[i] - response.impacts[0].start) / duration;
    const double force = phase > 0 && phase < std::numbers::pi ? peak * std::sin(phase) : 0;
    EXPECT_NEAR(found->force[i], force, 1e-8 * peak) << i;
    EXPECT_NEAR(std::max(0.0, -found->opening[i]), force / k, 1e-8 * peak / k) << i;
  }
}

TEST(CloseUp, NothingWithoutAnImpactOrWithoutRoom) {
  const auto law = std::make_shared<Linear>(4e6);
  const auto apart = test::free_masses(2, 3, 10, 0.5, law, 1);
  EXPECT_FALSE(close_up(apart, solve(apart), ExactSolver{}));
  const auto late = test::free_masses(2, 3, 0.5, 0.5, law, 4);
  EXPECT_FALSE(close_up(late, solve(late), ExactSolver{}, 1000));
}

}  // namespace
}  // namespace bentur
