#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstring>

#include "bentur/solve/engine/motion/kernels/power_factors.h"

// clang++ inlines no vectors of four into a function for another processor: there is one version of each, for all.
#if defined(__x86_64__) && defined(__linux__) && !defined(__clang__)
#define BENTUR_FOR_ALL_PROCESSORS __attribute__((target_clones("avx2", "default")))
#else
#define BENTUR_FOR_ALL_PROCESSORS
#endif
#define BENTUR_INLINE __attribute__((always_inline)) inline

/// Vectors of four numbers, for the kernels alone.
namespace bentur::engine::kernels {

using Eigen::Index;

constexpr Index four = 4;

/// Four numbers that a processor adds and multiplies at once; the compiler makes it so, or does with less.
using Four = double __attribute__((vector_size(32)));
using Bits = long long __attribute__((vector_size(32)));

BENTUR_INLINE Four load(const double* from) {
  Four x;
  std::memcpy(&x, from, sizeof x);
  return x;
}
BENTUR_INLINE void store(double* to, Four x) { std::memcpy(to, &x, sizeof x); }
BENTUR_INLINE Four all(double x) { return Four{x, x, x, x}; }
BENTUR_INLINE Four abs(Four x) {
  constexpr long long mask = 0x7fffffffffffffff;
  return reinterpret_cast<Four>(reinterpret_cast<Bits>(x) & Bits{mask, mask, mask, mask});
}
BENTUR_INLINE Four max(Four a, Four b) { return a > b ? a : b; }
BENTUR_INLINE Four root(Four x) { return Four{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])}; }
BENTUR_INLINE double sum(Four x) { return (x[0] + x[1]) + (x[2] + x[3]); }
BENTUR_INLINE Four product(Index n, const double* a, const double* b) {
  Four total = all(0.0);
  for (Index j = 0; j < n; j += four) total += load(a + j) * load(b + j);
  return total;
}

/// sum() of four at once.
BENTUR_INLINE Four sums_of(Four a, Four b, Four c, Four d) {
  // a0 + a1, b0 + b1, a2 + a3, b2 + b3
  const Four ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

/// sum(a) + sum(b).
BENTUR_INLINE double sum_of_both(Four a, Four b) {
  // a0 + a1, b0 + b1, a2 + a3, b2 + b3
  const Four pairs = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  return (pairs[0] + pairs[2]) + (pairs[1] + pairs[3]);
}

/// The largest entry of each of four.
BENTUR_INLINE Four largest_of(Four a, Four b, Four c, Four d) {
  const Four ab = max(__builtin_shufflevector(a, b, 0, 4, 2, 6), __builtin_shufflevector(a, b, 1, 5, 3, 7));
  const Four cd = max(__builtin_shufflevector(c, d, 0, 4, 2, 6), __builtin_shufflevector(c, d, 1, 5, 3, 7));
  return max(__builtin_shufflevector(ab, cd, 0, 1, 4, 5), __builtin_shufflevector(ab, cd, 2, 3, 6, 7));
}

BENTUR_INLINE Four factor(const std::array<double, PowerFactors::powers>& list, int k) { return all(list[k]); }

BENTUR_INLINE bool any(Bits x) { return (x[0] | x[1] | x[2] | x[3]) != 0; }
BENTUR_INLINE bool every(Bits x) { return (x[0] & x[1] & x[2] & x[3]) != 0; }

}  // namespace bentur::engine::kernels
