#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bentur {

/// How the runs of a study are chosen. `grid` is every combination of all values.
struct Sampling {
  enum class Method { grid, latin_hypercube, sobol, random };

  Method method = Method::grid;
  std::size_t count = 0;  ///< of samples; not of a grid
  std::uint64_t seed = 1;
};

/// Points of the unit cube (0, 1)^d, one coordinate at a time and in any order: point i is the same whichever others
/// are asked for, on every machine.
///   random           each coordinate independent, from a hash of seed, axis and point;
///   latin_hypercube  each of the `count` slices of every axis holds one point (a keyed permutation of the slices),
///   which
///                    lies anywhere in its slice [McKayBeckmanConover1979];
///   sobol            Sobol's sequence with the direction numbers of Boost.Random, from its point 0 on, each axis
///                    shifted digit by digit by the seed; the first 2^m points are as even as the sequence makes them.
class UnitPoints {
 public:
  /// @throws InvalidParameter unless count > 0 and, for sobol, axes ≤ 3667.
  UnitPoints(const Sampling& sampling, std::size_t axes);

  /// Coordinate `axis` of point `index` < count.
  [[nodiscard]] double at(std::size_t index, std::size_t axis) const;

 private:
  [[nodiscard]] std::uint64_t permuted(std::uint64_t index, std::size_t axis) const;

  Sampling sampling_;
  std::vector<std::uint64_t> directions_;  // of sobol: 64 per axis
};

}  // namespace bentur
