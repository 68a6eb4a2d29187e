#include "bentur/pounding/internal/same_but_gaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

void require_same(bool same, const std::string& what, const std::string& value) {
  if (!same) throw InvalidParameter(what, value, "must be that of the free response");
}

void require_as_many(std::size_t count, std::size_t as, const std::string& what) {
  require_same(count == as, what, std::to_string(count));
}

template <class Matrix>
bool alike(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && a == b;
}

bool alike_laws(const Law* a, const Law* b) {
  if (a == b) return true;
  return a != nullptr && b != nullptr && a->name() == b->name() && a->parameters() == b->parameters();
}

bool alike_elements(const Building& a, const Building& b) {
  const auto same = [](const BuildingElement& one, const BuildingElement& other) {
    return alike_laws(one.law.get(), other.law.get()) && alike(one.row, other.row) && one.storey == other.storey;
  };
  const auto same_coupled = [](const CoupledElement& one, const CoupledElement& other) {
    return (one.law == other.law || one.law->same_as(*other.law)) && alike(one.rows, other.rows);
  };
  return std::equal(a.elements.begin(), a.elements.end(), b.elements.begin(), b.elements.end(), same) &&
         std::equal(a.coupled.begin(), a.coupled.end(), b.coupled.begin(), b.coupled.end(), same_coupled) &&
         a.tangent_damping == b.tangent_damping;
}

bool alike(const InfillPanel& a, const InfillPanel& b) {
  return a.storey == b.storey && a.bay == b.bay && a.stiffness == b.stiffness && a.backbone == b.backbone &&
         a.cosine == b.cosine;
}

bool alike(const Link& a, const Link& b) {
  return a.left == b.left && a.right == b.right && a.left_floor == b.left_floor && a.right_floor == b.right_floor &&
         alike_laws(a.law.get(), b.law.get());
}

bool alike(const Building& a, const Building& b) {
  return alike(a.model.mass, b.model.mass) && alike(a.model.stiffness, b.model.stiffness) &&
         alike(a.model.load, b.model.load) && a.model.storey_heights == b.model.storey_heights &&
         alike(a.modes.omega, b.modes.omega) && alike(a.modes.shapes, b.modes.shapes) &&
         alike(a.modal_damping, b.modal_damping) && alike(a.model.drifts, b.model.drifts) &&
         alike(a.model.shears, b.model.shears) && a.has_gravity_loads == b.has_gravity_loads && alike_elements(a, b) &&
         std::equal(a.model.infills.begin(), a.model.infills.end(), b.model.infills.begin(), b.model.infills.end(),
                    [](const InfillPanel& one, const InfillPanel& other) { return alike(one, other); });
}

bool alike(const ContactPoint& a, const ContactPoint& b) {
  return a.left == b.left && a.left_floor == b.left_floor && a.right_floor == b.right_floor;
}

bool alike(const WatchedFloor& a, const WatchedFloor& b) {
  return a.left == b.left && alike(a.left_row, b.left_row) && alike(a.right_row, b.right_row);
}

bool alike(const NoMotion&, const NoMotion&) { return true; }

bool alike(const SampledMotion& a, const SampledMotion& b) {
  return a.time_step == b.time_step && a.acceleration == b.acceleration;
}

bool alike(const HarmonicMotion& a, const HarmonicMotion& b) {
  return a.period == b.period && a.displacement_amplitude == b.displacement_amplitude && a.phase == b.phase;
}

bool alike(const GroundMotion& a, const GroundMotion& b) {
  if (a.index() != b.index()) return false;
  return std::visit([&b](const auto& motion) { return alike(motion, std::get<std::decay_t<decltype(motion)>>(b)); }, a);
}

/// Of one building; an empty list means zero.
bool alike_at(std::size_t b, const std::vector<Eigen::VectorXd>& one, const std::vector<Eigen::VectorXd>& other) {
  if (one.empty()) return other.empty() || other[b].isZero(0.0);
  return other.empty() ? one[b].isZero(0.0) : one[b] == other[b];
}

}  // namespace

void require_same_but_gaps(const Problem& problem, const Problem& other) {
  require_as_many(other.buildings.size(), problem.buildings.size(), "buildings");
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Building& building = other.buildings[b];
    require_same(alike(problem.buildings[b], building), fmt::format("buildings[{}]", b), building.name);
    require_same(alike_at(b, problem.initial_displacement, other.initial_displacement), "initial_displacement",
                 building.name);
    require_same(alike_at(b, problem.initial_velocity, other.initial_velocity), "initial_velocity", building.name);
    require_same(delay_of(problem, b) == delay_of(other, b), "delays", "others");
  }
  require_as_many(other.points.size(), problem.points.size(), "points");
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const ContactPoint& point = other.points[i];
    require_same(alike(problem.points[i], point), fmt::format("points[{}]", i),
                 fmt::format("floors {} and {} of gap {}", point.left_floor, point.right_floor, point.left));
  }
  require_as_many(other.watched.size(), problem.watched.size(), "watched");
  for (std::size_t i = 0; i < problem.watched.size(); ++i) {
    require_same(alike(problem.watched[i], other.watched[i]), fmt::format("watched[{}]", i),
                 fmt::format("floor {} of gap {}", other.watched[i].floor, other.watched[i].left));
  }
  require_as_many(other.links.size(), problem.links.size(), "links");
  for (std::size_t i = 0; i < problem.links.size(); ++i) {
    require_same(alike(problem.links[i], other.links[i]), fmt::format("links[{}]", i),
                 std::string(other.links[i].law->name()));
  }
  require_same(alike(problem.motion, other.motion), "motion", "another one");
  require_same(problem.kinematics == other.kinematics, "kinematics",
               other.kinematics == Kinematics::absolute ? "absolute" : "relative");
  require_same(problem.collapse_drift == other.collapse_drift, "collapse_drift",
               fmt::format("{}", other.collapse_drift));
  require_same(problem.duration == other.duration, "duration", fmt::format("{}", other.duration));
  require_same(problem.goes_on == other.goes_on, "goes_on", fmt::format("{}", other.goes_on));
}

}  // namespace bentur
