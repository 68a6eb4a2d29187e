#include <fmt/format.h>

#include <algorithm>

#include "bentur/core/algebra/factors.h"
#include "bentur/io/case/plan/plan_parts.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"
#include "bentur/structure/plan/plan_masses.h"

namespace bentur {
namespace {

/// What each bearing carries of slab and floors [force], as those of one vertical stiffness below a rigid slab do;
/// empty where bearings on one line do not hold it against tilting.
std::vector<double> weights_on(const PlanIsolation& isolation, const Plan& plan, double gravity) {
  double mass = isolation.mass;
  PlanPoint moment = isolation.mass * isolation.centre;
  for (std::size_t f = 0; f < plan.masses.size(); ++f) {
    mass += plan.masses[f];
    moment += plan.masses[f] * centre_of_mass(plan, static_cast<Eigen::Index>(f));
  }
  const auto count = static_cast<Eigen::Index>(isolation.bearings.size());
  Eigen::Matrix3Xd lever(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const PlanPoint arm = (isolation.bearings[i].at - moment / mass) / plan.footprint.size.maxCoeff();
    lever.col(i) << 1, arm.x(), arm.y();
  }
  const Eigen::Vector3d borne(mass * gravity, 0, 0);
  const Eigen::VectorXd weights = least_norm_solution(lever, borne);  // of least norm
  if (!((lever * weights - borne).norm() <= 1e-9 * borne.norm())) return {};
  return {weights.begin(), weights.end()};
}

/// Sides of the polygon within which bearings of a kind yield; nothing where they are no such number.
std::optional<int> read_sides(const TableView& kind, const ReadBearings& read) {
  const auto sides = static_cast<int>(kind.whole("yield_sides").value_or(PolygonYield::least_sides));
  if (sides % 4 != 0) {
    kind.find("yield_sides")->error_value("must be a multiple of 4: x and y are alike");
    return std::nullopt;
  }
  const bool is_linear = read.law == &bearing_laws().front() && !kind.has("characteristic_strength");
  if (sides > PolygonYield::least_sides && is_linear) {
    kind.find("yield_sides")->error_value("needs bearings that yield: characteristic_strength or friction_pendulum");
    return std::nullopt;
  }
  return sides;
}

/// The kind of each bearing, with the table that says it.
struct Kind {
  TomlView table;
  ReadBearings read;
};

void make_bearings(const std::vector<Kind>& kinds, const Plan& plan, double gravity, PlanIsolation& isolation) {
  const std::vector<double> weights = weights_on(isolation, plan, gravity);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const Kind& kind = kinds[i];
    const bool by_weight = kind.read.law != &bearing_laws().front();
    if (by_weight && (weights.empty() || !(weights[i] > 0))) {
      kind.table.error(weights.empty()
                           ? "carries a weight that is not known: bearings stand on one line that is not below the "
                             "centre of all mass"
                           : fmt::format("lifts off at ({}, {}): all weight above is too far from there",
                                         isolation.bearings[i].at.x(), isolation.bearings[i].at.y()));
      return;
    }
    try {
      isolation.bearings[i].bearing =
          *kind.read.law->make({.numbers = kind.read.numbers, .weight = by_weight ? weights[i] : 1.0});
    } catch (const std::exception& error) {
      kind.table.error(std::string("cannot be computed with: ") + error.what());
      return;
    }
  }
}

}  // namespace

std::optional<PlanIsolation> read_isolation(const TomlView& given, const Plan& plan, double gravity) {
  const auto table = TableView::of(given, isolation_keys());
  if (!table) return std::nullopt;
  const TableView& view = *table;
  std::vector<std::string> of_one = bearing_keys().names();
  std::erase(of_one, "at");
  view.refuse(of_one, "is that of a bearing in plan: give it in isolation.bearing");
  PlanIsolation isolation{.mass = view.number("mass").value_or(0), .centre = plan.footprint.middle()};
  if (view.has("centre")) {
    const std::vector<PlanPoint> centre = read_pairs(view, "centre", 0);
    if (centre.size() == 1) isolation.centre = centre.front();
    if (centre.size() == 1 && !plan.footprint.contains(centre.front())) {
      view.find("centre")->error("is outside the footprint");
    }
  }
  isolation.inertia = view.number("inertia").value_or(isolation.mass * plan.footprint.radius2());
  if (!view.has("bearing")) {
    view.error_missing("bearing", "in plan, where one stiffness for all says nothing of torsion");
    return std::nullopt;
  }
  const auto list = view.find("bearing");
  if (!list->is_list_of("tables")) return std::nullopt;
  std::vector<Kind> kinds;
  bool known = true;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const auto kind = TableView::of(list->item(i), bearing_keys());
    if (!kind) return std::nullopt;
    const ReadBearings read = read_bearings(*kind);
    const std::vector<PlanPoint> places = read_pairs(*kind, "at", 0);
    known = known && !places.empty() && read.is_whole;
    if (!std::all_of(places.begin(), places.end(), [&](const PlanPoint& at) { return plan.footprint.contains(at); })) {
      kind->find("at")->error("is outside the footprint");
      known = false;
    }
    const std::optional<int> sides = read_sides(*kind, read);
    known = known && sides;
    for (const PlanPoint& at : places) {
      isolation.bearings.push_back({.at = at,
                                    .bearing = {},
                                    .sides = sides.value_or(PolygonYield::least_sides),
                                    .damping = kind->number("damping").value_or(0)});
      kinds.push_back({list->item(i), read});
    }
  }
  if (!known || isolation.mass <= 0) return std::nullopt;
  const auto elsewhere = [&](const PlanBearing& one) { return one.at != isolation.bearings.front().at; };
  if (std::none_of(isolation.bearings.begin(), isolation.bearings.end(), elsewhere)) {
    list->error("must stand at two places or more: nothing else holds the slab against rotation");
    return std::nullopt;
  }
  make_bearings(kinds, plan, gravity, isolation);
  return isolation;
}

}  // namespace bentur
