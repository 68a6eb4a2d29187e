#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/model/plan/plan_run.h"
#include "bentur/report/figures/box.h"
#include "bentur/report/kinds/internal/history_panels.h"
#include "bentur/report/scene/plan_scene.h"

// The figures of buildings in plan, beside those of a row in run_figures.h.
namespace bentur {

/// The contacts of the gap and at the elevation that the options ask for. @throws NoFigure when there are none.
[[nodiscard]] std::vector<Eigen::Index> asked_points(const PlanRun& run, const FigureOptions& options);
/// Of these the one hit hardest, or, where nothing is hit, nearest to it. @throws NoFigure when there is none.
[[nodiscard]] Eigen::Index chosen_point(const PlanRun& run, const FigureOptions& options);
/// "level 6.7 m".
[[nodiscard]] std::string level_text(const PlanRun& run, Eigen::Index point, const FigureOptions& options);
/// "A | B, level 6.7 m, y = 18 m".
[[nodiscard]] std::string point_text(const PlanRun& run, Eigen::Index point, const FigureOptions& options);
/// What histories there are of.
[[nodiscard]] HistoryPlace place_of(const PlanRun& run, Eigen::Index point, const FigureOptions& options);
// As those of a row.
[[nodiscard]] std::string shown_value(const PlanRun& run, double value, std::string_view form);
[[nodiscard]] std::string shown_unit(const PlanRun& run, std::string_view form);
[[nodiscard]] double shown_factor(const PlanRun& run, std::string_view form);

/// Where in a footprint its name may stand.
struct NameRows {
  std::array<double, 3> parts = {0.5, 0.85, 0.15};  ///< of its height, the best first
  double half_height = 0;                           ///< of the name [length]
  std::vector<Box> marks = {};                      ///< to which it gives way
};
constexpr double high_name = 0.4;  ///< with room above and below it [cm]
/// A name where rings of a picture, as far as none above covers them, leave it the most room along x, in one of these
/// rows, so that it lies within them; no room: none.
[[nodiscard]] PlaceText place_of_name(const std::string& name, const PlanRings& rings, const NameRows& rows,
                                      const std::vector<PlanRings>& above = {});

/// Of all buildings, whose rings these are: all names whole in one line, or where one has no room all of them in short.
/// @param above of each building what may cover something of it; empty: nothing does
[[nodiscard]] std::vector<PlaceText> places_of_names(const PlanProblem& problem, const std::vector<PlanRings>& rings,
                                                     const NameRows& rows, double one_cm,
                                                     const std::vector<std::vector<PlanRings>>& above = {});

[[nodiscard]] Figure map_figure(const PlanRun& run, const FigureOptions& options);
[[nodiscard]] Figure overview_figure(const PlanRun& run, const FigureOptions& options);
[[nodiscard]] Figure scene_figure(const PlanRun& run, const FigureOptions& options);
[[nodiscard]] Figure displacement_figure(const PlanRun& run, const FigureOptions& options);
[[nodiscard]] Figure opening_figure(const PlanRun& run, const FigureOptions& options);
[[nodiscard]] Figure force_figure(const PlanRun& run, const FigureOptions& options);
[[nodiscard]] Figure orbit_figure(const PlanRun& run, const FigureOptions& options);
[[nodiscard]] Figure friction_figure(const PlanRun& run, const FigureOptions& options);
[[nodiscard]] Figure bearing_loop_figure(const PlanRun& run, const FigureOptions& options);
[[nodiscard]] Figure soil_loop_figure(const PlanRun& run, const FigureOptions& options);
[[nodiscard]] Figure floor_spectrum_figure(const PlanRun& run, const FigureOptions& options);
[[nodiscard]] Figure frame_forces_figure(const PlanRun& run, const FigureOptions& options);
[[nodiscard]] Figure frame_envelope_figure(const PlanRun& run, const FigureOptions& options);
[[nodiscard]] Figure frame_moment_figure(const PlanRun& run, const FigureOptions& options);
[[nodiscard]] Figure frame_shear_figure(const PlanRun& run, const FigureOptions& options);
[[nodiscard]] Figure frame_axial_figure(const PlanRun& run, const FigureOptions& options);
[[nodiscard]] Figure energy_figure(const PlanRun& run, const FigureOptions& options);

}  // namespace bentur
