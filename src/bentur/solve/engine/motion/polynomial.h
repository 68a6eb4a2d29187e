#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>

namespace bentur::engine {

/// Highest degree of a power series: with ω h ≤ series_reach the first term left out is below 2.6^28/28! = 2e-18 of the
/// value.
inline constexpr int highest_degree = 27;

/// Σ p_k s^k, k ≤ degree, on s ∈ [0, 1] (s = time since the start of the step over its length).
/// Coefficients beyond the degree are zero.
struct Polynomial {
  std::array<double, highest_degree + 1> coefficients{};
  int degree = highest_degree;

  Polynomial() = default;
  Polynomial(std::initializer_list<double> values);  ///< at most highest_degree + 1 of them

  [[nodiscard]] double operator[](int k) const { return coefficients[k]; }
  [[nodiscard]] double& operator[](int k) { return coefficients[k]; }
};

[[nodiscard]] double value(const Polynomial& p, double s);
[[nodiscard]] double first_derivative(const Polynomial& p, double s);
/// p'' times `rate`.
[[nodiscard]] Polynomial second_derivative(const Polynomial& p, double rate);
/// ∫ p ds from 0 to `end`.
[[nodiscard]] double integral(const Polynomial& p, double end);

/// A root of p between a and b, where p must differ in sign.
[[nodiscard]] double root(const Polynomial& p, double a, double b);

/// The first s in [0, 1] where factor · p + offset becomes negative, or nothing when it is ≥ 0 on all of [0, 1].
///
/// The answer is proven (docs/theory/exact-solver.md, Events): by steps that cannot pass a crossing (T-6), and where
/// these get short by halves, until bounds of p'' exclude a negative value in between, or p or p' is monotone, which
/// settles it with one bracketed root. So the only limit is round-off of p itself, about degree · 1e-16 · Σ|p_k|; a
/// touch from above (p = 0, not negative) is no crossing.
[[nodiscard]] std::optional<double> first_negative(const Polynomial& p, double factor = 1.0, double offset = 0.0);

/// The last place in [0, end] where p, if it is positive at `end`, was zero; nothing where it is never zero or less but
/// at the start. `end` where it is not positive there.
[[nodiscard]] std::optional<double> last_zero(const Polynomial& p, double end);

/// Raises `best` to the maximum of factor · p on [0, end] where that is larger, and sets `where` to its place; returns
/// whether it did. The maximum is that of the continuous function: a root of p', found by the same proof.
bool raise_to_maximum(const Polynomial& p, double end, double& best, double& where, double factor = 1.0);

/// The same for |p|.
void raise_to_largest(const Polynomial& p, double end, double& best);

}  // namespace bentur::engine
