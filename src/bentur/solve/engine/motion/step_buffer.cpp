#include "bentur/solve/engine/motion/step_buffer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bentur::engine {
namespace {

using Eigen::Index;

constexpr double whole_slack = 1e-9;  // of a segment: one that ends so little after the analysis is whole
constexpr double jump_slack = 1e-14;  // of ground accelerations: less is round-off

}  // namespace

FlightPlan::FlightPlan(const ModalSystem& system, const TimeGrid& grid, double duration, bool exact)
    : flights(exact ? make_flights(system, grid) : FlightTable(grid.kinds())) {
  if (flights.front().empty()) return;
  const std::size_t ways = system.nu.size();
  const auto periods = static_cast<std::size_t>(duration / grid.start(1, 0));
  inputs.reserve((periods + 1) * grid.kinds() * system.blocks.size() * ways);
  std::vector<GroundInput> ground;
  for (long period = 0;; ++period) {
    for (std::size_t kind = 0; kind < flights.size(); ++kind, ++segments) {
      const double left = duration - grid.start(period, kind);
      if (left < grid.length(kind) * (1.0 - whole_slack)) {
        if (left > grid.length(kind) * whole_slack) rest = make_flights(system, left);
        return;
      }
      grid.input(period, kind, ground);
      bool jumps_here = false;
      for (std::size_t body = 0; body < system.blocks.size(); ++body) {
        if (const std::size_t like = grid.first_with(body); like < body) {
          const std::size_t end = inputs.size();
          inputs.resize(end + ways);
          std::copy_n(inputs.begin() + static_cast<std::ptrdiff_t>(end - (body - like) * ways), ways,
                      inputs.begin() + static_cast<std::ptrdiff_t>(end));
          continue;
        }
        for (std::size_t c = 0; c < ways; ++c) {
          const GroundInput& input = ground[body * ways + c];
          inputs.push_back(flights[kind].front().input(input, system.nu[c]));
          if (segments == 0) continue;
          const kernels::FlightInput& before = inputs[inputs.size() - 1 - ground.size()];
          jumps_here = jumps_here || std::abs(input.value - before.end) > jump_slack * before.largest;
        }
      }
      if (jumps_here) jumps.push_back(segments);
    }
  }
}

StepBuffer::StepBuffer(const ModalSystem& system, const FlightPlan& plan)
    : system_(&system), plan_(&plan), input_count_(std::ssize(system.blocks) * system.components()) {
  for (const auto& block : system.blocks) ranges_.push_back({block.begin, block.padded_size});
  if (plan.segments > 0) {
    for (int twice = 0; twice < 2; ++twice) {
      for (const Flights& flights : plan.flights) maps_.push_back(&flights.front().map());
    }
  }
  for (auto* columns : {&q_, &v_, &acceleration_, &rise_, &acceleration_rise_}) columns->resize(system.size, most + 1);
  steps_.resize(most);
  inputs_.resize(most * input_count_);
}

void StepBuffer::clear() {
  last_ = -1;
  joined_ = false;
  kept_count_ = 0;
}

/// Where the start of the next step is to be noted: nowhere (false) if that is known.
bool StepBuffer::next_instant() {
  if (joined_) return false;
  joined_ = true;
  ++last_;
  if (last_ > 0) {  // after a jump, from where the last step ended
    const Index jump = last_ - 1;
    steps_[jump] = {};
    steps_[jump].segment = jump > 0 ? steps_[jump - 1].segment : 0;
    rise_.col(last_ - 1).setZero();
    acceleration_rise_.col(last_ - 1).setZero();
  }
  return true;
}

bool StepBuffer::go_on(const State& state) {
  if (!joined_) return false;
  q_.col(last_) = state.q;
  v_.col(last_) = state.v;
  return true;
}

void StepBuffer::begin(const State& state, const std::vector<GroundInput>& inputs, const double* load) {
  load_ = load;
  if (!next_instant()) return;
  q_.col(last_) = state.q;
  v_.col(last_) = state.v;
  system_->acceleration(state, inputs, no_forces_, start_acceleration_);
  if (load != nullptr) start_acceleration_ += Eigen::Map<const Eigen::VectorXd>(load, system_->size);
  acceleration_.col(last_) = start_acceleration_;
}

/// Of the step that starts at the last instant.
void StepBuffer::note_inputs(const std::vector<GroundInput>& inputs) {
  std::copy(inputs.begin(), inputs.end(), inputs_.begin() + last_ * std::ssize(inputs));
}

void StepBuffer::fly_on(long segment, Index count) {
  const std::size_t kind = segment % plan_->flights.size();
  kernels::fly_on(
      {ranges_, std::span(maps_).subspan(kind, plan_->flights.size()), plan_->inputs.data() + segment * input_count_,
       system_->size, q_.col(last_).data(), v_.col(last_).data(), acceleration_.col(last_).data(),
       rise_.col(last_).data(), acceleration_rise_.col(last_).data(), load_},
      count);
}

void StepBuffer::accept(long segment, Index count) {
  const kernels::FlightInput* input = plan_->inputs.data() + segment * input_count_;
  auto at = inputs_.begin() + last_ * input_count_;
  std::size_t kind = segment % plan_->flights.size();
  for (const Index end = last_ + count; last_ < end; ++last_, ++segment) {
    const Flights& flights = plan_->flights[kind];
    if (++kind == plan_->flights.size()) kind = 0;
    Step& step = steps_[last_];
    step.segment = segment;
    step.flights = &flights;
    step.halvings = 0;
    step.length = flights.front().length();
    step.offset = 0.0;
    for (Index n = 0; n < input_count_; ++n, ++input) *at++ = {input->value, input->slope};
  }
}

void StepBuffer::fly(const Flights& flights, std::size_t halvings, const std::vector<GroundInput>& inputs) {
  const kernels::FlightArrays arrays{q_.col(last_).data(),
                                     v_.col(last_).data(),
                                     q_.col(last_ + 1).data(),
                                     v_.col(last_ + 1).data(),
                                     acceleration_.col(last_ + 1).data(),
                                     rise_.col(last_).data(),
                                     acceleration_rise_.col(last_).data(),
                                     load_};
  for (std::size_t b = 0; b < ranges_.size(); ++b) {
    flights[halvings].advance(b, system_->of_body(inputs, b), arrays);
  }
}

void StepBuffer::accept(long segment, double offset, const Flights& flights, std::size_t halvings,
                        const std::vector<GroundInput>& inputs) {
  note_inputs(inputs);
  steps_[last_] = {segment, &flights, halvings, flights[halvings].length(), offset, 0, 0, 0, 0};
  ++last_;
}

void StepBuffer::add(long segment, double offset, const SeriesStep& taken) {
  Expansion& motion = taken.motion;
  const auto copy = [this](Eigen::MatrixXd& columns, const double* x) {
    std::copy_n(x, system_->size, columns.col(last_).data());
  };
  const auto note = [this](Eigen::MatrixXd& columns, const double* x, double factor) {
    double* to = columns.col(last_).data();
    for (Index j = 0; j < system_->size; ++j) to[j] = factor * x[j];
  };
  if (next_instant()) {
    copy(q_, taken.from.q.data());
    copy(v_, taken.from.v.data());
    note(acceleration_, std::as_const(motion).coefficients().col(2).data(), 2.0 / (motion.h() * motion.h()));
  }
  note_inputs(taken.inputs);
  steps_[last_] = {segment,   nullptr,         0,          taken.cut * motion.h(), offset, motion.h(),
                   taken.cut, motion.degree(), kept_count_};
  if (kept_count_ == kept_.size()) {
    kept_.push_back({Eigen::MatrixXd(system_->size, highest_degree + 1),
                     FlagsOfFours(static_cast<std::size_t>(system_->size) / 4, 1)});
  }
  motion.give_coefficients(kept_[kept_count_++]);
  const double part = taken.cut * taken.cut;
  note(rise_, motion.rise().data(), part);
  note(acceleration_rise_, motion.acceleration_rise().data(), part);
  ++last_;
  copy(q_, taken.to.q.data());
  copy(v_, taken.to.v.data());
  copy(acceleration_, taken.acceleration.data());
}

}  // namespace bentur::engine
