// Pairs and corners of buildings in plan by chance, with and without friction: `exact` against `adaptive`, the energy,
// and what must change nothing: the order of the buildings, the place of the plan, its units.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bentur/contact/laws/bilinear.h"
#include "bentur/contact/laws/kelvin_voigt.h"
#include "bentur/contact/laws/kelvin_voigt_approach.h"
#include "bentur/contact/laws/linear.h"
#include "bentur/contact/laws/rubbing.h"
#include "bentur/pounding/plan/plan_pounding.h"
#include "tests/support/random_numbers.h"

namespace bentur::random_plans {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// `length` and `force` new units in an old one.
struct UnitChange {
  double length = 1, force = 1;
  [[nodiscard]] double mass() const { return force / length; }
  [[nodiscard]] double stiffness() const { return force / length; }
};

/// How a plan is told: nothing of it may change what happens.
struct Told {
  UnitChange units = {};
  PlanPoint shift = PlanPoint::Zero();                ///< [new length]
  bool backwards = false;                             ///< the order of the buildings
  Eigen::Matrix2d map = Eigen::Matrix2d::Identity();  ///< a quarter turn, a mirror
  [[nodiscard]] bool swaps() const { return map(0, 0) == 0; }
  [[nodiscard]] PlanPoint place(const PlanPoint& at) const { return units.length * (map * at) + shift; }
};

/// What a plan is drawn from; in m, kN, s.
struct Draw {
  std::vector<Plan> plans;
  int law = 0, points = 2;
  double stiffness = 0, friction = 0, tangential = 0, damping = 0.05, clearance = 0;
  std::array<GroundMotion, 2> motions;
  Eigen::Matrix2d axes = Eigen::Matrix2d::Identity();
  std::vector<double> delays;
  bool absolute = false;
};

class Generator {
 public:
  explicit Generator(unsigned seed) : engine_(seed) {}

  Draw make() {
    Draw draw;
    const double gap = chance(0.2) ? 0 : any(0.002, 0.02);
    const PlanPoint first(any(8, 16), any(8, 18)), second(any(8, 16), any(8, 18));
    double shift = any(-0.6, 0.6) * std::min(first.y(), second.y());
    if (chance(0.3)) shift = chance(0.5) ? first.y() + any(-0.03, 0.02) : -second.y() + any(-0.02, 0.03);
    draw.plans.push_back(building({0, 0}, first));
    draw.plans.push_back(building({first.x() + gap, shift}, second));
    if (chance(0.4)) {  // around the corner
      const double other = any(0.002, 0.02);
      draw.plans.push_back(building({any(-6, 0), first.y() + other}, {6 + any(1, 5), any(8, 14)}));
      if (overlap(draw.plans[1].footprint, draw.plans[2].footprint)) draw.plans.pop_back();
    }
    draw.clearance = 0.021;
    draw.law = among(0, 3);
    draw.points = among(2, 4);
    draw.stiffness = std::pow(10, any(4.8, 6));
    if (chance(0.7)) draw.friction = any(0.05, 0.8);
    draw.tangential = any(0.3, 1.2) * draw.stiffness;
    draw.damping = any(0.01, 0.06);
    for (GroundMotion& motion : draw.motions) {
      motion = HarmonicMotion{.period = any(0.25, 0.8),
                              .displacement_amplitude = any(0.005, 0.03),
                              .phase = chance(0.5) ? HarmonicMotion::Phase::sine : HarmonicMotion::Phase::cosine};
    }
    if (chance(0.3)) draw.motions[1] = NoMotion{};
    const double angle = any(0, 6);
    draw.axes << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    if (chance(0.3)) {
      for (std::size_t b = 0; b < draw.plans.size(); ++b) draw.delays.push_back(any(0, 0.05));
    }
    draw.absolute = chance(0.4);
    for (Plan& plan : draw.plans) {
      if (chance(0.3)) stand_on_soil(plan);
    }
    return draw;
  }

 private:
  double any(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
  int among(int from, int to) { return std::uniform_int_distribution<int>(from, to)(engine_); }
  bool chance(double of) { return any(0, 1) < of; }

  std::vector<double> storeys(std::size_t count, double from, double to) {
    std::vector<double> list(count);
    for (double& value : list) value = any(from, to);
    return list;
  }

  PlanPlane plane(std::size_t count, const PlanPoint& through, double angle) {
    return {.name = "",
            .through = through,
            .direction = {std::cos(angle), std::sin(angle)},
            .storeys = {.storey_heights = {}, .masses = {}, .stiffnesses = storeys(count, 1e4, 8e4)}};
  }

  Plan building(const PlanPoint& corner, const PlanPoint& size) {
    const auto count = static_cast<std::size_t>(among(1, 3));
    Plan plan{.footprint = {.corner = corner, .size = size},
              .storey_heights = std::vector<double>(count, 3.0),
              .masses = storeys(count, 60, 300)};
    if (chance(0.6)) plan.centres_of_mass = {size.cwiseProduct(PlanPoint(any(0.35, 0.65), any(0.35, 0.65)))};
    plan.planes = {plane(count, {0, any(0, 0.4) * size.y()}, 0), plane(count, {0, any(0.6, 1) * size.y()}, 0),
                   plane(count, {any(0, 1) * size.x(), 0}, any(1.2, 1.9))};
    return plan;
  }

  Impedance impedance(double stiffness) {
    const double k = any(0.5, 3) * stiffness;
    return {k, any(0, 0.02) * k};
  }

  /// About as soft as the storeys, under the weight of the floors in half of all cases.
  void stand_on_soil(Plan& plan) {
    PlanSoil soil{.sway_x = impedance(1e5),
                  .sway_y = impedance(1e5),
                  .rocking_x = impedance(1e7),
                  .rocking_y = impedance(1e7),
                  .mass = any(20, 100),
                  .inertia_x = any(200, 900),
                  .inertia_y = any(200, 900)};
    if (chance(0.7)) {
      soil.twist = impedance(5e6);
      soil.twist_inertia = any(500, 3000);
    }
    plan.soil = soil;
    if (chance(0.5)) return;
    for (const double mass : plan.masses) plan.gravity_loads.push_back(9.81 * mass);
  }

  std::mt19937 engine_;
};

void in_words(const Told& told, PlanSoil& soil) {
  const double k = told.units.stiffness(), m = told.units.mass(), arms = std::pow(told.units.length, 2);
  if (told.swaps()) {
    std::swap(soil.sway_x, soil.sway_y);
    std::swap(soil.rocking_x, soil.rocking_y);
    std::swap(soil.inertia_x, soil.inertia_y);
  }
  const auto scaled = [](Impedance& of, double factor) { of = {factor * of.stiffness, factor * of.damping}; };
  for (Impedance* const of : {&soil.sway_x, &soil.sway_y}) scaled(*of, k);
  for (Impedance* const of : {&soil.rocking_x, &soil.rocking_y}) scaled(*of, k * arms);
  if (soil.twist) scaled(*soil.twist, k * arms);
  soil.mass *= m;
  for (double* const inertia : {&soil.inertia_x, &soil.inertia_y, &soil.twist_inertia}) *inertia *= m * arms;
}

std::shared_ptr<const ContactLaw> law_of(const Draw& draw, double share, double mass, const UnitChange& units) {
  const double k = share * draw.stiffness * units.stiffness();
  if (draw.law == 0) return std::make_shared<Linear>(k);
  if (draw.law == 1) return std::make_shared<Bilinear>(k, 0.4 * k, 2e-3 * units.length);
  if (draw.law == 2) return std::make_shared<KelvinVoigt>(k, 0.2, share * mass, KelvinVoigt::Release::zero_force);
  return std::make_shared<KelvinVoigtApproach>(k, 0.2, share * mass);
}

Plan in_words(Plan plan, const Told& told) {
  const auto scaled = [](std::vector<double>& list, double factor) {
    for (double& value : list) value *= factor;
  };
  const UnitChange& units = told.units;
  const Footprint from = plan.footprint;
  plan.footprint.corner = told.place(from.corner).cwiseMin(told.place(from.far_corner()));
  plan.footprint.size = units.length * (told.map.cwiseAbs() * from.size);
  const auto local = [&](const PlanPoint& at) -> PlanPoint {
    return told.place(from.corner + at) - plan.footprint.corner;
  };
  for (PlanPoint& centre : plan.centres_of_mass) centre = local(centre);
  scaled(plan.storey_heights, units.length);
  scaled(plan.masses, units.mass());
  scaled(plan.gravity_loads, units.force);
  if (plan.soil) in_words(told, *plan.soil);
  for (PlanPlane& plane : plan.planes) {
    plane.through = local(plane.through);
    plane.direction = told.map * plane.direction;
    scaled(plane.storeys.stiffnesses, units.stiffness());
  }
  return plan;
}

PlanProblem problem_of(const Draw& draw, const Told& told = {}) {
  PlanProblem problem;
  const std::size_t count = draw.plans.size();
  std::vector<Plan> plans;
  for (std::size_t b = 0; b < count; ++b) {
    const std::size_t from = told.backwards ? count - 1 - b : b;
    plans.push_back(in_words(draw.plans[from], told));
    problem.buildings.push_back(make_plan_building("B" + std::to_string(from), plan_model(plans.back()),
                                                   ModalDamping{{draw.damping}}, false, plans.back().soil));
    if (!draw.delays.empty()) problem.delays.push_back(draw.delays[from]);
  }
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = a + 1; b < count; ++b) {
      const auto stretch = joint_between(plans[a].footprint, plans[b].footprint);
      if (!stretch || stretch->width > draw.clearance * told.units.length) continue;
      PlanGap gap{.left = static_cast<Index>(a), .right = static_cast<Index>(b), .stretch = *stretch};
      if (stretch->swapped) std::swap(gap.left, gap.right);
      const PlanModel &left = problem.buildings[gap.left].model, &right = problem.buildings[gap.right].model;
      for (Index floor = 0; floor < std::min(left.floors(), right.floors()); ++floor) {
        const double one = left.floor_masses[floor], other = right.floor_masses[floor];
        for (const StretchPoint& point : points_between(plans[gap.left].footprint, plans[gap.right].footprint, *stretch,
                                                        draw.points, 0.05 * left.elevations[floor])) {
          PlanContact contact{floor, floor, left.elevations[floor], point.along,
                              law_of(draw, point.share, one * other / (one + other), told.units)};
          if (draw.friction > 0) {
            contact.rubbing = std::make_shared<Rubbing>(contact.law, draw.friction,
                                                        point.share * draw.tangential * told.units.stiffness());
          }
          contact.family = point.family;
          contact.beside = point.beside;
          gap.contacts.push_back(contact);
        }
      }
      // At both ends the lowest floors of both against the other's edge between base and floor, and against each other.
      for (const double end : stretch->corners_along()) {
        for (const Index of : {gap.left, gap.right}) {
          gap.watched.push_back({.floor_of = of, .elevation = 2 * told.units.length, .along = end});
        }
        gap.watched.push_back({.floor_of = gap.left, .facing_floor = 0, .elevation = left.elevations[0], .along = end});
      }
      problem.gaps.push_back(std::move(gap));
    }
  }
  problem.motions = draw.motions;
  for (GroundMotion& motion : problem.motions) {
    if (auto* harmonic = std::get_if<HarmonicMotion>(&motion)) harmonic->displacement_amplitude *= told.units.length;
  }
  problem.axes = told.map * draw.axes;
  problem.kinematics = draw.absolute ? Kinematics::absolute : Kinematics::relative;
  problem.duration = 3;
  return problem;
}

/// How far two responses to one plan are apart, relative to the largest of a kind.
struct Apart {
  double size = 0;
  std::string what;
  void note(double one, double other, double scale, const std::string& of) {
    const double by = one == other ? 0 : std::abs(one - other) / scale;
    if (!(by <= size)) {
      size = std::isnan(by) ? std::numeric_limits<double>::infinity() : by;
      what = of + ": " + std::to_string(one) + " and " + std::to_string(other);
    }
  }
};

double most(const std::vector<PlanPeaks>& buildings, VectorXd PlanPeaks::*list) {
  double largest = std::numeric_limits<double>::min();
  for (const PlanPeaks& peaks : buildings) largest = std::max(largest, (peaks.*list).maxCoeff());
  return largest;
}

/// The contact at this place across a direction or its opposite, among those of all gaps.
Index contact_at(const PlanProblem& problem, double elevation, const PlanPoint& at, const PlanPoint& normal) {
  Index i = 0, nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const PlanGap& gap : problem.gaps) {
    for (const PlanContact& contact : gap.contacts) {
      const PlanPoint there = gap.middle(contact), n = gap.at(contact).normal;
      const double distance = (there - at).norm() + std::abs(contact.elevation - elevation);
      const bool is_along = std::abs(n.x() * normal.y() - n.y() * normal.x()) < 1e-6;
      if (is_along && distance < least) {
        least = distance;
        nearest = i;
      }
      ++i;
    }
  }
  return nearest;
}

/// What is watched there, of a floor of this building, among that of all gaps.
Index watched_at(const PlanProblem& problem, const std::string& building, double elevation, const PlanPoint& at) {
  Index i = 0, nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const PlanGap& gap : problem.gaps) {
    for (const PlanWatched& watched : gap.watched) {
      const double distance = (gap.stretch.middle(watched.along) - at).norm() + std::abs(watched.elevation - elevation);
      const bool alike = watched.facing_floor || problem.buildings[watched.floor_of].name == building;
      if (alike && distance < least) {
        least = distance;
        nearest = i;
      }
      ++i;
    }
  }
  return nearest;
}

/// Needs both ways round, and how far both sides go, whichever stands left.
template <class Summary>
void note_level(const Summary& one, const Summary& same, double length, double scale, Apart& result) {
  result.note(one.gap_needed, same.gap_needed / length, scale, "gap needed");
  result.note(one.gap_needed_reversed.value_or(-1), same.gap_needed_reversed.value_or(-length) / length, scale,
              "gap needed reversed");
  const auto [least, most] = std::minmax(one.peak_left, one.peak_right);
  const auto [less, more] = std::minmax(same.peak_left, same.peak_right);
  if (std::isnan(least)) return;
  result.note(least, less / length, scale, "the side that goes less far");
  result.note(most, more / length, scale, "the side that goes further");
}

Apart apart(const PlanProblem& problem, const PlanResponse& wanted, const PlanProblem& other, const PlanResponse& found,
            const Told& told = {}) {
  Apart result;
  if (wanted.impacts.size() != found.impacts.size()) return {std::numeric_limits<double>::infinity(), "impacts"};
  const double length = told.units.length, force = told.units.force;
  const std::size_t count = wanted.buildings.size();
  struct Kind {
    VectorXd PlanPeaks::*list;
    VectorXd PlanPeaks::*swapped;  ///< where x becomes y
    double factor;
    const char* name;
  };
  const std::vector<Kind> kinds = {
      {&PlanPeaks::x, &PlanPeaks::y, length, "x"},
      {&PlanPeaks::y, &PlanPeaks::x, length, "y"},
      {&PlanPeaks::rotation, &PlanPeaks::rotation, 1, "rotation"},
      {&PlanPeaks::acceleration_x, &PlanPeaks::acceleration_y, length, "acceleration x"},
      {&PlanPeaks::angular_acceleration, &PlanPeaks::angular_acceleration, 1, "angular acceleration"},
      {&PlanPeaks::shear_y, &PlanPeaks::shear_x, force, "shear y"},
      {&PlanPeaks::torque, &PlanPeaks::torque, force * length, "torque"}};
  for (const Kind& kind : kinds) {
    const auto list = told.swaps() ? kind.swapped : kind.list;
    for (std::size_t b = 0; b < count; ++b) {
      const PlanPeaks& mine = found.buildings[told.backwards ? count - 1 - b : b];
      for (Index f = 0; f < (wanted.buildings[b].*kind.list).size(); ++f) {
        result.note((wanted.buildings[b].*kind.list)(f), (mine.*list)(f) / kind.factor,
                    most(wanted.buildings, kind.list), kind.name);
      }
    }
  }
  for (std::size_t b = 0; b < count; ++b) {
    const VectorXd &one = wanted.buildings[b].foundation,
                   &same = found.buildings[told.backwards ? count - 1 - b : b].foundation;
    if (one.size() != same.size()) return {std::numeric_limits<double>::infinity(), "foundations"};
    for (Index i = 0; i < one.size(); ++i) {
      const Index there = told.swaps() && i < 4 ? i ^ 1 : i;
      const double of = i < 2 ? length : 1, most = i < 2 ? one.head<2>().maxCoeff() : one.tail<3>().maxCoeff();
      result.note(one(i), same(there) / of, most, "foundation");
    }
  }
  double impulse = std::numeric_limits<double>::min(), largest = impulse, needed = impulse;
  for (const PointSummary& point : wanted.points) {
    impulse = std::max(impulse, point.impulse);
    largest = std::max(largest, point.peak_force);
    needed = std::max(needed, point.gap_needed);
  }
  Index first = 0;
  for (const PlanGap& gap : problem.gaps) {
    for (Index i = 0; i < std::ssize(gap.contacts); ++i) {
      const PlanContact& contact = gap.contacts[i];
      const Index there = contact_at(other, length * contact.elevation, told.place(gap.middle(contact)),
                                     told.map * gap.at(contact).normal);
      const PointSummary &one = wanted.points[first + i], &same = found.points[there];
      if (one.impacts != same.impacts) return {std::numeric_limits<double>::infinity(), "impacts of a point"};
      result.note(one.impulse, same.impulse / force, impulse, "impulse");
      result.note(one.peak_force, same.peak_force / force, largest, "force");
      note_level(one, same, length, needed, result);
      const PlanFriction &rubs = wanted.friction[first + i], &too = found.friction[there];
      // Its sign is that of t, which a map turns.
      result.note(std::abs(rubs.tangential_impulse), std::abs(too.tangential_impulse) / force, impulse,
                  "along the joint");
      result.note(rubs.friction_loss, too.friction_loss / (force * length), wanted.energy->peak_input, "friction loss");
    }
    first += std::ssize(gap.contacts);
  }
  first = 0;
  for (const PlanGap& gap : problem.gaps) {
    for (const PlanWatched& watched : gap.watched) {
      const Index there = watched_at(other, problem.buildings[watched.floor_of].name, length * watched.elevation,
                                     told.place(gap.stretch.middle(watched.along)));
      const WatchedSummary &one = wanted.watched[first++], &same = found.watched[there];
      note_level(one, same, length, needed, result);
      result.note(one.least_opening, same.least_opening / length, needed, "least opening");
    }
  }
  return result;
}

/// First and last seed; of BENTUR_RANDOM_PLANS "FROM:TO" where that is set.
std::pair<unsigned, unsigned> seeds() { return test::seeds_of("BENTUR_RANDOM_PLANS", {1, 30}, {1, 8}); }

constexpr double moved_by = 1e-12;

/// How many times larger the response moves than masses and contact stiffnesses that are moved by 1e-12.
double sensitivity(const Draw& draw, const PlanProblem& problem, const PlanResponse& wanted) {
  Draw moved = draw;
  moved.stiffness *= 1 + moved_by;
  for (Plan& plan : moved.plans) {
    for (double& mass : plan.masses) mass *= 1 - moved_by;
  }
  const PlanProblem other = problem_of(moved);
  const PlanResponse found = solve(other, ExactSolver{}, {.both_ways = true});
  return apart(problem, wanted, other, found).size / moved_by;
}

TEST(RandomPlans, BothSolversEnergyAndWhatChangesNothing) {
  const auto [first, last] = seeds();
  int impacts = 0, rubbed = 0, sensitive = 0, fallen = 0;
  double worst_solver = 0, worst_told = 0, worst_energy = 0;
  int watched = 0;
  for (unsigned seed = first; seed <= last; ++seed) {
    SCOPED_TRACE("BENTUR_RANDOM_PLANS=" + std::to_string(seed) + ":" + std::to_string(seed));
    const Draw draw = Generator(seed).make();
    const PlanProblem problem = problem_of(draw);
    ASSERT_FALSE(problem.gaps.empty());
    const PlanResponse exact = solve(problem, ExactSolver{}, {.both_ways = true, .energy_audit = true});
    if (exact.status == Status::collapsed) {  // few are drawn so: how they end is compared, and nothing else
      ++fallen;
      const PlanResponse adaptive = solve(problem, AdaptiveSolver{.tolerance = 1e-12});
      ASSERT_TRUE(exact.collapse && adaptive.collapse);
      EXPECT_EQ(adaptive.collapse->building, exact.collapse->building);
      EXPECT_EQ(adaptive.collapse->storey, exact.collapse->storey);
      EXPECT_NEAR(adaptive.collapse->time, exact.collapse->time, 1e-8 * problem.duration);
      continue;
    }
    ASSERT_EQ(exact.status, Status::done) << exact.message;
    EXPECT_TRUE(exact.discrepancies.empty());
    worst_energy = std::max(worst_energy, exact.energy->relative_residual());
    EXPECT_LE(exact.energy->relative_residual(), 1e-12);
    impacts += static_cast<int>(exact.impacts.size());
    for (const Impact& impact : exact.impacts) {
      EXPECT_GE(impact.energy_lost, -1e-12 * exact.energy->peak_input);
      EXPECT_GE(impact.friction_loss, -1e-12 * exact.energy->peak_input);
    }
    for (const PlanFriction& friction : exact.friction) rubbed += friction.sliding > 0 ? 1 : 0;
    for (const WatchedSummary& one : exact.watched) watched += one.gap_needed > 0 && one.gap_needed_reversed ? 1 : 0;
    const double amplifies = sensitivity(draw, problem, exact);
    sensitive += amplifies > 1e3 ? 1 : 0;

    const PlanResponse adaptive = solve(problem, AdaptiveSolver{.tolerance = 1e-12}, {.both_ways = true});
    ASSERT_EQ(adaptive.status, Status::done) << adaptive.message;
    const Apart by = apart(problem, exact, problem, adaptive);
    worst_solver = std::max(worst_solver, by.size);
    EXPECT_LE(by.size, std::max(1e-8, 1e-12 * amplifies)) << by.what << ", amplifies " << amplifies;

    Eigen::Matrix2d quarter, mirror;
    quarter << 0, -1, 1, 0;
    mirror << -1, 0, 0, 1;
    for (const Told& told : std::vector<Told>{{.backwards = true},
                                              {.shift = {2, -4}},
                                              {.units = {100, 1000}},
                                              {.units = {1e3, 1e3}, .shift = {-3e3, 5e2}, .backwards = true},
                                              {.map = quarter},
                                              {.map = mirror},
                                              {.map = quarter * mirror}}) {
      const PlanProblem other = problem_of(draw, told);
      const PlanResponse found = solve(other, ExactSolver{}, {.both_ways = true});
      ASSERT_EQ(found.status, Status::done) << found.message;
      const Apart moved = apart(problem, exact, other, found, told);
      worst_told = std::max(worst_told, moved.size);
      EXPECT_LE(moved.size, std::max(1e-10, 1e-13 * amplifies)) << moved.what << ", amplifies " << amplifies;
    }
  }
  std::printf("%u plans, %d impacts, %d points slid, %d sensitive; solvers %.2g, told otherwise %.2g, energy %.2g\n",
              last - first + 1, impacts, rubbed, sensitive, worst_solver, worst_told, worst_energy);
  EXPECT_GT(impacts, 5 * static_cast<int>(last - first));
  EXPECT_GT(watched, 4 * static_cast<int>(last - first));
  EXPECT_LE(fallen, static_cast<int>(last - first) / 50 + 1);
}

}  // namespace
}  // namespace bentur::random_plans
