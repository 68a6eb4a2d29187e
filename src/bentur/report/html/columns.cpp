#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/model/plan/plan_places.h"
#include "bentur/model/run_results.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur::html {
namespace {

double demand_capacity(const RunView& run, const QuantityPlace& at) {
  return value_of(quantity_named("column_demand_capacity", Owner::point), run, at);
}

double demand_capacity(const PlanRun& run, const QuantityPlace& at) {
  return value_of(quantity_named("column_demand_capacity", Owner::point, true), run, at);
}

const ShownUnits& shown_of(const RunView& run) { return run.shown; }
ShownUnits shown_of(const PlanRun& run) { return shown_units(run); }

/// A struck column and where.
struct Struck {
  Eigen::Index building = 0;
  double elevation = 0;
};

Struck struck_at(const RunView& run, Eigen::Index point) {
  const ContactPoint& at = run.problem.points.at(point);
  return {struck_column(run.problem, at).value().building, at.elevation};
}

Struck struck_at(const PlanRun& run, Eigen::Index point) {
  const PlanContactPlace at = contact_at(run.problem, point);
  return {struck_column(run.problem, run.problem.gaps[at.gap], *at.contact).value().building, at.contact->elevation};
}

/// The column nearest to what it bears, else the one with the largest shear.
template <class Run>
Html lead(const Run& run, const std::vector<QuantityPlace>& places, const Units& units, const Words& say) {
  const auto demand = [&](const QuantityPlace& at) {
    const double ratio = demand_capacity(run, at);
    const std::optional<ColumnPeaks>& column = run.response.points[at.item].column;
    return std::pair{std::isnan(ratio) ? 0.0 : ratio, column ? column->shear : 0.0};
  };
  const QuantityPlace& worst =
      *std::max_element(places.begin(), places.end(),
                        [&](const QuantityPlace& a, const QuantityPlace& b) { return demand(a) < demand(b); });
  const ColumnPeaks column = run.response.points[worst.item].column.value_or(ColumnPeaks{});
  const Struck struck = struck_at(run, worst.item);
  const ShownUnits& shown = shown_of(run);
  std::string text = say("columns.worst", {{"building", run.problem.buildings[struck.building].name},
                                           {"elevation", quantity(struck.elevation, units.length)},
                                           {"shear", force_text(shown, column.shear, "F")},
                                           {"shear_without", force_text(shown, column.shear_no_contact, "F")},
                                           {"moment", force_text(shown, column.moment, "F L")},
                                           {"moment_without", force_text(shown, column.moment_no_contact, "F L")}});
  const double ratio = demand_capacity(run, worst);
  if (!std::isnan(ratio)) {
    text += " " + say(ratio > 1 ? "columns.fails" : "columns.holds", {{"ratio", fmt::format("{:.2f}", ratio)}});
  }
  return element("p", text, "class=\"lead\"");
}

template <class Run>
PageSection section(const Run& run, const RunTable& struck, const Units& units, const Words& say) {
  if (struck.is_empty()) return {};
  return {"columns", say("heading.columns"),
          lead(run, struck.places, units, say) + table_of(struck).called(say("columns.table")).markup() +
              element("p", say("columns.note"), "class=\"note\"")};
}

}  // namespace

PageSection columns_section(const RunView& run, const RunTable& struck, const Words& say) {
  return section(run, struck, run.units, say);
}

PageSection columns_section(const PlanRun& run, const RunTable& struck, const Words& say) {
  return section(run, struck, run.c.units, say);
}

}  // namespace bentur::html
