#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bentur/core/number_text.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/report/html/internal/echo.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/structure/modes.h"

// What the section of the input says of a building in plan.
namespace bentur::html {
namespace {

using Eigen::Index;

/// Writes it.
class PlanInput {
 public:
  PlanInput(const Case& c, const PlanProblem& problem, const Words& say) : c_(c), problem_(problem), say_(say) {}

  [[nodiscard]] Derived of(Index b, const TomlValue& given) const {
    Derived derived{problem_.buildings.at(b).name};
    const TomlValue* const planes = given.find("plane");
    derived.tables = given_planes(b, planes != nullptr ? *planes : TomlValue(), derived.printed) + modes(b);
    derived.printed.push_back(main_modes(b).called(say_("heading.modes")));
    return derived;
  }

 private:
  /// Where the planes of a building stand and how stiff they are, storeys from the top down, and how they yield.
  /// @param printed gets the table of them, and what planes that yield are given by
  [[nodiscard]] Html given_planes(Index b, const TomlValue& given, std::vector<HtmlTable>& printed) const {
    const auto* const plan = std::get_if<Plan>(&c_.buildings[b].structure);
    printed.resize(2);  // as many of each building
    if (plan == nullptr || plan->planes.empty()) return {};
    std::vector<std::string> names, stiffnesses;
    std::vector<double> x, y, angles;
    for (const PlanPlane& plane : plan->planes) {
      names.push_back(plane.name);
      x.push_back(plane.through.x());
      y.push_back(plane.through.y());
      constexpr double degrees = 180 / std::numbers::pi;
      angles.push_back(degrees * std::atan2(plane.direction.y(), plane.direction.x()));
      std::string list;
      for (auto k = plane.storeys.stiffnesses.rbegin(); k != plane.storeys.stiffnesses.rend(); ++k) {
        list += (list.empty() ? "" : ", ") + number(*k);
      }
      stiffnesses.push_back(list);
    }
    HtmlTable table;
    table.add(say_("column.plane"), "", names, false);
    table.add(say_("plan.through_x"), c_.units.length, x);
    table.add(say_("plan.through_y"), c_.units.length, y);
    table.add(label_text(plane_keys().at("angle").label, say_), "°", angles);
    const Key& stiffness = plane_keys().at("stiffnesses");
    table.add(label_text(stiffness.label, say_), unit_of(stiffness, c_.units), stiffnesses);
    Html content = under("h4", say_("plan.planes"), table);
    HtmlTable yielding_planes;
    for (std::size_t p = 0; p < std::min(given.items.size(), names.size()); ++p) {
      TomlValue yielding = given.items[p];
      std::erase_if(yielding.members, [](const TomlMember& member) {
        const std::string_view told[] = {"name", "along", "at", "angle", "through", "stiffnesses"};
        return std::find(std::begin(told), std::end(told), member.key) != std::end(told);
      });
      if (yielding.members.empty()) continue;
      Echoed echoed = echo(plane_keys(), yielding, say_, c_.units, c_.project.has_value());
      content += element("p", names[p]) + echoed.markup;
      yielding_planes.join(names[p], echoed.row);
    }
    printed[0] = table.called(say_("plan.planes"));
    printed[1] = yielding_planes.called(say_("plan.yielding_planes"));
    return content;
  }

  [[nodiscard]] Html modes(Index b) const {
    constexpr Index most = 8;
    return under("h4", say_("heading.modes"), modes_table(b, most));
  }

  /// Of modes as many as are asked for; none of what is rigid.
  [[nodiscard]] HtmlTable modes_table(Index b, Index most) const {
    const PlanBuilding& building = problem_.buildings[b];
    if (building.is_rigid()) return {};
    const ModalProperties along_x = modal_properties(building.modes, building.model.load.col(0));
    const ModalProperties along_y = modal_properties(building.modes, building.model.load.col(1));
    std::vector<std::string> numbers;
    std::vector<double> periods, mass_x, mass_y, damping;
    for (Index mode = 0; mode < std::min(most, building.modes.omega.size()); ++mode) {
      numbers.push_back(std::to_string(mode + 1));
      periods.push_back(along_x.periods(mode));
      mass_x.push_back(rounded(100 * along_x.effective_mass_fraction(mode)));
      mass_y.push_back(rounded(100 * along_y.effective_mass_fraction(mode)));
      damping.push_back(100 * building.modal_damping(mode, mode) / (2 * building.modes.omega(mode)));
    }
    HtmlTable table;
    table.add(say_("column.mode"), "", numbers);
    table.add(say_("column.period"), "s", periods);
    table.add(say_("column.damping"), "%", damping);
    table.add(say_("plan.mass_x"), "%", mass_x);
    table.add(say_("plan.mass_y"), "%", mass_y);
    return table;
  }

  /// Of the modes with the largest mass along x and along y; none of what is rigid.
  [[nodiscard]] HtmlTable main_modes(Index b) const {
    const PlanBuilding& building = problem_.buildings[b];
    HtmlTable table;
    if (building.is_rigid()) return table;
    for (const Index axis : {0, 1}) {
      const ModalProperties along = modal_properties(building.modes, building.model.load.col(axis));
      Index mode = 0;
      const double most = along.effective_mass_fraction.maxCoeff(&mode);
      table.add(say_(axis == 0 ? "plan.mode_x" : "plan.mode_y"), "", {std::to_string(mode + 1)}, true);
      table.add(say_("column.period"), "s", std::vector<double>{along.periods(mode)});
      table.add(say_(axis == 0 ? "plan.mass_x" : "plan.mass_y"), "%", std::vector<double>{rounded(100 * most)});
    }
    return table;
  }

  /// Without round-off [%].
  [[nodiscard]] static double rounded(double percent) { return std::round(1e6 * percent) / 1e6; }

  const Case& c_;
  const PlanProblem& problem_;
  const Words& say_;
};

}  // namespace

Derived of_building_in_plan(const Case& c, const PlanProblem& problem, Index building, const TomlValue& given,
                            const Words& say) {
  return PlanInput(c, problem, say).of(building, given);
}

}  // namespace bentur::html
