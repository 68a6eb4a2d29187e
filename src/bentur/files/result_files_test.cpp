#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "bentur/files/netcdf.h"
#include "bentur/files/result_netcdf.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/io/results/result_json.h"
#include "bentur/io/results/run_variables.h"

namespace bentur {
namespace {

using Json = nlohmann::json;

/// Two sticks with two and one floors that meet at 3 m, and a response made up so that every number is its own.
struct Fixture {
  Fixture() {
    c.title = "A \"title\"";
    c.units = {.length = "m", .force = "tf", .gravity = 9.80665};
    BuildingSpec left;
    left.name = "Left, old";
    left.structure = Stick{.storey_heights = {3, 3}, .masses = {20, 20}, .stiffnesses = {2e4, 2e4}};
    left.damping = ModalDamping{{0.05}};
    BuildingSpec right;
    right.name = "Right";
    right.structure = Stick{.storey_heights = {3}, .masses = {20}, .stiffnesses = {2e4}};
    right.damping = ModalDamping{{0.05}};
    c.buildings = {left, right};
    GapSpec gap;
    gap.widths = {0.1};
    gap.elevations = {3};
    gap.contact = {.law = "kelvin-voigt",
                   .numbers = {{"stiffness", {1e6}}, {"restitution", {0.65}}},
                   .words = {{"release", "separation"}}};
    c.gaps = {gap};
    c.excitation.motion = HarmonicMotion{.period = 0.5, .displacement_amplitude = 0.01};
    c.excitation.delays = {0, 0.25};
    c.analysis.duration = 2;
    problem = make_problem(c);

    response.steps = 7;
    response.events = 2;
    response.wall_time = 0.125;
    for (const Eigen::Index floors : {2, 1}) {
      BuildingPeaks peaks;
      peaks.displacement = Eigen::VectorXd::LinSpaced(floors, 1, 2);
      peaks.displacement_no_contact = Eigen::VectorXd::Constant(floors, 0.5);
      peaks.drift_ratio = Eigen::VectorXd::Constant(floors, 0.25);
      peaks.acceleration = Eigen::VectorXd::Constant(floors, 8);
      peaks.storey_shear = Eigen::VectorXd::Constant(floors, 16);
      response.buildings.push_back(peaks);
    }
    response.buildings[1].displacement_no_contact(0) = 0;
    response.points.resize(1);
    response.points[0].gap_needed = 0.3;
  }

  void add_histories() {
    Histories& h = response.histories;
    h.time = {0, 0.5, 1};
    h.ground_acceleration = {0, -1, 1};
    for (const Eigen::Index floors : {2, 1}) {
      Eigen::MatrixXd values(floors, 3);
      for (Eigen::Index i = 0; i < values.size(); ++i) {
        values(i % floors, i / floors) = static_cast<double>(10 * (i % floors) + i / floors);  // 10·floor + sample
      }
      h.displacement.push_back(values);
      h.velocity.push_back(2 * values);
      h.acceleration.push_back(3 * values);
      h.drift_ratio.push_back(4 * values);
      h.storey_shear.push_back(5 * values);
    }
    h.opening = Eigen::RowVector3d(0.1, 0, -0.1);
    h.force = Eigen::RowVector3d(0, 0, 1e5);
  }

  void add_energy() {
    response.energy = EnergyAudit{.peak_input = 8, .residual = 2, .histories = {}};
    EnergyHistories& e = response.energy->histories;
    e.time = response.histories.time;
    double first = 0;
    for (Eigen::VectorXd* curve :
         {&e.input, &e.kinetic, &e.strain, &e.damping, &e.hysteretic, &e.contact_stored, &e.contact_lost}) {
      *curve = Eigen::VectorXd::LinSpaced(3, first, first + 2);
      first += 10;
    }
  }

  /// The lower storey of the left building can yield; two tables of links, of two and of one.
  void add_yielding_and_links() {
    std::get<Stick>(c.buildings[0].structure).yield_forces = {5, std::numeric_limits<double>::infinity()};
    c.links = {{.elevations = {3}, .law = "cable", .numbers = {{"stiffness", {50}}}},
               {.elevations = {3}, .law = "yielding", .numbers = {{"stiffness", {70}}, {"yield_force", {2}}}}};
    problem = make_problem(c);
    const double none = std::numeric_limits<double>::quiet_NaN();
    response.buildings[0].yielding = {Eigen::Vector2d(2.5, none), Eigen::Vector2d(-0.01, 0), Eigen::Vector2d(40, 0)};
    response.buildings[0].yielding_no_contact = {Eigen::Vector2d(1.5, none), Eigen::Vector2d(0.02, 0),
                                                 Eigen::Vector2d(30, 0)};
    response.links = {
        {.peak_compression = 0, .peak_tension = 4, .peak_closing = 0.3, .peak_opening = 0.2},
        {.peak_compression = 2.5, .peak_tension = 2, .peak_closing = 0.3, .peak_opening = 0.2, .energy_dissipated = 7}};
  }

  [[nodiscard]] RunResults results() const { return run_results(c, problem, response); }

  Case c;
  Problem problem;
  Response response;
};

TEST(SummaryJson, HasEveryKeyOfTheContractAndNullsWhereNothingIs) {
  Fixture f;
  const Json json = Json::parse(summary_json(f.results(), "1.2.3"));
  EXPECT_EQ(json["title"], "A \"title\"");
  EXPECT_EQ(json["units"], (Json{{"length", "m"}, {"force", "tf"}}));
  EXPECT_EQ(json["version"], "1.2.3");
  EXPECT_EQ(json["solver"], (Json{{"name", "exact"},
                                  {"steps", 7},
                                  {"events", 2},
                                  {"wall_time", 0.125},
                                  {"energy_residual", nullptr},
                                  {"end_time", 0.0},
                                  {"peak_input_energy", nullptr}}));
  EXPECT_EQ(json["excitation"]["kind"], "harmonic");
  EXPECT_EQ(json["excitation"]["delays"], (Json{0.0, 0.25}));
  const Json& left = json["buildings"][0];
  EXPECT_EQ(left["name"], "Left, old");
  EXPECT_EQ(left["elevations"], (Json{3.0, 6.0}));
  EXPECT_EQ(left["periods"].size(), 2U);
  EXPECT_EQ(left["peak_displacement"], (Json{1.0, 2.0}));
  EXPECT_EQ(left["amplification"], (Json{2.0, 4.0}));
  EXPECT_EQ(left["peak_storey_shear"], (Json{16.0, 16.0}));
  EXPECT_EQ(json["buildings"][1]["amplification"], Json::array({nullptr}));
  const Json& gap = json["gaps"][0];
  EXPECT_EQ(gap["between"], (Json{"Left, old", "Right"}));
  EXPECT_EQ(gap["gap_needed"], 0.3);
  // ξ = −ln e/√(π² + ln² e), exact where contact ends at separation; c = 2ξ√(k m_e), m_e = 10.
  const double ratio = -std::log(0.65) / std::hypot(std::numbers::pi, std::log(0.65));
  Json point = gap["points"][0];
  EXPECT_NEAR(point["contact"]["damping_ratio"].get<double>(), ratio, 1e-15);
  EXPECT_NEAR(point["contact"]["damping"].get<double>() / (2 * ratio * std::sqrt(1e7)), 1, 1e-14);
  point["contact"].erase("damping_ratio");
  point["contact"].erase("damping");
  EXPECT_EQ(point, (Json{{"elevation", 3.0},
                         {"width", 0.1},
                         {"gap_needed", 0.3},
                         {"gap_needed_reversed", nullptr},
                         {"peak_left_no_contact", nullptr},
                         {"peak_right_no_contact", nullptr},
                         {"impacts", 0},
                         {"slow_starts", 0},
                         {"settling", 0},
                         {"contact_duration", 0.0},
                         {"peak_force", 0.0},
                         {"peak_force_time", nullptr},
                         {"peak_penetration", 0.0},
                         {"peak_closing_speed", 0.0},
                         {"impulse", 0.0},
                         {"energy_lost", 0.0},
                         {"peak_tension", 0.0},
                         {"contact",
                          {{"law", "kelvin-voigt"},
                           {"stiffness", 1e6},
                           {"restitution", 0.65},
                           {"release", "separation"},
                           {"calibration", "exact"}}},
                         {"restitution", {{"asked", 0.65}, {"smallest", nullptr}, {"largest", nullptr}}}}));
}

TEST(SummaryJson, YieldingOfBuildingsThatCanAndLinksTableByTable) {
  Fixture f;
  const Json without = Json::parse(summary_json(f.results(), "1"));
  EXPECT_FALSE(without.contains("links"));
  EXPECT_FALSE(without["buildings"][0].contains("ductility"));
  f.add_yielding_and_links();
  const Json json = Json::parse(summary_json(f.results(), "1"));
  EXPECT_EQ(json["status"], "completed");
  const Json& left = json["buildings"][0];
  EXPECT_EQ(left["ductility"], (Json{2.5, nullptr}));
  EXPECT_EQ(left["residual_drift_ratio"], (Json{-0.01, 0.0}));
  EXPECT_EQ(left["hysteretic_energy"], (Json{40.0, 0.0}));
  EXPECT_EQ(left["ductility_no_contact"], (Json{1.5, nullptr}));
  EXPECT_EQ(left["residual_drift_ratio_no_contact"], (Json{0.02, 0.0}));
  EXPECT_EQ(left["hysteretic_energy_no_contact"], (Json{30.0, 0.0}));
  for (const char* key : {"ductility", "residual_drift_ratio", "hysteretic_energy_no_contact"}) {
    EXPECT_FALSE(json["buildings"][1].contains(key)) << key;
  }
  ASSERT_EQ(json["links"].size(), 2U);
  EXPECT_EQ(json["links"][0]["between"], (Json{"Left, old", "Right"}));
  EXPECT_EQ(json["links"][0]["points"],
            (Json::array({{{"elevation", 3.0},
                           {"peak_compression", 0.0},
                           {"peak_tension", 4.0},
                           {"peak_closing", 0.3},
                           {"peak_opening", 0.2},
                           {"energy_dissipated", 0.0},
                           {"link", {{"law", "cable"}, {"stiffness", 50}, {"slack", 0}}}}})));
  const Json& second = json["links"][1]["points"][0];
  EXPECT_EQ(second["peak_compression"], 2.5);
  EXPECT_EQ(second["energy_dissipated"], 7);
  EXPECT_EQ(second["link"], (Json{{"law", "yielding"}, {"stiffness", 70}, {"yield_force", 2}, {"hardening", 0}}));
}

TEST(SummaryJson, RestitutionOfTheImpactsThatHaveEnded) {
  Fixture f;
  const auto impact = [](double closing, double separation, bool open_ended) {
    return Impact{.open_ended = open_ended, .closing_speed = closing, .separation_speed = separation};
  };
  f.response.impacts = {impact(2, 1, false), impact(4, 3, false), impact(4, 1, true), impact(0, 1, false)};
  const Json point = Json::parse(summary_json(f.results(), "1"))["gaps"][0]["points"][0];
  EXPECT_EQ(point["restitution"], (Json{{"asked", 0.65}, {"smallest", 0.5}, {"largest", 0.75}}));
  f.c.gaps[0].contact = {.law = "linear", .numbers = {{"stiffness", {1e6}}}};
  f.problem = make_problem(f.c);
  const Json linear = Json::parse(summary_json(f.results(), "1"))["gaps"][0]["points"][0];
  EXPECT_EQ(linear["contact"], (Json{{"law", "linear"}, {"stiffness", 1e6}}));
  EXPECT_EQ(linear["restitution"], (Json{{"asked", nullptr}, {"smallest", 0.5}, {"largest", 0.75}}));
}

TEST(SummaryJson, EachSolverWithItsNumberAndTheAudit) {
  Fixture f;
  f.add_energy();
  f.c.analysis.solver = AdaptiveSolver{.tolerance = 1e-7};
  Json solver = Json::parse(summary_json(f.results(), "1"))["solver"];
  EXPECT_EQ(solver["name"], "adaptive");
  EXPECT_EQ(solver["tolerance"], 1e-7);
  EXPECT_EQ(solver["energy_residual"], 0.25);
  EXPECT_EQ(solver["peak_input_energy"], 8.0);
  f.c.analysis.solver = RungeKuttaSolver{.step = 0.002};
  solver = Json::parse(summary_json(f.results(), "1"))["solver"];
  EXPECT_EQ(solver["name"], "runge-kutta");
  EXPECT_EQ(solver["step"], 0.002);
}

TEST(SummaryJson, EchoesTheRecord) {
  Fixture f;
  f.c.excitation.record = RecordEcho{.file = "a.csv",
                                     .path = "/somewhere/a.csv",
                                     .size = 77,
                                     .sha256 = "0123",
                                     .format = "two-column",
                                     .unit = "g",
                                     .time_step = 0.02,
                                     .count = 3,
                                     .duration = 0.04,
                                     .pga_read = 0.3,
                                     .pga = 2.9};
  const Json json = Json::parse(summary_json(f.results(), "1"))["excitation"];
  EXPECT_EQ(json["kind"], "record");
  EXPECT_EQ(json["file"], "a.csv");
  EXPECT_EQ(json["count"], 3);
  EXPECT_EQ(json["pga"], 2.9);
  EXPECT_EQ(json["size"], 77);
  EXPECT_EQ(json["sha256"], "0123");
  EXPECT_EQ(json.dump().find("somewhere"), std::string::npos) << "no path of this machine";
}

// The shortest decimal that reads back to the same double must be written, whatever the number.
TEST(SummaryJson, NumbersSurviveToTheLastBit) {
  Fixture f;
  f.response.points[0].peak_force = 0.1 + 0.2;
  f.response.points[0].impulse = std::numeric_limits<double>::denorm_min();
  const Json json = Json::parse(summary_json(f.results(), "1"));
  EXPECT_EQ(json["gaps"][0]["points"][0]["peak_force"].get<double>(), 0.1 + 0.2);
  EXPECT_EQ(json["gaps"][0]["points"][0]["impulse"].get<double>(), std::numeric_limits<double>::denorm_min());
}

TEST(ModesJson, ShapesAreMassNormalisedAndFractionsAddUpToOne) {
  const Fixture f;
  const Json json = Json::parse(modes_json(f.problem, f.c.units))["buildings"];
  ASSERT_EQ(json.size(), 2U);
  const Json& left = json[0];
  for (const Json& shape : left["shapes"]) {
    EXPECT_NEAR(
        20 * (shape[0].get<double>() * shape[0].get<double>() + shape[1].get<double>() * shape[1].get<double>()), 1,
        1e-12);
  }
  EXPECT_NEAR(left["effective_mass_fraction"][0].get<double>() + left["effective_mass_fraction"][1].get<double>(), 1,
              1e-12);
  EXPECT_GT(left["periods"][0].get<double>(), left["periods"][1].get<double>());
  EXPECT_EQ(left["participation"].size(), 2U);
}

TEST(GapJson, AGapsOwnValuesAreTheLargestOfItsLevels) {
  Fixture f;
  f.problem.points.push_back(f.problem.points[0]);
  f.problem.watched.clear();
  f.response.watched.clear();
  f.response.points.assign(2, {});
  for (const std::size_t i : {0U, 1U}) {
    PointSummary& point = f.response.points[i];
    point.gap_needed = i == 0 ? 1 : 2;
    point.gap_needed_reversed = i == 0 ? 5 : 4;
    point.peak_left = i == 0 ? 3 : 6;
    point.peak_right = i == 0 ? 4 : 0.5;
  }
  const Json gap = Json::parse(gap_json(f.results(), "1"))["gaps"][0];
  EXPECT_EQ(gap["gap_needed"], 2.0);
  EXPECT_EQ(gap["gap_needed_reversed"], 5.0);
  EXPECT_EQ(gap["abs"], 7.0);
  EXPECT_EQ(gap["srss"], std::hypot(6, 0.5));
  EXPECT_EQ(gap["points"][1]["gap_needed"], 2.0);
  EXPECT_EQ(gap["points"][1]["gap_needed_reversed"], 4.0);
  EXPECT_EQ(gap["points"][1]["abs"], 6.5);
  EXPECT_EQ(gap["points"][0]["srss"], 5.0);
}

TEST(ImpactsCsv, OneRowPerImpactUnderAHeaderWithUnits) {
  Fixture f;
  Impact impact{.point = 0,
                .start = 0.5,
                .end = 0.75,
                .open_ended = true,
                .closing_speed = 0.1,
                .separation_speed = 0.2,
                .peak_force = 3,
                .peak_force_time = 0.625,
                .peak_penetration = 0.001,
                .impulse = 4,
                .peak_tension = 6,
                .energy_lost = 5};
  f.response.impacts = {impact};
  impact.open_ended = false;
  f.response.impacts.push_back(impact);
  EXPECT_EQ(impacts_csv({f.problem, f.response, f.c.units}),
            "left,right,elevation [m],struck,start [s],end [s],open_ended,settling,closing_speed "
            "[m/s],separation_speed [m/s],"
            "restitution,peak_force [tf],peak_force_time [s],peak_penetration [m],impulse [tf s],energy_lost [tf m],"
            "peak_tension [tf],duration [s]\n"
            "\"Left, old\",Right,3,,0.5,0.75,1,0,0.1,0.2,,3,0.625,0.001,4,5,6,0.25\n"
            "\"Left, old\",Right,3,,0.5,0.75,0,0,0.1,0.2,2,3,0.625,0.001,4,5,6,0.25\n");
}

/// Reads one variable back.
std::vector<double> values(const NetcdfReader& file, const std::string& name,
                           const std::vector<std::size_t>& expected_shape) {
  EXPECT_EQ(file.at(name).shape, expected_shape) << name;
  return file.numbers(name);
}

TEST(HistoriesNetcdf, ReadsBackWithUnitsAndCoordinates) {
  Fixture f;
  f.add_histories();
  const NetcdfReader file(histories_netcdf(f.results(), "1.2.3"), "histories.nc");
  EXPECT_EQ(values(file, "time", {3}), (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(values(file, "ground_acceleration", {3}), (std::vector<double>{0, -1, 1}));
  EXPECT_EQ(values(file, "elevation_1", {2}), (std::vector<double>{3, 6}));
  EXPECT_EQ(values(file, "displacement_1", {3, 2}), (std::vector<double>{0, 10, 1, 11, 2, 12}));
  EXPECT_EQ(values(file, "velocity_2", {3, 1}), (std::vector<double>{0, 2, 4}));
  EXPECT_EQ(values(file, "acceleration_2", {3, 1}), (std::vector<double>{0, 3, 6}));
  EXPECT_EQ(values(file, "drift_ratio_1", {3, 2}), (std::vector<double>{0, 40, 4, 44, 8, 48}));
  EXPECT_EQ(values(file, "storey_shear_1", {3, 2}), (std::vector<double>{0, 50, 5, 55, 10, 60}));
  EXPECT_EQ(values(file, "base_shear_1", {3}), (std::vector<double>{0, 5, 10}));
  EXPECT_EQ(file.attribute("drift_ratio_1", "units"), "1");
  EXPECT_EQ(file.attribute("base_shear_2", "units"), "1000 kgf");
  EXPECT_EQ(values(file, "opening", {3, 1}), (std::vector<double>{0.1, 0, -0.1}));
  EXPECT_EQ(values(file, "force", {3, 1}), (std::vector<double>{0, 0, 1e5}));
  EXPECT_EQ(values(file, "point_width", {1}), (std::vector<double>{0.1}));
  EXPECT_EQ(values(file, "building_delay", {2}), (std::vector<double>{0, 0.25}));
  EXPECT_EQ(file.attribute("Conventions"), "CF-1.8");
  EXPECT_EQ(file.attribute("title"), "A \"title\"");
  EXPECT_EQ(file.attribute("history"), "written by bentur 1.2.3");
  EXPECT_EQ(file.attribute("bentur_version"), "1.2.3");
  EXPECT_EQ(file.attribute("time", "units"), "s");
  EXPECT_EQ(file.attribute("acceleration_1", "units"), "m s-2");
  EXPECT_EQ(file.attribute("force", "units"), "1000 kgf");  // tf, as UDUNITS knows it
  EXPECT_NE(file.attribute("displacement_1", "long_name").find("Left, old"), std::string::npos);
  for (const StoredVariable& variable : file.variables()) {
    EXPECT_NE(variable.long_name, "") << variable.name;
    EXPECT_EQ(variable.units.empty(), variable.text) << variable.name;
  }
}

TEST(HistoriesNetcdf, EnergyCurvesWithAnAuditOnly) {
  Fixture f;
  f.add_histories();
  const std::vector<std::string> parts = {"input",      "kinetic",        "strain",      "damping",
                                          "hysteretic", "contact_stored", "contact_lost"};
  for (const bool audited : {false, true}) {
    if (audited) f.add_energy();
    const NetcdfReader file(histories_netcdf(f.results(), "1"), "histories.nc");
    double first = 0;
    for (const std::string& part : parts) {
      const std::string name = "energy_" + part;
      if (!audited) {
        EXPECT_EQ(file.find(name), nullptr) << name;
        continue;
      }
      EXPECT_EQ(values(file, name, {3}), (std::vector<double>{first, first + 1, first + 2}));
      EXPECT_EQ(file.at(name).units, "1000 kgf m");
      EXPECT_NE(file.at(name).long_name, "");
      first += 10;
    }
  }
}

TEST(HistoriesNetcdf, ImpactsPeaksAndModes) {
  Fixture f;
  f.add_histories();
  f.response.impacts = {{.point = 0, .start = 1, .end = 2, .peak_force = 3}, {.point = 0, .start = 4, .peak_force = 5}};
  const std::size_t count = f.response.impacts.size();
  const NetcdfReader file(histories_netcdf(f.results(), "1"), "histories.nc");
  const auto start = values(file, "impact_start", {count});
  const auto force = values(file, "impact_peak_force", {count});
  const auto point = values(file, "impact_point", {count});
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(start[i], f.response.impacts[i].start);
    EXPECT_EQ(force[i], f.response.impacts[i].peak_force);
    EXPECT_EQ(point[i], f.response.impacts[i].point);
  }
  const auto peaks = values(file, "peak_displacement_no_contact_1", {2});
  EXPECT_EQ(peaks[1], f.response.buildings[0].displacement_no_contact(1));
  const auto periods = values(file, "period_1", {2});
  EXPECT_DOUBLE_EQ(periods[0], 2 * std::numbers::pi / f.problem.buildings[0].modes.omega(0));
  // Two equal storeys: the first mode is (1, φ), the second (−φ, 1) by the golden ratio φ; largest sway 1.
  const auto shapes = values(file, "shape_1", {2, 2});
  EXPECT_NEAR(shapes[0], 1 / std::numbers::phi, 1e-12);
  EXPECT_NEAR(shapes[1], 1, 1e-12);
  EXPECT_NEAR(std::abs(shapes[2]), 1, 1e-12);
  EXPECT_NEAR(shapes[3] / shapes[2], -1 / std::numbers::phi, 1e-12);
  f.response.impacts.clear();  // then there is no such dimension
  const NetcdfReader without(histories_netcdf(f.results(), "1"), "histories.nc");
  EXPECT_EQ(without.find("impact_start"), nullptr);
}

TEST(HistoriesNetcdf, YieldingAndLinksAreReadBack) {
  Fixture f;
  f.add_yielding_and_links();
  f.add_histories();
  const NetcdfReader file(histories_netcdf(f.results(), "1"), "histories.nc");
  EXPECT_EQ(values(file, "residual_drift_ratio_1", {2}), (std::vector<double>{-0.01, 0}));
  EXPECT_EQ(values(file, "link_peak_tension", {2}), (std::vector<double>{4, 2}));
  EXPECT_EQ(file.at("link_energy_dissipated").units, "1000 kgf m");
  EXPECT_EQ(values(file, "link_elevation", {2}), (std::vector<double>{3, 3}));
  EXPECT_EQ(file.texts("link_right"), (std::vector<std::string>{"Right", "Right"}));
  EXPECT_EQ(file.find("ductility_2"), nullptr);  // nothing of it can yield
  const RunResults read = read_run(file);
  const auto& yielding = read.response.buildings[0].yielding;
  ASSERT_EQ(yielding.ductility.size(), 2);
  EXPECT_EQ(yielding.ductility(0), 2.5);
  EXPECT_TRUE(std::isnan(yielding.ductility(1)));
  EXPECT_EQ(read.response.buildings[0].yielding_no_contact.hysteretic_energy, Eigen::Vector2d(30, 0));
  EXPECT_EQ(read.response.buildings[1].yielding.ductility.size(), 0);
  ASSERT_EQ(read.problem.links.size(), 2U);
  EXPECT_EQ(read.problem.links[1].left, 0);
  EXPECT_EQ(read.problem.links[1].right, 1);
  EXPECT_EQ(read.problem.links[1].left_floor, 0);
  ASSERT_EQ(read.response.links.size(), 2U);
  EXPECT_EQ(read.response.links[0].peak_tension, 4);
  EXPECT_EQ(read.response.links[1].energy_dissipated, 7);
}

TEST(Tables, YieldingHasATableOfItsOwnWhereABuildingCan) {
  Fixture f;
  f.add_yielding_and_links();
  const RunResults results = f.results();
  const RunView run = results.view();
  const auto labels = [](const std::vector<TableColumn>& columns) {
    std::string list;
    for (const TableColumn& column : columns) list += column.label + "; ";
    return list;
  };
  const std::string of_floors = "Displacement; Without contact; Amplification; Drift; Without contact; ";
  for (const Eigen::Index b : {0, 1}) {
    EXPECT_EQ(labels(table_columns(Owner::floor, run, floors_of(f.problem, b))), of_floors);
    EXPECT_EQ(labels(table_columns(Owner::floor, run, floors_of(f.problem, b), 0, QuantityTable::forces)),
              "Acceleration; Without contact; Ratio; Storey shear; Without contact; Ratio; ");
  }
  EXPECT_EQ(labels(table_columns(Owner::floor, run, floors_of(f.problem, 0), 0, QuantityTable::yielding)),
            "Ductility; Residual drift; Energy by yielding; Ductility without contact; Residual drift without contact; "
            "Energy by yielding without contact; ");
  EXPECT_TRUE(table_columns(Owner::floor, run, floors_of(f.problem, 1), 0, QuantityTable::yielding).empty());
  const TableColumn ductility =
      table_columns(Owner::floor, run, floors_of(f.problem, 0), 0, QuantityTable::yielding).front();
  EXPECT_EQ(ductility.cells, (std::vector<std::string>{"2.500", "–"}));
  EXPECT_EQ(labels(table_columns(Owner::link, run, first_places(2))),
            "Peak push; Peak pull; Closing; Opening; Energy lost; ");
}

TEST(HistoriesNetcdf, TheSameHistoriesGiveTheSameBytes) {
  Fixture f;
  f.add_histories();
  EXPECT_EQ(histories_netcdf(f.results(), "1"), histories_netcdf(f.results(), "1"));
}

}  // namespace
}  // namespace bentur
