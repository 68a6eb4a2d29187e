#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/study/fragility/ida_fragility.h"
#include "bentur/study/fragility/ida_results.h"

namespace bentur {

/// What is asked of the results of an incremental dynamic analysis.
struct FragilityRequest {
  std::string event = pounding_event;
  FragilityMethod method = FragilityMethod::likelihood;
  BootstrapOptions bootstrap = {};
  std::optional<double> at = {};           ///< intensity [its unit in the results] for the gaps
  std::vector<double> probabilities = {};  ///< p of the gaps, each in (0, 1)
  std::string along = {};  ///< name of the coordinate that is the gap; empty: the only gap width there is
};

/// The gap for P(event | at) ≤ probability, at one combination of the other axes.
struct GapAt {
  std::size_t first_case = 0;  ///< the case at the first width, which says what the other axes have
  double probability = 0;
  GapEstimate estimate;
};

struct FragilityReport {
  IdaResults results;
  std::vector<CaseFragility> fragilities;  ///< per case
  std::size_t gap_axis = 0;                ///< of the results' axes, where gaps were asked for
  std::string gap_name, gap_units;
  std::vector<GapAt> gaps;
};

/// Why a method does not go with these results and their event; empty: it does.
[[nodiscard]] std::string method_fault(const IdaResults& results, FragilityMethod method);

/// @param results for the request's event.
/// @return nothing where the results do not have what is asked for; `error` then says what.
[[nodiscard]] std::optional<FragilityReport> fragility_report(IdaResults results, const FragilityRequest& request,
                                                              std::string& error);

/// The same gaps, for the request's intensity and probabilities, from the fragilities that `report` holds.
/// @return whether there are such gaps; `error` says why not.
[[nodiscard]] bool find_gaps(FragilityReport& report, const FragilityRequest& request, std::string& error);

/// docs/studies.md. What does not exist is null.
[[nodiscard]] std::string fragility_json(const FragilityReport& report, const FragilityRequest& request,
                                         std::string_view version);

}  // namespace bentur
