#include "bentur/solve/solution.h"

#include <cmath>

namespace bentur {
namespace {

void scale(Sampled& sampled, double by) {
  for (Eigen::MatrixXd* of : {&sampled.ground_acceleration, &sampled.opening, &sampled.force, &sampled.slip,
                              &sampled.force_along, &sampled.joint_deformation, &sampled.joint_force}) {
    *of *= by;
  }
}

/// Energies are products of two lengths, speeds or forces.
void scale(EnergyAudit& energy, double by) {
  const double squared = by * by;
  energy.peak_input *= squared;
  energy.residual *= squared;
  EnergyHistories& of = energy.histories;
  for (Eigen::VectorXd* history :
       {&of.input, &of.kinetic, &of.strain, &of.damping, &of.hysteretic, &of.contact_stored, &of.contact_lost}) {
    *history *= squared;
  }
}

void scale(Impact& impact, double by) {
  for (double* of :
       {&impact.closing_speed, &impact.separation_speed, &impact.peak_force, &impact.peak_penetration, &impact.impulse,
        &impact.peak_tension, &impact.peak_tangential_force, &impact.tangential_impulse, &impact.sliding}) {
    *of *= by;
  }
  impact.energy_lost *= by * by;
  impact.friction_loss *= by * by;
}

}  // namespace

double ToCome::most(double t, double sign) const {
  double sum = sign * rest;
  for (const Fading& one : fading) sum += one.size * std::exp(-one.rate * t);
  return sum;
}

Solution scaled(Solution solution, double factor) {
  for (std::vector<OutputsFound>& body : solution.outputs) {
    for (OutputsFound& found : body) {
      found.peak *= factor;
      found.history *= factor;
      found.course *= factor;
    }
  }
  for (Impact& impact : solution.impacts) scale(impact, factor);
  for (ElementFound& joint : solution.joints) {
    joint.peak_force *= factor;
    joint.peak_tension *= factor;
    joint.closing.reach *= factor;
    joint.opening.reach *= factor;
    joint.energy_lost *= factor * factor;
  }
  for (std::vector<double>* lengths : {&solution.needed, &solution.scales}) {
    for (double& length : *lengths) length *= factor;
  }
  for (std::vector<Reach>* reaches : {&solution.watched, &solution.watched_free}) {
    for (Reach& reach : *reaches) reach.reach *= factor;
  }
  for (ToCome& one : solution.to_come) {
    one.rest *= factor;
    for (ToCome::Fading& fading : one.fading) fading.size *= factor;
  }
  scale(solution.samples, factor);
  scale(solution.course, factor);
  if (solution.energy) scale(*solution.energy, factor);
  return solution;
}

}  // namespace bentur
