#include <algorithm>
#include <cmath>

#include "bentur/pounding/plan/plan_pounding.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What is left of a drift has no end where nothing holds a storey of a frame any more.
bool holds_for_good(const BuildingPeaks& frame) {
  const auto loses = [](const BuildingPeaks::Hinge& hinge) { return hinge.strength_left.has_value(); };
  return frame.columns.empty() && std::none_of(frame.hinges.begin(), frame.hinges.end(), loses);
}

}  // namespace

bool is_finite(const PlanResponse& response) {
  const auto finite = [](const PlanPeaks& peaks) {
    bool all = true;
    const PlanPeaks::Bearings& bearings = peaks.bearings;
    for (const VectorXd* list : {&bearings.x,
                                 &bearings.y,
                                 &bearings.force_x,
                                 &bearings.force_y,
                                 &bearings.residual_x,
                                 &bearings.residual_y,
                                 &bearings.hysteretic_energy,
                                 &peaks.x,
                                 &peaks.y,
                                 &peaks.south,
                                 &peaks.north,
                                 &peaks.west,
                                 &peaks.east,
                                 &peaks.rotation,
                                 &peaks.acceleration_x,
                                 &peaks.acceleration_y,
                                 &peaks.angular_acceleration,
                                 &peaks.shear_x,
                                 &peaks.shear_y,
                                 &peaks.torque,
                                 &peaks.foundation,
                                 &peaks.column_forces}) {
      all = all && list->allFinite();
    }
    const Index slabs = bearings.x.size() > 0 ? 1 : 0;  // no plane is below one
    const auto of_storeys = [&](const VectorXd& list) {
      return list.size() == 0 || list.tail(list.size() - slabs).allFinite();
    };
    for (const VectorXd* list : {&peaks.drift_south, &peaks.drift_north, &peaks.drift_west, &peaks.drift_east}) {
      all = all && of_storeys(*list);
    }
    return all && std::all_of(peaks.planes.begin(), peaks.planes.end(), [&](const PlanPeaks::Plane& plane) {
             return of_storeys(plane.drift_ratio) && of_storeys(plane.shear) &&
                    (of_storeys(plane.yielding.residual_drift_ratio) || !holds_for_good(plane.frame)) &&
                    plane.yielding.hysteretic_energy.allFinite();
           });
  };
  return std::all_of(response.buildings.begin(), response.buildings.end(), finite) &&
         std::all_of(response.buildings_no_contact.begin(), response.buildings_no_contact.end(), finite) &&
         std::all_of(
             response.friction.begin(), response.friction.end(),
             [](const PlanFriction& p) {
               return std::isfinite(p.peak_tangential_force + p.tangential_impulse + p.sliding + p.friction_loss);
             }) &&
         std::all_of(response.links.begin(), response.links.end(),
                     [](const LinkSummary& link) {
                       return std::isfinite(link.peak_compression + link.peak_tension + link.peak_closing +
                                            link.peak_opening + link.energy_dissipated);
                     }) &&
         std::all_of(response.watched.begin(), response.watched.end(),
                     [](const WatchedSummary& w) { return std::isfinite(w.gap_needed + w.least_opening); }) &&
         std::all_of(response.points.begin(), response.points.end(), [](const PointSummary& p) {
           return std::isfinite(p.gap_needed + p.contact_duration + p.peak_force + p.peak_tension + p.peak_penetration +
                                p.peak_closing_speed + p.impulse + p.energy_lost);
         });
}

}  // namespace bentur
