#include "bentur/structure/frame/plane_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/structure/frame/condensation.h"
#include "bentur/structure/modes.h"
#include "bentur/structure/stick.h"
#include "tests/support/exact/monograph_frames.h"
#include "tests/support/exact/portal_frame.h"

namespace bentur {
namespace {

using exact::monograph_frame;

Eigen::VectorXd periods(const StructuralModel& model) {
  return modal_properties(modes(model.mass, model.stiffness), model.load).periods;
}

// A frame with nothing regular about it: three storeys, two bays [m, kN].
PlaneFrame irregular_frame() {
  PlaneFrame frame;
  frame.elastic_modulus = 3e7;
  frame.storey_heights = {4.0, 3.0, 3.5};
  frame.bay_widths = {5.0, 6.5};
  frame.columns = {{0.16, 2.1e-3, 1.6}, {0.12, 1.2e-3, 0.9}, {0.09, 0.7e-3, 0.8}};
  frame.beams = {{0.15, 3.1e-3, 2.2}, {0.15, 2.9e-3, 2.1}, {0.12, 2.0e-3, 1.4}};
  frame.floor_masses = {12.0, 11.0, 7.0};
  return frame;
}

PlaneFrame portal(double column_inertia, double beam_inertia, std::vector<double> bays = {5.0}) {
  PlaneFrame frame;
  frame.elastic_modulus = 3e7;
  frame.storey_heights = {4.0};
  frame.bay_widths = std::move(bays);
  frame.columns = {{0.16, column_inertia, 1.0}};
  frame.beams = {{0.15, beam_inertia, 2.0}};
  return frame;
}

TEST(PlaneFrame, StiffnessIsTheMonographsMatrix) {
  // [K]_s of 4.1.3, three storeys and one bay of length L: sways from the bottom, then the joints of floors 1, 2, 3.
  const double l = 100, k = 2.1e5 * 833.0, b = 2.1e5 * 1296.0;  // L, E I_k, E I_b
  PlaneFrame frame = monograph_frame(1);
  for (Section& column : frame.columns) column.inertia = 833.0;
  for (Section& beam : frame.beams) beam.inertia = 1296.0;
  const double s = 24 * k / (l * l * l), c = 6 * k / (l * l), q = 2 * k / l, w = 2 * b / l;
  const double d = 4 * q + 2 * w, t = 2 * q + 2 * w;
  Eigen::MatrixXd expected(9, 9);
  expected << 2 * s, -s, 0, 0, 0, c, c, 0, 0,  //
      -s, 2 * s, -s, -c, -c, 0, 0, c, c,       //
      0, -s, s, 0, 0, -c, -c, -c, -c,          //
      0, -c, 0, d, w, q, 0, 0, 0,              //
      0, -c, 0, w, d, 0, q, 0, 0,              //
      c, 0, -c, q, 0, d, w, q, 0,              //
      c, 0, -c, 0, q, w, d, 0, q,              //
      0, c, -c, 0, 0, q, 0, t, w,              //
      0, c, -c, 0, 0, 0, q, w, t;
  const Eigen::MatrixXd error = (assemble_plane_frame(frame).stiffness - expected).cwiseAbs();
  // A few roundings of the largest entry.
  EXPECT_LE(error.maxCoeff(), 1e-15 * expected.maxCoeff());
}

// A floor of beams of 5 m and 6.5 m, each with the mass of its own length: as three frames of one bay each would have.
TEST(PlaneFrame, AMemberByItsLengthWeighsAsOneGivenItsMass) {
  PlaneFrame frame = irregular_frame();
  const double line_mass = 0.4;
  for (Section& column : frame.columns) column.mass = 0;
  for (std::size_t i = 0; i < 3; ++i) frame.columns[i].line_mass = 0.3;
  for (Section& beam : frame.beams) {
    beam.mass = 0;
    beam.line_mass = line_mass;
  }
  PlaneFrame by_mass = frame;
  for (std::size_t i = 0; i < 3; ++i) {
    by_mass.columns[i].line_mass = 0;
    by_mass.columns[i].mass = 0.3 * frame.storey_heights[i];
  }
  const StructuralModel model = assemble_plane_frame(frame);
  // Column halves of three lines, beams of both bays, and the floor's own.
  EXPECT_NEAR(model.floor_masses[0], 3 * 0.3 * (4.0 + 3.0) / 2 + line_mass * 11.5 + 12.0, 1e-14 * 20);
  EXPECT_NEAR(model.floor_masses[2], 3 * 0.3 * 3.5 / 2 + line_mass * 11.5 + 7.0, 1e-14 * 20);
  const StructuralModel same = assemble_plane_frame(by_mass);
  EXPECT_LE((model.mass - same.mass).cwiseAbs().maxCoeff(), 1e-15 * model.mass.maxCoeff());
  // (2-50): the rotation of the outer joint of a beam has 4 m l²/420, m its own mass; of its column 4 m l²/420 too.
  const auto own = [](double mass, double length) { return 4 * mass * length * length / 420; };
  const Eigen::Index top_left = 3 + 2 * 3, top_right = top_left + 2;
  EXPECT_NEAR(model.mass(top_left, top_left), own(0.4 * 5, 5) + own(0.3 * 3.5, 3.5), 1e-15);
  EXPECT_NEAR(model.mass(top_right, top_right), own(0.4 * 6.5, 6.5) + own(0.3 * 3.5, 3.5), 1e-15);
}

TEST(PlaneFrame, PortalStiffness) {
  for (const double ratio : {1e-6, 1e-2, 0.3, 1.0, 4.0, 1e2, 1e6}) {
    const double column = 2e-3, beam = ratio * column;
    const StructuralModel model = plane_frame_model(portal(column, beam));
    const double expected = exact::portal_stiffness(3e7, column, beam, 4.0, 5.0);
    // k is what two numbers of up to four times its size leave: about ten roundings.
    EXPECT_NEAR(model.stiffness(0, 0) / expected, 1, 1e-14) << ratio;
  }
}

TEST(PlaneFrame, RigidAndVanishingBeams) {
  // Limits of the column: 12EI/h³ guided at both ends, 3EI/h³ as a cantilever; the error is of the order of κ^∓1 =
  // 1e-9.
  const double one = 3e7 * 2e-3 / 64;
  for (const std::vector<double>& bays : {std::vector<double>{5.0}, {5.0, 4.0, 6.0}}) {
    const auto columns = static_cast<double>(bays.size() + 1);
    EXPECT_NEAR(plane_frame_model(portal(2e-3, 2e6, bays)).stiffness(0, 0) / (12 * columns * one), 1, 1e-8);
    EXPECT_NEAR(plane_frame_model(portal(2e-3, 2e-12, bays)).stiffness(0, 0) / (3 * columns * one), 1, 1e-8);
  }
}

TEST(PlaneFrame, RigidBeamsMakeAShearBuilding) {
  PlaneFrame frame = irregular_frame();
  for (Section& beam : frame.beams) beam.inertia = 1e5;
  Stick stick{frame.storey_heights, {1, 1, 1}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    stick.stiffnesses.push_back(3 * 12 * 3e7 * frame.columns[i].inertia / std::pow(frame.storey_heights[i], 3));
  }
  const Eigen::MatrixXd expected = stick_model(stick).stiffness;
  const Eigen::MatrixXd error = (plane_frame_model(frame).stiffness - expected).cwiseAbs();
  EXPECT_LE(error.maxCoeff(), 1e-6 * expected.maxCoeff());  // κ is some 1e8
}

TEST(PlaneFrame, QuadraticAndCubicSwayAreExact) {
  // The element's shapes hold every cubic, so u(z) = z^p with θ = u' (clockwise) gives the energies and the momentum of
  // the continuous columns exactly: ∫m̄u², ∫EI u''², ∫m̄u; the last fixes the sign of both parts of m_g. A beam with both
  // ends turned by θ adds 12 E I_b θ²/L and 2 m_b L² θ²/420, and its whole mass at u.
  const PlaneFrame frame = irregular_frame();
  const StructuralModel model = assemble_plane_frame(frame);
  for (const int p : {2, 3}) {
    Eigen::VectorXd q(12);
    double mass = 0, stiffness = 0, momentum = 0, z0 = 0;
    for (int i = 0; i < 3; ++i) {
      const auto floor = static_cast<std::size_t>(i);
      const Section &column = frame.columns[floor], &beam = frame.beams[floor];
      const double h = frame.storey_heights[floor], z = z0 + h;
      const double u = std::pow(z, p), theta = p * std::pow(z, p - 1);
      q(i) = u;
      q.segment(3 + 3 * i, 3).setConstant(theta);
      const auto integral = [&](int power) { return (std::pow(z, power + 1) - std::pow(z0, power + 1)) / (power + 1); };
      mass += 3 * column.mass / h * integral(2 * p) + (2 * beam.mass + frame.floor_masses[floor]) * u * u;
      momentum += 3 * column.mass / h * integral(p) + (2 * beam.mass + frame.floor_masses[floor]) * u;
      stiffness += 3 * 3e7 * column.inertia * std::pow(p * (p - 1), 2) * integral(2 * p - 4);
      for (const double l : frame.bay_widths) {
        mass += 2 * beam.mass * l * l * theta * theta / 420;
        stiffness += 12 * 3e7 * beam.inertia * theta * theta / l;
      }
      z0 = z;
    }
    // Sums of some hundred terms with moderate cancellation.
    EXPECT_NEAR(q.dot(model.mass * q) / mass, 1, 1e-12) << p;
    EXPECT_NEAR(q.dot(model.stiffness * q) / stiffness, 1, 1e-12) << p;
    EXPECT_NEAR(q.dot(model.load) / momentum, 1, 1e-12) << p;
  }
}

TEST(PlaneFrame, ConsistentMassConservesMassAndMomentum) {
  // rᵀMr + 2 rᵀm_g + what stays at the base (156/420 of each ground-storey column) is all the mass there is.
  PlaneFrame frame = irregular_frame();
  const StructuralModel with = assemble_plane_frame(frame);
  frame.base_coupling = false;
  const StructuralModel without = assemble_plane_frame(frame);
  Eigen::VectorXd r = Eigen::VectorXd::Zero(12);
  r.head(3).setOnes();
  double total = 0;
  for (std::size_t i = 0; i < 3; ++i)
    total += 3 * frame.columns[i].mass + 2 * frame.beams[i].mass + frame.floor_masses[i];
  const double ground = 3 * frame.columns[0].mass;
  const Eigen::VectorXd m_g = with.load - without.load;
  EXPECT_NEAR(r.dot(with.mass * r) + 2 * r.dot(m_g) + 156.0 / 420 * ground, total, 1e-13 * total);
  EXPECT_TRUE(without.load.isApprox(with.mass * r, 1e-14));
  // Momentum of the free joints while everything moves with the base: half of the ground columns is the base's.
  EXPECT_NEAR(r.dot(with.load), total - ground / 2, 1e-13 * total);
  EXPECT_NEAR(m_g(0), 54.0 / 420 * ground, 1e-12 * ground);
  for (int joint = 0; joint < 3; ++joint) EXPECT_NEAR(m_g(3 + joint), -13.0 / 420 * 4.0 * ground / 3, 1e-12 * ground);
  EXPECT_EQ(m_g.segment(1, 2).norm() + m_g.tail(6).norm(), 0);
}

TEST(PlaneFrame, LumpedMass) {
  PlaneFrame frame = irregular_frame();
  frame.mass_matrix = MassMatrix::lumped;
  const StructuralModel model = assemble_plane_frame(frame);
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(12);
  expected.head(3) << 3 * (1.6 + 0.9) / 2 + 4.4 + 12, 3 * (0.9 + 0.8) / 2 + 4.2 + 11, 3 * 0.8 / 2 + 2.8 + 7;
  EXPECT_LE((model.mass - Eigen::MatrixXd(expected.asDiagonal())).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_LE((model.load - expected).cwiseAbs().maxCoeff(), 1e-14);  // m_g = 0
}

TEST(PlaneFrame, FloorMassesAreTheLumpedOnesWhateverTheMassMatrix) {
  PlaneFrame frame = irregular_frame();
  const std::vector<double> expected = {3 * (1.6 + 0.9) / 2 + 4.4 + 12, 3 * (0.9 + 0.8) / 2 + 4.2 + 11,
                                        3 * 0.8 / 2 + 2.8 + 7};
  for (const MassMatrix matrix : {MassMatrix::consistent, MassMatrix::lumped}) {
    for (const Condensation each : {Condensation::static_, Condensation::dynamic, Condensation::none}) {
      frame.mass_matrix = matrix;
      frame.condensation = each;
      const std::vector<double> actual = plane_frame_model(frame).floor_masses;
      ASSERT_EQ(actual.size(), 3U);
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], 1e-14 * expected[i]);  // sums of seven
    }
  }
}

TEST(PlaneFrame, LumpedMassMakesEveryCondensationStatic) {
  PlaneFrame frame = irregular_frame();
  frame.mass_matrix = MassMatrix::lumped;
  const StructuralModel expected = plane_frame_model(frame);
  for (const Condensation each : {Condensation::dynamic, Condensation::none}) {
    frame.condensation = each;
    const StructuralModel model = plane_frame_model(frame);
    EXPECT_EQ(model.mass, expected.mass);
    EXPECT_EQ(model.stiffness, expected.stiffness);
    EXPECT_EQ(model.load, expected.load);
  }
}

TEST(PlaneFrame, CondensationChoices) {
  PlaneFrame frame = irregular_frame();
  const StructuralModel full = assemble_plane_frame(frame);
  EXPECT_EQ(plane_frame_model(frame).stiffness, condense_statically(full, 3).stiffness);
  frame.condensation = Condensation::dynamic;
  EXPECT_EQ(plane_frame_model(frame).stiffness, condense_dynamically(full, 3).stiffness);
  frame.condensation = Condensation::none;
  EXPECT_EQ(plane_frame_model(frame).stiffness, full.stiffness);
}

TEST(PlaneFrame, ElevationsStandOnTheBase) {
  const StructuralModel model = plane_frame_model(irregular_frame(), -2.0);
  EXPECT_EQ(model.elevations, (std::vector<double>{2.0, 5.0, 8.5}));
  EXPECT_EQ(model.storey_heights, (std::vector<double>{4.0, 3.0, 3.5}));
  EXPECT_EQ(model.floors(), 3);
  EXPECT_EQ(model.dofs(), 3);
}

TEST(PlaneFrame, MirrorImageIsTheSameBuilding) {
  PlaneFrame frame = irregular_frame();
  const StructuralModel model = plane_frame_model(frame);
  frame.bay_widths = {6.5, 5.0};
  const StructuralModel mirrored = plane_frame_model(frame);
  EXPECT_TRUE(mirrored.stiffness.isApprox(model.stiffness, 1e-13));
  EXPECT_TRUE(mirrored.mass.isApprox(model.mass, 1e-13));
  EXPECT_TRUE(mirrored.load.isApprox(model.load, 1e-13));
}

TEST(PlaneFrame, MonographPeriods) {
  // Theory 7.5 prints four decimals.
  const std::vector<double> first = {0.1440, 0.1627, 0.3083, 0.1114};
  for (int model = 1; model <= 4; ++model) {
    EXPECT_NEAR(periods(plane_frame_model(monograph_frame(model)))(0), first[static_cast<std::size_t>(model - 1)],
                5e-5);
  }
  EXPECT_NEAR(periods(plane_frame_model(exact::monograph_two_storeys()))(0), 0.0640, 5e-5);
}

TEST(PlaneFrame, ReferencePeriods) {
  // To all digits, from the independent program behind the reference cases (theory 7.5: OpenSees agrees to 1e-10).
  const auto expect = [](const PlaneFrame& frame, const std::vector<double>& expected) {
    const Eigen::VectorXd actual = periods(plane_frame_model(frame));
    ASSERT_EQ(actual.size(), static_cast<Eigen::Index>(expected.size()));
    for (Eigen::Index i = 0; i < actual.size(); ++i) {
      EXPECT_NEAR(actual(i) / expected[static_cast<std::size_t>(i)], 1, 1e-12) << i;
    }
  };
  PlaneFrame one = monograph_frame(1), two = monograph_frame(2);
  expect(one, {0.14400448235235136, 0.04640092390191042, 0.027512436980108558});
  expect(two, {0.16265152131340066, 0.050173445286747005, 0.028005296995312203});
  expect(exact::monograph_two_storeys(), {0.06396635781818358, 0.021583093025250258});
  one.condensation = two.condensation = Condensation::none;
  expect(one, {0.144005803996504, 0.04640416019688183, 0.027514579114470025, 0.012198324616505855, 0.00954764143409832,
               0.00785335948926777, 0.0044486228575717915, 0.003506881003751005, 0.002794344688939489});
  expect(two,
         {0.16265325099938452, 0.05017791457483679, 0.02800951247288308, 0.013524550072581378, 0.010151159258184203,
          0.008166603531953124, 0.00526615280775113, 0.004019585846687095, 0.0030956645267976356});
  one.mass_matrix = two.mass_matrix = MassMatrix::lumped;
  expect(one, {0.14431195242314618, 0.04717180730528867, 0.028596668338026595});
  expect(two, {0.16300646462168952, 0.050955150612457714, 0.029069777072968078});
}

TEST(PlaneFrame, BadParametersAreNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto expect = [](const std::function<void(PlaneFrame&)>& spoil, const std::string& name) {
    PlaneFrame frame = irregular_frame();
    spoil(frame);
    try {
      static_cast<void>(plane_frame_model(frame));
      ADD_FAILURE() << name << " was taken";
    } catch (const InvalidParameter& error) {
      EXPECT_EQ(std::string(error.what()).rfind(name + " = ", 0), 0U) << error.what();
    }
  };
  expect([](PlaneFrame& f) { f.elastic_modulus = 0; }, "elastic_modulus");
  expect([](PlaneFrame& f) { f.storey_heights.clear(); }, "storey_heights");
  expect([](PlaneFrame& f) { f.storey_heights[1] = -3; }, "storey_heights[1]");
  expect([](PlaneFrame& f) { f.bay_widths.clear(); }, "bay_widths");
  expect([=](PlaneFrame& f) { f.bay_widths[0] = nan; }, "bay_widths[0]");
  expect([](PlaneFrame& f) { f.columns.pop_back(); }, "columns");
  expect([](PlaneFrame& f) { f.columns[2].area = 0; }, "columns[2].area");
  expect([](PlaneFrame& f) { f.beams.push_back(f.beams[0]); }, "beams");
  expect([](PlaneFrame& f) { f.beams[1].inertia = -1; }, "beams[1].inertia");
  expect([](PlaneFrame& f) { f.beams[0].mass = -1e-9; }, "beams[0].mass");
  expect([](PlaneFrame& f) { f.floor_masses = {1, 2}; }, "floor_masses");
  expect([=](PlaneFrame& f) { f.floor_masses[2] = nan; }, "floor_masses[2]");
  // A floor without any mass; joints without any while their rotations are to be kept.
  expect(
      [](PlaneFrame& f) {
        for (auto* sections : {&f.columns, &f.beams}) {
          for (Section& section : *sections) section.mass = 0;
        }
        f.floor_masses = {1, 0, 1};
      },
      "floor_masses[1]");
  expect(
      [](PlaneFrame& f) {
        f.columns[1].mass = f.columns[2].mass = f.beams[1].mass = 0;
        f.beams[2].mass = 0;
        f.condensation = Condensation::none;
      },
      "condensation");
  EXPECT_THROW(static_cast<void>(plane_frame_model(irregular_frame(), nan)), InvalidParameter);
}

// A column held against rotation at both ends by a base and a beam that hardly bends, struck in the middle.
TEST(PlaneFrame, ANodeInAColumnIsAsStiffAsThatColumn) {
  PlaneFrame frame = portal(2e-3, 2e9);
  frame.nodes = {{.left = true, .elevation = 2.0}};
  const StructuralModel model = plane_frame_model(frame);
  ASSERT_EQ(model.dofs(), 2);
  const double ei = 3e7 * 2e-3, l = 4;
  // The beam's rotation is left out of the formula: it is of the part 1e-12 of the column's.
  EXPECT_NEAR(model.stiffness(1, 1), 192 * ei / (l * l * l), 1e-9 * 192 * ei / (l * l * l));
  EXPECT_NEAR(model.node_masses[0], 0.5, 1e-15);
  const double shear = 96 * ei / (l * l * l), moment = 24 * ei / (l * l);
  const Eigen::VectorXd forces = model.column_forces.col(1).cwiseAbs();
  const double expected[] = {shear, shear, moment, moment, moment, moment};
  for (Eigen::Index n = 0; n < 6; ++n) EXPECT_NEAR(forces(n), expected[n], 1e-9 * expected[n]) << n;
}

// A node that nothing strikes changes nothing but by the sway that it may now have: the static answer is the same.
TEST(PlaneFrame, ANodeLeavesStaticStiffnessOfFloorsAsItIs) {
  PlaneFrame frame = irregular_frame();
  const StructuralModel plain = plane_frame_model(frame);
  frame.nodes = {{.left = false, .elevation = 5.1}, {.left = true, .elevation = 1.7}};
  const StructuralModel model = condense_statically(plane_frame_model(frame), 3);
  EXPECT_LE((model.stiffness - plain.stiffness).cwiseAbs().maxCoeff(), 1e-12 * plain.stiffness.cwiseAbs().maxCoeff());
}

TEST(PlaneFrame, ANodeNearAFloorIsRefused) {
  PlaneFrame frame = irregular_frame();
  for (const double elevation : {-1.0, 0.0, 3.99, 4.0, 4.02, 10.5, 11.0}) {
    frame.nodes = {{.left = true, .elevation = elevation}};
    EXPECT_THROW(static_cast<void>(plane_frame_model(frame)), InvalidParameter) << elevation;
  }
}

}  // namespace
}  // namespace bentur
