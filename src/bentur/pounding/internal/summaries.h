#pragma once

#include <functional>
#include <span>
#include <vector>

#include "bentur/elements/coupled_law.h"
#include "bentur/pounding/plan/free_touches.h"
#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"
#include "bentur/solve/solver.h"

namespace bentur {

// What free_response_of.h asks of rows.
[[nodiscard]] inline std::span<GroundMotion> motions_in(Problem& problem) { return {&problem.motion, 1}; }
/// Of the points of the system: they are those of the problem.
[[nodiscard]] inline std::vector<Eigen::Index> places_of(const Problem& /*problem*/) { return {}; }
[[nodiscard]] inline bool keeps_course(const Problem& /*problem*/) { return true; }
/// Floors in a row touch whatever they do elsewhere.
[[nodiscard]] inline bool has_meetings(const Problem& /*problem*/) { return false; }
inline void take_meetings(const Problem&, FreeTouches&, const std::function<FreeTouches&()>&,
                          std::vector<PointSummary>&) {}

/// What the response without contact says of buildings, points and watched floors.
[[nodiscard]] Response free_response(const Problem& problem, const Solution& free);
/// What rules for gaps combine. @param reversed whether the reversed motion gives the response times −1
void take_levels(const Problem& problem, const Solution& free, bool reversed, Response& response);

/// Puts what storey `storey` of so many has lost of its strength among what yielding did.
void take_loss(const StrengthLoss& loss, Eigen::Index storeys, Eigen::Index storey, BuildingPeaks::Yielding& yielding);

/// Ductility demand of a storey [-]: the larger of its drifts to either side over the yield drift of that side.
/// @param drift max |Δ| [length]
[[nodiscard]] double ductility(const HystereticLaw& law, double drift, const ElementFound& found);

/// Peaks of the hinges of a frame and of its columns that can break: moments [force·length], rotations [rad] (empty
/// where the hinges' law knows them all), shears [force].
void take_hinge_peaks(const Hinges& hinges, const Eigen::VectorXd& moments, const Eigen::VectorXd& rotations,
                      const Eigen::VectorXd& shears, BuildingPeaks& peaks);
/// The rest of it, by the state of their law at the end, with residual drifts and the mechanism. @param storey_heights
/// of the building that the frame is of, a slab's 0 [length]
void take_hinges(const Hinges& hinges, const std::vector<double>& storey_heights, const CoupledLaw& law,
                 const CoupledState& state, BuildingPeaks& peaks);

/// A frame whose bays have infill. @param storey_heights of the building that it is of, a slab's 0 [length]
struct InfilledFrame {
  const std::vector<InfillPanel>& panels;
  const Hinges& hinges;
  Eigen::Index first_storey = 0;
  const std::vector<double>& storey_heights;
};

/// What infill did. @param panels what the element of each did; null: it stays elastic @param across max |F| of each
/// @param on_columns max |Q + F| of struts_on_columns() [force] @param drift_ratios of the storeys [-]
[[nodiscard]] BuildingPeaks::Infill infill_of(const InfilledFrame& frame,
                                              const std::vector<const ElementFound*>& panels,
                                              const Eigen::VectorXd& across, const Eigen::VectorXd& on_columns,
                                              const Eigen::VectorXd& drift_ratios);

/// Samples of the struts at work, as Histories has them, panels × samples, of those of F and of drift ratios.
struct InfillHistories {
  Eigen::MatrixXd force, shortening;
};
[[nodiscard]] InfillHistories infill_histories(const InfilledFrame& frame, Eigen::MatrixXd across,
                                               const Eigen::MatrixXd& drift_ratios);

/// What a struck column carried, of the six forces at the ends of its pieces with contact and without.
[[nodiscard]] ColumnPeaks column_peaks(const Eigen::Vector<double, 6>& with, const Eigen::Vector<double, 6>& without);

/// How a solution ended, and what its links did.
void take_end(const Solution& solution, RunOutcome& outcome);

/// Adds impacts to the totals of their points.
void summarise(const std::vector<Impact>& impacts, std::vector<PointSummary>& points);

/// How near watched floors came. @param widths what they are apart at rest [length], one each
void summarise(const Solution& solution, const std::vector<double>& widths, std::vector<WatchedSummary>& watched);

/// Puts a solution with contact into the response that free_response() made.
void take_solution(const Problem& problem, Solution&& solution, Response& response);

}  // namespace bentur
