#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "bentur/io/case/plan/plan_toml.h"
#include "bentur/io/input_file.h"

namespace bentur::test {

/// A run of buildings in plan with histories and energies.
inline PlanRun plan_run(const std::string& text, double output_step = 0.01) {
  Diagnostics diagnostics;
  PlanProblem problem;
  const std::string file = std::string(BENTUR_SOURCE_DIR) + "/examples/plan/case.toml";
  auto c = read_plan_case_text(text, file, diagnostics, &problem);
  if (!c) throw std::runtime_error(diagnostics.errors().front().text());
  SolveOptions options = solve_options(*c);
  options.output_step = output_step;
  options.energy_audit = true;
  PlanResponse response = solve(problem, c->analysis.solver, options);
  return {*std::move(c), std::move(problem), std::move(response)};
}

/// A text with each `before` replaced by `after`.
inline std::string with(std::string text, const std::string& before, const std::string& after) {
  for (std::size_t at = 0; !before.empty() && (at = text.find(before, at)) != std::string::npos; at += after.size()) {
    text.replace(at, before.size(), after);
  }
  return text;
}

/// The text of examples/plan/twisting-pair.toml, likewise.
inline std::string twisting_pair(const std::string& before = "", const std::string& after = "") {
  Diagnostics diagnostics;
  const std::string file = std::string(BENTUR_SOURCE_DIR) + "/examples/plan/twisting-pair.toml";
  return with(read_input(file, case_input, diagnostics).value(), before, after);
}

/// A wall beside the first of them.
inline const std::string wall_beside =
    "\n[[building]]\nname = \"W\"\nrigid = true\nelevations = [3.5]\n"
    "plan = { corner = [-0.52, 0], size = [0.5, 18] }\n";

}  // namespace bentur::test
