#include "bentur/solve/engine/motion/flight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bentur/solve/engine/motion/series.h"

namespace bentur::engine {
namespace {

using Eigen::Index;
using Map = kernels::FlightMap;

/// An error of a map would grow with the number of segments flown by it, so maps are made with more digits.
using Long = long double;

/// The oscillator q̈ + d q̇ + ω²q = γ f, f̈ = −ν²f.
struct Oscillator {
  Long omega_squared, two_sigma, gamma, nu;
};

/// Position, speed, f and ḟ at the end of some time.
using Quadruple = std::array<Long, 4>;
/// The same from a start where one of them is 1: a linear map, column by column.
using Transition = std::array<Quadruple, 4>;

/// By the power series in one step, which series_reach allows.
Quadruple advance(const Oscillator& o, Long h, Quadruple from) {
  std::array<Long, highest_degree + 1> c{from[0], from[1] * h};
  std::array<Long, highest_degree + 1> f{from[2], from[3] * h};
  for (std::size_t k = 0; k + 2 < c.size(); ++k) {
    const Long two = (static_cast<Long>(k) + 2) * (static_cast<Long>(k) + 1);
    const Long step = static_cast<Long>(k) + 1;
    c[k + 2] = (h * h * (o.gamma * f[k] - o.omega_squared * c[k]) - h * o.two_sigma * step * c[k + 1]) / two;
    f[k + 2] = -o.nu * o.nu * h * h * f[k] / two;
  }
  Quadruple to{};
  for (std::size_t k = c.size(); k-- > 0;) {
    to[0] += c[k];
    to[1] += static_cast<Long>(k) * c[k] / h;
    to[2] += f[k];
    to[3] += static_cast<Long>(k) * f[k] / h;
  }
  return to;
}

Transition transition(const Oscillator& oscillator, Long h) {
  Transition columns{};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    Quadruple start{};
    start[i] = 1;
    columns[i] = advance(oscillator, h, start);
  }
  return columns;
}

/// The map of twice the time.
Transition doubled(const Transition& once) {
  Transition twice{};
  for (std::size_t i = 0; i < once.size(); ++i) {
    for (std::size_t j = 0; j < once.size(); ++j) {
      for (std::size_t k = 0; k < once.size(); ++k) twice[i][k] += once[j][k] * once[i][j];
    }
  }
  return twice;
}

}  // namespace

std::vector<Flight> Flight::make(const ModalSystem& system, double length, int halvings) {
  std::vector<Flight> flights;
  for (int n = 0; n <= halvings; ++n) flights.push_back(Flight(system, std::ldexp(length, -n)));
  for (Index j = 0; j < system.size; ++j) {
    for (Index c = 0; c < system.components(); ++c) {
      const Oscillator oscillator{system.omega_squared(j), system.two_sigma(j), system.gamma(j, c), system.nu[c]};
      Transition map = transition(oscillator, flights.back().length_);
      for (auto flight = flights.rbegin(); flight != flights.rend(); ++flight) {
        if (flight != flights.rbegin()) map = doubled(map);
        constexpr Map::Column to_q[] = {Map::qq, Map::qv, Map::qa, Map::qb};
        constexpr Map::Column to_v[] = {Map::vq, Map::vv, Map::va, Map::vb};
        for (std::size_t i = c == 0 ? 0 : 2; i < map.size(); ++i) {
          const Index component = i < 2 ? 0 : c;
          flight->map_(j, to_q[i], component) = static_cast<double>(map[i][0]);
          flight->map_(j, to_v[i], component) = static_cast<double>(map[i][1]);
        }
      }
    }
    if (flights.front().map_.loads.empty()) continue;
    Transition map = transition({system.omega_squared(j), system.two_sigma(j), 1, 0}, flights.back().length_);
    for (auto flight = flights.rbegin(); flight != flights.rend(); ++flight) {
      if (flight != flights.rbegin()) map = doubled(map);
      flight->map_(j, Map::load_q) = static_cast<double>(map[2][0]);
      flight->map_(j, Map::load_v) = static_cast<double>(map[2][1]);
    }
  }
  return flights;
}

/// All but the map itself.
Flight::Flight(const ModalSystem& system, double length)
    : system_(&system), length_(length), map_(system.size, system.components()) {
  const Index components = system_->components();
  const bool linear = system_->fastest_input() == 0.0;
  const double chord = length_ * length_ / 8.0;
  const double curved = linear ? std::pow(length_, 4) / 384.0 : std::numeric_limits<double>::infinity();
  const bool loaded = system.members < system.rubs;
  if (loaded) map_.loads.assign(system_->size * Map::load_columns, 0.0);
  for (Index j = 0; j < system_->size; ++j) {
    const double w2 = system_->omega_squared(j);
    const double d = system_->two_sigma(j);
    const double omega = std::sqrt(w2);
    const double kappa = std::sqrt(w2 + d * d);
    map_(j, Map::omega_squared) = w2;
    map_(j, Map::two_sigma) = d;
    map_(j, Map::omega) = omega;
    map_(j, Map::second) = chord * kappa;
    const double to_fourth = d * (d * kappa + w2) + w2 * kappa;
    map_(j, Map::fourth) = chord * to_fourth;
    map_(j, Map::cubic) = curved * kappa;
    map_(j, Map::acceleration_cubic) = curved * to_fourth;
    const bool stiff = linear && omega * length_ > 1.0;
    for (Index c = 0; c < components; ++c) {
      const double gamma = system_->gamma(j, c);
      const double push = std::abs(gamma);
      const double nu = system_->nu[c];
      map_(j, Map::gamma, c) = gamma;
      if (stiff) {
        map_(j, Map::p_value, c) = gamma / w2;
        map_(j, Map::p_slope, c) = -gamma * d / (w2 * w2);
        map_(j, Map::p_rate, c) = gamma / w2;
      } else {
        map_(j, Map::slow, c) = length_ * push;
        map_(j, Map::second_force, c) = chord * push;
        map_(j, Map::fourth_force, c) = chord * (d * d + w2 + nu * nu) * push;
        map_(j, Map::fourth_slope, c) = chord * d * push;
      }
    }
    if (stiff) {
      // u and ü stay within ±S/Ω and ±κ S: twice that is as far as a chord can be.
      map_(j, Map::second) = std::min(map_(j, Map::second), 2.0 / omega);
      map_(j, Map::fourth) = std::min(map_(j, Map::fourth), 2.0 * kappa);
      if (loaded) map_(j, Map::load_p) = 1.0 / w2;
    } else if (loaded) {
      map_(j, Map::load_slow) = length_;
      map_(j, Map::load_second) = chord;
      map_(j, Map::load_fourth) = chord * (d * d + w2);
    }
  }
}

kernels::FlightInput Flight::input(const GroundInput& ground, double nu) const {
  const GroundInput end = ground.later(length_, nu);
  if (nu > 0.0) {
    const double largest = std::hypot(ground.value, ground.slope / nu);
    return {ground.value, ground.slope, largest, nu * largest, end.value};
  }
  const double largest = std::max(std::abs(ground.value), std::abs(end.value));
  return {ground.value, ground.slope, largest, std::abs(ground.slope), end.value};
}

void Flight::advance(std::size_t b, const GroundInput* ground, const kernels::FlightArrays& arrays) const {
  const auto& block = system_->blocks[b];
  if (system_->nu.size() == 1) {
    return kernels::fly(map_, {block.begin, block.padded_size}, input(*ground, system_->nu.front()), arrays);
  }
  kernels::fly(map_, {block.begin, block.padded_size}, inputs(ground).front(), arrays);
}

std::array<kernels::FlightInput, most_components> Flight::inputs(const GroundInput* ground) const {
  std::array<kernels::FlightInput, most_components> inputs;
  auto* to = inputs.begin();
  for (const double nu : system_->nu) *to++ = input(*ground++, nu);
  return inputs;
}

void Flight::fit_cubics(std::size_t b, const GroundInput* ground, const kernels::CubicArrays& arrays) const {
  const auto& block = system_->blocks[b];
  kernels::fit_cubics(map_, {block.begin, block.padded_size}, length_, inputs(ground).front(), arrays);
}

Flights make_flights(const ModalSystem& system, double length) {
  if (!system.classical) return {};
  const double to_one_series = std::ceil(std::log2(std::max(1.0, length * system.rate({}) / series_reach)));
  return Flight::make(system, length, static_cast<int>(to_one_series));
}

FlightTable make_flights(const ModalSystem& system, const TimeGrid& grid) {
  FlightTable table(grid.kinds());
  for (std::size_t kind = 0; kind < table.size(); ++kind) table[kind] = make_flights(system, grid.length(kind));
  return table;
}

}  // namespace bentur::engine
