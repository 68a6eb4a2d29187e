#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "bentur/io/case/case_toml.h"
#include "bentur/io/input_file.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/pounding/plan/plan_pounding.h"

namespace bentur::test {

/// A run of buildings in plan with histories and energies.
inline PlanRun plan_run(const std::string& text, double output_step = 0.01) {
  Diagnostics diagnostics;
  MadeParts made;
  PlanProblem& problem = made.plan;
  const std::string file = std::string(BENTUR_SOURCE_DIR) + "/examples/plan/case.toml";
  auto c = read_case_text(text, file, diagnostics, &made);
  if (!c) throw std::runtime_error(diagnostics.errors().front().text());
  SolveOptions options = solve_options(*c);
  options.output_step = output_step;
  options.energy_audit = true;
  options.course = true;
  PlanResponse response = solve(problem, c->analysis.solver, options);
  return {*std::move(c), std::move(problem), std::move(response)};
}

/// A run as the command line makes it, without histories, that comes to its end.
inline PlanRun told_plan_run(const std::string& text) {
  Diagnostics diagnostics;
  MadeParts made;
  auto c = read_case_text(text, "case.toml", diagnostics, &made);
  if (!c) throw std::runtime_error(diagnostics.errors().front().text());
  PlanResponse response = solve(made.plan, c->analysis.solver, solve_options(*c));
  if (response.status != Status::done) throw std::runtime_error(response.message);
  return run_results(*std::move(c), std::move(made.plan), std::move(response));
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

/// The text of examples/plan/twisting-pair.toml with two frames in the first building whose members yield: hinges of
/// one lose strength, columns of the other break.
inline std::string hinged_pair() {
  const std::string before = "[[building.plane]]\nname = \"west";
  const std::string members = "elastic_modulus = 3e7, bay_widths = [6, 5], ";
  return twisting_pair(
      before,
      "[[building.plane]]\nname = \"middle\"\nalong = \"x\"\nat = 8\nframe = { " + members +
          "columns = [{ width = 0.4, depth = 0.5, moment_capacity = [90, 110, 90], hardening = 0.01, rotation_limits = "
          "[0.001, 0.002, 0.003], backbone = { plastic_rotation = 0.001, softening_rotation = 0.05, residual = 0.2 } "
          "}], "
          "beams = [{ width = 0.3, depth = 0.5, moment_capacity = [60, 80], line_load = 3 }] }\n" +
          "[[building.plane]]\nname = \"across\"\nalong = \"y\"\nat = 3\nframe = { " + members +
          "columns = [{ width = 0.4, depth = 0.4, shear_capacity = 60, residual_shear = 0.2, moment_capacity = 150 }], "
          "beams = [{ width = 0.3, depth = 0.4, moment_capacity = 80 }] }\n" +
          before);
}

}  // namespace bentur::test
