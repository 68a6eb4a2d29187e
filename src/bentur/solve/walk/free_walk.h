#pragma once

#include <vector>

#include "bentur/solve/walk/openings.h"
#include "bentur/solve/walk/walk.h"

namespace bentur::engine {

/// Contact switched off: peak displacements and the gap that would have been needed.
class FreeWalk final : public Walk {
 public:
  explicit FreeWalk(const Ground& ground);

  /// Per point, max(0, x_left − x_right) [length].
  [[nodiscard]] const std::vector<double>& needed() const { return needed_; }

 private:
  [[nodiscard]] const ContactForces& forces() const override { return none_; }
  [[nodiscard]] long changes() const override { return 0; }
  [[nodiscard]] const ForceFunction& force_at() const override { return no_force_; }
  [[nodiscard]] bool may_fly() const override { return true; }
  bool quiet(const Flights& flights, std::size_t halvings, const Flight::Bounds& bounds) override;
  double look(double time) override;
  void settle() override;
  void raise(const State& from, const State& to);

  /// A flight in which a gap may have been exceeded.
  struct Unsettled {
    double length;  ///< [s]
    State start;
    std::vector<GroundInput> inputs;
    std::vector<double> reach;  ///< per point
  };

  const ContactForces none_;
  const ForceFunction no_force_;
  Openings openings_;
  std::vector<double> needed_;
  std::vector<double> reach_;
  std::vector<Unsettled> unsettled_;
};

}  // namespace bentur::engine
