// Runs in which a floor strikes the columns of a stick or a generic building.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bentur/io/case/case_toml.h"
#include "bentur/model/run_results.h"
#include "bentur/pounding/pounding.h"

namespace bentur {
namespace {

/// A lower building strikes the columns of a taller one between its floors. @param tall its structure
std::string case_of(const std::string& tall, double width, const std::string& law, const std::string& solver) {
  return fmt::format(R"(
[units]
length = "m"
force = "kN"
[[building]]
name = "Tall"
damping = 0.04
{}
[[building]]
name = "Low"
damping = 0.04
stick = {{ storey_heights = [4.2, 4.2], masses = [150, 140], stiffnesses = [9e4, 9e4] }}
[[gap]]
between = ["Tall", "Low"]
width = {:.17g}
elevations = [4.2, 8.4]
strikes_columns = true
contact = {}
[excitation]
kind = "harmonic"
period = 0.55
displacement_amplitude = 0.03
[analysis]
duration = 4.0
energy_audit = true
solver = "{}"
)",
                     tall, width, law, solver);
}

const std::string columns =
    "columns = { elastic_modulus = 25e6, inertia = [4e-3, 4e-3, 3e-3], mass = 3.0, number = 3 }";
std::string stick(const std::string& yields = "") {
  return fmt::format(
      "stick = {{ storey_heights = [3.4, 3.4, 3.4], masses = [120, 120, 100], stiffnesses = [1.6e5, 1.4e5, 1.2e5], "
      "{}{} }}",
      yields, columns);
}
const std::string generic =
    "generic = { storeys = 3, storey_height = 3.4, floor_mass = 120, period = 0.35, system = \"frame\", " + columns +
    " }";

constexpr const char* spring = R"({ law = "linear", stiffness = 3e5 })";

struct Solved {
  Case c;
  Problem problem;
  Response response;
};
Solved run(const std::string& text) {
  Diagnostics diagnostics;
  const auto c = read_case_text(text, "case.toml", diagnostics);
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  Problem problem = make_problem(*c);
  Response response = solve(problem, c->analysis.solver, solve_options(*c));
  return {*c, std::move(problem), std::move(response)};
}

TEST(StruckStick, BothSolversAgreeAndEnergyBalances) {
  for (const std::string& tall : {stick(), stick("yield_forces = [900, 800, 600], hardening = 0.05, "), generic}) {
    for (const char* const law : {spring, R"({ law = "kelvin-voigt", stiffness = 3e5, restitution = 0.65 })"}) {
      const Solved exact = run(case_of(tall, 0.01, law, "exact")), adaptive = run(case_of(tall, 0.01, law, "adaptive"));
      ASSERT_EQ(exact.response.status, Status::done);
      ASSERT_GT(exact.response.impacts.size(), 3U) << tall;
      ASSERT_EQ(exact.response.impacts.size(), adaptive.response.impacts.size()) << tall;
      EXPECT_LE(exact.response.energy->relative_residual(), 1e-12) << tall;
      for (std::size_t i = 0; i < exact.response.points.size(); ++i) {
        const PointSummary &a = exact.response.points[i], &b = adaptive.response.points[i];
        ASSERT_TRUE(a.column);
        EXPECT_NEAR(a.peak_force, b.peak_force, 1e-7 * a.peak_force) << tall;
        EXPECT_NEAR(a.column->shear, b.column->shear, 1e-7 * a.column->shear) << tall;
        EXPECT_NEAR(a.column->moment, b.column->moment, 1e-7 * a.column->moment) << tall;
        // A blow bends the column more than the storeys' drifts do.
        if (a.impacts > 0) {
          EXPECT_GT(a.column->shear, a.column->shear_no_contact) << tall;
        }
      }
    }
  }
}

}  // namespace
}  // namespace bentur
