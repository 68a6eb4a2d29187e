#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "arguments.h"
#include "bentur/model/gap/minimum_gap.h"
#include "bentur/model/limits.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/report/errors.h"
#include "cases/plan.h"
#include "commands.h"
#include "session.h"
#include "text/effort_text.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

/// "3 storeys", without what stands on bearings below them.
std::string storeys_of(const Building& building, const Words& say) {
  return say.count("checked.count.storeys", building.model.floors() - building.model.first_storey());
}

/// "A: 2 of 3 storeys can yield, peak-oriented".
std::string yielding_text(const Building& building, const BuildingSpec& spec, const Words& say) {
  std::string law;
  int yielding = 0;
  const Eigen::Index first = building.model.first_storey();
  for (const BuildingElement& element : building.elements) {
    if (element.storey < first || element.infill) continue;
    ++yielding;
    law = element.law->name();
  }
  const std::string bearings = building.model.slab && building.storey_law(*building.model.slab) != nullptr
                                   ? say("checked.bearings", {{"building", building.name}}) + "\n"
                                   : "";
  if (yielding == 0) return bearings;
  return bearings +
         say("checked.yielding", {{"building", building.name},
                                  {"count", std::to_string(yielding)},
                                  {"storeys", storeys_of(building, say)},
                                  {"law", law}}) +
         (spec.tangent_damping ? say("checked.tangent") : "") + "\n";
}

/// "A: infill in 2 of 3 storeys, a panel has 1.2e+04 to 2e+04 kN/m and yields at 50 to 80 kN".
std::string infill_text(const Building& building, const Units& units, const Words& say) {
  const std::vector<InfillPanel>& panels = building.model.infills;
  if (panels.empty()) return "";
  std::set<Eigen::Index> storeys;
  std::pair<double, double> stiffness = {HUGE_VAL, 0}, strength = stiffness;
  const auto take = [](std::pair<double, double>& range, double value) {
    range = {std::min(range.first, value), std::max(range.second, value)};
  };
  for (const InfillPanel& panel : panels) {
    storeys.insert(panel.storey);
    take(stiffness, panel.stiffness);
    take(strength, panel.backbone.yield);
  }
  const auto told = [&say](const std::pair<double, double>& range) {
    const std::string least = number(range.first), most = number(range.second);
    return least == most ? least : say("checked.range", {{"least", least}, {"most", most}});
  };
  return say("checked.infill", {{"building", building.name},
                                {"count", std::to_string(storeys.size())},
                                {"storeys", storeys_of(building, say)},
                                {"stiffness", told(stiffness) + " " + units.force + "/" + units.length},
                                {"strength", told(strength) + " " + units.force}}) +
         "\n";
}

void run(const std::string& file, const Words& say) {
  const Loaded loaded = load(file, Purpose::no_run, say.language(), Takes::rows_and_plans);
  std::string text = say("checked.no_errors", {{"file", file}}) + "\n";
  if (!loaded.c.title.empty()) {
    text += loaded.c.title + "\n";
  }
  text += excitation_lines(loaded.c, say);
  const auto solver = [&] {
    return say("checked.solver",
               {{"duration", number(loaded.c.analysis.duration)}, {"solver", solver_name(loaded.c.analysis.solver)}}) +
           (loaded.c.analysis.energy_audit ? say("checked.audit") : "") + "\n";
  };
  const auto refuse = [&](const std::string& why) {
    if (why.empty()) return;
    throw Failure(exit_bad_input, error_text({.position = {.file = file}, .rule = why}, say.language()));
  };
  const auto& spectrum = loaded.c.excitation.spectrum;
  const std::string no_run = loaded.c.excitation.suite ? say("suite.takes_all") + "\n"
                             : spectrum
                                 ? say(spectrum->of_displacements ? "checked.no_run_given" : "checked.no_run") + "\n"
                                 : "";
  if (loaded.c.is_in_plan()) {
    if (no_run.empty())
      refuse(
          beyond_limits(loaded.c, loaded.plan, effort(loaded.plan, loaded.c.analysis.solver, solve_options(loaded.c))));
    const Story unusual = {remark_statements(remarks(loaded.c, loaded.plan))};
    return print(fitted(text + plan_lines(loaded, say) + (no_run.empty() ? solver() : no_run + "\n") +
                        story_text(gap_names(loaded.plan), unusual, say, Told::all)));
  }
  for (std::size_t b = 0; b < loaded.problem.buildings.size(); ++b) {
    const Building& building = loaded.problem.buildings[b];
    if (building.is_rigid()) {
      text += say(building.given ? "checked.given" : "checked.moves", {{"building", building.name}}) + "\n";
      continue;
    }
    const Proportions found = proportions(building, loaded.c.units, nullptr);
    text += fmt::format("{}: {}, {}, {}\n", building.name, say.count("checked.count.floors", building.model.floors()),
                        say.count("checked.count.freedom", building.model.dofs()),
                        proportions_text(building, found, shown_units(loaded.c.units, found.weight), say));
    if (building.storeys_yield()) text += yielding_text(building, loaded.c.buildings[b], say);
    text += infill_text(building, loaded.c.units, say);
  }
  for (Eigen::Index gap = 0; gap < std::ssize(loaded.c.gaps); ++gap) {
    const GapSpec& spec = loaded.c.gaps[gap];
    text += fmt::format("{}: {}, {}{}\n", gap_name(loaded.problem, gap),
                        say.count("checked.count.points", std::ssize(spec.elevations)),
                        is_known_by_peaks(loaded.problem, gap) ? say("checked.still") : spec.contact.law,
                        spec.contact.axial ? say("checked.axial") : "");
  }
  for (const LinkSpec& spec : loaded.c.links) {
    text += fmt::format("{} – {}: {}, {}\n", loaded.c.buildings[spec.left].name, loaded.c.buildings[spec.right].name,
                        say.count("story.count.links", std::ssize(spec.elevations)), spec.law);
  }
  const std::string unusual =
      story_text(gap_names(loaded.problem), {remark_statements(remarks(loaded.c, loaded.problem))}, say, Told::all);
  if (!no_run.empty()) {
    print(fitted(text + no_run + unusual));
    return;
  }
  text += solver();
  SolveOptions options;
  options.output_step = loaded.c.analysis.output_step;
  options.energy_audit = loaded.c.analysis.energy_audit;
  const Effort needed = effort(loaded.problem, loaded.c.analysis.solver, options);
  refuse(beyond_limits(loaded.c, loaded.problem, needed));
  print(fitted(text + effort_text(loaded, needed, say) + unusual));
}

}  // namespace

void add_check_command(CLI::App& app) {
  auto file = std::make_shared<std::string>();
  auto language = std::make_shared<std::string>("en");
  CLI::App* command = app.add_subcommand("check", "Read and validate a case, simulate nothing");
  command->add_option("CASE", *file, "the case file (TOML)")->required()->check(not_empty());
  add_language(*command, *language);
  command->footer("Example: bentur check case.toml");
  command->callback([file, language] { run(*file, Words(*language)); });
}

}  // namespace bentur::cli
