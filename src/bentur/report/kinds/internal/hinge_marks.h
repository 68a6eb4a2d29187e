#pragma once

#include <optional>
#include <string>

#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/scene/scene.h"

namespace bentur {

/// "bottom of the column of line 2, storey 1".
[[nodiscard]] std::string hinge_name(const FigureWords& say, const HingePlace& place);
/// What the mark of a level means: "yields", "beyond IO", "over 3.1 mrad, 1/4 of the largest rotation".
[[nodiscard]] std::string hinge_level_text(const FigureWords& say, const HingeBounds& bounds, int level);

/// Which marks of hinges and broken columns, and how large.
struct HingeMarks {
  double time = 0;                      ///< what they have come to by then [s]
  double storey = 0;                    ///< height of the lowest storey on paper [cm]
  std::optional<Eigen::Index> of = {};  ///< one building's alone
  bool with_those_at_rest = false;      ///< also those that have not yielded
  bool numbered = false;                ///< by the order in which they form
};
void add_hinge_marks(Panel& panel, const RunResults& run, const Scene& scene, const ScenePlaces& places,
                     const HingeMarks& wanted, const FigureOptions& options);

}  // namespace bentur
