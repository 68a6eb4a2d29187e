#include <fmt/format.h>

#include <memory>

#include "arguments.h"
#include "commands.h"
#include "session.h"
#include "text/effort_text.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

/// "1 floor", "2 floors".
std::string count(std::size_t number, const std::string& singular, const std::string& plural) {
  return fmt::format("{} {}", number, number == 1 ? singular : plural);
}

void run(const std::string& file) {
  const Loaded loaded = load(file);
  std::string text = fmt::format("{}: no errors\n", file);
  if (!loaded.c.title.empty()) {
    text += loaded.c.title + "\n";
  }
  text += excitation_line(loaded.c) + "\n";
  for (const Building& building : loaded.problem.buildings) {
    text += fmt::format("{}: {}, {} of freedom, {}\n", building.name,
                        count(building.model.elevations.size(), "floor", "floors"),
                        count(static_cast<std::size_t>(building.model.dofs()), "degree", "degrees"),
                        proportions_text(building, proportions(building, loaded.c.units, nullptr), loaded.c.units));
  }
  for (Eigen::Index gap = 0; gap < std::ssize(loaded.c.gaps); ++gap) {
    const GapSpec& spec = loaded.c.gaps[gap];
    text += fmt::format("{}: {}, {}{}\n", gap_name(loaded.problem, gap),
                        count(spec.widths.size(), "contact point", "contact points"), spec.contact.law,
                        spec.contact.axial ? ", axial stiffness" : "");
  }
  text += fmt::format("{} s, solver {}{}\n", number(loaded.c.analysis.duration), solver_name(loaded.c.analysis.solver),
                      loaded.c.analysis.energy_audit ? ", energy audit" : "");
  SolveOptions options;
  options.output_step = loaded.c.analysis.output_step;
  options.energy_audit = loaded.c.analysis.energy_audit;
  const Effort needed = effort(loaded.problem, loaded.c.analysis.solver, options);
  const std::string refusal = beyond_limits(loaded, needed);
  if (!refusal.empty()) throw Failure(exit_bad_input, file + ": error: " + refusal);
  print(text + effort_text(loaded, needed) + remarks_text(remarks(loaded.c, loaded.problem)));
}

}  // namespace

void add_check_command(CLI::App& app) {
  auto file = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("check", "Read and validate a case, simulate nothing");
  command->add_option("CASE", *file, "the case file (TOML)")->required()->check(not_empty());
  command->footer("Example: bentur check case.toml");
  command->callback([file] { run(*file); });
}

}  // namespace bentur::cli
