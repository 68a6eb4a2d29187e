#pragma once

#include <cstddef>
#include <functional>
#include <optional>
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

/// The largest difference of one coordinate of two places.
[[nodiscard]] double farthest(const std::vector<double>& a, const std::vector<double>& b);

/// A part of a function that is the largest of several, at a place: its value there and its slopes.
struct FunctionPart {
  double value = 0;           ///< [the function's unit]
  std::vector<double> slope;  ///< ∂value/∂u, n of them
};
/// Those parts of a function that are known at a place, the largest of which is the function; empty: none is known.
using FunctionParts = std::function<std::vector<FunctionPart>(const std::vector<double>&)>;

/// In place of the least of a function the place nearest to `home` where it does not exceed a limit.
struct Nearest {
  std::vector<double> home;
  double limit = 0;  ///< [the function's unit] > 0
};

/// What is to become small with the help of slopes.
struct Descent {
  PlaceFunction function;  ///< > 0
  FunctionParts parts;
  std::vector<double> start;
  std::size_t evaluations = 0;  ///< at most, from here on
  std::optional<Nearest> nearest = {};
};

/// Whether this build has NLopt. Without it the functions below throw std::logic_error.
[[nodiscard]] bool has_optimiser();

/// All over [0, 1]ⁿ: DIRECT in its locally biased form [Gablonsky2001]. `start` and `constraint` are not used.
void search_everywhere(const Minimisation& what);
/// From `start`: COBYLA [Powell1994], until steps are below 10⁻⁴.
void search_nearby(const Minimisation& what);
/// From `start`: a bundle of the parts seen so far, within a box that grows and shrinks as they foretell the function
/// well or badly, until it is smaller than 10⁻⁴. @return false, and nothing is tried, where no parts are known at
/// `start`
bool search_by_slopes(const Descent& what);
// The same calls give the same places in the same order. What the functions throw ends the search and is thrown on.

}  // namespace bentur
