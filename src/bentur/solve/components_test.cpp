// A ground that moves in several components: every body feels each by a column of its load.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "bentur/contact/laws/kelvin_voigt_approach.h"
#include "bentur/core/errors.h"
#include "bentur/elements/link_laws.h"
#include "bentur/solve/engine/motion/time_grid.h"
#include "bentur/solve/solver.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

SampledMotion noise(unsigned seed, double step, int count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-4, 4);
  SampledMotion motion{step, {0.0}};
  for (int n = 1; n < count; ++n) motion.acceleration.push_back(any(random));
  return motion;
}

/// Displacements and absolute accelerations of all degrees of freedom are its outputs.
Body body_of(const MatrixXd& mass, const MatrixXd& stiffness, double damping, const MatrixXd& load,
             const MatrixXd& ground) {
  const Index n = mass.rows();
  Body body;
  body.mass = mass;
  body.stiffness = stiffness;
  body.modes = modes(mass, stiffness);
  body.modal_damping = (2 * damping * body.modes.omega).asDiagonal();
  body.load = load;
  const MatrixXd unit = MatrixXd::Identity(n, n);
  body.outputs = {{.kind = OutputKind::displacement, .count = n, .rows = unit, .has_peak = true},
                  {.kind = OutputKind::acceleration, .count = n, .absolute = unit, .ground = ground, .has_peak = true}};
  return body;
}

Solution response_of(const System& system, const Solver& solver = ExactSolver{}) {
  const FreeSolution free(system, solver);
  EXPECT_EQ(free.solution().status, Status::done) << free.solution().message;
  Solution solution = free.solve(system.contacts, {.output_step = 0.05, .energy_audit = true});
  EXPECT_EQ(solution.status, Status::done) << solution.message;
  return solution;
}

constexpr double lighter = 20, along_stiffness = 9e3, across_stiffness = 5e3, duration = 8;

/// Two masses that strike and are linked along a line, the second one reached later; absolute kinematics.
System on_a_line(const GroundMotion& motion) {
  System system;
  for (const double by : {1.0, 1.7}) {
    const MatrixXd one = MatrixXd::Ones(1, 1);
    system.bodies.push_back(body_of(by * lighter * one, along_stiffness * one, 0.03, by * lighter * one, {}));
  }
  const VectorXd one = VectorXd::Ones(1);
  const Interface both{{0, one, one, 0}, {1, -one, -one, 0}};
  system.contacts = {{both, std::make_shared<KelvinVoigtApproach>(2e5, 0.1, lighter), 0.004}};
  system.joints = {{both, std::make_shared<SpringDashpot>(0, 30)}};
  system.motions = {motion};
  system.delays = {0, 0.013};
  system.duration = duration;
  return system;
}

/// The same in a plane, the line turned by an angle, with a second motion across it.
System turned(double angle, const GroundMotion& along, const GroundMotion& across) {
  System system = on_a_line(along);
  system.motions.push_back(across);
  Matrix2d axes;  // columns: along and across
  axes << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const Matrix2d stiffness = axes * Vector2d(along_stiffness, across_stiffness).asDiagonal() * axes.transpose();
  for (Body& body : system.bodies) {
    const double m = body.mass(0, 0);
    body = body_of(m * Matrix2d::Identity(), stiffness, 0.03, m * axes, axes);
  }
  const auto turn = [&axes](Interface& at) {
    for (BodyRow* side : {&at.left, &at.right}) {
      const double sign = side->row(0);
      *side = {side->body, sign * axes.col(0), sign * Vector2d(1, 0), -1};
    }
  };
  turn(system.contacts[0].at);
  turn(system.joints[0].at);
  return system;
}

void expect_near(const MatrixXd& actual, const MatrixXd& expected, double tolerance) {
  ASSERT_EQ(actual.cols(), expected.cols());
  EXPECT_LE((actual - expected).cwiseAbs().maxCoeff(), tolerance * expected.cwiseAbs().maxCoeff());
}

TEST(Components, BodyTurnedByAnAngleIsTheBodyOnALine) {
  const SampledMotion along = noise(3, 0.02, 300), across = noise(4, 0.03, 150);
  struct One {
    Solver solver;
    double tolerance;  // of runge-kutta too, whose steps are the same: impacts make round-off grow
  };
  for (const One& one :
       {One{ExactSolver{}, 1e-9}, One{AdaptiveSolver{1e-12}, 1e-8}, One{RungeKuttaSolver{1e-3}, 1e-6}}) {
    const Solution line = response_of(on_a_line(along), one.solver);
    ASSERT_GT(line.impacts.size(), 10U);
    for (const double angle : {0.0, std::numbers::pi / 2, 0.4}) {
      const Solution plane = response_of(turned(angle, along, across), one.solver);
      if (std::holds_alternative<ExactSolver>(one.solver)) {
        EXPECT_LT(plane.energy->relative_residual(), 1e-12) << angle;
      }
      ASSERT_EQ(plane.impacts.size(), line.impacts.size()) << name(one.solver) << " " << angle;
      for (std::size_t n = 0; n < line.impacts.size(); ++n) {
        EXPECT_NEAR(plane.impacts[n].impulse / line.impacts[n].impulse, 1, 1e3 * one.tolerance);
      }
      const Vector2d direction(std::cos(angle), std::sin(angle));
      for (std::size_t b = 0; b < 2; ++b) {
        for (std::size_t k = 0; k < 2; ++k) {
          expect_near(direction.transpose() * plane.outputs[b][k].history, line.outputs[b][k].history,
                      1e2 * one.tolerance);
        }
      }
      if (angle != 0.0) continue;
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(plane.outputs[0][k].peak(0) / line.outputs[0][k].peak(0), 1, 1e2 * one.tolerance);
      }
    }
  }
}

/// Three degrees of freedom that all motions shake.
System coupled(const std::vector<GroundMotion>& motions) {
  MatrixXd stiffness(3, 3);
  stiffness << 900, -300, 150, -300, 2000, 400, 150, 400, 4e5;
  MatrixXd load(3, 3), ground(3, 3);
  load << 1, 0.3, -0.7, -0.2, 2, 0.5, 0.6, 0.1, 1.5;
  ground << 1, 0, 0.5, 0, 1, 0.2, -0.4, 0.7, 0;
  System system;
  system.bodies = {body_of(Eigen::Vector3d(1, 2, 3).asDiagonal(), stiffness, 0.02, load.leftCols(std::ssize(motions)),
                           ground.leftCols(std::ssize(motions)))};
  system.motions = motions;
  system.duration = 6;
  return system;
}

TEST(Components, ResponsesAddUp) {
  const std::vector<GroundMotion> all = {
      noise(5, 0.02, 250), HarmonicMotion{.period = 0.31, .displacement_amplitude = 0.02}, noise(6, 0.05, 80)};
  const Solution together = response_of(coupled(all));
  for (std::size_t k = 0; k < 2; ++k) {
    MatrixXd sum = MatrixXd::Zero(3, together.outputs[0][k].history.cols());
    for (std::size_t c = 0; c < all.size(); ++c) {
      std::vector<GroundMotion> alone(all.size(), NoMotion{});
      alone[c] = all[c];
      sum += response_of(coupled(alone)).outputs[0][k].history;
    }
    expect_near(together.outputs[0][k].history, sum, 1e-11);
    const Solution adaptive = response_of(coupled(all), AdaptiveSolver{1e-12});
    expect_near(adaptive.outputs[0][k].history, together.outputs[0][k].history, 1e-8);
    // Peaks of the continuous response: samples come near them, and the other solver finds the same.
    const VectorXd sampled = together.outputs[0][k].history.cwiseAbs().rowwise().maxCoeff();
    for (Index i = 0; i < 3; ++i) {
      EXPECT_GE(together.outputs[0][k].peak(i), sampled(i));
      EXPECT_NEAR(adaptive.outputs[0][k].peak(i) / together.outputs[0][k].peak(i), 1, 1e-8);
    }
  }
  EXPECT_LT(together.energy->relative_residual(), 1e-12);
  for (Index n = 0; n < std::ssize(together.samples.time); ++n) {
    for (Index c = 0; c < 3; ++c) {
      ASSERT_EQ(together.samples.ground_acceleration(c, n), acceleration_at(all[c], together.samples.time[n]));
    }
  }
}

TEST(Components, RecordsWithDifferentSteps) {
  System system = coupled({noise(7, 0.02, 200), noise(8, 0.03, 100), noise(9, 0.004, 900)});
  system.bodies.push_back(system.bodies[0]);
  system.delays = {0, 0.0137};
  const engine::TimeGrid grid(system);
  EXPECT_EQ(grid.kinds(), 32U);  // of 0.06 s: every 0.004 s and at 0.03 s; the same 0.0137 s later
  std::vector<engine::GroundInput> inputs;
  for (long m = 0; grid.start(m) < 6; ++m) {
    grid.input(m, inputs);
    const double length = grid.length(static_cast<std::size_t>(m) % grid.kinds());
    ASSERT_GT(length, 0.0);
    for (std::size_t n = 0; n < inputs.size(); ++n) {
      for (const double part : {0.1, 0.9}) {
        const double t = grid.start(m) + part * length - system.delays[n / 3];
        ASSERT_NEAR(inputs[n].value + part * length * inputs[n].slope, acceleration_at(system.motions[n % 3], t), 1e-9);
      }
    }
  }
  system.motions[1] = noise(8, 0.0300001, 100);
  EXPECT_THROW(engine::TimeGrid{system}, InvalidParameter);
}

TEST(Components, OneLoadForEach) {
  System system = coupled({noise(7, 0.02, 200), NoMotion{}});
  system.motions.pop_back();
  EXPECT_THROW(FreeSolution(system, ExactSolver{}), InvalidParameter);
  system.motions.clear();
  EXPECT_THROW(FreeSolution(system, ExactSolver{}), InvalidParameter);
}

}  // namespace
}  // namespace bentur
