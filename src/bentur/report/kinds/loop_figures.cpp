#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/model/link.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"

namespace bentur {
namespace {

constexpr double percent = 100;

/// The storey of a building that yields most, or the one below the elevation asked for; nothing where none can yield.
std::optional<Eigen::Index> chosen_storey(const RunResults& run, Eigen::Index b, const FigureOptions& options) {
  const Eigen::VectorXd& ductility = run.response.buildings[b].yielding.ductility;
  const StructuralModel& model = run.problem.buildings[b].model;
  std::optional<Eigen::Index> chosen;
  for (Eigen::Index f = model.first_storey(); f < ductility.size(); ++f) {
    if (std::isnan(ductility(f)) || !is_at(options, model.elevations[f])) continue;
    if (!chosen || ductility(f) > ductility(*chosen)) chosen = f;
  }
  return chosen;
}

/// V of one storey over a row of displacements or drifts, each times `factor`; where it yields is marked.
Panel loop(const RunResults& run, Eigen::Index b, Eigen::Index storey, std::vector<Eigen::MatrixXd> Histories::*over,
           double factor, double largest, const FigureOptions& options) {
  const bool exact = std::ssize(run.response.course.storey_shear) > b && run.response.course.storey_shear[b].size() > 0;
  const Histories& histories = exact ? run.response.course : run.response.histories;
  const auto x = (histories.*over)[b].row(storey), y = histories.storey_shear[b].row(storey);
  Curve curve;
  for (const double value : x) curve.x.push_back(factor * value);
  curve.y = shown_values(run, {y.begin(), y.end()}, "F");
  Panel panel{.height = 5, .curves = {curve}};
  const Eigen::VectorXd& ductility = run.response.buildings[b].yielding.ductility;
  if (storey < ductility.size() && ductility(storey) >= 1) {
    const double yield = factor * largest / ductility(storey);
    panel.rules = {{.at = yield, .vertical = true, .label = word(options, "yield"), .line = Line::dotted},
                   {.at = -yield, .vertical = true, .line = Line::dotted}};
  }
  return panel;
}

void add_finding(Figure& figure, const std::string& finding) {
  figure.finding += (figure.finding.empty() ? "" : "; ") + finding;
}

}  // namespace

Figure storey_loop_figure(const RunResults& run, const FigureOptions& options) {
  Figure figure{.title = "Storey shear over drift, the yield drift dotted", .width = options.width};
  for (const Eigen::Index b : shown_buildings(run, options)) {
    const auto storey = chosen_storey(run, b, options);
    if (!storey) continue;
    const Building& building = run.problem.buildings[b];
    const BuildingPeaks& peaks = run.response.buildings[b];
    const std::string number_of = std::to_string(building.model.storey_number(*storey));
    Panel panel = loop(run, b, *storey, &Histories::drift_ratio, percent, peaks.drift_ratio(*storey), options);
    panel.title = building.name + ", " + word(options, "storey {}", number_of);
    panel.x.label = word(options, "Storey drift Δ/h [%]");
    panel.y.label = with_unit(word(options, "Storey shear V"), shown_unit(run, "F"));
    add_finding(figure, panel.title + ": " + word(options, "ductility {}", number(peaks.yielding.ductility(*storey))));
    figure.panels.push_back(std::move(panel));
  }
  if (figure.panels.empty()) throw NoFigure("no storey that can yield is there");
  return figure;
}

Figure bearing_loop_figure(const RunResults& run, const FigureOptions& options) {
  Figure figure{.title = "Force of the bearings over their displacement, without dashpots", .width = options.width};
  for (const Eigen::Index b : shown_buildings(run, options)) {
    const Building& building = run.problem.buildings[b];
    if (!building.model.slab) continue;
    const BuildingPeaks& peaks = run.response.buildings[b];
    Panel panel = loop(run, b, 0, &Histories::displacement, 1, peaks.displacement(0), options);
    panel.title = building.name + ", " + word(options, "bearings");
    panel.x.label = with_unit(word(options, "Displacement x"), run.c.units.length);
    panel.y.label = with_unit(word(options, "Force of the bearings V"), shown_unit(run, "F"));
    add_finding(figure,
                panel.title + ": " +
                    word(options, "force up to {}, displacement up to {}", shown_value(run, peaks.storey_shear(0), "F"),
                         shown_value(run, peaks.displacement(0), "L")));
    figure.panels.push_back(std::move(panel));
  }
  if (figure.panels.empty()) throw NoFigure("no building shown stands on bearings: building.isolation puts one there");
  return figure;
}

Figure soil_loop_figure(const RunResults& run, const FigureOptions& options) {
  Figure figure{.title = "Force and moment of the springs and dashpots under foundations over sway and rocking",
                .columns = 2,
                .width = broad(options.width)};
  const bool exact = !run.response.course.foundation.empty();
  const std::vector<Eigen::MatrixXd>& all = exact ? run.response.course.foundation : run.response.histories.foundation;
  for (const Eigen::Index b : shown_buildings(run, options)) {
    if (b >= std::ssize(all) || all[b].rows() == 0) continue;
    const std::string& name = run.problem.buildings[b].name;
    const auto panel = [&](Eigen::Index along, Eigen::Index force, const char* form, const std::string& x,
                           const std::string& y) {
      const auto moved = all[b].row(along), borne = all[b].row(force);
      Panel one{.title = name, .x = {.label = x}, .y = {.label = with_unit(y, shown_unit(run, form))}, .height = 5};
      one.curves = {{.x = {moved.begin(), moved.end()}, .y = shown_values(run, {borne.begin(), borne.end()}, form)}};
      figure.panels.push_back(std::move(one));
    };
    panel(0, 2, "F", with_unit(word(options, "Sway of the foundation u"), run.c.units.length),
          word(options, "Force of the soil V"));
    panel(1, 3, "F L", word(options, "Rocking θ [rad]"), word(options, "Moment of the soil M"));
    const Eigen::VectorXd& peaks = run.response.buildings[b].foundation;
    add_finding(figure, name + ": " +
                            word(options, "sway up to {}, rocking up to {}", shown_value(run, peaks(0), "L"),
                                 number(peaks(1)) + " rad"));
  }
  if (figure.panels.empty()) throw NoFigure("no building shown stands on soil: building.soil puts one there");
  return figure;
}

namespace {

/// The link with the largest force, of those at the elevation asked for.
Eigen::Index chosen_link(const RunResults& run, const FigureOptions& options) {
  std::optional<Eigen::Index> chosen;
  double most = -1;
  for (Eigen::Index i = 0; i < std::ssize(run.problem.links); ++i) {
    const LinkSummary& link = run.response.links[i];
    const double force = std::max(link.peak_compression, link.peak_tension);
    if (!is_at(options, run.problem.links[i].elevation) || force <= most) continue;
    most = force;
    chosen = i;
  }
  if (!chosen) throw NoFigure("no link is there: [[link]] in the case joins buildings");
  return *chosen;
}

}  // namespace

Figure link_loop_figure(const RunResults& run, const FigureOptions& options) {
  const Eigen::Index i = chosen_link(run, options);
  const Histories& histories = run.response.course.time.empty() ? run.response.histories : run.response.course;
  const auto closed = histories.link_deformation.row(i), force = histories.link_force.row(i);
  const Link& link = run.problem.links[i];
  const LinkSummary& peaks = run.response.links[i];
  const Panel panel{
      .title = link_name(run.problem, link) + ", " + word(options, "level {}", shown_value(run, link.elevation, "L")),
      .x = {.label = with_unit(word(options, "Approach of the floors δ"), run.c.units.length)},
      .y = {.label = with_unit(word(options, "Link force F"), shown_unit(run, "F"))},
      .height = 5,
      .curves = {{.x = {closed.begin(), closed.end()}, .y = shown_values(run, {force.begin(), force.end()}, "F")}}};
  return {.title = "Force of the link with the largest force, pushing apart, over the approach of the floors it joins",
          .finding = word(options, "pushes with up to {}, pulls with up to {}; {} dissipated",
                          shown_value(run, peaks.peak_compression, "F"), shown_value(run, peaks.peak_tension, "F"),
                          shown_value(run, peaks.energy_dissipated, "F L")),
          .panels = {panel},
          .width = options.width};
}

}  // namespace bentur
