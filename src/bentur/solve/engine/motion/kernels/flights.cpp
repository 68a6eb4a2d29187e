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
BENTUR_INLINE void fly_four(const double* table, Index j, const Input& in, const Leg& leg) {
  const auto at = [row = table + j * FlightMap::columns](FlightMap::Column column) __attribute__((always_inline)) {
    return load(row + column * four);
  };
  using enum FlightMap::Column;
  const Four q_start = load(leg.q + j);
  const Four v_start = load(leg.v + j);
  const Four q = (at(qq) * q_start + at(qv) * v_start) + (at(qa) * in.value + at(qb) * in.slope);
  const Four v = (at(vq) * q_start + at(vv) * v_start) + (at(va) * in.value + at(vb) * in.slope);
  const Four du = v_start - at(p_rate) * in.slope;
  const Four u = at(omega) * (q_start - (at(p_value) * in.value + at(p_slope) * in.slope));
  const Four s = root(du * du + u * u) + at(slow) * in.largest;
  store(leg.q_end + j, q);
  store(leg.v_end + j, v);
  store(leg.acceleration_end + j, in.end * at(gamma) - at(omega_squared) * q - at(two_sigma) * v);
  store(leg.rise + j, at(second) * s + at(second_force) * in.largest);
  store(leg.acceleration_rise + j, at(fourth) * s + (at(fourth_force) * in.largest + at(fourth_slope) * in.steepest));
}

BENTUR_INLINE void fly_building(const double* table, Room room, const FlightInput& input, const Leg& leg) {
  const Input in(input);
  for (Index j = room.begin; j < room.begin + room.size; j += four) fly_four(table, j, in, leg);
}

}  // namespace

BENTUR_FOR_ALL_PROCESSORS
void fly(const FlightMap& map, Room room, const FlightInput& input, const Leg& leg) {
  fly_building(map.table.data(), room, input, leg);
}

BENTUR_FOR_ALL_PROCESSORS
void fly_on(const Legs& legs, Index count) {
  std::size_t kind = 0;
  const FlightInput* input = legs.inputs;
  for (Index n = 0; n < count; ++n) {
    const Index at = n * legs.stride;
    const Index end = at + legs.stride;
    const Leg leg{legs.q + at,
                  legs.v + at,
                  legs.q + end,
                  legs.v + end,
                  legs.acceleration + end,
                  legs.rise + at,
                  legs.acceleration_rise + at};
    const double* table = legs.maps[kind]->table.data();
    if (++kind == legs.maps.size()) kind = 0;
    for (const Room& room : legs.rooms) fly_building(table, room, *input++, leg);
  }
}

}  // namespace bentur::engine::kernels
