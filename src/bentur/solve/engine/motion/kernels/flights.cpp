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
template <bool loaded>
BENTUR_INLINE void fly_four(const FlightMap& map, Index j, const Input& in, const FlightArrays& arrays) {
  const auto at = [row = map.table.data() + j * FlightMap::columns](FlightMap::Column column)
      __attribute__((always_inline)) {
    return load(row + column * four);
  };
  const auto of_load = [row = loaded ? map.loads.data() + j * FlightMap::load_columns
                                     : nullptr](FlightMap::LoadColumn column) __attribute__((always_inline)) {
    return load(row + column * four);
  };
  using enum FlightMap::Column;
  const Four q_start = load(arrays.q + j);
  const Four v_start = load(arrays.v + j);
  Four q = (at(qq) * q_start + at(qv) * v_start) + (at(qa) * in.value + at(qb) * in.slope);
  Four v = (at(vq) * q_start + at(vv) * v_start) + (at(va) * in.value + at(vb) * in.slope);
  Four particular = at(p_value) * in.value + at(p_slope) * in.slope;
  Four slow_force = at(slow) * in.largest;
  Four second_rise = at(second_force) * in.largest;
  Four fourth_rise = at(fourth_force) * in.largest + at(fourth_slope) * in.steepest;
  Four pushed = in.end * at(gamma);
  if constexpr (loaded) {
    using enum FlightMap::LoadColumn;
    const Four by = load(arrays.load + j);
    const Four most = abs(by);
    q += of_load(load_q) * by;
    v += of_load(load_v) * by;
    particular += of_load(load_p) * by;
    slow_force += of_load(load_slow) * most;
    second_rise += of_load(load_second) * most;
    fourth_rise += of_load(load_fourth) * most;
    pushed += by;
  }
  const Four du = v_start - at(p_rate) * in.slope;
  const Four u = at(omega) * (q_start - particular);
  const Four s = root(du * du + u * u) + slow_force;
  store(arrays.q_end + j, q);
  store(arrays.v_end + j, v);
  store(arrays.acceleration_end + j, pushed - at(omega_squared) * q - at(two_sigma) * v);
  store(arrays.rise + j, at(second) * s + second_rise);
  store(arrays.acceleration_rise + j, at(fourth) * s + fourth_rise);
}

template <bool loaded>
BENTUR_INLINE void fly_body(const FlightMap& map, CoordinateRange range, const FlightInput& input,
                            const FlightArrays& arrays) {
  const Input in(input);
  for (Index j = range.begin; j < range.begin + range.size; j += four) fly_four<loaded>(map, j, in, arrays);
}

template <bool loaded>
BENTUR_INLINE void fly_all(const FlightSequence& sequence, Index count) {
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
                              sequence.acceleration_rise + at,
                              sequence.load};
    const FlightMap& map = *sequence.maps[kind];
    if (++kind == sequence.maps.size()) kind = 0;
    for (const CoordinateRange& range : sequence.ranges) fly_body<loaded>(map, range, *input++, arrays);
  }
}

}  // namespace

BENTUR_FOR_ALL_PROCESSORS
void fly(const FlightMap& map, CoordinateRange range, const FlightInput& input, const FlightArrays& arrays) {
  if (arrays.load != nullptr) return fly_body<true>(map, range, input, arrays);
  fly_body<false>(map, range, input, arrays);
}

BENTUR_FOR_ALL_PROCESSORS
void fly_on(const FlightSequence& sequence, Index count) {
  if (sequence.load != nullptr) return fly_all<true>(sequence, count);
  fly_all<false>(sequence, count);
}

}  // namespace bentur::engine::kernels
