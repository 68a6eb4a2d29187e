// Peaks between the places at which a step is sampled: a bound says whether one can be there, and must never say no
// where one is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "bentur/pounding/assemble.h"
#include "bentur/solve/engine/run/watch/peak_watch.h"
#include "tests/support/small_buildings.h"

namespace bentur::engine {
namespace {

constexpr Eigen::Index padded_size = 4;  // of a building with one mode and its ground

/// One floor of mass 1 on a spring of 1, so that displacement, drift and shear are the same number.
const ModalSystem& one_floor() {
  static const Problem problem = test::pair(test::oscillator(1, 1), test::oscillator(1, 1), {test::contact(1, 1)}, 1);
  static const ModalSystem system(system_of(problem));
  return system;
}

/// The floor's displacement over a step of `h`, of which [0, end] is looked at.
class Step {
 public:
  Step(std::vector<double> powers, double h, double end) : powers_(std::move(powers)), h_(h), end_(end) {
    c_.assign(powers_.size() * padded_size, 0.0);
    for (std::size_t k = 0; k < powers_.size(); ++k) c_[k * padded_size] = powers_[k];
  }
  [[nodiscard]] Curves curves() const {
    return {c_.data(), padded_size, static_cast<int>(powers_.size()) - 1, h_, end_};
  }
  [[nodiscard]] double value(double s) const {
    double sum = 0;
    for (std::size_t k = powers_.size(); k-- > 0;) sum = sum * s + powers_[k];
    return sum;
  }
  [[nodiscard]] double acceleration(double s) const {
    double sum = 0;
    for (std::size_t k = powers_.size(); k-- > 2;) {
      sum = sum * s + static_cast<double>(k * (k - 1)) * powers_[k];
    }
    return sum / (h_ * h_);
  }
  [[nodiscard]] double end() const { return end_; }

 private:
  std::vector<double> powers_, c_;
  double h_, end_;
};

struct Looked {
  bool settled = false;
  double displacement = 0, acceleration = 0;              ///< as far as bounds let them reach
  double found_displacement = 0, found_acceleration = 0;  ///< by a search of what was left open
};

Looked look(const Step& step, int parts) {
  PeakWatch watch(one_floor());
  std::vector<double> reach(static_cast<std::size_t>(watch.quantities(0)));
  Looked result;
  result.settled = watch.settled_by_samples(0, step.curves(), parts, watch.unknown(), reach.data());
  result.displacement = reach[0];
  result.acceleration = reach[reach.size() / 2];
  watch.scan(0, step.curves(), reach.data());
  std::vector<OutputsFound> found(one_floor().blocks[0].outputs.size());
  watch.report(0, found);
  const auto peak = [&](OutputKind kind) { return found[static_cast<std::size_t>(kind)].peak(0); };
  result.found_displacement = peak(OutputKind::displacement);
  result.found_acceleration = peak(OutputKind::acceleration);
  return result;
}

// 1 − (s − a)² with a midway between two samples: there it is exactly as far above the chord as the bound says.
TEST(PeakBounds, AreReachedByAParabolaBetweenSamples) {
  for (const double end : {1.0, 0.4}) {
    const double a = 5.0 / 16 * end;
    const Looked looked = look(Step({1 - a * a, 2 * a, -1}, 0.3, end), 8);
    EXPECT_FALSE(looked.settled);
    EXPECT_NEAR(looked.displacement, 1, 1e-15);
    EXPECT_NEAR(looked.found_displacement, 1, 1e-15);
  }
}

// c (s − a)⁴ − (s − a)²: so is its second derivative, −2 + 12 c (s − a)².
TEST(PeakBounds, AreReachedByTheAccelerationOfAQuartic) {
  const double h = 0.3, a = 5.0 / 16, c = 0.1;
  const std::vector<double> powers = {c * std::pow(a, 4) - a * a, 2 * a - 4 * c * std::pow(a, 3), 6 * c * a * a - 1,
                                      -4 * c * a, c};
  const Looked looked = look(Step(powers, h, 1), 8);
  EXPECT_FALSE(looked.settled);
  EXPECT_NEAR(looked.acceleration * h * h, 2, 1e-14);
  EXPECT_NEAR(looked.found_acceleration * h * h, 2, 1e-14);
}

TEST(PeakBounds, HoldForRandomPolynomials) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int n = 0; n < 2000; ++n) {
    std::vector<double> powers(static_cast<std::size_t>(3 + n % 9));
    double size = 1;
    for (double& c : powers) c = number(random) * (size *= 0.9);
    const Step step(powers, 0.1 + 0.4 * std::abs(number(random)), n % 3 == 0 ? 0.7 : 1);
    double displacement = 0, acceleration = 0;
    for (int i = 0; i <= 400; ++i) {
      const double s = step.end() * i / 400;
      displacement = std::max(displacement, std::abs(step.value(s)));
      acceleration = std::max(acceleration, std::abs(step.acceleration(s)));
    }
    const Looked looked = look(step, 1 + n % PeakWatch::most_parts);
    const double round_off = 1e-14;
    EXPECT_GE(looked.found_displacement, displacement * (1 - round_off)) << n;
    EXPECT_GE(looked.found_acceleration, acceleration * (1 - round_off)) << n;
  }
}

}  // namespace
}  // namespace bentur::engine
