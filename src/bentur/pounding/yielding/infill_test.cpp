// Frames with infill in motion: a portal by hand up to yielding, beyond the cap and beyond failure; out of reach.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "bentur/structure/damping.h"
#include "bentur/structure/frame/infill.h"
#include "bentur/structure/frame/plane_frame.h"
#include "tests/support/same_response.h"
#include "tests/support/yielding_buildings.h"

namespace bentur::filled_frames {
namespace {

using namespace bentur::test;

class FilledFrame : public testing::TestWithParam<SolverWay> {
 protected:
  [[nodiscard]] Response run(const Problem& problem) const { return solved(problem, GetParam().solver); }
  [[nodiscard]] double within(double scale) const { return 10 * GetParam().accuracy * scale; }
};

INSTANTIATE_TEST_SUITE_P(, FilledFrame, testing::ValuesIn(exact_and_adaptive()),
                         [](const auto& one) { return one.param.label; });

constexpr double mass = 40, panel = 20e3, yield_force = 50, at_yield = yield_force / panel;

/// One bay, one storey, one mass, in which `backbone` fills the bay.
PlaneFrame portal(const Backbone& backbone) {
  PlaneFrame frame;
  frame.elastic_modulus = 2.5e7;
  frame.storey_heights = {3.5};
  frame.bay_widths = {5.0};
  frame.columns = {{.area = 0.16, .inertia = 0.4 * 0.4 * 0.4 * 0.4 / 12}};
  frame.beams = {{.area = 0.3 * 0.5, .inertia = 0.3 * 0.5 * 0.5 * 0.5 / 12}};
  frame.floor_masses = {mass};
  frame.mass_matrix = MassMatrix::lumped;
  frame.infills = {Infill{.stiffness = panel, .backbone = backbone}};
  return frame;
}

Building building_of(const PlaneFrame& frame) {
  return make_building("portal", plane_frame_model(frame), ModalDamping{{0}});
}

/// 24 EI_c/h³ (6κ + 1)/(6κ + 4), κ = (I_b/L)/(I_c/h): a portal with fixed feet.
double bare() {
  const PlaneFrame frame = portal({});
  const double column = frame.columns[0].inertia, kappa = frame.beams[0].inertia / 5 / (column / 3.5);
  return 24 * 2.5e7 * column / std::pow(3.5, 3) * (6 * kappa + 1) / (6 * kappa + 4);
}

/// The clear panel is 5 − 0.4 long and 3.5 − 0.5/2 high: a strut bears its push across over the cosine of its slope.
double cosine() { return 4.6 / std::hypot(4.6, 3.25); }

/// Pushed so that it comes to rest at `reach`, where its infill has taken up `work`.
Problem pushed(const Backbone& backbone, double reach, double work, double duration) {
  Problem problem = alone(building_of(portal(backbone)), duration);
  problem.initial_velocity[0](0) = std::sqrt((bare() * reach * reach + 2 * work) / mass);
  return problem;
}

TEST_P(FilledFrame, StopsBeyondTheCapWhereItsSpeedHasBeenUsedUp) {
  // Hardens to 1.2 V_y over 4 Δ_y, then falls to zero over 10 Δ_y; at the end 2 Δ_y beyond the cap.
  const Backbone falls = {.yield = yield_force, .cap = 1.2, .plastic = 4 * at_yield, .softening = 10 * at_yield};
  const double cap = 1.2 * yield_force, beyond = 2 * at_yield, slope = cap / falls.softening;
  const double reach = 5 * at_yield + beyond;
  const double work = 0.5 * yield_force * at_yield + 0.5 * (yield_force + cap) * falls.plastic + cap * beyond -
                      0.5 * slope * beyond * beyond;
  // Until it swings back, not so far that the other strut yields.
  const Response response = run(pushed(falls, reach, work, 0.2));
  const BuildingPeaks& peaks = response.buildings[0];
  EXPECT_NEAR(peaks.displacement(0), reach, within(reach));
  EXPECT_NEAR(peaks.infill.shear(0), cap, within(cap));
  EXPECT_NEAR(peaks.infill.force(0), cap / cosine(), within(cap));
  EXPECT_NEAR(peaks.infill.ductility(0), 7, within(7));
  EXPECT_NEAR(peaks.infill.strength_left(0), 0.8, within(1));
  EXPECT_TRUE(std::isnan(peaks.infill.failed_time(0)));
  // Of frame and strut together the shear is largest at the cap or where it stops.
  const double last = bare() * reach + cap - slope * beyond, at_cap = bare() * 5 * at_yield + cap;
  EXPECT_NEAR(peaks.storey_shear(0), std::max(last, at_cap), within(last));
}

TEST_P(FilledFrame, PushesOnItsColumnsBesideWhatTheyBear) {
  // Plastic to 3 Δ_y. By symmetry each column bears half of what the frame does, and all that a strut pushes.
  const double reach = 3 * at_yield, work = 0.5 * yield_force * at_yield + yield_force * 2 * at_yield;
  const double alone_bears = 0.5 * bare() * reach, together = alone_bears + yield_force;
  for (const double capacity : {1.25 * alone_bears, 2 * together}) {
    PlaneFrame frame = portal({.yield = yield_force});
    frame.columns[0].shear_capacity = {capacity};
    Problem problem = pushed({.yield = yield_force}, reach, work, 0.1);
    problem.buildings[0] = building_of(frame);
    const BuildingPeaks peaks = run(problem).buildings[0];
    EXPECT_NEAR(peaks.displacement(0), reach, within(reach));
    EXPECT_NEAR(peaks.infill.column_demand(0), together / capacity, within(2));
    EXPECT_EQ(peaks.infill.column_demand(0) > 1, capacity < together);
    for (const BuildingPeaks::Breaking& column : peaks.columns) {
      EXPECT_NEAR(column.peak_shear, alone_bears, within(together));
      EXPECT_FALSE(column.break_time) << "by its own shear alone";
    }
  }
}

TEST_P(FilledFrame, LosesWhatItsBackboneTakesUpAndSwingsBackAlone) {
  // Perfectly plastic to 3 Δ_y, where the run ends before it comes back to rest.
  const Backbone plastic = {.yield = yield_force};
  const double reach = 3 * at_yield, work = 0.5 * yield_force * at_yield + yield_force * 2 * at_yield;
  const Problem problem = pushed(plastic, reach, work, 0.1);
  const Response response = run(problem);
  // From rest at `reach` it goes back by frame and strut, then, the strut crushed by 2 Δ_y, by the frame alone.
  EXPECT_NEAR(response.buildings[0].infill.energy(0), work - 0.5 * yield_force * at_yield, within(work));
  EXPECT_NEAR(response.buildings[0].displacement(0), reach, within(reach));
}

TEST_P(FilledFrame, FailsAtItsUltimateDriftAndLeavesTheFrame) {
  // Plastic to 3 Δ_y, then gone: the frame alone stops it. Sines about 0 and, with V_y, about −V_y/k of the frame.
  const Backbone fails = {.yield = yield_force, .ultimate = 3 * at_yield};
  const double k = bare(), omega = std::sqrt(k / mass), whole = std::sqrt((k + panel) / mass);
  const double lost = 0.5 * yield_force * at_yield + yield_force * 2 * at_yield, reach = 5 * at_yield;
  const Problem problem = pushed(fails, reach, lost, 0.3);
  const double v = problem.initial_velocity[0](0);
  const double yields = std::asin(whole * at_yield / v) / whole, then = v * std::cos(whole * yields);
  const double centre = -yield_force / k;
  // x − centre = a sin(ω t + φ) from yielding on.
  const double phase = std::atan2(omega * (at_yield - centre), then);
  const double amplitude = std::hypot(at_yield - centre, then / omega);
  const double failed = yields + (std::asin((3 * at_yield - centre) / amplitude) - phase) / omega;
  const Response response = run(problem);
  const BuildingPeaks& peaks = response.buildings[0];
  EXPECT_NEAR(peaks.displacement(0), reach, within(reach));
  EXPECT_NEAR(peaks.infill.failed_time(0), failed, within(1));
  EXPECT_EQ(peaks.infill.strength_left(0), 0);
  EXPECT_NEAR(peaks.infill.energy(0), lost, within(lost));
  EXPECT_NEAR(peaks.infill.shear(0), yield_force, within(yield_force));
}

TEST_P(FilledFrame, IsElasticToTheBitWhereItsStrengthIsOutOfReach) {
  for (const double gap : {0.002, 1.0}) {
    std::vector<Response> responses;
    for (const double strength : {1e6, std::numeric_limits<double>::infinity()}) {
      const Building filled = building_of(portal({.yield = strength}));
      Problem problem = pair(filled, oscillator(30, 6000), {contact(gap, 1e5)}, 3);
      std::vector<double> record(150);
      for (std::size_t n = 0; n < record.size(); ++n) record[n] = 3 * std::sin(0.9 * static_cast<double>(n));
      problem.motion = SampledMotion{0.02, record};
      responses.push_back(run(problem));
    }
    expect_same(responses[0], responses[1]);
    EXPECT_EQ(responses[0].buildings[0].infill.force(0), responses[1].buildings[0].infill.force(0));
    EXPECT_GT(responses[0].buildings[0].infill.force(0), 0);
    EXPECT_EQ(responses[0].impacts.empty(), gap == 1.0);
    EXPECT_EQ(responses[0].buildings[0].infill.energy(0), 0);
    EXPECT_EQ(responses[0].buildings[0].infill.strength_left(0), 1);
  }
}

TEST_P(FilledFrame, IsThatOfAFreeResponseThatIsKept) {
  const Backbone falls = {.yield = yield_force, .plastic = 2 * at_yield, .softening = 5 * at_yield, .residual = 0.1};
  Problem problem = pair(building_of(portal(falls)), oscillator(30, 6000), {contact(0.05, 1e5)}, 4);
  std::vector<double> record(200);
  for (std::size_t n = 0; n < record.size(); ++n) {
    const double t = 0.02 * static_cast<double>(n);
    record[n] = 6 * std::sin(14 * t) + 3 * std::sin(23 * t);
  }
  problem.motion = SampledMotion{0.02, record};
  const FreeResponse free(problem, GetParam().solver);
  for (const double gap : {0.05, 0.01}) {
    problem.points[0].width = gap;
    const Response kept = free.solve(problem), anew = run(problem);
    expect_same(kept, anew);
    for (const auto list : {&BuildingPeaks::Infill::force, &BuildingPeaks::Infill::energy,
                            &BuildingPeaks::Infill::strength_left, &BuildingPeaks::Infill::ductility}) {
      EXPECT_EQ(kept.buildings[0].infill.*list, anew.buildings[0].infill.*list);
    }
    EXPECT_LT(anew.buildings[0].infill.strength_left(0), 1);
  }
}

}  // namespace
}  // namespace bentur::filled_frames
