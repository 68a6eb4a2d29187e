#include "bentur/structure/frame/member_forces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bentur/structure/modes.h"

namespace bentur {
namespace {

using Eigen::Index;

constexpr double round_off = 1e-10;  // of the largest, of some sixty terms each

/// Three storeys and two bays, nothing of them alike, struck on either side [m, kN].
PlaneFrame struck_frame() {
  PlaneFrame frame;
  frame.elastic_modulus = 3e7;
  frame.storey_heights = {4.0, 3.0, 3.5};
  frame.bay_widths = {5.0, 6.5};
  frame.columns = {{0.16, 2.1e-3, 1.6}, {0.12, 1.2e-3, 0.9}, {0.09, 0.7e-3, 0.8}};
  frame.beams = {{0.15, 3.1e-3, 2.2}, {0.15, 2.9e-3, 2.1}, {0.12, 2.0e-3, 1.4}};
  frame.floor_masses = {12.0, 11.0, 7.0};
  frame.nodes = {{true, 5.2}, {false, 1.7}};
  return frame;
}

const Eigen::VectorXd& sways() {
  static const Eigen::VectorXd values = (Eigen::VectorXd(5) << 0.013, 0.021, 0.019, 0.011, 0.008).finished();
  return values;
}

struct Diagram {
  std::vector<FrameMember> members;
  Eigen::MatrixXd moments;  // stations × members
  Eigen::VectorXd shears, axial;
  explicit Diagram(const PlaneFrame& frame, const Eigen::VectorXd& y) {
    const MemberForces forces(frame);
    const Eigen::MatrixXd none(0, 1);
    members = forces.members();
    const MemberForces::Forces all = forces.forces(y, none);
    moments = Eigen::Map<const Eigen::MatrixXd>(all.moments.data(), 5, std::ssize(members));
    shears = all.shears;
    axial = all.axial;
  }
  /// What acts on an end of a member, clockwise: `second` of the top or right one.
  [[nodiscard]] double end(Index n, bool second) const { return second ? -moments(4, n) : moments(0, n); }
};

/// A joint turns until the moments of all members that meet there balance, and so does a struck node.
TEST(MemberForces, BalanceAtEveryJoint) {
  const Diagram found(struck_frame(), sways());
  ASSERT_EQ(found.members.size(), 9 + 2 + 6U);
  const std::vector<double> levels = {4, 7, 10.5}, lines = {0, 5, 11.5};
  const double largest = found.moments.cwiseAbs().maxCoeff();
  std::vector<std::pair<double, double>> places = {{0, 5.2}, {11.5, 1.7}};
  for (const double x : lines) {
    for (const double z : levels) places.emplace_back(x, z);
  }
  for (const auto& [x, z] : places) {
    double sum = 0, size = 0;
    for (Index n = 0; n < std::ssize(found.members); ++n) {
      const FrameMember& member = found.members[n];
      for (const bool second : {false, true}) {
        const double along = second ? member.to : member.from;
        const bool meets = member.of_beam ? along == x && std::abs(member.place - z) < 1e-12
                                          : member.place == x && std::abs(along - z) < 1e-12;
        if (!meets) continue;
        sum += found.end(n, second);
        size += std::abs(found.end(n, second));
      }
    }
    EXPECT_GT(size, 1e-3 * largest);
    EXPECT_LT(std::abs(sum), round_off * largest) << x << ", " << z;
  }
}

/// K y is what holds the sways; the columns cut at any height carry all that acts above it.
TEST(MemberForces, ColumnsCarryTheStoreyShear) {
  const PlaneFrame frame = struck_frame();
  const StructuralModel model = plane_frame_model(frame);
  const Eigen::VectorXd holding = model.stiffness * sways();
  const std::vector<double> at = {4, 7, 10.5, 5.2, 1.7};
  const Diagram found(frame, sways());
  for (const double cut : {1.0, 3.0, 4.5, 6.0, 9.0}) {
    double applied = 0, carried = 0;
    for (std::size_t i = 0; i < at.size(); ++i) applied += at[i] > cut ? holding(static_cast<Index>(i)) : 0;
    for (Index n = 0; n < std::ssize(found.members); ++n) {
      const FrameMember& member = found.members[n];
      if (!member.of_beam && member.from < cut && member.to > cut) carried += found.shears(n);
    }
    EXPECT_NEAR(carried, applied, round_off * holding.cwiseAbs().maxCoeff()) << cut;
  }
}

/// About the left foot: what holds the sways turns the frame over; moments and axial forces of the feet hold it.
TEST(MemberForces, AxialForcesHoldTheFrameDown) {
  const PlaneFrame frame = struck_frame();
  const Eigen::VectorXd holding = plane_frame_model(frame).stiffness * sways();
  const std::vector<double> at = {4, 7, 10.5, 5.2, 1.7};
  double over = 0, held = 0, up = 0;
  for (std::size_t i = 0; i < at.size(); ++i) over += at[i] * holding(static_cast<Index>(i));
  const Diagram found(frame, sways());
  for (Index n = 0; n < std::ssize(found.members); ++n) {
    const FrameMember& member = found.members[n];
    EXPECT_EQ(std::isnan(found.axial(n)), member.of_beam);
    if (member.of_beam || member.from > 0) continue;
    held += member.place * found.axial(n) - found.end(n, false);
    up += found.axial(n);
  }
  EXPECT_NEAR(held, over, round_off * std::abs(over));
  EXPECT_NEAR(up, 0, round_off * found.axial.head(9).cwiseAbs().maxCoeff());
  EXPECT_GT(found.axial(2), 0);  // swayed to the right the right column is pressed
}

/// A portal of one bay whose beam does not bend: columns fixed at both ends, 12 E I/h³ each, 6 E I/h² at their ends.
TEST(MemberForces, OfAStiffBeamAreThoseOfFixedColumns) {
  PlaneFrame frame;
  frame.elastic_modulus = 3e7;
  frame.storey_heights = {4.0};
  frame.bay_widths = {5.0};
  frame.columns = {{0.16, 2e-3, 1.0}};
  frame.beams = {{0.15, 2e9, 2.0}};
  const Diagram found(frame, Eigen::VectorXd::Constant(1, 0.01));
  const double rigidity = 3e7 * 2e-3;
  for (const Index n : {0, 1}) {
    EXPECT_NEAR(found.shears(n), 12 * rigidity * 0.01 / 64, 1e-6);
    EXPECT_NEAR(found.moments(0, n), -6 * rigidity * 0.01 / 16, 1e-6);
    EXPECT_NEAR(found.moments(2, n), 0, 1e-6);
    EXPECT_NEAR(found.moments(4, n), 6 * rigidity * 0.01 / 16, 1e-6);
  }
  EXPECT_NEAR(found.axial(1), 2 * 6 * rigidity * 0.01 / 16 / 5, 1e-6);
  EXPECT_NEAR(found.axial(0), -found.axial(1), 1e-6);
}

TEST(MemberForces, KnowWhatTurnsWithoutInertiaAlone) {
  PlaneFrame frame = struck_frame();
  EXPECT_TRUE(MemberForces::knows(frame));
  frame.condensation = Condensation::none;
  EXPECT_FALSE(MemberForces::knows(frame));
  frame.mass_matrix = MassMatrix::lumped;
  EXPECT_TRUE(MemberForces::knows(frame));
}

}  // namespace
}  // namespace bentur
