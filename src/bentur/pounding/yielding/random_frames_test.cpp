// Frames by chance whose members yield, whose columns break or whose bays are filled, beside a wall or another such
// frame: `exact` against `adaptive`, which share no way of stepping, and where the energy went; the same seen from
// behind, and in other units.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <utility>

#include "bentur/elements/hinges.h"
#include "bentur/pounding/pounding.h"
#include "bentur/structure/frame/plane_frame.h"
#include "bentur/structure/support.h"
#include "tests/support/random_numbers.h"
#include "tests/support/small_buildings.h"

namespace bentur::random_frames {
namespace {

using namespace bentur::test;

/// Hinges alone, columns that break too, infill with hinges or without, hinges that lose strength, by repetition too.
enum class Kind { yields, breaks, filled, softens, wears };

/// How a case is told: seen from behind, and what a metre and a kilonewton are in its units.
struct Telling {
  bool mirrored = false;
  double length = 1, force = 1;
  Kind kind = Kind::yields;
};

class Generator {
 public:
  explicit Generator(unsigned seed, Telling told = {}) : random_(seed), told_(told) {}

  Problem make() {
    const double of_length = told_.length, sign = told_.mirrored ? -1 : 1;
    Building first = frame();
    Building second = chance(0.5) ? frame() : rigid_building("wall", {3 * of_length, 6 * of_length, 9 * of_length});
    if (told_.mirrored) std::swap(first, second);
    Problem problem = pair(std::move(first), std::move(second), {}, 4);
    const double gap = (chance(0.3) ? 0 : number(0.002, 0.02)) * of_length;
    const Eigen::Index levels = std::min(problem.buildings[0].model.floors(), problem.buildings[1].model.floors());
    for (int floor = 0; floor < levels; ++floor) {
      problem.points.push_back(contact(gap, number(5e4, 4e5) * told_.force / of_length, floor));
    }
    std::vector<double> record(200);
    const double one = number(4, 14), other = number(4, 25), strength = number(2, 7);
    for (std::size_t n = 0; n < record.size(); ++n) {
      const double t = 0.02 * static_cast<double>(n);
      record[n] =
          sign * of_length * strength * (std::sin(one * t) + 0.6 * std::sin(other * t + 1)) * std::exp(-0.2 * t);
    }
    problem.motion = SampledMotion{0.02, record};
    return problem;
  }

 private:
  double number(double least, double most) { return std::uniform_real_distribution(least, most)(random_); }
  [[nodiscard]] bool loses_strength() const { return told_.kind == Kind::softens || told_.kind == Kind::wears; }
  bool chance(double part) { return number(0, 1) < part; }
  std::size_t count(int least, int most) {
    return static_cast<std::size_t>(std::uniform_int_distribution(least, most)(random_));
  }

  Section member(double inertia, double capacity, std::size_t capacities, double hardening) {
    Section section{.area = 0.1, .inertia = inertia, .hardening = hardening};
    if (told_.kind == Kind::filled && chance(0.5)) return section;
    if (chance(0.1)) return section;  // stays elastic
    const std::size_t given = chance(0.5) ? capacities : 1;
    for (std::size_t n = 0; n < given; ++n) section.moment_capacity.push_back(capacity * number(0.8, 1.25));
    return section;
  }

  /// Beyond what a hinge hardens to; it may fail by either way, or by wear.
  HingeBackbone backbone() {
    HingeBackbone of{.plastic = number(0.001, 0.008)};
    if (chance(0.9)) of.softening = number(0.02, 0.08);
    if (chance(0.7)) of.residual = number(0.05, 0.6);
    if (chance(0.3)) of.ultimate = of.plastic + number(0.002, 0.03);
    if (told_.kind != Kind::wears) return of;
    of.ultimate += 0.5 * of.plastic;  // infinite where there is none
    of.plastic *= 1.5;
    of.wear = number(0.5, 20);
    if (chance(0.3)) of.wear_exponent = number(1, 2);
    return of;
  }

  void make_brittle(Section& column, std::size_t lines) {
    const std::size_t given = chance(0.6) ? lines : 1;
    for (std::size_t n = 0; n < given; ++n) column.shear_capacity.push_back(number(40, 130));
    column.residual_shear = chance(0.5) ? 0 : number(0.05, 0.7);
  }

  /// Of masonry or by numbers; strength lost in every way there is, or none.
  Infill panel() {
    Infill infill;
    if (chance(0.5)) {
      infill.thickness = number(0.08, 0.2);
      infill.modulus = number(1e6, 4e6);
      infill.strength = number(500, 2000);
      if (chance(0.3)) infill.sliding_strength = number(50, 400);
    } else {
      infill.stiffness = number(1e4, 6e4);
      infill.backbone.yield = chance(0.1) ? std::numeric_limits<double>::infinity() : number(20, 120);
    }
    Backbone& backbone = infill.backbone;
    if (chance(0.8)) {
      backbone.plastic = number(0.002, 0.01);
      if (chance(0.5)) backbone.cap = number(1, 1.4);
      if (chance(0.8)) backbone.softening = number(0.01, 0.06);
      if (chance(0.5)) backbone.residual = number(0.05, 0.5);
    }
    if (chance(0.3)) backbone.ultimate = number(0.03, 0.1);
    return infill;
  }

  Building frame() {
    PlaneFrame frame;
    frame.elastic_modulus = 3e7;
    const std::size_t storeys = count(1, 3);
    const std::size_t bays = count(1, 3);
    const double hardens = loses_strength() ? 0.1 : 1;  // so that none does to twice its capacity
    const double hardening = chance(0.4) ? 0 : number(0.005, 0.1) * hardens;
    const double strong = chance(0.5) ? 0.6 : 1.6;  // beams over columns
    frame.mass_matrix = chance(0.7) ? MassMatrix::lumped : MassMatrix::consistent;
    for (std::size_t bay = 0; bay < bays; ++bay) frame.bay_widths.push_back(number(4, 6));
    for (std::size_t n = 0; n < storeys; ++n) {
      frame.storey_heights.push_back(3);
      frame.columns.push_back(member(number(1e-3, 3e-3), number(80, 160), bays + 1, hardening));
      frame.beams.push_back(member(number(1e-3, 4e-3), strong * number(80, 160), 2, hardening));
      frame.columns.back().mass = frame.beams.back().mass = 1;
      if (chance(0.3)) frame.beams.back().line_load = number(1, 8);
      frame.floor_masses.push_back(number(20, 60));
    }
    if (chance(0.2)) frame.nodes = {{.left = chance(0.5), .elevation = 1.4}};
    for (std::vector<Section>* sections : {&frame.columns, &frame.beams}) {
      for (Section& section : *sections) {
        if (loses_strength() && chance(0.8)) section.backbone = backbone();
      }
    }
    for (Section& column : frame.columns) {
      if (loses_strength() && chance(0.15)) make_brittle(column, bays + 1);
      if (told_.kind == Kind::breaks && chance(0.7)) make_brittle(column, bays + 1);
    }
    for (std::size_t n = 0; told_.kind == Kind::filled && n < storeys; ++n) {
      frame.infills.push_back(chance(0.8) ? std::optional(panel()) : std::nullopt);
    }
    Support support;
    if (chance(0.25)) {
      std::vector<double> loads;
      for (const double mass : frame.floor_masses) loads.push_back(9.81 * mass);
      support.gravity = GravityLoads{loads};
    }
    if (chance(0.2)) support.soil = Soil{{2e5, 2e3}, {3e6, 3e4}, 40, 200};
    if (!support.soil && chance(0.1)) {
      support.isolation = Isolation{.mass = 40, .bearings = {.stiffness = 4e3}, .damping = 100};
    }
    const Damping damping = MassProportionalDamping{chance(0.3) ? 0 : 0.05};
    tell(frame, support);
    return make_building("frame", plane_frame_model(frame), damping, support);
  }

  /// From metres, kilonewtons and the front into what it is told in.
  void tell(PlaneFrame& frame, Support& support) const {
    const double l = told_.length, f = told_.force, m = f / l;
    const auto by = [](std::vector<double>& all, double factor) {
      for (double& one : all) one *= factor;
    };
    frame.elastic_modulus *= f / (l * l);
    by(frame.storey_heights, l);
    by(frame.bay_widths, l);
    by(frame.floor_masses, m);
    for (std::vector<Section>* sections : {&frame.columns, &frame.beams}) {
      for (Section& section : *sections) {
        section.area *= l * l;
        section.inertia *= l * l * l * l;
        section.mass *= m;
        section.line_load *= f / l;
        by(section.moment_capacity, f * l);
        by(section.shear_capacity, f);
        if (!told_.mirrored || sections != &frame.columns) continue;
        std::reverse(section.moment_capacity.begin(), section.moment_capacity.end());
        std::reverse(section.shear_capacity.begin(), section.shear_capacity.end());
      }
    }
    for (std::optional<Infill>& infill : frame.infills) {
      if (!infill) continue;
      infill->thickness *= l;
      infill->stiffness *= f / l;
      for (double* pressure : {&infill->modulus, &infill->strength, &infill->sliding_strength})
        *pressure *= f / (l * l);
      Backbone& backbone = infill->backbone;
      backbone.yield *= f;
      for (double* drift : {&backbone.plastic, &backbone.softening, &backbone.ultimate}) *drift *= l;
    }
    for (ColumnNode& node : frame.nodes) {
      node.elevation *= l;
      node.left = node.left != told_.mirrored;
    }
    if (told_.mirrored) std::reverse(frame.bay_widths.begin(), frame.bay_widths.end());
    if (support.gravity) by(support.gravity->loads, f);
    if (support.soil) {
      Soil& soil = *support.soil;
      soil = {{soil.sway.stiffness * f / l, soil.sway.damping * f / l},
              {soil.rocking.stiffness * f * l, soil.rocking.damping * f * l},
              soil.mass * m,
              soil.inertia * m * l * l};
    }
    if (support.isolation) {
      support.isolation->mass *= m;
      support.isolation->bearings.stiffness *= f / l;
      support.isolation->damping *= f / l;
    }
  }

  std::mt19937_64 random_;
  Telling told_;
};

double apart(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  double most = 0, size = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    if (std::isnan(a(i)) && std::isnan(b(i))) continue;
    size = std::max(size, std::abs(a(i)));
    most = std::max(most, std::abs(a(i) - b(i)));
  }
  return size > 0 ? most / size : most;
}

Response run(const Problem& problem, const Solver& solver) {
  SolveOptions options;
  options.energy_audit = true;
  return solve(problem, solver, options);
}

/// Over the energy put in, ½ x K x that elastic frames would hold at the largest displacements: what members hold that
/// yield or break is the difference between numbers of this size.
double held_at_peak(const Problem& problem, const Response& response) {
  double most = 0;
  for (std::size_t b = 0; b < 2; ++b) {
    const Eigen::VectorXd& x = response.buildings[b].displacement;
    const Eigen::VectorXd stiffness = problem.buildings[b].model.stiffness.diagonal().head(x.size());
    most = std::max(most, 0.5 * stiffness.dot(x.cwiseAbs2()));
  }
  return most / response.energy->peak_input;
}

/// BENTUR_RANDOM_FRAMES=FIRST:COUNT runs others than those that the tests always run.
std::pair<unsigned, unsigned> seeds(Kind kind) {
  const char* const variable = "BENTUR_RANDOM_FRAMES";
  if (kind == Kind::wears) return test::seeds_of(variable, {4, 4}, {4, 2});
  if (kind == Kind::yields || kind == Kind::breaks) return test::seeds_of(variable, {1, 20}, {1, 4});
  return test::seeds_of(variable, {1, 12}, {1, 2});
}

class RandomFrames : public testing::TestWithParam<Kind> {
 protected:
  [[nodiscard]] static bool breaks() { return GetParam() == Kind::breaks; }
  [[nodiscard]] static bool softens() { return GetParam() == Kind::softens || wears(); }
  [[nodiscard]] static bool wears() { return GetParam() == Kind::wears; }
  [[nodiscard]] static bool filled() { return GetParam() == Kind::filled; }
};

const auto name_of_kind = [](const auto& one) {
  return one.param == Kind::yields   ? "that_yield"
         : one.param == Kind::breaks ? "that_break"
         : one.param == Kind::filled ? "that_are_filled"
         : one.param == Kind::wears  ? "that_wear"
                                     : "that_soften";
};
INSTANTIATE_TEST_SUITE_P(, RandomFrames,
                         testing::Values(Kind::yields, Kind::breaks, Kind::filled, Kind::softens, Kind::wears),
                         name_of_kind);

class RandomHingedFrames : public RandomFrames {};

INSTANTIATE_TEST_SUITE_P(, RandomHingedFrames, testing::Values(Kind::yields, Kind::breaks, Kind::softens),
                         name_of_kind);

/// How many storeys have infill that has lost strength, and how many have some that failed.
std::pair<long, long> lost_infill(const Response& response) {
  long weakened = 0, failed = 0;
  for (const BuildingPeaks& peaks : response.buildings) {
    for (Eigen::Index j = 0; j < peaks.infill.force.size(); ++j) {
      weakened += peaks.infill.strength_left(j) < 1 ? 1 : 0;
      failed += std::isnan(peaks.infill.failed_time(j)) ? 0 : 1;
    }
  }
  return {weakened, failed};
}

/// Where a hinge is in the frame seen from behind.
HingePlace from_behind(HingePlace place, Eigen::Index bays) {
  using End = HingePlace::End;
  place.number = (place.of_beam ? bays : bays + 1) + 1 - place.number;
  if (place.of_beam) place.end = place.end == End::left ? End::right : End::left;
  return place;
}

bool is_at(const HingePlace& a, const HingePlace& b) {
  return a.of_beam == b.of_beam && a.level == b.level && a.number == b.number && a.end == b.end;
}

/// Hinge by hinge; seen from behind all turn the other way. @return how many have failed
long expect_same_hinges(const Building& building, const BuildingPeaks& one, const Building& of_other,
                        const BuildingPeaks& other, bool mirrored) {
  long failed = 0;
  Eigen::Index bays = 0;
  for (const HingePlace& place : building.model.hinges.places) {
    bays = std::max(bays, place.of_beam ? place.number : place.number - 1);
  }
  const auto& places = of_other.model.hinges.places;
  for (std::size_t h = 0; h < one.hinges.size(); ++h) {
    const HingePlace& own = building.model.hinges.places[h];
    const HingePlace there = mirrored ? from_behind(own, bays) : own;
    const auto found =
        std::find_if(places.begin(), places.end(), [&](const HingePlace& place) { return is_at(place, there); });
    if (found == places.end()) {
      ADD_FAILURE() << "no such hinge";
      return failed;
    }
    const BuildingPeaks::Hinge &a = one.hinges[h], &b = other.hinges[static_cast<std::size_t>(found - places.begin())];
    EXPECT_NEAR(a.peak_rotation, b.peak_rotation, 1e-7 * (1e-3 + a.peak_rotation)) << h;
    EXPECT_NEAR(a.residual_rotation, (mirrored ? -1 : 1) * b.residual_rotation, 1e-7 * (1e-3 + a.peak_rotation)) << h;
    EXPECT_EQ(a.half_cycles, b.half_cycles) << h;
    EXPECT_EQ(a.failed_time.has_value(), b.failed_time.has_value()) << h;
    EXPECT_GE(a.peak_rotation, (1 - 1e-9) * std::abs(a.residual_rotation)) << h;
    failed += a.failed_time ? 1 : 0;
  }
  return failed;
}

/// Seen from behind, left is right and all moves the other way; in centimetres and newtons it is the same frame.
TEST_P(RandomFrames, AreAlikeFromBehindAndInOtherUnits) {
  const auto [first, given] = seeds(GetParam());
  const unsigned count = wears() ? given / 2 : given;
  long yielded = 0, broken = 0, failed = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    const Problem of_plain = Generator(seed, {.kind = GetParam()}).make();
    // With samples, so that it checks its peaks against them.
    const Response plain = solve(of_plain, ExactSolver{}, {.output_step = 0.0137, .energy_audit = true});
    for (const Discrepancy& one : plain.discrepancies) EXPECT_NE(one.key, "check_peaks") << one.size;
    for (Telling told : {Telling{.mirrored = true}, Telling{.length = 100, .force = 1e3}}) {
      told.kind = GetParam();
      SCOPED_TRACE(fmt::format("seed {}, {}", seed, told.mirrored ? "mirrored" : "cm and N"));
      const Problem of_other = Generator(seed, told).make();
      const Response other = run(of_other, ExactSolver{});
      ASSERT_EQ(other.status, plain.status) << other.message;
      EXPECT_EQ(other.impacts.size(), plain.impacts.size());
      for (std::size_t b = 0; b < 2; ++b) {
        const BuildingPeaks& one = plain.buildings[b];
        const BuildingPeaks& same = other.buildings[told.mirrored ? 1 - b : b];
        EXPECT_LE(apart(one.displacement, same.displacement / told.length), 1e-8) << b;
        EXPECT_LE(apart(one.storey_shear, same.storey_shear / told.force), 1e-7) << b;
        EXPECT_LE(apart(one.infill.force, same.infill.force / told.force), 1e-7) << b;
        EXPECT_LE(apart(one.infill.energy, same.infill.energy / (told.force * told.length)), 1e-7) << b;
        EXPECT_LE(apart(one.infill.failed_time, same.infill.failed_time), 1e-7) << b;
        const auto same_energy = [&](const auto& mine, const auto& others, auto energy) {
          const auto all = [&](const auto& list) {
            double sum = 0;
            for (const auto& place : list) sum += place.*energy;
            return sum;
          };
          EXPECT_NEAR(all(mine), all(others) / (told.force * told.length), 1e-7 * all(mine) + 1e-12) << b;
        };
        same_energy(one.hinges, same.hinges, &BuildingPeaks::Hinge::dissipated_energy);
        same_energy(one.columns, same.columns, &BuildingPeaks::Breaking::released_energy);
        failed += expect_same_hinges(of_plain.buildings[b], one, of_other.buildings[told.mirrored ? 1 - b : b], same,
                                     told.mirrored);
        for (const BuildingPeaks::Hinge& hinge : one.hinges) yielded += hinge.first_yield ? 1 : 0;
        for (const BuildingPeaks::Breaking& column : one.columns) broken += column.break_time ? 1 : 0;
      }
    }
  }
  EXPECT_GT(yielded, count);
  EXPECT_GE(broken, breaks() ? count : 0);
  EXPECT_GE(failed, softens() ? count / 2 : 0);
}

TEST_P(RandomFrames, AreAlikeByBothSolvers) {
  const auto [first, count] = seeds(GetParam());
  long yielded = 0, pounded = 0, broken = 0, weakened = 0, failed = 0, weaker = 0, gone = 0, snapped = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const Problem problem = Generator(seed, {.kind = GetParam()}).make();
    const Response exact = run(problem, ExactSolver{});
    ASSERT_TRUE(exact.status == Status::done || exact.status == Status::collapsed) << exact.message;
    const double differs = std::max(1.0, held_at_peak(problem, exact));
    EXPECT_LE(exact.energy->relative_residual(), 1e-12 * differs);
    const Response adaptive = run(problem, AdaptiveSolver{1e-12});
    ASSERT_EQ(adaptive.status, exact.status) << adaptive.message;
    EXPECT_EQ(exact.impacts.size(), adaptive.impacts.size());
    for (std::size_t b = 0; b < 2; ++b) {
      const BuildingPeaks& one = exact.buildings[b];
      const BuildingPeaks& other = adaptive.buildings[b];
      EXPECT_LE(apart(one.displacement, other.displacement), 1e-8) << b;
      EXPECT_LE(apart(one.storey_shear, other.storey_shear), 1e-7) << b;
      for (const auto list : {&BuildingPeaks::Infill::force, &BuildingPeaks::Infill::strength_left,
                              &BuildingPeaks::Infill::energy, &BuildingPeaks::Infill::failed_time}) {
        EXPECT_LE(apart(one.infill.*list, other.infill.*list), 1e-7) << b;
      }
      for (const BuildingPeaks::Hinge& hinge : one.hinges) yielded += hinge.first_yield ? 1 : 0;
      for (std::size_t c = 0; c < one.columns.size(); ++c) {
        const BuildingPeaks::Breaking& column = one.columns[c];
        EXPECT_EQ(column.break_time.has_value(), other.columns[c].break_time.has_value());
        EXPECT_NEAR(column.break_time.value_or(0), other.columns[c].break_time.value_or(0), 1e-8);
        broken += column.break_time ? 1 : 0;
      }
      for (std::size_t h = 0; h < one.hinges.size(); ++h) {
        const BuildingPeaks::Hinge &hinge = one.hinges[h], &same = other.hinges[h];
        EXPECT_NEAR(hinge.strength_left.value_or(1), same.strength_left.value_or(1), 1e-7) << h;
        EXPECT_EQ(hinge.failed_time.has_value(), same.failed_time.has_value()) << h;
        weaker += hinge.strength_left.value_or(1) < 1 ? 1 : 0;
        gone += hinge.failed_time ? 1 : 0;
        snapped += hinge.released_energy.value_or(0) > 0 ? 1 : 0;
      }
    }
    pounded += std::ssize(exact.impacts);
    weakened += lost_infill(exact).first;
    failed += lost_infill(exact).second;
  }
  EXPECT_GT(yielded, count);
  EXPECT_GT(pounded, breaks() ? 0 : count);
  EXPECT_GE(broken, breaks() ? count : 0);
  EXPECT_GE(weakened, filled() ? count / 2 : 0);
  EXPECT_GE(failed, filled() ? count / 4 : 0);
  EXPECT_GE(weaker, softens() ? 2 * count : 0);
  EXPECT_GE(gone, softens() ? count / 2 : 0);
  EXPECT_GE(snapped, softens() ? count / 4 : 0);
}

void expect_same_to_the_bit(const Response& one, const Response& other) {
  EXPECT_EQ(std::pair(one.steps, one.impacts.size()), std::pair(other.steps, other.impacts.size()));
  for (std::size_t b = 0; b < 2; ++b) {
    const BuildingPeaks &mine = one.buildings[b], &others = other.buildings[b];
    EXPECT_EQ(mine.displacement, others.displacement);
    EXPECT_EQ(apart(mine.storey_shear, others.storey_shear), 0);  // NaN of walls
    ASSERT_EQ(mine.hinges.size(), others.hinges.size());
    for (std::size_t h = 0; h < mine.hinges.size(); ++h) {
      const BuildingPeaks::Hinge &a = mine.hinges[h], &same = others.hinges[h];
      EXPECT_EQ(a.dissipated_energy, same.dissipated_energy);
      EXPECT_EQ(a.peak_moment, same.peak_moment);
      EXPECT_EQ(a.residual_rotation, same.residual_rotation);
      EXPECT_EQ(a.first_yield, same.first_yield);
    }
  }
}

/// With nothing kept λ of (H-7) comes by complementarity, and sets are worked out anew at each event.
TEST_P(RandomHingedFrames, AreTheSameToTheBitWhateverIsKeptOfTheSetsThatFlow) {
  const auto [first, count] = seeds(GetParam());
  for (unsigned seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Problem problem = Generator(seed, {.kind = GetParam()}).make();
    const Response kept = run(problem, ExactSolver{});
    for (const Eigen::Index numbers : {0, 1000}) {
      for (Building& building : problem.buildings) {
        for (CoupledElement& element : building.coupled) {
          const auto& hinges = dynamic_cast<const HingeLaw&>(*element.law);
          element.law = std::make_shared<HingeLaw>(hinges.parameters(), numbers);
        }
      }
      expect_same_to_the_bit(run(problem, ExactSolver{}), kept);
    }
  }
}

/// All runs from one free response share what sets of hinges are over the modes.
TEST_P(RandomHingedFrames, AreTheSameToTheBitFromAFreeResponseThatIsKept) {
  const auto [first, count] = seeds(GetParam());
  long pounded = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Problem problem = Generator(seed, {.kind = GetParam()}).make();
    const FreeResponse free(problem);
    for (const double width : {0.0, 0.004, 0.015}) {
      for (ContactPoint& point : problem.points) point.width = width;
      const Response kept = free.solve(problem);
      expect_same_to_the_bit(kept, solve(problem));
      pounded += std::ssize(kept.impacts);
    }
  }
  EXPECT_GT(pounded, count);
}

}  // namespace
}  // namespace bentur::random_frames
