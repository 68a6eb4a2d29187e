// Columns of sticks that are struck: closed forms of beams, and a frame whose beams are as good as rigid.
#include "bentur/structure/frame/storey_columns.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "bentur/core/errors.h"
#include "bentur/structure/frame/plane_frame.h"
#include "bentur/structure/known/generic.h"
#include "bentur/structure/modes.h"
#include "bentur/structure/stick.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double modulus = 2e7, inertia = 0.004;

StructuralModel stick() {
  return stick_model({.storey_heights = {4, 3}, .masses = {60, 50}, .stiffnesses = {9e5, 8e5}});
}

StoreyColumns columns(std::vector<ColumnNode> nodes, int number = 1) {
  return {modulus, {inertia}, {2.0}, number, std::move(nodes)};
}

/// K of the floors with nodes free to follow.
MatrixXd without_nodes(const StructuralModel& model) {
  const Index n = model.floors(), nodes = model.nodes();
  const MatrixXd& k = model.stiffness;
  return k.topLeftCorner(n, n) -
         k.topRightCorner(n, nodes) *
             k.bottomRightCorner(nodes, nodes).llt().solve(MatrixXd(k.bottomLeftCorner(nodes, n)));
}

TEST(StoreyColumns, ChangeNothingWhereNothingIsStruck) {
  const StructuralModel bare = stick();
  StructuralModel model = stick();
  add_columns(model, columns({}));
  EXPECT_EQ(model.stiffness, bare.stiffness);
  EXPECT_EQ(model.mass, bare.mass);
  model = stick();
  add_columns(model, columns({{true, 1.0}, {false, 2.5}, {true, 2.2}, {false, 5.1}}, 3));
  ASSERT_EQ(model.nodes(), 4);
  EXPECT_LE((without_nodes(model) - bare.stiffness).norm(), 1e-12 * bare.stiffness.norm());
  // Of the ground storey's columns the base loses what stands nearer to the lowest node: 3 · 2/4/2 times 3 and 1.5 m.
  EXPECT_NEAR(model.load.sum(), bare.load.sum() + 0.75 * (3 + 1.5), 1e-12);
  EXPECT_GT(model.load.minCoeff(), 0);
}

TEST(StoreyColumns, AreBeamsFixedAtBothEnds) {
  const double height = 4, ei = 3 * modulus * inertia;  // three side by side
  for (const double part : {0.5, 0.3, 0.85}) {
    StructuralModel model = stick();
    const double a = part * height, b = height - a;
    add_columns(model, columns({{false, a}}, 3));
    // Floors held: 3 EI L³/(a³ b³), at the middle 192 EI/L³.
    const double k = 3 * ei * std::pow(height, 3) / std::pow(a * b, 3);
    EXPECT_NEAR(model.stiffness(2, 2), k, 1e-12 * k) << part;
    // Forces at the ends under F = 1: R = F b² (3 a + b)/L³ below, M = F a b²/L² and F a² b/L² [Roark].
    VectorXd x = VectorXd::Zero(3);
    x(2) = 1 / k;
    const VectorXd forces = model.column_forces * x;
    const double below = b * b * (3 * a + b) / std::pow(height, 3), above = 1 - below;
    const double bottom = a * b * b / (height * height), top = a * a * b / (height * height);
    EXPECT_NEAR(std::abs(forces(0)), below, 1e-12) << part;
    EXPECT_NEAR(std::abs(forces(1)), above, 1e-12) << part;
    EXPECT_NEAR(std::abs(forces(2)), bottom, 1e-12) << part;
    EXPECT_NEAR(std::abs(forces(3)), 2 * a * a * b * b / std::pow(height, 3), 1e-12) << part;
    EXPECT_NEAR(std::abs(forces(5)), top, 1e-12) << part;
    EXPECT_NEAR(forces(3) + forces(4), 0, 1e-12) << "no moment at the node";
    // With a drift and no force the whole columns' shear 12 EI Δ/h³, and M = 6 EI Δ/h² at both ends.
    const double deflection = 3 * part * part - 2 * part * part * part;
    const VectorXd bent = model.column_forces * Eigen::Vector3d(1, 1, deflection);
    EXPECT_NEAR(std::abs(bent(0)), 12 * ei / std::pow(height, 3), 1e-9 * ei);
    EXPECT_NEAR(std::abs(bent(1)), 12 * ei / std::pow(height, 3), 1e-9 * ei);
    EXPECT_NEAR(std::abs(bent(2)), 6 * ei / (height * height), 1e-9 * ei);
    EXPECT_NEAR(std::abs(bent(5)), 6 * ei / (height * height), 1e-9 * ei);
  }
}

TEST(StoreyColumns, AreThoseOfAFrameWithStiffBeams) {
  const std::vector<ColumnNode> nodes = {{true, 1.4}, {true, 5.8}};
  PlaneFrame frame{
      .elastic_modulus = modulus,
      .storey_heights = {4, 3},
      .bay_widths = {6},
      .columns = {{.area = 0.1, .inertia = inertia, .mass = 2.0}, {.area = 0.1, .inertia = inertia, .mass = 2.0}},
      .beams = {{.area = 0.1, .inertia = 1e9 * inertia, .mass = 0}, {.area = 0.1, .inertia = 1e9 * inertia, .mass = 0}},
      .floor_masses = {60, 50},
      .mass_matrix = MassMatrix::lumped,
      .nodes = nodes};
  const StructuralModel by_frame = plane_frame_model(frame);
  const auto k = [](double h) { return 2 * 12 * modulus * inertia / (h * h * h); };
  StructuralModel by_stick =
      stick_model({.storey_heights = {4, 3}, .masses = {60 + 2 + 2, 50 + 2}, .stiffnesses = {k(4), k(3)}});
  add_columns(by_stick, columns(nodes));
  ASSERT_EQ(by_frame.dofs(), by_stick.dofs());
  const auto near = [](const MatrixXd& a, const MatrixXd& b) { return (a - b).norm() <= 1e-6 * a.norm(); };
  EXPECT_TRUE(near(by_frame.stiffness, by_stick.stiffness));
  EXPECT_TRUE(near(by_frame.mass, by_stick.mass)) << by_frame.mass << "\n" << by_stick.mass;
  EXPECT_TRUE(near(by_frame.column_forces, by_stick.column_forces));
  EXPECT_EQ(by_frame.node_elevations, by_stick.node_elevations);
  for (const Index node : {0, 1}) EXPECT_NEAR(by_frame.node_masses[node], by_stick.node_masses[node], 1e-12);
  const auto rigid = [](const StructuralModel& model) { return rigid_body(model); };
  EXPECT_NEAR(rigid(by_frame).moment, rigid(by_stick).moment, 1e-9 * rigid(by_frame).moment);
}

TEST(StoreyColumns, LeaveTheLawsOfStoreysAlone) {
  const GenericBuilding generic{.storey_heights = {3, 3, 3},
                                .floor_masses = {100, 100, 80},
                                .period = 0.5,
                                .stiffness_ratio = 30,
                                .yield_base_shear = 0.2};
  const StructuralModel bare = generic_model(generic);
  StructuralModel model = bare;
  add_columns(model, columns({{true, 7.5}}));
  const auto laws = storey_laws(generic, bare, 9.81), struck = storey_laws(generic, model, 9.81);
  ASSERT_EQ(struck.size(), laws.size());
  for (std::size_t j = 0; j < laws.size(); ++j) {
    const auto branch = [](const auto& law) { return law->branch({}); };
    EXPECT_EQ(branch(struck[j]).stiffness, branch(laws[j]).stiffness);
    EXPECT_EQ(struck[j]->stored_energy({}, 0.01), laws[j]->stored_energy({}, 0.01));
  }
}

TEST(StoreyColumns, RefuseWhatIsNoPartOfTheStick) {
  const auto refused = [](const StoreyColumns& columns, const char* what) {
    StructuralModel model = stick();
    try {
      add_columns(model, columns);
      ADD_FAILURE() << what;
    } catch (const InvalidParameter& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  };
  StoreyColumns stiff = columns({{true, 1.0}});
  stiff.inertia = {inertia, 0.1};
  refused(stiff, "storey 2");
  StoreyColumns heavy = columns({{true, 1.0}});
  heavy.mass = {500};
  refused(heavy, "must be part of the mass of floor 1");
  refused(columns({{true, 0.01}}), "1 %");
  refused(columns({{true, 1.0}, {true, 1.02}}), "1 %");
  refused(columns({{true, 7.5}}), "must be between");
  refused(columns({{true, 1.0}}, 0), "must be 1 or more");
}

}  // namespace
}  // namespace bentur
