#include "bentur/solve/motion/kernels/flights.h"

#include "bentur/solve/motion/kernels/four.h"

namespace bentur::engine::kernels {
namespace {

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
    const Four all_four = sums_of(positions, accelerations, as_left, as_right);
    return {all_four[0], all_four[1], all_four[2], all_four[3]};
  }
};

}  // namespace

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

}  // namespace bentur::engine::kernels
