#include "bentur/solve/motion/course.h"

#include <algorithm>
#include <cmath>

namespace bentur::engine {
namespace {

using Eigen::Index;

constexpr double whole_slack = 1e-9;  // of a segment: one that ends so little after the analysis is whole
constexpr double jump_slack = 1e-14;  // of ground accelerations: less is round-off

}  // namespace

FlightPlan::FlightPlan(const ModalSystem& system, const TimeGrid& grid, double duration, bool exact)
    : flights(exact ? make_flights(system, grid) : FlightTable(grid.kinds())) {
  if (flights.front().empty()) return;
  std::vector<GroundInput> ground;
  for (;; ++segments) {
    const std::size_t kind = static_cast<std::size_t>(segments) % flights.size();
    if (duration - grid.start(segments) < grid.length(kind) * (1.0 - whole_slack)) return;
    grid.input(segments, ground);
    bool jumps_here = false;
    for (const GroundInput& input : ground) {
      inputs.push_back(flights[kind].front().input(input));
      if (segments == 0) continue;
      const kernels::FlightInput& before = inputs[inputs.size() - 1 - ground.size()];
      jumps_here = jumps_here || std::abs(input.value - before.end) > jump_slack * before.largest;
    }
    if (jumps_here) jumps.push_back(segments);
  }
}

Course::Course(const ModalSystem& system, const FlightPlan& plan) : system_(&system), plan_(&plan) {
  for (const auto& block : system.blocks) rooms_.push_back({block.begin, block.room});
  if (plan.segments == 0) return;
  for (int twice = 0; twice < 2; ++twice) {
    for (const Flights& flights : plan.flights) maps_.push_back(&flights.front().map());
  }
  for (auto* columns : {&q_, &v_, &rise_, &acceleration_rise_}) {
    columns->resize(system.size, most + 1);
  }
}

void Course::begin(const State& state, long segment) {
  first_ = segment;
  legs_ = 0;
  q_.col(0) = state.q;
  v_.col(0) = state.v;
}

long Course::fly_on(long count, const kernels::Lumped& lumped) {
  const auto kind = static_cast<std::size_t>(segment(legs_)) % plan_->flights.size();
  const Index n = legs_;
  const kernels::Legs legs{rooms_,
                           std::span(maps_).subspan(kind, plan_->flights.size()),
                           &input(n, 0),
                           system_->size,
                           q_.col(n).data(),
                           v_.col(n).data(),
                           rise_.col(n).data(),
                           acceleration_rise_.col(n).data()};
  const Index flown = kernels::fly_on(legs, std::min<Index>(count, most - n), lumped);
  legs_ += flown;
  return flown;
}

}  // namespace bentur::engine
