#include "bentur/model/story/remarks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "bentur/model/run_results.h"
#include "bentur/model/story/story.h"
#include "bentur/model/suite/suite.h"

namespace bentur {
namespace {

BuildingSpec remarked_spec(std::string name, decltype(BuildingSpec::structure) structure) {
  BuildingSpec spec;
  spec.name = std::move(name);
  spec.structure = std::move(structure);
  spec.damping = ModalDamping{{0.05}};
  return spec;
}

/// Two concrete frames of three storeys [m, kN] with nothing odd about them.
Case ordinary() {
  PlaneFrame frame;
  frame.elastic_modulus = 2.6e7;
  frame.storey_heights = {3.5, 3.0, 3.0};
  frame.bay_widths = {5, 5};
  frame.columns.assign(3, {.area = 0.16, .inertia = 0.4 * 0.4 * 0.4 * 0.4 / 12, .line_mass = 0.4});
  frame.beams.assign(3, {.area = 0.15, .inertia = 0.3 * 0.125 / 12, .line_mass = 0.375});
  frame.floor_masses = {30, 30, 25};
  Case c;
  c.units = {.length = "m", .force = "kN", .gravity = 9.80665};
  c.buildings = {remarked_spec("A", frame), remarked_spec("B", frame)};
  GapSpec gap;
  gap.elevations = {3.5, 6.5, 9.5};
  gap.widths = {0.05, 0.05, 0.05};
  gap.contact.axial = true;
  c.gaps = {gap};
  SampledMotion motion{0.01, {}};
  for (int i = 0; i < 1000; ++i) motion.acceleration.push_back(3.0 * std::sin(0.05 * i) * std::sin(0.003 * i));
  c.excitation.motion = motion;
  c.excitation.delays = {0, 0.1};
  c.analysis.duration = 9.99;
  return c;
}

PlaneFrame& frame_of(Case& c, std::size_t b) { return std::get<PlaneFrame>(c.buildings[b].structure); }

/// "key subject" of each.
std::vector<std::string> list(const std::vector<Remark>& remarks) {
  std::vector<std::string> names;
  for (const Remark& remark : remarks) {
    EXPECT_TRUE(remark.usual_from || remark.usual_to) << remark.key;
    names.push_back(remark.key + (remark.subject.empty() ? "" : " " + remark.subject));
  }
  std::sort(names.begin(), names.end());
  return names;
}

using Names = std::vector<std::string>;

Names remarks_of(const Case& c) { return list(remarks(c, make_problem(c))); }

TEST(Remarks, OrdinaryBuildingsHaveNone) { EXPECT_EQ(remarks_of(ordinary()), Names{}); }

TEST(Remarks, OfUnitsThatWereMixedUp) {
  Case c = ordinary();
  frame_of(c, 0).elastic_modulus = 2.6e4;  // MPa among kN and m
  EXPECT_EQ(remarks_of(c), (Names{"elastic_modulus A", "period_per_storey A"}));
  const Remark modulus = remarks(c, make_problem(c))[1];
  EXPECT_EQ(modulus.key, "elastic_modulus");
  EXPECT_EQ(modulus.unit, "kN/m²");
  EXPECT_NEAR(*modulus.usual_from, 1e7, 1);
  EXPECT_NEAR(*modulus.usual_to, 2.1e8, 1);
  c = ordinary();
  frame_of(c, 1).columns[1] = {.area = 50 * 40, .inertia = 50.0 * 40 * 40 * 40 / 12, .line_mass = 1};  // cm
  const Names found = remarks_of(c);
  EXPECT_NE(std::find(found.begin(), found.end(), "section B"), found.end());
  c = ordinary();
  frame_of(c, 0).storey_heights = {350, 300, 300};
  frame_of(c, 1).storey_heights = {350, 300, 300};
  c.gaps[0].elevations = {350, 650, 950};
  const Names high = remarks_of(c);
  EXPECT_NE(std::find(high.begin(), high.end(), "storey_height A"), high.end());
  EXPECT_NE(std::find(high.begin(), high.end(), "period_per_storey A"), high.end());
}

// Within a span a beam yields at w L²/8 − (M⁺ + M⁻)/2 … no sooner than w = 2 (M⁺ + M⁻)/L².
TEST(Remarks, OfBeamsThatTheirLoadMakesYieldWithinTheSpan) {
  Case c = ordinary();
  PlaneFrame& frame = frame_of(c, 0);
  const double widest = *std::max_element(frame.bay_widths.begin(), frame.bay_widths.end());
  const double most = 2 * (90 + 140) / (widest * widest);
  frame.condensation = Condensation::static_;
  frame.beams[1].moment_capacity = {90, 140};
  frame.beams[1].line_load = 0.99 * most;
  EXPECT_EQ(remarks_of(c), Names{});
  frame.beams[1].line_load = 1.01 * most;
  EXPECT_EQ(remarks_of(c), Names{"line_load A, beams[1]"});
  EXPECT_NEAR(*remarks(c, make_problem(c))[0].usual_to, most, 0.05 * most);
}

// The same buildings in other units are as ordinary.
TEST(Remarks, DoNotDependOnUnits) {
  Case c = ordinary();
  const double cm = 100, kgf = 1e3 / 9.80665;
  c.units = {.length = "cm", .force = "kgf", .gravity = 980.665};
  for (std::size_t b = 0; b < 2; ++b) {
    PlaneFrame& f = frame_of(c, b);
    f.elastic_modulus *= kgf / (cm * cm);
    for (double& h : f.storey_heights) h *= cm;
    for (double& w : f.bay_widths) w *= cm;
    for (double& mass : f.floor_masses) mass *= kgf / cm;
    for (auto* sections : {&f.columns, &f.beams}) {
      for (Section& s : *sections) {
        s.area *= cm * cm;
        s.inertia *= cm * cm * cm * cm;
        s.line_mass *= kgf / (cm * cm);
      }
    }
  }
  for (double& x : c.gaps[0].elevations) x *= cm;
  for (double& x : c.gaps[0].widths) x *= cm;
  for (double& a : std::get<SampledMotion>(c.excitation.motion).acceleration) a *= cm;
  EXPECT_EQ(remarks_of(c), Names{});
  EXPECT_NEAR(proportions(make_problem(c).buildings[0], c.units, nullptr).weight,
              kgf * proportions(make_problem(ordinary()).buildings[0], ordinary().units, nullptr).weight, 1e-6);
}

TEST(Remarks, OfMotionDelaysGapsAndOutput) {
  Case c = ordinary();
  for (double& a : std::get<SampledMotion>(c.excitation.motion).acceleration) a *= 27;  // 8.3 g
  EXPECT_EQ(remarks_of(c), Names{"pga"});
  EXPECT_NEAR(remarks(c, make_problem(c))[0].value, 81 / 9.80665, 0.1);
  for (double& a : std::get<SampledMotion>(c.excitation.motion).acceleration) a = 0;
  EXPECT_EQ(remarks_of(c), Names{"motion_of_zeros"});
  c = ordinary();
  c.excitation.delays = {0, 10.0};
  EXPECT_EQ(remarks_of(c), Names{"delay B"});
  c = ordinary();
  c.analysis.duration = 2;  // the record's largest is at some 5 s
  EXPECT_EQ(remarks_of(c), Names{"duration"});
  c = ordinary();
  c.analysis.output_step = 1e9;
  EXPECT_EQ(remarks_of(c), Names{"output_step"});
  c = ordinary();
  c.gaps[0].widths = {1.2, 1.2, 1.2};
  EXPECT_EQ(remarks_of(c), Names{"gap_width A | B"});
  EXPECT_FALSE(remarks(c, make_problem(c))[0].is_doubt);
  c.gaps[0].widths = {2, 2, 2};  // cm, where the case is in m
  EXPECT_TRUE(remarks(c, make_problem(c))[0].is_doubt);
  const Problem apart = make_problem(c);
  c.links = {{}};  // a bridge from A to B
  EXPECT_TRUE(remarks(c, apart).empty());
  c = ordinary();
  c.initial.displacements = {{0, 10.0, 0}, {}};
  EXPECT_EQ(remarks_of(c), Names{"initial_overlap A | B"});
  EXPECT_NEAR(remarks(c, make_problem(c))[0].value, 9.95, 1e-12);
  c = ordinary();
  c.gaps[0].contact.axial = false;
  c.gaps[0].contact.numbers["stiffness"] = {10.0};  // kN/m
  EXPECT_EQ(remarks_of(c), Names{"contact_stiffness A | B"});
  c = ordinary();
  c.buildings[1].damping = ModalDamping{{0.5}};
  EXPECT_EQ(remarks_of(c), Names{"damping B"});
  EXPECT_TRUE(remarks(c, make_problem(c))[0].is_doubt);
  c.buildings[1].damping = ModalDamping{{0.3}};
  EXPECT_EQ(remarks_of(c), Names{"damping B"});
  EXPECT_FALSE(remarks(c, make_problem(c))[0].is_doubt);
}

TEST(Remarks, OfMotionsInTheWrongUnit) {
  Case c = ordinary();
  auto& acceleration = std::get<SampledMotion>(c.excitation.motion).acceleration;
  const double peak = peak_acceleration(c.excitation.motion);
  RecordEcho record;
  record.unit = "g";
  record.pga_read = 0.31;
  record.pga_without_unit = 0.35;
  c.excitation.record = record;
  for (double& a : acceleration) a *= 0.35 / peak;  // pga = 0.35 where 0.35 g is meant
  EXPECT_EQ(remarks_of(c), Names{"pga_without_unit"});
  const Remark told = remarks(c, make_problem(c))[0];
  EXPECT_NEAR(told.value, 0.0357, 5e-5);
  EXPECT_EQ(told.usual_from, 0.35);
  c.excitation.record->pga_without_unit.reset();  // by scale, or with its unit
  EXPECT_EQ(remarks_of(c), Names{"pga"});
  c.excitation.record->pga_without_unit = 0.35;
  c.excitation.record->pga_read = 0.04;  // a weak record, left about as it is
  EXPECT_EQ(remarks_of(c), Names{"pga"});
  EXPECT_FALSE(remarks(c, make_problem(c))[0].is_doubt);
  c.excitation.record->unit = "m/s2";  // which stands in the case alone, where the file may be in g
  c.excitation.record->pga_read = 0.35;
  c.excitation.record->pga_without_unit.reset();
  EXPECT_FALSE(remarks(c, make_problem(c))[0].is_doubt);
  c.excitation.amplitude_without_unit = 0.35;
  EXPECT_EQ(remarks_of(c), Names{"pga"});
  EXPECT_TRUE(remarks(c, make_problem(c))[0].is_doubt);
  for (double& a : acceleration) a *= 0.051 * 9.80665 / 0.35;
  EXPECT_EQ(remarks_of(c), Names{});
  for (double& a : acceleration) a *= 2.45 / 0.051;
  EXPECT_EQ(remarks_of(c), Names{});
  for (double& a : acceleration) a *= 2.55 / 2.45;
  EXPECT_EQ(remarks_of(c), Names{"pga"});
}

// A table in g that is read as of cm/s².
TEST(Remarks, OfASpectrumInAnotherUnit) {
  Case c = ordinary();
  const auto with = [&](double ordinate) {
    c.excitation.spectrum =
        SpectrumSpec{.spectrum = {TableSpectrum{{0.1, 1}, {ordinate * c.units.gravity, 0}}}, .shape = "table"};
    c.excitation.motion = NoMotion{};
    std::vector<bool> doubts;
    for (const Remark& one : remarks(c, make_still_problem(c))) {
      if (one.key == "spectrum") doubts.push_back(one.is_doubt);
    }
    return doubts;
  };
  EXPECT_EQ(with(1), std::vector<bool>{});
  EXPECT_EQ(with(0.09), std::vector<bool>{false});
  EXPECT_EQ(with(1.0 / 981), std::vector<bool>{true});
  EXPECT_EQ(with(0), std::vector<bool>{true});
  EXPECT_EQ(with(80), std::vector<bool>{true});
}

// Times in milliseconds that are taken for seconds, and records that are cut or joined.
TEST(Remarks, OfARecordAlone) {
  const auto of = [](double step, long count, double pga) {
    RecordEcho record;
    record.time_step = step;
    record.count = count;
    record.duration = static_cast<double>(count - 1) * step;
    record.pga = pga;
    std::vector<std::string> names;
    for (const Remark& remark : remarks(record, ordinary().units)) names.push_back(remark.key);
    return names;
  };
  EXPECT_EQ(of(0.01, 4000, 3), Names{});
  EXPECT_EQ(of(0.1, 400, 3), Names{});
  EXPECT_EQ(of(10, 4000, 3), (Names{"record_step", "record_length"}));
  EXPECT_EQ(of(0.101, 4000, 3), Names{"record_step"});
  EXPECT_EQ(of(0.01, 500, 3), Names{"record_length"});  // 4.99 s
  EXPECT_EQ(of(0.01, 501, 3), Names{});
  EXPECT_EQ(of(0.01, 60002, 3), Names{"record_length"});
  EXPECT_EQ(of(0.01, 4000, 930), Names{"pga"});  // cm/s² for g
  EXPECT_EQ(of(0.01, 4000, 0), Names{"motion_of_zeros"});
}

TEST(Remarks, OfTheRecordOfACase) {
  Case c = ordinary();
  c.excitation.record = RecordEcho{};
  c.excitation.record->time_step = 10;
  c.excitation.record->count = 200;
  c.excitation.record->duration = 1990;
  EXPECT_EQ(remarks_of(c), (Names{"record_length", "record_step"}));
  // Of a suite each record has its own.
  auto suite = std::make_shared<SuiteSpec>();
  suite->records.resize(2);
  suite->records[1].echo = *c.excitation.record;
  suite->records[1].echo.file = "ms.csv";
  c.excitation.record.reset();
  c.excitation.suite = suite;
  const std::vector<Remark> found = remarks(c, make_still_problem(c));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].subject, "ms.csv");
  EXPECT_EQ(found[0].key, "record_step");
}

TEST(Remarks, OfWeightsAndOfStiffnessScaledToAPeriod) {
  Case c = ordinary();
  const double period = 2 * std::numbers::pi / make_building(c.buildings[0]).first_omega();
  c.buildings[0].calibrate_period = 1.7 * period;
  EXPECT_EQ(remarks_of(c), Names{});
  c.buildings[0].calibrate_period = 2 * period;
  EXPECT_EQ(remarks_of(c), Names{"stiffness_factor A"});
  EXPECT_NEAR(remarks(c, make_problem(c))[0].value, 0.25, 1e-12);
  // Kilograms for tonnes, which a period that is asked for hides.
  c = ordinary();
  for (PlaneFrame* frame : {&frame_of(c, 0), &frame_of(c, 1)}) {
    for (double& mass : frame->floor_masses) mass *= 1000;
  }
  c.buildings[1].calibrate_period = period;
  c.buildings[1].width = 10.0;
  const Names heavy = remarks_of(c);
  EXPECT_NE(std::find(heavy.begin(), heavy.end(), "storey_weight B"), heavy.end());
  EXPECT_NE(std::find(heavy.begin(), heavy.end(), "storey_weight_per_width B"), heavy.end());
  EXPECT_EQ(std::find(heavy.begin(), heavy.end(), "storey_weight_per_width A"), heavy.end()) << "no width is known";
}

TEST(Remarks, OfFloorsThatMeetFarApart) {
  Case c = ordinary();
  frame_of(c, 1).storey_heights = {3.5, 3.55, 2.45};  // 0.55 m apart, the beams are 0.5 m deep
  c.gaps[0].level_tolerance = 0.6;
  c.gaps[0].elevations = {3.5, 6.775, 9.5};
  EXPECT_EQ(remarks_of(c), Names{"level_tolerance A | B"});
  EXPECT_NEAR(remarks(c, make_problem(c))[0].value, 0.55, 1e-12);
  for (Section& beam : frame_of(c, 1).beams) beam = {.area = 0.2, .inertia = 0.3 * 0.125 / 12 * 3, .line_mass = 0.375};
  EXPECT_EQ(remarks_of(c), Names{}) << "the upper floor's beam reaches down far enough";
}

TEST(Remarks, OfFillersAndOfFactorsOnMotions) {
  Case c = ordinary();
  c.gaps[0].widths = {0, 0, 0};
  c.gaps[0].contact.axial = false;
  c.gaps[0].contact.numbers["stiffness"] = {1e6};  // kN/m
  EXPECT_EQ(remarks_of(c), Names{});
  c.gaps[0].contact.numbers["stiffness"] = {5e3};
  EXPECT_EQ(remarks_of(c), Names{"soft_contact A | B"});
  c.gaps[0].widths = {0.01, 0.01, 0.01};
  EXPECT_EQ(remarks_of(c), Names{});
  c.code.rules = {{.rule = "en-1998-1", .numbers = {{"behaviour_factor", {3.9}}}},
                  {.rule = "is-1893-1", .numbers = {{"response_reduction", {1.0}}}}};
  EXPECT_EQ(remarks_of(c), Names{"code_on_record en-1998-1"});
  EXPECT_EQ(remarks(c, make_problem(c))[0].value, 3.9);
}

// Damping that grows with frequency holds the node of a column that is struck.
TEST(Remarks, OfDampingWhereAColumnIsStruck) {
  Case c = ordinary();
  auto& nodes = frame_of(c, 0).nodes;
  nodes.push_back({.left = false, .elevation = 5.0});
  frame_of(c, 1).storey_heights = {5.0, 4.5};
  for (auto* list : {&frame_of(c, 1).columns, &frame_of(c, 1).beams}) list->resize(2);
  frame_of(c, 1).floor_masses.resize(2);
  c.gaps[0].strikes_columns = true;
  c.gaps[0].elevations = {5.0};
  c.gaps[0].widths = {0.05};
  c.gaps[0].contact.axial = false;
  c.gaps[0].contact.numbers["stiffness"] = {1e5};
  EXPECT_EQ(remarks_of(c), Names{});
  c.buildings[0].damping = StiffnessProportionalDamping{0.05};
  EXPECT_EQ(remarks_of(c), Names{"impact_damping A"});
  EXPECT_GT(remarks(c, make_problem(c))[0].value, 0.2);
}

TEST(Remarks, OfAResponseBeyondElasticBuildings) {
  const Case c = ordinary();
  const Problem problem = make_problem(c);
  Response response;
  response.buildings.resize(2);
  response.points.resize(3);
  const double weight = proportions(problem.buildings[0], c.units, nullptr).weight;
  for (BuildingPeaks& peaks : response.buildings) {
    peaks.drift_ratio = Eigen::Vector3d(0.002, 0.0099, 0.001);
    peaks.storey_shear = Eigen::Vector3d(0.399, 0.5, 0.6) * weight;  // of the first storey alone
  }
  response.points[2].peak_penetration = 0.049;
  EXPECT_EQ(list(remarks(c, problem, &response)), Names{});
  response.buildings[1].drift_ratio(2) = 0.0101;
  response.buildings[0].storey_shear(0) = 0.401 * weight;
  response.points[2].peak_penetration = 0.051;
  response.points[0].slow_starts = 1;
  response.points[1].slow_starts = 3;
  const std::vector<Remark> found = remarks(c, problem, &response);
  EXPECT_EQ(list(found), (Names{"base_shear A", "drift B", "penetration A | B", "slow_starts A | B"}));
  EXPECT_NEAR(found[0].value, 0.401, 1e-12);
  EXPECT_NEAR(found[1].value, 1.01, 1e-12);
  EXPECT_EQ(found[3].value, 4);  // of all points of the gap
}

// Of a building the larger of both runs, by a key of its own where that is the one without contact.
TEST(Remarks, SayOfWhichRunTheyAre) {
  const Case c = ordinary();
  const Problem problem = make_problem(c);
  Response response;
  response.buildings.resize(2);
  response.points.resize(3);
  const double weight = proportions(problem.buildings[0], c.units, nullptr).weight;
  BuildingPeaks &quieter = response.buildings[0], &thrown = response.buildings[1];
  quieter.drift_ratio = thrown.drift_ratio_no_contact = Eigen::Vector3d::Constant(0.011);
  quieter.drift_ratio_no_contact = thrown.drift_ratio = Eigen::Vector3d::Constant(0.012);
  quieter.storey_shear = thrown.storey_shear_no_contact = Eigen::Vector3d::Constant(0.45 * weight);
  quieter.storey_shear_no_contact = thrown.storey_shear = Eigen::Vector3d::Constant(0.5 * weight);
  const std::vector<Remark> found = remarks(c, problem, &response);
  EXPECT_EQ(list(found), (Names{"base_shear B", "base_shear_alone A", "drift B", "drift_alone A"}));
  for (const Remark& one : found) EXPECT_NEAR(one.value, one.unit == "%" ? 1.2 : 0.5, 1e-9) << one.key;
  thrown = quieter;
  thrown.drift_ratio_no_contact = quieter.drift_ratio_no_contact = quieter.drift_ratio * (1 + 1e-12);
  thrown.storey_shear_no_contact = quieter.storey_shear_no_contact = quieter.storey_shear * (1 + 1e-12);
  EXPECT_EQ(list(remarks(c, problem, &response)), (Names{"base_shear A", "base_shear B", "drift A", "drift B"}));
}

// Of a building that yields, of either run; nothing of its base shear, which it bounds by itself.
TEST(Remarks, OfYieldingBeyondWhatBuildingsBear) {
  const Case c = ordinary();
  const Problem problem = make_problem(c);
  Response response;
  response.buildings.resize(2);
  response.points.resize(3);
  const double not_known = std::numeric_limits<double>::quiet_NaN();
  for (BuildingPeaks& peaks : response.buildings) {
    peaks.drift_ratio = peaks.drift_ratio_no_contact = Eigen::Vector3d(0.0249, 0.01, 0.01);
    peaks.yielding.ductility = peaks.yielding_no_contact.ductility = Eigen::Vector3d(7.9, not_known, 2);
    peaks.storey_shear = Eigen::Vector3d(1e9, 0, 0);
  }
  EXPECT_EQ(list(remarks(c, problem, &response)), Names{});
  response.buildings[0].yielding_no_contact.ductility(2) = 8.1;
  response.buildings[1].drift_ratio(1) = 0.0251;
  const std::vector<Remark> found = remarks(c, problem, &response);
  EXPECT_EQ(list(found), (Names{"drift_yielding B", "ductility A"}));
  EXPECT_NEAR(found[0].value, 8.1, 1e-12);
  EXPECT_NEAR(found[1].value, 2.51, 1e-12);
}

// Of an isolated building its bearings, which are made for it, are left out.
TEST(Remarks, LeaveTheDuctilityOfBearingsOut) {
  Case c = ordinary();
  c.gaps[0].contact.axial = false;
  c.gaps[0].contact.numbers = {{"stiffness", {1e6}}};
  c.buildings[0].isolation = IsolationSpec{.mass = 30, .numbers = {{"stiffness", 1500}}};
  const Problem problem = make_problem(c);
  Response response;
  response.buildings.resize(2);
  response.points.resize(3);
  response.buildings[0].yielding.ductility = Eigen::Vector4d(40, 2, 2, 2);
  EXPECT_EQ(list(remarks(c, problem, &response)), Names{});
  response.buildings[0].yielding.ductility(1) = 40;
  EXPECT_EQ(list(remarks(c, problem, &response)), Names{"ductility A"});
}

// Millimetres among metres, of two things that each have a range of their own.
TEST(Remarks, OfDimensionsInTheWrongUnit) {
  const auto found = [](const Case& c, const std::string& subject) {
    const std::vector<Remark> all = remarks(c, make_problem(c));
    const auto one = std::find_if(all.begin(), all.end(), [&](const Remark& remark) {
      return remark.key == "dimension" && remark.subject == subject;
    });
    return one == all.end() ? std::nullopt : std::optional(*one);
  };
  Case c = ordinary();
  c.gaps[0].contact.axial = false;
  c.gaps[0].contact.numbers = {{"stiffness", {1e6}}};
  c.buildings[0].isolation = IsolationSpec{
      .mass = 30, .numbers = {{"stiffness", 500}, {"characteristic_strength", 50}, {"yield_displacement", 0.01}}};
  frame_of(c, 1).infills = {Infill{.thickness = 0.15, .modulus = 3e6, .strength = 3e3}, std::nullopt, std::nullopt};
  EXPECT_FALSE(found(c, "A, yield_displacement"));
  EXPECT_FALSE(found(c, "B, infill.thickness"));
  c.buildings[0].isolation->numbers["yield_displacement"] = 10;
  frame_of(c, 1).infills[0]->thickness = 150;
  const auto yields = found(c, "A, yield_displacement"), panel = found(c, "B, infill.thickness");
  ASSERT_TRUE(yields && panel);
  EXPECT_TRUE(yields->is_doubt && panel->is_doubt);
  EXPECT_NEAR(yields->value, 10, 1e-12);
  EXPECT_NEAR(panel->value, 150, 1e-12);
  EXPECT_EQ(yields->unit, "m");
  EXPECT_NEAR(*yields->usual_to, 0.05, 1e-12);
  EXPECT_NEAR(*panel->usual_to, 0.5, 1e-12);
}

// By hand: floors 30 + beams 0.375 · 10 + three columns 0.4 over half the storeys that meet there.
TEST(Proportions, AreWhatOneComparesFirst) {
  const Case c = ordinary();
  const Building building = make_building(c.buildings[0]);
  BuildingPeaks peaks;
  peaks.storey_shear = Eigen::Vector3d(100, 0, 0);
  const Proportions found = proportions(building, c.units, &peaks);
  const double mass = 85 + 3 * 3.75 + 3 * 0.4 * (6.5 / 2 + 3.0 + 1.5);
  EXPECT_NEAR(found.weight, mass * 9.80665, 1e-9);
  EXPECT_NEAR(*found.base_shear_coefficient, 100 / (mass * 9.80665), 1e-12);
  EXPECT_NEAR(found.period_per_storey, 2 * std::numbers::pi / building.modes.omega(0) / 3, 1e-15);
}

}  // namespace
}  // namespace bentur
