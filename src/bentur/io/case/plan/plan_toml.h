#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/io/toml/toml_view.h"
#include "bentur/model/plan/plan_case.h"

namespace bentur {

class CaseMemo;

/// Whether a file is a case of buildings in plan; of one that cannot be read: no.
[[nodiscard]] bool is_plan_case(const std::filesystem::path& file);

/// Reads and validates a case of buildings in plan and the records it names, as read_case() does one of a row: every
/// error goes to `diagnostics`.
/// @param problem takes what a case without errors is solved as, which is made on the way
[[nodiscard]] std::optional<PlanCase> read_plan_case(const std::filesystem::path& file, Diagnostics& diagnostics,
                                                     PlanProblem* problem = nullptr);
/// The same of a text; the folder of `file` is the one record files are in.
[[nodiscard]] std::optional<PlanCase> read_plan_case_text(const std::string& text, const std::filesystem::path& file,
                                                          Diagnostics& diagnostics, PlanProblem* problem = nullptr);

/// A case of buildings in plan and what it is solved as; of one with errors neither is of use.
struct ReadPlan {
  PlanCase c;
  PlanProblem problem;
};
/// The same of a text read before. `memo` is for many readings of nearly the same case, which then share records.
[[nodiscard]] ReadPlan read_plan_case_parts(const TomlView& root, const std::filesystem::path& folder,
                                            Diagnostics& diagnostics, CaseMemo* memo = nullptr);

/// A case whose records are not at hand: everything but those, in place of which there is no motion. Where it gives no
/// duration, which a record had, that is 1 s. @param problem as that of read_plan_case()
[[nodiscard]] std::optional<PlanCase> read_plan_case_without_records(const std::string& text,
                                                                     const std::filesystem::path& file,
                                                                     Diagnostics& diagnostics,
                                                                     PlanProblem* problem = nullptr);

/// The files that were read for it beside its own.
[[nodiscard]] std::vector<std::filesystem::path> files_read(const PlanCase& c);

}  // namespace bentur
