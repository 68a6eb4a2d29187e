#pragma once

#include <string>
#include <vector>

#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/report/kinds/kinds.h"

namespace bentur {

/// Given against needed gaps, as recorded and reversed, each at the level where it falls short the most: of one gap
/// bars with their values, of many of those that the verdict names first. @param c the case of the run
[[nodiscard]] Panel gap_panel(const std::vector<JudgedGap>& judged, const Case& c, const FigureOptions& options);

/// Has rules of a panel over time named where they end, in place of a legend: those across beside the frame, an upright
/// one in room that is made above all curves. @param panel whose height is what it stays
void name_rules_at_ends(Panel& panel);

}  // namespace bentur
