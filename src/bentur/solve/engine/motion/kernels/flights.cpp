#include "bentur/solve/engine/motion/kernels/flights.h"

#include "bentur/solve/engine/motion/kernels/four.h"

namespace bentur::engine::kernels {
namespace {

struct Input {
  Four value, slope, largest, steepest, end;
  BENTUR_INLINE explicit Input(const FlightInput& in)
      : value(all(in.value)),
        slope(all(in.slope)),
        largest(all(in.largest)),
        steepest(all(in.steepest)),
        end(all(in.end)) {}
};

/// Flies four coordinates from j on (flight.h).
BENTUR_INLINE void fly_four(const double* table, Index j, const Input& in, const FlightArrays& arrays) {
  const auto at = [row = table + j * FlightMap::columns](FlightMap::Column column) __attribute__((always_inline)) {
    return load(row + column * four);
  };
  using enum FlightMap::Column;
  const Four q_start = load(arrays.q + j);
  const Four v_start = load(arrays.v + j);
  const Four q = (at(qq) * q_start + at(qv) * v_start) + (at(qa) * in.value + at(qb) * in.slope);
  const Four v = (at(vq) * q_start + at(vv) * v_start) + (at(va) * in.value + at(vb) * in.slope);
  const Four du = v_start - at(p_rate) * in.slope;
  const Four u = at(omega) * (q_start - (at(p_value) * in.value + at(p_slope) * in.slope));
  const Four s = root(du * du + u * u) + at(slow) * in.largest;
  store(arrays.q_end + j, q);
  store(arrays.v_end + j, v);
  store(arrays.acceleration_end + j, in.end * at(gamma) - at(omega_squared) * q - at(two_sigma) * v);
  store(arrays.rise + j, at(second) * s + at(second_force) * in.largest);
  store(arrays.acceleration_rise + j,
        at(fourth) * s + (at(fourth_force) * in.largest + at(fourth_slope) * in.steepest));
}

BENTUR_INLINE void fly_building(const double* table, CoordinateRange range, const FlightInput& input,
                                const FlightArrays& arrays) {
  const Input in(input);
  for (Index j = range.begin; j < range.begin + range.size; j += four) fly_four(table, j, in, arrays);
}

}  // namespace

BENTUR_FOR_ALL_PROCESSORS
void fly(const FlightMap& map, CoordinateRange range, const FlightInput& input, const FlightArrays& arrays) {
  fly_building(map.table.data(), range, input, arrays);
}

BENTUR_FOR_ALL_PROCESSORS
void fly_on(const FlightSequence& sequence, Index count) {
  std::size_t kind = 0;
  const FlightInput* input = sequence.inputs;
  for (Index n = 0; n < count; ++n) {
    const Index at = n * sequence.stride;
    const Index end = at + sequence.stride;
    const FlightArrays arrays{sequence.q + at,
                              sequence.v + at,
                              sequence.q + end,
                              sequence.v + end,
                              sequence.acceleration + end,
                              sequence.rise + at,
                              sequence.acceleration_rise + at};
    const double* table = sequence.maps[kind]->table.data();
    if (++kind == sequence.maps.size()) kind = 0;
    for (const CoordinateRange& range : sequence.ranges) fly_building(table, range, *input++, arrays);
  }
}

}  // namespace bentur::engine::kernels
