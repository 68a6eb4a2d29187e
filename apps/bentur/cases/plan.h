#pragma once

#include <string>

namespace bentur::cli {

// What commands do with a case of buildings in plan (is_plan_case() of io). @throws Failure as with every other case.

void check_plan(const std::string& file, const std::string& language);
void print_plan_modes(const std::string& file, bool by_jacobi, bool json);
/// Prints the summary, as JSON or as tables, unless `quiet`.
void run_plan(const std::string& file, bool json, bool quiet, const std::string& language);

}  // namespace bentur::cli
