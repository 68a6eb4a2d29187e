#include "bench/arithmetic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <variant>

#include "bench/peers/equations.h"
#include "bench/timing.h"

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#endif

namespace bentur::bench {
namespace {

constexpr long rounds = 2'000'000;
constexpr std::size_t chains = 12;  // independent of one another, to fill the pipelines

/// Rate of `work`, which does `flops` operations a round.
template <class Work>
double rate_of(Work work, double flops) {
  return flops * static_cast<double>(rounds) / time_of(work, 0.05).minimum;
}

volatile double sink = 0;  // so that nothing is left out

#if defined(__x86_64__) && defined(__GNUC__)
void with_sse2() {
  __m128d sums[chains];
  for (__m128d& sum : sums) sum = _mm_setzero_pd();
  const __m128d factor = _mm_set1_pd(0.999), term = _mm_set1_pd(1e-3);
  for (long i = 0; i < rounds; ++i) {
#pragma GCC unroll 12
    for (std::size_t k = 0; k < chains; ++k) sums[k] = _mm_add_pd(_mm_mul_pd(sums[k], factor), term);
  }
  for (const __m128d& sum : sums) sink = sink + _mm_cvtsd_f64(sum);
}

__attribute__((target("avx2,fma"))) void with_fma() {
  __m256d sums[chains];
  for (__m256d& sum : sums) sum = _mm256_setzero_pd();
  const __m256d factor = _mm256_set1_pd(0.999), term = _mm256_set1_pd(1e-3);
  for (long i = 0; i < rounds; ++i) {
#pragma GCC unroll 12
    for (std::size_t k = 0; k < chains; ++k) sums[k] = _mm256_fmadd_pd(sums[k], factor, term);
  }
  for (const __m256d& sum : sums) sink = sink + _mm256_cvtsd_f64(sum);
}
#else
void with_scalars() {
  std::array<double, chains> sums{};
  for (long i = 0; i < rounds; ++i) {
    for (double& sum : sums) sum = sum * 0.999 + 1e-3;
  }
  for (const double sum : sums) sink = sink + sum;
}
#endif

}  // namespace

std::vector<std::pair<std::string, double>> arithmetic_rates() {
  constexpr double operations = 2 * chains;  // a product and a sum each
#if defined(__x86_64__) && defined(__GNUC__)
  std::vector<std::pair<std::string, double>> rates{{"SSE2", rate_of(with_sse2, 2 * operations)}};
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    rates.emplace_back("AVX2 with FMA", rate_of(with_fma, 4 * operations));
  }
  return rates;
#else
  return {{"as compiled", rate_of(with_scalars, operations)}};
#endif
}

Arithmetic arithmetic_of(const Problem& problem, const Response& response) {
  Arithmetic count;
  const long common = std::ssize(Equations(problem, 1.0).breakpoints()) - 1;
  count.free_steps = std::lround(problem.duration / std::get<SampledMotion>(problem.motion).time_step);
  count.contact_steps = std::max(0L, response.steps - common);
  double modes = 0, peaks = 0, points = 0;
  for (const Building& building : problem.buildings) {
    const auto of_building = static_cast<double>(building.modes.omega.size());
    modes += of_building;
    peaks += 16 * static_cast<double>(building.model.floors()) * of_building;
  }
  for (const ContactPoint& point : problem.points) {
    const Eigen::Index left = point.left;
    points += static_cast<double>(problem.buildings[left].modes.omega.size() +
                                  problem.buildings[left + 1].modes.omega.size());
  }
  const double closed = points / static_cast<double>(problem.points.size());  // modes at one point
  constexpr double terms = 26;
  const auto free_steps = static_cast<double>(count.free_steps), steps = static_cast<double>(count.contact_steps);
  count.free_flops = free_steps * (24 * modes + peaks);
  count.contact_flops = static_cast<double>(common) * (24 * modes + peaks + 4 * points) +
                        steps * (terms * (8 * modes + 4 * closed) + 2 * (terms + 1) * points);
  return count;
}

}  // namespace bentur::bench
