#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "arguments.h"
#include "bentur/io/results/result_json.h"
#include "bentur/structure/modes.h"
#include "commands.h"
#include "session.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

constexpr Eigen::Index most_modes = 8;  // in a table; --json has all

/// Shapes of the sways with the largest of each mode one, roof at the top.
Table shape_table(const Building& building, const std::string& length, const Words& say) {
  Table table;
  std::vector<double> elevations(building.model.elevations.rbegin(), building.model.elevations.rend());
  table.add(say("cli.level"), length, elevations);
  for (Eigen::Index mode = 0; mode < std::min(building.modes.shapes.cols(), most_modes); ++mode) {
    const Eigen::VectorXd sway = building.modes.shapes.col(mode).head(building.model.floors());
    const double largest = sway.cwiseAbs().maxCoeff();
    std::vector<std::string> cells;
    for (Eigen::Index floor = sway.size() - 1; floor >= 0; --floor) {
      cells.push_back(fmt::format("{:.3f}", largest > 0 ? sway(floor) / largest : 0.0));
    }
    table.add(say("modes.number", {{"n", std::to_string(mode + 1)}}), "", cells);
  }
  return table;
}

std::string modes_text(const Building& building, const Units& units, const Words& say) {
  if (building.given) return say("modes.given", {{"building", building.name}}) + "\n";
  if (building.is_rigid()) return say("modes.rigid", {{"building", building.name}}) + "\n";
  const ModalProperties properties = modal_properties(building);
  const Eigen::Index shown = std::min(properties.periods.size(), most_modes);
  std::vector<std::string> number_cells, periods, fraction, cumulative;
  std::vector<double> participation;
  // Decimals for three digits of the shortest period shown.
  const double shortest = properties.periods(shown - 1);
  const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(shortest))), 0, 9);
  double sum = 0;
  for (Eigen::Index mode = 0; mode < shown; ++mode) {
    sum += properties.effective_mass_fraction(mode);
    number_cells.push_back(std::to_string(mode + 1));
    periods.push_back(fmt::format("{:.{}f}", properties.periods(mode), decimals));
    participation.push_back(properties.participation(mode));
    fraction.push_back(fmt::format("{:.2f}", 100 * properties.effective_mass_fraction(mode)));
    cumulative.push_back(fmt::format("{:.2f}", 100 * sum));
  }
  Table table;
  table.add(say("column.mode"), "", number_cells);
  table.add(say("column.period"), "s", periods);
  table.add(say("column.participation"), "(" + units.force + "·s²/" + units.length + ")^½", participation);
  table.add(say("modes.mass"), "%", fraction);
  table.add(say("modes.mass_so_far"), "%", cumulative);
  const Proportions found = proportions(building, units, nullptr);
  std::string text =
      fmt::format("{}: {}\n\n{}", building.name,
                  proportions_text(building, found, shown_units(units, found.weight), say), table.text());
  if (shown < properties.periods.size()) {
    text += "  " + say("modes.more", {{"n", std::to_string(properties.periods.size() - shown)}}) + "\n";
  }
  return text + "\n  " + say("modes.shapes") + "\n\n" + shape_table(building, units.length, say).text();
}

/// How much of each mode is along x, along y, and rotation: parts of φᵀMφ = 1 [%].
std::string modes_text(const PlanBuilding& building, const Units& /*units*/, const Words& say) {
  if (building.is_rigid()) return say("modes.rigid", {{"building", building.name}}) + "\n";
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
  table.add(say("column.mode"), "", numbers);
  table.add(say("column.period"), "s", periods);
  table.add(say("modes.mass_along", {{"axis", "x"}}), "%", mass_x);
  table.add(say("modes.mass_along", {{"axis", "y"}}), "%", mass_y);
  table.add(say("modes.rotation"), "%", rotation);
  return building.name + "\n\n" + table.text();
}

struct ModesArguments {
  std::string file;
  std::string method = "library";
  std::string language = "en";
  bool json = false;
};

void run(const ModesArguments& arguments) {
  const Loaded loaded = load(arguments.file, arguments.language);
  const Words say(arguments.language);
  print(with_problem(loaded, [&](auto problem) {
    if (arguments.method == "jacobi") {
      for (auto& building : problem.buildings) find_modes_by_jacobi(building);
    }
    if (arguments.json) return modes_json(problem, loaded.c.units);
    std::string text;
    for (const auto& building : problem.buildings) {
      text += (text.empty() ? "" : "\n") + modes_text(building, loaded.c.units, say);
    }
    return fitted(text);
  }));
}

}  // namespace

void add_modes_command(CLI::App& app) {
  auto arguments = std::make_shared<ModesArguments>();
  CLI::App* command = app.add_subcommand("modes", "Periods, participation and shapes of each building");
  command->add_option("CASE", arguments->file, "the case file (TOML)")->required()->check(not_empty());
  command->add_flag("--json", arguments->json, "JSON instead of tables; shapes mass-normalised");
  command
      ->add_option("--method", arguments->method,
                   "library (default), or jacobi: the monograph's Cholesky factors and Jacobi rotations")
      ->check(CLI::IsMember({"library", "jacobi"}));
  add_language(*command, arguments->language);
  command->footer("Example: bentur modes case.toml");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bentur::cli
