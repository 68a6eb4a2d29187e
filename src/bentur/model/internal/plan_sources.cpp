#include "bentur/model/internal/plan_sources.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bentur/model/plan/plan_places.h"

namespace bentur::sources {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

double entry(const VectorXd& list, Index i) { return i < list.size() ? list(i) : not_known; }

constexpr double round_off = 1e-9;  // of the largest free peak of the case

RoundOff round_off_of(const PlanRun& run) {
  double largest = 0, side = 0;
  for (const PlanBuilding& building : run.problem.buildings) {
    side = std::max(side, building.model.footprint.size.maxCoeff());
  }
  for (const PlanPeaks& free : run.response.buildings_no_contact) {
    largest = std::max({largest, free.x.maxCoeff(), free.y.maxCoeff(), 0.5 * side * free.rotation.maxCoeff()});
  }
  return {round_off * largest, round_off * largest / (0.5 * side)};
}

/// An entry of a list over the floors of a building.
double& slot(VectorXd& list, const PlanRun& run, const QuantityPlace& at) {
  const Index floors = run.problem.buildings[at.item].model.floors();
  if (list.size() != floors) list = VectorXd::Constant(floors, not_known);
  return list(at.floor);
}

/// What the list that `find` finds among the peaks of a building has for the floor.
template <class Find>
QuantitySource of_list(PlanBuildings of, Find find) {
  QuantitySource source;
  source.plan.value = [=](const PlanRun& run, const QuantityPlace& at) {
    return entry(find((run.response.*of)[at.item], at), at.floor);
  };
  source.plan.keep = [=](PlanRun& run, const QuantityPlace& at, double value) {
    slot(find((run.response.*of)[at.item], at), run, at) = value;
  };
  return source;
}

QuantitySource in_plan(std::function<double(const PlanRun&, const QuantityPlace&)> value,
                       std::function<void(PlanRun&, const QuantityPlace&, double)> keep = {}) {
  QuantitySource source;
  source.plan.value = std::move(value);
  source.plan.keep = std::move(keep);
  return source;
}

}  // namespace

QuantitySource plan_floors(PlanList list, PlanBuildings of) {
  return of_list(
      of, [list](auto& peaks, const QuantityPlace&) -> auto& { return peaks.*list; });
}

QuantitySource plan_amplification(PlanList list, double RoundOff::*least) {
  return in_plan([=](const PlanRun& run, const QuantityPlace& at) {
    const double free = entry(run.response.buildings_no_contact[at.item].*list, at.floor);
    return free > round_off_of(run).*least ? entry(run.response.buildings[at.item].*list, at.floor) / free : not_known;
  });
}

QuantitySource plan_ratio(PlanList list, PlanList across) {
  return in_plan([=](const PlanRun& run, const QuantityPlace& at) {
    double largest = 0;
    for (const PlanPeaks& free : run.response.buildings_no_contact) {
      for (const VectorXd* const one : {&(free.*list), &(free.*across)}) {
        for (const double value : *one) largest = std::max(largest, value);
      }
    }
    const double free = entry(run.response.buildings_no_contact[at.item].*list, at.floor);
    if (!(free > round_off * largest)) return not_known;
    return ratio_of_peaks(entry(run.response.buildings[at.item].*list, at.floor), free);
  });
}

QuantitySource plan_base_shear(PlanList list) {
  return in_plan([list](const PlanRun& run, const QuantityPlace& at) {
    const PlanBuilding& building = run.problem.buildings[at.item];
    const double weight = weight_of(building.model.floor_masses, run.c.units);
    return building.is_rigid() || weight <= 0 ? not_known : entry(run.response.buildings[at.item].*list, 0) / weight;
  });
}

QuantitySource edge_drift(PlanBuildings of) {
  return in_plan([of](const PlanRun& run, const QuantityPlace& at) {
    return entry((run.response.*of)[at.item].edge_drift_ratio(), at.floor);
  });
}

QuantitySource of_plane(VectorXd PlanPeaks::Plane::*list, PlanBuildings of) {
  return of_list(
      of, [list](auto& peaks, const QuantityPlace& at) -> auto& { return peaks.planes[at.plane].*list; });
}

QuantitySource plan_yielding(VectorXd BuildingPeaks::Yielding::*list, PlanBuildings of) {
  return of_list(
      of, [list](auto& peaks, const QuantityPlace& at) -> auto& { return peaks.planes[at.plane].yielding.*list; });
}

QuantitySource plan_infill(VectorXd BuildingPeaks::Infill::*list) {
  QuantitySource source = of_list(
      &PlanResponse::buildings, [list](auto& peaks, const QuantityPlace& at) -> auto& {
        return peaks.planes[at.plane].frame.infill.*list;
      });
  source.when = list == &BuildingPeaks::Infill::column_demand ? When::infill_columns : When::infill;
  return source;
}

QuantitySource plan_foundation(Index i) {
  return in_plan(
      [i](const PlanRun& run, const QuantityPlace& at) { return entry(run.response.buildings[at.item].foundation, i); },
      [i](PlanRun& run, const QuantityPlace& at, double value) {
        VectorXd& list = run.response.buildings[at.item].foundation;
        if (std::isnan(value)) return;
        if (list.size() == 0) list = VectorXd::Zero(5);
        list(i) = value;
      });
}

QuantitySource of_bearings(VectorXd PlanPeaks::Bearings::*list, bool yields) {
  return in_plan(
      [=](const PlanRun& run, const QuantityPlace& at) {
        const auto& bearings = run.problem.buildings[at.item].model.bearings;
        if (yields && !bearings[static_cast<std::size_t>(at.plane)].law) return not_known;
        return entry(run.response.buildings[at.item].bearings.*list, at.plane);
      },
      [=](PlanRun& run, const QuantityPlace& at, double value) {
        VectorXd& kept = run.response.buildings[at.item].bearings.*list;
        kept.conservativeResize(std::ssize(run.problem.buildings[at.item].model.bearings));
        kept(at.plane) = std::isnan(value) ? 0 : value;
      });
}

QuantitySource of_ground(Index i) {
  return in_plan(
      [i](const PlanRun& run, const QuantityPlace&) { return run.response.peak_ground_acceleration(i); },
      [i](PlanRun& run, const QuantityPlace&, double value) { run.response.peak_ground_acceleration(i) = value; });
}

QuantitySource of_friction(double PlanFriction::*member) {
  return in_plan(
      [member](const PlanRun& run, const QuantityPlace& at) {
        return contact_at(run.problem, at.item).contact->rubbing ? run.response.friction[at.item].*member : not_known;
      },
      [member](PlanRun& run, const QuantityPlace& at, double value) {
        if (!std::isnan(value)) run.response.friction[at.item].*member = value;
      });
}

QuantitySource impact_friction() {
  return in_plan(
      [](const PlanRun& run, const QuantityPlace& at) {
        const Impact& impact = run.response.impacts[at.item];
        return contact_at(run.problem, impact.point).contact->rubbing ? impact.tangential_impulse : not_known;
      },
      [](PlanRun& run, const QuantityPlace& at, double value) {
        if (!std::isnan(value)) run.response.impacts[at.item].tangential_impulse = value;
      });
}

}  // namespace bentur::sources
