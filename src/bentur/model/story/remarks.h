#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/model/case.h"
#include "bentur/pounding/response.h"

namespace bentur {

/// A number of a case or a response that is unusual: no error, but worth a look. What is usual is what engineers of
/// buildings meet, with room for models; a number that is remarked on may well be meant. Texts are in the catalogue of
/// the report, in its languages, under "remark." and the key.
struct Remark {
  std::string key;                             ///< what it is about, e.g. "period_per_storey"
  std::string subject;                         ///< whose it is: a building, "A | B" for a gap, or empty
  double value = 0;                            ///< in `unit`
  std::string unit;                            ///< of the case, s, g, % or none
  std::optional<double> usual_from, usual_to;  ///< in `unit`; one side or both
  bool is_doubt = false;  ///< so far from usual that what was put in may not be meant: nothing that follows is known
};

/// Of the case: sections, stiffness, periods, motion, delays, gaps, output. And, where there is a response, of what
/// came out: drift, base shear and penetration beyond what linear elastic buildings stand for, and numbers that two
/// ways lead to and that are not quite the same (Response::discrepancies).
[[nodiscard]] std::vector<Remark> remarks(const Case& c, const Problem& problem, const Response* response = nullptr);

/// Of a record alone, as its file has it: how far apart its values are and how long it is, which say whether its times
/// are seconds; and its peak as applied, `pga`, in `units`.
[[nodiscard]] std::vector<Remark> remarks(const RecordEcho& record, const Units& units);

/// What remarks may be about, Remark::key of all there are; a new one is put last.
[[nodiscard]] const std::vector<std::string_view>& remark_keys();
/// What some remarks are about: bit i for key i.
[[nodiscard]] std::uint64_t remark_kinds(const std::vector<Remark>& remarks);
[[nodiscard]] long count_of_doubts(const std::vector<Remark>& remarks);

}  // namespace bentur
