#include <fmt/format.h>

#include <cmath>

#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/run_figures.h"

namespace bentur {
namespace {

constexpr double percent = 100;

/// The storey of a building that yields most, or the one below the elevation asked for; nothing where none can yield.
std::optional<Eigen::Index> chosen_storey(const RunResults& run, Eigen::Index b, const FigureOptions& options) {
  const Eigen::VectorXd& ductility = run.response.buildings[b].yielding.ductility;
  std::optional<Eigen::Index> chosen;
  for (Eigen::Index f = 0; f < ductility.size(); ++f) {
    if (std::isnan(ductility(f))) continue;
    if (!is_at(options, run.problem.buildings[b].model.elevations[f])) continue;
    if (!chosen || ductility(f) > ductility(*chosen)) chosen = f;
  }
  return chosen;
}

/// V over Δ/h of one storey, its yield drift marked.
Panel loop(const RunResults& run, Eigen::Index b, Eigen::Index storey, const FigureOptions& options) {
  const bool exact = std::ssize(run.response.course.storey_shear) > b && run.response.course.storey_shear[b].size() > 0;
  const Histories& histories = exact ? run.response.course : run.response.histories;
  const BuildingPeaks& peaks = run.response.buildings[b];
  const Building& building = run.problem.buildings[b];
  const bool bearings = building.model.has_slab && storey == 0;
  const Eigen::MatrixXd& drifts = bearings ? histories.displacement[b] : histories.drift_ratio[b];
  const double factor = bearings ? 1 : percent;
  Curve curve;
  for (std::size_t n = 0; n < histories.time.size(); ++n) {
    const auto sample = static_cast<Eigen::Index>(n);
    curve.x.push_back(factor * drifts(storey, sample));
    curve.y.push_back(histories.storey_shear[b](storey, sample));
  }
  const double largest = bearings ? peaks.displacement(storey) : peaks.drift_ratio(storey);
  const double yield = factor * largest / peaks.yielding.ductility(storey);
  const std::string name = bearings ? word(options, "bearings")
                                    : word(options, "storey {}", std::to_string(building.model.storey_number(storey)));
  Panel panel{.title = fmt::format("{}, {}", building.name, name),
              .x = {.label = bearings ? with_unit(word(options, "Displacement x"), run.c.units.length)
                                      : word(options, "Storey drift Δ/h [%]")},
              .y = {.label = with_unit(word(options, bearings ? "Force of the bearings V" : "Storey shear V"),
                                       run.c.units.force)},
              .height = 5,
              .curves = {curve}};
  if (peaks.yielding.ductility(storey) >= 1) {
    panel.rules = {{.at = yield, .vertical = true, .label = word(options, "yield"), .line = Line::dotted},
                   {.at = -yield, .vertical = true, .line = Line::dotted}};
  }
  return panel;
}

}  // namespace

Figure storey_loop_figure(const RunResults& run, const FigureOptions& options) {
  Figure figure{.title = "Storey shear over drift, the yield drift dotted", .width = options.width};
  for (const Eigen::Index b : shown_buildings(run, options)) {
    if (const auto storey = chosen_storey(run, b, options)) figure.panels.push_back(loop(run, b, *storey, options));
  }
  if (figure.panels.empty()) throw NoFigure("no storey that can yield is there");
  return figure;
}

}  // namespace bentur
