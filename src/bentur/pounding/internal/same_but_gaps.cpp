#include "bentur/pounding/internal/same_but_gaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>
#include <variant>
#include <vector>

namespace bentur {
namespace {

template <class Matrix>
bool alike(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && a == b;
}

bool alike_laws(const Law* a, const Law* b) {
  return a == b || (a->name() == b->name() && a->parameters() == b->parameters());
}

bool alike(const BuildingElement& a, const BuildingElement& b) {
  return alike_laws(a.law.get(), b.law.get()) && alike(a.row, b.row) && a.storey == b.storey && a.infill == b.infill &&
         a.damped == b.damped;
}

bool alike(const CoupledElement& a, const CoupledElement& b) {
  return (a.law == b.law || a.law->same_as(*b.law)) && alike(a.rows, b.rows);
}

bool alike(const Outputs& a, const Outputs& b) {
  return a.count == b.count && alike(a.rows, b.rows) && alike(a.rates, b.rates) && alike(a.absolute, b.absolute) &&
         alike(a.forces, b.forces) && alike(a.ground, b.ground) && alike(a.at_rest, b.at_rest);
}

template <class Item>
bool all_alike(const std::vector<Item>& a, const std::vector<Item>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Item& one, const Item& other) { return alike(one, other); });
}

bool alike(const Body& a, const Body& b) {
  return alike(a.mass, b.mass) && alike(a.stiffness, b.stiffness) && alike(a.load, b.load) &&
         alike(a.modes.omega, b.modes.omega) && alike(a.modes.shapes, b.modes.shapes) &&
         alike(a.modal_damping, b.modal_damping) && a.tangent_damping == b.tangent_damping &&
         all_alike(a.elements, b.elements) && all_alike(a.coupled, b.coupled) && all_alike(a.outputs, b.outputs);
}

bool alike(const BodyRow& a, const BodyRow& b) {
  return a.body == b.body && alike(a.row, b.row) && alike(a.ground, b.ground);
}

bool alike(const Interface& a, const Interface& b) { return alike(a.left, b.left) && alike(a.right, b.right); }

bool alike(const MeetingPlace& a, const MeetingPlace& b) { return a.meeting == b.meeting && a.family == b.family; }

bool alike(const Contact& a, const Contact& b) { return alike(a.at, b.at) && alike(a.place, b.place); }

bool alike(const RubbingContact& a, const RubbingContact& b) {
  return alike(a.at, b.at) && alike(a.along, b.along) && alike(a.place, b.place);
}

bool alike(const Element& a, const Element& b) { return alike(a.at, b.at) && alike_laws(a.law.get(), b.law.get()); }

bool alike(const NoMotion&, const NoMotion&) { return true; }

bool alike(const SampledMotion& a, const SampledMotion& b) { return a == b; }

bool alike(const HarmonicMotion& a, const HarmonicMotion& b) {
  return a.period == b.period && a.displacement_amplitude == b.displacement_amplitude && a.phase == b.phase;
}

bool alike(const GroundMotion& a, const GroundMotion& b) {
  if (a.index() != b.index()) return false;
  return std::visit([&b](const auto& motion) { return alike(motion, std::get<std::decay_t<decltype(motion)>>(b)); }, a);
}

/// Of one body; an empty list means zero.
bool alike_at(std::size_t b, const std::vector<Eigen::VectorXd>& one, const std::vector<Eigen::VectorXd>& other) {
  if (one.empty()) return other.empty() || other[b].isZero(0.0);
  return other.empty() ? one[b].isZero(0.0) : one[b] == other[b];
}

/// The first of a list that is not as in the other.
template <class Item>
std::optional<Difference> difference(const std::vector<Item>& items, const std::vector<Item>& others,
                                     const char* what) {
  if (items.size() != others.size()) return Difference{what, std::to_string(others.size())};
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!alike(items[i], others[i])) return Difference{fmt::format("{}[{}]", what, i), "another one"};
  }
  return std::nullopt;
}

}  // namespace

bool alike(const std::vector<GroundMotion>& motions, const std::vector<GroundMotion>& others) {
  return std::equal(motions.begin(), motions.end(), others.begin(), others.end(),
                    [](const GroundMotion& one, const GroundMotion& other) { return alike(one, other); });
}

std::optional<Difference> difference_but_gaps(const System& system, const System& other) {
  if (auto found = difference(system.bodies, other.bodies, "buildings")) return found;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const std::string& name = other.bodies[b].name;
    if (!alike_at(b, system.initial_displacement, other.initial_displacement)) {
      return Difference{"initial_displacement", name};
    }
    if (!alike_at(b, system.initial_velocity, other.initial_velocity)) return Difference{"initial_velocity", name};
    if (system.delay(b) != other.delay(b)) return Difference{"delays", fmt::format("{}", other.delay(b))};
  }
  if (auto found = difference(system.contacts, other.contacts, "points")) return found;
  if (auto found = difference(system.rubbing, other.rubbing, "points")) return found;
  if (auto found = difference(system.watched, other.watched, "watched")) return found;
  if (auto found = difference(system.joints, other.joints, "links")) return found;
  return difference(system.limits, other.limits, "limits");
}

}  // namespace bentur
