#include "bentur/model/story/internal/remark_list.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "bentur/excitation/usual_peaks.h"
#include "bentur/model/quantities.h"

namespace bentur {
namespace remarking {
namespace {

/// How far beyond the usual a value is no longer believed: an order of magnitude is how units are mistaken.
constexpr double far = 10;
constexpr double as_round_off = 1e-9;
constexpr UsualPeak usual_peak;

/// A new one is put last.
constexpr RemarkKind kinds[] = {
    {"period_per_storey", "s", 0.05, 0.2, 0.02, 0.6, far},
    {"stiffness_factor", "", 0.3, 3},  // to reach a period
    {"storey_weight", "F", 5e3, 1e7, 500, 2e8, far},
    {"storey_weight_per_width", "F L-1", none, 1e6, none, 1e7},
    {"impact_damping", "", none, 0.07, none, 0.2},
    {"damping", "", 0.01, 0.07, 0, 0.2, 5},  // 50 % where 5 % is meant: with that nothing moves
    {"storey_height", "L", 2.5, 6, 0.5, 15, far},
    {"elastic_modulus", "F L-2", 1e10, 2.1e11, 5e8, 3e11, far},  // timber, concrete, steel
    {"density", "kg/m³", 500, 8000, 300, 12000, 1.5},            // likewise
    {"section", "L", 0.2, 2, 0.04, 4},
    {"line_load", "F L-1"},
    {"gap_width", "L", none, 0.5, none, 1, far},
    {"level_tolerance", "L"},
    {"soft_contact", "", none, 0.05, none, 0.1},  // of a first period: longer is no blow
    {"code_on_record", "", none, 1, none, 1, 1},
    {"broken_columns", "", none, 0},
    {"initial_overlap", "L", none, 0},
    {"contact_stiffness", "F L-1", 1e7, 1e10, 1e5, 1e11, far},  // by beams over half a bay, or tests
    {"record_step", "s", none, 0.05, none, 0.1, far},
    {"record_length", "s", 5, 600, 5, 600, far},
    {"motion_of_zeros", "g", 0.05, 1, 0.05, 1, 1},
    // The strongest recorded have some 3 g; under 0.01 g nothing is damaged.
    {"pga", "g", usual_peak.from, usual_peak.to, usual_peak.from, usual_peak.most, 5},
    {"pga_without_unit", "g"},
    {"delay", "s"},
    {"duration", "s"},
    {"output_step", "s"},
    {"modal_mass", "", 0.9, none},  // of a floor's mass that known modes move
    {"drift", "%", none, 1},
    {"base_shear", "", none, 0.4},
    {"penetration", "L", none, 0.02, none, 0.05},
    {"check_first_contact", "", none, as_round_off},
    {"check_without_impact", "", none, as_round_off},
    {"check_momentum", "", none, as_round_off},
    {"check_opening", "", none, as_round_off},
    {"check_peaks", "", none, as_round_off},
    {"check_forces", "", none, as_round_off},
    {"check_energy", "", none, as_round_off},
    {"slow_starts", "", none, 0},
    {"merged_corners", "", none, 0},
    {"drift_alone", "%", none, 1},
    {"base_shear_alone", "", none, 0.4},
    {"floors_aligned", "", none, 0},
    {"ductility", "", none, 8},          // about the largest that codes reduce forces by
    {"drift_yielding", "%", none, 2.5},  // about the largest that they let a building have
    {"spectrum", "g", 0.2, 2.5, 0.1, 4, far},
    {"gravity", "m/s²", 9.7, 9.9, 9.7, 9.9, 1.05},
    // Over the weight of their building, moments over that times a storey height:
    {"yield_strength", "", 0.02, 2, 0.005, 10, far},
    {"moment_capacity", "", 1e-3, 0.3, 1e-4, 2, far},
    {"shear_capacity", "", 0.005, 2, 1e-3, 10, far},
    {"rotation_limit", "rad", 1e-3, 0.06, 5e-4, 0.15, 5},
    {"bearing_period", "s", 1.5, 5, 0.8, 10, far},
    {"dimension", "L"},                             // by a range of its own, as those below
    {"link_damping", "", none, 0.5, none, 2, far},  // of the critical one
};
// remark_kinds() has a bit for each and is written as a double, which holds so many.
static_assert(std::size(kinds) <= std::numeric_limits<double>::digits);

std::size_t number_of(std::string_view key) {
  return std::find_if(std::begin(kinds), std::end(kinds), [&](const RemarkKind& one) { return one.key == key; }) -
         std::begin(kinds);
}

std::optional<double> two_digits(double x) {
  if (std::isnan(x)) return std::nullopt;
  if (!(x > 0) || !std::isfinite(x)) return x;
  const double unit = std::pow(10.0, std::floor(std::log10(x)) - 1);
  return std::round(x / unit) * unit;
}

}  // namespace

const RemarkKind bearing_yield = {"dimension", "L", 2e-3, 0.05, 5e-4, 0.2, far};
const RemarkKind infill_thickness = {"dimension", "L", 0.1, 0.5, 0.05, 1, far};

const RemarkKind& remark_kind(std::string_view key) { return kinds[number_of(key)]; }

double beyond_usual(const Remark& remark) {
  const double over = !remark.usual_to ? 0 : *remark.usual_to > 0 ? remark.value / *remark.usual_to : remark.value;
  const double under = remark.usual_from && remark.value > 0 ? *remark.usual_from / remark.value : 0;
  return std::max(over, under);
}

void List::check(std::string_view key, const std::string& subject, double value) {
  check(remark_kind(key), subject, value);
}

void List::check(const RemarkKind& kind, const std::string& subject, double value) {
  const double unit = 1 / si(kind.unit);
  if (!(value < kind.least * unit) && !(value > kind.most * unit)) return;
  const double in_si = value / unit;
  const bool is_doubt =
      kind.doubted > 0 && (in_si < kind.usual_from / kind.doubted || in_si > kind.usual_to * kind.doubted);
  add(kind.key, subject, value, two_digits(kind.usual_from * unit), two_digits(kind.usual_to * unit), is_doubt);
}

void List::check(std::string_view key, const std::string& subject, double value, double most, double usual) {
  if (value > most) add(key, subject, value, std::nullopt, two_digits(usual), false);
}

void List::add(std::string_view key, const std::string& subject, double value, std::optional<double> usual_from,
               std::optional<double> usual_to, bool is_doubt) {
  const auto same = std::find_if(all_.begin(), all_.end(),
                                 [&](const Remark& other) { return other.key == key && other.subject == subject; });
  Remark remark{std::string(key), subject,  value,   unit_text(remark_kind(key).unit, units_),
                usual_from,       usual_to, is_doubt};
  if (same == all_.end()) {
    all_.push_back(std::move(remark));
  } else if (beyond_usual(remark) > beyond_usual(*same)) {
    *same = std::move(remark);
  }
}

double List::si(std::string_view form) const {
  double factor = 1;
  for (std::size_t i = 0; i < form.size(); ++i) {
    if (form[i] != 'F' && form[i] != 'L') continue;
    const double unit = form[i] == 'F' ? newtons_ : metres_;
    const bool is_below = i + 2 < form.size() && form[i + 1] == '-';
    for (int power = is_below ? form[i + 2] - '0' : 1; power > 0; --power) factor *= is_below ? 1 / unit : unit;
  }
  return factor;
}

}  // namespace remarking

const std::vector<std::string_view>& remark_keys() {
  static const std::vector<std::string_view> keys = [] {
    std::vector<std::string_view> list;
    for (const remarking::RemarkKind& one : remarking::kinds) list.push_back(one.key);
    return list;
  }();
  return keys;
}

std::uint64_t remark_kinds(const std::vector<Remark>& remarks) {
  std::uint64_t kinds = 0;
  for (const Remark& one : remarks) kinds |= std::uint64_t{1} << remarking::number_of(one.key);
  return kinds;
}

long count_of_doubts(const std::vector<Remark>& remarks) {
  return std::count_if(remarks.begin(), remarks.end(), [](const Remark& one) { return one.is_doubt; });
}

}  // namespace bentur
