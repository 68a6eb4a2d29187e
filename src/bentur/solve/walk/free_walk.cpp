#include "bentur/solve/walk/free_walk.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace bentur::engine {
namespace {

constexpr std::size_t most_unsettled = 4096;  // flights kept at a time

}  // namespace

FreeWalk::FreeWalk(const Ground& ground)
    : Walk(ground),
      no_force_([](const State&, const std::vector<GroundInput>&, Eigen::VectorXd& forces) { forces.resize(0); }),
      openings_(system_, lumped_),
      needed_(system_.points.size(), 0.0) {
  for (std::size_t i = 0; i < needed_.size(); ++i) needed_[i] = std::max(0.0, -system_.points[i].sense(state_.q));
  openings_.limit(needed_);
  run_.reaches.resize(needed_.size());
  for (std::size_t i = 0; i < needed_.size(); ++i) run_.reaches[i].push_back({0, needed_[i]});
}

/// To be told of how far a point reaches in the segment under way.
void FreeWalk::reach(std::size_t i, double reach) {
  auto& reaches = run_.reaches[i];
  if (reach <= reaches.back().reach) return;
  if (reaches.back().segment == segment()) reaches.pop_back();
  reaches.push_back({segment(), reach});
}

/// Nothing has to be cut here, so what the bound leaves open is kept, and looked into when the run is over.
bool FreeWalk::quiet(const Flown& flown) {
  openings_.look(flown.q, flown.q_end, flown.rise);
  reach_.resize(needed_.size());
  bool settled = true;
  bool raised = false;
  for (std::size_t i = 0; i < needed_.size(); ++i) {
    const double end = -openings_.lowest(i);
    reach_[i] = end + openings_.beyond(i);
    reach(i, reach_[i]);
    raised = raised || end > needed_[i];
    needed_[i] = std::max(needed_[i], end);
    settled = settled && reach_[i] <= needed_[i];
  }
  if (raised) openings_.limit(needed_);
  if (!settled) {
    const auto all = [this](const double* x) { return Eigen::Map<const Eigen::VectorXd>(x, system_.size); };
    unsettled_.push_back({flown.flight.length(), {all(flown.q), all(flown.v)}, inputs_, reach_});
  }
  if (unsettled_.size() >= most_unsettled) settle();
  return true;
}

double FreeWalk::look(double /*time*/) {
  raise(state_, next_);
  for (std::size_t i = 0; i < needed_.size(); ++i) reach(i, needed_[i]);
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

FreeRun FreeWalk::take_run() {
  run_.needed = needed_;
  return std::move(run_);
}

long first_contact(const FreeRun& run, const std::vector<double>& widths) {
  long first = std::numeric_limits<long>::max();
  for (std::size_t i = 0; i < widths.size(); ++i) {
    if (widths[i] > run.needed[i]) continue;
    const auto& reaches = run.reaches[i];
    const auto found = std::lower_bound(reaches.begin(), reaches.end(), widths[i],
                                        [](const FreeRun::Reach& at, double width) { return at.reach < width; });
    if (found != reaches.end()) first = std::min(first, found->segment);
  }
  return first;
}

}  // namespace bentur::engine
