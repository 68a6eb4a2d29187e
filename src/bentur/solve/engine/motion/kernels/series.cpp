#include "bentur/solve/engine/motion/kernels/series.h"

#include "bentur/solve/engine/motion/kernels/four.h"

namespace bentur::engine::kernels {
namespace {

/// row · x, summed as ModalSystem::Relation::along does.
BENTUR_INLINE double along(const Pressing& p, const double* x) {
  return sum(product(p.right_size, p.right_row, x + p.right_begin)) +
         sum(product(p.left_size, p.left_row, x + p.left_begin));
}

/// (T-2) for any number of buildings and points.
BENTUR_INLINE void expand_all(std::span<const Pressing> pressing, const Driven& of, std::span<GroundSeries> grounds,
                              int degree, Index stride, double* c) {
  const bool driven = grounds.front().nu_squared > 0.0;
  const Index begin = grounds.front().begin;
  const Index end = grounds.back().begin + grounds.back().size;
  for (const Pressing& p : pressing) p.deformation[0] = along(p, c) + p.offset;
  for (int k = 0; k + 2 <= degree; ++k) {
    const Four scale = factor(power_factors.scale, k);
    const Four step = factor(power_factors.next, k);
    const double* c0 = c + k * stride;
    const double* c1 = c0 + stride;
    double* c2 = c + (k + 2) * stride;
    const auto own = [&](Index j) __attribute__((always_inline)) {
      return load(of.stiff + j) * load(c0 + j) + step * load(of.damp + j) * load(c1 + j);
    };
    if (k < 2 || driven) {
      for (GroundSeries& ground : grounds) {
        const Four a = all(ground.next(k));
        for (Index j = ground.begin; j < ground.begin + ground.size; j += four) {
          store(c2 + j, load(of.gamma + j) * a - own(j));
        }
      }
    } else {
      for (Index j = begin; j < end; j += four) store(c2 + j, -own(j));
    }
    if (k == 0 && of.load != nullptr) {
      for (Index j = begin; j < end; j += four) store(c2 + j, load(c2 + j) + load(of.load + j));
    }
    for (const Pressing& p : pressing) {
      const double speed = along(p, c1);
      p.deformation[k + 1] = speed;
      double force = p.stiffness * p.deformation[k] + p.damping * step[0] * speed;
      if (k == 0) force += p.base;
      const auto push = [&](Index first, Index n, const double* by) __attribute__((always_inline)) {
        for (Index j = 0; j < n; j += four) store(c2 + first + j, load(c2 + first + j) + all(force) * load(by + j));
      };
      push(p.left_begin, p.left_size, p.left_push);
      push(p.right_begin, p.right_size, p.right_push);
    }
    for (Index j = begin; j < end; j += four) store(c2 + j, load(c2 + j) * scale);
  }
  for (const Pressing& p : pressing) p.deformation[degree] = along(p, c + degree * stride);
}

/// The same for two buildings of four coordinates each and one point. All stays in registers, and where nothing damps
/// the contact no power waits for the one before.
BENTUR_INLINE void expand_two_of_four(const Pressing p, const Driven& of, std::span<GroundSeries> grounds, int degree,
                                      Index stride, double* c) {
  const Index l = p.left_begin;
  const Index r = p.right_begin;
  const bool driven = grounds[0].nu_squared > 0.0;
  struct Building {
    Four stiff, damp, gamma, push, row, c0, c1;
  };
  const auto building = [&](Index at, const double* push, const double* row) __attribute__((always_inline)) {
    return Building{load(of.stiff + at), load(of.damp + at), load(of.gamma + at),      load(push),
                    load(row),           load(c + at),       load(c + stride + at)};
  };
  Building left = building(l, p.left_push, p.left_row);
  Building right = building(r, p.right_push, p.right_row);
  const auto along_row = [&](Four of_left, Four of_right) __attribute__((always_inline)) {
    return sum(right.row * of_right) + sum(left.row * of_left);
  };
  double deformation = along_row(left.c0, right.c0) + p.offset;
  double next = along_row(left.c1, right.c1);
  p.deformation[0] = deformation;
  p.deformation[1] = next;
  for (int k = 0; k + 2 <= degree; ++k) {
    const Four step = factor(power_factors.next, k);
    const Four scale = factor(power_factors.scale, k);
    double force = p.stiffness * deformation;
    if (p.damping != 0.0) force += p.damping * step[0] * next;
    if (k == 0) force += p.base;
    const auto advance = [&](Building & b, double a) __attribute__((always_inline)) {
      const Four own = b.stiff * b.c0 + step * b.damp * b.c1;
      b.c0 = b.c1;
      b.c1 = ((b.gamma * all(a) - own) + all(force) * b.push) * scale;
    };
    const bool shaken = k < 2 || driven;
    const double a_left = shaken ? grounds[0].next(k) : 0.0;
    const double a_right = shaken ? grounds[1].next(k) : 0.0;
    advance(left, a_left);
    advance(right, a_right);
    double* c2 = c + (k + 2) * stride;
    store(c2 + l, left.c1);
    store(c2 + r, right.c1);
    deformation = next;
    next = along_row(left.c1, right.c1);
    p.deformation[k + 2] = next;
  }
}

// NOLINTBEGIN(modernize-avoid-c-arrays): registers. Several fours side by side, so that none waits for another.
struct Evaluated {
  double *q, *first, *second;
};
template <int groups>
BENTUR_INLINE void evaluate_groups(const double* c, Index stride, int degree, double at, const Evaluated& to) {
  const Four s = all(at);
  Four x[groups] = {};
  Four y[groups] = {};
  Four z[groups] = {};
  for (int k = degree; k >= 2; --k) {
    const Four once = factor(power_factors.first, k);
    const Four twice = factor(power_factors.second, k);
    for (int g = 0; g < groups; ++g) {
      const Four term = load(c + k * stride + four * g);
      x[g] = x[g] * s + term;
      y[g] = y[g] * s + once * term;
      z[g] = z[g] * s + twice * term;
    }
  }
  for (int g = 0; g < groups; ++g) {
    const Four linear = load(c + stride + four * g);
    store(to.q + four * g, (x[g] * s + linear) * s + load(c + four * g));
    store(to.first + four * g, y[g] * s + linear);
    store(to.second + four * g, z[g]);
  }
}

struct Chord {
  double end, rate;
};
template <int groups>
BENTUR_INLINE Four leave_chords_of(const double* c, Index stride, int degree, const Chord& chord, double* rise,
                                   double* second_rise) {
  Four x[groups] = {};
  Four y[groups] = {};
  double power = 1.0;  // end^(k − 2)
  for (int k = 2; k <= degree; ++k) {
    const Four far = all(power_factors.rise[k] * power);
    const Four second_far = all(power_factors.second_rise[k] * power);
    for (int g = 0; g < groups; ++g) {
      const Four term = abs(load(c + k * stride + four * g));
      x[g] += far * term;
      y[g] += second_far * term;
    }
    power *= chord.end;
  }
  Four total = all(0.0);
  for (int g = 0; g < groups; ++g) {
    x[g] *= all(chord.end * chord.end);
    y[g] *= all(chord.rate);
    store(rise + four * g, x[g]);
    store(second_rise + four * g, y[g]);
    total += x[g] + y[g];
  }
  return total;
}
// NOLINTEND(modernize-avoid-c-arrays)

/// Hands terms p_k s^k to p_{k+3} s^{k+3} on, for k = 0, 4, …
template <class Take>
BENTUR_INLINE void in_fours(const double* p, int degree, double s, const Take& take) {
  const double square = s * s;
  Four powers{1.0, s, square, square * s};
  const Four next = all(square * square);
  int k = 0;
  for (; k + 4 <= degree + 1; k += 4) {
    take(k, load(p + k) * powers);
    powers *= next;
  }
  if (k <= degree) {
    Four rest = all(0.0);
    for (int i = 0; k + i <= degree; ++i) rest[i] = p[k + i];
    take(k, rest * powers);
  }
}

}  // namespace

BENTUR_FOR_ALL_PROCESSORS
void begin_series(Index n, const Oscillators& of, const double* q, const double* v, double h, Index stride,
                  double* stiff, double* damp, double* c) {
  const Four once = all(h);
  const Four twice = all(h * h);
  for (Index j = 0; j < n; j += four) {
    store(stiff + j, twice * load(of.omega_squared + j));
    store(damp + j, once * load(of.two_sigma + j));
    store(c + j, load(q + j));
    store(c + stride + j, once * load(v + j));
  }
}

BENTUR_FOR_ALL_PROCESSORS
void expand(const Driven& of, std::span<GroundSeries> grounds, std::span<const Pressing> pressing, int degree,
            Index stride, double* c) {
  const bool two_of_four = grounds.size() == 2 && grounds[0].size == four && grounds[1].size == four;
  if (pressing.size() == 1 && two_of_four && of.load == nullptr && pressing[0].right_size > 0) {
    expand_two_of_four(pressing[0], of, grounds, degree, stride, c);
  } else {
    expand_all(pressing, of, grounds, degree, stride, c);
  }
}

BENTUR_FOR_ALL_PROCESSORS
void evaluate(Index n, const double* c, Index stride, int degree, double at, double* q, double* first, double* second) {
  Index j = 0;
  for (; j + 2 * four <= n; j += 2 * four) {
    evaluate_groups<2>(c + j, stride, degree, at, {q + j, first + j, second + j});
  }
  if (j < n) evaluate_groups<1>(c + j, stride, degree, at, {q + j, first + j, second + j});
}

BENTUR_FOR_ALL_PROCESSORS
void bound(Index n, const double* c, Index stride, int degree, double end, double chord, double fourth_chord,
           double* second, double* fourth) {
  for (Index j = 0; j < n; j += four) {
    Four x = all(0.0);
    Four y = all(0.0);
    double power = 1.0;  // end^(k − 2)
    for (int k = 2; k <= degree; ++k) {
      const Four term = factor(power_factors.second, k) * (all(power) * abs(load(c + k * stride + j)));
      x += term;
      y += factor(power_factors.fourth, k) * term;
      power *= end;
    }
    store(second + j, x * all(chord));
    store(fourth + j, y * all(fourth_chord / (end * end)));
  }
}

BENTUR_FOR_ALL_PROCESSORS
double leave_chords(Index n, const double* c, Index stride, int degree, double end, double rate, double* rise,
                    double* second_rise) {
  Four total = all(0.0);
  Index j = 0;
  for (; j + 2 * four <= n; j += 2 * four) {
    total += leave_chords_of<2>(c + j, stride, degree, {end, rate}, rise + j, second_rise + j);
  }
  if (j < n) total += leave_chords_of<1>(c + j, stride, degree, {end, rate}, rise + j, second_rise + j);
  return sum(total);
}

BENTUR_FOR_ALL_PROCESSORS
void sample(Index n, const double* c, Index stride, int degree, const Places& places, double* q, double* second) {
  const auto [count, end, rate] = places;
  for (Index j = 0; j < n; j += four) {
    store(q + j, load(c + j));
    store(second + j, all(2.0 * rate) * load(c + 2 * stride + j));
    // Four places side by side, so that none waits for another.
    for (int first = 1; first <= count; first += four) {
      Four s[four];       // NOLINT(modernize-avoid-c-arrays): registers
      Four x[four] = {};  // NOLINT(modernize-avoid-c-arrays)
      Four y[four] = {};  // NOLINT(modernize-avoid-c-arrays)
      for (int i = 0; i < four; ++i) s[i] = all(first + i == count ? end : end * (first + i) / count);
      for (int k = degree; k >= 2; --k) {
        const Four term = load(c + k * stride + j);
        const Four curved = factor(power_factors.second, k) * term;
        for (int i = 0; i < four; ++i) {
          x[i] = x[i] * s[i] + term;
          y[i] = y[i] * s[i] + curved;
        }
      }
      for (int i = 0; i < four && first + i <= count; ++i) {
        const Index at = (first + i) * n + j;
        store(q + at, (x[i] * s[i] + load(c + stride + j)) * s[i] + load(c + j));
        store(second + at, y[i] * all(rate));
      }
    }
  }
}

BENTUR_FOR_ALL_PROCESSORS
void accelerate(Index n, const double* omega_squared, const double* two_sigma, const double* gamma, double value,
                const double* q, const double* v, double* acceleration) {
  for (Index j = 0; j < n; j += four) {
    store(acceleration + j,
          all(value) * load(gamma + j) - load(omega_squared + j) * load(q + j) - load(two_sigma + j) * load(v + j));
  }
}

BENTUR_FOR_ALL_PROCESSORS
void row_series(const RowOf& right, const RowOf& left, Index stride, int degree, double* polynomial) {
  const auto sums = [stride](RowOf by, int k) __attribute__((always_inline)) {
    Four total[four] = {};  // NOLINT(modernize-avoid-c-arrays): registers
    for (Index j = 0; j < by.size; j += four) {
      const Four weight = load(by.row + j);
      for (Index i = 0; i < four; ++i) total[i] += weight * load(by.c + (k + i) * stride + j);
    }
    return sums_of(total[0], total[1], total[2], total[3]);
  };
  int k = 0;
  for (; k + 4 <= degree + 1; k += 4) store(polynomial + k, sums(right, k) + sums(left, k));
  for (; k <= degree; ++k) {
    polynomial[k] = sum(product(right.size, right.row, right.c + k * stride)) +
                    sum(product(left.size, left.row, left.c + k * stride));
  }
}

BENTUR_FOR_ALL_PROCESSORS
Inspection inspect(const double* p, int degree, double mid, double b) {
  Four end = all(0.0);
  Four slope = all(0.0);
  Four curvature = all(0.0);
  Four second = all(0.0);
  Four third = all(0.0);
  in_fours(
      p, degree, mid, [&](int k, Four term) __attribute__((always_inline)) {
        slope += load(power_factors.first.data() + k) * term;
        curvature += load(power_factors.second.data() + k) * term;
      });
  in_fours(
      p, degree, b, [&](int k, Four term) __attribute__((always_inline)) {
        const Four most = abs(term);
        end += term;
        second += load(power_factors.second.data() + k) * most;
        third += load(power_factors.third.data() + k) * most;
      });
  return {sum(end), sum(slope) / mid, sum(curvature) / (mid * mid), sum(second) / (b * b), sum(third) / (b * b * b)};
}

BENTUR_FOR_ALL_PROCESSORS
Survey survey(const double* p, int degree, double end) {
  Four value = all(0.0);
  Four rise = all(0.0);
  Four second = all(0.0);
  in_fours(
      p, degree, end, [&](int k, Four term) __attribute__((always_inline)) {
        const Four most = abs(term);
        value += term;
        rise += load(power_factors.rise.data() + k) * most;
        second += load(power_factors.second.data() + k) * most;
      });
  return {sum(value), sum(rise), sum(second) / (end * end)};
}

BENTUR_FOR_ALL_PROCESSORS
Derivatives derivatives(const double* p, int degree, double s) {
  if (s == 0.0) return {p[0], p[1], 2.0 * p[2]};
  Four value = all(0.0);
  Four slope = all(0.0);
  Four curvature = all(0.0);
  in_fours(
      p, degree, s, [&](int k, Four term) __attribute__((always_inline)) {
        value += term;
        slope += load(power_factors.first.data() + k) * term;
        curvature += load(power_factors.second.data() + k) * term;
      });
  return {sum(value), sum(slope) / s, sum(curvature) / (s * s)};
}

BENTUR_FOR_ALL_PROCESSORS
void stage(Index n, const double* slopes, Index stride, int count, const double* positions, const double* speeds,
           double after, double h, const double* q, const double* v, double* q_at, double* v_at) {
  for (Index k = 0; k < n; k += four) {
    Four position = all(0.0);
    Four speed = all(0.0);
    for (int j = 0; j < count; ++j) {
      const Four slope = load(slopes + j * stride + k);
      position += all(positions[j]) * slope;
      speed += all(speeds[j]) * slope;
    }
    store(q_at + k, load(q + k) + all(after) * load(v + k) + all(h * h) * position);
    store(v_at + k, load(v + k) + all(h) * speed);
  }
}

BENTUR_FOR_ALL_PROCESSORS
void interpolate(Index n, const double* slopes, Index stride, int count, const double* weights, const double* factors,
                 double* to) {
  for (Index k = 0; k < n; k += four) {
    Four power[powers] = {};  // NOLINT(modernize-avoid-c-arrays): registers
    for (int j = 0; j < count; ++j) {
      const Four slope = load(slopes + j * stride + k);
      for (int i = 0; i < powers; ++i) power[i] += all(weights[j * powers + i]) * slope;
    }
    for (int i = 0; i < powers; ++i) store(to + i * stride + k, all(factors[i]) * power[i]);
  }
}

}  // namespace bentur::engine::kernels
