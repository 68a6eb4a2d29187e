#include "cases/plan.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "bentur/core/number_text.h"
#include "bentur/core/version.h"
#include "bentur/files/netcdf_kind.h"
#include "bentur/files/result_netcdf.h"
#include "bentur/io/case/plan/plan_toml.h"
#include "bentur/io/results/plan/plan_csv.h"
#include "bentur/io/results/plan/plan_json.h"
#include "bentur/model/limits.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/story/story.h"
#include "bentur/report/errors.h"
#include "bentur/report/html/plan/plan_report.h"
#include "bentur/structure/modes.h"
#include "cases/gap_text.h"
#include "cases/plan_text.h"
#include "output/output.h"
#include "output/picture.h"
#include "session.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

struct LoadedPlan {
  PlanCase c;
  PlanProblem problem;
  SolveOptions options;
};

/// @param histories whether the run keeps them, as files do; `for_report`: as a report does
LoadedPlan load_plan(const std::string& file, const std::string& language, bool histories = false,
                     bool for_report = false) {
  Diagnostics diagnostics;
  PlanProblem problem;
  std::optional<PlanCase> c = read_plan_case(file, diagnostics, &problem);
  if (!c) throw Failure(diagnostics, language);
  SolveOptions options = solve_options(*c);
  if (histories) options.output_step = c->analysis.output_step;
  if (for_report) options.output_step = report_output_step(problem);
  const std::string refusal = beyond_limits(*c, effort(problem, c->analysis.solver, options));
  if (!refusal.empty()) {
    throw Failure(exit_bad_input, error_text({.position = {.file = file}, .rule = refusal}, language));
  }
  return {*std::move(c), std::move(problem), std::move(options)};
}

std::string building_line(const PlanBuilding& building) {
  if (building.is_rigid()) return building.name + ": moves with the ground\n";
  const PlanModel& model = building.model;
  return fmt::format("{}: {}, {} of freedom, {}, first period {} s\n", building.name,
                     counted(model.elevations.size(), "floor"),
                     counted(static_cast<std::size_t>(model.dofs()), "degree"), counted(model.planes.size(), "plane"),
                     number(modal_properties(building.modes, model.load.col(0)).periods(0)));
}

std::string gap_line(const LoadedPlan& loaded, std::size_t g) {
  const PlanGap& gap = loaded.problem.gaps[g];
  const std::string& length = loaded.c.units.length;
  const PlanPoint& n = gap.stretch.n;
  const std::string across = gap.stretch.is_oblique()  ? fmt::format("({}, {})", number(n.x()), number(n.y()))
                             : gap.stretch.across == 0 ? "x"
                                                       : "y";
  return fmt::format("{}: {} {} apart along {}, {} {} of stretch, {}, {}\n", gap_name(loaded.problem, gap),
                     number(gap.stretch.width), length, across, number(gap.stretch.to - gap.stretch.from), length,
                     counted(gap.contacts.size(), "contact point"), loaded.c.gaps[g].contact.law);
}

/// How much of each mode is along x, along y, and rotation: parts of φᵀMφ = 1 [%].
std::string modes_text(const PlanBuilding& building) {
  if (building.is_rigid()) return building.name + ": moves with the ground, it has no modes\n";
  const Modes& modes = building.modes;
  const ModalProperties x = modal_properties(modes, building.model.load.col(0));
  const ModalProperties y = modal_properties(modes, building.model.load.col(1));
  std::vector<std::string> numbers, mass_x, mass_y, rotation;
  std::vector<double> periods;
  for (Eigen::Index mode = 0; mode < modes.omega.size(); ++mode) {
    const Eigen::ArrayXd parts = building.model.mass.diagonal().array() * modes.shapes.col(mode).array().square();
    double turning = 0;
    for (Eigen::Index f = 0; f < building.model.floors(); ++f) turning += parts(3 * f + 2);
    numbers.push_back(std::to_string(mode + 1));
    periods.push_back(x.periods(mode));
    mass_x.push_back(fmt::format("{:.2f}", 100 * x.effective_mass_fraction(mode)));
    mass_y.push_back(fmt::format("{:.2f}", 100 * y.effective_mass_fraction(mode)));
    rotation.push_back(fmt::format("{:.2f}", 100 * turning));
  }
  Table table;
  table.add("Mode", "", numbers);
  table.add("Period", "s", periods);
  table.add("Mass along x", "%", mass_x);
  table.add("Mass along y", "%", mass_y);
  table.add("Rotation in it", "%", rotation);
  return building.name + "\n\n" + table.text();
}

}  // namespace

void check_plan(const std::string& file, const std::string& language) {
  const LoadedPlan loaded = load_plan(file, language);
  std::string text = fmt::format("{}: no errors\n", file);
  if (!loaded.c.title.empty()) text += loaded.c.title + "\n";
  for (const PlanBuilding& building : loaded.problem.buildings) text += building_line(building);
  for (std::size_t g = 0; g < loaded.problem.gaps.size(); ++g) text += gap_line(loaded, g);
  text += fmt::format("{} s, solver {}{}\n", number(loaded.c.analysis.duration), solver_name(loaded.c.analysis.solver),
                      loaded.c.analysis.energy_audit ? ", energy audit" : "");
  const Words say(language);
  text += story_text(gap_names(loaded.problem), {remark_statements(remarks(loaded.c, loaded.problem))}, say, Told::all);
  print(fitted(text));
}

void print_plan_modes(const std::string& file, bool by_jacobi, bool json) {
  LoadedPlan loaded = load_plan(file, "en");
  for (PlanBuilding& building : loaded.problem.buildings) {
    if (by_jacobi && !building.is_rigid()) {
      building.modes = modes_by_jacobi(building.model.mass, building.model.stiffness);
    }
  }
  if (json) return print(plan_modes_json(loaded.problem));
  std::string text;
  for (const PlanBuilding& building : loaded.problem.buildings)
    text += (text.empty() ? "" : "\n") + modes_text(building);
  print(fitted(text));
}

PlanRun simulate_plan(const std::string& file, const std::string& language) {
  LoadedPlan loaded = load_plan(file, language);
  PlanResponse response = solve_shown(loaded.options, true, language, [&](const SolveOptions& shown) {
    return solve(loaded.problem, loaded.c.analysis.solver, shown);
  });
  return run_results(std::move(loaded.c), std::move(loaded.problem), std::move(response));
}

void print_plan_gaps(const std::string& file, bool json, const std::string& language) {
  const PlanRun run = simulate_plan(file, language);
  if (json) return print(plan_gap_json(run, version()));
  const Words say(language);
  print(fitted(plan_motion_text(run, say) + all_gaps_text(gap_names(run.problem), run.c.code, gap_story(run),
                                                          {say("cli.plan_gap_note"), say("screening.note")}, say)));
}

void print_plan_rules(const std::string& file, bool json, const std::string& language) {
  const LoadedPlan loaded = load_plan(file, language);
  if (json) return print(plan_height_rules_json(loaded.c, loaded.problem, version()));
  const Words say(language);
  std::string text = loaded.c.title.empty() ? "" : loaded.c.title + "\n\n";
  const Story story = height_rules_story(loaded.c, loaded.problem);
  if (!story.tables.empty()) {
    text += tables_text(gap_names(loaded.problem), story, say) + "\n" + wrapped(say("cli.height_note")) + "\n";
  }
  print(fitted(text + codes_note(loaded.c.code, say)));
}

void report_plan(const std::string& file, const std::string& head, const std::string& output, bool force,
                 const ReportOptions& options) {
  LoadedPlan loaded = load_plan(file, options.language, false, true);
  std::vector<std::filesystem::path> inputs = files_read(loaded.c);
  inputs.emplace_back(file);
  if (!head.empty()) inputs.emplace_back(head);
  OutputFile report(output, ResultKind::report, {inputs, force});
  PlanResponse response = solve_shown(loaded.options, true, options.language, [&](const SolveOptions& shown) {
    return solve(loaded.problem, loaded.c.analysis.solver, shown);
  });
  const std::string page =
      plan_report_html(run_results(std::move(loaded.c), std::move(loaded.problem), std::move(response)), options);
  report.write(page);
  if (!report.is_streamed()) message(fmt::format("Wrote {} ({} kB)", output, (page.size() + 999) / 1000));
}

void run_plan(const PlanRunArguments& arguments, const std::string& language) {
  LoadedPlan loaded = load_plan(arguments.file, language, !arguments.directory.empty());
  std::optional<RunFolder> folder;
  std::optional<RunPictures> pictures;
  if (!arguments.directory.empty()) {
    std::vector<std::filesystem::path> inputs = files_read(loaded.c);
    inputs.emplace_back(arguments.file);
    folder.emplace(arguments.directory,
                   OutputRules{.inputs = std::move(inputs), .force = arguments.force, .is_netcdf = &is_netcdf_result},
                   *loaded.c.source);
    pictures.emplace(*folder, arguments.figures);
  }
  PlanResponse response = solve_shown(loaded.options, !arguments.quiet, language, [&](const SolveOptions& shown) {
    return solve(loaded.problem, loaded.c.analysis.solver, shown);
  });
  const PlanRun run = run_results(std::move(loaded.c), std::move(loaded.problem), std::move(response));
  const std::string summary = plan_summary_json(run, version());
  if (folder) folder->write(*run.c.source, summary, impacts_csv(run), histories_netcdf(run, version()));
  if (arguments.json) {
    print(summary);
  } else if (!arguments.quiet) {
    print(fitted(plan_summary_text(run, Words(language))));
  }
  if (folder && !arguments.quiet) message(written_line(*run.c.source, arguments.directory));
  if (!arguments.figures.empty()) {
    pictures->write(run_figures(run, RunPictures::options(language)), arguments.quiet);
  }
}

}  // namespace bentur::cli
