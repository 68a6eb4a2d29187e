#pragma once

#include "bentur/report/kinds/kinds.h"
#include "bentur/study/remedy/remedy.h"

namespace bentur {

/// What a remedy gives for its size: every choice that was tried, the least objective of those that are no larger, the
/// limit. Where one number alone is chosen, the objective over that number.
/// @throws NoFigure where no choice has a number.
[[nodiscard]] Figure remedy_figure(const RemedySearch& search, const FigureOptions& options = {});

}  // namespace bentur
