#include "bentur/pounding/internal/after_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>

#include "bentur/pounding/problem.h"

namespace bentur {
namespace {

using Eigen::Index;

/// 2π/ω₁ of the slowest body that has one [s]; 0: none has.
double slowest_period(const System& system) {
  double longest = 0;
  for (const Body& body : system.bodies) {
    if (!body.is_rigid() && body.modes.omega(0) > 0)
      longest = std::max(longest, 2 * std::numbers::pi / body.modes.omega(0));
  }
  return longest;
}

/// Of records the shortest step [s]; 0 where nothing is sampled.
double step_of(const System& system) {
  double least = std::numeric_limits<double>::infinity();
  for (const GroundMotion& motion : system.motions) {
    if (const auto* sampled = std::get_if<SampledMotion>(&motion)) least = std::min(least, sampled->time_step);
  }
  return std::isfinite(least) ? least : 0.0;
}

/// When the last value of a record but zero is over at every body [s]; 0 where nothing is sampled.
double end_of_records(const System& system) {
  double latest = 0;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) latest = std::max(latest, system.delay(b));
  double end = 0;
  for (const GroundMotion& motion : system.motions) {
    const auto* const sampled = std::get_if<SampledMotion>(&motion);
    if (sampled == nullptr) continue;
    const std::vector<double>& values = sampled->acceleration;
    const auto last = std::find_if(values.rbegin(), values.rend(), [](double value) { return value != 0; });
    const auto count = std::min<std::ptrdiff_t>(values.rend() - last, std::ssize(values) - 1);  // down to the next zero
    if (last != values.rend()) end = std::max(end, static_cast<double>(count) * sampled->time_step + latest);
  }
  return end;
}

bool goes_on_after(const System& system) { return end_of_records(system) > system.duration * (1 + 1e-12); }

bool some_yield(const System& system) {
  return std::any_of(system.bodies.begin(), system.bodies.end(),
                     [](const Body& one) { return !one.elements.empty() || !one.coupled.empty(); });
}

/// Whether a bound says little, of what yields or is tied to others, and the run has gone on as long as any does.
bool has_gone_on(const System& system) {
  const double longest = most_periods_after * slowest_period(system);
  return motion_ends(system) && (some_yield(system) || !system.joints.empty()) &&
         system.duration + step_of(system) >= end_of_records(system) + longest;
}

/// Whether no δ, nor where the response is mirrored −δ, can go farther than it has from so long after the end on.
bool is_over(const Solution& free, bool mirrored, double after) {
  constexpr double round_off = 1e-9;
  for (std::size_t i = 0; i < free.to_come.size(); ++i) {
    const ToCome& one = free.to_come[i];
    if (!one.known) continue;
    const std::size_t contacts = free.needed.size();
    const double needed = i < contacts ? free.needed[i] : free.watched[i - contacts].reach;
    if (one.most(after) > (1 + round_off) * needed) return false;
    if (mirrored && i < free.watched_free.size() &&
        one.most(after, -1) > (1 + round_off) * free.watched_free[i].reach) {
      return false;
    }
  }
  return true;
}

/// How long after the end something larger can still come [s], in steps of the motion.
double time_after(const System& system, const Solution& free, bool mirrored) {
  const double longest = most_periods_after * slowest_period(system), step = step_of(system);
  const bool yields = some_yield(system);
  if (longest == 0 || step == 0 || (!yields && is_over(free, mirrored, 0))) return 0;
  double from = 0, to = longest;
  // What yields on is no longer where it is bound to swing.
  if (!yields && is_over(free, mirrored, longest)) {
    while (to - from > step) {
      const double middle = 0.5 * (from + to);
      (is_over(free, mirrored, middle) ? to : from) = middle;
    }
  }
  return std::ceil(to / step) * step;
}

/// Hands each point and what is watched over with what is to come there.
template <class Take>
void take_all(const std::vector<ToCome>& all, const std::vector<Index>& places, std::vector<PointSummary>& points,
              std::vector<WatchedSummary>& watched, const Take& take) {
  const std::size_t contacts = places.empty() ? points.size() : places.size();
  for (std::size_t i = 0; i < contacts; ++i) {
    const Index at = places.empty() ? static_cast<Index>(i) : places[i];
    if (at >= 0) take(all[i], points[static_cast<std::size_t>(at)]);
  }
  for (std::size_t i = 0; i < watched.size(); ++i) take(all[contacts + i], watched[i]);
}

}  // namespace

bool motion_ends(const System& system) {
  return std::none_of(system.motions.begin(), system.motions.end(),
                      [](const GroundMotion& motion) { return std::holds_alternative<HarmonicMotion>(motion); });
}

FreeSolution free_solution(System system, const Solver& solver, const std::function<bool(double)>& progress,
                           const RunLimits& limits, bool goes_on) {
  if (goes_on && goes_on_after(system)) {
    const double step = step_of(system);
    system.duration = std::ceil(end_of_records(system) / step - 1e-9) * step;
  }
  FreeSolution free(system, solver, progress, limits);
  if (!goes_on || free.solution().status != Status::done || !motion_ends(system)) return free;
  const double more = time_after(system, free.solution(), is_mirrored(system));
  if (more == 0) return free;
  system.duration += more;
  return FreeSolution(std::move(system), solver, progress, limits);
}

void take_to_come(const FreeSolution& free, const std::vector<Index>& places, std::vector<PointSummary>& points,
                  std::vector<WatchedSummary>& watched) {
  const System& system = free.system();
  if (free.solution().status != Status::done || has_gone_on(system)) return;
  const std::vector<ToCome>& all = free.solution().to_come;
  const bool mirrored = is_mirrored(system);
  const bool is_cut = goes_on_after(system), ends = motion_ends(system);
  const auto take = [&](const ToCome& one, auto& summary) {
    const bool is_open = is_cut || (!one.known && !ends);
    if (is_open) summary.to_come = summary.to_come_reversed = std::numeric_limits<double>::infinity();
    if (!one.known || is_open) return;
    summary.to_come = std::max(0.0, one.most(0));
    if (mirrored) summary.to_come_reversed = std::max(0.0, one.most(0, -1));
  };
  take_all(all, places, points, watched, take);
}

void take_to_come_struck(const Solution& with, const std::vector<Index>& places, std::vector<PointSummary>& points,
                         std::vector<WatchedSummary>& watched) {
  const bool touch =
      std::any_of(with.impacts.begin(), with.impacts.end(), [](const Impact& one) { return one.open_ended; });
  const auto take = [&](const ToCome& one, auto& summary) {
    summary.to_come_struck.reset();
    if (one.known) summary.to_come_struck = std::max(0.0, one.most(0));
    if (touch) summary.to_come_struck = std::numeric_limits<double>::infinity();
  };
  const std::vector<ToCome>& all = with.to_come;
  if (all.size() < points.size() + watched.size()) return;
  take_all(all, places, points, watched, take);
}

}  // namespace bentur
