#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bentur/io/results/result_variable.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/model/run_results.h"

namespace bentur {

/// Everything that histories.nc holds of a run (docs/result-files.md), each variable with its dimensions, units and
/// description: the one list that files are written from and read by, whatever writes or reads them. Dimensions `time`,
/// `elevation_N` for building N (1 the leftmost), `point`, `gap`, `link`, `impact`; where there is nothing along one,
/// it and its variables are left out, and without histories all that go along `time`. Group `exact` is the exact
/// course. The values look into `results`, which must outlive them.
[[nodiscard]] ResultFile run_file(const RunResults& results, std::string_view version);
/// Of buildings in plan, with dimensions `component` of the ground motion and `plane_N` of building N too.
[[nodiscard]] ResultFile run_file(const PlanRun& run, std::string_view version);

/// What histories.nc alone tells of a run: of the case its title, units and duration; buildings with names, elevations,
/// periods and shapes; contact points and links without laws; every kept quantity of floors, points, links and impacts;
/// histories, energies and exact course; data for figures. What the file contradicts itself in is ResultSource::fail().
[[nodiscard]] RunResults read_run(const ResultSource& source);

/// The floor of a building that is nearest to a level, which results name it by.
[[nodiscard]] Eigen::Index nearest_floor(const Building& building, double elevation);

/// Whether a file is one of a run, of this version.
[[nodiscard]] bool is_run(const ResultSource& source);

/// Where gaps, contact points and links of a problem are: names of the buildings on both sides, and elevations where a
/// unit of length is given for them.
struct PlaceVariables {
  ResultDimension gaps, points, links;
  std::vector<ResultVariable> variables;
};
[[nodiscard]] PlaceVariables place_variables(const Problem& problem, const std::string& point_length,
                                             const std::string& link_length);

}  // namespace bentur
