#include "python_law.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "bentur/core/errors.h"
#include "bentur/core/not_known.h"
#include "bentur/core/require.h"
#include "bentur/elements/hysteretic_laws.h"
#include "bentur/model/link.h"

namespace py = pybind11;

namespace bentur::python {
namespace {

template <class Base>
constexpr bool is_contact = std::is_same_v<Base, ContactLaw>;

/// What a function has raised in this thread. Always taken out again by rethrow_of_laws().
thread_local PyObject* raised = nullptr;

}  // namespace

void rethrow_of_laws() {
  if (raised == nullptr) return;
  const auto error = py::reinterpret_steal<py::object>(std::exchange(raised, nullptr));
  PyErr_SetObject(py::type::of(error).ptr(), error.ptr());
  throw py::error_already_set();
}

bool law_has_raised() noexcept { return raised != nullptr; }

PyLaw::~PyLaw() {
  const py::gil_scoped_acquire lock;
  given = {};
}

ForceLaw::~ForceLaw() {
  const py::gil_scoped_acquire lock;
  force_.given = {};
  energy_.given = {};
}

Branch ForceLaw::branch(const LawState& state) const noexcept {
  if (state.branch == apart) return Branch::apart();
  return Branch{.bodies = Bodies::touching, .linear = false}.guarded_by({{.deformation = 1}});
}

double ForceLaw::called(const py::object& function, double penetration, double speed, bool with_speed) const noexcept {
  const py::gil_scoped_acquire lock;
  if (raised != nullptr) return not_known;
  try {
    return (with_speed ? function(penetration, speed) : function(penetration)).cast<double>();
  } catch (py::error_already_set& error) {
    raised = error.value().inc_ref().ptr();
  } catch (const std::exception& error) {
    const py::object type = py::module_::import("builtins").attr("TypeError");
    raised = type(name_ + ": the force must be a number").release().ptr();
  }
  return not_known;
}

double ForceLaw::force(const LawState& state, double penetration, double closing_speed) const noexcept {
  if (state.branch == apart || !(penetration > 0)) return 0;
  const double force = force_.code != nullptr
                           ? reinterpret_cast<double (*)(double, double)>(force_.code)(penetration, closing_speed)
                           : called(force_.given, penetration, closing_speed, true);
  return force < 0 ? 0 : force;
}

double ForceLaw::stored_energy(const LawState& state, double penetration) const noexcept {
  if (state.branch == apart || !(penetration > 0)) return 0;
  if (energy_.code != nullptr) return reinterpret_cast<double (*)(double)>(energy_.code)(penetration);
  if (!energy_.given.is_none()) return called(energy_.given, penetration, 0, false);
  const auto slowly = [&](double at) { return force(state, at, 0); };
  return boost::math::quadrature::gauss<double, 20>::integrate(slowly, 0.0, penetration);
}

template <class Base>
BranchLaw<Base>::BranchLaw(std::string name, std::vector<BranchData> branches)
    : name_(std::move(name)), data_(std::move(branches)) {
  constexpr int first = is_contact<Base> ? 0 : 1;  // that a guard can lead to
  if (data_.empty()) throw InvalidParameter("branches", "none", "there must be one at least, to begin in");
  const int last = static_cast<int>(data_.size());
  for (std::size_t i = 0; i < data_.size(); ++i) {
    const BranchData& one = data_[i];
    const std::string path = "branches[" + std::to_string(i) + "]";
    for (const double x : {one.base.value_or(0), one.stiffness, one.damping, one.unloading_stiffness})
      require_finite(path, x);
    if (one.ends.size() > Branch::most_guards || (is_contact<Base> && one.ends.empty())) {
      throw InvalidParameter(path + ".guards", std::to_string(one.ends.size()) + " of them",
                             is_contact<Base> ? "must be from 1 to 3" : "must be 3 at most");
    }
    for (std::size_t g = 0; g < one.ends.size(); ++g) {
      const int then = one.ends[g].then;
      if (then >= first && then <= last) continue;
      throw InvalidParameter(path + ".guards[" + std::to_string(g) + "].then", std::to_string(then),
                             std::string(is_contact<Base> ? "must be 0 (apart) or " : "must be ") +
                                 "the number of a branch, from 1 to " + std::to_string(last));
    }
  }
}

/// The branch a contact, link or storey is in; null of floors apart.
template <class Base>
const BranchData* BranchLaw<Base>::data(const LawState& state) const noexcept {
  if (is_contact<Base> && state.branch == 0) return nullptr;
  return &data_[static_cast<std::size_t>(std::max(state.branch, 1) - 1)];
}

template <class Base>
double BranchLaw<Base>::unloading_stiffness(const BranchData& now) noexcept {
  return now.unloading_stiffness > 0 ? now.unloading_stiffness : now.stiffness;
}

template <class Base>
Branch BranchLaw<Base>::branch(const LawState& state) const noexcept {
  const BranchData* const now = data(state);
  if (now == nullptr) return Branch::apart();
  Branch branch{.bodies = !is_contact<Base> ? Bodies::none
                          : now->touching   ? Bodies::touching
                                            : Bodies::apart,
                .base = now->base.value_or(state.memory[0]),
                .stiffness = now->stiffness,
                .damping = now->damping};
  for (const auto& [guard, force, then] : now->ends) {
    Guard& made = branch.guards[branch.guard_count++];
    made = guard;
    made.constant += force * branch.base;
    made.deformation += force * branch.stiffness;
    made.speed += force * branch.damping;
  }
  return branch;
}

template <class Base>
LawState BranchLaw<Base>::next(const LawState& state, std::size_t guard, double time, double deformation,
                               double speed) const noexcept {
  LawState after = state;
  after.since = time;
  const BranchData* const before = data(state);
  after.branch = before == nullptr ? 1 : before->ends[guard].then;
  if (before == nullptr) after.closing_speed = speed;
  const BranchData* const now = data(after);
  if (now == nullptr) after.closing_speed = 0;
  after.memory = {};
  if (now != nullptr && !now->base) {
    const double force = before == nullptr ? 0 : Law::force(state, deformation, speed);
    after.memory[0] = force - now->stiffness * deformation - now->damping * speed;
  }
  return after;
}

template <class Base>
double BranchLaw<Base>::stored_energy(const LawState& state, double deformation) const noexcept {
  const BranchData* const now = data(state);
  if (now == nullptr) return 0;
  double force = now->base.value_or(state.memory[0]) + now->stiffness * deformation;
  if (is_contact<Base>) force = std::max(0.0, force);
  const double stiffness = unloading_stiffness(*now);
  return stiffness > 0 ? force * force / (2 * stiffness) : 0;
}

template class BranchLaw<ContactLaw>;
template class BranchLaw<Law>;
template class BranchLaw<HystereticLaw>;

namespace {

/// Told in forces and lengths, from units of a yield force and a yield deformation; sums of guards become lengths.
std::vector<BranchData> scaled(std::vector<BranchData> branches, double stiffness, double yield_force) {
  for (BranchData& one : branches) {
    if (one.base) *one.base *= yield_force;
    for (double* const number : {&one.stiffness, &one.damping, &one.unloading_stiffness}) *number *= stiffness;
    for (BranchData::End& end : one.ends) {
      end.guard.constant *= yield_force / stiffness;
      end.force /= stiffness;
    }
  }
  return branches;
}

}  // namespace

StoreyLaw::StoreyLaw(std::string name, std::vector<BranchData> branches, double stiffness, double yield_force)
    : BranchLaw(std::move(name), scaled(branches, stiffness, yield_force)),
      stiffness_(stiffness),
      yield_deformation_(yield_force / stiffness) {
  const BranchData& first = branches.front();
  if (first.base.value_or(0) != 0 || first.stiffness != 1 || first.damping != 0) {
    throw InvalidParameter("branches[0]", "another line",
                           "must be F = δ in a storey, base 0 and stiffness 1: its branches are given in units of its "
                           "yield force and yield deformation");
  }
}

double StoreyLaw::residual(const LawState& state, double deformation) const noexcept {
  const double stiffness = unloading_stiffness(*data(state));
  return stiffness > 0 ? deformation - force(state, deformation, 0) / stiffness : deformation;
}

namespace {

std::vector<BranchData> branches_of(const py::handle& law) {
  std::vector<BranchData> branches;
  for (const py::handle one : law.attr("branches")) {
    BranchData branch{.touching = one.attr("touching").cast<bool>(),
                      .base = one.attr("base").cast<std::optional<double>>(),
                      .stiffness = one.attr("stiffness").cast<double>(),
                      .damping = one.attr("damping").cast<double>(),
                      .unloading_stiffness = one.attr("unloading_stiffness").cast<double>()};
    for (const py::handle guard : one.attr("guards")) {
      branch.ends.push_back({{.constant = guard.attr("constant").cast<double>(),
                              .deformation = guard.attr("deformation").cast<double>(),
                              .speed = guard.attr("speed").cast<double>()},
                             guard.attr("force").cast<double>(),
                             guard.attr("then").cast<int>()});
    }
    branches.push_back(std::move(branch));
  }
  return branches;
}

template <class Made, class Make>
std::shared_ptr<const LawEntryOf<Made>> entry(const PyLaw& law, Make make) {
  return std::make_shared<const LawEntryOf<Made>>(LawEntryOf<Made>{law.name, {}, {}, {}, std::move(make)});
}

}  // namespace

std::shared_ptr<const OwnLaw> own_law(const py::object& given) {
  const auto law = std::make_shared<PyLaw>(given.attr("name").cast<std::string>(), given);
  const std::string& name = law->name;
  if (find_law(name) != nullptr || find_entry(link_laws(), name) != nullptr ||
      find_entry(hysteretic_laws(), name) != nullptr) {
    throw InvalidParameter("name", '"' + name + '"', "is that of a law of bentur's: give this one another");
  }
  if (py::hasattr(given, "force")) {
    const auto callable = [&](const char* what, int arguments) {
      const py::object function = given.attr(what);
      const auto address = py::module_::import("bentur._own_laws").attr("address_of")(function, arguments);
      return Callable{function, reinterpret_cast<const void*>(address.cast<std::uintptr_t>())};
    };
    const auto made = std::make_shared<const ForceLaw>(name, callable("force", 2), callable("energy", 1));
    law->contact = entry<ContactLaw>(*law, [made](const LawInput& /*input*/) { return made; });
    return law;
  }
  const std::vector<BranchData> data = branches_of(given);
  law->contact = entry<ContactLaw>(
      *law, [=](const LawInput& /*input*/) { return std::make_shared<const BranchLaw<ContactLaw>>(name, data); });
  law->link =
      entry<Law>(*law, [=](const LawInput& /*input*/) { return std::make_shared<const BranchLaw<Law>>(name, data); });
  law->storey = entry<HystereticLaw>(*law, [=](const LawInput& input) {
    return std::make_shared<const StoreyLaw>(name, data, input.number("stiffness"), input.number("yield_force"));
  });
  return law;
}

}  // namespace bentur::python
