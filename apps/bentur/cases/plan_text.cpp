#include "cases/plan_text.h"

#include <algorithm>

#include "bentur/model/plan/plan_places.h"
#include "session.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

using Eigen::Index;

std::string with_columns(Table table, std::vector<TableColumn> columns) {
  for (TableColumn& column : columns)
    table.add(std::move(column.label), std::move(column.unit), std::move(column.cells));
  return table.text();
}

/// The contact points of a gap, level after level from the top down, each along the stretch.
std::string contact_table(const PlanRun& run, std::size_t g, const Words& say) {
  std::vector<QuantityPlace> places;
  for (Index i = 0; i < std::ssize(run.problem.gaps[g].contacts); ++i) {
    places.push_back({first_contact(run.problem, g) + i});
  }
  std::stable_sort(places.begin(), places.end(), [&](const QuantityPlace& a, const QuantityPlace& b) {
    return contact_at(run.problem, a.item).contact->elevation > contact_at(run.problem, b.item).contact->elevation;
  });
  std::vector<double> elevation, x, y;
  for (const QuantityPlace& at : places) {
    const PlanContactPlace place = contact_at(run.problem, at.item);
    elevation.push_back(place.contact->elevation);
    x.push_back(place.at.x());
    y.push_back(place.at.y());
  }
  Table table;
  table.add(say("cli.level"), run.c.units.length, elevation);
  table.add("x", run.c.units.length, x);
  table.add("y", run.c.units.length, y);
  return with_columns(std::move(table), table_columns(Owner::point, run, places, say.number()));
}

std::string floor_table(const PlanRun& run, Index building, bool of_forces, const Words& say) {
  std::vector<QuantityPlace> places = floors_of(run.problem, building);
  std::reverse(places.begin(), places.end());
  const std::vector<double>& levels = run.problem.buildings[building].model.elevations;
  Table table;
  table.add(say("cli.level"), run.c.units.length, std::vector<double>(levels.rbegin(), levels.rend()));
  return with_columns(std::move(table), table_columns(Owner::floor, run, places, say.number(),
                                                      of_forces ? QuantityTable::forces : QuantityTable::main));
}

std::string plane_table(const PlanRun& run, Index building, const Words& say) {
  const PlanModel& model = run.problem.buildings[building].model;
  const std::vector<QuantityPlace> places = planes_from_top(run.problem, building);
  std::vector<std::string> names;
  std::vector<double> levels;
  for (const QuantityPlace& place : places) {
    names.push_back(model.planes[place.plane].name);
    levels.push_back(model.elevations[place.floor]);
  }
  if (places.empty()) return {};
  Table table;
  table.add(say("column.plane"), "", names);
  table.add(say("cli.level"), run.c.units.length, levels);
  return "\n" + say("cli.planes", {{"building", run.problem.buildings[building].name}}) + "\n\n" +
         with_columns(std::move(table), table_columns(Owner::plane, run, places, say.number()));
}

std::string foundation_table(const PlanRun& run, Index building, const Words& say) {
  std::vector<TableColumn> columns = table_columns(Owner::building, run, {{building}}, say.number());
  if (columns.empty()) return {};
  return "\n" + say("plan.foundation") + "\n\n" + with_columns(Table(), std::move(columns));
}

std::string bearing_table(const PlanRun& run, Index building, const Words& say) {
  const std::vector<QuantityPlace> places = bearings_of(run.problem, building);
  if (places.empty()) return {};
  const PlanModel& model = run.problem.buildings[building].model;
  std::vector<double> x, y;
  for (const PlanModel::Bearing& one : model.bearings) {
    x.push_back(model.footprint.corner.x() + one.at.x());
    y.push_back(model.footprint.corner.y() + one.at.y());
  }
  Table table;
  table.add("x", run.c.units.length, x);
  table.add("y", run.c.units.length, y);
  return "\n" + say("plan.bearings") + "\n\n" +
         with_columns(std::move(table), table_columns(Owner::bearing, run, places, say.number()));
}

/// The links of each [[link]] of the case, from the top down.
std::string link_tables(const PlanRun& run, const Words& say) {
  std::string text;
  const std::vector<std::vector<Index>> all = links_by_spec(run.c.links);
  for (std::size_t spec = 0; spec < all.size(); ++spec) {
    std::vector<QuantityPlace> places;
    std::vector<double> levels;
    for (auto link = all[spec].rbegin(); link != all[spec].rend(); ++link) {
      places.push_back({*link});
      levels.push_back(run.problem.links[*link].link.elevation);
    }
    if (places.empty()) continue;
    const std::string name = link_name(run.problem, run.problem.links[places.front().item]);
    Table table;
    table.add(say("cli.level"), run.c.units.length, levels);
    text += "\n" + say("cli.links", {{"link", name}, {"law", run.c.links[spec].law}}) + "\n\n" +
            with_columns(std::move(table), table_columns(Owner::link, run, places, say.number()));
  }
  return text;
}

}  // namespace

std::string run_tables(const PlanRun& run, const Words& say) {
  const PlanProblem& problem = run.problem;
  std::string text;
  for (std::size_t g = 0; g < problem.gaps.size(); ++g) {
    if (problem.gaps[g].contacts.empty()) continue;
    const std::string name = gap_name(problem, problem.gaps[g]);
    text += "\n" + say("cli.contact", {{"gap", name}}) + "\n\n" + contact_table(run, g, say);
  }
  text += link_tables(run, say);
  for (Index b = 0; b < std::ssize(problem.buildings); ++b) {
    text += "\n" + say("cli.peaks", {{"building", problem.buildings[b].name}}) + "\n\n";
    text += floor_table(run, b, false, say) + "\n" + floor_table(run, b, true, say);
    if (problem.buildings[b].is_rigid()) text += "  " + say("cli.moves") + "\n";
    text += foundation_table(run, b, say) + bearing_table(run, b, say) + plane_table(run, b, say);
  }
  return text;
}

}  // namespace bentur::cli
