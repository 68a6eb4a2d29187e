#include "bentur/solve/engine/motion/kernels/series.h"

#include "bentur/solve/engine/motion/kernels/four.h"

namespace bentur::engine::kernels {
namespace {

/// Adds term k of the force of such elements, times `scale`, to c_{k+2}.
BENTUR_INLINE void add_tied(const Tied& of, int k, Four scale, const double* c0, double* c2) {
  const Four by = scale * all(of.h_squared);
  const auto add = [&](Four factor, const double* column) __attribute__((always_inline)) {
    for (Index j = 0; j < of.size; j += four) store(c2 + j, load(c2 + j) + factor * load(column + j));
  };
  for (Index j = 0; of.matrix != nullptr && j < of.size; j += four) {
    Four sum = load(c2 + j);
    for (Index n = 0; n < of.size; ++n) sum += by * all(c0[n]) * load(of.matrix + n * of.size + j);
    store(c2 + j, sum);
  }
  for (Index n = 0; of.matrix == nullptr && n < of.count; ++n) {
    add(by * all(sum(product(of.size, of.pull + n * of.size, c0))), of.push + n * of.size);
  }
  if (k == 0) add(by, of.base);
}

/// (T-2) for any number of bodies and elements.
BENTUR_INLINE void expand_all(std::span<const Pressing> pressing, std::span<const Tied> tied, const Driven of,
                              std::span<GroundSeries> grounds, int degree, Index stride, double* c) {
  const bool driven = grounds.front().nu_squared > 0.0;
  // row · x, summed as ModalSystem::Relation::along does.
  const auto along = [](const Pressing& p, const double* x) __attribute__((always_inline)) {
    return sum_of_both(product(p.right_size, p.right_row, x + p.right_begin),
                       product(p.left_size, p.left_row, x + p.left_begin));
  };
  for (const Pressing& p : pressing) {
    p.deformation[0] = along(p, c) + p.offset;
    p.deformation[1] = along(p, c + stride);
  }
  for (int k = 0; k + 2 <= degree; ++k) {
    const Four scale = factor(power_factors.scale, k);
    const Four step = factor(power_factors.next, k);
    const double* c0 = c + k * stride;
    const double* c1 = c0 + stride;
    double* c2 = c + (k + 2) * stride;
    const auto own = [&](Index j) __attribute__((always_inline)) {
      return load(of.stiff + j) * load(c0 + j) + step * load(of.damp + j) * load(c1 + j);
    };
    for (GroundSeries& ground : grounds) {
      const Index last = ground.begin + ground.size;
      if (k < 2 || driven) {
        const Four a = all(ground.next(k));
        for (Index j = ground.begin; j < last; j += four) {
          store(c2 + j, (load(of.gamma + j) * a - own(j)) * scale);
        }
      } else {
        for (Index j = ground.begin; j < last; j += four) store(c2 + j, -own(j) * scale);
      }
      if (k > 0 || of.load == nullptr) continue;
      for (Index j = ground.begin; j < last; j += four) store(c2 + j, load(c2 + j) + load(of.load + j) * scale);
    }
    for (GroundSeries& ground : of.further) {
      if (k >= 2 && ground.nu_squared == 0.0) continue;
      const Four a = all(ground.next(k)) * scale;
      for (Index j = ground.begin; j < ground.begin + ground.size; j += four) {
        store(c2 + j, load(c2 + j) + load(ground.gamma + j) * a);
      }
    }
    for (const Tied& t : tied) add_tied(t, k, scale, c0 + t.begin, c2 + t.begin);
    for (const Pressing& p : pressing) {
      double force = p.stiffness * p.deformation[k] + p.damping * step[0] * p.deformation[k + 1];
      if (k == 0) force += p.base;
      const Four pushed = all(force * scale[0]);
      const auto push = [&](Index first, Index size, const double* by) __attribute__((always_inline)) {
        for (Index j = 0; j < size; j += four) store(c2 + first + j, load(c2 + first + j) + pushed * load(by + j));
      };
      push(p.left_begin, p.left_size, p.left_push);
      push(p.right_begin, p.right_size, p.right_push);
    }
    for (const Pressing& p : pressing) p.deformation[k + 2] = along(p, c2);
  }
}

// NOLINTBEGIN(modernize-avoid-c-arrays): registers
/// The same for two bodies of four coordinates each, which stay in registers, and no more elements than this.
constexpr std::size_t most_small = 6;
BENTUR_INLINE void expand_small(std::span<const Pressing> pressing, const Driven of, std::span<GroundSeries> grounds,
                                int degree, Index stride, double* to) {
  struct Element {
    Four row[2], push[2], stiffness, damping;
    double* deformation;
  };
  const Index begin[2] = {grounds[0].begin, grounds[1].begin};
  const bool driven = grounds[0].nu_squared > 0.0;
  Four c[2], next[2], stiff[2], damp[2], base[2];
  for (int b = 0; b < 2; ++b) {
    c[b] = load(to + begin[b]);
    next[b] = load(to + stride + begin[b]);
    stiff[b] = load(of.stiff + begin[b]);
    damp[b] = load(of.damp + begin[b]);
    base[b] = of.load != nullptr ? load(of.load + begin[b]) : all(0.0);
  }
  Element elements[most_small];
  const Element* const end = elements + pressing.size();
  const auto along = [](const Element& e, const Four* x) __attribute__((always_inline)) {
    return sum_of_both(e.row[1] * x[1], e.row[0] * x[0]);
  };
  for (std::size_t n = 0; n < pressing.size(); ++n) {
    const Pressing& p = pressing[n];
    Element& e = elements[n];
    const int left = p.left_begin == begin[0] ? 0 : 1;
    const bool both = p.right_size > 0;
    e.row[left] = load(p.left_row);
    e.push[left] = load(p.left_push);
    e.row[1 - left] = both ? load(p.right_row) : all(0.0);
    e.push[1 - left] = both ? load(p.right_push) : all(0.0);
    e.stiffness = all(p.stiffness);
    e.damping = all(p.damping);
    e.deformation = p.deformation;
    e.deformation[0] = along(e, c) + p.offset;
    e.deformation[1] = along(e, next);
    for (int b = 0; b < 2; ++b) base[b] += all(p.base) * e.push[b];
  }
  const auto advance = [&](int k, bool shaken) __attribute__((always_inline)) {
    const Four scale = factor(power_factors.scale, k);
    const Four step = factor(power_factors.next, k);
    Four after[2];
    for (int b = 0; b < 2; ++b) {
      after[b] = -(stiff[b] * c[b] + step * damp[b] * next[b]);
      if (shaken) after[b] += load(of.gamma + begin[b]) * all(grounds[b].next(k));
      if (k == 0) after[b] += base[b];
    }
    for (const Element* e = elements; e < end; ++e) {
      const Four force = e->stiffness * all(e->deformation[k]) + e->damping * step * all(e->deformation[k + 1]);
      for (int b = 0; b < 2; ++b) after[b] += force * e->push[b];
    }
    for (int b = 0; b < 2; ++b) {
      after[b] *= scale;
      store(to + (k + 2) * stride + begin[b], after[b]);
      c[b] = next[b];
      next[b] = after[b];
    }
    for (const Element* e = elements; e < end; ++e) e->deformation[k + 2] = along(*e, after);
  };
  advance(0, true);
  advance(1, true);
  int k = 2;
  for (; driven && k + 2 <= degree; ++k) advance(k, true);
  for (; k + 2 <= degree; ++k) advance(k, false);
}
// NOLINTEND(modernize-avoid-c-arrays)

// NOLINTBEGIN(modernize-avoid-c-arrays): registers. Several fours side by side, so that none waits for another.
template <int groups, bool accelerated>
BENTUR_INLINE void evaluate_groups(const double* c, Index stride, int degree, double at, double h, const Instant& to) {
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
      if constexpr (accelerated) z[g] = z[g] * s + twice * term;
    }
  }
  const Four rate = all(1.0 / h);
  for (int g = 0; g < groups; ++g) {
    const Four linear = load(c + stride + four * g);
    store(to.q + four * g, (x[g] * s + linear) * s + load(c + four * g));
    store(to.v + four * g, (y[g] * s + linear) * rate);
    if constexpr (accelerated) store(to.acceleration + four * g, z[g] * (rate * rate));
  }
}

template <bool accelerated>
BENTUR_INLINE void evaluate_all(Index n, const double* c, Index stride, int degree, double at, double h,
                                const Instant& to) {
  const auto from = [&](Index j) __attribute__((always_inline)) {
    return Instant{to.q + j, to.v + j, accelerated ? to.acceleration + j : nullptr};
  };
  Index j = 0;
  for (; j + 2 * four <= n; j += 2 * four) {
    evaluate_groups<2, accelerated>(c + j, stride, degree, at, h, from(j));
  }
  if (j < n) evaluate_groups<1, accelerated>(c + j, stride, degree, at, h, from(j));
}

template <int groups>
BENTUR_INLINE Four end_of_groups(const double* c, Index stride, int degree, double h, const Instant& to,
                                 double* rise_to, double* second_rise_to) {
  Four x[groups] = {};
  Four y[groups] = {};
  Four z[groups] = {};
  Four far[groups] = {};
  Four second_far[groups] = {};
  for (int k = degree; k >= 2; --k) {
    const Four once = factor(power_factors.first, k);
    const Four twice = factor(power_factors.second, k);
    const Four rise = factor(power_factors.rise, k);
    const Four second_rise = factor(power_factors.second_rise, k);
    for (int g = 0; g < groups; ++g) {
      const Four term = load(c + k * stride + four * g);
      x[g] += term;
      y[g] += once * term;
      z[g] += twice * term;
      far[g] += rise * abs(term);
      second_far[g] += second_rise * abs(term);
    }
  }
  const Four rate = all(1.0 / h);
  const Four rate_squared = rate * rate;
  Four total = all(0.0);
  for (int g = 0; g < groups; ++g) {
    const Four linear = load(c + stride + four * g);
    second_far[g] *= rate_squared;
    store(to.q + four * g, (x[g] + linear) + load(c + four * g));
    store(to.v + four * g, (y[g] + linear) * rate);
    store(to.acceleration + four * g, z[g] * rate_squared);
    store(rise_to + four * g, far[g]);
    store(second_rise_to + four * g, second_far[g]);
    total += far[g] + second_far[g];
  }
  return total;
}
// NOLINTEND(modernize-avoid-c-arrays)

/// Hands terms p_k s^k to p_{k+3} s^{k+3} on, for k = 0, 4, …; coefficients beyond the degree are zero.
template <class Take>
BENTUR_INLINE void in_fours(const double* p, int degree, double s, const Take& take) {
  const double square = s * s;
  Four powers{1.0, s, square, square * s};
  const Four next = all(square * square);
  for (int k = 0; k <= degree; k += 4) {
    take(k, load(p + k) * powers);
    powers *= next;
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
void expand(const Driven& of, std::span<GroundSeries> grounds, std::span<const Pressing> pressing,
            std::span<const Tied> tied, int degree, Index stride, double* c) {
  const bool small =
      tied.empty() && of.further.empty() && grounds.size() == 2 && grounds[0].size == four && grounds[1].size == four;
  if (small && pressing.size() <= most_small) {
    expand_small(pressing, of, grounds, degree, stride, c);
  } else {
    expand_all(pressing, tied, of, grounds, degree, stride, c);
  }
}

BENTUR_FOR_ALL_PROCESSORS
void evaluate(Index n, const double* c, Index stride, int degree, double s, double h, const Instant& to) {
  if (to.acceleration != nullptr) return evaluate_all<true>(n, c, stride, degree, s, h, to);
  evaluate_all<false>(n, c, stride, degree, s, h, to);
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
double end_of_step(Index n, const double* c, Index stride, int degree, double h, const Instant& to, double* rise,
                   double* second_rise) {
  Four total = all(0.0);
  const auto from = [&](Index j) __attribute__((always_inline)) {
    return Instant{to.q + j, to.v + j, to.acceleration + j};
  };
  Index j = 0;
  for (; j + 2 * four <= n; j += 2 * four) {
    total += end_of_groups<2>(c + j, stride, degree, h, from(j), rise + j, second_rise + j);
  }
  if (j < n) total += end_of_groups<1>(c + j, stride, degree, h, from(j), rise + j, second_rise + j);
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
  for (int k = 0; k <= degree; k += 4) store(polynomial + k, sums(right, k) + sums(left, k));
}

BENTUR_FOR_ALL_PROCESSORS
Splits splits(const double* p, int degree, double s) {
  const auto split = [](double x) { return x > 0.0 ? Split{x, 0.0} : Split{0.0, -x}; };
  if (s == 0.0) return {p[0], split(p[1]), split(2.0 * p[2])};
  Four value = all(0.0);
  Four rising = all(0.0);
  Four falling = all(0.0);
  Four convex = all(0.0);
  Four concave = all(0.0);
  in_fours(
      p, degree, s, [&](int k, Four term) __attribute__((always_inline)) {
        const Four above = max(term, all(0.0));
        const Four below = above - term;
        const Four once = load(power_factors.first.data() + k);
        const Four twice = load(power_factors.second.data() + k);
        value += term;
        rising += once * above;
        falling += once * below;
        convex += twice * above;
        concave += twice * below;
      });
  const double rate = 1.0 / s;
  const Four sums = sums_of(rising, falling, convex, concave) * all(rate);
  return {sum(value), {sums[0], sums[1]}, {sums[2] * rate, sums[3] * rate}};
}

BENTUR_FOR_ALL_PROCESSORS
Survey survey(const double* p, int degree, double end) {
  Four value = all(0.0);
  Four rise = all(0.0);
  Four second = all(0.0);
  Four third = all(0.0);
  in_fours(
      p, degree, end, [&](int k, Four term) __attribute__((always_inline)) {
        const Four most = abs(term);
        value += term;
        rise += load(power_factors.rise.data() + k) * most;
        second += load(power_factors.second.data() + k) * most;
        third += load(power_factors.third.data() + k) * most;
      });
  const Four sums = sums_of(value, rise, second, third);
  const double rate = 1.0 / end;
  return {sums[0], sums[1], sums[2] * (rate * rate), sums[3] * (rate * rate * rate)};
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
  const Four sums = sums_of(value, slope, curvature, curvature);
  return {sums[0], sums[1] / s, sums[2] / (s * s)};
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
