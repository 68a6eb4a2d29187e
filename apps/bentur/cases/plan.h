#pragma once

#include <string>
#include <vector>

#include "bentur/model/plan/plan_case.h"
#include "bentur/report/html/report.h"

namespace bentur::cli {

// What commands do with a case of buildings in plan (is_plan_case() of io). @throws Failure as with every other case.

void check_plan(const std::string& file, const std::string& language);
void print_plan_modes(const std::string& file, bool by_jacobi, bool json);

/// Solves it, with progress on a terminal.
[[nodiscard]] PlanRun simulate_plan(const std::string& file, const std::string& language);

/// What its gaps need and rules ask, simulated, and what rules ask from heights alone.
void print_plan_gaps(const std::string& file, bool json, const std::string& language);
void print_plan_rules(const std::string& file, bool json, const std::string& language);

struct PlanRunArguments {
  std::string file;
  std::string directory;             ///< for the results; empty: none are written
  std::vector<std::string> figures;  ///< formats; empty: none are drawn
  bool json = false, quiet = false, force = false;
};
/// Prints the summary, as JSON or as tables, unless `quiet`.
void run_plan(const PlanRunArguments& arguments, const std::string& language);

/// Solves the case and writes its report. @param head the file of an office's own head, which options hold; or empty
void report_plan(const std::string& file, const std::string& head, const std::string& output, bool force,
                 const ReportOptions& options);

}  // namespace bentur::cli
