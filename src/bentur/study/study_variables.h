#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/io/results/result_variable.h"
#include "bentur/study/study_runs.h"

namespace bentur {

/// A variable of the results of a study.
struct StudyVariable : ResultVariable {
  /// Its values of some runs one after the other; empty where they are in `values`. NaN of a run that failed.
  std::function<ResultValues(std::span<const RunResult>)> of_runs = {};
};

/// The file of results of a study (docs/studies.md): the one list of what it holds, whatever writes it.
struct StudyFile {
  std::vector<ResultAttribute> attributes;
  std::vector<ResultDimension> runs;  ///< along which the runs are, the last one fastest
  std::vector<StudyVariable> variables;
};

/// That of `runs`, which must outlive it.
[[nodiscard]] StudyFile study_file(const StudyRuns& runs, std::string_view version);

/// The variable that says why a run failed.
inline constexpr std::string_view message_variable = "message";

/// An error for each coordinate of a study whose name the results need for something else.
void check_names(const Study& study, Diagnostics& diagnostics);

/// peak_drift_ratio of peak_drift_ratio_2: the name of a variable without the building's number, where it has one.
[[nodiscard]] std::string without_number(const std::string& name);

/// The drifts of a building in plan, which are those of its planes.
inline constexpr std::string_view plane_drift = "plane_peak_drift_ratio";

/// Whether a variable is the quantity that is asked for: by its name, by that without the building's number, or as
/// "drift" for short.
[[nodiscard]] bool is_quantity(const std::string& variable, const std::string& asked);

}  // namespace bentur
