#include <algorithm>
#include <array>

#include "bentur/core/number_text.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/kinds/internal/plan_figures.h"
#include "bentur/report/kinds/kinds.h"

namespace bentur {
namespace {

using Eigen::Index;

/// One row of histories over another.
Panel loop_panel(const Eigen::MatrixXd& all, Index along, Index force, double factor) {
  Curve curve;
  for (const double value : all.row(along)) curve.x.push_back(value);
  for (const double value : all.row(force)) curve.y.push_back(factor * value);
  return {.height = 5, .curves = {std::move(curve)}};
}

}  // namespace

Figure bearing_loop_figure(const PlanRun& run, const FigureOptions& options) {
  Figure figure{.title = "Force of bearings over their displacement, without dashpots",
                .columns = 2,
                .width = broad(options.width)};
  for (Index b = 0; b < std::ssize(run.response.histories.bearing); ++b) {
    const Eigen::MatrixXd& all = run.response.histories.bearing[b];
    if (all.rows() == 0) continue;
    const PlanBuilding& building = run.problem.buildings[b];
    const PlanPeaks::Bearings& peaks = run.response.buildings[b].bearings;
    const Index count = std::ssize(building.model.bearings);
    Index most = 0;
    (void)(peaks.x.array().square() + peaks.y.array().square()).maxCoeff(&most);
    for (Index i = 0; i < 2; ++i) {
      Panel panel = loop_panel(all, 2 * most + i, 2 * (count + most) + i, shown_factor(run, "F"));
      panel.title = building.name + ", " + word(options, "bearing {}", std::to_string(most + 1));
      panel.x.label = with_unit(word(options, "Displacement along {}", i == 0 ? "x" : "y"), run.c.units.length);
      panel.y.label = with_unit(word(options, "Force of the bearings V"), shown_unit(run, "F"));
      const double moved = (i == 0 ? peaks.x : peaks.y)(most);
      const PlanModel::Bearing& bearing = building.model.bearings[static_cast<std::size_t>(most)];
      if (bearing.elements() > 0 && moved > bearing.law->yield_deformation()) {
        const double yield = bearing.law->yield_deformation();
        panel.rules = {{.at = yield, .vertical = true, .label = word(options, "yield"), .line = Line::dotted},
                       {.at = -yield, .vertical = true, .line = Line::dotted}};
      }
      figure.panels.push_back(std::move(panel));
    }
    figure.finding += (figure.finding.empty() ? "" : "; ") + building.name + ": " +
                      word(options, "force up to {}, displacement up to {}",
                           shown_value(run, std::max(peaks.force_x(most), peaks.force_y(most)), "F"),
                           shown_value(run, std::max(peaks.x(most), peaks.y(most)), "L"));
  }
  if (figure.panels.empty()) throw NoFigure("no building shown stands on bearings: building.isolation puts one there");
  return figure;
}

Figure soil_loop_figure(const PlanRun& run, const FigureOptions& options) {
  constexpr double round_off = 1e-9;
  Figure figure{.title = "Force and moment of the springs and dashpots under foundations over how these move",
                .columns = 2,
                .width = broad(options.width)};
  constexpr std::array<const char*, 5> moves = {"Sway along x", "Sway along y", "Rocking along x [rad]",
                                                "Rocking along y [rad]", "Twist [rad]"};
  constexpr std::array<const char*, 5> forces = {"Force of the soil V", "Force of the soil V", "Moment of the soil M",
                                                 "Moment of the soil M", "Moment of the soil M"};
  for (Index b = 0; b < std::ssize(run.response.histories.foundation); ++b) {
    const Eigen::MatrixXd& all = run.response.histories.foundation[b];
    if (all.rows() == 0) continue;
    const PlanBuilding& building = run.problem.buildings[b];
    const Eigen::VectorXd& peaks = run.response.buildings[b].foundation;
    // Compared as movements of the top, or of the edge.
    const double height =
        building.model.elevations.back() - building.model.elevations.front() + building.model.storey_heights.front();
    Eigen::VectorXd arms(5);
    arms << 1, 1, height, height, 0.5 * building.model.footprint.size.maxCoeff();
    const Eigen::VectorXd moved = arms.cwiseProduct(peaks);
    for (Index i = 0; i < 5; ++i) {
      if (!(moved(i) > round_off * moved.maxCoeff())) continue;
      const char* const form = i < 2 ? "F" : "F L";
      Panel panel = loop_panel(all, i, 5 + i, shown_factor(run, form));
      panel.title = building.name;
      panel.x.label = word(options, moves[i]);
      if (i < 2) panel.x.label = with_unit(panel.x.label, run.c.units.length);
      panel.y.label = with_unit(word(options, forces[i]), shown_unit(run, form));
      figure.panels.push_back(std::move(panel));
    }
    figure.finding +=
        (figure.finding.empty() ? "" : "; ") + building.name + ": " +
        word(options, "sway up to {}, rocking up to {}", shown_value(run, peaks.head<2>().maxCoeff(), "L"),
             number(peaks.segment<2>(2).maxCoeff()) + " rad");
  }
  if (figure.panels.empty()) throw NoFigure("no building stands on soil that gives way: building.soil puts one there");
  return figure;
}

}  // namespace bentur
