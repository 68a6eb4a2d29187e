#include "bentur/model/quantities.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bentur/core/errors.h"
#include "bentur/core/number_text.h"
#include "bentur/excitation/ground_motion.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/story/remarks.h"

namespace bentur {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// What is computed, not kept in a response.

Proportions proportions_of(const RunView& r, const QuantityPlace& at) {
  return proportions(r.problem.buildings[at.item], r.units, &r.response.buildings[at.item]);
}
bool is_wall(const RunView& r, const QuantityPlace& at) { return r.problem.buildings[at.item].is_rigid(); }
double weight(const RunView& r, const QuantityPlace& at) {
  return is_wall(r, at) ? none : proportions_of(r, at).weight;
}
double base_shear_coefficient(const RunView& r, const QuantityPlace& at) {
  return proportions_of(r, at).base_shear_coefficient.value_or(none);
}
double first_period(const RunView& r, const QuantityPlace& at) {
  const double omega = r.problem.buildings[at.item].first_omega();
  return omega > 0 ? 2 * std::numbers::pi / omega : none;
}
double period_per_storey(const RunView& r, const QuantityPlace& at) {
  return is_wall(r, at) ? none : proportions_of(r, at).period_per_storey;
}
double hinge_energy(const RunView& r, const QuantityPlace& at) {
  double sum = 0;
  for (const BuildingPeaks::Hinge& hinge : r.response.buildings[at.item].hinges) sum += hinge.dissipated_energy;
  return r.response.buildings[at.item].hinges.empty() ? none : sum;
}
double amplification(const RunView& r, const QuantityPlace& at) {
  const BuildingPeaks& peaks = r.response.buildings[at.item];
  const double without = peaks.displacement_no_contact(at.floor);
  return without > 0 ? peaks.displacement(at.floor) / without : none;
}
/// The ratio of two peaks of a floor; none where contact makes something of nothing, round-off included.
double peak_ratio(const RunView& r, const QuantityPlace& at, Eigen::VectorXd BuildingPeaks::*with,
                  Eigen::VectorXd BuildingPeaks::*without) {
  constexpr double round_off = 1e-9;
  const Eigen::VectorXd &a = r.response.buildings[at.item].*with, &b = r.response.buildings[at.item].*without;
  if (at.floor >= a.size() || at.floor >= b.size()) return none;
  return b(at.floor) > round_off * a(at.floor) ? a(at.floor) / b(at.floor) : none;
}
double acceleration_ratio(const RunView& r, const QuantityPlace& at) {
  return peak_ratio(r, at, &BuildingPeaks::acceleration, &BuildingPeaks::acceleration_no_contact);
}
double storey_shear_ratio(const RunView& r, const QuantityPlace& at) {
  return peak_ratio(r, at, &BuildingPeaks::storey_shear, &BuildingPeaks::storey_shear_no_contact);
}
double point_width(const RunView& r, const QuantityPlace& at) { return r.problem.points[at.item].width; }
double smallest_restitution(const RunView& r, const QuantityPlace& at) {
  return r.restitutions[at.item].smallest.value_or(none);
}
double largest_restitution(const RunView& r, const QuantityPlace& at) {
  return r.restitutions[at.item].largest.value_or(none);
}
double whole_gap(const RunView& r, const QuantityPlace& at) { return gap_needed(r.problem, r.response, at.item); }
double whole_gap_reversed(const RunView& r, const QuantityPlace& at) {
  return gap_needed_reversed(r.problem, r.response, at.item).value_or(none);
}
long floors_met(const RunView& r, const QuantityPlace& at) {
  return static_cast<long>(unmodelled_contacts(r.problem, r.response, at.item).size());
}
double ground_acceleration(const RunView& r, const QuantityPlace&) { return peak_acceleration(r.problem.motion); }
long events(const RunView& r, const QuantityPlace&) { return r.response.events; }
double remarks_of_run(const RunView& r, const QuantityPlace&) {
  return r.remarks != nullptr ? static_cast<double>(r.remarks->size()) : none;
}
double doubts_of_run(const RunView& r, const QuantityPlace&) {
  return r.remarks != nullptr ? static_cast<double>(count_of_doubts(*r.remarks)) : none;
}
double kinds_of_remarks(const RunView& r, const QuantityPlace&) {
  return r.remarks != nullptr ? static_cast<double>(remark_kinds(*r.remarks)) : none;
}
double end_time(const RunView& r, const QuantityPlace&) {
  return r.response.collapse ? r.response.collapse->time : r.response.duration;
}
long collapsed(const RunView& r, const QuantityPlace&) { return r.response.collapse ? 1 : 0; }
double energy_residual(const RunView& r, const QuantityPlace&) {
  return r.response.energy ? r.response.energy->relative_residual() : none;
}
double impact_restitution(const RunView& r, const QuantityPlace& at) {
  return r.response.impacts[at.item].restitution().value_or(none);
}
double impact_duration(const RunView& r, const QuantityPlace& at) {
  return r.response.impacts[at.item].end - r.response.impacts[at.item].start;
}

// Demand over capacity of a column; NaN where its capacity is not given, which std::fmax passes over.
double over(double demand, double capacity) { return capacity > 0 ? demand / capacity : none; }
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

constexpr Owner run = Owner::run, building = Owner::building, floor = Owner::floor, point = Owner::point,
                gap = Owner::gap, impact = Owner::impact, link_ = Owner::link, hinge = Owner::hinge,
                breaking = Owner::column;

constexpr YieldingSource yielding(Eigen::VectorXd BuildingPeaks::Yielding::*list) {
  return {&BuildingPeaks::yielding, list};
}
constexpr YieldingSource yielding_no_contact(Eigen::VectorXd BuildingPeaks::Yielding::*list) {
  return {&BuildingPeaks::yielding_no_contact, list};
}

constexpr ColumnSource kept(double ColumnPeaks::*value) { return {value, nullptr}; }
constexpr ColumnSource computed(double (*value)(const ColumnPeaks&, const ContactPoint&)) { return {nullptr, value}; }

// clang-format off
std::deque<Quantity>& list() {
  static std::deque<Quantity> all = {
      // Buildings.
      {"weight", building, "F", "W", "weight of the floors' lumped masses", {}, weight},
      {"base_shear_coefficient", building, "1", "V₁/W", "largest shear of the lowest storey over the weight", {}, base_shear_coefficient},
      {"first_period", building, "s", "T₁", "first period", {}, first_period},
      {"period_per_storey", building, "s", "T₁/n", "first period over the number of floors", {}, period_per_storey},
      // Of frames with hinges.
      {"hinge_energy", building, "F L", "Σ E_h", "energy that the hinges have dissipated", {}, hinge_energy},
      // Of buildings on soil.
      {"peak_sway", building, "L", "max |u|", "largest sway of the foundation relative to the free field", {}, FoundationSource{0}, "/soil/peak_sway"},
      {"peak_rocking", building, "rad", "max |θ|", "largest rotation of the foundation", {}, FoundationSource{1}, "/soil/peak_rocking"},
      // Floors, and the storeys below them.
      {"peak_displacement", floor, "L", "max |x|", "largest displacement relative to the own base", {"Displacement", "Perpindahan"}, &BuildingPeaks::displacement},
      {"peak_displacement_no_contact", floor, "L", "max |x⁰|", "largest displacement with contact switched off", {"Without contact", "Tanpa kontak"}, &BuildingPeaks::displacement_no_contact},
      {"amplification", floor, "1", "max |x| / max |x⁰|", "largest displacement over that with contact switched off", {"Amplification", "Amplifikasi"}, amplification, {}, {}, 1, 3},
      {"peak_drift_ratio", floor, "1", "max |Δx|/h", "largest storey drift over storey height", {"Drift", "Simpangan antartingkat"}, &BuildingPeaks::drift_ratio, {}, "%", 100},
      {"peak_acceleration", floor, "L s-2", "max |ẍ + a_g|", "largest absolute acceleration", {"Acceleration", "Percepatan"}, &BuildingPeaks::acceleration},
      {"peak_acceleration_no_contact", floor, "L s-2", "max |ẍ⁰ + a_g|", "largest absolute acceleration with contact switched off", {"Without contact", "Tanpa kontak"}, &BuildingPeaks::acceleration_no_contact},
      {"acceleration_ratio", floor, "1", "max |ẍ + a_g| / max |ẍ⁰ + a_g|", "largest absolute acceleration over that with contact switched off", {"Ratio", "Rasio"}, acceleration_ratio, {}, {}, 1, 2},
      {"peak_storey_shear", floor, "F", "max |V|", "largest storey shear, without dashpots", {"Storey shear", "Gaya geser tingkat"}, &BuildingPeaks::storey_shear},
      {"peak_storey_shear_no_contact", floor, "F", "max |V⁰|", "largest storey shear with contact switched off, without dashpots", {"Without contact", "Tanpa kontak"}, &BuildingPeaks::storey_shear_no_contact},
      {"storey_shear_ratio", floor, "1", "max |V| / max |V⁰|", "largest storey shear over that with contact switched off", {"Ratio", "Rasio"}, storey_shear_ratio, {}, {}, 1, 2},
      // Of buildings with storeys that can yield.
      {"ductility", floor, "1", "max |Δ|/Δ_y", "largest storey drift over that at yield", {"Ductility", "Daktilitas"}, yielding(&BuildingPeaks::Yielding::ductility), {}, {}, 1, 3},
      {"residual_drift_ratio", floor, "1", "Δ_r/h", "storey drift left after unloading at the end over storey height", {"Residual drift", "Simpangan sisa"}, yielding(&BuildingPeaks::Yielding::residual_drift_ratio), {}, "%", 100, {}, false, true},
      {"hysteretic_energy", floor, "F L", "E_h", "energy that the storey has dissipated by yielding", {"Energy by yielding", "Energi leleh"}, yielding(&BuildingPeaks::Yielding::hysteretic_energy)},
      {"strength_left", floor, "1", "V_c/V_c⁰", "largest shear that the storey can still reach at the end over that at first, of its weaker side", {"Strength left", "Kekuatan tersisa"}, yielding(&BuildingPeaks::Yielding::strength_left), {}, "%", 100},
      {"capped_time", floor, "s", "t_c", "when the storey first softened", {"Softens at", "Melunak saat"}, yielding(&BuildingPeaks::Yielding::capped_time)},
      {"residual_time", floor, "s", "t_r", "when the storey first was down to its residual strength", {"Residual at", "Sisa saat"}, yielding(&BuildingPeaks::Yielding::residual_time)},
      {"failed_time", floor, "s", "t_u", "when the storey failed", {"Fails at", "Gagal saat"}, yielding(&BuildingPeaks::Yielding::failed_time)},
      {"strength_left_no_contact", floor, "1", "V_c/V_c⁰", "largest shear that the storey can still reach at the end over that at first, with contact switched off", {"Strength left without contact", "Kekuatan tersisa tanpa kontak"}, yielding_no_contact(&BuildingPeaks::Yielding::strength_left), {}, "%", 100},
      {"ductility_no_contact", floor, "1", "max |Δ⁰|/Δ_y", "largest storey drift over that at yield, with contact switched off", {"Ductility without contact", "Daktilitas tanpa kontak"}, yielding_no_contact(&BuildingPeaks::Yielding::ductility), {}, {}, 1, 3},
      {"residual_drift_ratio_no_contact", floor, "1", "Δ_r⁰/h", "storey drift left after unloading at the end over storey height, with contact switched off", {"Residual drift without contact", "Simpangan sisa tanpa kontak"}, yielding_no_contact(&BuildingPeaks::Yielding::residual_drift_ratio), {}, "%", 100, {}, false, true},
      {"hysteretic_energy_no_contact", floor, "F L", "E_h⁰", "energy that the storey has dissipated by yielding, with contact switched off", {"Energy by yielding without contact", "Energi leleh tanpa kontak"}, yielding_no_contact(&BuildingPeaks::Yielding::hysteretic_energy)},
      // Of frames with infill.
      {"infill_force", floor, "F", "max N", "largest force of a strut of the infill", {"Strut of the infill", "Strut dinding pengisi"}, InfillSource{&BuildingPeaks::Infill::force}},
      {"infill_shear", floor, "F", "max N cos θ", "largest horizontal force of a strut of the infill, with which it pushes on a column", {"On the column", "Pada kolom"}, InfillSource{&BuildingPeaks::Infill::shear}},
      {"infill_ductility", floor, "1", "max |Δ|/Δ_y", "largest storey drift over that at which the infill yields", {"Ductility of the infill", "Daktilitas dinding pengisi"}, InfillSource{&BuildingPeaks::Infill::ductility}, {}, {}, 1, 3},
      {"infill_strength_left", floor, "1", "N_c/N_c⁰", "largest force that a strut of the infill can still reach at the end over that at first, of the weakest", {"Infill left", "Sisa dinding pengisi"}, InfillSource{&BuildingPeaks::Infill::strength_left}, {}, "%", 100},
      {"infill_energy", floor, "F L", "E_i", "energy that the infill has dissipated", {"Energy of the infill", "Energi dinding pengisi"}, InfillSource{&BuildingPeaks::Infill::energy}},
      {"infill_failed_time", floor, "s", "t_u", "when a panel of the infill first failed", {"Infill fails at", "Dinding pengisi gagal saat"}, InfillSource{&BuildingPeaks::Infill::failed_time}},
      {"infill_column_demand", floor, "1", "max |Q + N cos θ|/V", "largest shear of a column beside a strut, with what the strut pushes across it, over its capacity", {"Of the column's capacity", "Dari kapasitas kolom"}, InfillSource{&BuildingPeaks::Infill::column_demand}},
      // Hinges, in the order of the frame's members.
      {"peak_moment", hinge, "F L", "max |M|", "largest moment at the hinge, that at rest included", {"Moment", "Momen"}, &BuildingPeaks::Hinge::peak_moment},
      {"peak_rotation", hinge, "rad", "max |θ|", "largest rotation of the hinge", {"Rotation", "Rotasi"}, &BuildingPeaks::Hinge::peak_rotation, {}, "mrad", 1e3},
      {"residual_rotation", hinge, "rad", "θ_r", "rotation of the hinge at the end", {"At the end", "Di akhir"}, &BuildingPeaks::Hinge::residual_rotation, {}, "mrad", 1e3, {}, false, true},
      {"dissipated_energy", hinge, "F L", "E_h", "energy that the hinge has dissipated", {"Energy by yielding", "Energi leleh"}, &BuildingPeaks::Hinge::dissipated_energy},
      {"first_yield", hinge, "s", "t_y", "when the hinge first yielded", {"First yield", "Leleh pertama"}, &BuildingPeaks::Hinge::first_yield},
      {"half_cycles", hinge, "1", "n", "stretches of flow in one direction", {"Half cycles", "Setengah siklus"}, &BuildingPeaks::Hinge::half_cycles},
      {"strength_left", hinge, "1", "σ", "moment that the hinge can still bear at the end over that at its cap", {"Strength left", "Kekuatan tersisa"}, &BuildingPeaks::Hinge::strength_left, {}, "%", 100},
      {"cap_time", hinge, "s", "t_c", "when the hinge came to its cap", {"Cap at", "Puncak saat"}, &BuildingPeaks::Hinge::cap_time},
      {"failed_time", hinge, "s", "t_u", "when the hinge had no strength left", {"Fails at", "Gagal saat"}, &BuildingPeaks::Hinge::failed_time},
      {"snap_energy", hinge, "F L", "E_b", "energy that was lost as the hinge snapped or failed", {"Energy set free", "Energi terlepas"}, &BuildingPeaks::Hinge::released_energy},
      // Columns that can break in shear.
      {"peak_shear", breaking, "F", "max |Q|", "largest shear of the column, that at rest included", {"Shear", "Gaya geser"}, &BuildingPeaks::Breaking::peak_shear},
      {"shear_demand_capacity", breaking, "1", "max |Q|/V", "largest shear of the column over its capacity", {"Of its capacity", "Dari kapasitasnya"}, &BuildingPeaks::Breaking::shear_demand_capacity},
      {"break_time", breaking, "s", "t_b", "when the column broke in shear", {"Breaks at", "Patah saat"}, &BuildingPeaks::Breaking::break_time},
      {"released_energy", breaking, "F L", "E_b", "elastic energy that was lost when the column broke", {"Energy set free", "Energi terlepas"}, &BuildingPeaks::Breaking::released_energy},
      {"residual_slip", breaking, "L", "v_r", "how far the broken column has slipped at the end", {"Slip at the end", "Geseran di akhir"}, &BuildingPeaks::Breaking::residual_slip, {}, {}, 1, {}, false, true},
      // Contact points.
      {"point_width", point, "L", "w", "initial opening of the contact points", {"Given", "Tersedia"}, point_width, "/width"},
      {"point_gap_needed", point, "L", "w_n", "gap that the free response needs at each contact point", {"Needed", "Diperlukan"}, &PointSummary::gap_needed, "/gap_needed"},
      {"point_gap_needed_reversed", point, "L", "w_r", "gap that the free response to the reversed ground motion needs at each contact point", {}, &PointSummary::gap_needed_reversed, "/gap_needed_reversed", {}, 1, {}, false, false, true},
      {"peak_left_no_contact", point, "L", "max |x⁰_l|", "largest displacement of the left face with contact switched off", {}, &PointSummary::peak_left, {}, {}, 1, {}, false, false, true},
      {"peak_right_no_contact", point, "L", "max |x⁰_r|", "largest displacement of the right face with contact switched off", {}, &PointSummary::peak_right, {}, {}, 1, {}, false, false, true},
      {"impacts", point, "1", "n", "number of impacts", {"Impacts", "Benturan"}, &PointSummary::impacts},
      {"slow_starts", point, "1", "n_s", "impacts that began from rest, whose law divides by their closing speed", {}, &PointSummary::slow_starts},
      {"settling", point, "1", "n_b", "bounces slower than 2⁻¹³ of the speeds, by which a contact comes to rest, that are not among the impacts", {}, &PointSummary::settling},
      {"contact_duration", point, "s", "Σ Δt", "total time in contact", {"In contact", "Lama kontak"}, &PointSummary::contact_duration, {}, "ms", 1e3},
      {"peak_force", point, "F", "max F", "largest contact force", {"Peak force", "Gaya puncak"}, &PointSummary::peak_force},
      {"peak_force_time", point, "s", "t(max F)", "time of the largest contact force", {"At", "Saat"}, &PointSummary::peak_force_time},
      {"peak_penetration", point, "L", "max δ", "largest penetration", {"Penetration", "Penetrasi"}, &PointSummary::peak_penetration},
      {"peak_closing_speed", point, "L s-1", "max v₀", "largest closing speed at the start of an impact", {"Closing speed", "Kecepatan mendekat"}, &PointSummary::peak_closing_speed},
      {"impulse", point, "F s", "Σ ∫F dt", "impulse of all impacts", {"Impulse", "Impuls"}, &PointSummary::impulse},
      {"energy_lost", point, "F L", "Σ E", "energy that the contact dissipated", {"Energy lost", "Energi hilang"}, &PointSummary::energy_lost},
      {"peak_tension", point, "F", "max −F", "largest pull of the contact", {}, &PointSummary::peak_tension},
      {"restitution_smallest", point, "1", "min e", "smallest coefficient of restitution of an impact", {}, smallest_restitution, "/restitution/smallest"},
      {"restitution_largest", point, "1", "max e", "largest coefficient of restitution of an impact", {}, largest_restitution, "/restitution/largest"},
      // Of contact points where a floor strikes a column.
      {"column_shear", point, "F", "max |V_c|", "largest shear of the struck column", {"Shear", "Gaya geser"}, kept(&ColumnPeaks::shear), "/column/peak_shear"},
      {"column_shear_no_contact", point, "F", "max |V_c⁰|", "largest shear of the struck column with contact switched off", {"Without contact", "Tanpa kontak"}, kept(&ColumnPeaks::shear_no_contact), "/column/peak_shear_no_contact"},
      {"column_moment", point, "F L", "max |M_c|", "largest moment of the struck column", {"Moment", "Momen"}, kept(&ColumnPeaks::moment), "/column/peak_moment"},
      {"column_moment_no_contact", point, "F L", "max |M_c⁰|", "largest moment of the struck column with contact switched off", {"Without contact", "Tanpa kontak"}, kept(&ColumnPeaks::moment_no_contact), "/column/peak_moment_no_contact"},
      {"column_shear_below", point, "F", "max |V_b|", "largest shear of the struck column below the node", {}, kept(&ColumnPeaks::shear_below), "/column/peak_shear_below"},
      {"column_shear_above", point, "F", "max |V_a|", "largest shear of the struck column above the node", {}, kept(&ColumnPeaks::shear_above), "/column/peak_shear_above"},
      {"column_moment_bottom", point, "F L", "max |M_b|", "largest moment at the bottom of the struck column", {}, kept(&ColumnPeaks::moment_bottom), "/column/peak_moment_bottom"},
      {"column_moment_node", point, "F L", "max |M_n|", "largest moment of the struck column at the node", {}, kept(&ColumnPeaks::moment_node), "/column/peak_moment_node"},
      {"column_moment_top", point, "F L", "max |M_t|", "largest moment at the top of the struck column", {}, kept(&ColumnPeaks::moment_top), "/column/peak_moment_top"},
      {"column_shear_demand_capacity", point, "1", "max |V_c|/V_R", "largest shear of the struck column over its capacity", {"Shear, D/C", "Geser, D/C"}, computed(shear_ratio), "/column/shear_demand_capacity", {}, 1, 2},
      {"column_moment_demand_capacity", point, "1", "max |M_c|/M_R", "largest moment of the struck column over its capacity", {"Moment, D/C", "Momen, D/C"}, computed(moment_ratio), "/column/moment_demand_capacity", {}, 1, 2},
      {"column_demand_capacity", point, "1", "max D/C", "demand of the struck column over its capacity, the larger of shear and moment", {}, computed(column_ratio), "/column/demand_capacity"},
      {"column_demand_capacity_no_contact", point, "1", "max D⁰/C", "demand of the struck column over its capacity with contact switched off, the larger of shear and moment", {"D/C without contact", "D/C tanpa kontak"}, computed(column_ratio_no_contact), "/column/demand_capacity_no_contact", {}, 1, 2},
      // Gaps.
      {"gap_needed", gap, "L", "w_n", "gap that the free response needs, floors that face a column included", {}, whole_gap},
      {"gap_needed_reversed", gap, "L", "w_r", "gap that the free response to the reversed ground motion needs, floors that face a column included", {}, whole_gap_reversed, {}, {}, 1, {}, false, false, true},
      {"unmodelled_contacts", gap, "1", "n_u", "floors that met what they face where no contact is modelled", {}, floors_met},
      // Links, in the order of the case.
      {"peak_compression", link_, "F", "max F", "largest push of the link, its dashpot included", {"Peak push", "Dorong puncak"}, &LinkSummary::peak_compression},
      {"peak_tension", link_, "F", "max −F", "largest pull of the link, its dashpot included", {"Peak pull", "Tarik puncak"}, &LinkSummary::peak_tension},
      {"peak_closing", link_, "L", "max δ", "largest shortening of the link", {"Closing", "Memendek"}, &LinkSummary::peak_closing},
      {"peak_opening", link_, "L", "max −δ", "largest lengthening of the link", {"Opening", "Memanjang"}, &LinkSummary::peak_opening},
      {"energy_dissipated", link_, "F L", "E", "energy that the link dissipated", {"Energy lost", "Energi hilang"}, &LinkSummary::energy_dissipated},
      // The run.
      {"peak_ground_acceleration", run, "L s-2", "PGA", "peak ground acceleration as applied", {}, ground_acceleration, "/excitation/pga"},
      {"events", run, "1", "n_e", "events, such as contacts closed or opened, yielding begun or ended", {}, events, "/solver/events"},
      {"end_time", run, "s", "t_e", "when the run ended", {}, end_time, "/solver/end_time", {}, 1, {}, false, false, true},
      {"collapsed", run, "1", "", "whether a storey collapsed, which ends the run", {}, collapsed},
      {"energy_residual", run, "1", "ε", "largest energy not accounted for over the largest input", {}, energy_residual, "/solver/energy_residual", {}, 1, {}, true},
      {"remarks", run, "1", "", "remarks on the case and what came out", {}, remarks_of_run, "/remark_counts/all"},
      {"doubts", run, "1", "", "those by which an input may not be meant", {}, doubts_of_run, "/remark_counts/doubts"},
      {"remark_kinds", run, "1", "", "what the remarks are about, a bit for each of flag_meanings from the lowest", {}, kinds_of_remarks, "/remark_counts/kinds"},
      // Impacts, in the order of impacts.csv.
      {"start", impact, "s", "t₀", "start", {"Start", "Mulai"}, &Impact::start, {}, {}, 1, 4},
      {"end", impact, "s", "t₁", "end", {}, &Impact::end},
      {"open_ended", impact, "1", "", "whether the analysis ended before it did", {}, &Impact::open_ended},
      {"settling", impact, "1", "", "whether it is a bounce by which a contact comes to rest, slower than 2⁻¹³ of the speeds", {}, &Impact::settling},
      {"closing_speed", impact, "L s-1", "v₀", "speed at which the bodies met", {"Closing speed", "Kecepatan mendekat"}, &Impact::closing_speed},
      {"separation_speed", impact, "L s-1", "v₁", "speed at which they parted", {}, &Impact::separation_speed},
      {"restitution", impact, "1", "e", "coefficient of restitution", {"Restitution", "Restitusi"}, impact_restitution, {}, {}, 1, 3},
      {"peak_force", impact, "F", "max F", "largest force", {"Peak force", "Gaya puncak"}, &Impact::peak_force},
      {"peak_force_time", impact, "s", "t(max F)", "time of the largest force", {}, &Impact::peak_force_time},
      {"peak_penetration", impact, "L", "max δ", "largest penetration", {"Penetration", "Penetrasi"}, &Impact::peak_penetration},
      {"impulse", impact, "F s", "∫F dt", "impulse", {"Impulse", "Impuls"}, &Impact::impulse},
      {"energy_lost", impact, "F L", "E", "energy that it dissipated", {"Energy lost", "Energi hilang"}, &Impact::energy_lost},
      {"peak_tension", impact, "F", "max −F", "largest pull", {}, &Impact::peak_tension},
      {"duration", impact, "s", "Δt", "duration", {"In contact", "Lama kontak"}, impact_duration, {}, "ms", 1e3},
  };
  return all;
}
// clang-format on

/// One function for each kind of source.
template <typename... Functions>
struct Visitor : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Visitor(Functions...) -> Visitor<Functions...>;

}  // namespace

ShownUnits shown_units(const Units& units, const Response& response) {
  double largest = 0;
  for (const PointSummary& point : response.points) {
    largest = std::max({largest, point.peak_force, point.peak_tension});
  }
  for (const BuildingPeaks& peaks : response.buildings) {
    for (const double shear : peaks.storey_shear) largest = std::fmax(largest, shear);
  }
  return shown_units(units, largest);
}

RunView::RunView(const Problem& p, const Response& r, const Units& u)
    : problem(p), response(r), units(u), shown(shown_units(u, r)), restitutions(bentur::restitutions(p, r)) {}

const std::deque<Quantity>& quantities() { return list(); }

std::vector<const Quantity*> quantities_of(Owner owner) {
  std::vector<const Quantity*> result;
  for (const Quantity& quantity : list()) {
    if (quantity.owner == owner) result.push_back(&quantity);
  }
  return result;
}

const Quantity& quantity_named(std::string_view key, Owner owner) {
  for (const Quantity& quantity : list()) {
    if (quantity.key == key && quantity.owner == owner) return quantity;
  }
  throw InvalidParameter("quantity", std::string(key), "must be one of quantities()");
}

void add_quantity(const Quantity& quantity) { list().push_back(quantity); }

bool column_has(const Quantity& quantity, const Problem& problem, const ContactPoint& at) {
  const auto* source = std::get_if<ColumnSource>(&quantity.source);
  if (source == nullptr || !struck_column(problem, at)) return false;
  return source->kept != nullptr || !std::isnan(source->computed({}, at));
}

bool is_told(const Quantity& quantity, const RunView& r, Eigen::Index item) {
  if (is_of_columns(quantity)) return column_has(quantity, r.problem, r.problem.points[item]);
  if (const auto* source = std::get_if<InfillSource>(&quantity.source)) {
    return (r.response.buildings[item].infill.*source->list).size() > 0;
  }
  if (is_of_foundation(quantity)) return r.response.buildings[item].foundation.size() > 0;
  if (is_of_breaking(quantity)) return !r.response.buildings[item].columns.empty();
  if (is_of_hinges(quantity)) {
    const std::vector<BuildingPeaks::Hinge>& hinges = r.response.buildings[item].hinges;
    if (!is_of_weakening(quantity)) return !hinges.empty();
    return std::any_of(hinges.begin(), hinges.end(), [](const auto& of) { return of.strength_left.has_value(); });
  }
  const auto* source = std::get_if<YieldingSource>(&quantity.source);
  return source == nullptr || (r.response.buildings[item].*source->of.*source->list).size() > 0;
}

double value_of(const Quantity& quantity, const RunView& r, const QuantityPlace& at) {
  const Response& response = r.response;
  return std::visit(
      Visitor{
          [&](Eigen::VectorXd BuildingPeaks::*member) {
            const Eigen::VectorXd& values = response.buildings[at.item].*member;
            return at.floor < values.size() ? values(at.floor) : none;
          },
          [&](const YieldingSource& source) {
            const Eigen::VectorXd& values = response.buildings[at.item].*source.of.*source.list;
            return at.floor < values.size() ? values(at.floor) : none;
          },
          [&](const InfillSource& source) {
            const Eigen::VectorXd& values = response.buildings[at.item].infill.*source.list;
            return at.floor < values.size() ? values(at.floor) : none;
          },
          [&](const FoundationSource& source) {
            const Eigen::VectorXd& values = response.buildings[at.item].foundation;
            return source.entry < values.size() ? values(source.entry) : none;
          },
          [&](const ColumnSource& source) {
            const std::optional<ColumnPeaks>& column = response.points[at.item].column;
            if (!column) return none;
            return source.kept != nullptr ? *column.*source.kept : source.computed(*column, r.problem.points[at.item]);
          },
          [&](double BuildingPeaks::Hinge::*member) { return response.buildings[at.item].hinges[at.floor].*member; },
          [&](int BuildingPeaks::Hinge::*member) {
            return static_cast<double>(response.buildings[at.item].hinges[at.floor].*member);
          },
          [&](std::optional<double> BuildingPeaks::Hinge::*member) {
            return (response.buildings[at.item].hinges[at.floor].*member).value_or(none);
          },
          [&](double BuildingPeaks::Breaking::*member) {
            return response.buildings[at.item].columns[at.floor].*member;
          },
          [&](std::optional<double> BuildingPeaks::Breaking::*member) {
            return (response.buildings[at.item].columns[at.floor].*member).value_or(none);
          },
          [&](double LinkSummary::*member) {
            return at.item < std::ssize(response.links) ? response.links[at.item].*member : none;
          },
          [&](std::optional<double> PointSummary::*member) {
            return (response.points[at.item].*member).value_or(none);
          },
          [&](double Impact::*member) { return response.impacts[at.item].*member; },
          [&](bool Impact::*member) { return response.impacts[at.item].*member ? 1.0 : 0.0; },
          [&](double (*compute)(const RunView&, const QuantityPlace&)) { return compute(r, at); },
          [&](long (*count)(const RunView&, const QuantityPlace&)) { return static_cast<double>(count(r, at)); },
          [&](auto PointSummary::*member) { return static_cast<double>(response.points[at.item].*member); }},
      quantity.source);
}

bool is_whole(const Quantity& quantity) {
  return std::holds_alternative<int PointSummary::*>(quantity.source) ||
         std::holds_alternative<bool Impact::*>(quantity.source) ||
         std::holds_alternative<int BuildingPeaks::Hinge::*>(quantity.source) ||
         std::holds_alternative<long (*)(const RunView&, const QuantityPlace&)>(quantity.source);
}

bool is_kept(const Quantity& quantity) {
  if (const auto* source = std::get_if<ColumnSource>(&quantity.source)) return source->kept != nullptr;
  return !std::holds_alternative<double (*)(const RunView&, const QuantityPlace&)>(quantity.source) &&
         !std::holds_alternative<long (*)(const RunView&, const QuantityPlace&)>(quantity.source);
}

namespace {

/// The place of a hinge, or of a column that breaks, in a response, which is made.
template <class Told>
Told& told_at(std::vector<Told> BuildingPeaks::*list, Response& response, const QuantityPlace& at) {
  std::vector<Told>& all = response.buildings.at(at.item).*list;
  if (std::ssize(all) <= at.floor) all.resize(at.floor + 1);
  return all[at.floor];
}
BuildingPeaks::Hinge& hinge_at(Response& response, const QuantityPlace& at) {
  return told_at(&BuildingPeaks::hinges, response, at);
}

}  // namespace

void put_value(const Quantity& quantity, double value, const QuantityPlace& at, Response& response) {
  std::visit(
      Visitor{[&](Eigen::VectorXd BuildingPeaks::*member) {
                Eigen::VectorXd& values = response.buildings.at(at.item).*member;
                if (values.size() <= at.floor) values.conservativeResize(at.floor + 1);
                values(at.floor) = value;
              },
              [&](const YieldingSource& source) {
                Eigen::VectorXd& values = response.buildings.at(at.item).*source.of.*source.list;
                if (values.size() <= at.floor) values.conservativeResize(at.floor + 1);
                values(at.floor) = value;
              },
              [&](const InfillSource& source) {
                Eigen::VectorXd& values = response.buildings.at(at.item).infill.*source.list;
                if (values.size() <= at.floor) values.conservativeResize(at.floor + 1);
                values(at.floor) = value;
              },
              [&](const FoundationSource& source) {
                Eigen::VectorXd& values = response.buildings.at(at.item).foundation;
                if (values.size() <= source.entry) values.conservativeResize(source.entry + 1);
                values(source.entry) = value;
              },
              [&](const ColumnSource& source) {
                std::optional<ColumnPeaks>& column = response.points.at(at.item).column;
                if (source.kept == nullptr || std::isnan(value)) return;  // NaN: no column is struck there
                if (!column) column.emplace();
                *column.*source.kept = value;
              },
              [&](double BuildingPeaks::Hinge::*member) { hinge_at(response, at).*member = value; },
              [&](int BuildingPeaks::Hinge::*member) { hinge_at(response, at).*member = static_cast<int>(value); },
              [&](std::optional<double> BuildingPeaks::Hinge::*member) {
                hinge_at(response, at).*member = std::isnan(value) ? std::nullopt : std::optional(value);
              },
              [&](double BuildingPeaks::Breaking::*member) {
                told_at(&BuildingPeaks::columns, response, at).*member = value;
              },
              [&](std::optional<double> BuildingPeaks::Breaking::*member) {
                told_at(&BuildingPeaks::columns, response, at).*member =
                    std::isnan(value) ? std::nullopt : std::optional(value);
              },
              [&](double LinkSummary::*member) { response.links.at(at.item).*member = value; },
              [&](std::optional<double> PointSummary::*member) {
                response.points.at(at.item).*member = std::isnan(value) ? std::nullopt : std::optional(value);
              },
              [&](double Impact::*member) { response.impacts.at(at.item).*member = value; },
              [&](bool Impact::*member) { response.impacts.at(at.item).*member = value != 0; },
              [](double (*)(const RunView&, const QuantityPlace&)) {},
              [](long (*)(const RunView&, const QuantityPlace&)) {},
              [&](double PointSummary::*member) { response.points.at(at.item).*member = value; },
              [&](int PointSummary::*member) { response.points.at(at.item).*member = static_cast<int>(value); }},
      quantity.source);
}

}  // namespace bentur
