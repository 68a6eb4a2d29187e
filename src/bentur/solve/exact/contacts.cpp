#include "bentur/solve/exact/contacts.h"

#include <algorithm>
#include <tuple>

namespace bentur::exact {
namespace {

/// An event is where the opening leaves the round-off band; the impact is dated from where the opening became zero.
double last_touch(const Polynomial& opening, double event) {
  double largest = 0.0;
  double where = 0.0;
  if (!raise_to_maximum(opening, event, largest, where)) return 0.0;
  return root(opening, where, event);
}

}  // namespace

Contacts::Contacts(const ModalSystem& system, const Problem& problem, std::vector<double> tolerances)
    : system_(&system),
      problem_(&problem),
      tolerances_(std::move(tolerances)),
      closed_(system.points.size(), 0),
      under_way_(system.points.size()) {}

bool Contacts::clear(const State& from, const State& to, const Eigen::VectorXd& rise) const {
  for (const auto& point : system_->points) {
    const double lowest = point.width + std::min(point.sense(from.q), point.sense(to.q));
    if (lowest <= 0.0 || lowest <= point.sense_abs(rise)) return false;
  }
  return true;
}

std::optional<Contacts::Event> Contacts::next_event(const Series& series, const State& from, const State& to) const {
  std::optional<Event> first;
  for (std::size_t i = 0; i < closed_.size(); ++i) {
    const auto& point = system_->points[i];
    std::optional<double> s;
    if (closed_[i]) {
      s = first_negative(-series.opening(i));
    } else {
      const double lowest = point.width + std::min(point.sense(from.q), point.sense(to.q));
      if (lowest > point.sense_abs(series.curvature()) / 8.0) continue;
      Polynomial opening = series.opening(i);
      opening[0] += tolerances_[i];
      s = first_negative(opening);
    }
    if (s && (!first || *s < first->s)) first = Event{i, *s};
  }
  return first;
}

void Contacts::accumulate(const Series& series, double time, double end) {
  if (closed_count_ == 0) return;
  for (std::size_t i = 0; i < closed_.size(); ++i) {
    if (!closed_[i]) continue;
    const Polynomial depth = -series.opening(i);
    const ContactLaw& law = *problem_->points[i].law;
    Impact& impact = under_way_[i];
    double where = 0.0;
    if (raise_to_maximum(depth, end, impact.peak_penetration, where)) {
      impact.peak_force = law.force(impact.peak_penetration, 0.0);
      impact.peak_force_time = time + where * series.h();
    }
    impact.impulse += law.stiffness() * integral(depth, end) * series.h();
  }
}

void Contacts::change(const Event& event, const Series& series, double time) {
  const std::size_t i = event.point;
  const Polynomial opening = series.opening(i);
  ++events_;
  if (closed_[i]) {
    under_way_[i].end = time;
    under_way_[i].separation_speed = first_derivative(opening, event.s) / series.h();
    impacts_.push_back(under_way_[i]);
    closed_[i] = 0;
    --closed_count_;
  } else {
    const double touch = last_touch(opening, event.s);
    under_way_[i] = Impact{};
    under_way_[i].point = static_cast<int>(i);
    under_way_[i].start = time - (event.s - touch) * series.h();
    under_way_[i].closing_speed = -first_derivative(opening, touch) / series.h();
    under_way_[i].peak_force_time = time;
    closed_[i] = 1;
    ++closed_count_;
  }
}

void Contacts::finish(double time) {
  for (std::size_t i = 0; i < closed_.size(); ++i) {
    if (!closed_[i]) continue;
    under_way_[i].end = time;
    under_way_[i].open_ended = true;
    impacts_.push_back(under_way_[i]);
  }
  std::sort(impacts_.begin(), impacts_.end(),
            [](const Impact& a, const Impact& b) { return std::tie(a.start, a.point) < std::tie(b.start, b.point); });
}

}  // namespace bentur::exact
