#pragma once

#include <Eigen/Core>
#include <vector>

#include "bentur/solve/engine/tangent/tangent_run.h"

namespace bentur::engine {

/// Finds when rows of coordinates have the peaks that a run is known to have.
class PeakPlaces {
 public:
  struct Sought {
    Eigen::VectorXd row;                        ///< over all coordinates
    double offset = 0;                          ///< that is added to it
    bool of_size = true;                        ///< |row q + offset|; else itself
    double peak = 0;                            ///< that is known
    std::vector<Dependence::OfRow> moved = {};  ///< how the row itself changes, of numbers that move it
  };
  struct Place {
    double time = -1, value = 0;  ///< negative time: not found
    bool is_equalled = false;
  };
  /// @param thorough looks into all stretches, not only where the ends say that a peak may be
  PeakPlaces(const TangentRun::Setup& setup, const std::vector<Sought>& sought, bool thorough);

  /// Takes in a stretch of a run, and its end.
  void take(const TangentRun::Stretch& stretch, const TangentState& to);
  /// Takes in where speeds have jumped.
  void take_event(double time, const TangentState& before, const TangentState& after);
  /// Takes in an end of the run.
  void take_end(double time, const TangentState& state);
  [[nodiscard]] const std::vector<Place>& places() const { return places_; }
  /// Whether all have been found.
  [[nodiscard]] bool all() const;

 private:
  void note(Eigen::Index i, double time, double value);
  void look_into(const TangentRun::Stretch& stretch);

  const TangentRun::Setup setup_;
  const std::vector<Sought>* sought_;
  bool thorough_;
  Eigen::MatrixXd rows_;
  Eigen::VectorXd from_, to_, from_rate_, to_rate_;
  std::vector<Eigen::Index> open_;  ///< that a stretch may hold
  std::vector<Place> places_;
  TangentStep step_;
};

}  // namespace bentur::engine
