#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <ostream>
#include <utility>
#include <variant>
#include <vector>

#include "bentur/elements/kinematic_hardening.h"
#include "bentur/pounding/pounding.h"
#include "tests/support/small_buildings.h"

namespace bentur::test {

/// A storey of a stick and the floor above it; no law: it stays elastic.
struct StickStorey {
  double mass = 0;       ///< [mass]
  double stiffness = 0;  ///< [force/length]
  double dashpot = 0;    ///< [force·s/length]
  std::shared_ptr<const HystereticLaw> law = nullptr;
};

/// The matrix of springs in a row, the first to the ground.
inline Eigen::MatrixXd chain(const std::vector<double>& springs) {
  const auto n = static_cast<Eigen::Index>(springs.size());
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const double spring = springs[static_cast<std::size_t>(j)];
    k(j, j) += spring;
    if (j == 0) continue;
    k(j - 1, j - 1) += spring;
    k(j - 1, j) -= spring;
    k(j, j - 1) -= spring;
  }
  return k;
}

/// A stick of storeys 1 [length] high that may yield.
inline Building yielding_stick(const std::vector<StickStorey>& storeys) {
  Eigen::VectorXd mass(static_cast<Eigen::Index>(storeys.size()));
  std::vector<double> springs, dashpots;
  std::vector<std::shared_ptr<const HystereticLaw>> laws;
  for (const StickStorey& storey : storeys) {
    mass(static_cast<Eigen::Index>(laws.size())) = storey.mass;
    springs.push_back(storey.stiffness);
    dashpots.push_back(storey.dashpot);
    laws.push_back(storey.law);
  }
  Building building = matrix_building(mass.asDiagonal(), chain(springs), chain(dashpots));
  building.elements = storey_elements(building.model, laws);
  return building;
}

inline std::shared_ptr<const HystereticLaw> bilinear_law(double stiffness, double yield_force, double hardening = 0) {
  return std::make_shared<KinematicHardening>(stiffness, yield_force, hardening);
}

/// One mass on a bilinear spring with damping ratio ζ of k and m.
inline Building yielding_oscillator(double m, double k, double yield_force, double hardening = 0, double zeta = 0) {
  return yielding_stick({{m, k, 2 * zeta * std::sqrt(k * m), bilinear_law(k, yield_force, hardening)}});
}

/// The building with a neighbour that stays at rest where the building does not come.
inline Problem alone(Building building, double duration) {
  Problem problem = pair(std::move(building), oscillator(1, 1), {contact(1e3, 1)}, duration);
  problem.delays = {0, 1e3};
  return problem;
}

/// A solver and how well it is expected to meet what is known.
struct SolverWay {
  const char* label;
  Solver solver;
  double accuracy;  ///< relative [-]
};

inline void PrintTo(const SolverWay& way, std::ostream* out) { *out << way.label; }

/// exact by round-off; adaptive by errors of 1e-13 a step that add up.
inline std::vector<SolverWay> exact_and_adaptive() {
  return {{"exact", ExactSolver{}, 1e-12}, {"adaptive", AdaptiveSolver{1e-13}, 1e-11}};
}

/// Ends well, with all energy accounted for.
inline Response solved(const Problem& problem, const Solver& solver, double output_step = 0) {
  SolveOptions options;
  options.output_step = output_step;
  options.energy_audit = true;
  Response response = solve(problem, solver, options);
  EXPECT_EQ(response.status, Status::done) << response.message;
  if (response.energy) {
    // The integrals of a step that is an approximation are as good as the step, as in the reference cases.
    EXPECT_LE(response.energy->relative_residual(), std::holds_alternative<ExactSolver>(solver) ? 1e-9 : 1e-8);
  }
  return response;
}

}  // namespace bentur::test
