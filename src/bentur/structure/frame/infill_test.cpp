// A portal with infill by hand: width, stiffness and strength of the strut, K and the first period.
#include "bentur/structure/frame/infill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bentur/core/errors.h"
#include "bentur/structure/damping.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

PlaneFrame portal() {
  PlaneFrame frame;
  frame.elastic_modulus = 2.5e7;
  frame.storey_heights = {3.5};
  frame.bay_widths = {5.0};
  frame.columns = {{.area = 0.16, .inertia = 0.4 * 0.4 * 0.4 * 0.4 / 12}};
  frame.beams = {{.area = 0.3 * 0.5, .inertia = 0.3 * 0.5 * 0.5 * 0.5 / 12}};
  frame.floor_masses = {40};
  frame.mass_matrix = MassMatrix::lumped;
  return frame;
}

Infill masonry() {
  return {.thickness = 0.15, .modulus = 3e6, .strength = 3000, .backbone = {.plastic = 0.01, .softening = 0.03}};
}

TEST(Infill, OfAPortalIsTheStrutByHand) {
  PlaneFrame frame = portal();
  frame.infills = {masonry()};
  const std::vector<InfillPanel> panels = infill_panels(frame);
  ASSERT_EQ(panels.size(), 1U);
  // h = 3.5 − 0.25, L = 5 − 0.4.
  const double h = 3.25, l = 4.6, r = std::sqrt(h * h + l * l), theta = std::atan2(h, l);
  const double lambda = std::pow(3e6 * 0.15 * std::sin(2 * theta) / (4 * 2.5e7 * (0.0256 / 12) * h), 0.25);
  const double a = 0.175 * std::pow(lambda * 3.5, -0.4) * r;
  const double k = 3e6 * a * 0.15 / r * std::cos(theta) * std::cos(theta);
  EXPECT_NEAR(panels[0].stiffness, k, 1e-12 * k);
  EXPECT_NEAR(panels[0].cosine, std::cos(theta), 1e-14);
  EXPECT_NEAR(panels[0].backbone.yield, a * 0.15 * 3000 * std::cos(theta), 1e-9);
  frame.infills[0]->sliding_strength = 100;
  EXPECT_NEAR(infill_panels(frame)[0].backbone.yield, 100 * 0.15 * l, 1e-10);

  // The sway stiffness of a fixed portal, 24 EI_c/h³ (6κ + 1)/(6κ + 4), κ = (I_b/L)/(I_c/h), and the strut beside it.
  const double kappa = (0.3 * 0.125 / 12 / 5) / (0.0256 / 12 / 3.5);
  const double bare = 24 * 2.5e7 * (0.0256 / 12) / std::pow(3.5, 3) * (6 * kappa + 1) / (6 * kappa + 4);
  const StructuralModel model = plane_frame_model(frame);
  EXPECT_NEAR(model.stiffness(0, 0), bare + k, 1e-10 * k);
  const Building building = make_building("portal", model, ModalDamping{{0}});
  const double period = 2 * std::numbers::pi * std::sqrt(40 / (bare + k));
  EXPECT_NEAR(2 * std::numbers::pi / building.first_omega(), period, 1e-10 * period);
  ASSERT_EQ(building.elements.size(), 1U);
  EXPECT_EQ(building.elements[0].infill, 0);
  EXPECT_FALSE(building.storeys_yield());
  EXPECT_TRUE(building.can_yield());
  EXPECT_EQ(building.storey_law(0), nullptr);
}

TEST(Infill, LeavesOpenStoreysAsTheyAre) {
  PlaneFrame frame = portal();
  frame.storey_heights = {3.5, 3.0};
  frame.bay_widths = {5.0, 4.0};
  frame.columns.push_back(frame.columns[0]);
  frame.beams.push_back(frame.beams[0]);
  frame.floor_masses = {40, 30};
  const Eigen::MatrixXd bare = plane_frame_model(frame).stiffness;
  frame.infills = {std::nullopt, Infill{.stiffness = 7000, .backbone = {.yield = 50}}};
  const StructuralModel model = plane_frame_model(frame);
  ASSERT_EQ(model.infills.size(), 2U);
  Eigen::Matrix2d added;
  added << 14000, -14000, -14000, 14000;
  EXPECT_LT((model.stiffness - bare - added).cwiseAbs().maxCoeff(), 1e-12 * model.stiffness.maxCoeff());
  // In a hinged frame K of the frame alone has none of it.
  for (Section& beam : frame.beams) beam.moment_capacity = {100};
  const StructuralModel hinged = plane_frame_model(frame);
  EXPECT_LT((hinged.hinges.frame_stiffness - bare).cwiseAbs().maxCoeff(), 1e-11 * bare.maxCoeff());
}

TEST(Infill, IsInTheFirstModeThatDynamicCondensationKeeps) {
  PlaneFrame frame = portal();
  frame.columns[0].mass = frame.beams[0].mass = 3;
  frame.mass_matrix = MassMatrix::consistent;
  frame.infills = {masonry()};
  const auto first_omega = [&](Condensation condensation) {
    frame.condensation = condensation;
    const StructuralModel model = plane_frame_model(frame);
    return modes(model.mass, model.stiffness).omega(0);
  };
  const double whole = first_omega(Condensation::none);
  EXPECT_NEAR(first_omega(Condensation::dynamic), whole, 1e-10 * whole);
  EXPECT_GT(std::abs(first_omega(Condensation::static_) / whole - 1), 1e-6);
}

TEST(Infill, NeedsRoomAndABackbone) {
  PlaneFrame frame = portal();
  frame.infills = {masonry()};
  frame.infills[0]->backbone.cap = 0.5;
  EXPECT_THROW((void)infill_panels(frame), InvalidParameter);
  frame.infills = {masonry()};
  frame.bay_widths = {0.3};
  EXPECT_THROW((void)infill_panels(frame), InvalidParameter);
  frame.infills.push_back(masonry());
  EXPECT_THROW((void)infill_panels(frame), InvalidParameter);
}

}  // namespace
}  // namespace bentur
