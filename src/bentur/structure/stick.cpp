#include "bentur/structure/stick.h"

#include <algorithm>
#include <cmath>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/elements/hysteretic_laws.h"

namespace bentur {

StructuralModel stick_model(const Stick& stick, double base_elevation) {
  const std::size_t floors = stick.storey_heights.size();
  if (floors == 0) throw InvalidParameter("storey_heights", "an empty list", "must have at least one entry");
  require_size("masses", stick.masses.size(), floors);
  require_size("stiffnesses", stick.stiffnesses.size(), floors);
  require_finite("base_elevation", base_elevation);
  for (std::size_t i = 0; i < floors; ++i) {
    require_positive(indexed("storey_heights", i), stick.storey_heights[i]);
    require_positive(indexed("masses", i), stick.masses[i]);
    require_positive(indexed("stiffnesses", i), stick.stiffnesses[i]);
  }

  StructuralModel model;
  const Eigen::Index n = std::ssize(stick.masses);
  model.storey_heights = stick.storey_heights;
  model.elevations = floor_elevations(stick.storey_heights, base_elevation);
  model.load = Eigen::Map<const Eigen::VectorXd>(stick.masses.data(), n);
  model.mass = model.load.asDiagonal();
  model.floor_masses = stick.masses;
  model.stiffness = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double k = stick.stiffnesses[i];
    model.stiffness(i, i) += k;
    if (i > 0) {
      model.stiffness(i - 1, i - 1) += k;
      model.stiffness(i, i - 1) -= k;
      model.stiffness(i - 1, i) -= k;
    }
  }
  return model;
}

namespace {

/// Entry j of a list of one for all or one for each of n.
double entry_of(const char* name, const std::vector<double>& list, std::size_t n, std::size_t j, double otherwise) {
  if (list.empty()) return otherwise;
  if (list.size() != 1) require_size(name, list.size(), n);
  return list[list.size() == 1 ? 0 : j];
}

Backbone backbone_of(const StoreyBackbones::Side& side, std::size_t n, std::size_t j) {
  constexpr Backbone otherwise;
  if (side.yield.empty()) throw InvalidParameter("backbone.yield", "an empty list", "must have at least one entry");
  return {.yield = entry_of("backbone.yield", side.yield, n, j, 0),
          .cap = entry_of("backbone.cap", side.cap, n, j, otherwise.cap),
          .plastic = entry_of("backbone.plastic_drift", side.plastic, n, j, otherwise.plastic),
          .softening = entry_of("backbone.softening_drift", side.softening, n, j, otherwise.softening),
          .residual = entry_of("backbone.residual", side.residual, n, j, otherwise.residual),
          .ultimate = entry_of("backbone.ultimate_drift", side.ultimate, n, j, otherwise.ultimate)};
}

/// Of a storey that can lose strength.
std::shared_ptr<const HystereticLaw> softening_law(const Stick& stick, std::size_t j, double stiffness) {
  const StoreyBackbones& of = *stick.backbone;
  const std::size_t n = stick.stiffnesses.size();
  BackboneLaw::Parameters law = {.stiffness = stiffness,
                                 .positive = backbone_of(of.positive, n, j),
                                 .negative = backbone_of(of.negative.value_or(of.positive), n, j),
                                 .deterioration = of.deterioration,
                                 .reloading = of.reloading,
                                 .pinching_force = of.pinching_force,
                                 .pinching_deformation = of.pinching_deformation};
  if (std::isinf(law.positive.yield) && std::isinf(law.negative.yield)) return nullptr;
  return std::make_shared<BackboneLaw>(law);
}

}  // namespace

std::shared_ptr<const HystereticLaw> storey_law(const Stick& stick, std::size_t storey, double stiffness) {
  if (stick.backbone) return softening_law(stick, storey, stiffness);
  const std::vector<double>& forces = stick.yield_forces;
  if (forces.empty()) return nullptr;
  const std::size_t n = stick.stiffnesses.size();
  if (forces.size() != 1) require_size("yield_forces", forces.size(), n);
  if (stick.hardening.size() > 1) require_size("hardening", stick.hardening.size(), n);
  const auto* const entry = find_entry(hysteretic_laws(), stick.hysteresis, stick.own);
  if (entry == nullptr) throw InvalidParameter("hysteresis", stick.hysteresis, "there is no such law of a storey");
  const double force = forces[forces.size() == 1 ? 0 : storey];
  if (force > 0 && std::isinf(force)) return nullptr;
  const double r = stick.hardening.empty() ? 0 : stick.hardening[stick.hardening.size() == 1 ? 0 : storey];
  LawInput input = {.numbers = stick.law_numbers};
  for (const Key& key : entry->keys) {
    if (key.default_value) input.numbers.emplace(key.name, *key.default_value);
  }
  input.numbers.insert({{"stiffness", stiffness}, {"yield_force", force}, {"hardening", r}});
  return entry->make(input);
}

std::vector<std::shared_ptr<const HystereticLaw>> storey_laws(const Stick& stick, const StructuralModel& model) {
  if (!stick.backbone && stick.yield_forces.empty()) return {};
  const Eigen::Index n = model.floors();
  require_size("stiffnesses", stick.stiffnesses.size(), n);
  const double scale = model.stiffness_factor.value_or(1);
  std::vector<std::shared_ptr<const HystereticLaw>> laws;
  for (std::size_t j = 0; j < stick.stiffnesses.size(); ++j) {
    laws.push_back(storey_law(stick, j, scale * stick.stiffnesses[j]));
  }
  const auto elastic = [](const auto& law) { return law == nullptr; };
  if (std::all_of(laws.begin(), laws.end(), elastic)) laws.clear();
  return laws;
}

}  // namespace bentur
