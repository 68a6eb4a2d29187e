#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <regex>

#include "bentur/core/errors.h"
#include "bentur/model/case.h"
#include "bentur/study/exchange/gem.h"
#include "bentur/study/exchange/nrml.h"
#include "tests/support/small_buildings.h"

namespace bentur {
namespace {

/// The numbers behind mean="…" and stddev="…" of every limit state.
std::vector<std::array<double, 2>> moments_in(const std::string& xml) {
  static const std::regex of_params("mean=\"([^\"]+)\" stddev=\"([^\"]+)\"");
  std::vector<std::array<double, 2>> found;
  for (std::sregex_iterator at(xml.begin(), xml.end(), of_params), end; at != end; ++at) {
    found.push_back({std::stod((*at)[1]), std::stod((*at)[2])});
  }
  return found;
}

TEST(Nrml, MomentsGiveMedianAndDispersionBack) {
  NrmlModel model{.id = "m", .description = "a < b & \"c\"", .lowest = 0.05, .highest = 1.5};
  std::vector<std::pair<double, double>> given;
  for (const double median : {0.01, 0.19, 0.5669, 3.0}) {
    for (const double dispersion : {1e-4, 0.05, 0.1675, 0.6, 1.5}) given.emplace_back(median, dispersion);
  }
  for (const auto& [median, dispersion] : given) {
    model.functions.push_back({std::to_string(model.functions.size()), {{"pounding", median, dispersion}}});
  }
  const std::string xml = nrml_fragility(model, "1");
  const auto moments = moments_in(xml);
  ASSERT_EQ(moments.size(), given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    const auto [mean, stddev] = moments[i];
    const double square = std::log1p(stddev / mean * (stddev / mean));
    EXPECT_NEAR(mean / std::exp(square / 2) / given[i].first, 1, 1e-12);
    EXPECT_NEAR(std::sqrt(square) / given[i].second, 1, 1e-12);
  }
  EXPECT_NE(xml.find("imt=\"PGA\" noDamageLimit=\"0\" minIML=\"0.05\" maxIML=\"1.5\""), std::string::npos);
  EXPECT_NE(xml.find("a &lt; b &amp; &quot;c&quot;"), std::string::npos);
}

TEST(Nrml, ByHand) {  // θ = 0.4 g, β = √ln 2: the mean is θ √2, and so is the standard deviation
  const LognormalMoments moments = lognormal_moments(0.4, std::sqrt(std::log(2.0)));
  EXPECT_NEAR(moments.mean, 0.4 * std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(moments.stddev, 0.4 * std::sqrt(2.0), 1e-15);
  EXPECT_THROW((void)lognormal_moments(0.4, 0), InvalidParameter);
  EXPECT_THROW((void)lognormal_moments(-1, 0.3), InvalidParameter);
  EXPECT_THROW((void)nrml_fragility({.lowest = 1, .highest = 2}, "1"), InvalidParameter);
}

/// Two widths, three records, four levels; no event with the wider gap.
IdaResults results(const std::string& unit, const std::string& intensity) {
  IdaResults made;
  made.title = "Pair";
  made.intensity = intensity;
  made.study_unit = unit;
  made.axes = {{"width", 2, {{"width", "m", "gap[0].width", {0.1, 0.2}, {}}}}};
  OutcomeTable& table = made.table;
  table.levels = {0.981, 1.962, 3.924, 7.848};
  table.cases = 2;
  table.records = 3;
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t record = 0; record < 3; ++record) {
      for (std::size_t level = 0; level < 4; ++level) {
        const bool event = c == 0 && level + record > 2;
        table.outcomes.push_back(event ? Outcome::event : Outcome::no_event);
      }
    }
  }
  return made;
}

TEST(Nrml, OfResultsInTheUnitOfOpenQuake) {
  const IdaResults given = results("m/s2", "spectral acceleration, period 0.8 s, damping 2 %");
  std::string error;
  const auto made = nrml_of({{"impacts > 0", given}}, "CR/LFM", false, error);
  ASSERT_TRUE(made) << error;
  EXPECT_EQ(made->model.period, 0.8);
  EXPECT_NEAR(made->damping, 0.02, 1e-15);
  EXPECT_NEAR(made->model.lowest, 0.981 / 9.80665, 1e-15);
  ASSERT_EQ(made->model.functions.size(), 1U);
  EXPECT_EQ(made->model.functions[0].id, "CR/LFM/width=0.1");
  EXPECT_EQ(made->model.functions[0].curves[0].limit_state, "pounding");
  const CaseFragility fit = fit_case(given.table, 0, {.resamples = 1});
  EXPECT_NEAR(made->model.functions[0].curves[0].median * 9.80665, fit.fit.median, 1e-12);
  ASSERT_EQ(made->left_out.size(), 1U);
  EXPECT_EQ(made->left_out[0], "CR/LFM/width=0.2 (impacts > 0)");
  IdaResults never = given;
  for (Outcome& one : never.table.outcomes) one = Outcome::no_event;
  EXPECT_FALSE(nrml_of({{"peak_force > 20", never}}, "X", false, error));
  EXPECT_FALSE(error.empty());
}

TEST(Nrml, AMedianBeyondTheLevelsIsMarked) {
  IdaResults given = results("g", "peak ground acceleration");
  std::string error;
  const auto within = nrml_of({{"impacts > 0", given}}, "X", false, error);
  ASSERT_TRUE(within) << error;
  EXPECT_TRUE(within->extrapolated.empty());
  EXPECT_EQ(nrml_fragility(within->model, "1").find("extrapolated"), std::string::npos);
  // One of three records has the event, from the third level on: every second one is beyond the last level.
  for (std::size_t record = 0; record < 3; ++record) {
    for (std::size_t level = 0; level < 4; ++level) {
      given.table.outcomes[record * 4 + level] = record == 2 && level > 1 ? Outcome::event : Outcome::no_event;
    }
  }
  const auto beyond = nrml_of({{"impacts > 0", given}}, "X", false, error);
  ASSERT_TRUE(beyond) << error;
  const NrmlCurve& curve = beyond->model.functions.at(0).curves.at(0);
  EXPECT_GT(curve.median, beyond->model.highest);
  EXPECT_EQ(beyond->extrapolated, std::vector<std::string>{"X/width=0.1 (impacts > 0)"});
  const std::string xml = nrml_fragility(beyond->model, "1");
  const std::size_t mark = xml.find("<!-- extrapolated: median ");
  ASSERT_NE(mark, std::string::npos);
  EXPECT_LT(mark, xml.find("<params"));
}

TEST(Nrml, ACurveThatItsRunsDoNotFollowIsLeftOutUnlessAskedFor) {
  // Two of forty records have the event at four levels, all of them at the last: no lognormal is so flat, then so
  // steep.
  IdaResults given = results("g", "peak ground acceleration");
  given.table.cases = 1;
  given.axes[0].coordinates[0].numbers = {0.1};
  given.table.records = 40;
  given.table.levels = {0.1, 0.2, 0.4, 0.8, 1.6};
  given.table.outcomes.clear();
  for (std::size_t record = 0; record < 40; ++record) {
    for (std::size_t level = 0; level < 5; ++level) {
      given.table.outcomes.push_back(record < (level < 4 ? 2U : 40U) ? Outcome::event : Outcome::no_event);
    }
  }
  std::string error;
  EXPECT_TRUE(fit_case(given.table, 0, {.resamples = 1}).is_misfit());
  EXPECT_FALSE(nrml_of({{"impacts > 0", given}}, "X", false, error));
  EXPECT_NE(error.find("--misfits"), std::string::npos);
  const auto taken = nrml_of({{"impacts > 0", given}}, "X", true, error);
  ASSERT_TRUE(taken) << error;
  EXPECT_EQ(taken->misfits, std::vector<std::string>{"X (impacts > 0)"});
  const std::string xml = nrml_fragility(taken->model, "1");
  EXPECT_LT(xml.find("<!-- misfit:"), xml.find("<params"));
}

TEST(Gem, HasSystemStoreysPlaceAndPounding) {
  Case c;
  c.buildings.resize(3);
  GenericBuilding frame, wall;
  frame.stiffness_ratio = 12;
  wall.stiffness_ratio = 1;
  c.buildings[0].structure = frame;
  c.buildings[1].structure = wall;
  c.buildings[2].structure = Stick{};
  Problem problem;
  for (const int storeys : {8, 5, 2}) {
    Building building = test::matrix_building(Eigen::MatrixXd::Identity(1, 1), Eigen::MatrixXd::Identity(1, 1),
                                              Eigen::MatrixXd::Identity(1, 1));
    building.model.storey_heights.assign(static_cast<std::size_t>(storeys), 3.0);
    problem.buildings.push_back(building);
  }
  EXPECT_EQ(gem_taxonomy(c, problem, 0, true), "LFM/HEX:8/BP1/IRIR+IRVP:POP");
  EXPECT_EQ(gem_taxonomy(c, problem, 1, false), "LWAL/HEX:5/BP2");
  EXPECT_EQ(gem_taxonomy(c, problem, 2, false), "HEX:2/BP1");
}

/// A house with others to its right, twice, above and below stands in a row on three sides.
TEST(Gem, InPlanCountsSidesNotNeighbours) {
  Case c;
  c.buildings.resize(5);
  PlanProblem problem;
  problem.buildings.resize(5);
  for (std::size_t b = 0; b < 5; ++b) {
    Plan plan;
    plan.planes.resize(1);
    if (b == 0) plan.planes[0].sway_stiffness = Eigen::MatrixXd::Identity(2, 2);
    c.buildings[b].structure = plan;
    problem.buildings[static_cast<Eigen::Index>(b)].model.storey_heights.assign(b + 2, 3.0);
  }
  const auto gap = [&](Eigen::Index left, Eigen::Index right, double x, double y) {
    PlanGap one;
    one.left = left, one.right = right;
    one.stretch.n = PlanPoint(x, y);
    one.stretch.across = std::abs(y) > std::abs(x) ? 1 : 0;
    problem.gaps.push_back(one);
  };
  gap(0, 1, 1, 0);
  gap(2, 0, -0.9, 0.4);  // it stands to the right too
  gap(0, 3, 0, 1);
  EXPECT_EQ(gem_taxonomy(c, problem, 0, true), "LFM/HEX:2/BP2/IRIR+IRVP:POP");
  EXPECT_EQ(gem_taxonomy(c, problem, 3, false), "HEX:5/BP1");
  EXPECT_EQ(gem_taxonomy(c, problem, 4, false), "HEX:6/BPD");
  gap(4, 0, 0, 1);
  EXPECT_EQ(gem_taxonomy(c, problem, 0, false), "LFM/HEX:2/BP3");
}

/// Where a building collapses no gap is known to do; an input in doubt says nothing of that.
TEST(Gem, GapsMayCloseWhereABuildingCollapses) {
  const auto judged = [](Reason::Kind kind) { return Judgement{.reasons = {{.kind = kind}}}; };
  for (const auto kind : {Reason::Kind::contact, Reason::Kind::need, Reason::Kind::collapse, Reason::Kind::drift}) {
    EXPECT_TRUE(may_close(judged(kind))) << word_of(kind);
  }
  for (const auto kind : {Reason::Kind::rule, Reason::Kind::doubt}) EXPECT_FALSE(may_close(judged(kind)));
  EXPECT_FALSE(may_close({}));
}

}  // namespace
}  // namespace bentur
