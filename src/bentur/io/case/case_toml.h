#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/model/case.h"
#include "bentur/pounding/plan/plan_problem.h"

namespace bentur {

/// What is made of a case in reading it: the buildings of a row, or what buildings in plan are solved as.
struct MadeParts {
  std::vector<Building> buildings;
  PlanProblem plan;
};

/// Reads and validates a case file and the records it names (docs/case-file.md), of buildings in a row or in plan.
/// Every error found goes to `diagnostics`, each with file:line:column, key, value, rule and, for an unknown key, the
/// nearest known one.
/// @param made takes what is made in reading
/// @param progress of what may take long, the spectra of a suite of records: the fraction done
/// @return the case, or nothing when there was an error.
[[nodiscard]] std::optional<Case> read_case(const std::filesystem::path& file, Diagnostics& diagnostics,
                                            MadeParts* made = nullptr,
                                            const std::function<void(double)>& progress = {});

/// The same for a text that is already in memory. Messages carry `file`; its folder is the one record files are in.
[[nodiscard]] std::optional<Case> read_case_text(const std::string& text, const std::filesystem::path& file,
                                                 Diagnostics& diagnostics, MadeParts* made = nullptr,
                                                 const std::function<void(double)>& progress = {});

/// A case whose records are not at hand: everything but these, in place of which there is no motion. Where it gives no
/// duration, which a record had, that is 1 s.
[[nodiscard]] std::optional<Case> read_case_without_record(const std::string& text, const std::filesystem::path& file,
                                                           Diagnostics& diagnostics, MadeParts* made = nullptr);

/// Takes a logo out that does not stand beside the case, as where results hold a copy of it, or a page has it alone.
void leave_out_lost_logo(TomlValue& root, const std::filesystem::path& folder);

/// [project] of a case's text, without its logo, whatever else stands there; nothing where it has none, or a wrong one.
[[nodiscard]] std::optional<ProjectSpec> project_of(const std::string& text);

/// The files that were read for a case beside its own: of its record, its spectrum and its shapes.
[[nodiscard]] std::vector<std::filesystem::path> files_read(const Case& c);

}  // namespace bentur
