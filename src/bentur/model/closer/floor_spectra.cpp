#include "bentur/model/closer/floor_spectra.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "bentur/model/gap/gap_outcome.h"
#include "bentur/solve/spectrum/response_spectrum.h"

namespace bentur {
namespace {

using Eigen::Index;

/// What the ground gains in speed from the motion's start on. [length/s]
class GroundSpeed {
 public:
  explicit GroundSpeed(const GroundMotion& motion) : motion_(&motion) {
    const auto* sampled = std::get_if<SampledMotion>(&motion);
    if (sampled == nullptr) return;
    speeds_ = {0};
    for (std::size_t i = 0; i + 1 < sampled->acceleration.size(); ++i) {
      speeds_.push_back(speeds_.back() +
                        sampled->time_step * (sampled->acceleration[i] + sampled->acceleration[i + 1]) / 2);
    }
  }

  [[nodiscard]] double at(double t) const {
    if (t <= 0) return 0;
    if (const auto* harmonic = std::get_if<HarmonicMotion>(motion_)) {
      const double omega = 2 * std::numbers::pi / harmonic->period, speed = harmonic->displacement_amplitude * omega;
      return harmonic->phase == HarmonicMotion::Phase::sine ? speed * (std::cos(omega * t) - 1)
                                                            : -speed * std::sin(omega * t);
    }
    const auto* sampled = std::get_if<SampledMotion>(motion_);
    if (sampled == nullptr) return 0;
    const auto before = static_cast<std::size_t>(t / sampled->time_step);
    if (before + 1 >= speeds_.size()) return speeds_.back();
    const double part = t / sampled->time_step - static_cast<double>(before);
    const double from = sampled->acceleration[before], to = sampled->acceleration[before + 1];
    return speeds_[before] + sampled->time_step * part * (from + part * (to - from) / 2);
  }

 private:
  const GroundMotion* motion_;
  std::vector<double> speeds_;  ///< at the samples
};

}  // namespace

std::vector<FloorSpectra::Floor> spectrum_floors(const Problem& problem, const Response& response) {
  constexpr std::size_t most = 6;
  std::vector<FloorSpectra::Floor> floors;
  const auto add = [&](Index building, Index floor) {
    if (problem.buildings[building].is_rigid()) return;
    const auto same = [&](const FloorSpectra::Floor& one) { return one.building == building && one.floor == floor; };
    if (std::none_of(floors.begin(), floors.end(), same)) floors.push_back({.building = building, .floor = floor});
  };
  const auto roof = [&](Index building) { return problem.buildings[building].model.floors() - 1; };
  const Impact* const hardest = hardest_impact(response.impacts);
  if (hardest == nullptr) {
    for (Index b = 0; b < std::ssize(problem.buildings) && floors.size() < most; ++b) add(b, roof(b));
    return floors;
  }
  const ContactPoint& point = problem.points[hardest->point];
  for (const auto& [building, floor] : {std::pair(point.left, point.left_floor), {point.right, point.right_floor}}) {
    add(building, roof(building));
    add(building, problem.buildings[building].model.floor_at_or_above(floor));
  }
  return floors;
}

std::vector<double> spectrum_periods(const std::vector<Eigen::VectorXd>& omegas, double shortest, double longest) {
  constexpr double apart = 0.013;  // of a period: half of it is 13 % of the bandwidth of 5 % damping
  const int count = 2 + static_cast<int>(std::log(longest / shortest) / apart);
  std::vector<double> periods = logarithmic_periods(shortest, longest, count);
  for (const Eigen::VectorXd& of_one : omegas) {
    for (const double omega : of_one) {
      const double period = 2 * std::numbers::pi / omega;
      if (period > shortest && period < longest) periods.push_back(period);
    }
  }
  std::sort(periods.begin(), periods.end());
  constexpr double same = 1e-6;
  periods.erase(std::unique(periods.begin(), periods.end(), [](double a, double b) { return b < a * (1 + same); }),
                periods.end());
  return periods;
}

Eigen::VectorXd ground_speed(const GroundMotion& motion, const std::vector<double>& time, double delay) {
  const GroundSpeed ground(motion);
  Eigen::VectorXd speed(std::ssize(time));
  for (std::size_t i = 0; i < time.size(); ++i) speed(static_cast<Index>(i)) = ground.at(time[i] - delay);
  return speed;
}

SampledMotion mean_acceleration(double step, const Eigen::VectorXd& speed, Index samples) {
  SampledMotion motion{.time_step = static_cast<double>(samples) * step, .acceleration = {0}};
  for (Index i = samples; i < speed.size(); i += samples) {
    motion.acceleration.push_back((speed(i) - speed(i - samples)) / motion.time_step);
  }
  return motion;
}

Eigen::VectorXd floor_speed(const Histories& histories, const Problem& problem, Index building, Index floor) {
  const double delay = problem.delays.empty() ? 0 : problem.delays[building];
  return histories.velocity[building].row(floor).transpose() + ground_speed(problem.motion, histories.time, delay);
}

std::vector<double> floor_spectrum(double step, const Eigen::VectorXd& speed, const std::vector<double>& periods,
                                   double damping) {
  constexpr double to_a_period = 60;
  const auto samples_of = [&](double period) {
    Index samples = 1;
    while (2 * to_a_period * static_cast<double>(samples) * step <= period) samples *= 2;
    return samples;
  };
  std::vector<double> spectrum;
  while (spectrum.size() < periods.size()) {  // those that have the same samples at once
    const auto first = periods.begin() + std::ssize(spectrum);
    const Index samples = samples_of(*first);
    const auto end = std::find_if(first, periods.end(), [&](double period) { return samples_of(period) != samples; });
    const std::vector<double> found =
        pseudo_accelerations_at_samples(mean_acceleration(step, speed, samples), {first, end}, damping);
    spectrum.insert(spectrum.end(), found.begin(), found.end());
  }
  return spectrum;
}

}  // namespace bentur
