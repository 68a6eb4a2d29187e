#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace bentur {

/// A function of places u in [0, 1]ⁿ [-].
using PlaceFunction = std::function<double(const std::vector<double>&)>;

/// What is to become small, and what must not exceed zero meanwhile; neither has derivatives.
struct Minimisation {
  PlaceFunction objective;
  PlaceFunction constraint = {};  ///< empty: none
  std::vector<double> start;      ///< n of them
  std::size_t evaluations = 0;    ///< at most, from here on
};

/// Whether this build has NLopt. Without it the functions below throw std::logic_error.
[[nodiscard]] bool has_optimiser();

/// All over [0, 1]ⁿ: DIRECT in its locally biased form [Gablonsky2001]. `start` and `constraint` are not used.
void search_everywhere(const Minimisation& what);
/// From `start`: COBYLA [Powell1994], until steps are below 10⁻⁴.
void search_nearby(const Minimisation& what);
// The same calls give the same places in the same order. What the functions throw ends the search and is thrown on.

}  // namespace bentur
