#include "bentur/solve/motion/kernels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#if defined(__x86_64__) && defined(__linux__)
#define BENTUR_FOR_ALL_PROCESSORS __attribute__((target_clones("avx2", "default")))
#else
#define BENTUR_FOR_ALL_PROCESSORS
#endif
#define BENTUR_INLINE __attribute__((always_inline)) inline

namespace bentur::engine::kernels {
namespace {

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
BENTUR_INLINE Four size(Four x) {
  constexpr long long mask = 0x7fffffffffffffff;
  return reinterpret_cast<Four>(reinterpret_cast<Bits>(x) & Bits{mask, mask, mask, mask});
}
BENTUR_INLINE Four larger(Four a, Four b) { return a > b ? a : b; }
BENTUR_INLINE Four smaller(Four a, Four b) { return a < b ? a : b; }
BENTUR_INLINE Four root(Four x) { return Four{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])}; }
BENTUR_INLINE double sum(Four x) { return (x[0] + x[1]) + (x[2] + x[3]); }
BENTUR_INLINE Four product(Index n, const double* a, const double* b) {
  Four total = all(0.0);
  for (Index j = 0; j < n; j += four) total += load(a + j) * load(b + j);
  return total;
}

BENTUR_INLINE bool any(Bits x) { return (x[0] | x[1] | x[2] | x[3]) != 0; }

struct Input {
  Four value, slope, largest, steepest;
  BENTUR_INLINE explicit Input(const FlightInput& in)
      : value(all(in.value)), slope(all(in.slope)), largest(all(in.largest)), steepest(all(in.steepest)) {}
};

/// Four coordinates at the end of a flight, and what is known of the way (flight.h).
struct Flown {
  Four q, v, rise, acceleration_rise, position, acceleration;

  BENTUR_INLINE Flown(const double* row, const Input& in, Four q_start, Four v_start) {
    const auto at = [row](FlightMap::Column column) __attribute__((always_inline)) {
      return load(row + column * four);
    };
    using enum FlightMap::Column;
    q = (at(qq) * q_start + at(qv) * v_start) + (at(qa) * in.value + at(qb) * in.slope);
    v = (at(vq) * q_start + at(vv) * v_start) + (at(va) * in.value + at(vb) * in.slope);
    const Four du = v_start - at(p_rate) * in.slope;
    const Four u = at(omega) * (q_start - (at(p_value) * in.value + at(p_slope) * in.slope));
    const Four s = root(du * du + u * u) + at(slow) * in.largest;
    rise = at(second) * s + at(second_force) * in.largest;
    acceleration_rise = at(fourth) * s + (at(fourth_force) * in.largest + at(fourth_slope) * in.steepest);
    const Four chord = larger(size(q_start), size(q)) + rise;
    const Four around =
        (at(orbit_floor) + at(orbit) * s) + (at(orbit_value) * in.largest + at(orbit_slope) * in.steepest);
    position = smaller(chord, around);
    acceleration = at(kappa) * s + at(force) * in.largest;
  }
};

/// The sums of (T-4), four coordinates at a time.
struct FourSums {
  Four positions{}, accelerations{}, as_left{}, as_right{};

  BENTUR_INLINE void add(const Lumped& lumped, Index j, Four position, Four acceleration) {
    positions += load(lumped.positions.data() + j) * position;
    accelerations += load(lumped.accelerations.data() + j) * acceleration;
    as_left += load(lumped.as_left.data() + j) * position;
    as_right += load(lumped.as_right.data() + j) * position;
  }
  [[nodiscard]] BENTUR_INLINE Sums result() const {
    return {sum(positions), sum(accelerations), sum(as_left), sum(as_right)};
  }
};

/// Four rows of a matrix at two vectors, and Σ |w_rj| rise_j.
struct Ends {
  Four start, end, beyond;
};
BENTUR_INLINE Ends ends_of_rows(Index columns, const double* weights, const double* start, const double* end,
                                const double* rise) {
  Ends at{all(0.0), all(0.0), all(0.0)};
  for (Index j = 0; j < columns; ++j) {
    const Four weight = load(weights + four * j);
    at.start += weight * all(start[j]);
    at.end += weight * all(end[j]);
    at.beyond += size(weight) * all(rise[j]);
  }
  return at;
}

}  // namespace

PackedRows::PackedRows(const Eigen::MatrixXd& matrix, Index columns)
    : rows_((matrix.rows() + four - 1) / four * four),
      columns_(columns),
      weights_(static_cast<std::size_t>(rows_ * columns), 0.0) {
  for (Index r = 0; r < matrix.rows(); ++r) {
    for (Index j = 0; j < matrix.cols(); ++j) {
      weights_[static_cast<std::size_t>(r / four * four * columns + four * j + r % four)] = matrix(r, j);
    }
  }
}

BENTUR_FOR_ALL_PROCESSORS
Sums fly(const FlightMap& map, Room room, const FlightInput& input, const double* q, const double* v, double* q_end,
         double* v_end, const Lumped& lumped, Rises& rises) {
  const Input in(input);
  FourSums total;
  for (Index j = room.begin; j < room.begin + room.size; j += four) {
    const Flown flown(map.table.data() + j * FlightMap::columns, in, load(q + j), load(v + j));
    store(q_end + j, flown.q);
    store(v_end + j, flown.v);
    store(rises.position.data() + j, flown.rise);
    store(rises.acceleration.data() + j, flown.acceleration_rise);
    total.add(lumped, j, flown.position, flown.acceleration);
  }
  return total.result();
}

BENTUR_FOR_ALL_PROCESSORS
Index fly_on(const Legs& legs, Index count, const Lumped& lumped) {
  std::size_t kind = 0;
  for (Index n = 0; n < count; ++n) {
    const double* q = legs.q + n * legs.stride;
    const double* v = legs.v + n * legs.stride;
    double* q_end = legs.q + (n + 1) * legs.stride;
    double* v_end = legs.v + (n + 1) * legs.stride;
    const double* table = legs.maps[kind]->table.data();
    if (++kind == legs.maps.size()) kind = 0;
    bool open = true;
    double left = 0.0;  // sum of the building before, as the left one of a pair
    const FlightInput* input = legs.inputs + n * static_cast<Index>(legs.rooms.size());
    for (const Room& room : legs.rooms) {
      const Input in(*input++);
      Four as_left = all(0.0);
      Four as_right = all(0.0);
      for (Index j = room.begin; j < room.begin + room.size; j += four) {
        const Flown flown(table + j * FlightMap::columns, in, load(q + j), load(v + j));
        store(q_end + j, flown.q);
        store(v_end + j, flown.v);
        const Index at = n * legs.stride + j;
        store(legs.rise + at, flown.rise);
        store(legs.acceleration_rise + at, flown.acceleration_rise);
        as_left += load(lumped.as_left.data() + j) * flown.position;
        as_right += load(lumped.as_right.data() + j) * flown.position;
      }
      open = open && left + sum(as_right) < 1.0;
      left = sum(as_left);
    }
    if (!open) return n;
  }
  return count;
}

BENTUR_FOR_ALL_PROCESSORS
Sums sum_up(Room room, const Stretch& stretch, const Lumped& lumped) {
  const Four chord = all(stretch.end * stretch.end / 8.0);
  const Four rate = all(1.0 / (stretch.h * stretch.h));
  const auto at_most = [&chord](const double* from, const double* to, Four curvature) __attribute__((always_inline)) {
    return larger(size(load(from)), size(load(to))) + chord * curvature;
  };
  FourSums total;
  for (Index j = room.begin; j < room.begin + room.size; j += four) {
    const Four second = load(stretch.second + j);
    const Four curved = at_most(stretch.curved + j, stretch.curved_end + j, load(stretch.fourth + j));
    total.add(lumped, j, at_most(stretch.q + j, stretch.q_end + j, second), rate * smaller(second, curved));
  }
  return total.result();
}

BENTUR_FOR_ALL_PROCESSORS
void expand(const double* stiff, const double* damp, const double* gamma, std::span<Ground> grounds,
            std::span<const Pressing> pressing, int degree, Index stride, double* c, double* room) {
  const bool driven = grounds.front().nu_squared > 0.0;
  const Index begin = grounds.front().begin;
  const Index end = grounds.back().begin + grounds.back().size;
  const auto open = [](const Pressing& p, const double* x) __attribute__((always_inline)) {
    return sum(product(p.right_size, p.sense_right, x + p.right_begin)) +
           sum(product(p.left_size, p.sense_left, x + p.left_begin));
  };
  for (const Pressing& p : pressing) p.opening[0] = open(p, c) + p.width;
  for (int k = 0; k + 2 <= degree; ++k) {
    const Four scale = all(1.0 / ((k + 2.0) * (k + 1.0)));
    const Four step = all(k + 1.0);
    const double* c0 = c + k * stride;
    const double* c1 = c0 + stride;
    double* c2 = c + (k + 2) * stride;
    const bool input = k < 2 || driven;
    if (input) {
      for (Ground& ground : grounds) {
        const Four a = all(ground.next(k));
        for (Index j = ground.begin; j < ground.begin + ground.size; j += four) store(room + j, load(gamma + j) * a);
      }
    } else if (!pressing.empty()) {
      for (Index j = begin; j < end; j += four) store(room + j, all(0.0));
    }
    for (const Pressing& p : pressing) {
      p.opening[k + 1] = open(p, c1);
      double force = -p.stiffness * p.opening[k] - p.damping * (k + 1.0) * p.opening[k + 1];
      if (k == 0) force += p.base;
      const auto push =
          [&room, f = all(force) ](Index first, Index n, const double* by) __attribute__((always_inline)) {
        for (Index j = 0; j < n; j += four) store(room + first + j, load(room + first + j) + f * load(by + j));
      };
      push(p.left_begin, p.left_size, p.push_left);
      push(p.right_begin, p.right_size, p.push_right);
    }
    if (input || !pressing.empty()) {
      for (Index j = begin; j < end; j += four) {
        store(c2 + j, (load(room + j) - load(stiff + j) * load(c0 + j) - step * load(damp + j) * load(c1 + j)) * scale);
      }
    } else {
      for (Index j = begin; j < end; j += four) {
        store(c2 + j, (-load(stiff + j) * load(c0 + j) - step * load(damp + j) * load(c1 + j)) * scale);
      }
    }
  }
  for (const Pressing& p : pressing) p.opening[degree] = open(p, c + degree * stride);
}

BENTUR_FOR_ALL_PROCESSORS
void evaluate(Index n, const double* c, Index stride, int degree, double at, double* q, double* first, double* second) {
  const Four s = all(at);
  for (Index j = 0; j < n; j += four) {
    Four x = all(0.0);
    Four y = all(0.0);
    Four z = all(0.0);
    for (int k = degree; k >= 2; --k) {
      const Four term = load(c + k * stride + j);
      x = x * s + term;
      y = y * s + all(k) * term;
      z = z * s + all(k * (k - 1.0)) * term;
    }
    const Four linear = load(c + stride + j);
    store(q + j, (x * s + linear) * s + load(c + j));
    store(first + j, y * s + linear);
    store(second + j, z);
  }
}

BENTUR_FOR_ALL_PROCESSORS
double bound(Index n, const double* c, Index stride, int degree, double* second, double* fourth) {
  Four total = all(0.0);
  for (Index j = 0; j < n; j += four) {
    Four x = all(0.0);
    Four y = all(0.0);
    for (int k = 2; k <= degree; ++k) {
      const Four term = all(k * (k - 1.0)) * size(load(c + k * stride + j));
      x += term;
      y += all((k - 2.0) * (k - 3.0)) * term;
    }
    store(second + j, x);
    store(fourth + j, y);
    total += x + y;
  }
  return sum(total);
}

BENTUR_FOR_ALL_PROCESSORS
void sample(Index n, const double* c, Index stride, int degree, int count, double end, double* q, double* second) {
  for (Index j = 0; j < n; j += four) {
    store(q + j, load(c + j));
    store(second + j, all(2.0) * load(c + 2 * stride + j));
    // Four places side by side, so that none waits for another.
    for (int first = 1; first <= count; first += four) {
      Four s[four];       // NOLINT(modernize-avoid-c-arrays): registers
      Four x[four] = {};  // NOLINT(modernize-avoid-c-arrays)
      Four y[four] = {};  // NOLINT(modernize-avoid-c-arrays)
      for (int i = 0; i < four; ++i) s[i] = all(first + i == count ? end : end * (first + i) / count);
      for (int k = degree; k >= 2; --k) {
        const Four term = load(c + k * stride + j);
        const Four curved = all(k * (k - 1.0)) * term;
        for (int i = 0; i < four; ++i) {
          x[i] = x[i] * s[i] + term;
          y[i] = y[i] * s[i] + curved;
        }
      }
      for (int i = 0; i < four && first + i <= count; ++i) {
        const Index at = (first + i) * n + j;
        store(q + at, (x[i] * s[i] + load(c + stride + j)) * s[i] + load(c + j));
        store(second + at, y[i]);
      }
    }
  }
}

BENTUR_FOR_ALL_PROCESSORS
bool reach_of_samples(const PackedRows& rows, int count, const double* x, const double* rise, double* peak,
                      const double* reach_before, double* reach) {
  const Index columns = rows.columns();
  Bits beyond_peak{};
  for (Index r = 0; r < rows.rows(); r += four) {
    const Four before = load(peak + r);
    const Four so_far = load(reach_before + r);
    store(reach + r, so_far);
    if (!any(so_far > before)) continue;
    const double* weights = rows.from(r);
    Four most = all(0.0);
    Four beyond = all(0.0);
    for (Index j = 0; j < columns; ++j) beyond += size(load(weights + four * j)) * all(rise[j]);
    int i = 0;
    for (; i + 3 <= count; i += 3) {
      const double* at = x + i * columns;
      Four value[3] = {};  // NOLINT(modernize-avoid-c-arrays): registers
      for (Index j = 0; j < columns; ++j) {
        const Four weight = load(weights + four * j);
        value[0] += weight * all(at[j]);
        value[1] += weight * all(at[columns + j]);
        value[2] += weight * all(at[2 * columns + j]);
      }
      most = larger(most, larger(size(value[0]), larger(size(value[1]), size(value[2]))));
    }
    for (; i < count; ++i) {
      Four value = all(0.0);
      for (Index j = 0; j < columns; ++j) value += load(weights + four * j) * all(x[i * columns + j]);
      most = larger(most, size(value));
    }
    const Four high = larger(before, most);
    store(peak + r, high);
    store(reach + r, most + beyond);
    beyond_peak |= most + beyond > high;
  }
  return !any(beyond_peak);
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

BENTUR_FOR_ALL_PROCESSORS
void accelerate(Index n, const double* omega_squared, const double* two_sigma, const double* gamma, double value,
                const double* q, const double* v, double* acceleration) {
  for (Index j = 0; j < n; j += four) {
    store(acceleration + j,
          all(value) * load(gamma + j) - load(omega_squared + j) * load(q + j) - load(two_sigma + j) * load(v + j));
  }
}

BENTUR_FOR_ALL_PROCESSORS
void raise_peaks(const PackedRows& rows, Index count, const double* x, Index apart, double* peak, double* share,
                 double* room) {
  for (Index r = 0; r < rows.rows(); r += four) {
    const double* weights = rows.from(r);
    double* values = room + r * count;
    Four high = load(peak + r);
    Index i = 0;
    for (; i + four <= count; i += four) {
      const double* at = x + i * apart;
      Four value[four] = {};  // NOLINT(modernize-avoid-c-arrays): registers
      for (Index j = 0; j < rows.columns(); ++j) {
        const Four weight = load(weights + four * j);
        for (Index k = 0; k < four; ++k) value[k] += weight * all(at[k * apart + j]);
      }
      for (Index k = 0; k < four; ++k) {
        const Four most = size(value[k]);
        store(values + four * (i + k), most);
        high = larger(high, most);
      }
    }
    for (; i < count; ++i) {
      Four value = all(0.0);
      for (Index j = 0; j < rows.columns(); ++j) value += load(weights + four * j) * all(x[i * apart + j]);
      store(values + four * i, size(value));
      high = larger(high, size(value));
    }
    store(peak + r, high);
  }
  for (Index i = 0; i < count; ++i) {
    Four most = all(0.0);
    for (Index r = 0; r < rows.rows(); r += four) {
      const Four part = load(room + r * count + four * i) / load(peak + r);
      most = part > most ? part : most;  // 0/0 is no share
    }
    share[i] = std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
  }
}

BENTUR_FOR_ALL_PROCESSORS
void combine(const PackedRows& rows, Index r, const double* c, Index stride, int degree, double* room,
             double* polynomial) {
  for (Index j = 0; j < rows.columns(); ++j) room[j] = rows(r, j);
  for (int k = 0; k <= degree; ++k) polynomial[k] = sum(product(rows.columns(), room, c + k * stride));
}

BENTUR_FOR_ALL_PROCESSORS
void open_groups(Index n, const double* x, const double* y, Index apart, const double* peak, double rest,
                 double* open) {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  for (Index r = 0; r < n; r += four) {
    const Four most = larger(load(x + r * apart), load(y + r * apart));
    store(open + r, all(any(most > all(rest) * load(peak + r)) ? unknown : 0.0));
  }
}

BENTUR_FOR_ALL_PROCESSORS
void lump(const PackedRows& rows, Index first, Index count, const double* limits, double* largest) {
  for (Index j = first; j < first + count; ++j) {
    Four most = all(0.0);
    for (Index r = 0; r < rows.rows(); r += four) {
      const Four share = size(load(rows.from(r) + four * j)) / load(limits + r);
      most = share > most ? share : most;  // 0/0 is no share
    }
    largest[j - first] = std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
  }
}

BENTUR_FOR_ALL_PROCESSORS
void lowest_of_rows(const PackedRows& rows, const double* start, const double* end, const double* rise, double* lowest,
                    double* beyond) {
  for (Index r = 0; r < rows.rows(); r += four) {
    const Ends at = ends_of_rows(rows.columns(), rows.from(r), start, end, rise);
    store(lowest + r, smaller(at.start, at.end));
    store(beyond + r, at.beyond);
  }
}

BENTUR_FOR_ALL_PROCESSORS
bool reach_of_rows(const PackedRows& rows, const double* start, const double* end, const double* rise, double* peak,
                   const double* reach_before, double* reach) {
  Bits beyond_peak{};
  for (Index r = 0; r < rows.rows(); r += four) {
    const Four before = load(peak + r);
    const Four so_far = load(reach_before + r);
    store(reach + r, so_far);
    if (!any(so_far > before)) continue;
    const Ends at = ends_of_rows(rows.columns(), rows.from(r), start, end, rise);
    const Four most = larger(size(at.start), size(at.end));
    const Four high = larger(before, most);
    store(peak + r, high);
    store(reach + r, most + at.beyond);
    beyond_peak |= most + at.beyond > high;
  }
  return !any(beyond_peak);
}

}  // namespace bentur::engine::kernels
