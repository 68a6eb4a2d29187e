#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bentur/model/gap/spectral_gap.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/model/run_results.h"
#include "bentur/model/suite/suite.h"
#include "bentur/report/figures/figure.h"
#include "bentur/study/fragility/ida_results.h"
#include "bentur/study/suite/suite_run.h"

namespace bentur {

/// What a user may choose besides the kind of figure.
struct FigureOptions {
  std::optional<double> from, to;   ///< of histories and energies [s]
  std::optional<std::size_t> gap;   ///< counted from 0; default: the one with the hardest impact
  std::optional<double> elevation;  ///< of the contact point [length]; default: that of the hardest impact
  std::vector<std::pair<std::string, std::string>> at;   ///< of a sweep: name and value of what stays fixed
  std::string against;                                   ///< of a sweep: what stands along the x axis
  std::string event = pounding_event;                    ///< of a fragility: EventRule
  FragilityMethod method = FragilityMethod::likelihood;  ///< of a fragility: what finds it
  double width = column_width;                           ///< [cm]
  bool narrow = false;  ///< for a telephone: no wider than that where panels can stand one below another
  FigureWords say = {};
  std::string language = "en";  ///< of sentences, as report_languages() has them
  /// Of what stands as a row of buildings and is none, as frames in plan: the colour of the building that each is of.
  std::vector<Tone> tones = {};
  /// Where more varies than a figure can show, shows a part of it, which the figure names, in place of an error.
  bool choose = false;
};

/// These results cannot give the figure that was asked for; what() says what they can give.
class NoFigure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct FigureKind {
  std::string name;   ///< "displacement", as the command line takes it
  std::string shows;  ///< a few words on what is drawn
  /// Among the figures of a report; others have little to say of these results, or stand above.
  bool tells = true;
  bool over_time = false;  ///< time stands along its x axis: FigureOptions::from and to
};

/// The kinds of figure that these results can give; file_kinds.h has those of files.
[[nodiscard]] std::vector<FigureKind> figure_kinds(const RunResults& run);

/// Names of all kinds of figure that a run may give, whatever this one holds.
[[nodiscard]] std::vector<std::string> run_figure_names();

/// A figure of one of the kinds.
/// @throws NoFigure when there is no such kind, or what the options ask for is not there.
[[nodiscard]] Figure make_figure(const RunResults& run, const std::string& kind, const FigureOptions& options = {});

/// The same of buildings in plan.
[[nodiscard]] std::vector<FigureKind> figure_kinds(const PlanRun& run);
[[nodiscard]] Figure make_figure(const PlanRun& run, const std::string& kind, const FigureOptions& options = {});

/// The first period of a building, marked in a spectrum.
struct SpectrumMark {
  std::string name;
  double period = 0;       ///< [s]
  std::size_t number = 0;  ///< of the building
  Tone tone = Tone::blue;  ///< of the building
  /// Ordinates of its modes, where they are not those of the curves at its first period.
  std::vector<double> periods = {}, acceleration = {}, displacement = {};
};

/// Spectral acceleration and displacement over period.
struct SpectrumCurves {
  std::vector<double> periods;            ///< T [s]
  std::vector<double> acceleration;       ///< S_a [unit]
  std::vector<double> displacement;       ///< S_d [length]
  std::string acceleration_unit, length;  ///< units as the axes show them
  double damping = 0.05;                  ///< ζ [-]
  std::vector<SpectrumMark> marks = {};
  std::string title = "Response spectra of the ground motion";
  std::optional<double> from = {}, to = {};  ///< periods shown [s]; all, unless given
};
/// Both spectra, one above the other.
[[nodiscard]] Figure spectrum_figure(const SpectrumCurves& curves, const FigureOptions& options = {});

/// The spectrum of a case by which its gaps are found, with what the first modes of the buildings take from it.
[[nodiscard]] Figure design_spectrum_figure(const Case& c, const Problem& problem, const SpectralGaps& spectral,
                                            const FigureOptions& options = {});

/// Of a suite the spectra of its records as they are scaled and their mean, against the target, over the band.
[[nodiscard]] Figure suite_figure(const SuiteSpec& suite, const Units& units, const FigureOptions& options = {});

/// The record that needs most of a gap, of none asked for that of the gap which lacks most: its number, from 0.
[[nodiscard]] std::size_t governing_record(const SuiteRun& run, std::optional<std::size_t> gap = {});
/// Whether that record needs most of it under its motion times −1.
[[nodiscard]] bool governs_reversed(const SuiteRun& run, std::size_t record, std::optional<std::size_t> gap = {});

/// The kinds of figure that the runs of a suite give: "suite", its spectra, and "gap-needed", what each record needs of
/// a gap beside what is given and, where a code scales them, what that takes of them. @throws NoFigure when there is no
/// such kind, or no gap where anything is needed.
[[nodiscard]] std::vector<FigureKind> figure_kinds(const SuiteRun& run);
[[nodiscard]] Figure make_figure(const SuiteRun& run, const GapStudy& gaps, const std::string& kind,
                                 const FigureOptions& options = {});

/// What happens at other widths of a gap.
struct GapCurve {
  std::string name;                                    ///< of the gap
  std::vector<double> widths, forces, amplifications;  ///< [length], [force], [-]; one of each for each width
  double given = 0;                                    ///< width of the case [length]
  std::optional<double> needed = {};                   ///< to stay apart [length]
  std::string length, force_unit;                      ///< units as the axes show them
};
/// Peak contact force and largest amplification against the width, one above the other.
[[nodiscard]] Figure gap_curve_figure(const GapCurve& curve, const FigureOptions& options = {});

}  // namespace bentur
