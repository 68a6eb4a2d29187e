#include "bentur/model/quantities.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bentur/core/errors.h"
#include "bentur/excitation/ground_motion.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/internal/plan_sources.h"
#include "bentur/model/judgement/open_needs.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/story/remarks.h"

namespace bentur {
namespace {

using sources::weight_of;

// What is computed, not kept in a response.

double base_shear_coefficient(const RunView& r, const QuantityPlace& at) {
  const Building& building = r.problem.buildings[at.item];
  const double weight = weight_of(building.model.floor_masses, r.units);
  return building.is_rigid() || weight <= 0 ? not_known : r.response.buildings[at.item].storey_shear(0) / weight;
}
const Units& units_of(const RunView& run) { return run.units; }
const Units& units_of(const PlanRun& run) { return run.c.units; }
constexpr auto weight = [](const auto& run, const QuantityPlace& at) {
  const auto& building = run.problem.buildings[at.item];
  return building.is_rigid() ? not_known : weight_of(building.model.floor_masses, units_of(run));
};
constexpr auto first_period = [](const auto& run, const QuantityPlace& at) {
  const auto& omega = run.problem.buildings[at.item].modes.omega;
  return omega.size() > 0 && omega(0) > 0 ? 2 * std::numbers::pi / omega(0) : not_known;
};
constexpr auto period_per_storey = [](const auto& run, const QuantityPlace& at) {
  const auto& model = run.problem.buildings[at.item].model;
  return first_period(run, at) / static_cast<double>(model.floors() - model.first_storey());
};
double amplification(const RunView& r, const QuantityPlace& at) {
  const BuildingPeaks& peaks = r.response.buildings[at.item];
  const double without = peaks.displacement_no_contact(at.floor);
  return without > 0 ? peaks.displacement(at.floor) / without : not_known;
}
double peak_ratio(const RunView& r, const QuantityPlace& at, Eigen::VectorXd BuildingPeaks::*with,
                  Eigen::VectorXd BuildingPeaks::*without) {
  const Eigen::VectorXd &a = r.response.buildings[at.item].*with, &b = r.response.buildings[at.item].*without;
  return at.floor < a.size() && at.floor < b.size() ? sources::ratio_of_peaks(a(at.floor), b(at.floor)) : not_known;
}
double acceleration_ratio(const RunView& r, const QuantityPlace& at) {
  return peak_ratio(r, at, &BuildingPeaks::acceleration, &BuildingPeaks::acceleration_no_contact);
}
double storey_shear_ratio(const RunView& r, const QuantityPlace& at) {
  return peak_ratio(r, at, &BuildingPeaks::storey_shear, &BuildingPeaks::storey_shear_no_contact);
}
template <class Extreme>
QuantitySource of_restitutions(std::optional<double> PointRestitution::*of, Extreme extreme) {
  QuantitySource source;
  source.row.value = [of](const RunView& r, const QuantityPlace& at) {
    return (r.restitutions[at.item].*of).value_or(not_known);
  };
  source.plan.value = [extreme](const PlanRun& run, const QuantityPlace& at) {
    double found = not_known;
    for (const Impact& impact : run.response.impacts) {
      if (impact.point == at.item) found = extreme(found, impact.restitution().value_or(not_known));
    }
    return found;
  };
  return source;
}
double smaller(double a, double b) { return std::fmin(a, b); }  // of a number and NaN the number
double larger(double a, double b) { return std::fmax(a, b); }
double whole_gap_reversed(const Problem& problem, const Response& response, Eigen::Index gap) {
  return gap_needed_reversed(problem, response, gap).value_or(not_known);
}
double floors_met(const Problem& problem, const Response& response, Eigen::Index gap) {
  return static_cast<double>(unmodelled_contacts(problem, response.watched, gap).size());
}
double ground_acceleration(const RunView& r, const QuantityPlace&) { return peak_acceleration(r.problem.motion); }

const std::vector<Remark>* remarks_of(const RunView& run) { return run.remarks; }
const std::vector<Remark>* remarks_of(const PlanRun& run) { return &run.remarks; }
constexpr auto events = [](const auto& run, const QuantityPlace&) { return static_cast<double>(run.response.events); };
constexpr auto remarks_of_run = [](const auto& run, const QuantityPlace&) {
  return remarks_of(run) != nullptr ? static_cast<double>(remarks_of(run)->size()) : not_known;
};
constexpr auto doubts_of_run = [](const auto& run, const QuantityPlace&) {
  return remarks_of(run) != nullptr ? static_cast<double>(count_of_doubts(*remarks_of(run))) : not_known;
};
constexpr auto kinds_of_remarks = [](const auto& run, const QuantityPlace&) {
  return remarks_of(run) != nullptr ? static_cast<double>(remark_kinds(*remarks_of(run))) : not_known;
};
double open_needs_of(const RunView& run, const QuantityPlace&) {
  if (run.remarks == nullptr) return not_known;
  return static_cast<double>(open_needs(run.problem, run.response, *run.remarks));
}
double open_needs_in_plan(const PlanRun& run, const QuantityPlace&) {
  const auto row = row_of(run);
  return static_cast<double>(open_needs(row->problem, row->response, run.remarks));
}
QuantitySource of_open_needs() {
  QuantitySource source;
  source.row.value = open_needs_of;
  source.plan.value = open_needs_in_plan;
  return source;
}
constexpr auto end_time = [](const auto& run, const QuantityPlace&) {
  return run.response.collapse ? run.response.collapse->time : run.response.duration;
};
constexpr auto collapsed = [](const auto& run, const QuantityPlace&) { return run.response.collapse ? 1.0 : 0.0; };
constexpr auto energy_residual = [](const auto& run, const QuantityPlace&) {
  return run.response.energy ? run.response.energy->relative_residual() : not_known;
};
constexpr auto impact_restitution = [](const auto& run, const QuantityPlace& at) {
  return run.response.impacts[at.item].restitution().value_or(not_known);
};
constexpr auto impact_duration = [](const auto& run, const QuantityPlace& at) {
  return run.response.impacts[at.item].end - run.response.impacts[at.item].start;
};

// Demand over capacity of a column; NaN where its capacity is not given, which std::fmax passes over.
double over(double demand, double capacity) { return capacity > 0 ? demand / capacity : not_known; }
double shear_ratio(const ColumnPeaks& column, const ContactPoint& point) {
  return over(column.shear, point.column_shear_capacity);
}
double moment_ratio(const ColumnPeaks& column, const ContactPoint& point) {
  return over(column.moment, point.column_moment_capacity);
}
double column_ratio(const ColumnPeaks& column, const ContactPoint& point) {
  return std::fmax(shear_ratio(column, point), moment_ratio(column, point));
}
double column_ratio_no_contact(const ColumnPeaks& column, const ContactPoint& point) {
  return std::fmax(over(column.shear_no_contact, point.column_shear_capacity),
                   over(column.moment_no_contact, point.column_moment_capacity));
}

constexpr Owner run = Owner::run, building = Owner::building, floor = Owner::floor, plane = Owner::plane,
                point = Owner::point, gap = Owner::gap, impact = Owner::impact, link_ = Owner::link,
                hinge = Owner::hinge, breaking = Owner::column, bearing = Owner::bearing;

// clang-format off
/// Of frames with infill, storey by storey: of a building, or in plan of a plane.
std::vector<Quantity> of_frames_with_infill(Owner owner, QuantitySource (*source)(Eigen::VectorXd BuildingPeaks::Infill::*)) {
  return {
      {"infill_force", owner, "F", "max N", "largest force of a strut of the infill", {"Strut of the infill", "Strut dinding pengisi"}, source(&BuildingPeaks::Infill::force)},
      {"infill_shear", owner, "F", "max N cos θ", "largest horizontal force of a strut of the infill, with which it pushes on a column", {"On the column", "Pada kolom"}, source(&BuildingPeaks::Infill::shear)},
      {"infill_ductility", owner, "1", "max |Δ|/Δ_y", "largest storey drift over that at which the infill yields", {"Ductility of the infill", "Daktilitas dinding pengisi"}, source(&BuildingPeaks::Infill::ductility), {}, {}, 1, 3},
      {"infill_strength_left", owner, "1", "N_c/N_c⁰", "largest force that a strut of the infill can still reach at the end over that at first, of the weakest", {"Infill left", "Sisa dinding pengisi"}, source(&BuildingPeaks::Infill::strength_left), {}, "%", 100},
      {"infill_energy", owner, "F L", "E_i", "energy that the infill has dissipated", {"Energy of the infill", "Energi dinding pengisi"}, source(&BuildingPeaks::Infill::energy)},
      {"infill_failed_time", owner, "s", "t_u", "when a panel of the infill first failed", {"Infill fails at", "Dinding pengisi gagal saat"}, source(&BuildingPeaks::Infill::failed_time)},
      {"infill_column_demand", owner, "1", "max |Q + N cos θ|/V", "largest shear of a column beside a strut, with what the strut pushes across it, over its capacity", {"Of the column's capacity", "Dari kapasitas kolom"}, source(&BuildingPeaks::Infill::column_demand)},
  };
}

std::deque<Quantity>& list() {
  using namespace sources;
  static std::deque<Quantity> all = [] {
    std::deque<Quantity> made = {
      // Buildings.
      {"weight", building, "F", "W", "weight of the floors' lumped masses", {}, of_any(weight)},
      {"base_shear_coefficient", building, "1", "V₁/W", "largest shear of the lowest storey over the weight", {}, computed(base_shear_coefficient)},
      {"first_period", building, "s", "T₁", "first period", {}, of_any(first_period)},
      {"period_per_storey", building, "s", "T₁/n", "first period over the number of floors", {}, of_any(period_per_storey)},
      // Of frames with hinges.
      {"hinge_energy", building, "F L", "Σ E_h", "energy that the hinges have dissipated", {}, hinge_energy()},
      // Of buildings on soil.
      {"peak_sway", building, "L", "max |u|", "largest sway of the foundation relative to the free field", {"Sway", "Goyangan"}, of_foundation(0), "/soil/peak_sway"},
      {"peak_rocking", building, "rad", "max |θ|", "largest rotation of the foundation", {"Rocking", "Guling"}, of_foundation(1), "/soil/peak_rocking", "mrad", 1e3},
      // Floors, and the storeys below them.
      {"peak_displacement", floor, "L", "max |x|", "largest displacement relative to the own base", {"Displacement", "Perpindahan"}, of_floors(&BuildingPeaks::displacement)},
      {"peak_displacement_no_contact", floor, "L", "max |x⁰|", "largest displacement with contact switched off", {"Without contact", "Tanpa kontak"}, of_floors(&BuildingPeaks::displacement_no_contact)},
      {"amplification", floor, "1", "max |x| / max |x⁰|", "largest displacement over that with contact switched off", {"Amplification", "Amplifikasi"}, computed(amplification), {}, {}, 1, 3},
      {"peak_drift_ratio", floor, "1", "max |Δx|/h", "largest storey drift over storey height", {"Drift", "Simpangan antartingkat"}, of_floors(&BuildingPeaks::drift_ratio), {}, "%", 100},
      {"peak_drift_ratio_no_contact", floor, "1", "max |Δx⁰|/h", "largest storey drift over storey height with contact switched off", {"Without contact", "Tanpa kontak"}, of_floors(&BuildingPeaks::drift_ratio_no_contact), {}, "%", 100},
      {"peak_acceleration", floor, "L s-2", "max |ẍ + a_g|", "largest absolute acceleration", {"Acceleration", "Percepatan"}, forces(of_floors(&BuildingPeaks::acceleration))},
      {"peak_acceleration_no_contact", floor, "L s-2", "max |ẍ⁰ + a_g|", "largest absolute acceleration with contact switched off", {"Without contact", "Tanpa kontak"}, forces(of_floors(&BuildingPeaks::acceleration_no_contact))},
      {"acceleration_ratio", floor, "1", "max |ẍ + a_g| / max |ẍ⁰ + a_g|", "largest absolute acceleration over that with contact switched off", {"Ratio", "Rasio"}, forces(computed(acceleration_ratio)), {}, {}, 1, 2},
      {"peak_storey_shear", floor, "F", "max |V|", "largest storey shear, without dashpots", {"Storey shear", "Gaya geser tingkat"}, forces(of_floors(&BuildingPeaks::storey_shear))},
      {"peak_storey_shear_no_contact", floor, "F", "max |V⁰|", "largest storey shear with contact switched off, without dashpots", {"Without contact", "Tanpa kontak"}, forces(of_floors(&BuildingPeaks::storey_shear_no_contact))},
      {"storey_shear_ratio", floor, "1", "max |V| / max |V⁰|", "largest storey shear over that with contact switched off", {"Ratio", "Rasio"}, forces(computed(storey_shear_ratio)), {}, {}, 1, 2},
      // Of buildings with storeys that can yield.
      {"ductility", floor, "1", "max |Δ|/Δ_y", "largest storey drift over that at yield", {"Ductility", "Daktilitas"}, of_yielding(&BuildingPeaks::Yielding::ductility), {}, {}, 1, 3},
      {"residual_drift_ratio", floor, "1", "Δ_r/h", "storey drift left after unloading at the end over storey height", {"Residual drift", "Simpangan sisa"}, of_yielding(&BuildingPeaks::Yielding::residual_drift_ratio), {}, "%", 100, {}, false, true},
      {"hysteretic_energy", floor, "F L", "E_h", "energy that the storey has dissipated by yielding", {"Energy by yielding", "Energi leleh"}, of_yielding(&BuildingPeaks::Yielding::hysteretic_energy)},
      {"strength_left", floor, "1", "V_c/V_c⁰", "largest shear that the storey can still reach at the end over that at first, of its weaker side", {"Strength left", "Kekuatan tersisa"}, of_yielding(&BuildingPeaks::Yielding::strength_left), {}, "%", 100},
      {"capped_time", floor, "s", "t_c", "when the storey first softened", {"Softens at", "Melunak saat"}, of_yielding(&BuildingPeaks::Yielding::capped_time)},
      {"residual_time", floor, "s", "t_r", "when the storey first was down to its residual strength", {"Residual at", "Sisa saat"}, of_yielding(&BuildingPeaks::Yielding::residual_time)},
      {"failed_time", floor, "s", "t_u", "when the storey failed", {"Fails at", "Gagal saat"}, of_yielding(&BuildingPeaks::Yielding::failed_time)},
      {"strength_left_no_contact", floor, "1", "V_c/V_c⁰", "largest shear that the storey can still reach at the end over that at first, with contact switched off", {"Strength left without contact", "Kekuatan tersisa tanpa kontak"}, of_yielding(&BuildingPeaks::Yielding::strength_left, &BuildingPeaks::yielding_no_contact), {}, "%", 100},
      {"ductility_no_contact", floor, "1", "max |Δ⁰|/Δ_y", "largest storey drift over that at yield, with contact switched off", {"Ductility without contact", "Daktilitas tanpa kontak"}, of_yielding(&BuildingPeaks::Yielding::ductility, &BuildingPeaks::yielding_no_contact), {}, {}, 1, 3},
      {"residual_drift_ratio_no_contact", floor, "1", "Δ_r⁰/h", "storey drift left after unloading at the end over storey height, with contact switched off", {"Residual drift without contact", "Simpangan sisa tanpa kontak"}, of_yielding(&BuildingPeaks::Yielding::residual_drift_ratio, &BuildingPeaks::yielding_no_contact), {}, "%", 100, {}, false, true},
      {"hysteretic_energy_no_contact", floor, "F L", "E_h⁰", "energy that the storey has dissipated by yielding, with contact switched off", {"Energy by yielding without contact", "Energi leleh tanpa kontak"}, of_yielding(&BuildingPeaks::Yielding::hysteretic_energy, &BuildingPeaks::yielding_no_contact)},
      // Hinges, in the order of the frame's members.
      {"peak_moment", hinge, "F L", "max |M|", "largest moment at the hinge, that at rest included", {"Moment", "Momen"}, of_hinges(&BuildingPeaks::Hinge::peak_moment)},
      {"peak_rotation", hinge, "rad", "max |θ|", "largest rotation of the hinge", {"Rotation", "Rotasi"}, of_hinges(&BuildingPeaks::Hinge::peak_rotation), {}, "mrad", 1e3},
      {"residual_rotation", hinge, "rad", "θ_r", "rotation of the hinge at the end", {"At the end", "Di akhir"}, of_hinges(&BuildingPeaks::Hinge::residual_rotation), {}, "mrad", 1e3, {}, false, true},
      {"dissipated_energy", hinge, "F L", "E_h", "energy that the hinge has dissipated", {"Energy by yielding", "Energi leleh"}, of_hinges(&BuildingPeaks::Hinge::dissipated_energy)},
      {"first_yield", hinge, "s", "t_y", "when the hinge first yielded", {"First yield", "Leleh pertama"}, of_hinges(&BuildingPeaks::Hinge::first_yield)},
      {"half_cycles", hinge, "1", "n", "stretches of flow in one direction", {"Half cycles", "Setengah siklus"}, of_hinges(&BuildingPeaks::Hinge::half_cycles)},
      {"strength_left", hinge, "1", "σ", "moment that the hinge can still carry at the end over that at its cap", {"Strength left", "Kekuatan tersisa"}, of_weakening(&BuildingPeaks::Hinge::strength_left), {}, "%", 100},
      {"cap_time", hinge, "s", "t_c", "when the hinge came to its cap", {"Cap at", "Puncak saat"}, of_weakening(&BuildingPeaks::Hinge::cap_time)},
      {"failed_time", hinge, "s", "t_u", "when the hinge had no strength left", {"Fails at", "Gagal saat"}, of_weakening(&BuildingPeaks::Hinge::failed_time)},
      {"snap_energy", hinge, "F L", "E_b", "energy that was lost as the hinge snapped or failed", {"Energy set free", "Energi terlepas"}, of_weakening(&BuildingPeaks::Hinge::released_energy)},
      // Columns that can break in shear.
      {"peak_shear", breaking, "F", "max |Q|", "largest shear of the column, that at rest included", {"Shear", "Gaya geser"}, of_columns(&BuildingPeaks::Breaking::peak_shear)},
      {"shear_demand_capacity", breaking, "1", "max |Q|/V", "largest shear of the column over its capacity", {"Of its capacity", "Dari kapasitasnya"}, of_columns(&BuildingPeaks::Breaking::shear_demand_capacity)},
      {"break_time", breaking, "s", "t_b", "when the column broke in shear", {"Breaks at", "Patah saat"}, of_columns(&BuildingPeaks::Breaking::break_time)},
      {"released_energy", breaking, "F L", "E_b", "elastic energy that was lost when the column broke", {"Energy set free", "Energi terlepas"}, of_columns(&BuildingPeaks::Breaking::released_energy)},
      {"residual_slip", breaking, "L", "v_r", "how far the broken column has slipped at the end", {"Slip at the end", "Geseran di akhir"}, of_columns(&BuildingPeaks::Breaking::residual_slip), {}, {}, 1, {}, false, true},
      // Contact points.
      {"point_width", point, "L", "w", "initial opening of the contact points", {"Given", "Tersedia"}, widths(), "/width"},
      {"point_gap_needed", point, "L", "w_n", "gap that the free response needs at each contact point", {"Needed", "Diperlukan"}, of_points(&PointSummary::gap_needed), "/gap_needed"},
      {"point_gap_needed_reversed", point, "L", "w_r", "gap that the free response to the reversed ground motion needs at each contact point", {}, needed_reversed(), "/gap_needed_reversed", {}, 1, {}, false, false, true},
      {"peak_left_no_contact", point, "L", "max |x⁰_l|", "largest displacement of the left face with contact switched off", {}, of_points(&PointSummary::peak_left), {}, {}, 1, {}, false, false, true},
      {"peak_right_no_contact", point, "L", "max |x⁰_r|", "largest displacement of the right face with contact switched off", {}, of_points(&PointSummary::peak_right), {}, {}, 1, {}, false, false, true},
      {"impacts", point, "1", "n", "number of impacts", {"Impacts", "Benturan"}, of_points(&PointSummary::impacts)},
      {"slow_starts", point, "1", "n_s", "impacts that began from rest, whose law divides by their closing speed", {}, of_points(&PointSummary::slow_starts)},
      {"settling", point, "1", "n_b", "bounces slower than 2⁻¹³ of the speeds, by which a contact comes to rest, that are not among the impacts", {}, of_points(&PointSummary::settling)},
      {"contact_duration", point, "s", "Σ Δt", "total time in contact", {"In contact", "Lama kontak"}, of_points(&PointSummary::contact_duration), {}, "ms", 1e3},
      {"peak_force", point, "F", "max F", "largest contact force", {"Peak force", "Gaya puncak"}, of_points(&PointSummary::peak_force)},
      {"peak_force_time", point, "s", "t(max F)", "time of the largest contact force", {"At", "Saat"}, of_points(&PointSummary::peak_force_time)},
      {"peak_penetration", point, "L", "max δ", "largest penetration", {"Penetration", "Penetrasi"}, of_points(&PointSummary::peak_penetration)},
      {"peak_closing_speed", point, "L s-1", "max v₀", "largest closing speed at the start of an impact", {"Closing speed", "Kecepatan mendekat"}, of_points(&PointSummary::peak_closing_speed)},
      {"impulse", point, "F s", "Σ ∫F dt", "impulse of all impacts", {"Impulse", "Impuls"}, of_points(&PointSummary::impulse)},
      {"energy_lost", point, "F L", "Σ E", "energy that the contact dissipated", {"Energy lost", "Energi hilang"}, of_points(&PointSummary::energy_lost)},
      {"peak_tension", point, "F", "max −F", "largest pull of the contact", {}, of_points(&PointSummary::peak_tension)},
      {"restitution_smallest", point, "1", "min e", "smallest coefficient of restitution of an impact", {}, of_restitutions(&PointRestitution::smallest, smaller), "/restitution/smallest"},
      {"restitution_largest", point, "1", "max e", "largest coefficient of restitution of an impact", {}, of_restitutions(&PointRestitution::largest, larger), "/restitution/largest"},
      // Of contact points where a floor strikes a column.
      {"column_shear", point, "F", "max |V_c|", "largest shear of the struck column", {"Shear", "Gaya geser"}, of_struck(&ColumnPeaks::shear), "/column/peak_shear"},
      {"column_shear_no_contact", point, "F", "max |V_c⁰|", "largest shear of the struck column with contact switched off", {"Without contact", "Tanpa kontak"}, of_struck(&ColumnPeaks::shear_no_contact), "/column/peak_shear_no_contact"},
      {"column_moment", point, "F L", "max |M_c|", "largest moment of the struck column", {"Moment", "Momen"}, of_struck(&ColumnPeaks::moment), "/column/peak_moment"},
      {"column_moment_no_contact", point, "F L", "max |M_c⁰|", "largest moment of the struck column with contact switched off", {"Without contact", "Tanpa kontak"}, of_struck(&ColumnPeaks::moment_no_contact), "/column/peak_moment_no_contact"},
      {"column_shear_below", point, "F", "max |V_b|", "largest shear of the struck column below the node", {}, of_struck(&ColumnPeaks::shear_below), "/column/peak_shear_below"},
      {"column_shear_above", point, "F", "max |V_a|", "largest shear of the struck column above the node", {}, of_struck(&ColumnPeaks::shear_above), "/column/peak_shear_above"},
      {"column_moment_bottom", point, "F L", "max |M_b|", "largest moment at the bottom of the struck column", {}, of_struck(&ColumnPeaks::moment_bottom), "/column/peak_moment_bottom"},
      {"column_moment_node", point, "F L", "max |M_n|", "largest moment of the struck column at the node", {}, of_struck(&ColumnPeaks::moment_node), "/column/peak_moment_node"},
      {"column_moment_top", point, "F L", "max |M_t|", "largest moment at the top of the struck column", {}, of_struck(&ColumnPeaks::moment_top), "/column/peak_moment_top"},
      {"column_shear_demand_capacity", point, "1", "max |V_c|/V_R", "largest shear of the struck column over its capacity", {"Shear, D/C", "Geser, D/C"}, of_struck(shear_ratio, When::struck_shear), "/column/shear_demand_capacity", {}, 1, 2},
      {"column_moment_demand_capacity", point, "1", "max |M_c|/M_R", "largest moment of the struck column over its capacity", {"Moment, D/C", "Momen, D/C"}, of_struck(moment_ratio, When::struck_moment), "/column/moment_demand_capacity", {}, 1, 2},
      {"column_demand_capacity", point, "1", "max D/C", "demand of the struck column over its capacity, the larger of shear and moment", {}, of_struck(column_ratio, When::struck_capacity), "/column/demand_capacity"},
      {"column_demand_capacity_no_contact", point, "1", "max D⁰/C", "demand of the struck column over its capacity with contact switched off, the larger of shear and moment", {"D/C without contact", "D/C tanpa kontak"}, of_struck(column_ratio_no_contact, When::struck_capacity), "/column/demand_capacity_no_contact", {}, 1, 2},
      // Gaps.
      {"gap_needed", gap, "L", "w_n", "gap that the free response needs, floors that face a column included", {}, of_gaps(gap_needed)},
      {"gap_needed_reversed", gap, "L", "w_r", "gap that the free response to the reversed ground motion needs, floors that face a column included", {}, of_gaps(whole_gap_reversed, true), {}, {}, 1, {}, false, false, true},
      {"unmodelled_contacts", gap, "1", "n_u", "floors that met what they face where no contact is modelled", {}, count(of_gaps(floors_met))},
      // Links, in the order of the case.
      {"peak_compression", link_, "F", "max F", "largest push of the link, its dashpot included", {"Peak push", "Dorong puncak"}, of_links(&LinkSummary::peak_compression)},
      {"peak_tension", link_, "F", "max −F", "largest pull of the link, its dashpot included", {"Peak pull", "Tarik puncak"}, of_links(&LinkSummary::peak_tension)},
      {"peak_closing", link_, "L", "max δ", "largest shortening of the link", {"Closing", "Memendek"}, of_links(&LinkSummary::peak_closing)},
      {"peak_opening", link_, "L", "max −δ", "largest lengthening of the link", {"Opening", "Memanjang"}, of_links(&LinkSummary::peak_opening)},
      {"energy_dissipated", link_, "F L", "E", "energy that the link dissipated", {"Energy lost", "Energi hilang"}, of_links(&LinkSummary::energy_dissipated)},
      // The run.
      {"peak_ground_acceleration", run, "L s-2", "PGA", "peak ground acceleration as applied", {}, computed(ground_acceleration), "/excitation/pga"},
      {"events", run, "1", "n_e", "contact events: a contact closes, opens or changes its branch of the law", {}, count(of_any(events)), "/solver/events"},
      {"end_time", run, "s", "t_e", "when the run ended", {}, of_any(end_time), "/solver/end_time", {}, 1, {}, false, false, true},
      {"collapsed", run, "1", "", "whether a storey collapsed, which ends the run", {}, count(of_any(collapsed))},
      {"energy_residual", run, "1", "ε", "largest energy not accounted for over the largest input", {}, of_any(energy_residual), "/solver/energy_residual", {}, 1, {}, true},
      {"remarks", run, "1", "", "remarks on the case and what came out", {}, count(of_any(remarks_of_run)), "/remark_counts/all"},
      {"doubts", run, "1", "", "those by which an input may not be meant", {}, count(of_any(doubts_of_run)), "/remark_counts/doubts"},
      {"remark_kinds", run, "1", "", "what the remarks are about, a bit for each of flag_meanings from the lowest", {}, of_any(kinds_of_remarks), "/remark_counts/kinds"},
      {"open_needs", run, "1", "", "what keeps the gaps needed from being known, a bit for each of flag_meanings from the lowest", {}, of_open_needs()},
      // Impacts, in the order of impacts.csv.
      {"start", impact, "s", "t₀", "start", {"Start", "Mulai"}, of_impacts(&Impact::start), {}, {}, 1, 4},
      {"end", impact, "s", "t₁", "end", {}, of_impacts(&Impact::end)},
      {"open_ended", impact, "1", "", "whether the analysis ended before it did", {}, of_impacts(&Impact::open_ended)},
      {"settling", impact, "1", "", "whether it is a bounce by which a contact comes to rest, slower than 2⁻¹³ of the speeds", {}, of_impacts(&Impact::settling)},
      {"closing_speed", impact, "L s-1", "v₀", "speed at which the bodies met", {"Closing speed", "Kecepatan mendekat"}, of_impacts(&Impact::closing_speed)},
      {"separation_speed", impact, "L s-1", "v₁", "speed at which they parted", {}, of_impacts(&Impact::separation_speed)},
      {"restitution", impact, "1", "e", "coefficient of restitution", {"Speed ratio", "Rasio kecepatan"}, of_any(impact_restitution), {}, {}, 1, 3},
      {"peak_force", impact, "F", "max F", "largest force", {"Peak force", "Gaya puncak"}, of_impacts(&Impact::peak_force)},
      {"peak_force_time", impact, "s", "t(max F)", "time of the largest force", {"Peak at", "Puncak saat"}, of_impacts(&Impact::peak_force_time), {}, {}, 1, 4},
      {"peak_penetration", impact, "L", "max δ", "largest penetration", {"Penetration", "Penetrasi"}, of_impacts(&Impact::peak_penetration)},
      {"impulse", impact, "F s", "∫F dt", "impulse", {"Impulse", "Impuls"}, of_impacts(&Impact::impulse)},
      {"energy_lost", impact, "F L", "E", "energy that it dissipated", {"Energy lost", "Energi hilang"}, of_impacts(&Impact::energy_lost)},
      {"peak_tension", impact, "F", "max −F", "largest pull", {}, of_impacts(&Impact::peak_tension)},
      {"duration", impact, "s", "Δt", "duration", {"In contact", "Lama kontak"}, of_any(impact_duration), {}, "ms", 1e3},
      // Of buildings in plan.
      // Floors, and the storeys below them.
      {"peak_displacement_x", floor, "L", "max |u_x|", "largest displacement along x of the centre of mass relative to the own base", {"Along x", "Sepanjang x"}, plan_floors(&PlanPeaks::x)},
      {"peak_displacement_x_no_contact", floor, "L", "max |u_x⁰|", "largest displacement along x with contact switched off", {"Without contact", "Tanpa kontak"}, when(When::moves, plan_floors(&PlanPeaks::x, &PlanResponse::buildings_no_contact))},
      {"amplification_x", floor, "1", "max |u_x| / max |u_x⁰|", "largest displacement along x over that with contact switched off", {}, when(When::moves, plan_amplification(&PlanPeaks::x, &RoundOff::displacement))},
      {"peak_displacement_y", floor, "L", "max |u_y|", "largest displacement along y of the centre of mass relative to the own base", {"Along y", "Sepanjang y"}, plan_floors(&PlanPeaks::y)},
      {"peak_displacement_y_no_contact", floor, "L", "max |u_y⁰|", "largest displacement along y with contact switched off", {"Without contact", "Tanpa kontak"}, when(When::moves, plan_floors(&PlanPeaks::y, &PlanResponse::buildings_no_contact))},
      {"amplification_y", floor, "1", "max |u_y| / max |u_y⁰|", "largest displacement along y over that with contact switched off", {}, when(When::moves, plan_amplification(&PlanPeaks::y, &RoundOff::displacement))},
      {"peak_rotation", floor, "rad", "max |θ|", "largest rotation", {"Rotation", "Rotasi"}, plan_floors(&PlanPeaks::rotation), {}, "mrad", 1e3},
      {"peak_rotation_no_contact", floor, "rad", "max |θ⁰|", "largest rotation with contact switched off", {"Without contact", "Tanpa kontak"}, when(When::moves, plan_floors(&PlanPeaks::rotation, &PlanResponse::buildings_no_contact)), {}, "mrad", 1e3},
      {"amplification_rotation", floor, "1", "max |θ| / max |θ⁰|", "largest rotation over that with contact switched off", {}, when(When::moves, plan_amplification(&PlanPeaks::rotation, &RoundOff::rotation))},
      {"peak_displacement_south", floor, "L", "max |u_x|", "largest displacement along x of the lower edge", {}, when(When::moves, plan_floors(&PlanPeaks::south)), "/peak_edge_displacement/south"},
      {"peak_displacement_south_no_contact", floor, "L", "max |u_x⁰|", "largest displacement along x of the lower edge with contact switched off", {}, when(When::moves, plan_floors(&PlanPeaks::south, &PlanResponse::buildings_no_contact)), "/peak_edge_displacement_no_contact/south"},
      {"peak_displacement_north", floor, "L", "max |u_x|", "largest displacement along x of the upper edge", {}, when(When::moves, plan_floors(&PlanPeaks::north)), "/peak_edge_displacement/north"},
      {"peak_displacement_north_no_contact", floor, "L", "max |u_x⁰|", "largest displacement along x of the upper edge with contact switched off", {}, when(When::moves, plan_floors(&PlanPeaks::north, &PlanResponse::buildings_no_contact)), "/peak_edge_displacement_no_contact/north"},
      {"peak_displacement_west", floor, "L", "max |u_y|", "largest displacement along y of the left edge", {}, when(When::moves, plan_floors(&PlanPeaks::west)), "/peak_edge_displacement/west"},
      {"peak_displacement_west_no_contact", floor, "L", "max |u_y⁰|", "largest displacement along y of the left edge with contact switched off", {}, when(When::moves, plan_floors(&PlanPeaks::west, &PlanResponse::buildings_no_contact)), "/peak_edge_displacement_no_contact/west"},
      {"peak_displacement_east", floor, "L", "max |u_y|", "largest displacement along y of the right edge", {}, when(When::moves, plan_floors(&PlanPeaks::east)), "/peak_edge_displacement/east"},
      {"peak_displacement_east_no_contact", floor, "L", "max |u_y⁰|", "largest displacement along y of the right edge with contact switched off", {}, when(When::moves, plan_floors(&PlanPeaks::east, &PlanResponse::buildings_no_contact)), "/peak_edge_displacement_no_contact/east"},
      {"peak_acceleration_x", floor, "L s-2", "max |ü_x + a_x|", "largest absolute acceleration along x", {"Acceleration x", "Percepatan x"}, forces(plan_floors(&PlanPeaks::acceleration_x))},
      {"peak_acceleration_x_no_contact", floor, "L s-2", "max |ü_x⁰ + a_x|", "largest absolute acceleration along x with contact switched off", {"Without contact", "Tanpa kontak"}, forces(when(When::moves, plan_floors(&PlanPeaks::acceleration_x, &PlanResponse::buildings_no_contact)))},
      {"acceleration_ratio_x", floor, "1", "max |ü_x + a_x| / max |ü_x⁰ + a_x|", "largest absolute acceleration along x over that with contact switched off", {}, forces(when(When::moves, plan_ratio(&PlanPeaks::acceleration_x, &PlanPeaks::acceleration_y)))},
      {"peak_acceleration_y", floor, "L s-2", "max |ü_y + a_y|", "largest absolute acceleration along y", {"Acceleration y", "Percepatan y"}, forces(plan_floors(&PlanPeaks::acceleration_y))},
      {"peak_acceleration_y_no_contact", floor, "L s-2", "max |ü_y⁰ + a_y|", "largest absolute acceleration along y with contact switched off", {"Without contact", "Tanpa kontak"}, forces(when(When::moves, plan_floors(&PlanPeaks::acceleration_y, &PlanResponse::buildings_no_contact)))},
      {"acceleration_ratio_y", floor, "1", "max |ü_y + a_y| / max |ü_y⁰ + a_y|", "largest absolute acceleration along y over that with contact switched off", {}, forces(when(When::moves, plan_ratio(&PlanPeaks::acceleration_y, &PlanPeaks::acceleration_x)))},
      {"peak_angular_acceleration", floor, "rad s-2", "max |θ̈|", "largest angular acceleration", {"Angular acceleration", "Percepatan sudut"}, forces(when(When::moves, plan_floors(&PlanPeaks::angular_acceleration)))},
      {"peak_angular_acceleration_no_contact", floor, "rad s-2", "max |θ̈⁰|", "largest angular acceleration with contact switched off", {}, forces(when(When::moves, plan_floors(&PlanPeaks::angular_acceleration, &PlanResponse::buildings_no_contact)))},
      {"peak_storey_shear_x", floor, "F", "max |V_x|", "largest storey shear along x, without dashpots", {"Storey shear x", "Gaya geser tingkat x"}, forces(when(When::moves, plan_floors(&PlanPeaks::shear_x)))},
      {"peak_storey_shear_x_no_contact", floor, "F", "max |V_x⁰|", "largest storey shear along x with contact switched off, without dashpots", {"Without contact", "Tanpa kontak"}, forces(when(When::moves, plan_floors(&PlanPeaks::shear_x, &PlanResponse::buildings_no_contact)))},
      {"storey_shear_ratio_x", floor, "1", "max |V_x| / max |V_x⁰|", "largest storey shear along x over that with contact switched off", {}, forces(when(When::moves, plan_ratio(&PlanPeaks::shear_x, &PlanPeaks::shear_y)))},
      {"peak_storey_shear_y", floor, "F", "max |V_y|", "largest storey shear along y, without dashpots", {"Storey shear y", "Gaya geser tingkat y"}, forces(when(When::moves, plan_floors(&PlanPeaks::shear_y)))},
      {"peak_storey_shear_y_no_contact", floor, "F", "max |V_y⁰|", "largest storey shear along y with contact switched off, without dashpots", {"Without contact", "Tanpa kontak"}, forces(when(When::moves, plan_floors(&PlanPeaks::shear_y, &PlanResponse::buildings_no_contact)))},
      {"storey_shear_ratio_y", floor, "1", "max |V_y| / max |V_y⁰|", "largest storey shear along y over that with contact switched off", {}, forces(when(When::moves, plan_ratio(&PlanPeaks::shear_y, &PlanPeaks::shear_x)))},
      {"peak_storey_torque", floor, "F L", "max |T|", "largest torque of the storey about the centre of mass of the floor above", {"Torque", "Torsi"}, forces(when(When::moves, plan_floors(&PlanPeaks::torque)))},
      {"peak_storey_torque_no_contact", floor, "F L", "max |T⁰|", "largest torque of the storey with contact switched off", {}, forces(when(When::moves, plan_floors(&PlanPeaks::torque, &PlanResponse::buildings_no_contact)))},
      // Of buildings without planes.
      {"peak_drift_ratio", floor, "1", "max |Δ|/h", "largest drift of an edge along itself over storey height, of a building without planes", {"Drift at an edge", "Simpangan di tepi"}, when(When::edges, edge_drift()), {}, "%", 100},
      {"peak_drift_ratio_no_contact", floor, "1", "max |Δ⁰|/h", "largest drift of an edge along itself over storey height with contact switched off, of a building without planes", {"Without contact", "Tanpa kontak"}, when(When::edges, edge_drift(&PlanResponse::buildings_no_contact)), {}, "%", 100},
      {"peak_drift_ratio_south", floor, "1", "max |Δ_x|/h", "largest drift along x of the lower edge over storey height", {}, when(When::edges, plan_floors(&PlanPeaks::drift_south)), "/peak_edge_drift_ratio/south", "%", 100},
      {"peak_drift_ratio_south_no_contact", floor, "1", "max |Δ_x⁰|/h", "largest drift along x of the lower edge over storey height with contact switched off", {}, when(When::edges, plan_floors(&PlanPeaks::drift_south, &PlanResponse::buildings_no_contact)), "/peak_edge_drift_ratio_no_contact/south", "%", 100},
      {"peak_drift_ratio_north", floor, "1", "max |Δ_x|/h", "largest drift along x of the upper edge over storey height", {}, when(When::edges, plan_floors(&PlanPeaks::drift_north)), "/peak_edge_drift_ratio/north", "%", 100},
      {"peak_drift_ratio_north_no_contact", floor, "1", "max |Δ_x⁰|/h", "largest drift along x of the upper edge over storey height with contact switched off", {}, when(When::edges, plan_floors(&PlanPeaks::drift_north, &PlanResponse::buildings_no_contact)), "/peak_edge_drift_ratio_no_contact/north", "%", 100},
      {"peak_drift_ratio_west", floor, "1", "max |Δ_y|/h", "largest drift along y of the left edge over storey height", {}, when(When::edges, plan_floors(&PlanPeaks::drift_west)), "/peak_edge_drift_ratio/west", "%", 100},
      {"peak_drift_ratio_west_no_contact", floor, "1", "max |Δ_y⁰|/h", "largest drift along y of the left edge over storey height with contact switched off", {}, when(When::edges, plan_floors(&PlanPeaks::drift_west, &PlanResponse::buildings_no_contact)), "/peak_edge_drift_ratio_no_contact/west", "%", 100},
      {"peak_drift_ratio_east", floor, "1", "max |Δ_y|/h", "largest drift along y of the right edge over storey height", {}, when(When::edges, plan_floors(&PlanPeaks::drift_east)), "/peak_edge_drift_ratio/east", "%", 100},
      {"peak_drift_ratio_east_no_contact", floor, "1", "max |Δ_y⁰|/h", "largest drift along y of the right edge over storey height with contact switched off", {}, when(When::edges, plan_floors(&PlanPeaks::drift_east, &PlanResponse::buildings_no_contact)), "/peak_edge_drift_ratio_no_contact/east", "%", 100},
      // Storeys of planes, by the floor above them.
      {"peak_drift_ratio", plane, "1", "max |Δ|/h", "largest drift of the plane over storey height", {"Drift", "Simpangan antartingkat"}, of_plane(&PlanPeaks::Plane::drift_ratio), {}, "%", 100},
      {"peak_drift_ratio_no_contact", plane, "1", "max |Δ⁰|/h", "largest drift of the plane over storey height with contact switched off", {"Without contact", "Tanpa kontak"}, when(When::moves, of_plane(&PlanPeaks::Plane::drift_ratio, &PlanResponse::buildings_no_contact)), {}, "%", 100},
      {"peak_shear", plane, "F", "max |V|", "largest force of the plane", {"Force", "Gaya"}, of_plane(&PlanPeaks::Plane::shear)},
      {"ductility", plane, "1", "max |Δ|/Δ_y", "largest drift of the plane over that at yield", {"Ductility", "Daktilitas"}, when(When::yields, plan_yielding(&BuildingPeaks::Yielding::ductility)), {}, {}, 1, 3},
      {"ductility_no_contact", plane, "1", "max |Δ⁰|/Δ_y", "largest drift of the plane over that at yield with contact switched off", {}, when(When::yields, plan_yielding(&BuildingPeaks::Yielding::ductility, &PlanResponse::buildings_no_contact))},
      {"residual_drift_ratio", plane, "1", "Δ_r/h", "drift of the plane left after unloading at the end over storey height", {"Residual drift", "Simpangan sisa"}, when(When::yields_or_turns, plan_yielding(&BuildingPeaks::Yielding::residual_drift_ratio)), {}, "%", 100, {}, false, true},
      {"hysteretic_energy", plane, "F L", "E_h", "energy that the storey of the plane has dissipated by yielding", {"Energy by yielding", "Energi leleh"}, when(When::yields, plan_yielding(&BuildingPeaks::Yielding::hysteretic_energy))},
      {"strength_left", plane, "1", "V_c/V_c⁰", "largest force that the plane can still reach at the end over that at first, of its weaker side", {"Strength left", "Kekuatan tersisa"}, when(When::loses_strength, plan_yielding(&BuildingPeaks::Yielding::strength_left)), {}, "%", 100},
      {"capped_time", plane, "s", "t_c", "when the storey of the plane first softened", {"Softens at", "Melunak saat"}, when(When::loses_strength, plan_yielding(&BuildingPeaks::Yielding::capped_time))},
      {"residual_time", plane, "s", "t_r", "when the storey of the plane first was down to its residual strength", {"Residual at", "Sisa saat"}, when(When::loses_strength, plan_yielding(&BuildingPeaks::Yielding::residual_time))},
      {"failed_time", plane, "s", "t_u", "when the storey of the plane failed", {"Fails at", "Gagal saat"}, when(When::loses_strength, plan_yielding(&BuildingPeaks::Yielding::failed_time))},
      {"strength_left_no_contact", plane, "1", "V_c/V_c⁰", "largest force that the plane can still reach at the end over that at first, with contact switched off", {}, when(When::loses_strength, plan_yielding(&BuildingPeaks::Yielding::strength_left, &PlanResponse::buildings_no_contact)), {}, "%", 100},
      {"residual_drift_ratio_no_contact", plane, "1", "Δ_r⁰/h", "drift of the plane left after unloading at the end over storey height, with contact switched off", {}, when(When::yields_or_turns, plan_yielding(&BuildingPeaks::Yielding::residual_drift_ratio, &PlanResponse::buildings_no_contact)), {}, "%", 100, {}, false, true},
      {"hysteretic_energy_no_contact", plane, "F L", "E_h⁰", "energy that the storey of the plane has dissipated by yielding, with contact switched off", {}, when(When::yields, plan_yielding(&BuildingPeaks::Yielding::hysteretic_energy, &PlanResponse::buildings_no_contact))},
      // Buildings.
      {"base_shear_coefficient_x", building, "1", "V_x,1/W", "largest shear along x of the lowest storey over the weight", {}, when(When::moves, plan_base_shear(&PlanPeaks::shear_x))},
      {"base_shear_coefficient_y", building, "1", "V_y,1/W", "largest shear along y of the lowest storey over the weight", {}, when(When::moves, plan_base_shear(&PlanPeaks::shear_y))},
      // Foundations on soil.
      {"peak_sway_x", building, "L", "max |u_x|", "largest sway of the foundation along x relative to the free field", {"Sway x", "Goyangan x"}, when(When::soil, plan_foundation(0)), "/soil/peak_sway_x"},
      {"peak_sway_y", building, "L", "max |u_y|", "largest sway of the foundation along y relative to the free field", {"Sway y", "Goyangan y"}, when(When::soil, plan_foundation(1)), "/soil/peak_sway_y"},
      {"peak_rocking_x", building, "rad", "max |ψ_x|", "largest rocking of the foundation that moves what is above along x", {"Rocking x", "Guling x"}, when(When::soil, plan_foundation(2)), "/soil/peak_rocking_x", "mrad", 1e3},
      {"peak_rocking_y", building, "rad", "max |ψ_y|", "largest rocking of the foundation that moves what is above along y", {"Rocking y", "Guling y"}, when(When::soil, plan_foundation(3)), "/soil/peak_rocking_y", "mrad", 1e3},
      {"peak_twist", building, "rad", "max |θ_b|", "largest twist of the foundation about the vertical", {"Twist", "Puntir"}, when(When::soil, plan_foundation(4)), "/soil/peak_twist", "mrad", 1e3},
      // Bearings below a slab.
      {"peak_displacement_x", bearing, "L", "max |Δ_x|", "largest displacement of the bearing along x", {"Along x", "Sepanjang x"}, of_bearings(&PlanPeaks::Bearings::x)},
      {"peak_displacement_y", bearing, "L", "max |Δ_y|", "largest displacement of the bearing along y", {"Along y", "Sepanjang y"}, of_bearings(&PlanPeaks::Bearings::y)},
      {"peak_force_x", bearing, "F", "max |F_x|", "largest force of the bearing along x, without its dashpot", {"Force x", "Gaya x"}, of_bearings(&PlanPeaks::Bearings::force_x)},
      {"peak_force_y", bearing, "F", "max |F_y|", "largest force of the bearing along y, without its dashpot", {"Force y", "Gaya y"}, of_bearings(&PlanPeaks::Bearings::force_y)},
      {"residual_x", bearing, "L", "|Δ_x,r|", "displacement along x at the end at which the bearing would rest without force", {"Residual x", "Sisa x"}, when(When::bearings_yield, of_bearings(&PlanPeaks::Bearings::residual_x, true))},
      {"residual_y", bearing, "L", "|Δ_y,r|", "displacement along y at the end at which the bearing would rest without force", {"Residual y", "Sisa y"}, when(When::bearings_yield, of_bearings(&PlanPeaks::Bearings::residual_y, true))},
      {"hysteretic_energy", bearing, "F L", "E_h", "energy that the bearing dissipated by yielding along x and y", {"Dissipated", "Diserap"}, when(When::bearings_yield, of_bearings(&PlanPeaks::Bearings::hysteretic_energy, true))},
      {"peak_tangential_force", point, "F", "max |F_t|", "largest force along the joint", {"Along the joint", "Sepanjang celah"}, when(When::rubs, of_friction(&PlanFriction::peak_tangential_force))},
      {"tangential_impulse", point, "F s", "Σ ∫F_t dt", "impulse along the joint of all impacts", {"Impulse along it", "Impuls sepanjang itu"}, when(When::rubs, of_friction(&PlanFriction::tangential_impulse))},
      {"sliding", point, "L", "Σ |Δs|", "path slid along the joint", {"Slides", "Menggeser"}, when(When::rubs, of_friction(&PlanFriction::sliding))},
      {"friction_loss", point, "F L", "Σ E_t", "energy that friction dissipated", {"Lost by friction", "Hilang oleh gesekan"}, when(When::rubs, of_friction(&PlanFriction::friction_loss))},
      {"peak_ground_acceleration_x", run, "L s-2", "PGA_x", "peak ground acceleration along x as applied", {}, of_ground(0), "/excitation/peak_ground_acceleration_x"},
      {"peak_ground_acceleration_y", run, "L s-2", "PGA_y", "peak ground acceleration along y as applied", {}, of_ground(1), "/excitation/peak_ground_acceleration_y"},
      {"tangential_impulse", impact, "F s", "∫F_t dt", "impulse along the joint", {"Along the joint", "Sepanjang celah"}, when(When::rubs, impact_friction())},
      {"slipped", impact, "1", "", "whether the buildings slipped off one another there, which lost what the contact held", {}, in_plan_alone(of_impacts(&Impact::slipped))},
    };
    for (Quantity& one : of_frames_with_infill(floor, of_infill)) made.push_back(std::move(one));
    for (Quantity& one : of_frames_with_infill(plane, plan_infill)) made.push_back(std::move(one));
    return made;
  }();
  return all;
}
// clang-format on

bool is_of(const Quantity& quantity, bool in_plan) {
  return in_plan ? static_cast<bool>(quantity.source.plan.value) : static_cast<bool>(quantity.source.row.value);
}

}  // namespace

RunView::RunView(const Problem& p, const Response& r, const Units& u)
    : problem(p), response(r), units(u), shown(shown_units(u, r)), restitutions(bentur::restitutions(p, r)) {}

const std::deque<Quantity>& quantities() { return list(); }

std::vector<const Quantity*> quantities_of(Owner owner, bool in_plan) {
  std::vector<const Quantity*> result;
  for (const Quantity& quantity : list()) {
    if (quantity.owner == owner && is_of(quantity, in_plan)) result.push_back(&quantity);
  }
  return result;
}

const Quantity& quantity_named(std::string_view key, Owner owner, bool in_plan) {
  for (const Quantity& quantity : list()) {
    if (quantity.key == key && quantity.owner == owner && is_of(quantity, in_plan)) return quantity;
  }
  throw InvalidParameter("quantity", std::string(key), "must be one of quantities()");
}

void add_quantity(const Quantity& quantity) { list().push_back(quantity); }

double value_of(const Quantity& quantity, const RunView& run, const QuantityPlace& at) {
  return quantity.source.row.value(run, at);
}

double value_of(const Quantity& quantity, const PlanRun& run, const QuantityPlace& at) {
  return quantity.source.plan.value(run, at);
}

bool is_whole(const Quantity& quantity) { return quantity.source.number != QuantitySource::Number::real; }

}  // namespace bentur
