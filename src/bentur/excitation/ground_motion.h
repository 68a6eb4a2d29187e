#pragma once

#include <array>
#include <optional>
#include <variant>
#include <vector>

namespace bentur {

/// No ground motion: free vibration.
struct NoMotion {};

/// Accelerations every `time_step`, the first at t = 0; linear between samples, zero before the first and after the
/// last.
struct SampledMotion {
  double time_step = 0;              ///< [s] > 0
  std::vector<double> acceleration;  ///< [length/s²]

  bool operator==(const SampledMotion&) const = default;
};

/// Harmonic ground acceleration for t ≥ 0, zero before: a_g = −A ω² sin ωt (displacement A sin ωt) or −A ω² cos ωt.
struct HarmonicMotion {
  enum class Phase { sine, cosine };
  double period = 0;                  ///< [s] > 0
  double displacement_amplitude = 0;  ///< A [length]; below 0 it is reversed
  Phase phase = Phase::sine;

  [[nodiscard]] bool is_reversed() const { return displacement_amplitude < 0; }
};

using GroundMotion = std::variant<NoMotion, SampledMotion, HarmonicMotion>;

/// The motion times −1.
[[nodiscard]] GroundMotion reversed(GroundMotion motion);

/// a_g(t) [length/s²], t in [s] since the motion's own start.
[[nodiscard]] double acceleration_at(const GroundMotion& motion, double t);

/// Largest |a_g| [length/s²].
[[nodiscard]] double peak_acceleration(const GroundMotion& motion);

/// Largest |w₁ a₁ + w₂ a₂| [length/s²] of two motions that begin together, w₁ and w₂ [-]; nothing where both move and
/// have no common course: one is sampled and the other harmonic, or their periods differ.
[[nodiscard]] std::optional<double> peak_acceleration(const std::array<GroundMotion, 2>& motions,
                                                      const std::array<double, 2>& weights);

/// Angular frequency ν [rad/s] of the motion between its samples: 0 for piecewise-linear ones.
[[nodiscard]] double angular_frequency(const GroundMotion& motion);

}  // namespace bentur
