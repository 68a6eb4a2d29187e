// Floors that nearly meet, and floors against columns.
#include "bentur/model/gap/gap_outcome.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "bentur/model/case.h"
#include "bentur/pounding/pounding.h"
#include "bentur/structure/frame/condensation.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double modulus = 2.5e7;  // [kN/m²]

/// A concrete frame of one bay [m, kN, t].
PlaneFrame concrete_frame(const std::vector<double>& heights, double column_depth, MassMatrix mass_matrix) {
  PlaneFrame frame;
  frame.elastic_modulus = modulus;
  frame.storey_heights = heights;
  frame.bay_widths = {6.0};
  for (const double height : heights) {
    frame.columns.push_back({.area = 0.4 * column_depth,
                             .inertia = 0.4 * std::pow(column_depth, 3) / 12,
                             .mass = 2.5 * 0.4 * column_depth * height});
    frame.beams.push_back({.area = 0.15, .inertia = 0.3 * 0.125 / 12, .mass = 2.2});
    frame.floor_masses.push_back(28.0);
  }
  frame.mass_matrix = mass_matrix;
  return frame;
}

BuildingSpec spec(std::string name, decltype(BuildingSpec::structure) structure) {
  BuildingSpec building;
  building.name = std::move(name);
  building.structure = std::move(structure);
  building.damping = ModalDamping{{0.05}};
  return building;
}

/// A jagged motion that fades in and out; its strongest shaking is near 1 s, the buildings' first periods.
SampledMotion jagged_motion() {
  SampledMotion motion;
  motion.time_step = 0.02;
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  double smooth = 0;
  for (int n = 0; n < 800; ++n) {
    smooth += 0.15 * (normal(random) - smooth);
    motion.acceleration.push_back(1.5 * smooth * std::sin(3.14159265 * n / 800));
  }
  return motion;
}

/// Two buildings with a linear contact at the floors that meet, at a width.
Case pair_of(BuildingSpec left, BuildingSpec right, double width) {
  Case c;
  c.buildings = {std::move(left), std::move(right)};
  GapSpec gap;
  gap.contact.numbers["stiffness"] = {1e5};
  const StructuralModel a = structural_model(c.buildings[0]), b = structural_model(c.buildings[1]);
  for (const LevelPair& pair : level_floors(levels_of(a), levels_of(b))) gap.elevations.push_back(pair.elevation);
  gap.widths.assign(std::max<std::size_t>(gap.elevations.size(), 1), width);
  c.gaps = {gap};
  c.excitation.motion = jagged_motion();
  c.excitation.delays = {0, 0};
  c.analysis.duration = 16;
  return c;
}

std::vector<double> storeys(int count, double height) {
  return std::vector<double>(static_cast<std::size_t>(count), height);
}

TEST(NearlyLevelFloors, AnswerAsLevelOnes) {
  const auto run = [](double storey, double width) {
    std::vector<double> heights = storeys(5, 3.5);
    heights[1] = storey;  // so do all floors above
    const Case c = pair_of(spec("A", concrete_frame(storeys(8, 3.5), 0.5, MassMatrix::consistent)),
                           spec("B", concrete_frame(heights, 0.7, MassMatrix::consistent)), width);
    EXPECT_EQ(c.gaps[0].elevations.size(), 5U);
    const Problem problem = make_problem(c);
    EXPECT_TRUE(problem.watched.empty());
    const Response response = solve(problem);
    return std::tuple(gap_needed(problem, response, 0), response.points[4].peak_force, response.points[4].impacts);
  };
  const auto [level_need, level_force, level_impacts] = run(3.5, 0.04);
  const auto [near_need, near_force, near_impacts] = run(3.502, 0.04);
  ASSERT_GT(level_need, 0.05);
  ASSERT_GT(level_impacts, 0);
  EXPECT_NEAR(near_need, level_need, 0.01 * level_need);
  EXPECT_NEAR(near_force, level_force, 0.01 * level_force);
  EXPECT_EQ(near_impacts, level_impacts);
}

TEST(NearlyLevelFloors, MeetAtTheMeanElevation) {
  const Case c = pair_of(spec("A", Stick{{3.5, 3.5}, {30, 30}, {4e4, 4e4}}),
                         spec("B", Stick{{3.502, 3.5}, {20, 20}, {6e4, 6e4}}), 0.01);
  const Problem problem = make_problem(c);
  ASSERT_EQ(problem.points.size(), 2U);
  EXPECT_DOUBLE_EQ(problem.points[0].elevation, 3.501);
  EXPECT_DOUBLE_EQ(problem.points[1].elevation, 7.001);
  EXPECT_EQ(problem.points[1].left_floor, 1);
}

/// A member's matrix (2-48) or, for its mass, (2-50), between dofs.
void add_member(MatrixXd& matrix, const Eigen::Matrix4d& member, const std::array<Index, 4>& dofs, double sign) {
  for (Index i = 0; i < 4; ++i) {
    for (Index j = 0; j < 4; ++j) {
      matrix(dofs[static_cast<std::size_t>(i)], dofs[static_cast<std::size_t>(j)]) += sign * member(i, j);
    }
  }
}

Eigen::Matrix4d member_stiffness(double rigidity, double l) {
  Eigen::Matrix4d k;
  k << 12, 6 * l, -12, 6 * l, 6 * l, 4 * l * l, -6 * l, 2 * l * l, -12, -6 * l, 12, -6 * l, 6 * l, 2 * l * l, -6 * l,
      4 * l * l;
  return rigidity / (l * l * l) * k;
}

Eigen::Matrix4d member_mass(double mass, double l) {
  Eigen::Matrix4d m;
  m << 156, 22 * l, 54, -13 * l, 22 * l, 4 * l * l, 13 * l, -3 * l * l, 54, 13 * l, 156, -22 * l, -13 * l, -3 * l * l,
      -22 * l, 4 * l * l;
  return mass / 420 * m;
}

/// The frame with one node more, in its left column line at `elevation` in storey `storey` (0 the lowest, not that):
/// a sway and a rotation, the column above and below it with its own mass. Rotations are condensed statically.
MatricesSpec with_node(const PlaneFrame& frame, std::size_t storey, double elevation) {
  const StructuralModel whole = assemble_plane_frame(frame);
  const Index floors = whole.floors(), rotations = whole.dofs() - floors, n = whole.dofs() + 2;
  const auto s = static_cast<Index>(storey);
  // Sways with the new one in its place from below, then rotations with the new one last.
  const auto place = [&](Index old) { return old < s ? old : old + 1; };
  const auto rotation = [&](Index floor) { return floors + 1 + floor * (rotations / floors); };  // of the left line
  MatrixXd stiffness = MatrixXd::Zero(n, n), mass = MatrixXd::Zero(n, n);
  for (Index i = 0; i < whole.dofs(); ++i) {
    for (Index j = 0; j < whole.dofs(); ++j) {
      stiffness(place(i), place(j)) = whole.stiffness(i, j);
      mass(place(i), place(j)) = whole.mass(i, j);
    }
  }
  const double height = frame.storey_heights[storey];
  const double below = elevation - whole.elevations[storey - 1];
  const Section& column = frame.columns[storey];
  const double rigidity = frame.elastic_modulus * column.inertia;
  const std::array<Index, 4> old = {s - 1, rotation(s - 1), s + 1, rotation(s)};
  const std::array<Index, 4> lower = {s - 1, rotation(s - 1), s, n - 1};
  const std::array<Index, 4> upper = {s, n - 1, s + 1, rotation(s)};
  add_member(stiffness, member_stiffness(rigidity, height), old, -1);
  add_member(stiffness, member_stiffness(rigidity, below), lower, 1);
  add_member(stiffness, member_stiffness(rigidity, height - below), upper, 1);
  const double part = below / height;
  add_member(mass, member_mass(column.mass, height), old, -1);
  add_member(mass, member_mass(part * column.mass, below), lower, 1);
  add_member(mass, member_mass((1 - part) * column.mass, height - below), upper, 1);
  StructuralModel model;
  model.elevations = whole.elevations;
  model.elevations.insert(model.elevations.begin() + static_cast<std::ptrdiff_t>(storey), elevation);
  model.storey_heights.assign(model.elevations.size(), 1.0);
  model.mass = mass;
  model.stiffness = stiffness;
  model.load = mass.leftCols(floors + 1).rowwise().sum();
  const StructuralModel reduced = condense_statically(model, floors + 1);
  return {model.elevations, reduced.mass, reduced.stiffness};
}

// 8 × 3.0 m beside 8 × 3.5 m: the lower roof, at 24 m, faces a column between floors at 21 and 24.5 m.
TEST(WatchedFloor, NeedsTheGapOfAFrameWithANodeThere) {
  const BuildingSpec low = spec("low", concrete_frame(storeys(8, 3.0), 0.5, MassMatrix::consistent));
  const PlaneFrame tall = concrete_frame(storeys(8, 3.5), 0.75, MassMatrix::consistent);
  const Case with = pair_of(low, spec("tall", with_node(tall, 6, 24.0)), 0.02);
  ASSERT_EQ(with.gaps[0].elevations, (std::vector<double>{21, 24}));
  const Problem noded = make_problem(with);
  const double expected = solve(noded).points[1].gap_needed;
  ASSERT_GT(expected, 0.05);
  for (const Condensation condensation : {Condensation::static_, Condensation::dynamic, Condensation::none}) {
    PlaneFrame frame = tall;
    frame.condensation = condensation;
    const Case c = pair_of(low, spec("tall", frame), 0.02);
    const Problem problem = make_problem(c);
    ASSERT_EQ(problem.points.size(), 1U);
    const Response response = solve(problem);
    const std::vector<Eigen::Index> floors = gap_at(problem, 0).watched;
    const std::size_t roof = floors.back();
    EXPECT_EQ(problem.watched[roof].floor_of, 0);
    EXPECT_EQ(problem.watched[roof].elevation, 24.0);
    EXPECT_NEAR(response.watched[roof].gap_needed, expected, 0.02 * expected);
    EXPECT_GE(gap_needed(problem, response, 0), response.watched[roof].gap_needed);
    // More than the floors that meet need, which was all that was told.
    EXPECT_GT(gap_needed(problem, response, 0), 1.05 * response.points[0].gap_needed);
    EXPECT_EQ(governing_level(problem, response, 0).watched, roof);
    EXPECT_TRUE(response.watched[roof].closes);
    EXPECT_EQ(unmodelled_contacts(problem, response.watched, 0).front(), roof);
  }
}

// The same elsewhere in storeys. They agree to 5e-6: the column's own mass bends it a little more. A straight line
// between the floors would be 1e-3 off.
TEST(WatchedFloor, FollowsTheBentColumn) {
  const BuildingSpec low = spec("low", concrete_frame(storeys(8, 3.0), 0.5, MassMatrix::consistent));
  const PlaneFrame tall = concrete_frame(storeys(8, 3.5), 0.75, MassMatrix::consistent);
  const Problem problem = make_problem(pair_of(low, spec("tall", tall), 0.02));
  const Response response = solve(problem);
  for (const auto& [storey, elevation] : {std::pair(1, 6.0), std::pair(2, 9.0), std::pair(3, 12.0)}) {
    const Problem noded =
        make_problem(pair_of(low, spec("tall", with_node(tall, static_cast<std::size_t>(storey), elevation)), 0.02));
    ASSERT_EQ(noded.points[0].elevation, elevation);
    const double expected = solve(noded).points[0].gap_needed;
    const auto floor = std::find_if(problem.watched.begin(), problem.watched.end(),
                                    [at = elevation](const WatchedFloor& one) { return one.elevation == at; });
    const double needed = response.watched[static_cast<std::size_t>(floor - problem.watched.begin())].gap_needed;
    EXPECT_NEAR(needed, expected, 1e-4 * expected) << elevation;
  }
}

TEST(WatchedFloors, AreThoseThatFaceTheNeighbourWithoutAContact) {
  // Floors at 3 6 9 12 and, on a base at 2, at 5.5 9 12.5: 9 meets 9; 12 and 12.5 differ by more than a tenth of 3.
  BuildingSpec b = spec("B", Stick{{3.5, 3.5, 3.5}, {20, 20, 20}, {6e4, 6e4, 6e4}});
  b.base_elevation = 2;
  Case c = pair_of(spec("A", Stick{{3, 3, 3, 3}, {30, 30, 30, 30}, {4e4, 4e4, 4e4, 4e4}}), b, 0.01);
  const auto elevations = [&] {
    std::vector<std::pair<int, double>> found;
    for (const WatchedFloor& floor : make_problem(c).watched) found.emplace_back(floor.floor_of, floor.elevation);
    return found;
  };
  // 12.5 is above A's roof.
  EXPECT_EQ(elevations(), (std::vector<std::pair<int, double>>{{0, 3}, {1, 5.5}, {0, 6}, {0, 12}}));
  c.gaps[0].level_tolerance = 0.6;  // 5.5 meets 6, 12 meets 12.5, but they are not among the elevations
  EXPECT_EQ(elevations(), (std::vector<std::pair<int, double>>{{0, 3}, {0, 5.75}, {0, 12.25}}));
  EXPECT_EQ(make_problem(c).watched[1].facing_floor, 0);
  c.gaps[0].elevations = {5.75, 9, 12.25};
  c.gaps[0].widths = {0.01, 0.02, 0.03};
  EXPECT_EQ(elevations(), (std::vector<std::pair<int, double>>{{0, 3}}));
  c.buildings[1].base_elevation = 3.5;  // floors at 7 10.5 14: that at 3 is below its base
  c.gaps[0] = {.widths = {0.01}, .elevations = {}, .contact = {}, .level_tolerance = {}};
  EXPECT_EQ(elevations(), (std::vector<std::pair<int, double>>{{0, 6}, {1, 7}, {0, 9}, {1, 10.5}, {0, 12}}));
}

TEST(WatchedWidth, IsTheSmallerOfThePointsAboveAndBelow) {
  std::vector<ContactPoint> points(3);
  const double widths[] = {0.05, 0.02, 0.04};
  for (std::size_t i = 0; i < 3; ++i) {
    points[i].elevation = 3.0 * static_cast<double>(i + 1);
    points[i].width = widths[i];
  }
  EXPECT_EQ(watched_width(points, 0, 1), 0.05);
  EXPECT_EQ(watched_width(points, 0, 4), 0.02);
  EXPECT_EQ(watched_width(points, 0, 8), 0.02);
  EXPECT_EQ(watched_width(points, 0, 10), 0.04);
  EXPECT_EQ(watched_width(points, 0, 9), 0.04);
  EXPECT_FALSE(watched_width(points, 1, 4).has_value());
}

// A's roof at 6 faces the column of B between 4.2 and 7.5: what to do depends on whether B has columns.
TEST(RemedyFor, AColumnCanBeStruckWhereItsBuildingIsAFrame) {
  const PlaneFrame frame = concrete_frame({4.2, 3.3}, 0.5, MassMatrix::consistent);
  Case c = pair_of(spec("A", Stick{{3, 3}, {30, 30}, {4e4, 4e4}}), spec("B", frame), 0.01);
  c.gaps[0] = {.widths = {0.01}, .elevations = {}, .contact = {}, .level_tolerance = {}};
  Problem problem = make_problem(c);
  const auto roof = std::find_if(problem.watched.begin(), problem.watched.end(),
                                 [](const WatchedFloor& floor) { return floor.elevation == 6; });
  ASSERT_NE(roof, problem.watched.end());
  EXPECT_EQ(remedy_for(problem, *roof).kind, Remedy::Kind::strike_column);
  EXPECT_EQ(remedy_text(problem, *roof, "m"),
            "gap.strikes_columns = true with 6 among gap.elevations lets it strike the column of B there");
  c.buildings[1].structure = Stick{{4.2, 3.3}, {20, 20}, {6e4, 6e4}};
  problem = make_problem(c);
  EXPECT_EQ(remedy_text(problem, problem.watched[2], "m"),
            "give B as building.frame, whose column it can strike with gap.strikes_columns = true and 6 among "
            "gap.elevations, or as building.matrices with a floor at level 6 m");
}

// The slab of A on bearings, at 0, faces the base of B.
TEST(RemedyFor, ABaseIsNoFloor) {
  BuildingSpec a = spec("A", Stick{{3, 3}, {30, 30}, {4e4, 4e4}});
  a.isolation = IsolationSpec{.mass = 30, .numbers = {{"stiffness", 500}}};
  const Problem problem = make_problem(pair_of(a, spec("B", Stick{{3, 3}, {20, 20}, {6e4, 6e4}}), 0.01));
  ASSERT_EQ(problem.watched.size(), 1U);
  EXPECT_EQ(problem.watched[0].elevation, 0);
  EXPECT_TRUE(faces_base(problem, problem.watched[0]));
  EXPECT_EQ(faced_text(problem, problem.watched[0]), "the base of B");
  for (const bool in_plan : {false, true}) {
    EXPECT_EQ(remedy_for(problem, problem.watched[0], in_plan).kind, Remedy::Kind::give_wall);
    EXPECT_EQ(remedy_text(problem, problem.watched[0], "m", in_plan),
              "a base cannot be struck: a case with a wall (rigid = true) in place of B shows what it does");
  }
}

TEST(RemedyFor, SaysWhatACaseCanDo) {
  Case c = pair_of(spec("A", Stick{{3, 3, 3}, {30, 30, 30}, {4e4, 4e4, 4e4}}),
                   spec("B", Stick{{3, 3.5, 3.5, 3}, {20, 20, 20, 20}, {6e4, 6e4, 6e4, 6e4}}), 0.01);
  Problem problem = make_problem(c);  // A at 3 6 9, B at 3 6.5 10 13
  ASSERT_EQ(problem.watched.size(), 3U);
  EXPECT_EQ(problem.watched[0].elevation, 6);
  const Remedy near = remedy_for(problem, problem.watched[0]);
  EXPECT_EQ(near.kind, Remedy::Kind::raise_tolerance);
  EXPECT_EQ(near.level, 6.5);
  c.gaps[0].level_tolerance = near.tolerance;
  c.gaps[0].elevations = {3, 6};
  c.gaps[0].widths = {0.01, 0.01};
  problem = make_problem(c);
  EXPECT_EQ(problem.points.size(), 2U);
  EXPECT_EQ(problem.points[1].elevation, 6.25);
  ASSERT_EQ(problem.watched.size(), 1U);  // A's roof at 9 is 1 m from a floor
  EXPECT_EQ(remedy_for(problem, problem.watched[0]).kind, Remedy::Kind::give_columns);
  c.gaps[0].elevations = {6};
  c.gaps[0].widths = {0.01};
  problem = make_problem(c);
  EXPECT_EQ(remedy_for(problem, problem.watched[0]).kind, Remedy::Kind::name_elevation);
  EXPECT_EQ(remedy_for(problem, problem.watched[0]).level, 3);
}

}  // namespace
}  // namespace bentur
