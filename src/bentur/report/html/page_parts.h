#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bentur/model/plan/plan_run.h"
#include "bentur/model/run_results.h"

namespace bentur {

// What a page that is no report, the studio, has from those of reports.

/// Impacts that a page lists; where there are more, it says so.
constexpr std::size_t most_impacts = 1500;
/// Which of a run's impacts a page lists: the hardest, in the order in which they begin.
[[nodiscard]] std::vector<Eigen::Index> listed_impacts(const std::vector<Impact>& impacts);

/// What motion.js draws, with its words in that language: the buildings in motion and the listed_impacts().
/// The response must have histories.
/// @throws InvalidParameter for an unknown language.
[[nodiscard]] std::string motion_json(const RunResults& results, const std::string& language);
[[nodiscard]] std::string motion_json(const PlanRun& run, const std::string& language);

/// What is listed of the listed_impacts(), the hardest first; the first column has their numbers from 1.
/// @throws InvalidParameter for an unknown language.
[[nodiscard]] std::vector<TableColumn> impact_columns(const RunResults& results, const std::string& language);
[[nodiscard]] std::vector<TableColumn> impact_columns(const PlanRun& run, const std::string& language);

/// A section of a report. No text of a case can bring a tag, an attribute or a script into its markup.
struct PagePart {
  std::string id, heading, markup;
};

/// The tables of a run as its report has them: the gap each level needs, simulated and by every rule, what contact and
/// floors reach, and struck columns. @throws InvalidParameter for an unknown language.
[[nodiscard]] std::vector<PagePart> table_parts(const RunResults& results, const std::string& language);
/// The same of buildings in plan: the gap each level needs, contacts, floors and planes.
[[nodiscard]] std::vector<PagePart> table_parts(const PlanRun& run, const std::string& language);

}  // namespace bentur
