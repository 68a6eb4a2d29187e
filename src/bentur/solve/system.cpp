#include "bentur/solve/system.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "bentur/contact/laws/rubbing.h"

namespace bentur {
namespace {

bool rests(const std::vector<Eigen::VectorXd>& initial) {
  return std::all_of(initial.begin(), initial.end(), [](const auto& x) { return x.isZero(0.0); });
}

bool starts_from_rest(const System& system) {
  return rests(system.initial_displacement) && rests(system.initial_velocity);
}

}  // namespace

bool is_shaken(const System& system) {
  return std::any_of(system.motions.begin(), system.motions.end(),
                     [](const GroundMotion& motion) { return !std::holds_alternative<NoMotion>(motion); });
}

bool is_mirrored(const System& system) {
  const auto all_odd = [](const auto& elements) {
    return std::all_of(elements.begin(), elements.end(), [](const auto& one) { return one.law->is_odd(); });
  };
  return is_shaken(system) && starts_from_rest(system) && all_odd(system.joints) &&
         std::all_of(system.bodies.begin(), system.bodies.end(),
                     [&](const Body& body) { return all_odd(body.elements) && all_odd(body.coupled); });
}

bool is_homogeneous(const System& system) {
  return starts_from_rest(system) && system.limits.empty() &&
         std::all_of(system.joints.begin(), system.joints.end(),
                     [](const Element& joint) { return joint.law->is_homogeneous(); }) &&
         std::all_of(system.bodies.begin(), system.bodies.end(),
                     [](const Body& body) { return body.elements.empty() && body.coupled.empty(); });
}

bool are_homogeneous(const std::vector<Contact>& contacts, const std::vector<RubbingContact>& rubbing) {
  return std::all_of(contacts.begin(), contacts.end(), [](const Contact& one) { return one.law->is_homogeneous(); }) &&
         std::all_of(rubbing.begin(), rubbing.end(),
                     [](const RubbingContact& one) { return one.law->normal().is_homogeneous(); });
}

std::optional<double> times(const std::vector<GroundMotion>& motions, const std::vector<GroundMotion>& others) {
  constexpr double round_off = 1e-14;  // of the largest acceleration of a motion
  if (motions.size() != others.size()) return std::nullopt;
  double peak = 0, other_peak = 0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const auto* const one = std::get_if<SampledMotion>(&motions[i]);
    const auto* const other = std::get_if<SampledMotion>(&others[i]);
    if (one == nullptr || other == nullptr || one->time_step != other->time_step) return std::nullopt;
    if (one->acceleration.size() != other->acceleration.size()) return std::nullopt;
    if (peak_acceleration(motions[i]) <= peak) continue;
    peak = peak_acceleration(motions[i]);
    other_peak = peak_acceleration(others[i]);
  }
  const double factor = peak / other_peak;
  if (!(factor > 0.0) || !std::isfinite(factor)) return std::nullopt;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const std::vector<double>& a = std::get<SampledMotion>(motions[i]).acceleration;
    const std::vector<double>& b = std::get<SampledMotion>(others[i]).acceleration;
    const double least = round_off * peak_acceleration(motions[i]);
    const bool alike = std::equal(a.begin(), a.end(), b.begin(),
                                  [&](double x, double y) { return std::abs(x - factor * y) <= least; });
    if (!alike) return std::nullopt;
  }
  return factor;
}

}  // namespace bentur
