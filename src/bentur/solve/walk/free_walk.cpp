#include "bentur/solve/walk/free_walk.h"

#include <algorithm>

namespace bentur::engine {
namespace {

constexpr std::size_t most_unsettled = 4096;  // flights kept at a time

}  // namespace

FreeWalk::FreeWalk(const Ground& ground)
    : Walk(ground, PeakWatch::Scope::displacement),
      no_force_([](const State&, const std::vector<GroundInput>&, Eigen::VectorXd& forces) { forces.resize(0); }),
      openings_(system_),
      needed_(system_.points.size(), 0.0) {
  for (std::size_t i = 0; i < needed_.size(); ++i) needed_[i] = std::max(0.0, -system_.points[i].sense(state_.q));
  openings_.limit(needed_);
}

/// Nothing has to be cut here, so what the bound leaves open is kept, and looked into when the run is over.
bool FreeWalk::quiet(const Flights& flights, std::size_t halvings, const Flight::Bounds& bounds) {
  if (openings_.stay_open(state_, next_, bounds)) return true;
  reach_.resize(needed_.size());
  bool settled = true;
  bool raised = false;
  for (std::size_t i = 0; i < needed_.size(); ++i) {
    const auto& point = system_.points[i];
    const double end = -point.sense(next_.q);
    reach_[i] = std::max(-point.sense(state_.q), end) + point.sense_abs(bounds.rise);
    raised = raised || end > needed_[i];
    needed_[i] = std::max(needed_[i], end);
    settled = settled && reach_[i] <= needed_[i];
  }
  if (raised) openings_.limit(needed_);
  if (!settled) unsettled_.push_back({flights[halvings].length(), state_, inputs_, reach_});
  if (unsettled_.size() >= most_unsettled) settle();
  return true;
}

double FreeWalk::look(double /*time*/) {
  raise(state_, next_);
  return 1.0;
}

/// Takes the expanded step, from one state to the other, into the gaps needed. Points have no width here.
void FreeWalk::raise(const State& from, const State& to) {
  for (std::size_t i = 0; i < needed_.size(); ++i) {
    const auto& point = system_.points[i];
    const double largest = std::max(-point.sense(from.q), -point.sense(to.q));
    if (largest + point.sense_abs(motion_.curvature()) / 8.0 <= needed_[i]) continue;
    double where = 0.0;
    raise_to_maximum(-motion_.opening(i), 1.0, needed_[i], where);
  }
}

void FreeWalk::settle() {
  for (const Unsettled& interval : unsettled_) {
    bool settled = true;
    for (std::size_t i = 0; i < needed_.size(); ++i) settled = settled && interval.reach[i] <= needed_[i];
    if (settled) continue;
    replay(interval.start, interval.inputs, interval.length,
           [this](double, const State& from, const auto&, const State& to) {
             (void)motion_.bound();
             raise(from, to);
           });
  }
  unsettled_.clear();
}

}  // namespace bentur::engine
