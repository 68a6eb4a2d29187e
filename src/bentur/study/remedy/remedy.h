#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/model/story/study_story.h"
#include "bentur/study/design/study.h"
#include "bentur/study/study_runs.h"

namespace bentur {

/// One number that a remedy chooses: a [[vary]] with a range. Those that move in step have one axis.
struct RemedyParameter {
  std::string name, parameter;  ///< of the coordinate; the key of the case
  std::string unit;             ///< as UDUNITS reads it; "1" where there is none
  SoughtRange range;
  std::size_t axis = 0;  ///< of those that are chosen
};

/// A choice that has been tried.
struct RemedyTrial {
  std::vector<double> places;  ///< u per axis [-], 0 … 1
  std::vector<double> values;  ///< per parameter
  double objective = 0;        ///< infinite where no number can be relied on
  double size = 0;             ///< mean over the axes of the way from what the case says, as part of its range [-]
  std::size_t failed = 0;      ///< of its runs: those that collapse, fail or have contact that is not modelled
  OpenNeeds open = {};         ///< of the others those whose numbers are not known to hold
};

/// What a search for a remedy has found. A search that was stopped has what was tried before.
struct RemedySearch {
  Study study;
  std::string title;
  std::vector<std::string> buildings;  ///< their names
  std::string unit;                    ///< of the objective, as UDUNITS reads it
  std::vector<RemedyParameter> parameters;
  std::size_t axes = 0;             ///< that are chosen
  std::size_t runs_each = 1;        ///< of a trial: one per record
  std::vector<RemedyTrial> trials;  ///< in the order of their making; the first is what the case says
  std::size_t with_slopes = 0;      ///< at how many choices derivatives were taken
  bool stopped = false;
  bool both_ways = false;  ///< each record is applied as recorded and reversed

  [[nodiscard]] const RemedySpec& spec() const { return *study.remedy; }
  /// The trial with the least objective, of several the smallest; nothing where none has a number.
  [[nodiscard]] const RemedyTrial* best() const;
  /// The smallest that keeps the limit; nothing without a limit, or where none does.
  [[nodiscard]] const RemedyTrial* smallest() const;
  /// Parameters that a trial has at an end of their range, where they were moved to.
  [[nodiscard]] std::vector<std::size_t> at_bounds(const RemedyTrial& trial) const;
};

/// Solves some runs of a study, in the order of their numbers, and asks meanwhile whether to go on.
using RunSolver = std::function<std::vector<RunResult>(const StudyRuns&, std::span<const std::size_t> runs,
                                                       const std::function<bool()>& goes_on)>;

struct RemedyOptions {
  std::filesystem::path journal;  ///< what has been tried is kept here; empty: nowhere
  bool resume = false;            ///< goes on with a journal that is left
  std::string version;            ///< of the program
  const char* resumed_by = "--resume";
  /// Asked often, by what part of the evaluations is done [-]; false: end as soon as possible.
  std::function<bool(double)> goes_on = {};
  RunSolver solve = {};  ///< the runs of a choice; empty: one after the other
  bool slopes = true;    ///< derivatives are used where there are any; false: for a comparison
};

/// Seeks the choice within the ranges of a study with [remedy] for which its objective is least, and with a limit the
/// smallest choice that keeps it: half of the evaluations everywhere, then from the best on, then with the limit as a
/// constraint, and at last by halving the way back to what the case says; where the objective has derivatives, along
/// them. (docs/studies.md, "Remedies")
/// @return nothing when the study has an error; all are in `diagnostics`.
/// @throws std::runtime_error where a journal is there, or with `resume` is another study's, or cannot be written.
[[nodiscard]] std::optional<RemedySearch> seek_remedy(const std::filesystem::path& study, const RemedyOptions& options,
                                                      Diagnostics& diagnostics);

/// The study whose runs are those of one choice: `places` u per axis of what is chosen.
[[nodiscard]] Study chosen_study(const Study& study, const std::vector<double>& places);

[[nodiscard]] std::string remedy_json(const RemedySearch& search, std::string_view version);

}  // namespace bentur
