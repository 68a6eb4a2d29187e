#pragma once

#include "bentur/report/kinds/kinds.h"
#include "bentur/study/sensitivity/sensitivity.h"

namespace bentur {

/// By how much the gap needed and the peak force change for 1 % more of the numbers that they change most with, for
/// each gap; of several gaps the three that change most. @throws NoFigure where no derivative of a gap is known.
[[nodiscard]] Figure sensitivity_figure(const Sensitivity& found, const FigureOptions& options = {});

}  // namespace bentur
