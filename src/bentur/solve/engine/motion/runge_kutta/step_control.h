#pragma once

namespace bentur::engine {

/// Chooses the lengths of the steps of a pair of order 8 by the errors of the last two, h_{n+1} =
/// 0.9 h_n ε_n^{−1/8} (h_n/h_{n−1}) (ε_{n−1}/ε_n)^{1/8} (Gustafsson's predictive rule, [HairerWanner1996] IV.8): where
/// steps grow or shrink steadily, away from or towards a root-like force, it goes along with that.
class StepControl {
 public:
  /// Length for the next attempt, after one of length `h` with error/tolerance `error`; 1 and less is accepted.
  [[nodiscard]] double next(double h, double error);
  /// Forgets the last steps.
  void reset() { last_h_ = 0.0; }

 private:
  double last_h_ = 0;  ///< of the last step accepted [s]; 0: none
  double last_error_ = 1;
};

}  // namespace bentur::engine
