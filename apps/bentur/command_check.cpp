#include <fmt/format.h>

#include <memory>

#include "arguments.h"
#include "commands.h"
#include "session.h"
#include "table.h"

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
    text += fmt::format("{}: {}, {} of freedom\n", building.name,
                        count(building.model.elevations.size(), "floor", "floors"),
                        count(static_cast<std::size_t>(building.model.dofs()), "degree", "degrees"));
  }
  for (std::size_t gap = 0; gap < loaded.c.gaps.size(); ++gap) {
    const GapSpec& spec = loaded.c.gaps[gap];
    text += fmt::format("{}: {}, {}{}\n", gap_name(loaded.problem, static_cast<int>(gap)),
                        count(spec.widths.size(), "contact point", "contact points"), spec.contact.law,
                        spec.contact.axial ? ", axial stiffness" : "");
  }
  text += fmt::format("{} s, solver {}{}\n", number(loaded.c.analysis.duration), solver_name(loaded.c.analysis.solver),
                      loaded.c.analysis.energy_audit ? ", energy audit" : "");
  print(text);
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
