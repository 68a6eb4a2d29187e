#pragma once

#include <string>
#include <vector>

#include "bentur/model/gap/code_rules.h"
#include "bentur/report/story_text.h"

// What a terminal shows of gaps, of rows and of buildings in plan.
namespace bentur::cli {

/// Statements, the tables of every gap, remarks. @param gaps their names
[[nodiscard]] std::string tables_text(const std::vector<std::string>& gaps, const Story& story, const Words& say);

/// What a user may want to know of the rules: those not shown and why, and what the numbers are worth.
[[nodiscard]] std::string codes_note(const CodeSpec& code, const Words& say);

/// All of these. @param notes what the numbers mean, a paragraph each @param details tables of what they come from
[[nodiscard]] std::string all_gaps_text(const std::vector<std::string>& gaps, const CodeSpec& code, const Story& story,
                                        const std::vector<std::string>& notes, const Words& say,
                                        const std::string& details = {});

}  // namespace bentur::cli
