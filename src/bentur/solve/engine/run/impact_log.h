#pragma once

#include <vector>

#include "bentur/contact/law.h"
#include "bentur/elements/coupled_law.h"
#include "bentur/solve/engine/motion/polynomial.h"
#include "bentur/solve/solution.h"

namespace bentur::engine {

/// Writes the list of impacts: one entry from touching to parting.
class ImpactLog {
 public:
  explicit ImpactLog(std::size_t points);

  /// `stored` energy is in the contact as it begins. What its surface has kept since the impact before, of a dent that
  /// is still there, that one has not lost.
  void begin(Eigen::Index point, double start, double closing_speed, double stored = 0.0);
  [[nodiscard]] Impact& under_way(Eigen::Index point) { return under_way_[point]; }
  void end(Eigen::Index point, double time, double separation_speed);

  /// A stretch of the expanded step over which a point was in contact.
  struct Stretch {
    const Law& law;
    const LawState& state;
    const Polynomial& penetration;  ///< δ(s) [length]
    double h = 0;                   ///< of the step [s]
    double time = 0;                ///< its start [s]
    double end = 1;                 ///< s where the stretch ends
    double force_band = 0;          ///< pulls up to this are round-off [force]
  };
  void accumulate(Eigen::Index point, const Stretch& stretch);

  /// What rubs along the bodies over a stretch: forces by a branch whose second deformation is the slip.
  struct Along {
    const CoupledBranch& branch;
    int slides = 0;               ///< κ; 0: it sticks
    const Polynomial& slip;       ///< s [length]
    double tangential_stiffness;  ///< k_t [force/length]
  };
  /// Adds it to what accumulate() has. The force along at its end [force].
  double rub(Eigen::Index point, const Stretch& stretch, const Along& along);

  /// Adds a stretch of resting contact under the force λ(s).
  void rest(Eigen::Index point, const Polynomial& force, double h, double time, double end);

  /// Impacts still under way count, up to `time`; then sorts by start and point.
  void finish(const std::vector<Branch>& branches, double time);
  [[nodiscard]] std::vector<Impact>& impacts() { return impacts_; }

 private:
  std::vector<Impact> under_way_;  ///< per point, meaningful while it touches
  std::vector<Impact> impacts_;
  static constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> before_;  ///< per point, its last one in impacts_, until they are sorted
};

}  // namespace bentur::engine
