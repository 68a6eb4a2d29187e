#include "bentur/solve/exact/exact.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "bentur/solve/exact/contacts.h"
#include "bentur/solve/exact/sampler.h"
#include "bentur/solve/exact/walk.h"

namespace bentur {
namespace exact {
namespace {

constexpr double round_off_band = 0x1p-46;  // of the displacements at a point: depth below which nothing is a contact

/// Contact switched off: peak displacements and the gap that would have been needed.
class FreeWalk final : public Walk {
 public:
  FreeWalk(const ModalSystem& system, const Problem& problem, const TimeGrid& grid, FlightTable& flights)
      : Walk(system, problem, grid, flights, PeakWatch::Scope::displacement), needed_(system.points.size(), 0.0) {
    for (std::size_t i = 0; i < needed_.size(); ++i) needed_[i] = std::max(0.0, -system.points[i].sense(state_.q));
  }

  [[nodiscard]] const std::vector<double>& needed() const { return needed_; }

 private:
  [[nodiscard]] bool may_fly() const override { return true; }
  [[nodiscard]] const std::vector<char>& closed() const override { return none_; }

  /// Nothing has to be cut here, so what the bound leaves open is kept, and looked into when the run is over.
  bool quiet(const Flight& flight) override {
    reach_.resize(needed_.size());
    bool settled = true;
    for (std::size_t i = 0; i < needed_.size(); ++i) {
      const auto& point = system_.points[i];
      const double end = -point.sense(next_.q);
      reach_[i] = std::max(-point.sense(state_.q), end) + point.sense_abs(flight.rise());
      needed_[i] = std::max(needed_[i], end);
      settled = settled && reach_[i] <= needed_[i];
    }
    if (!settled) unsettled_.push_back({flight.length(), state_, inputs_, reach_});
    if (unsettled_.size() >= unsettled_limit) settle();
    return true;
  }

  double look(double /*time*/) override {
    raise(state_, next_);
    return 1.0;
  }

  /// Takes the expanded step, from one state to the other, into the gaps needed.
  void raise(const State& from, const State& to) {
    for (std::size_t i = 0; i < needed_.size(); ++i) {
      const auto& point = system_.points[i];
      const double largest = std::max(-point.sense(from.q), -point.sense(to.q));
      if (largest + point.sense_abs(series_.curvature()) / 8.0 <= needed_[i]) continue;
      Polynomial closing = -series_.opening(i);
      closing[0] += point.width;
      double where = 0.0;
      raise_to_maximum(closing, 1.0, needed_[i], where);
    }
  }

  void settle() override {
    for (Unsettled& interval : unsettled_) {
      bool settled = true;
      for (std::size_t i = 0; i < needed_.size(); ++i) settled = settled && interval.reach[i] <= needed_[i];
      if (settled) continue;
      State& from = interval.start;
      State to = from;
      const auto count = std::max(1.0, std::ceil(interval.length * system_.rate(none_) / series_reach));
      const double h = interval.length / count;
      for (double n = 0.0; n < count; n += 1.0) {
        series_.expand(from, interval.inputs, h, none_);
        series_.bound();
        series_.evaluate(1.0, to);
        raise(from, to);
        system_.advance(interval.inputs, h);
        from.q.swap(to.q);
        from.v.swap(to.v);
      }
    }
    unsettled_.clear();
  }

  struct Unsettled {
    double length;  ///< [s]
    State start;
    std::vector<GroundInput> inputs;
    std::vector<double> reach;
  };

  std::vector<double> needed_;  ///< per point, max(0, x_left − x_right) so far [length]
  std::vector<double> reach_;
  std::vector<Unsettled> unsettled_;
  const std::vector<char> none_ = std::vector<char>(system_.points.size(), 0);
};

/// The response with contact.
class PoundingWalk final : public Walk {
 public:
  PoundingWalk(const ModalSystem& system, const Problem& problem, const TimeGrid& grid, FlightTable& flights,
               std::vector<double> tolerances, double output_step)
      : Walk(system, problem, grid, flights, PeakWatch::Scope::everything),
        contacts_(system, problem, std::move(tolerances)),
        sampler_(system, problem, output_step) {}

  Contacts& contacts() { return contacts_; }
  Sampler& sampler() { return sampler_; }

 private:
  [[nodiscard]] bool may_fly() const override { return !contacts_.any_closed(); }
  bool quiet(const Flight& flight) override { return contacts_.clear(state_, next_, flight.rise()); }
  [[nodiscard]] const std::vector<char>& closed() const override { return contacts_.closed(); }

  double look(double time) override {
    time_ = time;
    event_ = contacts_.next_event(series_, state_, next_);
    const double cut = event_ ? event_->s : 1.0;
    contacts_.accumulate(series_, time, cut);
    sampler_.take(series_, time, time + cut * series_.h(), inputs_, contacts_.closed());
    return cut;
  }

  void arrived(double time) override {
    contacts_.note_touches(series_, time_, event_ ? event_->s : 1.0, state_);
    if (event_) contacts_.change(*event_, series_, time);
  }

  void pass(double start, double length) override {
    if (!sampler_.due(start + length)) return;
    State from = state_;
    State to = state_;
    std::vector<GroundInput> inputs = inputs_;
    const auto count = std::max(1.0, std::ceil(length * system_.rate(closed()) / series_reach));
    const double h = length / count;
    for (double n = 0.0; n < count; n += 1.0) {
      series_.expand(from, inputs, h, contacts_.closed());
      sampler_.take(series_, start + n * h, start + (n + 1.0) * h, inputs, contacts_.closed());
      series_.evaluate(1.0, to);
      system_.advance(inputs, h);
      from.q.swap(to.q);
      from.v.swap(to.v);
    }
  }

  Contacts contacts_;
  Sampler sampler_;
  std::optional<Contacts::Event> event_;
  double time_ = 0;  ///< start of the expanded step [s]
};

/// Depth below which nothing counts as a contact, per point.
std::vector<double> tolerances(const Problem& problem, const std::vector<BuildingPeaks>& peaks, const Walk& walk) {
  std::vector<double> result;
  for (const ContactPoint& point : problem.points) {
    const auto left = static_cast<std::size_t>(point.left);
    const double scale = point.width + peaks[left].displacement_no_contact(point.left_floor) +
                         peaks[left + 1].displacement_no_contact(point.right_floor) +
                         walk.largest_ground_displacement(left) + walk.largest_ground_displacement(left + 1);
    result.push_back(round_off_band * scale);
  }
  return result;
}

void summarise(const std::vector<Impact>& impacts, std::vector<PointSummary>& points) {
  for (const Impact& impact : impacts) {
    PointSummary& point = points[static_cast<std::size_t>(impact.point)];
    ++point.impacts;
    point.contact_duration += impact.end - impact.start;
    point.impulse += impact.impulse;
    point.energy_lost += impact.energy_lost;
    point.peak_penetration = std::max(point.peak_penetration, impact.peak_penetration);
    point.peak_closing_speed = std::max(point.peak_closing_speed, impact.closing_speed);
    if (!point.peak_force_time || impact.peak_force > point.peak_force) {
      point.peak_force = impact.peak_force;
      point.peak_force_time = impact.peak_force_time;
    }
  }
}

/// Status and message of a walk that did not get to its end.
void report_end(Response& response, Status status, const Walk& walk) {
  response.status = status;
  if (status == Status::stopped) response.message = "stopped on request";
  if (status == Status::failed) {
    response.message = walk.trouble();
  }
}

}  // namespace
}  // namespace exact

Response solve_exact(const Problem& problem, const ExactOptions& options) {
  validate(problem);
  const auto began = std::chrono::steady_clock::now();
  const exact::ModalSystem system(problem);
  const exact::TimeGrid grid(problem);
  const auto report = [&options](double fraction) { return !options.progress || options.progress(fraction); };

  Response response;
  response.buildings.resize(problem.buildings.size());
  response.points.resize(problem.points.size());

  exact::FlightTable flights = exact::make_flights(system, grid);
  exact::FreeWalk free(system, problem, grid, flights);
  Status status = free.run([&](double fraction) { return report(0.25 * fraction); });
  for (std::size_t b = 0; b < response.buildings.size(); ++b) free.watch().report(b, response.buildings[b]);
  for (std::size_t i = 0; i < response.points.size(); ++i) response.points[i].minimum_gap_no_contact = free.needed()[i];
  if (status != Status::done) {
    exact::report_end(response, status, free);
    return response;
  }

  exact::PoundingWalk pounding(system, problem, grid, flights, exact::tolerances(problem, response.buildings, free),
                               options.output_step);
  status = pounding.run([&](double fraction) { return report(0.25 + 0.75 * fraction); });
  exact::report_end(response, status, pounding);
  pounding.contacts().finish(problem.duration);
  for (std::size_t b = 0; b < response.buildings.size(); ++b) pounding.watch().report(b, response.buildings[b]);
  response.impacts = std::move(pounding.contacts().impacts());
  response.events = pounding.contacts().events();
  response.steps = pounding.steps();
  exact::summarise(response.impacts, response.points);
  pounding.sampler().finish();
  response.histories = std::move(pounding.sampler().histories());
  response.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return response;
}

}  // namespace bentur
