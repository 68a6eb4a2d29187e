#include "bentur/structure/stick.h"

#include <cmath>
#include <numeric>

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
  model.elevations.resize(floors);
  std::partial_sum(stick.storey_heights.begin(), stick.storey_heights.end(), model.elevations.begin());
  for (double& elevation : model.elevations) elevation += base_elevation;
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

/// Of the storeys, `scale` times as stiff as they are given.
std::vector<std::shared_ptr<const HystereticLaw>> softening_laws(const Stick& stick, double scale) {
  const StoreyBackbones& of = *stick.backbone;
  const std::size_t n = stick.stiffnesses.size();
  std::vector<std::shared_ptr<const HystereticLaw>> laws(n);
  bool any = false;
  for (std::size_t j = 0; j < n; ++j) {
    BackboneLaw::Parameters law = {.stiffness = scale * stick.stiffnesses[j],
                                   .positive = backbone_of(of.positive, n, j),
                                   .negative = backbone_of(of.negative.value_or(of.positive), n, j),
                                   .deterioration = of.deterioration,
                                   .reloading = of.reloading,
                                   .pinching_force = of.pinching_force,
                                   .pinching_deformation = of.pinching_deformation};
    if (std::isinf(law.positive.yield) && std::isinf(law.negative.yield)) continue;
    laws[j] = std::make_shared<BackboneLaw>(law);
    any = true;
  }
  if (!any) laws.clear();
  return laws;
}

}  // namespace

std::vector<std::shared_ptr<const HystereticLaw>> storey_laws(const Stick& stick, const StructuralModel& model) {
  if (stick.backbone) {
    require_size("stiffnesses", stick.stiffnesses.size(), model.floors());
    return softening_laws(stick, model.stiffness(model.floors() - 1, model.floors() - 1) / stick.stiffnesses.back());
  }
  const std::vector<double>& forces = stick.yield_forces;
  if (forces.empty()) return {};
  const Eigen::Index n = model.floors();
  require_size("stiffnesses", stick.stiffnesses.size(), n);
  if (forces.size() != 1) require_size("yield_forces", forces.size(), n);
  if (stick.hardening.size() > 1) require_size("hardening", stick.hardening.size(), n);
  const auto* const entry = find_entry(hysteretic_laws(), stick.hysteresis, stick.own);
  if (entry == nullptr) throw InvalidParameter("hysteresis", stick.hysteresis, "there is no such law of a storey");
  const double scale = model.stiffness(n - 1, n - 1) / stick.stiffnesses.back();  // the top storey's stiffness alone
  std::vector<std::shared_ptr<const HystereticLaw>> laws(stick.stiffnesses.size());
  bool any = false;
  for (std::size_t j = 0; j < laws.size(); ++j) {
    const double force = forces[forces.size() == 1 ? 0 : j];
    if (force > 0 && std::isinf(force)) continue;
    const double k = scale * stick.stiffnesses[j];
    const double r = stick.hardening.empty() ? 0 : stick.hardening[stick.hardening.size() == 1 ? 0 : j];
    any = true;
    LawInput input = {.numbers = stick.law_numbers};
    for (const Key& key : entry->keys) {
      if (key.default_value) input.numbers.emplace(key.name, *key.default_value);
    }
    input.numbers.insert({{"stiffness", k}, {"yield_force", force}, {"hardening", r}});
    laws[j] = entry->make(input);
  }
  if (!any) laws.clear();
  return laws;
}

}  // namespace bentur
