// What elements store and take, for the account of energy.
#include "bentur/contact/laws/rubbing.h"
#include "bentur/solve/engine/run/elements.h"

namespace bentur::engine {

using Eigen::Index;

double Elements::stored_in_contacts(const State& state) const {
  double sum = 0.0;
  for (Index i = idle_; i < count(); ++i) {
    if (branches_[i].touching()) sum += law(i).stored_energy(states_[i], deformation(i, state));
  }
  if (rubbing_.empty()) return sum;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(std::ssize(offsets_));
  coupled_.add_forces(state, forces);
  for (std::size_t n = 0; n < rubbing_.size(); ++n) {
    const Rub of = rub(n);
    if (!touches(of)) continue;
    sum +=
        of.law->normal().stored_energy(of.law->normal_state(coupled_.states()[of.coupled]), deformation(of.at, state));
    sum += of.law->stored_along(forces(of.at + 1));
  }
  return sum;
}

double Elements::stored_in_others(const State& state) const {
  double sum = 0.0;
  for (Index i = idle_; i < count(); ++i) {
    if (two_bodies(i)) continue;
    const double delta = deformation(i, state);
    sum += law(i).stored_energy(states_[i], delta) - 0.5 * system_->elements[i].stiffness * delta * delta;
  }
  return sum + coupled_.stored_energy(state);
}

double Elements::damping_power(const State& state) const {
  double sum = 0.0;
  for (const Index i : forces_.pressing) {
    if (two_bodies(i) || forces_.linear[i].damping == 0.0) continue;
    const double rate = speed(i, state);
    sum += forces_.linear[i].damping * rate * rate;
  }
  return sum;
}

double Elements::residual(Index i, const State& state) const {
  const auto* law = dynamic_cast<const HystereticLaw*>(laws_[i].get());
  return law == nullptr ? 0.0 : law->residual(states_[i], deformation(i, state));
}

std::optional<StrengthLoss> Elements::loss(Index i, const State& state) const {
  const auto* law = dynamic_cast<const HystereticLaw*>(laws_[i].get());
  return law == nullptr ? std::nullopt : law->loss(states_[i], deformation(i, state));
}

}  // namespace bentur::engine
