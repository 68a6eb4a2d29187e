#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bentur/core/number_text.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/report/html/internal/echo.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/structure/modes.h"

// The section of a report in plan that echoes the case.
namespace bentur::html {
namespace {

using Eigen::Index;

/// Writes it.
class PlanInput {
 public:
  PlanInput(const Case& c, const PlanProblem& problem, long events, const Words& say)
      : c_(c), problem_(problem), events_(events), say_(say) {}

  /// The case key by key, and what follows from it.
  [[nodiscard]] PageSection input() const {
    Html content;
    bool is_sharing_told = false;
    for (const Key& key : case_keys().keys) {
      const TomlValue nothing;
      const TomlValue* const found = c_.given ? c_.given->find(std::string(key.name)) : nullptr;
      const bool always = key.name == "units" || (key.name == "analysis" && !is_without_motion(c_));
      if (key.table == nullptr || (found == nullptr && !always)) continue;
      const TomlValue& given = found != nullptr ? *found : nothing;
      const bool is_list = given.kind == TomlValue::Kind::list;
      EachOf each(true);
      for (std::size_t i = 0; i < (is_list ? given.items.size() : 1); ++i) {
        TomlValue one = is_list ? given.items[i] : given;
        const bool is_building = key.name == "building";
        const TomlValue planes = is_building && one.find("plane") != nullptr ? *one.find("plane") : TomlValue();
        if (is_building) std::erase_if(one.members, [](const TomlMember& member) { return member.key == "plane"; });
        Rows rows;
        if (key.name == "excitation") rows = motion();
        if (key.name == "analysis") rows = analysis(one);
        if (key.name == "units" && one.find("gravity") == nullptr) {
          rows.emplace_back(label_text(unit_keys().at("gravity").label, say_),
                            quantity(c_.units.gravity, acceleration_unit(c_.units)));
        }
        const std::string heading = is_building ? problem_.buildings.at(i).name : label_text(key.label, say_);
        Echoed echoed = echo(*key.table, one, say_, c_.units, rows);
        Html told = std::move(echoed.markup);
        std::vector<HtmlTable> printed = {std::move(echoed.row)};
        if (!is_sharing_told && (key.name == "plan" || key.name == "gap")) {
          told += element("p", say_("plan.shared"), "class=\"note\"");
          is_sharing_told = true;
        }
        if (is_building) {
          const auto b = static_cast<Index>(i);
          told += given_planes(b, planes, printed) + modes(b);
          printed.push_back(main_modes(b).called(say_("heading.modes")));
        }
        each.add(heading, told, printed);
      }
      content += each.markup(say_, entries_key(say_, key.name));
    }
    return {"input", say_("heading.input"), content};
  }

 private:
  /// Where the planes of a building stand and how stiff they are, storeys from the top down, and how they yield.
  /// @param printed gets the table of them, and what planes that yield are given by
  [[nodiscard]] Html given_planes(Index b, const TomlValue& given, std::vector<HtmlTable>& printed) const {
    const auto* const plan = std::get_if<Plan>(&c_.buildings[b].structure);
    printed.resize(3);  // as many of each building
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
      Echoed echoed = echo(plane_keys(), yielding, say_, c_.units);
      content += element("p", names[p]) + echoed.markup;
      yielding_planes.join(names[p], echoed.row);
    }
    printed[1] = table.called(say_("plan.planes"));
    printed[2] = yielding_planes.called(say_("plan.yielding_planes"));
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

  /// Both motions as they were read and as they are applied.
  [[nodiscard]] Rows motion() const {
    Rows rows;
    const auto pga_of = [&](std::size_t i) {
      const std::optional<RecordEcho>& record = c_.excitations()[i]->record;
      return record ? record->pga : peak_acceleration(problem_.motions[i]);
    };
    for (const std::size_t i : {0U, 1U}) {
      const std::optional<RecordEcho>& record = c_.excitations()[i]->record;
      const double pga = pga_of(i);
      if (!(pga > 0)) continue;
      // Of two components which one; one alone acts in a direction that the table has.
      const std::string of = !(pga_of(1 - i) > 0) ? "" : i == 0 ? "x: " : "y: ";
      if (record) {
        for (auto& [name, text] : rows_of_record(*record, say_)) rows.emplace_back(of + name, text);
      }
      rows.emplace_back(of + say_("motion.pga"),
                        quantity(pga, acceleration_unit(c_.units)) + " = " + quantity(pga / c_.units.gravity, "g"));
    }
    const std::vector<double>& delays = c_.excitation.delays;
    for (std::size_t b = 0; b < delays.size(); ++b) {
      if (delays[b] == 0) continue;
      rows.emplace_back(say_("motion.delay", {{"building", problem_.buildings.at(b).name}}), quantity(delays[b], "s"));
    }
    return rows;
  }

  [[nodiscard]] Rows analysis(const TomlValue& given) const {
    Rows rows;
    if (is_without_motion(c_)) return rows;  // no run is told of
    if (given.find("duration") == nullptr) {
      rows.emplace_back(label_text(analysis_keys().at("duration").label, say_), quantity(problem_.duration, "s"));
    }
    rows.emplace_back(say_("analysis.events"), std::to_string(events_));
    return rows;
  }

  const Case& c_;
  const PlanProblem& problem_;
  long events_;
  const Words& say_;
};

}  // namespace

PageSection plan_input_section(const Case& c, const PlanProblem& problem, long events, const Words& say) {
  return PlanInput(c, problem, events, say).input();
}

}  // namespace bentur::html
