#include "bentur/solve/engine/tangent/peak_places.h"

#include <algorithm>
#include <cmath>

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double same_peak = 1e-6;       // of a peak: what is nearer is as large
constexpr double same_peak_time = 1e-7;  // of the duration
constexpr double short_of = 1e-9;        // of a peak: what is less below it may be it
constexpr double bulge = 0.3;            // of the steeper end times the length, by which a curve rises above both
constexpr Index samples = 8;             // of a power series, between which its slope changes sign once at most
constexpr int halvings = 60;

double at(const VectorXd& c, double s) {
  double sum = 0.0;
  for (Index k = c.size(); k-- > 0;) sum = sum * s + c(k);
  return sum;
}

double slope_at(const VectorXd& c, double s) {
  double sum = 0.0;
  for (Index k = c.size(); k-- > 1;) sum = sum * s + static_cast<double>(k) * c(k);
  return sum;
}

}  // namespace

PeakPlaces::PeakPlaces(const TangentRun::Setup& setup, const std::vector<Sought>& sought, bool thorough)
    : setup_(setup),
      sought_(&sought),
      thorough_(thorough),
      rows_(std::ssize(sought), setup.modal.size),
      places_(sought.size()),
      step_(setup.modal, setup.by) {
  for (Index i = 0; i < rows_.rows(); ++i) rows_.row(i) = sought[i].row;
}

bool PeakPlaces::all() const {
  return std::all_of(places_.begin(), places_.end(), [](const Place& place) { return place.time >= 0.0; });
}

/// Two that are as large are told of, unless they are one that ends a stretch and begins the next.
void PeakPlaces::note(Index i, double time, double value) {
  const Sought& sought = (*sought_)[i];
  const double size = sought.of_size ? std::abs(value) : value;
  if (size < sought.peak * (1.0 - same_peak)) return;
  Place& place = places_[i];
  const double best = sought.of_size ? std::abs(place.value) : place.value;
  const bool apart = place.time >= 0.0 && std::abs(place.time - time) > same_peak_time * setup_.system.duration;
  if (apart) place.is_equalled = true;
  if (place.time < 0.0 || size > best) {
    place.time = time;
    place.value = value;
  }
}

void PeakPlaces::take(const TangentRun::Stretch& stretch, const TangentState& to) {
  const double h = stretch.length;
  from_.noalias() = rows_ * stretch.from.q;
  to_.noalias() = rows_ * to.q;
  from_rate_.noalias() = rows_ * stretch.from.v;
  to_rate_.noalias() = rows_ * to.v;
  open_.clear();
  for (Index i = 0; i < rows_.rows(); ++i) {
    const Sought& sought = (*sought_)[i];
    const auto may = [&](double sign) {
      const double ends = std::max(sign * (from_(i) + sought.offset), sign * (to_(i) + sought.offset));
      const double steep = std::max({sign * from_rate_(i), -sign * to_rate_(i), 0.0});
      return ends + bulge * h * steep >= sought.peak * (1.0 - short_of);
    };
    if (thorough_ || may(1.0) || (sought.of_size && may(-1.0))) open_.push_back(i);
  }
  if (!open_.empty()) look_into(stretch);
}

void PeakPlaces::look_into(const TangentRun::Stretch& stretch) {
  const double longest = step_.longest(stretch.pressing);
  const auto parts = std::max(1L, std::lround(std::ceil(2.0 * stretch.length / longest)));
  const double h = stretch.length / static_cast<double>(parts);
  TangentState state{stretch.from.q, stretch.from.v, {}, {}};
  TangentInputs inputs{stretch.inputs.inputs, {}, {}};
  VectorXd c;
  for (long n = 0; n < parts; ++n) {
    step_.advance(state, inputs, stretch.pressing, setup_.laws.offsets, h);
    inputs.advance(setup_.modal, setup_.by, h);
    const double start = stretch.start + static_cast<double>(n) * h;
    for (const Index i : open_) {
      c = (rows_.row(i) * step_.coefficients()).transpose();
      c(0) += (*sought_)[i].offset;
      double before = slope_at(c, 0.0);
      for (Index k = 1; k <= samples; ++k) {
        const double end = static_cast<double>(k) / static_cast<double>(samples);
        const double after = slope_at(c, end);
        double low = end - 1.0 / static_cast<double>(samples), high = end;
        const double sign = before > 0.0 ? 1.0 : -1.0;
        if (before != 0.0 && sign * after <= 0.0 && (sign > 0.0 || (*sought_)[i].of_size)) {
          for (int m = 0; m < halvings; ++m) {
            const double middle = 0.5 * (low + high);
            (sign * slope_at(c, middle) > 0.0 ? low : high) = middle;
          }
          note(i, start + high * h, at(c, high));
        }
        before = after;
      }
    }
  }
}

void PeakPlaces::take_event(double time, const TangentState& before, const TangentState& after) {
  for (Index i = 0; i < rows_.rows(); ++i) {
    const double rate = rows_.row(i).dot(before.v), later = rows_.row(i).dot(after.v);
    const double value = rows_.row(i).dot(before.q) + (*sought_)[i].offset;
    if ((rate > 0.0 && later <= 0.0 && value > 0.0) || (rate < 0.0 && later >= 0.0 && value < 0.0)) {
      note(i, time, value);
    }
  }
}

void PeakPlaces::take_end(double time, const TangentState& state) {
  for (Index i = 0; i < rows_.rows(); ++i) note(i, time, rows_.row(i).dot(state.q) + (*sought_)[i].offset);
}

}  // namespace bentur::engine
