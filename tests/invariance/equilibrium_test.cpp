// At every sample of a run inertia, damping, storey shears, shears of struck columns, contact and link forces are in
// equilibrium at every floor and every struck node. The response is computed in modal coordinates and its forces by
// rows of their own, so that what is scaled, condensed or put on something in one and not in the other shows here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bentur/excitation/ground_motion.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/pounding/pounding.h"
#include "tests/invariance/random_case.h"
#include "tests/reference/shared_folder.h"
#include "tests/support/column_case.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A building of which every degree of freedom is told as a floor's: nodes with the shears of their columns' pieces, as
/// the results tell them, others (rotations, a foundation) with their rows of K.
Building told_whole(Building building) {
  StructuralModel& model = building.model;
  const Index n = model.dofs(), floors = model.floors(), nodes = model.nodes();
  MatrixXd drifts = MatrixXd::Zero(n, n), shears = model.stiffness;
  drifts.topRows(floors) = drift_rows(model);
  shears.topRows(floors) = shear_rows(model);
  for (Index node = 0; node < nodes; ++node) {
    shears.row(floors + node) = model.column_forces.row(6 * node) + model.column_forces.row(6 * node + 1);
  }
  model.drifts = drifts;
  model.shears = shears;
  for (Index dof = floors; dof < n; ++dof) {
    model.elevations.push_back(model.elevations.back() + 1);
    model.storey_heights.push_back(1);
    model.floor_masses.push_back(dof < floors + nodes ? model.node_masses[dof - floors] : 1);
  }
  model.node_elevations.clear();
  model.node_masses.clear();
  model.column_forces.resize(0, 0);
  model.foundation.reset();
  return building;
}

/// F of a link; nothing where it depends on what was before.
std::optional<double> link_force(const Law& law, double deformation, double speed) {
  double stiffness = 0, damping = 0, slack = 0;
  for (const auto& [key, value] : law.parameters()) {
    if (key == "stiffness") stiffness = value;
    if (key == "damping") damping = value;
    if (key == "slack") slack = value;
  }
  if (law.name() == "spring-dashpot") return stiffness * deformation + damping * speed;
  if (law.name() == "cable") return -stiffness * std::max(0.0, -deformation - slack);
  return std::nullopt;
}

/// Forces of contacts and links on each building, dofs × samples; nothing where a link yields.
std::optional<std::vector<MatrixXd>> outer_forces(const Problem& whole, const Histories& h) {
  const Index samples = std::ssize(h.time);
  std::vector<MatrixXd> forces;
  for (const Building& building : whole.buildings) forces.push_back(MatrixXd::Zero(building.model.dofs(), samples));
  for (std::size_t i = 0; i < whole.points.size(); ++i) {
    const ContactPoint& point = whole.points[i];
    forces[point.left].row(point.left_floor) -= h.force.row(static_cast<Index>(i));
    forces[point.left + 1].row(point.right_floor) += h.force.row(static_cast<Index>(i));
  }
  for (const Link& link : whole.links) {
    for (Index s = 0; s < samples; ++s) {
      const auto along = [&](const std::vector<MatrixXd>& of) {
        return of[link.left](link.left_floor, s) - of[link.right](link.right_floor, s);
      };
      const auto force = link_force(*link.law, along(h.displacement), along(h.velocity));
      if (!force) return std::nullopt;
      forces[link.left](link.left_floor, s) -= *force;
      forces[link.right](link.right_floor, s) += *force;
    }
  }
  return forces;
}

/// What pushes each degree of freedom back, dofs × samples, of the shears that the run told.
MatrixXd restoring(const Building& building, const Building& whole, const MatrixXd& x, const MatrixXd& told) {
  const StructuralModel& model = building.model;
  const Index floors = model.floors(), nodes = model.nodes();
  MatrixXd forces = told;
  for (Index f = 0; f + 1 < floors; ++f) forces.row(f) -= told.row(f + 1);
  // A storey's shear is that of all columns at its foot: nodes within it stand between both floors.
  for (Index node = 0; node < nodes; ++node) {
    forces.row(model.floor_at_or_above(floors + node)) -= told.row(floors + node);
  }
  if (building.has_gravity_loads) {  // shears are of the columns, and the loads act on floors too
    const MatrixXd elastic = whole.model.shears * x;
    for (Index f = 0; f < floors; ++f) {
      forces.row(f) += model.stiffness.row(f) * x - elastic.row(f);
      if (f + 1 < floors) forces.row(f) += elastic.row(f + 1);
    }
    for (Index node = 0; node < nodes; ++node) {
      forces.row(model.floor_at_or_above(floors + node)) += elastic.row(floors + node);
    }
  }
  for (Index dof = floors + nodes; dof < model.dofs(); ++dof) {  // what yields pushes a foundation too
    for (Index storey = 0; storey < floors; ++storey) {
      if (building.storey_law(storey) == nullptr) continue;
      forces.row(dof) += whole.model.drifts(storey, dof) * (told.row(storey) - whole.model.shears.row(storey) * x);
    }
  }
  return forces;
}

struct Balance {
  double residual = 0, largest = 0;  ///< [force]
  int buildings = 0;
};

/// The largest sum of all forces at a degree of freedom, of buildings whose dashpots do not change.
Balance balance(const Problem& problem) {
  Balance found;
  Problem whole = problem;
  for (Building& building : whole.buildings) building = told_whole(building);
  SolveOptions options;
  options.output_step = problem.duration / 128;
  const Response response = solve(whole, ExactSolver{}, options);
  EXPECT_EQ(response.status, Status::done) << response.message;
  const Histories& h = response.histories;
  const auto outer = outer_forces(whole, h);
  if (!outer) return found;
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Building& building = problem.buildings[b];
    const StructuralModel& model = building.model;
    if (building.is_rigid() || (building.tangent_damping != 0 && building.can_yield())) continue;
    // Hinges and breaks push nodes of struck columns too, whose shears told_whole() takes from K alone.
    if (model.nodes() > 0 && model.hinges.clockwise.size() > 0) continue;
    ++found.buildings;
    const MatrixXd to = model.mass * building.modes.shapes;
    const MatrixXd ground = [&] {
      MatrixXd values(1, std::ssize(h.time));
      for (Index s = 0; s < values.cols(); ++s)
        values(0, s) = acceleration_at(problem.motion, h.time[s] - delay_of(problem, b));
      return values;
    }();
    const MatrixXd inertia =
        model.mass * (h.acceleration[b] - VectorXd::Ones(model.dofs()) * ground) + model.load * ground;
    const MatrixXd damping = to * (building.modal_damping * (to.transpose() * h.velocity[b]));
    const MatrixXd elastic = restoring(building, whole.buildings[b], h.displacement[b], h.storey_shear[b]);
    MatrixXd sum = inertia + damping + elastic - (*outer)[b];
    if (building.modes.omega.size() < model.dofs()) sum = to * (building.modes.shapes.transpose() * sum);
    for (Index s = 0; s < sum.cols(); ++s) {
      // The motion may jump as it arrives: either side is right.
      if (std::abs(h.time[s] - delay_of(problem, b)) <= 1e-9 * problem.duration) continue;
      found.residual = std::max(found.residual, sum.col(s).cwiseAbs().maxCoeff());
      for (const MatrixXd* one : {&inertia, &damping, &elastic, &(*outer)[b]}) {
        found.largest = std::max(found.largest, one->col(s).cwiseAbs().maxCoeff());
      }
    }
  }
  return found;
}

int in_equilibrium(const Problem& problem, const std::string& name) {
  const Balance found = balance(problem);
  EXPECT_LE(found.residual, 1e-9 * found.largest) << name;
  return found.buildings;
}

int of_folder(const fs::path& folder) {
  int buildings = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    Diagnostics diagnostics;
    const auto c = read_case(entry.path(), diagnostics);
    if (!c || c->is_in_plan() || c->excitation.spectrum || c->excitation.suite)
      continue;  // a study, no motion, or many
    const Problem problem = make_problem(*c);
    if (solve(problem).status != Status::done) continue;  // collapses
    buildings += in_equilibrium(problem, entry.path().string());
  }
  return buildings;
}

TEST(Equilibrium, OfEveryExample) { EXPECT_GT(of_folder(fs::path(BENTUR_SOURCE_DIR) / "examples"), 30); }

TEST(Equilibrium, OfEveryReferenceCase) {
  const fs::path folder = test::shared_folder() / "reference";
  if (!fs::exists(folder)) GTEST_SKIP() << "the reference cases (../shared) are not here";
  EXPECT_GT(of_folder(folder), 50);
}

TEST(Equilibrium, OfStruckColumnsOfFramesWithAPeriod) {
  Diagnostics diagnostics;
  Case c = read_case_text(test::struck_columns, "case.toml", diagnostics).value();
  for (const double period : {0.3, 1.2}) {
    for (BuildingSpec& building : c.buildings) building.calibrate_period = period;
    EXPECT_EQ(in_equilibrium(make_problem(c), fmt::format("period {}", period)), 2);
  }
}

TEST(Equilibrium, OfRandomCases) {
  int buildings = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const Problem problem = make_problem(test::CaseGenerator(seed).make().c);
    if (solve(problem).status == Status::done) buildings += in_equilibrium(problem, fmt::format("seed {}", seed));
  }
  EXPECT_GT(buildings, 300);
}

}  // namespace
}  // namespace bentur
