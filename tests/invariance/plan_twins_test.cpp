// Rows of sticks stood in plan: symmetric floors with their stiffness in two planes, shaken along x; and these plans
// turned and mirrored.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "bentur/io/case/case_toml.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/gap/spectral_gap.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/structure/modes.h"
#include "tests/invariance/expect_twins.h"
#include "tests/invariance/plan_twin.h"
#include "tests/invariance/random_building.h"
#include "tests/reference/shared_folder.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

using namespace bentur::test;

/// What gaps need under a spectrum, which moves the twin along its other axis too.
void expect_spectral_twins(const PlanProblem& plan, const Problem& row) {
  const SpectrumSpec spectrum{.spectrum = {TwoPeriodSpectrum{9.8, 6.0, 8.0}}, .shape = "asce-7-22"};
  const auto largest = [](const SpectralGaps& gaps, Eigen::Index gap) {
    return largest_of(of_gap(gaps.levels, gap)).gap_needed;
  };
  const SpectralGaps of_plan = spectral_gaps(plan, spectrum), of_row = spectral_gaps(row, spectrum);
  for (std::size_t gap = 0; gap < plan.gaps.size(); ++gap) {
    const double needed = largest(of_row, std::min(plan.gaps[gap].left, plan.gaps[gap].right));
    EXPECT_NEAR(largest(of_plan, static_cast<Eigen::Index>(gap)), needed, 1e-9 * needed);
  }
  for (std::size_t b = 0; b < plan.buildings.size(); ++b) {
    const double demand = of_row.demands[b].ratio;
    EXPECT_NEAR(of_plan.demands[b].ratio, demand, 1e-9 * demand);
    EXPECT_GE(of_plan.drifts[b].ratio, (1 - 1e-9) * of_row.drifts[b].ratio);  // it moves along its other axis too
  }
}

// Two that twist, as they stand and turned by a right angle: one spectrum along both axes.
TEST(PlanTwins, NeedTheSameUnderASpectrumHoweverTheyStand) {
  Diagnostics diagnostics;
  const auto c = read_case(fs::path(BENTUR_SOURCE_DIR) / "examples/plan/twisting-pair.toml", diagnostics);
  ASSERT_TRUE(c);
  const SpectrumSpec spectrum{.spectrum = {TwoPeriodSpectrum{9.8, 6.0, 8.0}}, .shape = "asce-7-22"};
  const auto needed = [&](const Case& one) {
    return largest_of(spectral_gaps(make_plan_problem(one), spectrum).levels).gap_needed;
  };
  Case turned = *c;
  Eigen::Matrix2d map;
  map << 0, -1, 1, 0;
  for (BuildingSpec& building : turned.buildings) put_under(map, building);
  for (BuildingSpec& building : turned.buildings) {
    auto& rigidity = std::get<Plan>(building.structure).rigidity;
    if (!rigidity) continue;
    std::swap(rigidity->x, rigidity->y);
    const double depth = std::get<Plan>(building.structure).footprint.size.x();
    for (PlanPoint& centre : rigidity->centres) centre = PlanPoint(depth - centre.y(), centre.x());
  }
  GapSpec& gap = turned.gaps.at(0);
  gap.stretch = *facing(turned.buildings[0].footprint(), turned.buildings[1].footprint());
  ASSERT_FALSE(gap.stretch.swapped);
  EXPECT_NEAR(needed(turned), needed(*c), 1e-9 * needed(*c));
  // Along y moves what the second direction moves.
  const PlanProblem problem = make_plan_problem(*c);
  SpectralModes modes = spectral_modes(problem.buildings[0], spectrum.spectrum);
  const double both = spectral_peaks(problem.buildings[0], modes).cqc_y(1);
  modes.motions.pop_back();
  EXPECT_GT(both, 100 * spectral_peaks(problem.buildings[0], modes).cqc_y(1));
}

/// A row against its twins, turned and mirrored.
class TwinsOfRows {
 public:
  /// @param name for messages
  /// @param sensitive 1, or by how much more round-off may tell as strength is lost
  void compare(const Case& row, const std::string& name, double sensitive = 1) {
    std::optional<Response> wanted;
    const bool framed = std::any_of(row.buildings.begin(), row.buildings.end(), [](const BuildingSpec& spec) {
      return std::holds_alternative<PlaneFrame>(spec.structure);
    });
    for (const auto& [points, map] : ways_) {
      if (framed && map != Eigen::Matrix2d::Identity()) break;  // those with hinges are turned below
      const auto twin = twin_of(row, points, map);
      if (!twin) break;
      SCOPED_TRACE(testing::Message() << name << ", points " << points << "\n" << map);
      const Problem row_problem = make_problem(row);
      const SolveOptions options{.levels = true, .both_ways = true};
      if (!wanted) wanted = solve(row_problem, ExactSolver{}, options);
      const PlanProblem problem = make_plan_problem(*twin);
      const PlanResponse plan = solve(problem, ExactSolver{}, options);
      const double tolerance =
          sensitive * (std::any_of(row.gaps.begin(), row.gaps.end(), is_integrated_law) ? 1e-8 : 1e-9);
      expect_twins(problem, plan, *wanted, tolerance, map(0, 0) == 0);
      watched += expect_watched_twins(problem, plan, row_problem, *wanted, tolerance);
      const auto seen = row_of(PlanRun{*twin, problem, plan});
      for (const Gap& gap : gaps_of(seen->problem)) {
        const Eigen::Index left = std::min(gap.left, gap.right);
        const double needed = gap_needed(row_problem, *wanted, left);
        EXPECT_NEAR(gap_needed(seen->problem, seen->response, gap.number), needed, 10 * tolerance * (1e-9 + needed));
        EXPECT_EQ(unmodelled_contacts(seen->problem, seen->response.watched, gap.number).size(),
                  2 * unmodelled_contacts(row_problem, wanted->watched, left).size());
      }
      expect_spectral_twins(problem, row_problem);
      twins += 1;
      for (const PlanBuilding& building : problem.buildings) walls += building.is_rigid() ? 1 : 0;
      impacts += static_cast<int>(plan.impacts.size());
      collapses += plan.collapse ? 1 : 0;
      for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
        const Eigen::VectorXd& of_row = wanted->buildings[b].yielding.ductility;
        for (const PlanPeaks::Plane& plane : plan.buildings[b].planes) {
          if (of_row.size() == 0 || plane.yielding.ductility.size() == 0) continue;  // of the springs across
          expect_known_alike(plane.yielding.ductility, of_row, tolerance);
          yielding += of_row.maxCoeff() > 1 ? 1 : 0;
        }
      }
    }
  }

  int twins = 0, walls = 0, impacts = 0, watched = 0, yielding = 0, collapses = 0;

 private:
  static Eigen::Matrix2d matrix(double xx, double xy, double yx, double yy) {
    Eigen::Matrix2d made;
    made << xx, xy, yx, yy;
    return made;
  }
  /// Points of each edge, and how the plan is turned.
  std::vector<std::pair<int, Eigen::Matrix2d>> ways_ = {{2, matrix(1, 0, 0, 1)},  {3, matrix(1, 0, 0, 1)},
                                                        {2, matrix(0, -1, 1, 0)}, {2, matrix(-1, 0, 0, -1)},
                                                        {2, matrix(-1, 0, 0, 1)}, {2, matrix(0, 1, 1, 0)}};
};

TEST(PlanTwins, GiveTheNumbersOfTheirRows) {
  TwinsOfRows found;
  for (const fs::path& folder : {fs::path(BENTUR_SOURCE_DIR) / "examples", test::shared_folder() / "reference"}) {
    if (!fs::exists(folder)) continue;
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() != ".toml") continue;
      Diagnostics diagnostics;
      const auto row = read_case(entry.path(), diagnostics);
      if (row) found.compare(*row, entry.path().filename().string());  // else it is a study
    }
  }
  EXPECT_GE(found.twins, 4);
  EXPECT_GT(found.impacts, 100);
  std::printf("%d twins, %d walls, %d impacts, %d watched\n", found.twins, found.walls, found.impacts, found.watched);
}

/// Rows of two or three sticks by chance, one of whose storeys may be of any strength, alike on both sides or not, worn
/// or not; only their lowest floors are to meet, those above are watched.
class UnevenRows : private test::BuildingGenerator {
 public:
  using BuildingGenerator::BuildingGenerator;

  Case make() {
    Case c;
    const int count = among(2, 3);
    for (int b = 0; b < count; ++b) c.buildings.push_back(one(fmt::format("B{}", b)));
    for (int b = 0; b + 1 < count; ++b) {
      GapSpec& gap = c.gaps.emplace_back();
      gap.elevations = {heights_[0]};
      gap.widths = {logarithmic(1e-4, 0.03)};
      gap.contact.law = chance(0.5) ? "linear" : "kelvin-voigt";
      gap.contact.numbers["stiffness"] = {logarithmic(1e7, 1e9)};
      if (gap.contact.law != "linear") gap.contact.numbers["restitution"] = {uniform(0.3, 0.9)};
    }
    c.excitation.motion =
        HarmonicMotion{.period = uniform(0.3, 0.9), .displacement_amplitude = logarithmic(0.01, 0.06)};
    c.analysis.duration = uniform(1.5, 3);
    return c;
  }

 private:
  BuildingSpec one(const std::string& name) {
    BuildingSpec spec;
    spec.name = name;
    if (name == "B0" && chance(0.1)) {
      spec.structure = RigidSpec{{0.0, heights_[0], heights_[0] + heights_[1]}};
      return spec;
    }
    Stick made = stick({heights_.begin(), heights_.begin() + among(2, 3)});
    spec.damping = MassProportionalDamping{uniform(0, 0.05)};
    if (chance(0.85)) made.backbone = backbones(made);
    spec.structure = made;
    return spec;
  }

  StoreyBackbones backbones(const Stick& of) {
    StoreyBackbones made;
    made.positive = side(of, 1);
    if (chance(0.8)) made.negative = side(of, logarithmic(0.3, 3));
    made.reloading = static_cast<Reloading>(among(0, 2));
    for (double* gamma : {&made.deterioration.strength, &made.deterioration.cap, &made.deterioration.reloading,
                          &made.deterioration.unloading}) {
      if (chance(0.3)) *gamma = logarithmic(20, 300);
    }
    if (made.reloading == Reloading::bilinear) made.deterioration.reloading = Deterioration::none;
    made.pinching_force = uniform(0.2, 0.9);
    made.pinching_deformation = uniform(0, 0.8);
    return made;
  }

  StoreyBackbones::Side side(const Stick& of, double factor) {
    StoreyBackbones::Side made;
    for (std::size_t j = 0; j < of.masses.size(); ++j) {
      const double yield = factor * logarithmic(0.5, 6) * of.masses[j] * static_cast<double>(of.masses.size() - j);
      made.yield.push_back(yield);
      made.plastic.push_back(yield / of.stiffnesses[j] * logarithmic(0.5, 5));
      made.softening.push_back(yield / of.stiffnesses[j] * logarithmic(2, 20));
    }
    made.cap = {uniform(1, 1.3)};
    made.residual = {chance(0.3) ? 0 : uniform(0.05, 0.6)};
    return made;
  }
};

TEST(PlanTwins, OfUnevenStoreys) {
#ifdef BENTUR_SANITIZED
  constexpr unsigned count = 3;
#else
  constexpr unsigned count = 10;
#endif
  TwinsOfRows found;
  for (unsigned seed = 1; seed <= count; ++seed)
    found.compare(UnevenRows(seed).make(), fmt::format("seed {}", seed), 100);
  std::printf("%d twins, %d impacts, %d watched, %d planes that yield, %d collapses\n", found.twins, found.impacts,
              found.watched, found.yielding, found.collapses);
  EXPECT_GE(found.twins, static_cast<int>(6 * count));
  EXPECT_GT(found.impacts, static_cast<int>(count));
  EXPECT_GT(found.watched, static_cast<int>(6 * count));
  EXPECT_GT(found.yielding, static_cast<int>(6 * count));
}

/// Rows of two known by all or some of their modes.
class ModalRows : private test::BuildingGenerator {
 public:
  using BuildingGenerator::BuildingGenerator;

  Case make() {
    Case c;
    for (const char* const name : {"A", "B"}) c.buildings.push_back(one(name));
    GapSpec& gap = c.gaps.emplace_back();
    gap.elevations = {heights_[0]};
    gap.widths = {logarithmic(1e-4, 0.01)};
    gap.contact.law = "linear";
    gap.contact.numbers["stiffness"] = {logarithmic(1e7, 1e8)};
    c.excitation.motion =
        HarmonicMotion{.period = uniform(0.3, 0.9), .displacement_amplitude = logarithmic(0.02, 0.06)};
    c.analysis.duration = uniform(1.5, 3);
    return c;
  }

 private:
  BuildingSpec one(const std::string& name) {
    const Stick made = stick({heights_.begin(), heights_.begin() + 3});
    const StructuralModel model = stick_model(made);
    const Modes solved = modes(model.mass, model.stiffness);
    ModalBuilding modal{.elevations = model.elevations, .masses = made.masses, .modes = {}};
    for (Eigen::Index mode = 0; mode < among(1, 3); ++mode) {
      modal.modes.periods.push_back(2 * std::numbers::pi / solved.omega(mode));
      modal.modes.shapes.emplace_back(solved.shapes.col(mode).begin(), solved.shapes.col(mode).end());
    }
    BuildingSpec spec;
    spec.name = name;
    spec.damping = ModalDamping{{0.03}};
    spec.structure = std::move(modal);
    return spec;
  }
};

TEST(PlanTwins, OfRowsKnownByTheirModes) {
  TwinsOfRows found;
  constexpr unsigned count = 5;
  for (unsigned seed = 1; seed <= count; ++seed) found.compare(ModalRows(seed).make(), fmt::format("seed {}", seed));
  EXPECT_EQ(found.twins, static_cast<int>(6 * count));
  EXPECT_GT(found.impacts, static_cast<int>(6 * count));
}

/// The reference cases of frames with hinges that a plan can have: seen from both ends, and along y.
TEST(PlanTwins, OfFramesWithHinges) {
  const fs::path folder = test::shared_folder() / "reference" / "hinges";
  if (!fs::exists(folder)) GTEST_SKIP();
  Eigen::Matrix2d quarter;
  quarter << 0, -1, 1, 0;
  int twins = 0, formed = 0, mechanisms = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    Diagnostics diagnostics;
    const auto row = read_case(entry.path(), diagnostics);
    ASSERT_TRUE(row) << entry.path();
    const SolveOptions options{.levels = true, .energy_audit = true};
    std::optional<Response> wanted;
    for (const Eigen::Matrix2d& map : {Eigen::Matrix2d(Eigen::Matrix2d::Identity()), quarter}) {
      const auto twin = twin_of(*row, 2, map);
      if (!twin) break;
      SCOPED_TRACE(testing::Message() << entry.path().filename().string() << "\n" << map);
      if (!wanted) wanted = solve(make_problem(*row), ExactSolver{}, options);
      const PlanProblem problem = make_plan_problem(*twin);
      const PlanResponse plan = solve(problem, ExactSolver{}, options);
      const bool integrated = std::any_of(row->gaps.begin(), row->gaps.end(), is_integrated_law);
      expect_twins(problem, plan, *wanted, integrated ? 1e-8 : 1e-9, map(0, 0) == 0);
      EXPECT_LE(plan.energy->relative_residual(), 1e-12);
      twins += 1;
      for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
        if (wanted->buildings[b].hinges.empty()) continue;
        for (const std::size_t p : {0U, 1U}) {
          formed += expect_frame(plan.buildings[b].planes[p], wanted->buildings[b], 1e-8);
        }
        mechanisms += wanted->buildings[b].mechanism ? 1 : 0;
      }
    }
  }
  std::printf("%d twins, %d hinges formed, %d mechanisms\n", twins, formed, mechanisms);
  EXPECT_GE(twins, 4);
  EXPECT_GT(formed, 20);
}

/// Two sticks under gravity that yield, with so much on the left one and collapse at so much drift; and their twin.
std::pair<Case, Case> under_gravity(const std::string& loads, double collapse_drift) {
  Diagnostics diagnostics;
  auto row = read_case_text(
      "units = { length = \"m\", force = \"kN\" }\n"
      "[[building]]\nname = \"A\"\ndamping = { stiffness_proportional = 0.03 }\n"
      "damping_stiffness = \"tangent\"\ngravity_loads = " +
          loads +
          "\n"
          "stick = { storey_heights = [3, 3], masses = [30, 25], stiffnesses = [40e3, 30e3], yield_forces = [90, 80], "
          "hardening = 0.02 }\n"
          "[[building]]\nname = \"B\"\ndamping = 0.05\np_delta = true\n"
          "stick = { storey_heights = [3, 3], masses = [20, 18], stiffnesses = [60e3, 50e3] }\n"
          "[[gap]]\nbetween = [\"A\", \"B\"]\nwidth = 0.02\ncontact = { law = \"linear\", stiffness = 3e5 }\n"
          "[excitation]\nkind = \"harmonic\"\nperiod = 0.6\ndisplacement_amplitude = 0.06\n"
          "[analysis]\nduration = 6\ncollapse_drift = " +
          std::to_string(collapse_drift) + "\n",
      "row.toml", diagnostics);
  if (!row) throw std::runtime_error(diagnostics.errors().front().text());
  auto twin = twin_of(*row, 2, Eigen::Matrix2d::Identity());
  return {*std::move(row), std::move(twin).value()};
}

TEST(PlanTwins, UnderGravityLoads) {
  const auto [row, twin] = under_gravity("[1000, 800]", 0.1);
  const SolveOptions options{.levels = true, .both_ways = true};
  const Response wanted = solve(make_problem(row), ExactSolver{}, options);
  const PlanProblem problem = make_plan_problem(twin);
  for (std::size_t b = 0; b < 2; ++b) {
    const Building made = make_building(row.buildings[b]);
    EXPECT_NEAR(problem.buildings[b].modes.omega(0), made.modes.omega(0), 1e-12 * made.modes.omega(0));
    EXPECT_NEAR(problem.buildings[b].tangent_damping, made.tangent_damping, 1e-12 * made.tangent_damping);
  }
  const PlanResponse plan = solve(problem, ExactSolver{}, options);
  expect_twins(problem, plan, wanted, 1e-9, false);
  EXPECT_GT(plan.impacts.size(), 2U);
  EXPECT_GT(wanted.buildings[0].yielding.ductility.maxCoeff(), 1.5);
  // And they are not those without gravity.
  const Response without = solve(make_problem(under_gravity("[0, 0]", 0.1).first));
  EXPECT_GT(std::abs(without.buildings[0].displacement(1) / wanted.buildings[0].displacement(1) - 1), 0.01);
}

TEST(PlanTwins, CollapseWhenTheirRowsDo) {
  const auto [row, twin] = under_gravity("[9000, 7000]", 0.03);
  const SolveOptions options{.levels = true, .both_ways = true};
  const Response wanted = solve(make_problem(row), ExactSolver{}, options);
  const PlanResponse plan = solve(make_plan_problem(twin), ExactSolver{}, options);
  ASSERT_EQ(wanted.status, Status::collapsed);
  ASSERT_EQ(plan.status, Status::collapsed) << plan.message;
  ASSERT_TRUE(wanted.collapse);
  expect_twins(make_plan_problem(twin), plan, wanted, 1e-9, false);
}

}  // namespace
}  // namespace bentur
