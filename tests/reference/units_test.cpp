// One case in three systems of units gives one set of dimensionless results.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bentur/io/case/case_toml.h"
#include "bentur/pounding/pounding.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

constexpr double kgf = 9.80665;  // [N]
constexpr double metre_in_cm = 100.0;

/// The monograph's M1-2 at 0.2 cm, given in cm and kgf, written in other units: `length` of them in a cm, `force` in a
/// kgf.
std::string m12(const std::string& length_unit, const std::string& force_unit, double length, double force) {
  const double mass = force / length;  // of force·s²/length
  const auto section = [&](double width, double depth, double m) {
    return fmt::format("{{ width = {:.17g}, depth = {:.17g}, mass = {:.17g} }}", width * length, depth * length,
                       m * mass);
  };
  const auto building = [&](const std::string& name, double beam, double first, double others) {
    const std::string upper = section(8, beam, others);
    return fmt::format(
        "[[building]]\nname = \"{}\"\ndamping = 0.05\n[building.frame]\nelastic_modulus = {:.17g}\n"
        "storey_heights = [{h:.17g}, {h:.17g}, {h:.17g}]\nbay_widths = [{h:.17g}]\ncolumns = [{}]\nbeams = [{}, {}, "
        "{}]\n",
        name, 2.1e5 * force / (length * length), section(10, 10, 0.024), section(9, beam, first), upper, upper,
        fmt::arg("h", 100 * length));
  };
  const double k = force / length;
  return fmt::format("[units]\nlength = \"{}\"\nforce = \"{}\"\n", length_unit, force_unit) +
         building("Model 1", 12, 0.206, 0.203) + building("Model 2", 10, 0.202, 0.199) +
         fmt::format(
             "[[gap]]\nbetween = [\"Model 1\", \"Model 2\"]\nwidth = {:.17g}\n"
             "contact = {{ law = \"linear\", stiffness = [{:.17g}, {:.17g}, {:.17g}] }}\n"
             "[excitation]\nkind = \"record\"\nfile = \"{}/data/el-centro-1940-ns.csv\"\nunit = \"g\"\npga = {:.17g}\n"
             "delays = [0.0, 0.1]\n[analysis]\nduration = 10.0\n",
             0.2 * length, 206181.818 * k, 183272.727 * k, 183272.727 * k, BENTUR_SOURCE_DIR, 341.7 * length);
}

/// Every result over a scale of its own dimension.
std::vector<double> dimensionless(const std::string& text, const std::string& name, double length, double force) {
  const fs::path file = fs::path(BENTUR_BINARY_DIR) / (name + ".toml");
  std::ofstream(file) << text;
  Diagnostics diagnostics;
  const auto c = read_case(file, diagnostics);
  for (const Diagnostic& error : diagnostics.errors()) ADD_FAILURE() << error.text();
  if (!c) return {};
  const Response response = solve(make_problem(*c));
  std::vector<double> numbers;
  const auto add = [&numbers](const Eigen::VectorXd& values, double scale) {
    for (const double x : values) numbers.push_back(x / scale);
  };
  for (const BuildingPeaks& peaks : response.buildings) {
    add(peaks.displacement, length);
    add(peaks.displacement_no_contact, length);
    add(peaks.drift_ratio, 1.0);
    add(peaks.acceleration, length);
    add(peaks.storey_shear, force);
  }
  for (const Impact& impact : response.impacts) {
    numbers.insert(numbers.end(),
                   {impact.start, impact.end, impact.closing_speed / length, impact.separation_speed / length,
                    impact.peak_force / force, impact.peak_penetration / length, impact.impulse / force});
  }
  for (const PointSummary& point : response.points) numbers.push_back(point.gap_needed / length);
  return numbers;
}

TEST(Units, ThreeSystemsOneAnswer) {
  const auto cm_kgf = dimensionless(m12("cm", "kgf", 1.0, 1.0), "m12-cm-kgf", 1.0, 1.0);
  ASSERT_GT(cm_kgf.size(), 100u);
  const struct {
    const char *length_unit, *force_unit;
    double length, force;
  } others[] = {{"m", "N", 1.0 / metre_in_cm, kgf}, {"mm", "N", 10.0, kgf}};
  for (const auto& other : others) {
    const auto numbers = dimensionless(m12(other.length_unit, other.force_unit, other.length, other.force),
                                       std::string("m12-") + other.length_unit + "-N", other.length, other.force);
    ASSERT_EQ(numbers.size(), cm_kgf.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      EXPECT_NEAR(numbers[i], cm_kgf[i], 1e-9 * std::max(std::abs(cm_kgf[i]), 1e-6)) << other.length_unit << " " << i;
    }
  }
}

}  // namespace
}  // namespace bentur
