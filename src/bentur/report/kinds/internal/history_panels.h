#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bentur/pounding/response.h"
#include "bentur/report/kinds/internal/run_figures.h"

// Panels of histories around one contact point: what those of buildings in a row and in plan share.
namespace bentur {

struct TimeWindow {
  double from = 0, to = 0;  ///< [s]
};

/// What histories are of.
struct HistoryPlace {
  std::string title = {};                        ///< "A | B, level 3 m"
  const std::vector<Impact>* impacts = nullptr;  ///< of the run
  Eigen::Index point = 0;                        ///< of these
  TimeWindow samples = {}, whole = {};           ///< first and last sample; and what is known beyond
  double period = 0;                             ///< the longer first one of both buildings [s]
  double closest = 0;                            ///< when they come closest [s]
  bool of_force = false;                         ///< what matters is the course of an impact
};

/// The hardest impact there; nullptr without one.
[[nodiscard]] const Impact* hardest_impact(const HistoryPlace& place);
/// A row of a table of histories.
[[nodiscard]] std::vector<double> row_of(const Eigen::MatrixXd& table, Eigen::Index row);
/// What the user asks for, within the histories. @throws NoFigure where that is nothing
[[nodiscard]] TimeWindow asked_window(const HistoryPlace& place, const FigureOptions& options);
/// The course of the hardest impact, of what moves with a vibration before and after it; or some vibrations around the
/// moment that is nearest to one.
[[nodiscard]] TimeWindow around_the_hardest(const HistoryPlace& place);
/// Whether the latter has a panel of its own beside the whole.
[[nodiscard]] bool has_two_windows(const HistoryPlace& place, const FigureOptions& options);
/// The part of a curve within a window, with one point more at either side.
[[nodiscard]] Curve within(const Curve& whole, const TimeWindow& window);
/// A path without the points that lie within a distance from the one before.
[[nodiscard]] Curve sparse(Curve path, double distance);
/// Of the line of many vibrations side by side: no journal prints one that is much thinner.
constexpr double width_over_time = 0.7;
/// The starts of the contacts there; of very many those that can be distinguished.
[[nodiscard]] Events contacts_within(const HistoryPlace& place, const TimeWindow& window, const FigureOptions& options);
/// Room for all curves within a window and for marks above them, so that panels can be compared.
[[nodiscard]] std::pair<double, double> range_of(const std::vector<Curve>& curves, const TimeWindow& window);

/// The contact force over a window: of each impact its course, `force` at `time`, or where that is not known
/// start, peak and end.
[[nodiscard]] Curve force_curve(const HistoryPlace& place, const std::vector<double>& time,
                                const std::vector<double>& force, const TimeWindow& window);
/// The peak of each impact alone, where there are so many that their courses would fill the frame, or where one is long
/// enough for its course to be seen and no course is known.
[[nodiscard]] std::optional<Curve> force_peaks(const HistoryPlace& place, const TimeWindow& window, bool has_course);

/// What a figure of histories shows besides its curves.
struct HistoryPanels {
  std::string label;             ///< of the y axis
  std::string label_of_parts{};  ///< the same in short; empty: the curves of the whole run stand in one panel
  std::vector<RuleLine> rules{};
  bool mark_contacts = false;
};
/// A panel over the whole run, or one for each curve, and, where that is long, another over its hardest moments; or one
/// over the window asked for.
[[nodiscard]] Figure history_figure(const HistoryPlace& place, const FigureOptions& options,
                                    const std::vector<Curve>& curves, const HistoryPanels& with);
/// The same of contact forces [force] times `factor`, in place of curves.
[[nodiscard]] Figure force_history_figure(const HistoryPlace& place, const FigureOptions& options,
                                          const std::vector<double>& time, const std::vector<double>& force,
                                          const std::string& label, double factor);

/// Writes a value above its place, in the last panel that shows it, or beside it where that is near an end.
void name_value(std::vector<Panel>& panels, double x, double y, const std::string& text);

/// Samples pass a peak by: puts the largest size that was found of a curve [its y] between them, where the parabola
/// through three of them goes furthest; nothing where they hold it.
void add_peak(Curve& samples, double peak);

/// Samples with points between them within a window, so close that no corner is seen: on the cubic that has the values
/// and the rates of both samples beside it.
[[nodiscard]] Curve finer(const Curve& samples, const std::vector<double>& rates, const TimeWindow& window);

/// Writes the largest value of each curve, with its sign, above or below it, in the last panel where nothing goes
/// further there, with room for it; where there is none, beyond what goes further, led to its peak. @param text of a
/// value
void name_peaks(const std::vector<Panel*>& panels, const std::vector<Curve>& curves,
                const std::function<std::string(double)>& text);

/// Where the energy is, in `unit` after `factor`, within a window.
[[nodiscard]] Figure energy_history_figure(const EnergyHistories& energy, const TimeWindow& asked,
                                           const FigureOptions& options, double factor, const std::string& unit);

}  // namespace bentur
