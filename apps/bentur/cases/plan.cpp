#include "cases/plan.h"

#include <fmt/format.h>

#include <vector>

#include "bentur/core/number_text.h"
#include "bentur/io/results/plan/plan_json.h"
#include "bentur/structure/modes.h"
#include "session.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

std::string building_line(const PlanBuilding& building, const Words& say) {
  if (building.is_rigid()) return say("checked.moves", {{"building", building.name}}) + "\n";
  const PlanModel& model = building.model;
  const double period = modal_properties(building.modes, model.load.col(0)).periods(0);
  return fmt::format("{}: {}, {}, {}, {}\n", building.name, say.count("checked.count.floors", model.floors()),
                     say.count("checked.count.freedom", model.dofs()),
                     say.count("checked.count.planes", std::ssize(model.planes)),
                     say("checked.period", {{"period", number(period)}}));
}

std::string gap_line(const Loaded& loaded, std::size_t g, const Words& say) {
  const PlanGap& gap = loaded.plan.gaps[g];
  const auto length = [&](double value) { return number(value) + " " + loaded.c.units.length; };
  const PlanPoint& n = gap.stretch.n;
  const std::string across = gap.stretch.is_oblique()  ? fmt::format("({}, {})", number(n.x()), number(n.y()))
                             : gap.stretch.across == 0 ? "x"
                                                       : "y";
  return gap_name(loaded.plan, gap) + ": " +
         say("checked.gap", {{"width", length(gap.stretch.width)},
                             {"across", across},
                             {"stretch", length(gap.stretch.to - gap.stretch.from)},
                             {"points", say.count("checked.count.points", std::ssize(gap.contacts))},
                             {"law", loaded.c.gaps[g].contact.law}}) +
         (loaded.c.gaps[g].contact.axial ? say("checked.axial") : "") + "\n";
}

/// How much of each mode is along x, along y, and rotation: parts of φᵀMφ = 1 [%].
std::string modes_text(const PlanBuilding& building, const Words& say) {
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

}  // namespace

std::string plan_lines(const Loaded& loaded, const Words& say) {
  std::string text;
  for (const PlanBuilding& building : loaded.plan.buildings) text += building_line(building, say);
  for (std::size_t g = 0; g < loaded.plan.gaps.size(); ++g) text += gap_line(loaded, g, say);
  return text;
}

void print_plan_modes(PlanProblem problem, bool by_jacobi, bool json, const Words& say) {
  for (PlanBuilding& building : problem.buildings) {
    if (by_jacobi && !building.is_rigid()) {
      building.modes = modes_by_jacobi(building.model.mass, building.model.stiffness);
    }
  }
  if (json) return print(modes_json(problem));
  std::string text;
  for (const PlanBuilding& building : problem.buildings) text += (text.empty() ? "" : "\n") + modes_text(building, say);
  print(fitted(text));
}

}  // namespace bentur::cli
