#include "python_law.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"

namespace py = pybind11;

namespace bentur::python {

ForceLaw::~ForceLaw() {
  const py::gil_scoped_acquire lock;
  force_ = {};
  energy_ = {};
  error_ = {};
}

Branch ForceLaw::branch(const LawState& state) const noexcept {
  if (state.branch == apart) return Branch::apart();
  return Branch{.bodies = Bodies::touching, .linear = false}.guarded_by({{.deformation = 1}});
}

double ForceLaw::called(const py::object& function, double penetration, double speed, bool with_speed) const noexcept {
  const py::gil_scoped_acquire lock;
  if (error_) return std::numeric_limits<double>::quiet_NaN();
  try {
    return (with_speed ? function(penetration, speed) : function(penetration)).cast<double>();
  } catch (py::error_already_set& error) {
    error_ = error.value();
  } catch (const std::exception& error) {
    error_ = py::module_::import("builtins").attr("TypeError")(name_ + ": the force must be a number");
  }
  return std::numeric_limits<double>::quiet_NaN();
}

void ForceLaw::rethrow() const {
  if (!error_) return;
  const py::object error = std::move(error_);
  error_ = {};
  PyErr_SetObject(py::type::of(error).ptr(), error.ptr());
  throw py::error_already_set();
}

double ForceLaw::force(const LawState& state, double penetration, double closing_speed) const noexcept {
  if (state.branch == apart || !(penetration > 0)) return 0;
  const double force = called(force_, penetration, closing_speed, true);
  return force < 0 ? 0 : force;
}

double ForceLaw::stored_energy(const LawState& state, double penetration) const noexcept {
  if (state.branch == apart || !(penetration > 0)) return 0;
  if (!energy_.is_none()) return called(energy_, penetration, 0, false);
  // ∫ F(δ, 0) dδ by Gauss and Legendre's rule of five points on four parts.
  constexpr std::array<double, 3> at = {0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 3> weight = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  constexpr int parts = 4;
  const double half = penetration / (2 * parts);
  double energy = 0;
  for (int part = 0; part < parts; ++part) {
    const double middle = (2 * part + 1) * half;
    for (std::size_t i = 0; i < at.size(); ++i) {
      energy += weight[i] * force(state, middle + at[i] * half, 0);
      if (i > 0) energy += weight[i] * force(state, middle - at[i] * half, 0);
    }
  }
  return energy * half;
}

BranchLaw::BranchLaw(std::string name, std::vector<BranchData> branches)
    : name_(std::move(name)), data_(std::move(branches)) {
  if (data_.empty())
    throw InvalidParameter("branches", "none", "there must be one at least, in which a contact begins");
  const int last = static_cast<int>(data_.size());
  for (std::size_t i = 0; i < data_.size(); ++i) {
    const BranchData& one = data_[i];
    const std::string path = "branches[" + std::to_string(i) + "]";
    for (const double x : {one.base, one.stiffness, one.damping, one.unloading_stiffness}) require_finite(path, x);
    if (one.guards.empty() || one.guards.size() > Branch::most_guards) {
      throw InvalidParameter(path + ".guards", std::to_string(one.guards.size()) + " of them", "must be from 1 to 3");
    }
    Branch branch{.bodies = one.touching ? Bodies::touching : Bodies::apart,
                  .base = one.base,
                  .stiffness = one.stiffness,
                  .damping = one.damping};
    for (std::size_t g = 0; g < one.guards.size(); ++g) {
      if (one.then[g] < 0 || one.then[g] > last) {
        throw InvalidParameter(path + ".guards[" + std::to_string(g) + "].then", std::to_string(one.then[g]),
                               "must be 0 (apart) or the number of a branch, from 1 to " + std::to_string(last));
      }
      branch.guards[branch.guard_count++] = one.guards[g];
    }
    branches_.push_back(branch);
  }
}

Branch BranchLaw::branch(const LawState& state) const noexcept {
  return state.branch == apart ? Branch::apart() : branches_[static_cast<std::size_t>(state.branch - 1)];
}

LawState BranchLaw::next(const LawState& state, std::size_t guard, double time, double /*penetration*/,
                         double closing_speed) const noexcept {
  LawState after = state;
  after.since = time;
  if (state.branch == apart) {
    after.branch = 1;
    after.closing_speed = closing_speed;
    return after;
  }
  after.branch = data_[static_cast<std::size_t>(state.branch - 1)].then[guard];
  if (after.branch == apart) after.closing_speed = 0;
  return after;
}

double BranchLaw::stored_energy(const LawState& state, double penetration) const noexcept {
  if (state.branch == apart) return 0;
  const BranchData& now = data_[static_cast<std::size_t>(state.branch - 1)];
  const double force = std::max(0.0, now.base + now.stiffness * penetration);
  const double stiffness = now.unloading_stiffness > 0 ? now.unloading_stiffness : now.stiffness;
  return stiffness > 0 ? force * force / (2 * stiffness) : 0;
}

}  // namespace bentur::python
