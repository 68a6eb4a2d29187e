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

/// What acts beside one component of the ground's motion.
enum class Also { nothing, load, components };

/// Flies four coordinates from j on (flight.h). `in` is of the first of `inputs`; of several components there may be a
/// load too.
template <Also also>
BENTUR_INLINE void fly_four(const FlightMap& map, Index j, const Input& in, const FlightInput* inputs,
                            const FlightArrays& arrays) {
  constexpr bool several = also == Also::components;
  const auto at = [row = map.table.data() + j * (several ? map.width : Index{FlightMap::columns})](Index column)
      __attribute__((always_inline)) {
    return load(row + column * four);
  };
  using enum FlightMap::Column;
  const Four q_start = load(arrays.q + j);
  const Four v_start = load(arrays.v + j);
  Four q = (at(qq) * q_start + at(qv) * v_start) + (at(qa) * in.value + at(qb) * in.slope);
  Four v = (at(vq) * q_start + at(vv) * v_start) + (at(va) * in.value + at(vb) * in.slope);
  Four particular = at(p_value) * in.value + at(p_slope) * in.slope;
  Four rate = at(p_rate) * in.slope;
  Four slow_force = at(slow) * in.largest;
  Four second_rise = at(second_force) * in.largest;
  Four fourth_rise = at(fourth_force) * in.largest + at(fourth_slope) * in.steepest;
  Four pushed = in.end * at(gamma);
  if constexpr (several) {
    for (Index c = 1; c < map.components; ++c) {
      const Input by(inputs[c]);
      const Index on = c * of_component;
      q += at(on + qa) * by.value + at(on + qb) * by.slope;
      v += at(on + va) * by.value + at(on + vb) * by.slope;
      particular += at(on + p_value) * by.value + at(on + p_slope) * by.slope;
      rate += at(on + p_rate) * by.slope;
      slow_force += at(on + slow) * by.largest;
      second_rise += at(on + second_force) * by.largest;
      fourth_rise += at(on + fourth_force) * by.largest + at(on + fourth_slope) * by.steepest;
      pushed += by.end * at(on + gamma);
    }
  }
  if (also == Also::load || (several && arrays.load != nullptr)) {
    using enum FlightMap::LoadColumn;
    const auto of_load = [row = map.loads.data() + j * FlightMap::load_columns](FlightMap::LoadColumn column)
        __attribute__((always_inline)) {
      return load(row + column * four);
    };
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
  const Four du = v_start - rate;
  const Four u = at(omega) * (q_start - particular);
  const Four s = root(du * du + u * u) + slow_force;
  store(arrays.q_end + j, q);
  store(arrays.v_end + j, v);
  store(arrays.acceleration_end + j, pushed - at(omega_squared) * q - at(two_sigma) * v);
  store(arrays.rise + j, at(second) * s + second_rise);
  store(arrays.acceleration_rise + j, at(fourth) * s + fourth_rise);
}

template <Also also>
BENTUR_INLINE void fly_body(const FlightMap& map, CoordinateRange range, const FlightInput* inputs,
                            const FlightArrays& arrays) {
  const Input in(*inputs);
  for (Index j = range.begin; j < range.begin + range.size; j += four) fly_four<also>(map, j, in, inputs, arrays);
}

template <Also also>
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
    for (const CoordinateRange& range : sequence.ranges) {
      fly_body<also>(map, range, input, arrays);
      input += also == Also::components ? map.components : 1;
    }
  }
}

BENTUR_INLINE void fit_four(const FlightMap& map, Index j, double length, const FlightInput* inputs,
                            const CubicArrays& arrays) {
  using enum FlightMap::Column;
  const auto at = [row = map.table.data() + j * map.width](Index column) __attribute__((always_inline)) {
    return load(row + column * four);
  };
  Four pushed = all(0.0);
  for (Index c = 0; c < map.components; ++c) pushed += at(gamma + c * of_component) * all(inputs[c].slope);
  const auto jerk_at = [&](const double* v, const double* acceleration) __attribute__((always_inline)) {
    return pushed - at(omega_squared) * load(v + j) - at(two_sigma) * load(acceleration + j);
  };
  const Four jerk = jerk_at(arrays.v, arrays.acceleration);
  const Four jerk_end = jerk_at(arrays.v_end, arrays.acceleration_end);
  const Four swing = at(omega) * load(arrays.acceleration + j);
  const Four s = root(jerk * jerk + swing * swing);
  /// Of the cubic with slopes `by` and `by_end` [1/s] and the chord the one that is known to be nearer.
  const auto fit = [&](Four departure, double* rise, const double* start, const double* end, Four by, Four by_end,
                       double* slope, double* slope_end) __attribute__((always_inline)) {
    const Four chord = load(end + j) - load(start + j);
    const Four of_chord = load(rise + j);
    const Bits nearer = departure < of_chord;  // not what cannot be compared
    store(rise + j, nearer ? departure : of_chord);
    store(slope + j, nearer ? all(length) * by : chord);
    store(slope_end + j, nearer ? all(length) * by_end : chord);
  };
  fit(at(cubic) * s, arrays.rise, arrays.q, arrays.q_end, load(arrays.v + j), load(arrays.v_end + j), arrays.slope,
      arrays.slope_end);
  fit(at(acceleration_cubic) * s, arrays.acceleration_rise, arrays.acceleration, arrays.acceleration_end, jerk,
      jerk_end, arrays.acceleration_slope, arrays.acceleration_slope_end);
}

}  // namespace

BENTUR_FOR_ALL_PROCESSORS
void fit_cubics(const FlightMap& map, CoordinateRange range, double length, const FlightInput& input,
                const CubicArrays& arrays) {
  for (Index j = range.begin; j < range.begin + range.size; j += four) fit_four(map, j, length, &input, arrays);
}

BENTUR_FOR_ALL_PROCESSORS
void fly(const FlightMap& map, CoordinateRange range, const FlightInput& input, const FlightArrays& arrays) {
  if (map.components > 1) return fly_body<Also::components>(map, range, &input, arrays);
  if (arrays.load != nullptr) return fly_body<Also::load>(map, range, &input, arrays);
  fly_body<Also::nothing>(map, range, &input, arrays);
}

BENTUR_FOR_ALL_PROCESSORS
void fly_on(const FlightSequence& sequence, Index count) {
  if (sequence.maps.front()->components > 1) return fly_all<Also::components>(sequence, count);
  if (sequence.load != nullptr) return fly_all<Also::load>(sequence, count);
  fly_all<Also::nothing>(sequence, count);
}

}  // namespace bentur::engine::kernels
