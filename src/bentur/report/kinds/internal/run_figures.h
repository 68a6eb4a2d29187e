#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bentur/core/number_text.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/run_results.h"
#include "bentur/report/kinds/kinds.h"

namespace bentur {

/// The exact course where it has the list of a building, else samples.
[[nodiscard]] const Histories& histories_with(const RunResults& run, std::vector<Eigen::MatrixXd> Histories::*list,
                                              Eigen::Index building);

/// The point the options ask for: hit hardest, or, where nothing is hit, nearest to it.
/// @throws NoFigure when there is none.
[[nodiscard]] Eigen::Index chosen_point(const RunResults& run, const FigureOptions& options);
/// Whether they ask for this elevation, or for none.
[[nodiscard]] bool is_at(const FigureOptions& options, double elevation);
/// The point at which they ask for a struck column: that with the largest shear. @throws NoFigure when there is none.
[[nodiscard]] Eigen::Index chosen_struck_point(const RunResults& run, const FigureOptions& options);
/// Of so many buildings a figure shows all: where each has a place of its own, and where their curves stand together.
constexpr std::size_t most_apart = 12, most_together = 6;
/// Indices of the buildings to be shown beside one another: all, or of more than `most` the two at the point and,
/// unless a point is asked for, those that the verdict names, then those whose gap lacks most, up to eight, or `most`.
[[nodiscard]] std::vector<Eigen::Index> shown_buildings(const RunResults& run, const FigureOptions& options,
                                                        std::size_t most = most_together);
/// The hardest impact of a point; nullptr without one.
[[nodiscard]] const Impact* hardest_impact(const RunResults& run, Eigen::Index point);
/// Whether the impact in close-up gives back all the energy it takes, so that its loop has no area.
[[nodiscard]] bool is_lossless(const RunResults& run);
/// "Model 1 | Model 2, level 300 cm".
[[nodiscard]] std::string point_text(const RunResults& run, Eigen::Index point, const FigureOptions& options);
/// A text of a figure in the language of the words; each {} in it becomes the next of the values.
[[nodiscard]] std::string filled_word(const FigureWords& say, std::string_view english,
                                      const std::vector<std::string>& values);
template <class... Values>
[[nodiscard]] std::string word(const FigureWords& say, std::string_view english, const Values&... values) {
  return filled_word(say, english, {std::string(values)...});
}
template <class... Values>
[[nodiscard]] std::string word(const FigureOptions& options, std::string_view english, const Values&... values) {
  return filled_word(options.say, english, {std::string(values)...});
}
/// A value with its unit as people are shown it, of a form of units: "5300 kN" of "F".
[[nodiscard]] std::string shown_value(const RunResults& run, double value, std::string_view form);
/// Its unit alone, and what values are multiplied by to stand in it.
[[nodiscard]] std::string shown_unit(const RunResults& run, std::string_view form);
[[nodiscard]] double shown_factor(const RunResults& run, std::string_view form);
[[nodiscard]] std::vector<double> shown_values(const RunResults& run, std::vector<double> values,
                                               std::string_view form);
/// How hard an impact is, in a row or in plan: "peak 5300 kN", without a force "closing at 12 cm/s".
template <class AnyRun>
[[nodiscard]] std::string strength_text(const AnyRun& run, const Impact& impact, const FigureOptions& options) {
  return impact.peak_force > 0
             ? word(options, "peak {}", shown_value(run, impact.peak_force, "F"))
             : word(options, "closing at {}", number(impact.closing_speed) + " " + run.c.units.length + "/s");
}
/// "3.57 s".
[[nodiscard]] std::string seconds_text(double time);
/// Elevation of a building's base [length].
[[nodiscard]] double base_of(const Building& building);
/// The colour of each building, or of the one that each frame in plan is of; of one of them.
[[nodiscard]] std::vector<Tone> tones_of(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Tone tone_of(const RunResults& run, const FigureOptions& options, Eigen::Index building);
/// Whether contact lasts then [s].
[[nodiscard]] inline bool lasts_at(const Impact& impact, double time) {
  return impact.start <= time && impact.end >= time;
}
/// T of the first mode [s]; nothing without modes.
[[nodiscard]] std::optional<double> first_period(const Building& building);

/// Names of all kinds of figure of buildings in a row, and in plan.
[[nodiscard]] std::vector<std::string> row_figure_names();
[[nodiscard]] std::vector<std::string> plan_figure_names();

/// @param of what the message calls the results
[[noreturn]] void refuse_figure(const std::string& kind, const std::string& of, const std::vector<FigureKind>& kinds);

// The figures of a run, one for each kind.
[[nodiscard]] Figure overview_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure scene_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure displacement_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure opening_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure force_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure impact_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure loop_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure envelope_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure amplification_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure forces_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure drift_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure modes_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure hinges_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure hinge_loop_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure storey_loop_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure bearing_loop_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure soil_loop_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure link_loop_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure column_shear_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure column_moment_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure energy_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure run_spectrum_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure floor_spectrum_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure frame_forces_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure frame_envelope_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure frame_moment_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure frame_shear_figure(const RunResults& run, const FigureOptions& options);
[[nodiscard]] Figure frame_axial_figure(const RunResults& run, const FigureOptions& options);

/// Of widths: figures with more panels take a page's.
/// Of a figure with more beside one another than a column has room for: a page for a column [cm]. What is as wide as a
/// page stays, so that its letters stay as large as they are asked for.
constexpr double broad(double width) { return width >= page_width ? width : width * page_width / column_width; }
/// A bar from one value to another, `thick` around its place; or its outline alone, so that it is distinct in grey from
/// one beside it of the same tone.
[[nodiscard]] Curve bar(double from, double to, double place, double thick, Tone tone);
[[nodiscard]] Curve hollow_bar(double from, double to, double place, double thick, Tone tone);
/// The tone of what is judged of a gap.
[[nodiscard]] Tone tone_of(Sufficiency value);
/// That of areas, which in grey are the darker the worse.
[[nodiscard]] Tone area_tone_of(Sufficiency value);
/// Between which buildings a figure is that shows one place, the hardest impact or the closest approach, where that is
/// not the gap that the verdict puts first. @param gap shown @param worst that gap
/// @param with_worst the figure has it too, below
[[nodiscard]] std::string place_text(const std::vector<std::string>& gaps, std::size_t gap, std::size_t worst,
                                     bool is_hit, const FigureOptions& options, bool with_worst);
/// Adds to what a figure says below it: Figure::part.
void add_part(Figure& figure, const std::string& text);
/// Says what bands are, where it has some.
void tell_bands(Figure& figure, const FigureOptions& options);
/// What an overview has where one gap is the worst and is hit hardest: picture, opening, bars.
constexpr std::size_t overview_panels = 3;
/// The gap that the verdict puts first where that is not this one.
[[nodiscard]] std::optional<std::size_t> worst_besides(const std::vector<JudgedGap>& judged, std::size_t gap);
/// Where that gap is shown: at the level that its bars are of where it is hit there, else where it is hit hardest.
[[nodiscard]] FigureOptions options_of_worst(const JudgedGap& judged, std::size_t worst, FigureOptions options);
/// Panels of another figure below those of one, all somewhat lower.
void append(Figure& figure, Figure&& below);
/// Below what a figure shows of one gap the same of the worst one. @return whether it can be drawn
template <class Make>
bool add_worst(Figure& figure, const FigureOptions& of_worst, const Make& make) {
  Figure below;
  try {
    below = make(of_worst);
  } catch (const NoFigure&) {
    return false;
  }
  append(figure, std::move(below));
  return true;
}
/// Of spectra of floors: at which gap they are, or whose roofs, where there are others; and where their periods begin,
/// where samples are too far apart for shorter ones. @param hit the gap of the hardest impact
[[nodiscard]] std::string floors_text(const FloorSpectra& spectra, std::optional<std::size_t> hit,
                                      const std::vector<std::string>& gaps, const std::vector<JudgedGap>& judged,
                                      std::size_t buildings, const FigureOptions& options);
/// An axis whose label and numbers are those of the panel beside it.
void leave_to_neighbour(Axis& axis);
/// Of a curve beside another: dashed where their tones are not distinct in grey.
[[nodiscard]] Line line_beside(Tone tone, Tone other);
/// Line, mark and tone of curve number `index` of several that must be distinguished; marks for few points alone.
void tell_apart(Curve& curve, std::size_t index, std::optional<Tone> tone = {});
[[nodiscard]] Mark mark_of(std::size_t index);

}  // namespace bentur
