#include "bentur/study/design/sampling.h"

#include <bit>
#include <boost/random/sobol.hpp>
#include <string>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

constexpr std::size_t most_sobol_axes = 3667;  // of Boost's table
constexpr std::size_t direction_bits = 40;     // 2^40 points, more than can be run

/// Mixes all bits of x (the finaliser of SplitMix64 [SteeleLeaFlood2014]).
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31);
}

std::uint64_t hash(std::uint64_t seed, std::uint64_t a, std::uint64_t b) { return mixed(mixed(mixed(seed) ^ a) ^ b); }

/// In (0, 1): the middle of one of 2^53 slices, so neither end is ever met.
double unit(std::uint64_t bits) { return (static_cast<double>(bits >> 11) + 0.5) * 0x1p-53; }

/// Direction number k of every axis: the point whose Gray code has bit k alone, 2^(k+1) − 1. Boost begins with point 1.
std::vector<std::uint64_t> sobol_directions(std::size_t axes) {
  std::vector<std::uint64_t> directions(axes * direction_bits);
  boost::random::sobol engine(axes);
  for (std::size_t k = 0; k < direction_bits; ++k) {
    engine.seed();
    engine.discard(((std::uint64_t{2} << k) - 2) * axes);
    for (std::size_t axis = 0; axis < axes; ++axis) directions[axis * direction_bits + k] = engine();
  }
  return directions;
}

}  // namespace

UnitPoints::UnitPoints(const Sampling& sampling, std::size_t axes) : sampling_(sampling) {
  if (sampling.count == 0) throw InvalidParameter("count", "0", "must be > 0");
  if (sampling.method == Sampling::Method::sobol) {
    if (axes > most_sobol_axes) throw InvalidParameter("axes", std::to_string(axes), "must be at most 3667 for sobol");
    directions_ = sobol_directions(axes);
  }
}

std::uint64_t UnitPoints::permuted(std::uint64_t index, std::size_t axis) const {
  // A Feistel network permutes the numbers of 2·half bits; walking on until a number below count comes leaves a
  // permutation of those.
  constexpr int rounds = 6;
  const auto half = static_cast<unsigned>(std::bit_width(sampling_.count - 1) + 1) / 2;
  if (half == 0) return 0;
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  do {
    std::uint64_t left = index >> half;
    std::uint64_t right = index & mask;
    for (std::uint64_t round = 1; round <= rounds; ++round) {
      const std::uint64_t next = left ^ (hash(sampling_.seed + (round << 32), axis, right) & mask);
      left = right;
      right = next;
    }
    index = (left << half) | right;
  } while (index >= sampling_.count);
  return index;
}

double UnitPoints::at(std::size_t index, std::size_t axis) const {
  switch (sampling_.method) {
    case Sampling::Method::latin_hypercube: {
      const double within = unit(hash(sampling_.seed, axis, index));
      const double u = (static_cast<double>(permuted(index, axis)) + within) / static_cast<double>(sampling_.count);
      return u < 1 ? u : 1 - 0x1p-53;  // rounding must not reach the end
    }
    case Sampling::Method::sobol: {
      std::uint64_t bits = hash(sampling_.seed, axis, 0);
      const std::uint64_t gray = index ^ (index >> 1);
      for (std::size_t k = 0; k < direction_bits; ++k) {
        if (((gray >> k) & 1) != 0) bits ^= directions_[axis * direction_bits + k];
      }
      return unit(bits);
    }
    case Sampling::Method::random:
    case Sampling::Method::grid:
      break;
  }
  return unit(hash(sampling_.seed, axis, index));
}

}  // namespace bentur
