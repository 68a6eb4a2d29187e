// Plastic hinges of frames against numbers worked out by hand (docs/theory/hinges.md): the portal of (H-2),
// collapse loads of the static theorem, moments of gravity loads.
#include "bentur/structure/frame/frame_hinges.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>
#include <numeric>

#include "bentur/core/errors.h"
#include "bentur/elements/hinges.h"
#include "bentur/structure/frame/plane_frame.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinite = std::numeric_limits<double>::infinity();

Section member(double inertia, std::vector<double> capacity, double hardening = 0) {
  return {.area = 1, .inertia = inertia, .mass = 1, .moment_capacity = std::move(capacity), .hardening = hardening};
}

PlaneFrame portal(std::vector<double> columns, std::vector<double> beam) {
  return {.elastic_modulus = 3e4,
          .storey_heights = {3},
          .bay_widths = {5},
          .columns = {member(1, std::move(columns))},
          .beams = {member(1, std::move(beam))},
          .floor_masses = {},
          .mass_matrix = MassMatrix::lumped};
}

/// Forces along a course of growing loads: equilibrium K x + Gᵀ F = factor · loads, event by event.
struct Push {
  explicit Push(const StructuralModel& model) : stiffness(model.stiffness), element(hinge_elements(model).at(0)) {
    state = element.law->begin(VectorXd::Zero(element.law->size()));
  }
  /// How x changes with the factor, and what it is at a factor of zero; nothing where the frame is a mechanism.
  struct Line {
    VectorXd at_zero, slope;
  };
  [[nodiscard]] std::optional<Line> line(const VectorXd& loads) const {
    const CoupledBranch branch = element.law->branch(state);
    const MatrixXd rows = element.rows(branch.set->moving, Eigen::all);
    const MatrixXd tangent = stiffness + rows.transpose() * branch.set->stiffness * rows;
    const Eigen::FullPivLU<MatrixXd> lu(tangent);
    const double smallest = lu.matrixLU().diagonal().cwiseAbs().minCoeff();
    if (smallest < 1e-9 * stiffness.cwiseAbs().maxCoeff()) return std::nullopt;
    return Line{lu.solve(-element.rows.transpose() * branch.base), lu.solve(loads)};
  }
  /// The factor at which the frame becomes a mechanism.
  double collapse(const VectorXd& loads) {
    double factor = 0;
    for (int events = 0; events < 1000; ++events) {
      const std::optional<Line> now = line(loads);
      if (!now) return factor;
      const CoupledBranch branch = element.law->branch(state);
      const VectorXd fixed = element.rows * now->at_zero;
      const VectorXd moving = element.rows * now->slope;
      double first = infinite;
      std::size_t ends = 0;
      for (std::size_t g = 0; g < branch.guard_count(); ++g) {
        const CoupledGuard guard = branch.guard(g);
        const bool flows = guard.deformation < 0;
        const VectorXd row = guard.sense * branch.set->row(flows ? guard.speed : guard.deformation, moving.size());
        if (flows) {
          EXPECT_GE(row.dot(moving), -1e-9 * row.norm() * moving.norm()) << "nobody unloads";
          continue;
        }
        const double falls = -row.dot(moving);
        const double left = guard.constant + row.dot(fixed);
        if (falls <= 1e-12 * row.norm() * moving.norm()) continue;
        if (left / falls < first) {
          first = left / falls;
          ends = g;
        }
      }
      if (!(first < infinite)) return infinite;
      factor = first;
      const VectorXd none = VectorXd::Zero(moving.size());
      state = element.law->next(state, branch, ends, factor, {fixed + factor * moving, moving, none, 0});
    }
    return infinite;
  }

  MatrixXd stiffness;
  CoupledElement element;
  CoupledState state;
};

TEST(FrameHinges, OfAPortalByHand) {
  const StructuralModel model = plane_frame_model(portal({100}, {60}));
  EXPECT_NEAR(model.stiffness(0, 0), 16140.35087719298, 1e-10);
  const Hinges& hinges = model.hinges;
  ASSERT_EQ(hinges.places.size(), 6U);
  EXPECT_EQ(name_of(hinges.places[1]), "top of the column of line 1, storey 1");
  EXPECT_EQ(name_of(hinges.places[5]), "right end of the beam of bay 1, floor 1");
  const VectorXd g{{-14736.842105263158, -9473.684210526316, -14736.842105263158, -9473.684210526316, 9473.684210526316,
                    9473.684210526316}};
  EXPECT_LT((hinges.rows.col(0) - g).cwiseAbs().maxCoeff(), 1e-10);
  MatrixXd rows(2, 6);
  rows << 33522.26720647773, 7044.534412955466, 1214.574898785425, 2429.14979757085, -7044.534412955466,
      -2429.14979757085,  //
      7044.534412955466, 14089.06882591093, 2429.14979757085, 4858.299595141701, -14089.06882591093, -4858.299595141701;
  EXPECT_LT((hinges.stiffness.topRows(2) - rows).cwiseAbs().maxCoeff(), 1e-10);
  // A spin of the left corner: its two ends turn alike, and nothing is bent.
  EXPECT_LT((hinges.stiffness.col(1) + hinges.stiffness.col(4)).cwiseAbs().maxCoeff(), 1e-10);
  // Beams are weaker, so that tops of columns never yield (H-5); of equals the beam does.
  for (const double beam : {60.0, 100.0}) {
    const Hinges held = plane_frame_model(portal({100}, {beam})).hinges;
    EXPECT_EQ(held.clockwise, (VectorXd{{100, infinite, 100, infinite, beam, beam}}));
    EXPECT_EQ(held.anticlockwise, held.clockwise);
  }
}

TEST(FrameHinges, OfAPortalThatIsPushed) {
  const StructuralModel model = plane_frame_model(portal({100}, {60}));
  const CoupledElement element = hinge_elements(model).at(0);
  const auto force_at = [&](double x, VectorXd& theta) {
    const VectorXd delta = element.rows * VectorXd::Constant(1, x);
    const CoupledState state = element.law->begin(delta);
    theta = state.memory.col(0);
    return (model.stiffness * x - element.rows.transpose() * theta)(0);
  };
  VectorXd theta;
  EXPECT_NEAR(force_at(0.005, theta), 80.7017543859649, 1e-12);
  EXPECT_TRUE(theta.isZero(0));
  EXPECT_NEAR(force_at(0.01, theta), 2 * (100.0 + 60.0) / 3, 1e-11);
  EXPECT_LT((theta - VectorXd{{-0.001, 0, -0.001, 0, 0.004 / 3, 0.004 / 3}}).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_NEAR(force_at(0.02, theta), 2 * (100.0 + 60.0) / 3, 1e-11);
  EXPECT_LT((theta - VectorXd{{-0.013, 0, -0.013, 0, 0.014, 0.014}} / 3).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(FrameHinges, CollapseUnderLoadsOfTheStaticTheorem) {
  EXPECT_NEAR(Push(plane_frame_model(portal({100}, {100}))).collapse(VectorXd::Ones(1)), 400.0 / 3, 1e-9);
  EXPECT_NEAR(Push(plane_frame_model(portal({100}, {60}))).collapse(VectorXd::Ones(1)), 320.0 / 3, 1e-9);
  const PlaneFrame frame{.elastic_modulus = 3e7,
                         .storey_heights = {3.5, 3},
                         .bay_widths = {5, 4},
                         .columns = {member(2e-3, {130, 170, 120}), member(1.5e-3, {80, 110, 85})},
                         .beams = {member(3e-3, {97}), member(2e-3, {71})},
                         .floor_masses = {},
                         .mass_matrix = MassMatrix::lumped};
  struct Case {
    double ground, roof, factor;
  };
  for (const Case& of : {Case{1, 2, 64.242424242424}, Case{1, 0.3, 184.615384615385}, Case{0.2, 1, 147.222222222222},
                         Case{-1, 1, 175.666666666667}}) {
    EXPECT_NEAR(Push(plane_frame_model(frame)).collapse(Eigen::Vector2d(of.ground, of.roof)), of.factor,
                1e-8 * of.factor)
        << of.ground << " " << of.roof;
  }
}

TEST(FrameHinges, OfAStruckColumn) {
  // Fixed at both ends, as its beam does not bend: 192 EI/h³, then 8 M_p/h.
  PlaneFrame frame = portal({100}, {});
  frame.beams[0].inertia = 1e9;
  frame.nodes = {{.left = true, .elevation = 1.5}};
  StructuralModel model = plane_frame_model(frame);
  ASSERT_EQ(model.hinges.places.size(), 5U);
  EXPECT_EQ(name_of(model.hinges.places[1]), "node of the column of line 1, storey 1");
  model.stiffness(0, 0) += 1e12;  // the floor is held
  EXPECT_NEAR(model.stiffness(1, 1), 192 * 3e4 / 27, 5e-9 * 192 * 3e4 / 27);
  EXPECT_NEAR(Push(model).collapse(Eigen::Vector2d(0, 1)), 8 * 100.0 / 3, 1e-6);
}

TEST(FrameHinges, CarryGravityFromTheStart) {
  PlaneFrame frame = portal({100}, {60});
  frame.beams[0].line_load = 12;
  const StructuralModel model = plane_frame_model(frame);
  const double corner = 12 * 25.0 / (6 * (0.6 + 2));
  const VectorXd moments{{corner / 2, corner, -corner / 2, -corner, -corner, corner}};
  EXPECT_LT((model.hinges.at_rest - moments).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_NEAR(Push(model).collapse(VectorXd::Ones(1)), 320.0 / 3, 1e-9) << "as without";
  frame.beams[0].line_load = 500;
  try {
    (void)plane_frame_model(frame);
    FAIL() << "a beam that yields by itself";
  } catch (const InvalidParameter& error) {
    EXPECT_NE(std::string(error.what()).find("left end of the beam of bay 1, floor 1"), std::string::npos)
        << error.what();
  }
}

TEST(FrameHinges, OfBeamsThatAreStrongerBelow) {
  const Hinges hinges = plane_frame_model(portal({500}, {90, 140})).hinges;
  // Sagging, with the tension below, is clockwise at a left end.
  EXPECT_EQ(hinges.clockwise(4), 90);
  EXPECT_EQ(hinges.anticlockwise(4), 140);
  EXPECT_EQ(hinges.clockwise(5), 140);
  EXPECT_EQ(hinges.anticlockwise(5), 90);
}

TEST(FrameHinges, RefuseWhatIsNoCapacity) {
  for (const auto& capacity : std::vector<std::vector<double>>{{0}, {-1}, {1, 2, 3}, {std::nan("")}}) {
    EXPECT_THROW((void)plane_frame_model(portal({100}, capacity)), InvalidParameter);
  }
  EXPECT_THROW((void)plane_frame_model(portal({100, 100, 100}, {60})), InvalidParameter);
  PlaneFrame frame = portal({100}, {60});
  frame.beams[0].hardening = 1;
  EXPECT_THROW((void)plane_frame_model(frame), InvalidParameter);
}

}  // namespace
}  // namespace bentur
