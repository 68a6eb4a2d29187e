#include "bentur/pounding/internal/asked.h"

namespace bentur {

RunOptions run_options(const SolveOptions& options) {
  return {.output_step = options.output_step,
          .course = options.course,
          .limits = options.limits,
          .energy_audit = options.energy_audit,
          .energy_step = options.energy_step,
          .progress = options.progress};
}

GroundMotion reversed(GroundMotion motion) {
  if (auto* sampled = std::get_if<SampledMotion>(&motion)) {
    for (double& value : sampled->acceleration) value = -value;
  }
  if (auto* harmonic = std::get_if<HarmonicMotion>(&motion)) harmonic->displacement_amplitude *= -1;
  return motion;
}

}  // namespace bentur
