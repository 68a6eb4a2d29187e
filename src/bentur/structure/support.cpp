#include "bentur/structure/support.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "bentur/core/algebra/factors.h"
#include "bentur/core/algebra/symmetric.h"
#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// P_j/h_j of each storey, the lowest first.
VectorXd softening(const StructuralModel& model, const GravityLoads& gravity) {
  require_size("gravity_loads", gravity.loads.size(), model.floors());
  VectorXd result(model.floors());
  double above = 0;
  for (Index j = model.floors(); j-- > 0;) {
    require_not_negative(indexed("gravity_loads", j), gravity.loads[j]);
    above += gravity.loads[j];
    result(j) = above / model.storey_heights[j];
  }
  return result;
}

/// Σ P_j/h_j d_jᵀ d_j over the drifts d_j of total sways.
MatrixXd geometric_stiffness(const VectorXd& softening, const MatrixXd& drifts) {
  return drifts.transpose() * softening.asDiagonal() * drifts;
}

/// Names what is wrong with loads under which a structure does not stand.
[[noreturn]] void refuse_loads(const StructuralModel& model, const VectorXd& softening, const MatrixXd& geometric) {
  // A storey's own stiffness: its shear by a unit drift alone.
  const MatrixXd shears = shear_rows(model);
  Index weakest = 0;
  double least = 0;
  for (Index j = 0; j < softening.size(); ++j) {
    const Index storey = model.floors() - softening.size() + j;  // above a slab
    VectorXd unit = VectorXd::Zero(model.dofs());
    unit.segment(storey, model.floors() - storey).setOnes();
    const double share = shears.row(storey).dot(unit) / softening(j);
    if (j == 0 || share < least) {
      least = share;
      weakest = j;
    }
  }
  const double critical = 1 / generalised_values(geometric, model.stiffness).maxCoeff();
  throw InvalidParameter("gravity_loads", fmt::format("{:.4g} times what the building bears", 1 / critical),
                         fmt::format("must leave the building standing: storey {} has the least margin, and all loads "
                                     "times {:.3g} are critical",
                                     weakest + 1, critical));
}

/// C of the dofs whose modes have D as modal damping.
MatrixXd damping_matrix(const StructuralModel& model, const Modes& modes, const MatrixXd& modal) {
  const MatrixXd to = model.mass * modes.shapes;
  return to * modal * to.transpose();
}

/// A structure that moves relative to something below it: coordinates z of the whole, y = B z of the structure.
struct Above {
  MatrixXd b;
  [[nodiscard]] MatrixXd carried(const MatrixXd& of_structure) const { return b.transpose() * of_structure * b; }
};

/// Rows of the structure, over y, as rows over z.
void carry_rows(const Above& above, StructuralModel& model) {
  if (model.left_joints.size() > 0) {
    model.left_joints = model.left_joints * above.b;
    model.right_joints = model.right_joints * above.b;
  }
  if (model.column_forces.size() > 0) model.column_forces = model.column_forces * above.b;
  if (model.hinges.size() > 0) model.hinges.rows = model.hinges.rows * above.b;
}

MatrixXd below_zero(const MatrixXd& rows) {
  MatrixXd result(rows.rows() + 1, rows.cols());
  result << VectorXd::Zero(rows.cols()).transpose(), rows;
  return result;
}

void check(const Isolation& isolation) {
  require_positive("isolation.mass", isolation.mass);
  require_positive("isolation.stiffness", isolation.bearings.stiffness);
  require_not_negative("isolation.damping", isolation.damping);
}

/// What the structure is before it is put on something.
struct Structure {
  StructuralModel model;  ///< with K as its stiffness
  MatrixXd damping;       ///< C
  VectorXd softening;     ///< P_j/h_j; empty: none
};

/// The slab's sway first, then the structure's dofs as totals.
void put_on_bearings(const Isolation& isolation, Structure& structure) {
  check(isolation);
  StructuralModel& model = structure.model;
  const Index n = model.dofs();
  const Index sways = model.floors() + model.nodes();
  const StructuralModel::RigidBody body = rigid_body(model);
  Above above{MatrixXd::Zero(n, n + 1)};
  above.b.rightCols(n).setIdentity();
  above.b.col(0).head(sways).setConstant(-1);
  MatrixXd mass(n + 1, n + 1);  // over the slab's sway and y
  mass << body.mass + isolation.mass, model.load.transpose(), model.load, model.mass;
  MatrixXd to(n + 1, n + 1);
  to << VectorXd::Unit(n + 1, 0).transpose(), above.b;
  const MatrixXd shears = shear_rows(model);  // over the structure's dofs, before the mass has one more
  const MatrixXd drifts = drift_rows(model);
  model.mass = to.transpose() * mass * to;
  model.stiffness = above.carried(model.stiffness);
  model.stiffness(0, 0) += isolation.bearings.stiffness;
  structure.damping = above.carried(structure.damping);
  structure.damping(0, 0) += isolation.damping;
  VectorXd load(n + 1);
  load << body.mass + isolation.mass, model.load;
  model.load = to.transpose() * load;
  // Rows: the slab's drift is its sway, its shear what the bearings take.
  model.drifts = below_zero(drifts * above.b);
  model.drifts(0, 0) = 1;
  model.shears = below_zero(shears * above.b);
  model.shears(0, 0) = isolation.bearings.stiffness;
  carry_rows(above, model);
  if (model.left_joints.size() > 0) {
    model.left_joints = below_zero(model.left_joints);
    model.right_joints = below_zero(model.right_joints);
  }
  const double base = model.elevations.front() - model.storey_heights.front();
  model.elevations.insert(model.elevations.begin(), base);
  model.storey_heights.insert(model.storey_heights.begin(), 0.0);
  model.floor_masses.insert(model.floor_masses.begin(), isolation.mass + body.foot_mass);
  model.slab = 0;
}

void check(const Soil& soil) {
  require_positive("soil.sway.stiffness", soil.sway.stiffness);
  require_not_negative("soil.sway.damping", soil.sway.damping);
  require_positive("soil.rocking.stiffness", soil.rocking.stiffness);
  require_not_negative("soil.rocking.damping", soil.rocking.damping);
  require_positive("soil.foundation.mass", soil.mass);
  require_positive("soil.foundation.inertia", soil.inertia);
}

/// The structure's dofs as totals, then u and θ.
void put_on_soil(const Soil& soil, Structure& structure) {
  check(soil);
  StructuralModel& model = structure.model;
  const Index n = model.dofs();
  const StructuralModel::RigidBody body = rigid_body(model);
  const double base = model.elevations.front() - model.storey_heights.front();
  MatrixXd to = MatrixXd::Identity(n + 2, n + 2);  // from totals, u and θ to y, u and θ
  const auto relative = [&](Index dof, double height) {
    to(dof, n) = -1;
    to(dof, n + 1) = -height;
  };
  for (Index f = 0; f < model.floors(); ++f) relative(f, model.elevations[f] - base);
  for (Index node = 0; node < model.nodes(); ++node) {
    relative(model.floors() + node, model.node_elevations[node] - base);
  }
  const Above above{to.topRows(n)};
  MatrixXd mass(n + 2, n + 2);
  mass << model.mass, model.load, body.rocking,                    //
      model.load.transpose(), body.mass + soil.mass, body.moment,  //
      body.rocking.transpose(), body.moment, body.inertia + soil.inertia;
  VectorXd load(n + 2);
  load << model.load, body.mass + soil.mass, body.moment;
  model.drifts = drift_rows(model) * above.b;
  model.shears = shear_rows(model) * above.b;
  const auto with = [&](const MatrixXd& of_structure, double sway, double rocking) {
    MatrixXd result = above.carried(of_structure);
    result(n, n) += sway;
    result(n + 1, n + 1) += rocking;
    return result;
  };
  structure.damping = with(structure.damping, soil.sway.damping, soil.rocking.damping);
  model.stiffness = with(model.stiffness, soil.sway.stiffness, soil.rocking.stiffness);
  model.mass = to.transpose() * mass * to;
  model.load = to.transpose() * load;
  carry_rows(above, model);
  model.foundation = Foundation{n, n + 1, soil.sway, soil.rocking};
}

}  // namespace

double mass_above_bearings(const StructuralModel& model, double slab_mass) {
  return rigid_body(model).mass + slab_mass;
}

Soil soil_of(const HalfSpace& half_space, double mass, double inertia) {
  require_positive("half_space.shear_wave_velocity", half_space.shear_wave_velocity);
  require_positive("half_space.density", half_space.density);
  require_positive("half_space.radius", half_space.radius);
  const double nu = half_space.poisson;
  if (!(nu >= 0 && nu <= 0.5)) {
    throw InvalidParameter("half_space.poisson", fmt::format("{}", nu), "must be in [0, 0.5]");
  }
  const double v = half_space.shear_wave_velocity;
  const double rho = half_space.density;
  const double r = half_space.radius;
  const double g = rho * v * v;
  const double inertia_ratio = 3 * (1 - nu) * inertia / (8 * rho * std::pow(r, 5));  // B_r
  return {.sway = {8 * g * r / (2 - nu), 4.6 * rho * v * r * r / (2 - nu)},
          .rocking = {8 * g * r * r * r / (3 * (1 - nu)),
                      0.8 * std::pow(r, 4) * std::sqrt(rho * g) / ((1 - nu) * (1 + inertia_ratio))},
          .mass = mass,
          .inertia = inertia};
}

Building make_building(std::string name, StructuralModel model, const Damping& damping, const Support& support,
                       std::vector<std::shared_ptr<const HystereticLaw>> storey_laws) {
  if (support.isolation && support.soil) {
    throw InvalidParameter("isolation", "together with soil", "must stand on a base that does not move by itself");
  }
  Structure structure;
  structure.model = std::move(model);
  StructuralModel& whole = structure.model;
  MatrixXd fixed_stiffness = whole.stiffness;
  if (support.gravity) {
    structure.softening = softening(whole, *support.gravity);
    const MatrixXd geometric = geometric_stiffness(structure.softening, drift_rows(whole));
    fixed_stiffness -= geometric;
    if (!is_positive_definite(fixed_stiffness)) refuse_loads(whole, structure.softening, geometric);
  }
  const Modes fixed_modes = modes(whole.mass, fixed_stiffness);
  const MatrixXd fixed_damping = modal_damping(damping, fixed_modes);
  structure.damping = damping_matrix(whole, fixed_modes, fixed_damping);
  const bool moves_below = support.isolation || support.soil;
  if (whole.shears.size() == 0 && support.gravity) whole.shears = shear_rows(whole);  // of K, not of K − K_g
  if (support.isolation) {
    put_on_bearings(*support.isolation, structure);
    if (const auto& law = support.isolation->bearings.law; law || !storey_laws.empty()) {
      if (storey_laws.empty()) storey_laws.resize(whole.floors() - 1);
      storey_laws.insert(storey_laws.begin(), law);
    }
  }
  if (support.soil) put_on_soil(*support.soil, structure);
  if (!moves_below) {
    whole.stiffness = fixed_stiffness;
  } else if (support.gravity) {
    // On total sways, x_0 that of the slab or the foundation.
    const Index first = whole.first_storey();
    MatrixXd drifts = MatrixXd::Zero(structure.softening.size(), whole.dofs());
    for (Index j = 0; j < drifts.rows(); ++j) {
      drifts(j, first + j) = 1;
      const Index below = first + j - 1;
      if (below >= 0) drifts(j, below) = -1;
      if (j == 0 && whole.foundation) drifts(j, whole.foundation->sway) = -1;
    }
    const MatrixXd geometric = geometric_stiffness(structure.softening, drifts);
    const MatrixXd softened = whole.stiffness - geometric;
    if (!is_positive_definite(softened)) refuse_loads(whole, structure.softening, geometric);
    whole.stiffness = softened;
  }
  Building building;
  building.name = std::move(name);
  building.modes = moves_below ? modes(whole.mass, whole.stiffness) : fixed_modes;
  building.modal_damping =
      moves_below ? modal_damping(MatrixDamping{structure.damping}, building.modes) : fixed_damping;
  building.elements = storey_elements(whole, storey_laws);
  for (BuildingElement& element : building.elements) element.damped = element.storey >= whole.first_storey();
  add_infill(whole, building.elements);
  building.coupled = hinge_elements(whole);
  building.model = std::move(structure.model);
  building.has_gravity_loads = support.gravity.has_value();
  return building;
}

Building rigid_building(std::string name, const std::vector<double>& elevations) {
  if (elevations.empty()) throw InvalidParameter("elevations", "an empty list", "must have at least one entry");
  Building building;
  building.name = std::move(name);
  StructuralModel& model = building.model;
  const Index n = std::ssize(elevations);
  for (std::size_t i = 0; i < elevations.size(); ++i) {
    require_finite(indexed("elevations", i), elevations[i]);
    if (i > 0 && !(elevations[i] > elevations[i - 1])) {
      throw InvalidParameter(indexed("elevations", i), fmt::format("{}", elevations[i]), "must ascend");
    }
    model.storey_heights.push_back(i > 0 ? elevations[i] - elevations[i - 1] : 0.0);
  }
  model.elevations = elevations;
  model.mass = MatrixXd::Zero(n, n);
  model.stiffness = MatrixXd::Zero(n, n);
  model.load = VectorXd::Zero(n);
  model.floor_masses.assign(elevations.size(), std::numeric_limits<double>::infinity());
  model.drifts = MatrixXd::Zero(n, n);
  model.shears = MatrixXd::Zero(n, n);
  building.modes.shapes = MatrixXd::Zero(n, 0);
  building.modal_damping = MatrixXd::Zero(0, 0);
  return building;
}

}  // namespace bentur
