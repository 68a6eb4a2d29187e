#include "bentur/model/story/worst_hinges.h"

#include <gtest/gtest.h>

#include "bentur/structure/frame/plane_frame.h"

namespace bentur {
namespace {

/// Two bays and two storeys; all hinges have yielded.
std::size_t balanced_joints(double of_columns, double of_beams, double hardening) {
  PlaneFrame frame;
  frame.elastic_modulus = 3e10;
  frame.storey_heights = {3, 3};
  frame.bay_widths = {5, 5};
  const Section column{.area = 0.16, .inertia = 2e-3, .moment_capacity = {of_columns}, .hardening = hardening};
  const Section beam{.area = 0.16, .inertia = 2e-3, .moment_capacity = {of_beams}};
  frame.columns = {column, column};
  frame.beams = {beam, beam};
  frame.floor_masses = {2e4, 2e4};
  frame.mass_matrix = MassMatrix::lumped;
  const Hinges hinges = plane_frame_model(frame).hinges;
  BuildingPeaks peaks;
  for (Eigen::Index h = 0; h < std::ssize(hinges.places); ++h) {
    peaks.hinges.push_back({.peak_rotation = 0.01, .first_yield = 1.0});
  }
  const auto joints = indeterminate_joints(hinges, peaks);
  for (const std::vector<Eigen::Index>& ends : joints) {
    for (const Eigen::Index h : ends) {
      const HingePlace& place = hinges.places[h];  // of the inner joint of the lower floor
      EXPECT_EQ(place.of_beam ? place.number + (place.end == HingePlace::End::right ? 1 : 0) : place.number, 2);
      EXPECT_EQ(place.end == HingePlace::End::bottom ? place.level - 1 : place.level, 1);
    }
  }
  return joints.size();
}

/// Two beams and two columns, all alike: of four moments two and two balance.
TEST(IndeterminateJoints, AreThoseWhoseEndsCanAllFlowAtOnce) {
  EXPECT_EQ(balanced_joints(5e4, 5e4, 0), 1U);
  EXPECT_EQ(balanced_joints(5e4, 4e4, 0), 1U);  // beams against one another, and columns
  EXPECT_EQ(balanced_joints(5e4, 5e4, 0.01), 0U);
}

}  // namespace
}  // namespace bentur
