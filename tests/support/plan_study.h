#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bentur/io/case/case_toml.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/model/quantity_row.h"
#include "bentur/study/study_runs.h"

namespace bentur::test {

inline const char* const twisting_case = R"(
[plan]
clearance = 0.10
contact = { law = "linear", stiffness = 4e5, friction = 0.3 }
[[building]]
name = "Walled"
damping = 0.05
plan = { corner = [0, 0], size = [12, 18], storey_heights = [3.5, 3.2], masses = [200, 180] }
[[building.plane]]
name = "south wall"
along = "x"
at = 0.0
stiffnesses = [9e4, 9e4]
yield_forces = [900, 700]
hysteresis = "bilinear"
hardening = 0.05
[[building.plane]]
name = "north frame"
along = "x"
at = 18.0
stiffnesses = [2e4, 2e4]
[[building.plane]]
name = "west frame"
along = "y"
at = 0.0
stiffnesses = [4e4, 4e4]
[[building.plane]]
name = "east frame"
along = "y"
at = 12.0
stiffnesses = [4e4, 4e4]
[[building]]
name = "Frame"
damping = 0.05
plan = { corner = [12.02, 0], size = [15, 18], storey_heights = [3.5, 3.2], masses = [250, 220] }
rigidity = { centre = [7.5, 9], x = 1.2e5, y = 1.2e5, torsion = 1.2e7 }
[excitation]
kind = "harmonic"
period = 0.5
displacement_amplitude = 0.03
angle = 30
[analysis]
duration = 3.0
)";

/// A study of buildings in plan.
class PlanStudy : public testing::Test {
 protected:
  std::optional<StudyRuns> runs_of(const std::string& rest) {
    std::ofstream(folder_.path() / "case.toml") << case_;
    std::ofstream(folder_.path() / "study.toml") << "case = 'case.toml'\n" << rest;
    auto study = read_study(folder_.path() / "study.toml", diagnostics_);
    const auto memo = std::make_shared<CaseMemo>();
    auto facts = study ? check_study(*study, *memo, diagnostics_) : std::nullopt;
    if (!facts) return std::nullopt;
    return std::optional<StudyRuns>(std::in_place, std::move(*study), std::move(*facts), memo);
  }

  std::string first_error() { return diagnostics_.ok() ? "" : diagnostics_.errors().front().message(); }

  /// The row of a case that is read and solved by itself.
  std::vector<double> alone(const StudyRuns& runs, const std::function<void(std::string&)>& change) {
    std::string text = case_;
    change(text);
    Diagnostics diagnostics;
    MadeParts made;
    PlanProblem& problem = made.plan;
    const auto c = read_case_text(text, folder_.path() / "case.toml", diagnostics, &made);
    for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
    PlanResponse response = solve(problem, c->analysis.solver, {.levels = true});
    std::vector<double> row(row_size(runs.quantities()));
    fill_row(runs.quantities(), run_results(*c, problem, std::move(response)), row);
    return row;
  }

  static void put(std::string& text, const std::string& old, const std::string& now) {
    const std::size_t at = text.find(old);
    ASSERT_NE(at, std::string::npos) << old;
    text.replace(at, old.size(), now);
  }

  /// Two records of so many components, by name; of the second both are larger.
  void shake(bool both) {
    const auto write = [this](const std::string& name, double size, double rate) {
      std::ofstream file(folder_.path() / name);
      for (int n = 0; n < 150; ++n) file << 0.02 * n << "," << size * std::sin(rate * n) * std::exp(-0.02 * n) << "\n";
    };
    write("a-x.csv", 2.0, 0.25);
    write("a-y.csv", 0.5, 0.30);
    write("b-x.csv", 3.0, 0.20);
    write("b-y.csv", 2.0, 0.22);
    const std::string along_y =
        both ? "\n[excitation.y]\nkind = 'record'\nfile = 'a-y.csv'\nunit = 'm/s2'\nscale = 7.0\n" : "\n";
    put(case_, "kind = \"harmonic\"\nperiod = 0.5\ndisplacement_amplitude = 0.03\nangle = 30\n",
        "kind = 'record'\nfile = 'a-x.csv'\nunit = 'm/s2'\npga = 9.0\nangle = 30\n" + along_y);
  }

  std::string case_ = twisting_case;
  TemporaryFolder folder_;
  Diagnostics diagnostics_;
};

inline void expect_same(const std::vector<double>& a, const std::vector<double>& b, const std::vector<RowPart>& parts) {
  ASSERT_EQ(a.size(), b.size());
  for (const RowPart& part : parts) {
    for (std::size_t i = part.first; i < part.first + part.count; ++i) {
      if (std::isnan(a[i]) && std::isnan(b[i])) continue;
      EXPECT_EQ(a[i], b[i]) << part.name << " " << i - part.first;
    }
  }
}

}  // namespace bentur::test
