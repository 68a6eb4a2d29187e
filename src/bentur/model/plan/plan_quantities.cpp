#include "bentur/model/plan/plan_quantities.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/model/internal/quantity_column.h"
#include "bentur/model/plan/plan_pair.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Lists = VectorXd PlanPeaks::*;
using Value = std::function<double(const PlanRun&, const PlanPlace&)>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double entry(const VectorXd& list, Index i) { return i < list.size() ? list(i) : none; }

/// A free peak below this is round-off, and has no amplification.
struct RoundOff {
  double displacement = 0;  ///< of the largest free peak of the case, rotations times half the longest side [length]
  double rotation = 0;      ///< that over this half [rad]
};

RoundOff round_off_of(const PlanRun& run) {
  constexpr double round_off = 1e-9;
  double largest = 0, side = 0;
  for (const PlanBuilding& building : run.problem.buildings) {
    side = std::max(side, building.model.footprint.size.maxCoeff());
  }
  for (const PlanPeaks& free : run.response.buildings_no_contact) {
    largest = std::max({largest, free.x.maxCoeff(), free.y.maxCoeff(), 0.5 * side * free.rotation.maxCoeff()});
  }
  return {round_off * largest, round_off * largest / (0.5 * side)};
}

using Keep = std::function<void(PlanRun&, const PlanPlace&, double)>;
/// How a quantity is told, and how what was read of it is kept.
struct Source {
  Value value;
  Keep keep = {};
};

/// An entry of a list over the floors of a building.
double& slot(VectorXd& list, const PlanRun& run, const PlanPlace& at) {
  const Index floors = run.problem.buildings[at.item].model.floors();
  if (list.size() != floors) list = VectorXd::Constant(floors, none);
  return list(at.floor);
}

Source of_floors(std::vector<PlanPeaks> PlanResponse::*of, Lists list) {
  return {[=](const PlanRun& run, const PlanPlace& at) { return entry((run.response.*of)[at.item].*list, at.floor); },
          [=](PlanRun& run, const PlanPlace& at, double value) {
            slot((run.response.*of)[at.item].*list, run, at) = value;
          }};
}
Source with(Lists list) { return of_floors(&PlanResponse::buildings, list); }
Source without(Lists list) { return of_floors(&PlanResponse::buildings_no_contact, list); }
Source amplification(Lists list, double RoundOff::*least) {
  return {[=, peak = with(list).value, alone = without(list).value](const PlanRun& run, const PlanPlace& at) {
    const double free = alone(run, at);
    return free > round_off_of(run).*least ? peak(run, at) / free : none;
  }};
}

Source edge_drift() {
  return {[](const PlanRun& run, const PlanPlace& at) {
    return entry(run.response.buildings[at.item].edge_drift_ratio(), at.floor);
  }};
}

/// Of a plane the list that `find` finds.
template <class Find>
Source of_planes(std::vector<PlanPeaks> PlanResponse::*of, Find find) {
  return {[=](const PlanRun& run, const PlanPlace& at) {
            return entry(find((run.response.*of)[at.item].planes[at.plane]), at.floor);
          },
          [=](PlanRun& run, const PlanPlace& at, double value) {
            slot(find((run.response.*of)[at.item].planes[at.plane]), run, at) = value;
          }};
}
Source of_plane(VectorXd PlanPeaks::Plane::*list) {
  return of_planes(
      &PlanResponse::buildings, [list](auto& plane) -> auto& { return plane.*list; });
}
Source of_yielding(VectorXd BuildingPeaks::Yielding::*list,
                   std::vector<PlanPeaks> PlanResponse::*of = &PlanResponse::buildings) {
  return of_planes(
      of, [list](auto& plane) -> auto& { return plane.yielding.*list; });
}
/// Of the foundation of a building, in the order of PlanPeaks::foundation.
Source of_foundation(Index i) {
  return {[i](const PlanRun& run, const PlanPlace& at) { return entry(run.response.buildings[at.item].foundation, i); },
          [i](PlanRun& run, const PlanPlace& at, double value) {
            VectorXd& list = run.response.buildings[at.item].foundation;
            if (std::isnan(value)) return;
            if (list.size() == 0) list = VectorXd::Zero(5);
            list(i) = value;
          }};
}
Source of_bearings(VectorXd PlanPeaks::Bearings::*list, bool yields = false) {
  return {[=](const PlanRun& run, const PlanPlace& at) {
            const auto& bearings = run.problem.buildings[at.item].model.bearings;
            if (yields && !bearings[static_cast<std::size_t>(at.plane)].law) return none;
            return entry(run.response.buildings[at.item].bearings.*list, at.plane);
          },
          [=](PlanRun& run, const PlanPlace& at, double value) {
            VectorXd& kept = run.response.buildings[at.item].bearings.*list;
            kept.conservativeResize(std::ssize(run.problem.buildings[at.item].model.bearings));
            kept(at.plane) = std::isnan(value) ? 0 : value;
          }};
}
/// Of the ground along x, 0, or y.
Source of_ground(Index i) {
  return {[i](const PlanRun& run, const PlanPlace&) { return run.response.peak_ground_acceleration(i); },
          [i](PlanRun& run, const PlanPlace&, double value) { run.response.peak_ground_acceleration(i) = value; }};
}
Source of_friction(double PlanFriction::*member) {
  return {[member](const PlanRun& run, const PlanPlace& at) {
            return contact_at(run.problem, at.item).contact->rubbing ? run.response.friction[at.item].*member : none;
          },
          [member](PlanRun& run, const PlanPlace& at, double value) {
            if (!std::isnan(value)) run.response.friction[at.item].*member = value;
          }};
}
Source impact_friction() {
  return {[](const PlanRun& run, const PlanPlace& at) {
            const Impact& impact = run.response.impacts[at.item];
            return contact_at(run.problem, impact.point).contact->rubbing ? impact.tangential_impulse : none;
          },
          [](PlanRun& run, const PlanPlace& at, double value) {
            if (!std::isnan(value)) run.response.impacts[at.item].tangential_impulse = value;
          }};
}

/// A member of each point or impact.
template <class Item, class Member>
Source of_items(std::vector<Item> PlanResponse::*list, Member Item::*member) {
  return {[=](const PlanRun& run, const PlanPlace& at) {
            return static_cast<double>((run.response.*list)[at.item].*member);
          },
          [=](PlanRun& run, const PlanPlace& at, double value) {
            (run.response.*list)[at.item].*member = static_cast<Member>(value);
          }};
}
Source of_time(std::optional<double> PointSummary::*member) {
  return {
      [=](const PlanRun& run, const PlanPlace& at) { return (run.response.points[at.item].*member).value_or(none); },
      [=](PlanRun& run, const PlanPlace& at, double value) {
        if (!std::isnan(value)) run.response.points[at.item].*member = value;
      }};
}

/// Where a plan has what a quantity of a row's points or impacts tells; empty where it has not.
Source of_row(const Quantity& quantity) {
  const auto& source = quantity.source;
  if (quantity.key == "point_width") {
    return {[](const PlanRun& run, const PlanPlace& at) {
      const PlanContactPlace place = contact_at(run.problem, at.item);
      return run.problem.gaps[place.gap].stretch.width_at(place.contact->along);
    }};
  }
  if (quantity.key == "point_gap_needed_reversed") {
    const Source told = of_time(&PointSummary::gap_needed_reversed);
    return {[told](const PlanRun& run, const PlanPlace& at) {
              return run.c.analysis.both_ways ? told.value(run, at) : none;
            },
            told.keep};
  }
  if (const auto* const real = std::get_if<double PointSummary::*>(&source)) {
    return of_items(&PlanResponse::points, *real);
  }
  if (const auto* const count = std::get_if<int PointSummary::*>(&source)) {
    return of_items(&PlanResponse::points, *count);
  }
  if (const auto* const time = std::get_if<std::optional<double> PointSummary::*>(&source)) return of_time(*time);
  if (quantity.owner == Owner::gap) {
    return {[quantity](const PlanRun& run, const PlanPlace& at) {
      const RunResults pair = pair_of(run, at.item);
      const RunView view = pair.view();
      const bool asked = quantity.key != "gap_needed_reversed" || run.c.analysis.both_ways;
      return asked ? value_of(quantity, view, {}) : none;
    }};
  }
  if (const auto* const real = std::get_if<double LinkSummary::*>(&source)) {
    return of_items(&PlanResponse::links, *real);
  }
  if (quantity.owner != Owner::impact) return {};
  if (quantity.key == "restitution") {
    return {[](const PlanRun& run, const PlanPlace& at) {
      return run.response.impacts[at.item].restitution().value_or(none);
    }};
  }
  if (quantity.key == "duration") {
    return {[](const PlanRun& run, const PlanPlace& at) {
      return run.response.impacts[at.item].end - run.response.impacts[at.item].start;
    }};
  }
  if (const auto* const real = std::get_if<double Impact::*>(&source)) {
    return of_items(&PlanResponse::impacts, *real);
  }
  if (const auto* const flag = std::get_if<bool Impact::*>(&source)) {
    return of_items(&PlanResponse::impacts, *flag);
  }
  return {};
}

template <class Value>
double number_of(const Value& value) {
  return static_cast<double>(value);
}
double number_of(const std::optional<double>& value) { return value.value_or(none); }

/// A member of each hinge of frames, or of each column that can break.
template <class Item, class Member>
Source of_frames(std::vector<Item> BuildingPeaks::*list, Member Item::*member) {
  return {[=](const PlanRun& run, const PlanPlace& at) {
            const std::vector<Item>& items = run.response.buildings[at.item].planes[at.plane].frame.*list;
            return at.floor < std::ssize(items) ? number_of(items[at.floor].*member) : none;
          },
          [=](PlanRun& run, const PlanPlace& at, double value) {
            std::vector<Item>& items = run.response.buildings[at.item].planes[at.plane].frame.*list;
            if (std::ssize(items) <= at.floor) items.resize(static_cast<std::size_t>(at.floor) + 1);
            if (!std::isnan(value)) items[at.floor].*member = static_cast<Member>(value);
          }};
}

/// What the quantity of a row's hinges or columns tells, of those of frames in plan.
Source of_row_frame(const Quantity& quantity) {
  Source source;
  const auto take = [&](auto list, const auto* member) {
    if (member != nullptr) source = of_frames(list, *member);
  };
  take(&BuildingPeaks::hinges, std::get_if<double BuildingPeaks::Hinge::*>(&quantity.source));
  take(&BuildingPeaks::hinges, std::get_if<int BuildingPeaks::Hinge::*>(&quantity.source));
  take(&BuildingPeaks::hinges, std::get_if<std::optional<double> BuildingPeaks::Hinge::*>(&quantity.source));
  take(&BuildingPeaks::columns, std::get_if<double BuildingPeaks::Breaking::*>(&quantity.source));
  take(&BuildingPeaks::columns, std::get_if<std::optional<double> BuildingPeaks::Breaking::*>(&quantity.source));
  return source;
}

/// One of the list below.
struct Line {
  PlanOwner owner = PlanOwner::floor;
  Quantity told;
  Source source;
  PlanQuantity::When when = PlanQuantity::When::always;
};

constexpr PlanOwner floor = PlanOwner::floor, plane_ = PlanOwner::plane, building = PlanOwner::building,
                    bearing = PlanOwner::bearing, point = PlanOwner::point, gap = PlanOwner::gap,
                    impact = PlanOwner::impact;
constexpr PlanQuantity::When moving = PlanQuantity::When::of_what_moves, known = PlanQuantity::When::where_known,
                             lossy = PlanQuantity::When::where_strength_goes;

// clang-format off
std::deque<Line> list() {
  const Owner of = Owner::floor;
  std::deque<Line> all = {
      // Floors, and the storeys below them.
      {floor, {"peak_displacement_x", of, "L", "max |u_x|", "largest displacement along x of the centre of mass relative to the own base", {"Along x", "Sepanjang x"}, {}}, with(&PlanPeaks::x)},
      {floor, {"peak_displacement_x_no_contact", of, "L", "max |u_x⁰|", "largest displacement along x with contact switched off", {"Without contact", "Tanpa kontak"}, {}}, without(&PlanPeaks::x), moving},
      {floor, {"amplification_x", of, "1", "max |u_x| / max |u_x⁰|", "largest displacement along x over that with contact switched off", {}, {}}, amplification(&PlanPeaks::x, &RoundOff::displacement), moving},
      {floor, {"peak_displacement_y", of, "L", "max |u_y|", "largest displacement along y of the centre of mass relative to the own base", {"Along y", "Sepanjang y"}, {}}, with(&PlanPeaks::y)},
      {floor, {"peak_displacement_y_no_contact", of, "L", "max |u_y⁰|", "largest displacement along y with contact switched off", {"Without contact", "Tanpa kontak"}, {}}, without(&PlanPeaks::y), moving},
      {floor, {"amplification_y", of, "1", "max |u_y| / max |u_y⁰|", "largest displacement along y over that with contact switched off", {}, {}}, amplification(&PlanPeaks::y, &RoundOff::displacement), moving},
      {floor, {"peak_rotation", of, "rad", "max |θ|", "largest rotation", {"Rotation", "Rotasi"}, {}, {}, "mrad", 1e3}, with(&PlanPeaks::rotation)},
      {floor, {"peak_rotation_no_contact", of, "rad", "max |θ⁰|", "largest rotation with contact switched off", {"Without contact", "Tanpa kontak"}, {}, {}, "mrad", 1e3}, without(&PlanPeaks::rotation), moving},
      {floor, {"amplification_rotation", of, "1", "max |θ| / max |θ⁰|", "largest rotation over that with contact switched off", {}, {}}, amplification(&PlanPeaks::rotation, &RoundOff::rotation), moving},
      {floor, {"peak_displacement_south", of, "L", "max |u_x|", "largest displacement along x of the lower edge", {}, {}, "/peak_edge_displacement/south"}, with(&PlanPeaks::south), moving},
      {floor, {"peak_displacement_south_no_contact", of, "L", "max |u_x⁰|", "largest displacement along x of the lower edge with contact switched off", {}, {}, "/peak_edge_displacement_no_contact/south"}, without(&PlanPeaks::south), moving},
      {floor, {"peak_displacement_north", of, "L", "max |u_x|", "largest displacement along x of the upper edge", {}, {}, "/peak_edge_displacement/north"}, with(&PlanPeaks::north), moving},
      {floor, {"peak_displacement_north_no_contact", of, "L", "max |u_x⁰|", "largest displacement along x of the upper edge with contact switched off", {}, {}, "/peak_edge_displacement_no_contact/north"}, without(&PlanPeaks::north), moving},
      {floor, {"peak_displacement_west", of, "L", "max |u_y|", "largest displacement along y of the left edge", {}, {}, "/peak_edge_displacement/west"}, with(&PlanPeaks::west), moving},
      {floor, {"peak_displacement_west_no_contact", of, "L", "max |u_y⁰|", "largest displacement along y of the left edge with contact switched off", {}, {}, "/peak_edge_displacement_no_contact/west"}, without(&PlanPeaks::west), moving},
      {floor, {"peak_displacement_east", of, "L", "max |u_y|", "largest displacement along y of the right edge", {}, {}, "/peak_edge_displacement/east"}, with(&PlanPeaks::east), moving},
      {floor, {"peak_displacement_east_no_contact", of, "L", "max |u_y⁰|", "largest displacement along y of the right edge with contact switched off", {}, {}, "/peak_edge_displacement_no_contact/east"}, without(&PlanPeaks::east), moving},
      {floor, {"peak_acceleration_x", of, "L s-2", "max |ü_x + a_x|", "largest absolute acceleration along x", {"Acceleration x", "Percepatan x"}, {}}, with(&PlanPeaks::acceleration_x)},
      {floor, {"peak_acceleration_y", of, "L s-2", "max |ü_y + a_y|", "largest absolute acceleration along y", {"Acceleration y", "Percepatan y"}, {}}, with(&PlanPeaks::acceleration_y)},
      {floor, {"peak_angular_acceleration", of, "rad s-2", "max |θ̈|", "largest angular acceleration", {"Angular acceleration", "Percepatan sudut"}, {}}, with(&PlanPeaks::angular_acceleration), moving},
      {floor, {"peak_storey_shear_x", of, "F", "max |V_x|", "largest storey shear along x, without dashpots", {"Storey shear x", "Gaya geser tingkat x"}, {}}, with(&PlanPeaks::shear_x), moving},
      {floor, {"peak_storey_shear_y", of, "F", "max |V_y|", "largest storey shear along y, without dashpots", {"Storey shear y", "Gaya geser tingkat y"}, {}}, with(&PlanPeaks::shear_y), moving},
      {floor, {"peak_storey_torque", of, "F L", "max |T|", "largest torque of the storey about the centre of mass of the floor above", {"Torque", "Torsi"}, {}}, with(&PlanPeaks::torque), moving},
      // Of buildings without planes.
      {floor, {"peak_drift_ratio", of, "1", "max |Δ|/h", "largest drift of an edge along itself over storey height, of a building without planes", {"Drift at an edge", "Simpangan di tepi"}, {}, {}, "%", 100}, edge_drift(), known},
      {floor, {"peak_drift_ratio_south", of, "1", "max |Δ_x|/h", "largest drift along x of the lower edge over storey height", {}, {}, "/peak_edge_drift_ratio/south", "%", 100}, with(&PlanPeaks::drift_south), known},
      {floor, {"peak_drift_ratio_north", of, "1", "max |Δ_x|/h", "largest drift along x of the upper edge over storey height", {}, {}, "/peak_edge_drift_ratio/north", "%", 100}, with(&PlanPeaks::drift_north), known},
      {floor, {"peak_drift_ratio_west", of, "1", "max |Δ_y|/h", "largest drift along y of the left edge over storey height", {}, {}, "/peak_edge_drift_ratio/west", "%", 100}, with(&PlanPeaks::drift_west), known},
      {floor, {"peak_drift_ratio_east", of, "1", "max |Δ_y|/h", "largest drift along y of the right edge over storey height", {}, {}, "/peak_edge_drift_ratio/east", "%", 100}, with(&PlanPeaks::drift_east), known},
      // Storeys of planes, by the floor above them.
      {plane_, {"peak_drift_ratio", of, "1", "max |Δ|/h", "largest drift of the plane over storey height", {"Drift", "Simpangan antartingkat"}, {}, {}, "%", 100}, of_plane(&PlanPeaks::Plane::drift_ratio)},
      {plane_, {"peak_shear", of, "F", "max |V|", "largest force of the plane", {"Force", "Gaya"}, {}}, of_plane(&PlanPeaks::Plane::shear)},
      {plane_, {"ductility", of, "1", "max |Δ|/Δ_y", "largest drift of the plane over that at yield", {"Ductility", "Daktilitas"}, {}, {}, {}, 1, 3}, of_yielding(&BuildingPeaks::Yielding::ductility), known},
      {plane_, {"ductility_no_contact", of, "1", "max |Δ⁰|/Δ_y", "largest drift of the plane over that at yield with contact switched off", {}, {}}, of_yielding(&BuildingPeaks::Yielding::ductility, &PlanResponse::buildings_no_contact), known},
      {plane_, {"residual_drift_ratio", of, "1", "Δ_r/h", "drift of the plane left after unloading at the end over storey height", {"Residual drift", "Simpangan sisa"}, {}, {}, "%", 100}, of_yielding(&BuildingPeaks::Yielding::residual_drift_ratio), known},
      {plane_, {"hysteretic_energy", of, "F L", "E_h", "energy that the storey of the plane has dissipated by yielding", {"Energy by yielding", "Energi leleh"}, {}}, of_yielding(&BuildingPeaks::Yielding::hysteretic_energy), known},
      {plane_, {"strength_left", of, "1", "V_c/V_c⁰", "largest force that the plane can still reach at the end over that at first, of its weaker side", {"Strength left", "Kekuatan tersisa"}, {}, {}, "%", 100}, of_yielding(&BuildingPeaks::Yielding::strength_left), lossy},
      {plane_, {"capped_time", of, "s", "t_c", "when the storey of the plane first softened", {"Softens at", "Melunak saat"}, {}}, of_yielding(&BuildingPeaks::Yielding::capped_time), lossy},
      {plane_, {"residual_time", of, "s", "t_r", "when the storey of the plane first was down to its residual strength", {"Residual at", "Sisa saat"}, {}}, of_yielding(&BuildingPeaks::Yielding::residual_time), lossy},
      {plane_, {"failed_time", of, "s", "t_u", "when the storey of the plane failed", {"Fails at", "Gagal saat"}, {}}, of_yielding(&BuildingPeaks::Yielding::failed_time), lossy},
      {plane_, {"strength_left_no_contact", of, "1", "V_c/V_c⁰", "largest force that the plane can still reach at the end over that at first, with contact switched off", {}, {}, {}, "%", 100}, of_yielding(&BuildingPeaks::Yielding::strength_left, &PlanResponse::buildings_no_contact), lossy},
      // Foundations on soil.
      {building, {"peak_sway_x", Owner::building, "L", "max |u_x|", "largest sway of the foundation along x relative to the free field", {"Sway x", "Goyangan x"}, {}, "/soil/peak_sway_x"}, of_foundation(0), known},
      {building, {"peak_sway_y", Owner::building, "L", "max |u_y|", "largest sway of the foundation along y relative to the free field", {"Sway y", "Goyangan y"}, {}, "/soil/peak_sway_y"}, of_foundation(1), known},
      {building, {"peak_rocking_x", Owner::building, "rad", "max |ψ_x|", "largest rocking of the foundation that moves what is above along x", {"Rocking x", "Guling x"}, {}, "/soil/peak_rocking_x", "mrad", 1e3}, of_foundation(2), known},
      {building, {"peak_rocking_y", Owner::building, "rad", "max |ψ_y|", "largest rocking of the foundation that moves what is above along y", {"Rocking y", "Guling y"}, {}, "/soil/peak_rocking_y", "mrad", 1e3}, of_foundation(3), known},
      {building, {"peak_twist", Owner::building, "rad", "max |θ_b|", "largest twist of the foundation about the vertical", {"Twist", "Puntir"}, {}, "/soil/peak_twist", "mrad", 1e3}, of_foundation(4), known},
      // Bearings below a slab.
      {bearing, {"peak_displacement_x", Owner::bearing, "L", "max |Δ_x|", "largest displacement of the bearing along x", {"Along x", "Sepanjang x"}, {}}, of_bearings(&PlanPeaks::Bearings::x)},
      {bearing, {"peak_displacement_y", Owner::bearing, "L", "max |Δ_y|", "largest displacement of the bearing along y", {"Along y", "Sepanjang y"}, {}}, of_bearings(&PlanPeaks::Bearings::y)},
      {bearing, {"peak_force_x", Owner::bearing, "F", "max |F_x|", "largest force of the bearing along x, without its dashpot", {"Force x", "Gaya x"}, {}}, of_bearings(&PlanPeaks::Bearings::force_x)},
      {bearing, {"peak_force_y", Owner::bearing, "F", "max |F_y|", "largest force of the bearing along y, without its dashpot", {"Force y", "Gaya y"}, {}}, of_bearings(&PlanPeaks::Bearings::force_y)},
      {bearing, {"residual_x", Owner::bearing, "L", "|Δ_x,r|", "displacement along x at the end at which the bearing would rest without force", {"Residual x", "Sisa x"}, {}}, of_bearings(&PlanPeaks::Bearings::residual_x, true), known},
      {bearing, {"residual_y", Owner::bearing, "L", "|Δ_y,r|", "displacement along y at the end at which the bearing would rest without force", {"Residual y", "Sisa y"}, {}}, of_bearings(&PlanPeaks::Bearings::residual_y, true), known},
      {bearing, {"hysteretic_energy", Owner::bearing, "F L", "E_h", "energy that the bearing dissipated by yielding along x and y", {"Dissipated", "Diserap"}, {}}, of_bearings(&PlanPeaks::Bearings::hysteretic_energy, true), known},
  };
  for (const Quantity* const quantity : quantities_of(Owner::hinge)) {
    all.push_back({PlanOwner::hinge, *quantity, of_row_frame(*quantity), is_of_weakening(*quantity) ? lossy : PlanQuantity::When::always});
  }
  for (const Quantity* const quantity : quantities_of(Owner::column)) {
    all.push_back({PlanOwner::column, *quantity, of_row_frame(*quantity)});
  }
  for (const Quantity* const quantity : quantities_of(Owner::point)) {
    if (Source source = of_row(*quantity); source.value) all.push_back({point, *quantity, std::move(source)});
  }
  all.push_back({point, {"peak_tangential_force", Owner::point, "F", "max |F_t|", "largest force along the joint", {"Along the joint", "Sepanjang celah"}, {}}, of_friction(&PlanFriction::peak_tangential_force), known});
  all.push_back({point, {"tangential_impulse", Owner::point, "F s", "Σ ∫F_t dt", "impulse along the joint of all impacts", {"Impulse along it", "Impuls sepanjang itu"}, {}}, of_friction(&PlanFriction::tangential_impulse), known});
  all.push_back({point, {"sliding", Owner::point, "L", "Σ |Δs|", "path slid along the joint", {"Slides", "Menggeser"}, {}}, of_friction(&PlanFriction::sliding), known});
  all.push_back({point, {"friction_loss", Owner::point, "F L", "Σ E_t", "energy that friction dissipated", {"Lost by friction", "Hilang oleh gesekan"}, {}}, of_friction(&PlanFriction::friction_loss), known});
  for (const Quantity* const quantity : quantities_of(Owner::link)) {
    if (Source source = of_row(*quantity); source.value) all.push_back({PlanOwner::link, *quantity, std::move(source)});
  }
  for (const Quantity* const quantity : quantities_of(Owner::gap)) all.push_back({gap, *quantity, of_row(*quantity)});
  all.push_back({PlanOwner::run, {"peak_ground_acceleration_x", Owner::run, "L s-2", "PGA_x", "peak ground acceleration along x as applied", {}, {}, "/excitation/peak_ground_acceleration_x"}, of_ground(0)});
  all.push_back({PlanOwner::run, {"peak_ground_acceleration_y", Owner::run, "L s-2", "PGA_y", "peak ground acceleration along y as applied", {}, {}, "/excitation/peak_ground_acceleration_y"}, of_ground(1)});
  all.push_back({PlanOwner::run, quantity_named("end_time", Owner::run), {[](const PlanRun& run, const PlanPlace&) { return run.response.collapse ? run.response.collapse->time : run.response.duration; }}});
  all.push_back({PlanOwner::run, quantity_named("collapsed", Owner::run), {[](const PlanRun& run, const PlanPlace&) { return run.response.collapse ? 1.0 : 0.0; }}});
  all.push_back({PlanOwner::run, quantity_named("remarks", Owner::run), {[](const PlanRun& run, const PlanPlace&) { return static_cast<double>(run.remarks.size()); }}});
  all.push_back({PlanOwner::run, quantity_named("doubts", Owner::run), {[](const PlanRun& run, const PlanPlace&) { return static_cast<double>(count_of_doubts(run.remarks)); }}});
  all.push_back({PlanOwner::run, quantity_named("remark_kinds", Owner::run), {[](const PlanRun& run, const PlanPlace&) { return static_cast<double>(remark_kinds(run.remarks)); }}});
  for (const Quantity* const quantity : quantities_of(Owner::impact)) {
    if (Source source = of_row(*quantity); source.value) all.push_back({impact, *quantity, std::move(source)});
  }
  all.push_back({impact, {"tangential_impulse", Owner::impact, "F s", "∫F_t dt", "impulse along the joint", {"Along the joint", "Sepanjang celah"}, {}}, impact_friction(), known});
  return all;
}
// clang-format on

/// What a run has of these units at most, of its lengths, accelerations and forces; turning at the longest side.
double size_of(const PlanRun& run, std::string_view units) {
  double displacement = 0, acceleration = 0, force = 0, side = 0;
  for (const PlanBuilding& one : run.problem.buildings) side = std::max(side, one.model.footprint.size.maxCoeff());
  const auto most = [](double& of, std::initializer_list<const VectorXd*> lists) {
    for (const VectorXd* const list : lists) {
      for (const double value : *list) of = std::max(of, value);
    }
  };
  for (const PlanPeaks& peaks : run.response.buildings) {
    most(displacement, {&peaks.x, &peaks.y});
    most(acceleration, {&peaks.acceleration_x, &peaks.acceleration_y});
    most(force, {&peaks.shear_x, &peaks.shear_y});
  }
  for (const PointSummary& one : run.response.points) force = std::max(force, one.peak_force);
  if (units == "L") return displacement;
  if (units == "rad") return displacement / side;
  if (units == "L s-2") return acceleration;
  if (units == "rad s-2") return acceleration / side;
  if (units == "F") return force;
  return units == "F L" ? force * displacement : 0;
}

bool is_force(const PlanQuantity& one) {
  const auto names = [&](std::string_view part) { return one.told.key.find(part) != std::string_view::npos; };
  return one.owner == PlanOwner::floor && (names("acceleration") || names("shear") || names("torque"));
}

}  // namespace

const std::deque<PlanQuantity>& plan_quantities() {
  static const std::deque<PlanQuantity> all = [] {
    std::deque<PlanQuantity> made;
    for (Line& line : list()) {
      made.push_back({line.owner, line.told, std::move(line.source.value), line.when, std::move(line.source.keep)});
    }
    return made;
  }();
  return all;
}

const PlanQuantity& plan_quantity_named(std::string_view key, PlanOwner owner) {
  for (const PlanQuantity& one : plan_quantities()) {
    if (one.told.key == key && one.owner == owner) return one;
  }
  throw InvalidParameter("quantity", std::string(key), "must be one of plan_quantities()");
}

std::vector<double> values_at(const PlanQuantity& quantity, const PlanRun& run, const std::vector<PlanPlace>& places) {
  using When = PlanQuantity::When;
  std::vector<double> values;
  if (places.empty()) return values;
  if (quantity.when == When::of_what_moves && run.problem.buildings[places.front().item].is_rigid()) return values;
  for (const PlanPlace& at : places) values.push_back(quantity.value(run, at));
  const auto is_none = [](double value) { return std::isnan(value); };
  const bool left_out = quantity.when == When::where_known || quantity.when == When::where_strength_goes;
  if (left_out && std::all_of(values.begin(), values.end(), is_none)) values.clear();
  return values;
}

ShownUnits shown_units(const PlanRun& run) {
  double largest = 0;
  for (const PointSummary& one : run.response.points) largest = std::max({largest, one.peak_force, one.peak_tension});
  for (const PlanPeaks& peaks : run.response.buildings) {
    for (const VectorXd* const list : {&peaks.shear_x, &peaks.shear_y}) {
      for (const double shear : *list) largest = std::max(largest, shear);
    }
  }
  return shown_units(run.c.units, largest);
}

std::vector<TableColumn> table_columns(PlanOwner owner, bool of_forces, const PlanRun& run,
                                       const std::vector<PlanPlace>& places, std::size_t language) {
  const ShownUnits shown = shown_units(run);
  std::vector<TableColumn> columns;
  for (const PlanQuantity& one : plan_quantities()) {
    if (one.owner != owner || one.told.label[language].empty() || is_force(one) != of_forces) continue;
    std::vector<double> values = values_at(one, run, places);
    const bool is_known = !std::all_of(values.begin(), values.end(), [](double value) { return std::isnan(value); });
    if (!is_known) continue;
    const double least = 1e-12 * size_of(run, one.told.units);
    for (double& value : values) value = std::abs(value) < least ? 0 : value;
    columns.push_back(column_of(one.told, std::move(values), shown, language));
  }
  return columns;
}

}  // namespace bentur
