#include "bentur/solve/engine/run/impact_log.h"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <tuple>

#include "bentur/solve/engine/run/link_stretch.h"

namespace bentur::engine {
namespace {

using Gauss = boost::math::quadrature::gauss<double, 15>;  // exact to degree 29; a step spans less than 2.6/rate

using ShortGauss = boost::math::quadrature::gauss<double, 7>;  // on the steps of an embedded pair, which are shorter

double depth(const ImpactLog::Stretch& stretch, double s) { return value(stretch.penetration, s); }
double closing_speed(const ImpactLog::Stretch& stretch, double s) {
  return first_derivative(stretch.penetration, s) / stretch.h;
}

/// Raises the peaks of penetration and force of a spring alone: both are where δ is largest.
void raise_peaks_of_spring(const ImpactLog::Stretch& at, const Branch& branch, Impact& impact) {
  double lowest = std::max(-branch.base / branch.stiffness, 0.0);  // deeper counts
  lowest = std::max(lowest, std::min(impact.peak_penetration, (impact.peak_force - branch.base) / branch.stiffness));
  double where = 0.0;
  if (!raise_to_maximum(at.penetration, at.end, lowest, where)) return;
  impact.peak_penetration = std::max(impact.peak_penetration, lowest);
  const double force = branch.base + branch.stiffness * lowest;
  if (force > impact.peak_force) {
    impact.peak_force = force;
    impact.peak_force_time = at.time + where * at.h;
  }
}

/// F = base + k δ + c δ̇: everything is a polynomial.
void accumulate_linear(const ImpactLog::Stretch& at, const Branch& branch, Impact& impact) {
  if (branch.damping == 0.0 && branch.stiffness > 0.0) {
    raise_peaks_of_spring(at, branch, impact);
  } else {
    double where = 0.0;
    raise_to_maximum(at.penetration, at.end, impact.peak_penetration, where);
    const Polynomial force = force_of({branch.base, branch.stiffness, branch.damping}, at.penetration, at.h);
    if (raise_to_maximum(force, at.end, impact.peak_force, where)) impact.peak_force_time = at.time + where * at.h;
    double pull = std::max(impact.peak_tension, at.force_band);
    if (raise_to_maximum(force, at.end, pull, where, -1.0)) impact.peak_tension = pull;
  }
  const double start = at.penetration[0];
  const double end = depth(at, at.end);
  impact.impulse += (branch.base * at.end + branch.stiffness * integral(at.penetration, at.end)) * at.h +
                    branch.damping * (end - start);
  // What goes in and is not stored: of the spring nothing, unless the law stores less than it takes.
  const auto kept = [&](double d) {
    return 0.5 * branch.stiffness * d * d + branch.base * d - at.law.stored_energy(at.state, d);
  };
  impact.energy_lost += kept(end) - kept(start);
  if (branch.damping != 0.0) {
    const auto power = [&](double s) { return closing_speed(at, s) * closing_speed(at, s); };
    impact.energy_lost += branch.damping * at.h * Gauss::integrate(power, 0.0, at.end);
  }
}

void accumulate_nonlinear(const ImpactLog::Stretch& at, Impact& impact) {
  const auto force = [&](double s) { return at.law.force(at.state, depth(at, s), closing_speed(at, s)); };
  // As stored energy is what force(δ, 0) takes in, the rest is lost.
  const double half = 0.5 * at.end;
  const auto add = [&](double s, double weight) {
    const double d = depth(at, s);
    const double speed = closing_speed(at, s);
    const double f = at.law.force(at.state, d, speed);
    impact.impulse += weight * f;
    impact.energy_lost += weight * (f - at.law.force(at.state, d, 0.0)) * speed;
  };
  for (std::size_t n = 0; n < ShortGauss::abscissa().size(); ++n) {
    const double x = ShortGauss::abscissa()[n];
    const double weight = half * at.h * ShortGauss::weights()[n];
    add(half * (1.0 + x), weight);
    if (x != 0.0) add(half * (1.0 - x), weight);
  }

  // The peak: the force has one turning point in a step at most, as steps are short against a contact.
  constexpr std::size_t samples = 5;
  std::array<double, samples> f{};
  const auto place = [&](std::size_t n) { return at.end * static_cast<double>(n) / (samples - 1.0); };
  for (std::size_t n = 0; n < samples; ++n) f[n] = force(place(n));
  const std::size_t best = std::max_element(f.begin(), f.end()) - f.begin();
  const std::size_t low = best == 0 ? 0 : best - 1;
  const std::size_t high = std::min(best + 1, samples - 1);
  if (f[best] + std::max(f[best] - f[low], f[best] - f[high]) <= impact.peak_force) return;
  double top = f[best];
  double where = place(best);
  constexpr int bits = 26;  // of the place; the value is then known to twice as many
  const auto [s, minus] =
      boost::math::tools::brent_find_minima([&](double x) { return -force(x); }, place(low), place(high), bits);
  if (-minus > top) {
    top = -minus;
    where = s;
  }
  if (top > impact.peak_force) {
    impact.peak_force = top;
    impact.peak_force_time = at.time + where * at.h;
  }
}

}  // namespace

ImpactLog::ImpactLog(std::size_t points) : under_way_(points), before_(points, none) {}

void ImpactLog::begin(Eigen::Index point, double start, double closing_speed, double stored) {
  Impact& impact = under_way_[point] = Impact{};
  impact.point = point;
  impact.start = start;
  impact.peak_force_time = start;
  impact.closing_speed = closing_speed;
  (before_[point] == none ? impact : impacts_[before_[point]]).energy_lost -= stored;
}

void ImpactLog::end(Eigen::Index point, double time, double separation_speed) {
  Impact& impact = under_way_[point];
  impact.end = time;
  impact.separation_speed = separation_speed;
  before_[point] = impacts_.size();
  impacts_.push_back(impact);
}

void ImpactLog::accumulate(Eigen::Index point, const Stretch& stretch) {
  Impact& impact = under_way_[point];
  const Branch branch = stretch.law.branch(stretch.state);
  if (branch.linear) {
    accumulate_linear(stretch, branch, impact);
  } else {
    double where = 0.0;
    raise_to_maximum(stretch.penetration, stretch.end, impact.peak_penetration, where);
    accumulate_nonlinear(stretch, impact);
  }
}

double ImpactLog::rub(Eigen::Index point, const Stretch& at, const Along& along) {
  const CoupledBranch& branch = along.branch;
  const CoupledSet& set = *branch.set;
  if (set.moving.size() < 2) return 0.0;
  Polynomial force = force_of({branch.base(1), set.stiffness(1, 0), set.damping.size() > 0 ? set.damping(1, 0) : 0.0},
                              at.penetration, at.h);
  for (int k = 0; k <= along.slip.degree; ++k) force[k] += set.stiffness(1, 1) * along.slip[k];
  Impact& impact = under_way_[point];
  double where = 0.0;
  raise_to_maximum(force, at.end, impact.peak_tangential_force, where);
  raise_to_maximum(force, at.end, impact.peak_tangential_force, where, -1.0);
  impact.tangential_impulse += integral(force, at.end) * at.h;
  const auto power = [&](double s) { return value(force, s) * first_derivative(along.slip, s); };
  impact.friction_loss += Gauss::integrate(power, 0.0, at.end);
  const double last = value(force, at.end);
  if (along.slides != 0) {
    const double springs = (last - force[0]) / along.tangential_stiffness;
    impact.sliding += along.slides * (value(along.slip, at.end) - along.slip[0] - springs);
  }
  return last;
}

void ImpactLog::rest(Eigen::Index point, const Polynomial& force, double h, double time, double end) {
  Impact& impact = under_way_[point];
  double where = 0.0;
  if (raise_to_maximum(force, end, impact.peak_force, where)) impact.peak_force_time = time + where * h;
  impact.impulse += integral(force, end) * h;
}

void ImpactLog::finish(const std::vector<Branch>& branches, double time) {
  for (Eigen::Index i = 0; i < std::ssize(branches); ++i) {
    if (!branches[i].touching()) continue;
    under_way_[i].open_ended = true;
    end(i, time, 0.0);
  }
  std::sort(impacts_.begin(), impacts_.end(), [](const Impact& a, const Impact& b) {
    return std::tie(a.start, a.point, a.end) < std::tie(b.start, b.point, b.end);
  });
}

}  // namespace bentur::engine
