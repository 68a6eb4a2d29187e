#pragma once

#include <emscripten/val.h>

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "bentur/io/case/case_parts.h"
#include "bentur/io/file_identity.h"
#include "bentur/model/gap/spectral_gap.h"
#include "bentur/model/run_results.h"
#include "bentur/study/gap/gap_study.h"
#include "bentur/study/suite/suite_run.h"
#include "shell_answers.h"

namespace bentur {
class CaseMemo;
}

namespace bentur::web {

/// What stands between a page and the library: the case that is open, and its run. Everything a page gets is text, JSON
/// or arrays of numbers; no exception leaves a public function. Answers that may fail are JSON objects with "ok", and
/// where that is false "errors": [{file, line, column, key, message}], line and column 0 for the whole file. A case may
/// be of a row or of buildings in plan; what a page gets has the same shape for both.
class Studio {
 public:
  Studio();
  ~Studio();

  /// A file that cases may name, at a path relative to the case.
  void put_file(const std::string& path, const std::string& bytes);
  /// From then on it is not there.
  void remove_file(const std::string& path);

  /// Reads a case. One whose matrices are more than a page can take is refused before they are made.
  /// @return {ok, errors}
  [[nodiscard]] std::string open(const std::string& text, const std::string& file);

  /// Of a case with a suite that has just been opened makes it that of one record, from 1: what follows is of it. Where
  /// there is no such record it stays that of all of them.
  /// @return {ok, errors, record: which it is, 0: all, records: how many there are}
  [[nodiscard]] std::string choose_record(int number);

  /// How many contact points each gap of the case that is open has, by the building to its left; none of buildings in
  /// plan. @return {ok, errors, counts}
  [[nodiscard]] std::string contacts() const;

  /// A case's text with its numbers in other units, text_in_units(). @return {ok, errors, text}
  [[nodiscard]] std::string in_units(const std::string& text, const std::string& length,
                                     const std::string& force) const;

  /// {case: what `bentur schema` says, units: {length: {m: 1, ...}, force: {N: 1, ...}}, style: CSS
  /// of figures}, units in metres and newtons.
  [[nodiscard]] std::string schema() const;

  /// Runs the case that is open, with histories every `output_step` [s]: 0 for none, below 0 for the case's own, and
  /// null for one fine enough to be looked at (report_output_step). `progress` gets the fraction done; where it
  /// answers false the run ends. A case with a spectrum has its gaps computed instead, one with a suite the runs of all
  /// records in short and then the gaps over them: these have no impacts, motion and histories. @return {ok, errors,
  /// seconds}
  [[nodiscard]] std::string solve(const emscripten::val& output_step, const emscripten::val& progress);

  // Of the run, the gaps by a spectrum, or all records of a suite. @throws nothing; empty before there is one.
  [[nodiscard]] std::string summary() const;                            ///< summary.json, or as bentur run --json
  [[nodiscard]] std::string impacts() const;                            ///< impacts.csv
  [[nodiscard]] std::string gaps() const;                               ///< as bentur gap --json
  [[nodiscard]] std::string modes() const;                              ///< as bentur modes --json
  [[nodiscard]] std::string motion(const std::string& language) const;  ///< what motion.js draws
  [[nodiscard]] std::string report(const std::string& language) const;  ///< report.html
  /// What the page tells first, JSON, with the report's sentences in that language.
  [[nodiscard]] std::string overview(const std::string& language) const;
  /// The report's tables: [{id, heading, markup}].
  [[nodiscard]] std::string tables(const std::string& language) const;
  [[nodiscard]] emscripten::val histories() const;  ///< {time, ground, opening, force, buildings}

  /// A figure of one of the kinds that overview() lists, or "gap-curve", which `wanted` has the points of.
  /// @param wanted {width [cm], from, to [s], gap, elevation, curve: {gap, widths, forces, amplifications}}
  /// @return {svg, width [cm], panels: [{left, top, width, height, x: {label, from, to, logarithmic}, y,
  /// curves: [{label, x, y}]}]}, places as PanelPlace; {error} where there is no such figure
  [[nodiscard]] emscripten::val draw(const std::string& kind, const std::string& language,
                                     const emscripten::val& wanted) const;
  /// The same as a file of its own, as bentur plot writes it; empty where there is none.
  [[nodiscard]] std::string figure_file(const std::string& kind, const std::string& language,
                                        const emscripten::val& wanted) const;

  /// Peak force and largest amplification of the case that is open with gap `gap` (0 the first) this wide [length]: its
  /// narrowest point, the others wider by as much as they are. Buildings move freely once for all widths.
  /// @return {ok, errors, force, amplification}
  [[nodiscard]] std::string at_width(int gap, double width);

 private:
  /// Says of a record what it is by its content.
  void know(ExcitationSpec& excitation);
  [[nodiscard]] Json solve_suite(const emscripten::val& progress);
  [[nodiscard]] Json suite_overview(const Words& say) const;

  std::unique_ptr<CaseMemo> memo_;  // buildings and records of the cases that were open: a gap that moves leaves them
  std::map<std::string, FileIdentity> identities_;  // of records, which are large
  std::optional<Case> case_;
  std::optional<Problem> problem_;
  std::optional<RunResults> run_;
  std::optional<SpectralGaps> spectral_;
  std::shared_ptr<const SuiteSpec> suite_;  // of the case that is open, also where one of its records is chosen
  std::size_t record_ = 0;                  // from 1; 0: all
  std::optional<SuiteRun> suite_run_;       // and its gaps
  std::optional<GapStudy> suite_gaps_;
  std::optional<PlanProblem> plan_;  // in place of the problem, and its run
  std::optional<PlanRun> plan_run_;
  GroundMotion motion_;  // of the figures that were made last, which another width of the gap leaves their spectrum
  FigureData figures_;
  std::unique_ptr<FreeResponse> free_;
};

}  // namespace bentur::web
