#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bentur/io/case/case_toml.h"
#include "bentur/model/run_results.h"
#include "bentur/report/figures/figure.h"
#include "bentur/report/figures/internal/colours.h"

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

/// On paper without colours the entries of a legend that have the same dashes and marks differ in grey: by 1.5, of
/// which an eye sees two lines side by side as different; dashes, marks and areas it sees in any grey.
inline void expect_told_apart_in_grey(const Figure& figure, const std::string& name) {
  struct Entry {
    std::string label, look;
    std::string_view tone;
  };
  std::vector<Entry> entries;
  for (const Panel& panel : figure.panels) {
    if (!figure.shared_legend) entries.clear();
    const auto add = [&](const std::string& label, const std::string& look, Tone tone) {
      const Entry entry{label, look, colour(tone).paper};
      for (const Entry& other : entries) {
        if (other.label == entry.label || other.look != entry.look) continue;
        EXPECT_GE(contrast(other.tone, entry.tone), 1.5) << name << ": " << other.label << " and " << entry.label;
      }
      entries.push_back(entry);
    };
    const auto look = [](const char* kind, Line line, Mark mark, double size) {
      return std::string(kind) + std::to_string(static_cast<int>(line)) + "/" + std::to_string(static_cast<int>(mark)) +
             "/" + std::to_string(mark == Mark::none ? 1 : size);
    };
    for (const Curve& curve : panel.curves) {
      if (curve.label.empty() || !curve.in_legend) continue;
      const Mark mark = curve.mark == Mark::none ? curve.legend_mark : curve.mark;
      add(curve.label, look(curve.top.empty() ? "" : "area", curve.line, mark, curve.mark_size), curve.tone);
    }
    for (const RuleLine& rule : panel.rules) {
      if (!rule.label.empty()) add(rule.label, look("rule", rule.line, Mark::none, 1), rule.tone);
    }
  }
}

}  // namespace bentur::test
