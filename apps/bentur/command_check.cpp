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
#include "bentur/structure/modes.h"
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

/// What a building is, in lines: of a row, or in plan.
std::string building_lines(const Case& c, const Problem& problem, std::size_t b, const Words& say) {
  const Building& building = problem.buildings[b];
  if (building.is_rigid()) {
    return say(building.given ? "checked.given" : "checked.moves", {{"building", building.name}}) + "\n";
  }
  const Proportions found = proportions(building, c.units, nullptr);
  std::string text =
      fmt::format("{}: {}, {}, {}\n", building.name, say.count("checked.count.floors", building.model.floors()),
                  say.count("checked.count.freedom", building.model.dofs()),
                  proportions_text(building, found, shown_units(c.units, found.weight), say));
  if (building.storeys_yield()) text += yielding_text(building, c.buildings[b], say);
  return text + infill_text(building, c.units, say);
}

std::string building_lines(const Case& /*c*/, const PlanProblem& problem, std::size_t b, const Words& say) {
  const PlanBuilding& building = problem.buildings[b];
  if (building.is_rigid()) return say("checked.moves", {{"building", building.name}}) + "\n";
  const PlanModel& model = building.model;
  const double period = modal_properties(building.modes, model.load.col(0)).periods(0);
  return fmt::format("{}: {}, {}, {}, {}\n", building.name, say.count("checked.count.floors", model.floors()),
                     say.count("checked.count.freedom", model.dofs()),
                     say.count("checked.count.planes", std::ssize(model.planes)),
                     say("checked.period", {{"period", number(period)}}));
}

std::string gap_text(const Case& c, const Problem& problem, std::size_t gap, const Words& say) {
  const GapSpec& spec = c.gaps[gap];
  const auto place = static_cast<Eigen::Index>(gap);
  return say.count("checked.count.points", std::ssize(spec.elevations)) + ", " +
         (is_known_by_peaks(problem, place) ? say("checked.still") : spec.contact.law);
}

std::string gap_text(const Case& c, const PlanProblem& problem, std::size_t gap, const Words& say) {
  const PlanGap& of = problem.gaps[gap];
  const auto length = [&](double value) { return number(value) + " " + c.units.length; };
  const PlanPoint& n = of.stretch.n;
  const std::string across = of.stretch.is_oblique()  ? fmt::format("({}, {})", number(n.x()), number(n.y()))
                             : of.stretch.across == 0 ? "x"
                                                      : "y";
  return say("checked.gap", {{"width", length(of.stretch.width)},
                             {"across", across},
                             {"stretch", length(of.stretch.to - of.stretch.from)},
                             {"points", say.count("checked.count.points", std::ssize(of.contacts))},
                             {"law", c.gaps[gap].contact.law}});
}

/// What stands there, and what a run of it takes. @throws Failure where that is beyond the case's limits
template <class AnyProblem>
std::string checked(const Case& c, const AnyProblem& problem, const std::string& file, const Words& say) {
  std::string text;
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) text += building_lines(c, problem, b, say);
  const std::vector<std::string> gaps = gap_names(problem);
  for (std::size_t gap = 0; gap < gaps.size(); ++gap) {
    text += gaps[gap] + ": " + gap_text(c, problem, gap, say) +
            (c.gaps[gap].contact.axial ? say("checked.axial") : "") + "\n";
  }
  for (const LinkSpec& spec : c.links) {
    text += fmt::format("{} – {}: {}, {}\n", c.buildings[spec.left].name, c.buildings[spec.right].name,
                        say.count("story.count.links", std::ssize(spec.elevations)), spec.law);
  }
  const std::string unusual = story_text(gaps, {remark_statements(remarks(c, problem))}, say, Told::all);
  if (c.excitation.suite) return text + say("suite.takes_all") + "\n" + unusual;
  if (const auto& spectrum = c.excitation.spectrum) {
    return text + say(spectrum->of_displacements ? "checked.no_run_given" : "checked.no_run") + "\n" + unusual;
  }
  text +=
      say("checked.solver", {{"duration", number(c.analysis.duration)}, {"solver", solver_name(c.analysis.solver)}}) +
      (c.analysis.energy_audit ? say("checked.audit") : "") + "\n";
  SolveOptions options = solve_options(c);
  options.output_step = c.analysis.output_step;
  const Effort needed = effort(problem, c.analysis.solver, options);
  if (const std::string why = beyond_limits(c, problem, needed); !why.empty()) {
    throw Failure(exit_bad_input, error_text({.position = {.file = file}, .rule = why}, say.language()));
  }
  return text + effort_text(c, problem, needed, say) + unusual;
}

void run(const std::string& file, const Words& say) {
  const Loaded loaded = load(file, say.language());
  std::string text = say("checked.no_errors", {{"file", file}}) + "\n";
  if (!loaded.c.title.empty()) text += loaded.c.title + "\n";
  text += excitation_lines(loaded.c, say);
  print(
      fitted(text + with_problem(loaded, [&](const auto& problem) { return checked(loaded.c, problem, file, say); })));
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
