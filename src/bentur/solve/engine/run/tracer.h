#pragma once

#include <vector>

#include "bentur/solve/engine/motion/expansion.h"
#include "bentur/solve/engine/run/elements.h"
#include "bentur/solve/solution.h"

namespace bentur::engine {

/// Follows outputs, openings and contact forces by as few instants as a bound allows: straight lines between them
/// leave no such output and no opening by more than `course_bound` of its scale, and no contact force by more than
/// half of that of the contact's largest. Extrema of these outputs and openings, the largest force of each contact, and
/// whatever changes an element (a contact that begins or ends, a yield) are instants themselves; where a force jumps
/// there are two at one time. It reads solutions that are known anyway and never changes them.
class Tracer {
 public:
  static constexpr double course_bound = 1e-3;  ///< [-]

  /// @param offsets of all elements
  /// @param free response without contact, whose peaks are the scales of outputs; `openings`: that of each contact
  Tracer(const ModalSystem& system, const System& given, const std::vector<double>& offsets, const Solution& free,
         const std::vector<double>& openings);

  /// Takes in [0, end] of the expanded step that began at `time` with `inputs`.
  void take(const Expansion& motion, double time, double end, const std::vector<GroundInput>& inputs,
            const Elements& elements);
  /// Elements change at the end of what was taken in last.
  void changed();

  /// Puts the course into a solution, whose outputs have an entry for each.
  void finish(Solution& solution);

 private:
  /// Values at an instant: outputs that are followed, openings, forces, then what comes along without a bound.
  struct Instant {
    double s = 0;  ///< in the step
    double time = 0;
    Eigen::VectorXd values;
    Eigen::VectorXd speeds;  ///< of what is followed, and openings
    bool stays = false;
  };
  /// A step to be looked at.
  struct Step {
    const Expansion& motion;
    double time;
    const std::vector<GroundInput>& inputs;
    const Elements& elements;
  };
  [[nodiscard]] Instant at(const Step& step, double s);
  [[nodiscard]] double force(const Step& step, Eigen::Index point, double s);
  [[nodiscard]] double speed(const Step& step, Eigen::Index row, double s);
  void evaluate(const Step& step, double s);
  void halve(const Step& step, const Instant& from, const Instant& to, int depth, std::vector<Instant>& list);
  void find_extrema(const Step& step, std::vector<Instant>& list);
  /// Whether an instant lies so near the chord between two others that it is not needed.
  [[nodiscard]] bool is_on_chord(const Instant& from, const Instant& instant, const Instant& to) const;
  void take(const Instant& instant);
  void keep(const Instant& instant);

  const ModalSystem* system_;
  double duration_;
  std::vector<double> offsets_;
  Eigen::Index followed_ = 0, points_ = 0;
  Eigen::Index others_ = 0;     ///< values of an instant that come along without a bound
  Eigen::VectorXd scales_;      ///< of what is followed, and openings [length]
  Eigen::VectorXd forces_met_;  ///< largest force of each contact so far [force]; 0 where there is none
  double bound_ = course_bound;
  double room_;  ///< numbers that may be kept before the bound grows
  std::vector<Instant> waiting_;
  Instant kept_;  ///< the last one
  bool has_begun_ = false;
  double latest_ = 0;  ///< [s]
  std::vector<double> times_;
  std::vector<double> numbers_;
  State state_;
  std::vector<GroundInput> inputs_;
  Eigen::VectorXd forces_;
};

}  // namespace bentur::engine
