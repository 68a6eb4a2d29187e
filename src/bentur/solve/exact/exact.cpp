#include "bentur/solve/exact/exact.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "bentur/solve/exact/contacts.h"
#include "bentur/solve/exact/flight.h"
#include "bentur/solve/exact/peak_watch.h"
#include "bentur/solve/exact/sampler.h"
#include "bentur/solve/exact/series.h"

namespace bentur {
namespace exact {
namespace {

constexpr double round_off_band = 0x1p-46;  // of the displacements at a point: depth below which nothing is a contact
constexpr double end_slack = 1e-9;          // of a segment: a remainder shorter than this is not run
constexpr long events_per_segment_limit = 100000;  // more than this in one record step cannot be a pounding problem
constexpr long segments_between_reports = 256;

struct Numerics {
  std::string trouble;  ///< empty while all is well
  double time = 0;
};

/// What the free response and the response with contact have in common: walking the time grid, whole segments by
/// Flight where nothing can happen in them, the rest by power series.
class Walk {
 public:
  Walk(const ModalSystem& system, const Problem& problem, const TimeGrid& grid, PeakWatch::Scope scope)
      : system_(system), problem_(problem), grid_(grid), watch_(system, scope), series_(system) {
    state_.q = system.initial_q;
    state_.v = system.initial_v;
    next_ = state_;
    watch_.start(state_);
    if (system.classical) {
      for (std::size_t kind = 0; kind < grid.kinds(); ++kind) flights_.emplace_back(system, grid.length(kind));
    }
    largest_ground_.assign(system.blocks.size(), 0.0);
  }
  virtual ~Walk() = default;

  /// Runs to the end of the analysis. `progress(fraction)` returning false stops.
  template <class Progress>
  Status run(const Progress& progress) {
    for (long segment = 0;; ++segment) {
      const double start = grid_.start(segment);
      const std::size_t kind = static_cast<std::size_t>(segment) % grid_.kinds();
      const double left = problem_.duration - start;
      const double length = grid_.length(kind);
      if (left <= end_slack * length) break;
      grid_.input(segment, inputs_);
      const bool whole = left >= length * (1.0 - end_slack);
      if (!(whole && fly(kind, start, length))) walk(start, whole ? length : left);
      if (!numerics_.trouble.empty()) return Status::failed;
      if (unsettled_.size() >= unsettled_limit) scan_unsettled();
      if (segment % segments_between_reports == 0 && !progress(start / problem_.duration)) return Status::stopped;
    }
    scan_unsettled();
    return Status::done;
  }

  [[nodiscard]] const PeakWatch& watch() const { return watch_; }
  [[nodiscard]] const Numerics& numerics() const { return numerics_; }
  [[nodiscard]] long steps() const { return steps_; }
  [[nodiscard]] double largest_ground_displacement(std::size_t b) const { return largest_ground_[b]; }

 protected:
  /// Whether the segment may be flown at all, and whether nothing that the walk looks for happened in it.
  virtual bool may_fly() const { return true; }
  virtual bool quiet(const Flight& flight) = 0;
  /// Looks at the expanded step; returns where it must be cut (1: not at all).
  virtual double look(double time) = 0;
  /// After the state has been moved to the cut.
  virtual void arrived(double /*time*/) {}
  virtual void sample_quiet(double /*start*/, double /*length*/) {}
  [[nodiscard]] virtual double rate() const = 0;
  virtual void expand(double h) = 0;

  const ModalSystem& system_;
  const Problem& problem_;
  const TimeGrid& grid_;
  PeakWatch watch_;
  Series series_;
  State state_, next_;
  std::vector<GroundInput> inputs_;
  Numerics numerics_;
  long steps_ = 0;

 private:
  /// One whole segment by its transition; false (and nothing changed) when something may happen in it.
  bool fly(std::size_t kind, double start, double length) {
    if (!system_.classical || !may_fly()) return false;
    Flight& flight = flights_[kind];
    flight.advance(state_, inputs_, next_);
    if (!quiet(flight)) return false;
    system_.acceleration(state_, inputs_, {}, start_acceleration_);
    end_inputs_ = inputs_;
    system_.advance(end_inputs_, length);
    system_.acceleration(next_, end_inputs_, {}, end_acceleration_);
    for (std::size_t b = 0; b < system_.blocks.size(); ++b) {
      if (!watch_.settled_by_bound(b, state_, next_, start_acceleration_, end_acceleration_, flight.curvature(),
                                   flight.acceleration_curvature(), reach_)) {
        unsettled_.push_back({b, length, state_, inputs_, reach_});
      }
    }
    sample_quiet(start, length);
    state_.q.swap(next_.q);
    state_.v.swap(next_.v);
    after_step(start + length);
    return true;
  }

  /// Looks for peaks in the quiet segments that their bounds had not settled. Peaks only rise, so most are settled by
  /// now.
  void scan_unsettled() {
    for (Unsettled& segment : unsettled_) {
      if (watch_.settled(segment.block, segment.reach)) continue;
      State& from = segment.start;
      const double rate = std::max(system_.blocks[segment.block].rate(), system_.nu);
      const auto count = std::max(1.0, std::ceil(segment.length * rate / series_reach));
      const double h = segment.length / count;
      for (double n = 0.0; n < count; n += 1.0) {
        series_.expand_block(segment.block, from, segment.inputs[segment.block], h);
        series_.evaluate(1.0, next_);
        watch_.scan(segment.block, series_, 1.0, from, next_);
        system_.advance(segment.inputs, h);
        from.q.swap(next_.q);
        from.v.swap(next_.v);
      }
    }
    unsettled_.clear();
  }

  /// One segment (or the last part of one) by power series, cut at events.
  void walk(double start, double length) {
    double elapsed = 0.0;
    long cuts = 0;
    while (elapsed < length && numerics_.trouble.empty()) {
      const double left = length - elapsed;
      double h = series_reach / rate();
      const bool last = h >= left * (1.0 - end_slack);
      if (last) h = left;
      expand(h);
      series_.evaluate(1.0, next_);
      const double time = start + elapsed;
      const double cut = look(time);
      if (cut < 1.0) series_.evaluate(cut, next_);
      for (std::size_t b = 0; b < system_.blocks.size(); ++b) watch_.scan(b, series_, cut, state_, next_);
      elapsed = last && cut == 1.0 ? length : elapsed + cut * h;
      system_.advance(inputs_, cut * h);
      state_.q.swap(next_.q);
      state_.v.swap(next_.v);
      arrived(start + elapsed);
      after_step(start + elapsed);
      if (cut < 1.0 && ++cuts > events_per_segment_limit) {
        numerics_ = {fmt::format("more than {} contacts closed or opened within one step of the ground motion",
                                 events_per_segment_limit),
                     time};
      }
    }
  }

  void after_step(double time) {
    ++steps_;
    if (!state_.q.allFinite() || !state_.v.allFinite()) numerics_ = {"the response is no longer a finite number", time};
    if (problem_.kinematics == Kinematics::absolute) {
      for (std::size_t b = 0; b < system_.blocks.size(); ++b) {
        const Eigen::Index ground = system_.blocks[b].begin + system_.blocks[b].size - 1;
        largest_ground_[b] = std::max(largest_ground_[b], std::abs(state_.q(ground)));
      }
    }
  }

  std::vector<Flight> flights_;
  /// A quiet segment in which one building may have exceeded its peaks.
  struct Unsettled {
    std::size_t block;
    double length;  ///< [s]
    State start;
    std::vector<GroundInput> inputs;
    Eigen::VectorXd reach;
  };
  static constexpr std::size_t unsettled_limit = 4096;

  std::vector<Unsettled> unsettled_;
  Eigen::VectorXd reach_;
  Eigen::VectorXd start_acceleration_, end_acceleration_;
  std::vector<GroundInput> end_inputs_;
  std::vector<double> largest_ground_;
};

/// Contact switched off: peak displacements and the gap that would have been needed.
class FreeWalk final : public Walk {
 public:
  FreeWalk(const ModalSystem& system, const Problem& problem, const TimeGrid& grid)
      : Walk(system, problem, grid, PeakWatch::Scope::displacement), needed_(system.points.size(), 0.0) {
    for (std::size_t i = 0; i < needed_.size(); ++i) needed_[i] = std::max(0.0, -system.points[i].sense(state_.q));
  }

  [[nodiscard]] const std::vector<double>& needed() const { return needed_; }

 private:
  bool quiet(const Flight& flight) override {
    for (std::size_t i = 0; i < needed_.size(); ++i) {
      const auto& point = system_.points[i];
      const double largest = std::max(-point.sense(state_.q), -point.sense(next_.q));
      if (largest + point.sense_abs(flight.curvature()) > needed_[i]) return false;
    }
    return true;
  }

  double look(double /*time*/) override {
    for (std::size_t i = 0; i < needed_.size(); ++i) {
      const auto& point = system_.points[i];
      const double largest = std::max(-point.sense(state_.q), -point.sense(next_.q));
      if (largest + point.sense_abs(series_.curvature()) / 8.0 <= needed_[i]) continue;
      Polynomial closing = series_.opening(i);
      closing[0] -= point.width;
      for (double& coefficient : closing) coefficient = -coefficient;
      double where = 0.0;
      raise_to_maximum(closing, 1.0, needed_[i], where);
    }
    return 1.0;
  }

  [[nodiscard]] double rate() const override { return system_.rate(none_); }
  void expand(double h) override { series_.expand(state_, inputs_, h, none_); }

  std::vector<double> needed_;  ///< per point, max(0, x_left − x_right) so far [length]
  const std::vector<char> none_ = std::vector<char>(system_.points.size(), 0);
};

/// The response with contact.
class PoundingWalk final : public Walk {
 public:
  PoundingWalk(const ModalSystem& system, const Problem& problem, const TimeGrid& grid, std::vector<double> tolerances,
               double output_step)
      : Walk(system, problem, grid, PeakWatch::Scope::everything),
        contacts_(system, problem, std::move(tolerances)),
        sampler_(system, problem, output_step) {}

  Contacts& contacts() { return contacts_; }
  Sampler& sampler() { return sampler_; }

 private:
  [[nodiscard]] bool may_fly() const override { return !contacts_.any_closed(); }
  bool quiet(const Flight& flight) override { return contacts_.clear(state_, next_, flight.curvature()); }
  [[nodiscard]] double rate() const override { return system_.rate(contacts_.closed()); }
  void expand(double h) override { series_.expand(state_, inputs_, h, contacts_.closed()); }

  double look(double time) override {
    event_ = contacts_.next_event(series_, state_, next_);
    const double cut = event_ ? event_->s : 1.0;
    contacts_.accumulate(series_, time, cut);
    sampler_.take(series_, time, time + cut * series_.h(), inputs_, contacts_.closed());
    return cut;
  }

  void arrived(double time) override {
    if (event_) contacts_.change(*event_, series_, time);
  }

  void sample_quiet(double start, double length) override {
    if (!sampler_.due(start + length)) return;
    State from = state_;
    State to = state_;
    std::vector<GroundInput> inputs = inputs_;
    const auto count = std::max(1.0, std::ceil(length * rate() / series_reach));
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
    response.message = fmt::format("{} at t = {:.6g} s", walk.numerics().trouble, walk.numerics().time);
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

  exact::FreeWalk free(system, problem, grid);
  Status status = free.run([&](double fraction) { return report(0.25 * fraction); });
  for (std::size_t b = 0; b < response.buildings.size(); ++b) free.watch().report(b, response.buildings[b]);
  for (std::size_t i = 0; i < response.points.size(); ++i) response.points[i].minimum_gap_no_contact = free.needed()[i];
  if (status != Status::done) {
    exact::report_end(response, status, free);
    return response;
  }

  exact::PoundingWalk pounding(system, problem, grid, exact::tolerances(problem, response.buildings, free),
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
