#include "bentur/solve/walk/peak_watch.h"

#include <algorithm>
#include <limits>

#include "bentur/solve/motion/kernels/series.h"

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int misses_before_lump = 8;  // lumping costs about as much as a look at all rows

}  // namespace

PeakWatch::Rows::Rows(const Eigen::MatrixXd& quantities, Index room, double* lumped_weights)
    : weights(quantities, room), peak(VectorXd::Zero(weights.rows())), lumped(lumped_weights) {
  lump();
}

void PeakWatch::Rows::lump() {
  misses = 0;
  kernels::lump(weights, 0, weights.columns(), peak.data(), lumped);
}

bool PeakWatch::Rows::open(double sum) {
  if (sum <= 1.0) return false;
  if (++misses >= misses_before_lump) lump();
  return true;
}

PeakWatch::PeakWatch(const ModalSystem& system, kernels::Lumped& lumped) : system_(&system) {
  Index most = 0;
  Index most_quantities = 0;
  for (const auto& block : system.blocks) {
    positions_.emplace_back(block.outputs, block.room, lumped.positions.data() + block.begin);
    accelerations_.emplace_back(block.acceleration, block.room, lumped.accelerations.data() + block.begin);
    most = std::max(most, block.room);
    most_quantities = std::max(most_quantities, quantities(positions_.size() - 1));
  }
  samples_.resize(most * (most_parts + 1));
  seconds_.resize(most * (most_parts + 1));
  rise_.setZero(most);
  course_.second_derivatives.resize(most, Course::most + 1);
  for (Ends* ends : {&course_.positions, &course_.accelerations}) {
    ends->values.resize(most_quantities * (Course::most + 1));
    ends->shares.resize(Course::most + 1);
  }
  unknown_.assign(static_cast<std::size_t>(most_quantities), std::numeric_limits<double>::infinity());
}

Index PeakWatch::quantities(std::size_t b) const { return positions_[b].peak.size() + accelerations_[b].peak.size(); }

void PeakWatch::start(const State& state) {
  std::vector<double> reach(unknown_.size());
  for (std::size_t b = 0; b < positions_.size(); ++b) {
    const double* q = state.q.data() + system_->blocks[b].begin;
    (void)kernels::reach_of_rows(positions_[b].weights, q, q, rise_.data(), positions_[b].peak.data(), unknown(),
                                 reach.data());
    positions_[b].lump();
  }
}

VectorXd PeakWatch::peaks() const {
  Index size = 0;
  for (std::size_t b = 0; b < positions_.size(); ++b) size += quantities(b);
  VectorXd all(size);
  Index at = 0;
  for (std::size_t b = 0; b < positions_.size(); ++b) {
    for (const Rows* rows : {&positions_[b], &accelerations_[b]}) {
      all.segment(at, rows->peak.size()) = rows->peak;
      at += rows->peak.size();
    }
  }
  return all;
}

void PeakWatch::resume(const VectorXd& peaks) {
  Index at = 0;
  for (std::size_t b = 0; b < positions_.size(); ++b) {
    for (Rows* rows : {&positions_[b], &accelerations_[b]}) {
      rows->peak = peaks.segment(at, rows->peak.size());
      rows->lump();
      at += rows->peak.size();
    }
  }
}

PeakWatch::Open PeakWatch::open(std::size_t b, const kernels::Sums& sums) {
  return {positions_[b].open(sums.positions), accelerations_[b].open(sums.accelerations)};
}

void PeakWatch::raise(std::size_t b, const Course& course) {
  const auto& block = system_->blocks[b];
  const Index legs = course.legs();
  const auto at = [&block](const VectorXd& x) { return x.data() + block.begin; };
  for (Index n = 0; n <= legs; ++n) {
    const double value = n < legs ? course.input(n, b).value : course.input(n - 1, b).end;
    kernels::accelerate(block.room, at(system_->omega_squared), at(system_->two_sigma), at(system_->gamma), value,
                        course.q(n) + block.begin, course.v(n) + block.begin, course_.second_derivatives.col(n).data());
  }
  kernels::raise_peaks(positions_[b].weights, legs + 1, course.q(0) + block.begin, system_->size,
                       positions_[b].peak.data(), course_.positions.shares.data(), course_.positions.values.data());
  kernels::raise_peaks(accelerations_[b].weights, legs + 1, course_.second_derivatives.data(),
                       course_.second_derivatives.rows(), accelerations_[b].peak.data(),
                       course_.accelerations.shares.data(), course_.accelerations.values.data());
  positions_[b].lump();
  accelerations_[b].lump();
}

PeakWatch::Open PeakWatch::open(std::size_t b, const Course& course, Index leg, double* before) {
  const auto& block = system_->blocks[b];
  const auto look = [&](const Rows& rows, const Ends& ends, const double* rise, double* rows_before) {
    const double between = kernels::dot(block.room, rows.lumped, rise + block.begin);
    if (std::max(ends.shares(leg), ends.shares(leg + 1)) + between <= 1.0) return false;
    const double* at = ends.values.data() + 4 * leg;
    kernels::open_groups(rows.peak.size(), at, at + 4, course.legs() + 1, rows.peak.data(), 1.0 - between, rows_before);
    return true;
  };
  return {look(positions_[b], course_.positions, course.rise(leg), before),
          look(accelerations_[b], course_.accelerations, course.acceleration_rise(leg),
               before + positions_[b].peak.size())};
}

bool PeakWatch::settled_by_bound(std::size_t b, const Interval& at, Open open, const double* before, double* reach) {
  const auto look = [](Rows& rows, bool is_open, const double* start, const double* end, const double* rise,
                       const double* rows_before, double* rows_reach) {
    if (is_open) {
      return kernels::reach_of_rows(rows.weights, start, end, rise, rows.peak.data(), rows_before, rows_reach);
    }
    std::fill_n(rows_reach, rows.peak.size(), 0.0);
    return true;
  };
  const Index first = positions_[b].peak.size();
  const bool positions = look(positions_[b], open.positions, at.start, at.end, at.rise, before, reach);
  const bool accelerations = look(accelerations_[b], open.accelerations, at.start_acceleration, at.end_acceleration,
                                  at.acceleration_rise, before + first, reach + first);
  return positions && accelerations;
}

bool PeakWatch::settled_by_samples(std::size_t b, const Expansion& motion, double end, int parts, const double* before,
                                   double* reach) {
  const auto& block = system_->blocks[b];
  const Index n = block.room;
  const Eigen::MatrixXd& c = motion.coefficients();
  kernels::sample(n, c.data() + block.begin, c.rows(), motion.degree(), parts, end, samples_.data(), seconds_.data());
  const auto look = [&](Rows& rows, const VectorXd& samples, const double* rows_before, double* rows_reach) {
    return kernels::reach_of_samples(rows.weights, parts + 1, samples.data(), rise_.data(), rows.peak.data(),
                                     rows_before, rows_reach);
  };
  const Index first = positions_[b].peak.size();
  const double chord = end * end / (8.0 * parts * parts);
  rise_.head(n) = chord * motion.curvature().segment(block.begin, n);
  const bool positions = look(positions_[b], samples_, before, reach);
  const double rate = 1.0 / (motion.h() * motion.h());
  seconds_.head(n * (parts + 1)) *= rate;
  rise_.head(n) = chord * rate * motion.fourth_derivative().segment(block.begin, n);
  const bool accelerations = look(accelerations_[b], seconds_, before + first, reach + first);
  return positions && accelerations;
}

Index PeakWatch::open(std::size_t b, const double* reach) const {
  const auto above = [](const VectorXd& peak, const double* of) {
    return (Eigen::Map<const Eigen::ArrayXd>(of, peak.size()) > peak.array()).count();
  };
  return above(positions_[b].peak, reach) + above(accelerations_[b].peak, reach + positions_[b].peak.size());
}

void PeakWatch::scan(std::size_t b, const Expansion& motion, const double* reach) {
  const Eigen::MatrixXd& c = motion.coefficients();
  const double* begin = c.data() + system_->blocks[b].begin;
  Polynomial row;
  const auto combine = [&](const Rows& rows, Index r) {
    row.degree = motion.degree();
    kernels::combine(rows.weights, r, begin, c.rows(), row.degree, rise_.data(), row.coefficients.data());
  };
  Rows& positions = positions_[b];
  for (Index r = 0; r < positions.peak.size(); ++r) {
    if (!(reach[r] > positions.peak(r))) continue;
    combine(positions, r);
    raise_to_largest(row, positions.peak(r));
  }
  Rows& accelerations = accelerations_[b];
  for (Index f = 0; f < accelerations.peak.size(); ++f) {
    if (!(reach[positions.peak.size() + f] > accelerations.peak(f))) continue;
    combine(accelerations, f);
    row.degree -= 2;
    for (int k = 0; k <= row.degree; ++k) row[k] = row[k + 2] * ((k + 2.0) * (k + 1.0)) / (motion.h() * motion.h());
    raise_to_largest(row, accelerations.peak(f));
  }
}

void PeakWatch::report(std::size_t b, BuildingPeaks& peaks) const {
  const Index floors = system_->blocks[b].floors;
  const VectorXd& peak = positions_[b].peak;
  peaks.displacement = peak.head(floors);
  peaks.drift_ratio = peak.segment(floors, floors);
  peaks.storey_shear = peak.segment(2 * floors, floors);
  peaks.acceleration = accelerations_[b].peak.head(floors);
}

}  // namespace bentur::engine
