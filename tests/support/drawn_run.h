#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

#include "bentur/io/case/case_toml.h"
#include "bentur/model/run_results.h"

namespace bentur::test {

/// A run with all that figures are drawn from.
inline RunResults drawn_run(const std::string& text, double output_step = 0.01) {
  Diagnostics diagnostics;
  auto c = read_case_text(text, std::string(BENTUR_SOURCE_DIR) + "/examples/case.toml", diagnostics);
  if (!c) throw std::runtime_error(diagnostics.errors().front().text());
  Problem problem = make_problem(*c);
  SolveOptions options;
  options.output_step = output_step;
  options.course = true;
  Response response = solve(problem, c->analysis.solver, options);
  RunResults results = run_results(std::move(*c), std::move(problem), std::move(response));
  results.figures = figure_data(results);
  return results;
}

/// Two sticks in mm, the roof of the lower one at a level of five digits.
inline std::string sticks_in_mm(double width, double storey) {
  const std::string heights = fmt::format("storey_heights = [4000, {0}, {0}, {0}]", storey);
  return fmt::format(R"(
units = {{ length = "mm", force = "N" }}
gap = [{{ between = ["A", "B"], width = {}, contact = {{ law = "linear", stiffness = 4e5 }} }}]
excitation = {{ kind = "harmonic", period = 0.7, displacement_amplitude = 50.0 }}
analysis = {{ duration = 5.0 }}
[[building]]
name = "A"
damping = 0.05
stick = {{ {heights}, masses = [100, 100, 100, 90], stiffnesses = [9e4, 8e4, 8e4, 7e4] }}
[[building]]
name = "B"
damping = 0.05
stick = {{ {heights}, masses = [80, 80, 70, 60], stiffnesses = [1.5e5, 1.4e5, 1.3e5, 1.2e5] }}
)",
                     width, fmt::arg("heights", heights));
}

/// Two sticks in newtons, joined at two levels: by a link that yields and by springs with dashpots.
inline const char* const linked = R"(
units = { length = "m", force = "N" }
excitation = { kind = "harmonic", period = 0.7, displacement_amplitude = 0.03 }
analysis = { duration = 5.0 }
[[building]]
name = "A"
damping = 0.05
stick = { storey_heights = [4, 3], masses = [100e3, 90e3], stiffnesses = [9e7, 8e7] }
[[building]]
name = "B"
damping = 0.05
stick = { storey_heights = [4, 3], masses = [80e3, 60e3], stiffnesses = [1.5e7, 1.2e7] }
[[gap]]
between = ["A", "B"]
width = 0.02
contact = { law = "kelvin-voigt", stiffness = 4e8, restitution = 0.65 }
[[link]]
between = ["A", "B"]
elevations = [7]
law = "yielding"
stiffness = 2e7
yield_force = 2e5
hardening = 0.02
[[link]]
between = ["A", "B"]
elevations = [4]
law = "spring-dashpot"
stiffness = 1e6
damping = 1e4
)";

}  // namespace bentur::test
