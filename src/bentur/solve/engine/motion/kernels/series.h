#pragma once

#include <Eigen/Core>
#include <span>

/// Inner loops of power series and Runge-Kutta steps; see rows.h.
namespace bentur::engine::kernels {

using Eigen::Index;

/// An element that presses with a linear force, as a power series over a step of h: F_k h² = stiffness δ_k +
/// (k + 1) damping δ_{k+1}, and `base` more for k = 0.
struct Pressing {
  Index left_begin, left_size, right_begin, right_size;
  const double *left_row, *right_row, *left_push, *right_push;
  double offset;                    ///< of δ [length]
  double base, stiffness, damping;  ///< times h², h², h
  double* deformation;              ///< δ_k, filled on the way: degree + 1 of them
};

/// Elements whose deformations act on one another: their force on `size` coordinates, from `begin` on, as a power
/// series over a step of h is F_k h² = h² matrix c_k, or, without that, h² push pullᵀ c_k of columns of as many
/// entries; `base` h² more for k = 0.
struct Tied {
  Index begin, size, count;
  const double *matrix, *pull, *push, *base;
  double h_squared;
};

/// A component of the ground acceleration of one body as a power series: a_{k+2} = −ν²h² a_k / ((k+2)(k+1)).
struct GroundSeries {
  Index begin = 0, size = 0;
  double even = 0, odd = 0;       ///< a_0 h², a_1 h²; then those last asked for
  double nu_squared = 0;          ///< ν² h²
  const double* gamma = nullptr;  ///< of further components: γ of all coordinates

  /// a_k h², to be asked for k = 0, 1, 2, …
  [[nodiscard]] double next(int k) {
    double& a = k % 2 == 0 ? even : odd;
    if (k >= 2) a *= -nu_squared / (k * (k - 1.0));
    return a;
  }
};

/// What (T-2) starts from for n coordinates: `stiff` = h²Ω², `damp` = h D, columns 0 and 1 of `c`.
struct Oscillators {
  const double *omega_squared, *two_sigma;
};
void begin_series(Index n, const Oscillators& of, const double* q, const double* v, double h, Index stride,
                  double* stiff, double* damp, double* c);

/// What coordinates are made of and driven by: h²Ω², h D, γ, and h² times a constant load (null: none); and beside the
/// first component of the ground's motion by further ones.
struct Driven {
  const double *stiff, *damp, *gamma, *load;
  std::span<GroundSeries> further = {};
};
/// (T-2) for the coordinates of `grounds`, one per body: columns 0 and 1 of `c` are given, 2 to `degree` are filled,
/// `stride` apart.
void expand(const Driven& of, std::span<GroundSeries> grounds, std::span<const Pressing> pressing,
            std::span<const Tied> tied, int degree, Index stride, double* c);

/// Where q, q̇ and q̈ of n coordinates at one instant are written; no q̈ where that is null.
struct Instant {
  double *q, *v, *acceleration;
};
/// At s of a step of h, of coordinates whose coefficients begin at `c`.
void evaluate(Index n, const double* c, Index stride, int degree, double s, double h, const Instant& to);

/// `chord` times a bound of the second derivatives of n polynomials on [0, end], Σ k(k−1)|c_k| end^{k−2}, and
/// `fourth_chord` times that of the fourth ones.
void bound(Index n, const double* c, Index stride, int degree, double end, double chord, double fourth_chord,
           double* second, double* fourth);

/// The same at s = 1, and how far q and q̈ leave their chords between 0 and 1 at most: a power s^k leaves its chord by
/// max x − x^k (T-5). Returns a sum that is finite only where all rises are.
double end_of_step(Index n, const double* c, Index stride, int degree, double h, const Instant& to, double* rise,
                   double* second_rise);

/// Position and `rate` times d²q/ds² of n coordinates at s = 0, end/count, 2 end/count, … end, `n` apart.
struct Places {
  int count;
  double end, rate;
};
void sample(Index n, const double* c, Index stride, int degree, const Places& places, double* q, double* second);

/// q̈ = γ a − Ω² q − D q̇ of n coordinates.
void accelerate(Index n, const double* omega_squared, const double* two_sigma, const double* gamma, double value,
                const double* q, const double* v, double* acceleration);

/// The polynomial row · c of a relation, summed as ModalSystem::Relation::along does: two rows of a size each, and the
/// coefficients of their coordinates. Four powers at a time: `degree` + 1 is a multiple of four.
struct RowOf {
  Index size;
  const double *row, *c;
};
void row_series(const RowOf& right, const RowOf& left, Index stride, int degree, double* polynomial);

// A polynomial p of s has zeros beyond its degree, up to a multiple of four coefficients.

/// Σ of what is positive in some derivative of p at s, and less Σ of what is negative. Both grow with s.
struct Split {
  double above = 0, below = 0;
};
/// p, p' and p'' at s.
struct Splits {
  double value = 0;
  Split slope, curvature;
};
[[nodiscard]] Splits splits(const double* p, int degree, double s);

/// p(end), how far p leaves the chord between 0 and `end` at most (T-5), and bounds of its second and third derivative.
struct Survey {
  double end = 0, rise = 0, second = 0, third = 0;
};
[[nodiscard]] Survey survey(const double* p, int degree, double end);

/// p and its first two derivatives at s.
struct Derivatives {
  double value = 0, slope = 0, curvature = 0;
};
[[nodiscard]] Derivatives derivatives(const double* p, int degree, double s);

/// A stage of a Runge-Kutta step of n coordinates from the slopes of `count` stages before it, `stride` apart:
///   q_at = q + after v + h² Σ positions_j slope_j,   v_at = v + h Σ speeds_j slope_j.
void stage(Index n, const double* slopes, Index stride, int count, const double* positions, const double* speeds,
           double after, double h, const double* q, const double* v, double* q_at, double* v_at);

/// A polynomial of `powers` coefficients from all stages: to_k = factors_k Σ_j weights_j,k slope_j, columns of `to`
/// being `stride` apart too; row j of the weights has `powers` entries.
inline constexpr int powers = 8;
void interpolate(Index n, const double* slopes, Index stride, int count, const double* weights, const double* factors,
                 double* to);

}  // namespace bentur::engine::kernels
