#include "bentur/solve/exact/contacts.h"

#include <algorithm>
#include <tuple>

namespace bentur::exact {
namespace {

/// Where in [0, end] the opening, which ends in the round-off band, came down to zero; nothing if it was never above.
std::optional<double> last_touch(const Polynomial& opening, double end) {
  double largest = 0.0;
  double where = 0.0;
  if (!raise_to_maximum(opening, end, largest, where)) return std::nullopt;
  if (where >= end || value(opening, end) >= 0.0) return end;  // zero to within round-off
  return root(opening, where, end);
}

}  // namespace

Contacts::Contacts(const ModalSystem& system, const Problem& problem, std::vector<double> tolerances)
    : system_(&system),
      problem_(&problem),
      tolerances_(std::move(tolerances)),
      closed_(system.points.size(), 0),
      touches_(system.points.size()),
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

void Contacts::note_touches(const Series& series, double time, double end, const State& state) {
  for (std::size_t i = 0; i < closed_.size(); ++i) {
    if (closed_[i]) continue;
    const auto& point = system_->points[i];
    if (point.width + point.sense(state.q) > 0.0) {
      touches_[i] = {};
      continue;
    }
    const Polynomial opening = series.opening(i);
    const auto touch = last_touch(opening, end);
    if (!touch && touches_[i].time >= 0.0) continue;  // in the band since an earlier step
    const double s = touch.value_or(0.0);
    touches_[i] = {time + s * series.h(), -first_derivative(opening, s) / series.h()};
  }
}

void Contacts::change(const Event& event, const Series& series, double time) {
  const std::size_t i = event.point;
  ++events_;
  if (closed_[i]) {
    under_way_[i].end = time;
    under_way_[i].separation_speed = first_derivative(series.opening(i), event.s) / series.h();
    impacts_.push_back(under_way_[i]);
    closed_[i] = 0;
    --closed_count_;
  } else {
    under_way_[i] = Impact{};
    under_way_[i].point = static_cast<int>(i);
    under_way_[i].start = touches_[i].time;
    under_way_[i].closing_speed = touches_[i].closing_speed;
    touches_[i] = {};
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
