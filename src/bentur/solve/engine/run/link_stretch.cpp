#include "bentur/solve/engine/run/link_stretch.h"

#include <boost/math/quadrature/gauss.hpp>

namespace bentur::engine {

Polynomial force_of(const ElementForces::Linear& linear, const Polynomial& deformation, double h) {
  Polynomial force = deformation;
  for (int k = 0; k <= force.degree; ++k) force[k] *= linear.stiffness;
  for (int k = 0; k < force.degree; ++k) force[k] += linear.damping * (k + 1.0) * deformation[k + 1] / h;
  force[0] += linear.base;
  return force;
}

LinkStretch link_stretch(const ElementForces::Linear& linear, const Polynomial& deformation, double h, double end) {
  LinkStretch result;
  if (linear.base == 0.0 && linear.stiffness == 0.0 && linear.damping == 0.0) return result;
  const Polynomial force = force_of(linear, deformation, h);
  double where = 0.0;
  raise_to_maximum(force, end, result.peak_force, where);
  raise_to_maximum(force, end, result.peak_tension, where, -1.0);
  if (linear.damping == 0.0) return result;
  const auto power = [&](double s) {
    const double speed = first_derivative(deformation, s) / h;
    return linear.damping * speed * speed;
  };
  result.damped = h * boost::math::quadrature::gauss<double, 15>::integrate(power, 0.0, end);
  return result;
}

}  // namespace bentur::engine
