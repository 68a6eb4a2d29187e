// Which contacts are found: grazing, coinciding, at breakpoints, and against a dense check of random cases.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <unsupported/Eigen/MatrixFunctions>

#include "bentur/pounding/pounding.h"
#include "tests/support/small_buildings.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;
using namespace bentur::test;

TEST(Events, GrazingContactOfATrillionthOfTheGap) {
  // Undamped swing of amplitude w(1 + depth): with depth 1e-12 one contact a period, with −1e-12 none.
  const double omega = 20.0, w = 0.2;
  for (const double depth : {1e-12, 1e-9, 1e-6}) {
    Problem problem = pair(oscillator(1.0, omega * omega), wall(), {contact(w, 1.0)}, 10.25 * 2.0 * pi / omega);
    problem.initial_velocity[0](0) = w * omega * (1.0 + depth);
    const Response touching = solve(problem);
    EXPECT_EQ(touching.impacts.size(), 11u) << depth;
    for (const Impact& impact : touching.impacts) {
      // Ten swings are some 500 steps, each adding round-off of 1e-16 w.
      EXPECT_NEAR(impact.peak_penetration, w * depth, 5e-14 * w + 1e-3 * w * depth) << depth;
    }
    problem.initial_velocity[0](0) = w * omega * (1.0 - depth);
    EXPECT_TRUE(solve(problem).impacts.empty()) << depth;
  }
}

/// A law as a user may write one by mistake: its force is another whenever it is asked for.
class Noise final : public ContactLaw {
 public:
  [[nodiscard]] std::string_view name() const noexcept override { return "noise"; }
  [[nodiscard]] LawParameters parameters() const override { return {}; }
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override {
    if (state.branch == apart) return Branch::apart();
    return Branch{.bodies = Bodies::touching, .linear = false}.guarded_by({{.deformation = 1}});
  }
  [[nodiscard]] double force(const LawState& state, double, double) const noexcept override {
    return state.branch == apart ? 0 : 1e4 * std::uniform_real_distribution<>()(engine_);
  }
  [[nodiscard]] double stored_energy(const LawState&, double) const noexcept override { return 0; }

 private:
  mutable std::mt19937 engine_{1};
};

TEST(Events, AForceThatJumpsAboutEndsTheRun) {
  Problem problem = pair(oscillator(1.0, 400.0), wall(), {contact(0.01, 1.0)}, 1.0);
  problem.points[0].law = std::make_shared<Noise>();
  problem.initial_velocity[0](0) = 1.0;
  for (const Solver& solver : {Solver(ExactSolver{}), Solver(AdaptiveSolver{})}) {
    const Response response = solve(problem, solver);
    EXPECT_EQ(response.status, Status::failed);
    EXPECT_NE(response.message.find("no step is short enough to follow the contact force"), std::string::npos);
  }
}

TEST(Events, ContactAtARecordSample) {
  // A free mass under a_g = −2 is at t² relative to its base: at w = 0.01 when t = 0.1, the sixth sample of 0.02 s.
  Problem problem = pair(oscillator(1.0, 0.0), wall(), {contact(0.01, 1e4)}, 0.3);
  problem.motion = SampledMotion{0.02, std::vector<double>(100, -2.0)};
  problem.delays = {0.0, 1.0};
  const Response response = solve(problem);
  ASSERT_GE(response.impacts.size(), 1u);
  EXPECT_NEAR(response.impacts[0].start, 0.1, 1e-13);
  EXPECT_NEAR(response.impacts[0].closing_speed, 0.2, 1e-12);
}

TEST(Events, ContactThatBeginsAtOnceWithoutGap) {
  Problem problem = pair(oscillator(1.0, 400.0), oscillator(1.0, 400.0), {contact(0.0, 1e4)}, 0.1);
  problem.initial_velocity[0](0) = 1.0;
  const Response response = solve(problem);
  ASSERT_GE(response.impacts.size(), 1u);
  EXPECT_EQ(response.impacts[0].start, 0.0);
  EXPECT_NEAR(response.impacts[0].closing_speed, 1.0, 1e-14);
  EXPECT_NEAR(response.impacts[0].end, pi / std::sqrt(400.0 + 2e4), 1e-13);
}

TEST(Events, ContactFromRestWithoutGapIsDatedFromZero) {
  // Both at rest, touching; the left one is pushed by the ground: g = −t²/2 at first, so g' (0) = 0.
  Problem problem = pair(oscillator(1.0, 0.0), oscillator(1.0, 400.0), {contact(0.0, 1e4)}, 0.05);
  problem.motion = SampledMotion{0.02, std::vector<double>(20, -1.0)};
  problem.delays = {0.0, 1.0};
  const Response response = solve(problem);
  ASSERT_EQ(response.points[0].impacts, 1);
  EXPECT_EQ(response.impacts[0].start, 0.0);
  EXPECT_NEAR(response.impacts[0].closing_speed, 0.0, 1e-12);
}

TEST(Events, SeveralContactsFromRestAreAllDatedFromZero) {
  // Two floors that do not know of each other, of very different displacements, so that they leave the round-off band
  // one after the other; both openings are negative from t = 0 on.
  MatrixXd stiffness = MatrixXd::Zero(2, 2);
  stiffness.diagonal() << 4.0, 400.0;
  const MatrixXd none = MatrixXd::Zero(2, 2);
  Problem problem = pair(matrix_building(MatrixXd::Identity(2, 2), stiffness, none),
                         matrix_building(MatrixXd::Identity(2, 2), 400.0 * MatrixXd::Identity(2, 2), none),
                         {contact(0.0, 1e4, 0), contact(0.0, 1e4, 1)}, 1.0);
  problem.motion = SampledMotion{0.02, std::vector<double>(50, -1.0)};
  problem.delays = {0.0, 2.0};
  const Response response = solve(problem);
  ASSERT_GE(response.impacts.size(), 2u);
  EXPECT_EQ(response.impacts[0].start, 0.0);
  EXPECT_EQ(response.impacts[1].start, 0.0);
  EXPECT_NE(response.impacts[0].point, response.impacts[1].point);
}

TEST(Events, OverlappingStartIsAContactAtOnce) {
  Problem problem = pair(oscillator(1.0, 400.0), oscillator(1.0, 400.0), {contact(0.01, 1e4)}, 0.1);
  problem.initial_displacement[0](0) = 0.02;
  const Response response = solve(problem);
  ASSERT_GE(response.impacts.size(), 1u);
  EXPECT_EQ(response.impacts[0].start, 0.0);
  EXPECT_NEAR(response.impacts[0].peak_penetration, 0.01, 1e-12);
}

TEST(Events, SeveralFloorsAtOneInstant) {
  // Three floors that do not know of each other, all alike: three impacts with the same times.
  const MatrixXd mass = MatrixXd::Identity(3, 3);
  const MatrixXd stiffness = 400.0 * MatrixXd::Identity(3, 3);
  const MatrixXd none = MatrixXd::Zero(3, 3);
  Problem problem = pair(matrix_building(mass, stiffness, none), matrix_building(mass, stiffness, none),
                         {contact(0.01, 1e4, 0), contact(0.01, 1e4, 1), contact(0.01, 1e4, 2)}, 0.2);
  problem.initial_velocity[0].setOnes();
  const Response response = solve(problem);
  ASSERT_EQ(response.impacts.size() % 3, 0u);
  ASSERT_GE(response.impacts.size(), 3u);
  for (std::size_t i = 0; i < response.impacts.size(); i += 3) {
    EXPECT_NEAR(response.impacts[i].start, response.impacts[i + 1].start, 1e-14);
    EXPECT_NEAR(response.impacts[i].start, response.impacts[i + 2].start, 1e-14);
    EXPECT_NEAR(response.impacts[i].peak_force, response.impacts[i + 2].peak_force, 1e-9);
  }
}

SampledMotion noise(std::mt19937_64& random, std::size_t samples, double step, double scale) {
  std::normal_distribution<double> normal(0.0, scale);
  SampledMotion motion{step, {}};
  for (std::size_t i = 0; i < samples; ++i) motion.acceleration.push_back(normal(random));
  return motion;
}

Building random_stick(std::mt19937_64& random, int floors) {
  std::uniform_real_distribution<double> spread(0.5, 2.0);
  MatrixXd mass = MatrixXd::Zero(floors, floors);
  MatrixXd stiffness = MatrixXd::Zero(floors, floors);
  for (int f = 0; f < floors; ++f) {
    mass(f, f) = spread(random);
    const double k = 900.0 * spread(random);
    stiffness(f, f) += k;
    if (f > 0) {
      stiffness(f - 1, f - 1) += k;
      stiffness(f - 1, f) -= k;
      stiffness(f, f - 1) -= k;
    }
  }
  // Now and then a damping matrix that the modes do not diagonalise.
  MatrixXd damping = 0.003 * stiffness;
  if (spread(random) < 0.9) damping(0, 0) += spread(random);
  if (spread(random) < 0.7) damping.setZero();
  Building building = matrix_building(mass, stiffness, damping);
  return building;
}

/// Two or three random sticks, random record, delays and gaps from none to more than is needed.
Problem random_problem(std::mt19937_64& random) {
  std::uniform_int_distribution<int> some(1, 3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Problem problem;
  const int buildings = unit(random) < 0.2 ? 3 : 2;
  for (int b = 0; b < buildings; ++b) {
    problem.buildings.push_back(random_stick(random, some(random)));
    problem.delays.push_back(unit(random) < 0.5 ? 0.02 * some(random) : 0.05 * unit(random));
  }
  for (int b = 0; b + 1 < buildings; ++b) {
    const auto left = static_cast<std::size_t>(b);
    const auto floors = std::min(problem.buildings[left].model.floors(), problem.buildings[left + 1].model.floors());
    const double width = unit(random) < 0.2 ? 0.0 : 0.08 * unit(random);
    for (int f = 0; f < floors; ++f)
      problem.points.push_back(contact(width, std::pow(10.0, 3.0 + 3.0 * unit(random)), f, b));
  }
  problem.motion = noise(random, 40, 0.02, 20.0);
  problem.duration = 1.0;
  return problem;
}

/// Whether a point is in contact at t by the list of impacts; times within `slack` of a change say nothing.
enum class Said { open, closed, changing };
Said said(const std::vector<Impact>& impacts, std::size_t point, double t, double slack) {
  for (const Impact& impact : impacts) {
    if (static_cast<std::size_t>(impact.point) != point || t < impact.start - slack || t > impact.end + slack) continue;
    return t > impact.start + slack && (t < impact.end - slack || impact.open_ended) ? Said::closed : Said::changing;
  }
  return Said::open;
}

TEST(Events, TenThousandRandomCasesAgreeWithADenseCheck) {
  std::mt19937_64 random(20261);
#ifdef BENTUR_SANITIZED
  constexpr int cases = 500;  // the sanitizers look for other faults, ten times more slowly
#else
  constexpr int cases = 10000;
#endif
  // GuardMonitor are differences of displacements of order 0.1 computed to about 1e-15 each.
  constexpr double depth = 1e-13;
  long impacts = 0;
  for (int n = 0; n < cases; ++n) {
    const Problem problem = random_problem(random);
    SolveOptions options;
    options.output_step = 0.0017;
    const Response response = solve(problem, ExactSolver{}, options);
    ASSERT_EQ(response.status, Status::done) << response.message;
    impacts += static_cast<long>(response.impacts.size());
    for (std::size_t i = 0; i < problem.points.size(); ++i) {
      for (std::size_t s = 0; s < response.histories.time.size(); ++s) {
        const double opening = response.histories.opening(static_cast<Index>(i), static_cast<Index>(s));
        const Said contact = said(response.impacts, i, response.histories.time[s], 1e-12);
        if (contact == Said::open) {
          ASSERT_GE(opening, -depth) << "missed: case " << n;
        } else if (contact == Said::closed) {
          ASSERT_LE(opening, depth) << "invented: case " << n;
        }
      }
    }
  }
  EXPECT_GT(impacts, 5 * cases);  // the cases are not all trivial
}

/// Physical coordinates of all buildings with the ground's piecewise-linear input, advanced by matrix exponentials:
/// an integration that shares nothing with the solver but the times it is asked to check.
class ByMatrixExponential {
 public:
  explicit ByMatrixExponential(const Problem& problem)
      : problem_(problem), motion_(std::get<SampledMotion>(problem.motion)) {
    for (const Building& building : problem.buildings) {
      begin_.push_back(size_);
      size_ += building.model.dofs();
    }
    state_ = VectorXd::Zero(2 * size_);
  }

  /// From t to t + h with the contact set fixed and every a_g linear in between.
  void advance(double t, double h, const std::vector<bool>& closed) {
    const Index n = size_;
    MatrixXd a = MatrixXd::Zero(2 * n + 2, 2 * n + 2);  // state, then a constant and time within the step
    a.topRightCorner(2 * n, 2 * n + 2).block(0, n, n, n).setIdentity();
    for (std::size_t b = 0; b < problem_.buildings.size(); ++b) {
      const auto& building = problem_.buildings[b];
      const Index at = begin_[b], dofs = building.model.dofs();
      const MatrixXd inverse = building.model.mass.inverse();
      const MatrixXd root = building.model.mass * building.modes.shapes;
      a.block(n + at, at, dofs, dofs) = -inverse * building.model.stiffness;
      a.block(n + at, n + at, dofs, dofs) = -inverse * (root * building.modal_damping * root.transpose());
      const double first = acceleration_at(motion_, t + 1e-9 * h - problem_.delays[b]);
      const double last = acceleration_at(motion_, t + (1 - 1e-9) * h - problem_.delays[b]);
      a.block(n + at, 2 * n, dofs, 1) = -inverse * building.model.load * first;
      a.block(n + at, 2 * n + 1, dofs, 1) = -inverse * building.model.load * ((last - first) / h);
    }
    a(2 * n + 1, 2 * n) = 1.0;
    for (std::size_t i = 0; i < problem_.points.size(); ++i) {
      if (!closed[i]) continue;
      const auto [left, right] = floors(i);
      const double k = problem_.points[i].law->branch({.branch = 1}).stiffness;
      for (const auto& [floor, sign] : {std::pair(left, -1.0), std::pair(right, 1.0)}) {
        const double over_mass = -k * sign / mass_of(floor);
        a(n + floor, right) += over_mass;
        a(n + floor, left) -= over_mass;
        a(n + floor, 2 * n) += over_mass * problem_.points[i].width;
      }
    }
    VectorXd z(2 * n + 2);
    z << state_, 1.0, 0.0;
    state_ = ((a * h).exp() * z).head(2 * n);
  }

  [[nodiscard]] double opening(std::size_t i) const {
    const auto [left, right] = floors(i);
    return problem_.points[i].width + state_(right) - state_(left);
  }

 private:
  [[nodiscard]] std::pair<Index, Index> floors(std::size_t i) const {
    const ContactPoint& point = problem_.points[i];
    const auto left = static_cast<std::size_t>(point.left);
    return {begin_[left] + point.left_floor, begin_[left + 1] + point.right_floor};
  }
  [[nodiscard]] double mass_of(Index dof) const {
    for (std::size_t b = problem_.buildings.size(); b-- > 0;) {
      if (dof >= begin_[b]) return problem_.buildings[b].model.mass(dof - begin_[b], dof - begin_[b]);
    }
    return 0.0;
  }

  const Problem& problem_;
  const SampledMotion& motion_;
  std::vector<Index> begin_;
  Index size_ = 0;
  VectorXd state_;
};

TEST(Events, RandomCasesReplayedByMatrixExponentials) {
  std::mt19937_64 random(77);
  int checked = 0;
  for (int n = 0; n < 100; ++n) {
    const Problem problem = random_problem(random);
    const Response response = solve(problem);
    std::vector<double> times{0.0, problem.duration};
    for (const Impact& impact : response.impacts) times.insert(times.end(), {impact.start, impact.end});
    for (int k = 0; k <= 40; ++k) {
      for (const double delay : problem.delays) times.push_back(0.02 * k + delay);
    }
    std::sort(times.begin(), times.end());
    ByMatrixExponential replay(problem);
    for (std::size_t j = 0; j + 1 < times.size() && times[j + 1] <= problem.duration; ++j) {
      const double h = (times[j + 1] - times[j]) / 2.0;
      if (h < 1e-12) continue;
      std::vector<bool> closed;
      for (std::size_t i = 0; i < problem.points.size(); ++i) {
        closed.push_back(said(response.impacts, i, times[j] + h, 0.0) == Said::closed);
      }
      for (int half = 0; half < 2; ++half) {
        replay.advance(times[j] + half * h, h, closed);
        for (std::size_t i = 0; i < problem.points.size(); ++i) {
          // Displacements are of order 0.1; contact at speeds of order 1 turns 1e-13 s of an event into 1e-13.
          if (closed[i]) {
            ASSERT_LE(replay.opening(i), 1e-10) << n;
          } else {
            ASSERT_GE(replay.opening(i), -1e-10) << n;
          }
          ++checked;
        }
      }
    }
  }
  EXPECT_GT(checked, 10000);
}

TEST(Events, TwoTouchingIdenticalBuildingsNeverCollide) {
  std::mt19937_64 random(5);
  for (int n = 0; n < 20; ++n) {
    const Building building = random_stick(random, 3);
    Problem problem = pair(building, building, {contact(0.0, 1e5, 0), contact(0.0, 1e5, 1), contact(0.0, 1e5, 2)}, 3.0);
    problem.motion = noise(random, 120, 0.02, 10.0);
    const Response response = solve(problem);
    EXPECT_TRUE(response.impacts.empty()) << n;
    EXPECT_GT(response.buildings[0].displacement(2), 0.0);
    problem.delays = {0.0, 0.1};  // with a delay they do
    EXPECT_FALSE(solve(problem).impacts.empty()) << n;
  }
}

}  // namespace
}  // namespace bentur
