#include "bentur/elements/softening/backbone_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/core/not_known.h"
#include "bentur/core/require.h"

namespace bentur {
namespace {

// A side is +1 or −1; sizes and strengths are told for the upper side and mirrored by it.
constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double nothing_lost = 1e-12;     // of F_y δ_y: an energy that is round-off
constexpr double round_off_slope = 1e-9;   // of k: a slope is not steeper than k by that much
constexpr double round_off_force = 1e-11;  // of F_y

// Branches of both sides come in pairs, the upper one first and odd.
double way_of(int branch) { return branch % 2 == 1 ? 1.0 : -1.0; }
int one_of_pair(int upper, double side) { return side > 0 ? upper : upper + 1; }
bool either_of(int branch, int upper) { return branch == upper || branch == upper + 1; }

double work_along(const Branch& branch, double deformation) {
  return (branch.base + 0.5 * branch.stiffness * deformation) * deformation;
}

void check_backbone(const std::string& of, const Backbone& side, double stiffness) {
  const auto refuse = [&of](const char* name, double value, const char* rule) {
    throw InvalidParameter(of + name, fmt::format("{}", value), rule);
  };
  require_positive(of + "yield", side.yield);
  if (!(side.cap >= 1 && std::isfinite(side.cap))) refuse("cap", side.cap, "must be ≥ 1");
  if (!(side.plastic > 0)) refuse("plastic", side.plastic, "must be > 0");
  if (!(side.softening > 0)) refuse("softening", side.softening, "must be > 0");
  if (!(side.residual >= 0 && side.residual < side.cap)) {
    refuse("residual", side.residual, "must be in [0, cap)");
  }
  if (!(side.ultimate > side.yield / stiffness)) {
    refuse("ultimate", side.ultimate, "must be beyond the deformation at which it yields");
  }
  if (std::isinf(side.plastic) && side.cap > 1) refuse("cap", side.cap, "needs a plastic deformation that ends");
}

}  // namespace

std::string_view word_of(Reloading reloading) {
  return reloading == Reloading::bilinear        ? "bilinear"
         : reloading == Reloading::peak_oriented ? "peak-oriented"
                                                 : "pinching";
}

/// What is left of one side's backbone; all of it as of the upper side.
struct BackboneLaw::Side {
  double yield;             ///< F_y
  double hardening;         ///< slope from there to the cap
  double projection;        ///< force of the line beyond the cap at δ = 0
  double peak;              ///< largest δ
  double last, last_force;  ///< of the last turn
};

/// What is remembered.
struct BackboneLaw::Past {
  Side above, below;
  double back;         ///< k_u
  double from, force;  ///< δ and F of a point of the line that it is on …
  double slope;        ///< … and its slope
  double until;        ///< size of δ where that line or piece ends
  double pinched, pinched_force;
  double worked;                    ///< ∫ F dδ up to `entered`
  double without_force;             ///< that when there was no force last
  double entered;                   ///< δ where the branch began
  double capped, residual, failed;  ///< times; NaN: not yet
  [[nodiscard]] Side& side(double s) { return s > 0 ? above : below; }
  [[nodiscard]] const Side& side(double s) const { return s > 0 ? above : below; }

  [[nodiscard]] static Past of(const LawState& state) {
    static_assert(sizeof(Past) == sizeof(LawState::memory));
    Past past;
    std::memcpy(&past, state.memory.data(), sizeof past);
    return past;
  }
  [[nodiscard]] LawState in(int branch, double time) const {
    LawState state{.branch = branch, .since = time};
    std::memcpy(state.memory.data(), this, sizeof *this);
    return state;
  }
};

BackboneLaw::BackboneLaw(const Parameters& parameters) : of_(parameters) {
  require_positive("stiffness", of_.stiffness);
  check_backbone("", of_.positive, of_.stiffness);
  check_backbone("negative.", of_.negative, of_.stiffness);
  const auto& wear = of_.deterioration;
  for (const auto& [name, gamma] : {std::pair{"strength", wear.strength}, std::pair{"cap", wear.cap},
                                    std::pair{"reloading", wear.reloading}, std::pair{"unloading", wear.unloading}}) {
    if (!(gamma > 0)) {
      throw InvalidParameter(fmt::format("deterioration.{}", name), fmt::format("{}", gamma), "must be > 0");
    }
  }
  if (!(wear.exponent >= 1 && wear.exponent <= 2)) {
    throw InvalidParameter("deterioration.exponent", fmt::format("{}", wear.exponent), "must be in [1, 2]");
  }
  if (!(of_.pinching_force > 0 && of_.pinching_force <= 1)) {
    throw InvalidParameter("pinching_force", fmt::format("{}", of_.pinching_force), "must be in (0, 1]");
  }
  if (!(of_.pinching_deformation >= 0 && of_.pinching_deformation < 1)) {
    throw InvalidParameter("pinching_deformation", fmt::format("{}", of_.pinching_deformation), "must be in [0, 1)");
  }
}

LawParameters BackboneLaw::parameters() const {
  const Backbone& up = of_.positive;
  LawParameters list = {{"stiffness", of_.stiffness}, {"yield_force", up.yield},   {"cap", up.cap},
                        {"plastic", up.plastic},      {"softening", up.softening}, {"residual", up.residual},
                        {"ultimate", up.ultimate}};
  return list;
}

// Of the backbone as it now is ----------------------------------------------------------------------------------------

double BackboneLaw::softening_slope(const Past& past, double s) const noexcept {
  const Backbone& whole = backbone(s);
  if (std::isinf(whole.softening)) return 0.0;
  const double first = whole.cap * whole.yield / whole.softening;
  if (of_.reloading != Reloading::bilinear) return first;
  const double floor = whole.floor();
  if (whole.residual >= 1) return first;
  return first * std::max(0.0, (past.side(s).yield - floor) / (whole.yield - floor));
}

/// Where the lines to and from the cap meet.
double BackboneLaw::cap_at(const Past& past, double s) const noexcept {
  const Side& side = past.side(s);
  const double falling = softening_slope(past, s) + side.hardening;
  if (falling == 0.0) return unbounded;
  return (side.projection - side.yield + side.hardening * side.yield / of_.stiffness) / falling;
}

/// Whether nothing of it is above the residual strength.
bool BackboneLaw::flat(const Past& past, double s) const noexcept {
  const Side& side = past.side(s);
  const double floor = backbone(s).floor();
  if (of_.reloading == Reloading::bilinear && backbone(s).residual < 1 && side.yield <= floor) return true;
  const double cap = cap_at(past, s);
  if (std::isinf(cap)) return side.yield <= floor;
  return side.yield + side.hardening * (cap - side.yield / of_.stiffness) <= floor;
}

/// F at δ = size.
double BackboneLaw::strength(const Past& past, double s, double size) const noexcept {
  const Side& side = past.side(s);
  const double floor = backbone(s).floor();
  if (flat(past, s)) return floor;
  const double rising = side.yield + side.hardening * (size - side.yield / of_.stiffness);
  const double falling = std::isinf(side.projection) ? unbounded : side.projection - softening_slope(past, s) * size;
  return std::max(floor, std::min(rising, falling));
}

/// Where a line that rises from (size, force) with `slope` meets it.
double BackboneLaw::met(const Past& past, double s, double size, double force, double slope) const noexcept {
  const Side& side = past.side(s);
  const double floor = backbone(s).floor();
  const double of_floor = size + (floor - force) / slope;
  if (flat(past, s)) return std::max(size, of_floor);
  const double start = side.yield - side.hardening * side.yield / of_.stiffness;  // of the rising line at δ = 0
  // Where the line that rises is below it, this is met at once; else where it catches up.
  const double first = std::max(size, of_floor);
  const bool at_once = start + side.hardening * first <= force + slope * (first - size);
  const bool catches_up = slope > side.hardening;
  const double of_rising = at_once      ? first
                           : catches_up ? (start - force + slope * size) / (slope - side.hardening)
                                        : unbounded;
  const double falls = softening_slope(past, s);
  const double of_falling =
      std::isinf(side.projection) ? unbounded : (side.projection - force + slope * size) / (slope + falls);
  return std::max(first, std::min(of_rising, of_falling));
}

// What wears ----------------------------------------------------------------------------------------------------------

/// β of (L-6), above 1 where nothing is left.
double BackboneLaw::worn(double energy, double gamma, double lost) const noexcept {
  const double yield = of_.one_sided ? of_.positive.yield : std::min(of_.positive.yield, of_.negative.yield);
  const double unit = yield * yield / of_.stiffness;
  if (std::isinf(gamma) || energy <= nothing_lost * unit) return 0.0;
  const double left = gamma * unit - lost;
  return left > 0 ? std::pow(energy / left, of_.deterioration.exponent) : 2.0;
}

/// k_u of a turn where `force` acts, `past.worked` up to there.
double BackboneLaw::unloading_stiffness(const Past& past, double force) const noexcept {
  const double given = past.worked - past.without_force;
  const double elastic = 0.5 * force * force / past.back;
  const double share = worn(given - elastic, of_.deterioration.unloading, past.worked - elastic);
  return std::max(past.back * (1 - std::min(share, 1.0)), given > 0 ? 0.5 * force * force / given : 0.0);
}

// The way of it -------------------------------------------------------------------------------------------------------

LawState BackboneLaw::fail(Past past, double time) const noexcept {
  past.failed = time;
  return past.in(failed, time);
}

/// On along the backbone, from δ = size.
LawState BackboneLaw::along_backbone(Past past, double s, double size, double time) const noexcept {
  const Side& side = past.side(s);
  const double cap = cap_at(past, s);
  if (!flat(past, s)) {
    const double floor = backbone(s).floor();
    const double at_yield = side.yield / of_.stiffness;
    if (size >= cap) return soften(past, s, time);
    if (side.yield + side.hardening * (size - at_yield) >= floor || side.hardening == 0.0) {
      past.until = cap;
      return past.in(one_of_pair(plastic_up, s), time);
    }
    past.until = at_yield + (floor - side.yield) / side.hardening;  // below it
    return past.in(one_of_pair(residual_up, s), time);
  }
  return level(past, s, time);
}

/// Beyond the cap: down, or where that has come to an end.
LawState BackboneLaw::soften(Past past, double s, double time) const noexcept {
  const double slope = softening_slope(past, s);
  if (slope > 0.0 && std::isnan(past.capped)) past.capped = time;
  past.until = slope > 0.0 ? (past.side(s).projection - backbone(s).floor()) / slope : unbounded;
  return past.until > s * past.entered ? past.in(one_of_pair(softening_up, s), time) : level(past, s, time);
}

/// No more than the residual strength from here on.
LawState BackboneLaw::level(Past past, double s, double time) const noexcept {
  if (backbone(s).floor() == 0.0) return fail(past, time);
  if (std::isnan(past.capped)) past.capped = time;
  if (std::isnan(past.residual)) past.residual = time;
  past.until = unbounded;
  return past.in(one_of_pair(residual_up, s), time);
}

/// Rule 1.
LawState BackboneLaw::turn(Past past, double s, double deformation, double force, double time) const noexcept {
  Side& side = past.side(s);
  side.last = s * deformation;
  side.last_force = s * force;
  side.peak = std::max(side.peak, side.last);
  past.back = unloading_stiffness(past, force);
  past.from = deformation;
  past.force = force;
  past.slope = past.back;
  past.until = side.last;
  return past.in(one_of_pair(unloading_above, s), time);
}

/// Rule 2: there is no force, and what follows is on side s. `past.from` is where that is.
LawState BackboneLaw::enter(Past past, double s, double time) const noexcept {
  const auto& wear = of_.deterioration;
  const double energy = past.worked - past.without_force;
  past.without_force = past.worked;
  const double of_strength = worn(energy, wear.strength, past.worked);
  const double of_cap = worn(energy, wear.cap, past.worked);
  const double of_peak = worn(energy, wear.reloading, past.worked);
  const double of_back = worn(energy, wear.unloading, past.worked);
  if (std::max({of_strength, of_cap, of_peak, of_back}) > 1) return fail(past, time);
  Side& side = past.side(s);
  side.yield *= 1 - of_strength;
  side.hardening *= 1 - of_strength;
  side.projection *= 1 - of_cap;
  side.peak *= 1 + of_peak;
  const double reach = of_.reloading == Reloading::bilinear ? s * past.from : side.peak;
  if (strength(past, s, reach) <= 0) return fail(past, time);
  if (of_.reloading == Reloading::bilinear) {
    past.until = met(past, s, s * past.from, 0, past.slope);
    return past.in(one_of_pair(unloading_above, s), time);
  }
  return head(past, s, time);
}

/// From (past.from, 0) to where it has been.
LawState BackboneLaw::head(Past past, double s, double time) const noexcept {
  const Side& side = past.side(s);
  const double start = s * past.from;
  const double force = strength(past, s, side.peak);
  const double to_peak_slope = force / (side.peak - start);
  if (!(side.peak > start) || to_peak_slope > of_.stiffness * (1 + round_off_slope)) {
    return to_peak(past, s, start, 0, time);
  }
  if (of_.reloading == Reloading::pinching) {
    past.pinched = (1 - of_.pinching_deformation) * (side.peak - force / past.back);
    past.pinched_force = of_.pinching_force * to_peak_slope * (past.pinched - start);
    if (start < past.pinched) {
      past.force = 0;
      past.slope = of_.pinching_force * to_peak_slope;
      past.until = past.pinched;
      return past.in(one_of_pair(pinched_up, s), time);
    }
  }
  return go_on(past, s, start, 0, time);
}

/// From (size, force) to the last turn where that is steeper, else to the peak.
LawState BackboneLaw::go_on(Past past, double s, double size, double force, double time) const noexcept {
  const Side& side = past.side(s);
  const double at_peak = strength(past, s, side.peak);
  const double slope = (side.last_force - force) / (side.last - size);
  if (size < side.last && force < side.last_force && side.last_force < at_peak &&
      slope > (at_peak - force) / (side.peak - size) && slope <= of_.stiffness) {
    past.from = s * size;
    past.force = s * force;
    past.slope = slope;
    past.until = side.last;
    return past.in(one_of_pair(last_up, s), time);
  }
  return to_peak(past, s, size, force, time);
}

LawState BackboneLaw::to_peak(Past past, double s, double size, double force, double time) const noexcept {
  const Side& side = past.side(s);
  past.from = s * size;
  past.force = s * force;
  past.slope = (strength(past, s, side.peak) - force) / (side.peak - size);
  past.until = side.peak;
  if (!(side.peak > size) || past.slope > of_.stiffness * (1 + round_off_slope)) {
    past.slope = of_.stiffness;
    past.until = met(past, s, size, force, past.slope);
  }
  past.slope = std::min(past.slope, of_.stiffness);
  return past.in(one_of_pair(peak_up, s), time);
}

Branch BackboneLaw::branch(const LawState& state) const noexcept {
  const double k = of_.stiffness;
  if (state.branch == virgin) {
    return Branch{.stiffness = k}.guarded_by(
        {{.constant = of_.positive.yield / k, .deformation = -1},
         {.constant = of_.one_sided ? 0.0 : of_.negative.yield / k, .deformation = 1}});
  }
  if (state.branch == failed) return Branch{};
  const Past past = Past::of(state);
  if (state.branch == slack) return Branch{}.guarded_by({{.constant = past.from, .deformation = -1}});
  const double s = way_of(state.branch);
  const Side& side = past.side(s);
  const double end = std::min(past.until, backbone(s).ultimate);
  Branch line;
  if (either_of(state.branch, plastic_up)) {
    line.base = s * (side.yield - side.hardening * side.yield / k);
    line.stiffness = side.hardening;
  } else if (either_of(state.branch, softening_up)) {
    line.base = s * side.projection;
    line.stiffness = -softening_slope(past, s);
  } else if (either_of(state.branch, residual_up)) {
    line.base = s * backbone(s).floor();
  } else {
    line.base = past.force - past.slope * past.from;
    line.stiffness = past.slope;
  }
  if (either_of(state.branch, unloading_above)) {
    const double rest = past.from - past.force / past.slope;
    double least = s * rest;
    if (!of_.one_sided) least = std::max(least, -backbone(-s).ultimate);
    return line.guarded_by({{.constant = end, .deformation = -s}, {.constant = -least, .deformation = s}});
  }
  const Guard outward = {.speed = s};
  if (std::isinf(end)) return line.guarded_by({outward});
  return line.guarded_by({{.constant = end, .deformation = -s}, outward});
}

LawState BackboneLaw::next(const LawState& state, std::size_t guard, double time, double deformation,
                           double speed) const noexcept {
  Past past;
  const Branch ended = branch(state);
  if (state.branch == virgin) {
    const auto begun = [this](const Backbone& of) {
      const double at_yield = of.yield / of_.stiffness;
      const double hardening = (of.cap - 1) * of.yield / of.plastic;
      const double projection =
          of.cap * of.yield * (std::isinf(of.softening) ? 1 : 1 + (at_yield + of.plastic) / of.softening);
      return Side{of.yield, hardening, projection, at_yield, at_yield, of.yield};
    };
    past = {.above = begun(of_.positive),
            .below = begun(of_.negative),
            .back = of_.stiffness,
            .from = 0,
            .force = 0,
            .slope = of_.stiffness,
            .until = 0,
            .pinched = 0,
            .pinched_force = 0,
            .worked = 0,
            .without_force = 0,
            .entered = 0,
            .capped = not_known,
            .residual = not_known,
            .failed = not_known};
  } else {
    past = Past::of(state);
  }
  past.worked += work_along(ended, deformation) - work_along(ended, past.entered);
  past.entered = deformation;
  if (state.branch == virgin) {
    const double s = guard == 0 ? 1.0 : -1.0;
    if (s < 0 && of_.one_sided) return past.in(slack, time);
    return along_backbone(past, s, past.side(s).peak, time);
  }
  if (state.branch == slack) return enter(past, 1, time);
  const double s = way_of(state.branch);
  const double end = std::min(past.until, backbone(s).ultimate);
  if (either_of(state.branch, unloading_above)) {
    const double rest = past.from - past.force / past.slope;
    if (guard == 1) {
      if (!of_.one_sided && s * rest < -backbone(-s).ultimate) return fail(past, time);
      past.from = rest;
      past.force = 0;
      return of_.one_sided ? past.in(slack, time) : enter(past, -s, time);
    }
    if (end < past.until) return fail(past, time);
    const Side& side = past.side(s);
    // The turn is on the backbone, or on a line that has not come up to it.
    const bool on_backbone = side.last_force >= strength(past, s, end) - round_off_force * backbone(s).yield;
    if (of_.reloading == Reloading::bilinear || (end >= side.peak && on_backbone)) {
      return along_backbone(past, s, end, time);
    }
    const double at_peak = strength(past, s, side.peak);
    const bool pinches = of_.reloading == Reloading::pinching && side.last < past.pinched &&
                         side.last_force < past.pinched_force && past.pinched < side.peak &&
                         (past.pinched_force - side.last_force) / (past.pinched - side.last) <
                             (at_peak - side.last_force) / (side.peak - side.last);
    if (!pinches) return to_peak(past, s, side.last, side.last_force, time);
    past.slope = (past.pinched_force - side.last_force) / (past.pinched - side.last);
    past.until = past.pinched;
    return past.in(one_of_pair(pinched_up, s), time);
  }
  if (guard == 1 || std::isinf(end)) {
    return turn(past, s, deformation, ended.base + ended.stiffness * deformation + ended.damping * speed, time);
  }
  if (end < past.until || end >= backbone(s).ultimate) return fail(past, time);
  if (either_of(state.branch, residual_up)) {  // the line to the cap has come up to it
    past.until = cap_at(past, s);
    return past.in(one_of_pair(plastic_up, s), time);
  }
  if (either_of(state.branch, plastic_up)) return soften(past, s, time);
  if (either_of(state.branch, softening_up)) return level(past, s, time);
  if (either_of(state.branch, pinched_up)) return go_on(past, s, past.pinched, past.pinched_force, time);
  if (either_of(state.branch, last_up)) return to_peak(past, s, past.side(s).last, past.side(s).last_force, time);
  return along_backbone(past, s, end, time);  // at the peak
}

/// k_u if it were unloaded from here.
double BackboneLaw::back(const LawState& state, double deformation, double force) const noexcept {
  if (state.branch == virgin) return of_.stiffness;
  Past past = Past::of(state);
  if (either_of(state.branch, unloading_above)) return past.slope;
  const Branch line = branch(state);
  past.worked += work_along(line, deformation) - work_along(line, past.entered);
  return unloading_stiffness(past, force);
}

double BackboneLaw::stored_energy(const LawState& state, double deformation) const noexcept {
  const double f = force(state, deformation, 0);
  return f == 0.0 ? 0.0 : 0.5 * f * f / back(state, deformation, f);
}

double BackboneLaw::residual(const LawState& state, double deformation) const noexcept {
  if (state.branch == virgin) return 0;
  const double f = force(state, deformation, 0);
  return f == 0.0 ? deformation : deformation - f / back(state, deformation, f);
}

std::optional<StrengthLoss> BackboneLaw::loss(const LawState& state, double deformation) const noexcept {
  StrengthLoss loss;
  if (state.branch == virgin) return loss;
  const Past past = Past::of(state);
  const auto told = [](double time) { return std::isnan(time) ? std::nullopt : std::optional(time); };
  loss.capped = told(past.capped);
  loss.residual = told(past.residual);
  loss.failed = told(past.failed);
  if (state.branch == failed) {
    loss.left = 0;
    return loss;
  }
  for (const double s : {1.0, -1.0}) {
    if (s < 0 && of_.one_sided) continue;
    const bool outward = either_of(state.branch, plastic_up) || either_of(state.branch, softening_up) ||
                         either_of(state.branch, residual_up);
    const double peak =
        outward && way_of(state.branch) == s ? std::max(past.side(s).peak, s * deformation) : past.side(s).peak;
    const double cap = cap_at(past, s);
    const double best = std::isinf(cap) ? past.side(s).yield : strength(past, s, std::max(peak, cap));
    loss.left = std::min(loss.left, best / (backbone(s).cap * backbone(s).yield));
  }
  return loss;
}

}  // namespace bentur
